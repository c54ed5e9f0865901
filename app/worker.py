"""Binding in the background: plain immutable data goes in, a deformer comes out.

Binding is everything between a finished stroke and a surface that can be dragged.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from app.document import Document
from solver import Deformer
from solver.material import Material
from solver.types import FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class BindRequest:
    """A snapshot of all that binding depends on.

    version: of the document it was taken from. mesh: a number that names the mesh.
    keys: (h,) of the handles that have vertices, in the order of `handles` (index arrays).
    rigid: the level that the surface will be posed at, to be made ready.
    """

    version: int
    mesh: int
    keys: tuple[int, ...]
    vertices: FloatArray
    faces: IntArray
    fixed: IntArray
    handles: tuple[IntArray, ...]
    softness: FloatArray
    material: str | Material
    bending_length: float
    orientation: bool
    rigid: int

    @staticmethod
    def of(document: Document) -> BindRequest:
        """The snapshot of a document; handles without a vertex stay out."""
        regions = {handle.key: document.vertices_of(handle.key) for handle in document.handles}
        regions = {key: vertices for key, vertices in regions.items() if len(vertices)}
        return BindRequest(
            version=document.bind_version,
            mesh=document.serial,
            keys=tuple(regions),
            vertices=document.mesh.vertices,
            faces=document.mesh.faces,
            fixed=document.fixed,
            handles=tuple(regions.values()),
            softness=document.softness.copy(),
            material=document.material,
            bending_length=document.bending_length,
            orientation=document.orientation,
            rigid=document.rigid,
        )


# What `Deformer` takes beside the mesh, and `Deformer.rebind` where it differs.
ARGUMENTS = ("fixed", "handles", "softness", "material", "bending_length", "orientation")


@dataclass(frozen=True, eq=False)
class Bound:
    """A finished bind. seconds: how long it took."""

    request: BindRequest
    deformer: Deformer
    seconds: float


@dataclass(frozen=True, eq=False)
class BindFailure:
    """A bind that could not be done."""

    request: BindRequest
    error: Exception


Build = Callable[[BindRequest, Bound | None], Deformer]


def bind(request: BindRequest, last: Bound | None = None) -> Deformer:
    """The deformer for a request, sharing what it can with the last one of the same mesh."""
    arguments = {name: getattr(request, name) for name in ARGUMENTS}
    if last is None or last.request.mesh != request.mesh:
        deformer = Deformer(request.vertices, request.faces, **arguments)
    else:
        deformer = last.deformer.rebind(
            **{
                name: value
                for name, value in arguments.items()
                if not _same(value, getattr(last.request, name))
            }
        )
    # What the first pose of a level prepares belongs to the bind, not to the first drag frame.
    deformer.pose([np.eye(4)] * len(request.handles), rigid=request.rigid)
    return deformer


def _same(one: Any, two: Any) -> bool:
    if isinstance(one, tuple):
        return len(one) == len(two) and all(map(np.array_equal, one, two))
    return bool(np.array_equal(one, two)) if isinstance(one, np.ndarray) else bool(one == two)


class Binder:
    """Binds in one background thread. The newest request wins: older ones that wait are dropped."""

    def __init__(self, build: Build = bind) -> None:
        self._build = build
        self._change = threading.Condition()
        self._pending: BindRequest | None = None
        self._running: BindRequest | None = None
        self._result: Bound | BindFailure | None = None
        self._last: Bound | None = None
        self._wanted = False
        self._closed = False
        self._thread: threading.Thread | None = None

    def request(self, request: BindRequest) -> None:
        """Ask for a bind; returns at once."""
        with self._change:
            self._pending = request
            self._wanted = True
            if self._thread is None and not self._closed:
                # a daemon: a window that closes does not wait for a long bind
                self._thread = threading.Thread(target=self._work, name="bind", daemon=True)
                self._thread.start()
            self._change.notify_all()

    def poll(self) -> Bound | BindFailure | None:
        """What has finished since the last call, None when nothing has."""
        with self._change:
            result, self._result = self._result, None
            return result

    def drop(self) -> None:
        """Forget the requests so far: no result of theirs will be polled."""
        with self._change:
            self._pending = self._result = None
            self._wanted = False

    @property
    def busy(self) -> bool:
        """Whether a result that is wanted has not been reached yet."""
        with self._change:
            return self._unfinished()

    def wait(self, timeout: float | None = None) -> bool:
        """Block until nothing is under way (or `timeout` seconds passed); whether that is so."""
        with self._change:
            return self._change.wait_for(lambda: not self._unfinished(), timeout)

    def close(self) -> None:
        """End the thread; a bind that is running ends by itself and goes nowhere."""
        self.drop()
        with self._change:
            self._closed = True
            self._change.notify_all()

    def _unfinished(self) -> bool:
        return not self._closed and self._wanted and bool(self._pending or self._running)

    def _work(self) -> None:
        while True:
            with self._change:
                self._running = None
                self._change.notify_all()
                self._change.wait_for(lambda: self._closed or self._pending is not None)
                if self._closed:
                    return
                request, self._pending = self._pending, None
                self._running = request
            assert request is not None
            self._finish(self._attempt(request))

    def _attempt(self, request: BindRequest) -> Bound | BindFailure:
        start = time.perf_counter()
        try:
            deformer = self._build(request, self._last)
        # The border of the thread: whatever is not carried across it would be lost unseen.
        except Exception as error:
            return BindFailure(request, error)
        return Bound(request, deformer, time.perf_counter() - start)

    def _finish(self, result: Bound | BindFailure) -> None:
        with self._change:
            if isinstance(result, Bound):
                self._last = result
            if self._wanted:
                self._result = result
