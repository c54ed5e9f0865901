"""What is known of a shape that was asked for, without asking the solver."""

from __future__ import annotations

from app.live.refinements import Refinements, at_rest
from app.worker.errand import Snapshot
from app.worker.requests import Bound, checked
from solver.types import FloatArray


def known_shape(
    shape: Snapshot, bound: Bound | None, refinements: Refinements
) -> FloatArray | None:
    """Positions (n, 3) of a snapshot as far as a bind and its refinements tell, else None.

    Raises SolverError if it is known that they cannot be had.
    """
    refusal = refinements.refusal(shape.refinement)
    if refusal is not None:
        raise refusal
    if at_rest(shape.transforms):
        return shape.bind.vertices
    if bound is None or bound.request.version != shape.bind.version:
        return None
    if shape.rigid == 0:
        return checked(bound.model.pose(shape.transforms))
    refined = refinements.at(shape.rigid)
    asked = refined is not None and refined.request.asks(shape.transforms, shape.rigid)
    return refined.positions if refined is not None and asked else None
