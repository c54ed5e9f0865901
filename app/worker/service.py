"""Where requests are met: keeps the deformer of the last bind, or what can be shared of it.

Binding is everything between a finished stroke and a surface that can be dragged.
"""

from __future__ import annotations

import time
import traceback

import numpy as np

from app.worker.memory import check_memory
from app.worker.requests import Answer, BindRequest, RefineRequest, Request, WorkerError
from solver import Deformer
from solver.errors import SolverError
from solver.linear.drag_model import DragModel
from solver.types import FloatArray

# Vertices: above, preparing a level above 0 takes from half a second on. [docs/scaling.md]
QUICK = 200_000
Last = tuple[int, Deformer]  # the number of the mesh, and what is bound of it


def bind(request: BindRequest, last: Last | None = None) -> Deformer:
    """The deformer for a request without its grab, sharing what it can with the last one of a mesh.

    Raises OutOfMemory before it is tried, or what binding raises.
    """
    check_memory(len(request.vertices), request.setup.coarse)
    if last is None or last[0] != request.mesh:
        deformer = Deformer.of(request.vertices, request.faces, request.setup)
    else:
        deformer = last[1].rebound(request.setup)
    if not request.keys:  # nothing to pose: a mesh was opened
        deformer.prepare()
    # What the first pose of a level prepares belongs to the bind, not to the first drag frame,
    # unless it would take so long that a drag at level 0 is worth more.
    level = request.rigid if _is_quick(request) else 0
    deformer.pose([np.eye(4)] * deformer.handle_count, rigid=level)
    return deformer


def _is_quick(request: BindRequest) -> bool:
    """Whether a level above 0 is prepared within a fraction of a second."""
    return len(request.vertices) <= QUICK


def released(last: Last | None, request: BindRequest) -> Last | None:
    """What of the last bind a request can share, without a factor that it cannot.

    The caller lets go of the last one: two factors of a large mesh would not fit into memory.
    """
    if last is None or last[0] != request.mesh:
        return None
    mesh, deformer = last
    if request.setup.holds_as(deformer.setup):
        return last
    return mesh, deformer.rebound(deformer.setup.changed(fixed=(), handles=()))


class SolverService:
    """Meets one request after the other, and never has the factors of two binds at once.

    A bind that fails may leave none: the bind in use is then asked for once more.
    """

    def __init__(self) -> None:
        self._shared: Last | None = None
        self._posed: Deformer | None = None  # that one, with what is grabbed now
        self._version: int | None = None  # of the bind that can be refined

    def answer(self, request: Request) -> Answer:
        """Do what is asked; whatever goes wrong is the answer."""
        start = time.perf_counter()
        value: DragModel | FloatArray | SolverError
        try:
            if isinstance(request, BindRequest):
                value = self._bind(request)
            else:
                value = self._refine(request)
        except SolverError as error:
            value = error
        # The border of the process: whatever is not carried across it would be lost unseen.
        except Exception as error:
            traceback.print_exc()
            value = WorkerError(f"{type(error).__name__}: {error}")
        seconds = time.perf_counter() - start
        return Answer(value, seconds, self._first_pose(request, value))

    def _bind(self, request: BindRequest) -> DragModel:
        shared = released(self._shared, request)
        if shared is not self._shared:
            self._shared, self._posed, self._version = shared, None, None
        deformer = bind(request, shared)
        self._shared = request.mesh, deformer
        self._posed = deformer if request.grab is None else deformer.grab(request.grab)
        self._version = request.version
        return self._posed.drag_model

    def _first_pose(self, request: Request, value: object) -> Answer | None:
        """The surface with the bind, so that a slider that binds all the time shows what it does.

        None where the window needs none: at rest, or where the linear level is asked for; or where
        a drag should not wait for it.
        """
        if not isinstance(request, BindRequest) or not isinstance(value, DragModel):
            return None
        at_rest = (request.transforms == np.eye(4)).all()
        if request.rigid == 0 or at_rest or not _is_quick(request):
            return None
        return self.answer(request.first_pose)

    def _refine(self, request: RefineRequest) -> FloatArray:
        if self._posed is None or self._version != request.version:
            raise WorkerError(f"bind {request.version} is asked for, which is not the last one")
        return self._posed.pose(list(request.transforms), rigid=request.rigid)
