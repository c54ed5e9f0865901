"""What one set of constraints settles on both surfaces, whatever the material."""

from __future__ import annotations

from copy import copy
from functools import cached_property

import numpy as np

from solver.coarse.border import Border
from solver.coarse.carrier import Carrier
from solver.coarse.fine_poisson import FineStructure
from solver.coarse.restriction import coarse_groups
from solver.linear.constraints import attached_bodies, attachments_in_force, held_bodies
from solver.setup import FREE, Setup
from solver.types import FloatArray, IntArray


class Held:
    """What is held on a fine surface and on the coarse one that carries it.

    setup: of the fine surface.  group: (n,) see Setup.groups.  coarse_group: (c,) of the coarse.
    Raises ConstraintError, see Setup.groups.
    """

    def __init__(self, carrier: Carrier, setup: Setup) -> None:
        self._carrier, self.setup = carrier, setup
        self.group: IntArray = setup.groups(len(carrier.fine.vertices))
        self.coarse_group: IntArray = coarse_groups(carrier, self.group)

    def with_material(self, setup: Setup) -> Held:
        """The same for a setup that holds the same vertices, see Setup.holds_as."""
        other = copy(self)
        other.setup = setup
        return other

    @cached_property
    def border(self) -> Border:
        return Border(self._carrier, self.group, self.coarse_group)

    @cached_property
    def structure(self) -> FineStructure:
        """The fine Poisson problem, before any material."""
        rest = self._carrier.fine
        attachments = attachments_in_force(rest, self.setup)
        body = attached_bodies(rest, attachments)
        free = np.flatnonzero((self.group == FREE) & held_bodies(body, self.group)[body])
        return FineStructure(rest, free, attachments, self._carrier.elimination_order)

    def goals(self, handle_count: int) -> FloatArray:
        """(h, 4k) rows [p', 1] of each held vertex in its handle's columns, in coarse units."""
        border, carrier = self.border, self._carrier
        points = carrier.coarse.normalise(carrier.fine.vertices[border.held])
        goals = np.zeros((len(points), handle_count, 4))
        moved = np.flatnonzero(self.group[border.held] > 0)
        handle = self.group[border.held[moved]] - 1
        goals[moved, handle, :3], goals[moved, handle, 3] = points[moved], 1.0
        return goals.reshape(len(points), 4 * handle_count)
