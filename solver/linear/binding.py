"""One bind of a rest surface: its constraints, its factorised system, the basis of its drags."""

from __future__ import annotations

from dataclasses import dataclass

from solver.linear.constraints import Constraints, build_constraints
from solver.linear.energy import Gains
from solver.linear.response import Response, hard_response
from solver.linear.rest_surface import RestSurface
from solver.linear.system import Structure, System
from solver.setup import Setup
from solver.softness.material import explicit_gains, softness_gains


@dataclass(frozen=True)
class Binding:
    """One factorisation and what hangs on it.

    bending_length: as the mesh resolves it, see RestEnergy.resolved.
    """

    rest: RestSurface
    setup: Setup
    bending_length: float
    constraints: Constraints
    structure: Structure
    system: System
    hard: Response


def bind(rest: RestSurface, setup: Setup, earlier: Binding | None = None) -> Binding:
    """Assemble, factorise and find the basis.

    Raises ConstraintError, MaterialError, or FactorizationError where rounding spoils the result.

    earlier: a binding of the same rest surface; what has not changed since then is shared.
    """
    if earlier is not None and setup == earlier.setup:
        return earlier
    length = rest.energy.resolved(setup.bending_length)
    gains = gains_of(rest, setup)
    if earlier is not None and setup.holds_as(earlier.setup):
        constraints, structure = earlier.constraints, earlier.structure
    else:
        constraints = build_constraints(rest, setup)
        structure = Structure(rest, constraints)
    system = System(rest, structure, rest.energy.weights(length, gains), length)
    system.check()
    hard = hard_response(rest, constraints, system)
    return Binding(rest, setup, length, constraints, structure, system, hard)


def gains_of(rest: RestSurface, setup: Setup) -> Gains:
    """The gains of each edge that a setup asks for. Raises MaterialError."""
    if setup.edge_gains is not None:
        return explicit_gains(rest.topology, setup.edge_gains)
    return softness_gains(rest.topology, setup.softness, setup.material)
