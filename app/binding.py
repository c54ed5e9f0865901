"""Keeps the surface on screen up to date with the document: binds and poses as needed."""

from __future__ import annotations

from app.worker import BindFailure, BindRequest
from app.workspace import Workspace
from solver.errors import SolverError


class BindError(SolverError):
    """What the document asks for could not be bound."""


def update(work: Workspace) -> None:
    """Take a bind that has finished, ask for one if the document has changed, pose the surface.

    During a stroke or a drag no bind is asked for, and a slow rigid level is put off.
    Raises SolverError if there is no pose to show.
    """
    result = work.binder.poll()
    if isinstance(result, BindFailure):
        work.bind_error = f"Binding failed: {result.error}"
        work.say(work.bind_error, "error")
    elif result is not None:
        work.surface.attach(result)
    if work.interaction is None:
        _request(work)
    work.surface.show(work.document, live=work.interaction is not None)


def settle(work: Workspace) -> None:
    """Wait until the surface is what the document asks for.

    Raises BindError if it cannot be, SolverError as `update`.
    """
    update(work)
    work.binder.wait()
    update(work)
    if work.bind_error:
        raise BindError(work.bind_error)


def _request(work: Workspace) -> None:
    document = work.document
    if document.bind_version == work.requested_version:
        return
    work.requested_version = document.bind_version
    work.bind_error = ""
    request = BindRequest.of(document)
    if request.keys:
        work.binder.request(request)
    else:
        work.binder.drop()
        work.surface.attach(None)
