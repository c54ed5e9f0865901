"""A snapshot of the document: all that a bind depends on, for the solver's process."""

from __future__ import annotations

from app.model.document import Document
from app.worker.errand import Snapshot
from app.worker.requests import BindRequest
from solver import Setup


def preparation(document: Document) -> BindRequest:
    """A bind that holds nothing: it finds what belongs to the mesh alone, for those to come."""
    return BindRequest(
        version=0,
        mesh=document.surface_number,
        keys=(),
        vertices=document.rest_positions,
        faces=document.mesh.faces,
        setup=Setup(coarse=document.coarse_count),
        rigid=0,
        transforms=document.pose.stacked(()),
    )


def bind_request(document: Document) -> BindRequest:
    """The bind that a document asks for as it is now; handles without a vertex stay out.

    What a level prepares for its first pose takes longer than to grab: it is left to that pose.
    """
    keys = document.bound_keys
    return BindRequest(
        version=document.bind_version,
        mesh=document.surface_number,
        keys=keys,
        vertices=document.rest_positions,
        faces=document.mesh.faces,
        setup=document.setup(),
        rigid=document.rigid if document.grab is None else 0,
        transforms=document.pose.stacked(keys),
        grab=document.grab,
    )


def snapshot(document: Document) -> Snapshot:
    """The surface that a document asks for as it is now."""
    bind = bind_request(document)
    return Snapshot(bind, document.pose.stacked(bind.keys), document.rigid)
