"""What holds and softens the coarse surface where the fine one is held and soft."""

from __future__ import annotations

import numpy as np

from solver.arrays import check_unit_interval
from solver.coarse.carrier import Carrier
from solver.errors import MaterialError
from solver.setup import FIXED, FREE, Setup
from solver.softness.material import explicit_gains
from solver.types import FloatArray, IntArray


def restrict(carrier: Carrier, setup: Setup, held: IntArray) -> Setup:
    """The setup of the coarse surface for that of the fine one.

    held: (c,) see `coarse_groups`. Lengths stay what they are, whatever the coarse surface's own
    diagonal.
    """
    count = len(carrier.fine.vertices)
    changes: dict[str, object] = {
        "fixed": np.flatnonzero(held == FIXED),
        "handles": [np.flatnonzero(held == 1 + h) for h in range(len(setup.handles))],
        "bending_length": setup.bending_length * carrier.fine.scale / carrier.coarse.scale,
    }
    if setup.softness is not None:
        if setup.softness.shape != (count,):
            raise MaterialError(f"softness must be ({count},), got {setup.softness.shape}")
        check_unit_interval(setup.softness, "softness", MaterialError)
        changes["softness"] = carrier.mean(setup.softness)
    if setup.edge_gains is not None:
        changes["edge_gains"] = _coarse_gains(carrier, setup)
    return setup.changed(**changes)


def coarse_groups(carrier: Carrier, group: IntArray) -> IntArray:
    """(c,) the group that has most of each cell; none is lost in a piece that it holds some of.

    group: (n,) see Setup.groups.
    """
    used = np.flatnonzero(carrier.cell >= 0)
    count, groups = len(carrier.coarse.vertices), int(group.max()) + 2
    place = carrier.cell[used] * groups + group[used] - FREE
    votes = np.bincount(place, minlength=count * groups).reshape(count, groups)
    held = votes.argmax(axis=1) + FREE
    component = carrier.coarse.topology.vertex_component
    pair = component[carrier.cell[used]] * groups + group[used] - FREE
    wanted = np.unique(pair[group[used] != FREE])
    present = np.unique(component[held != FREE] * groups + held[held != FREE] - FREE)
    for lacking in np.setdiff1d(wanted, present):
        members = used[pair == lacking]
        _claim_one(carrier, held, members, int(lacking % groups) + FREE)
    return np.asarray(held)


def _claim_one(carrier: Carrier, held: IntArray, members: IntArray, group: int) -> None:
    """Give the group the nearest coarse vertex of its piece that no other needs."""
    rest = carrier.coarse
    component = rest.topology.vertex_component
    piece = component[carrier.cell[members[0]]]
    own = np.flatnonzero((component == piece) & (held == FREE))
    if len(own) == 0:  # everything is held: then by a group that can spare one
        own = np.flatnonzero(component == piece)
        own = own[np.bincount(held[own])[held[own]] > 1]
    if len(own):
        middle = carrier.fine.vertices[members].mean(axis=0)
        held[own[((rest.vertices[own] - middle) ** 2).sum(axis=1).argmin()]] = group


def _coarse_gains(carrier: Carrier, setup: Setup) -> tuple[IntArray, FloatArray, FloatArray]:
    """Gains of all coarse edges: geometric means over cells, then over an edge's ends."""
    assert setup.edge_gains is not None
    topology = carrier.fine.topology
    degree = np.bincount(topology.edges.ravel(), minlength=topology.vertex_count)
    edges = carrier.coarse.topology.edges
    gains = []
    for gain in explicit_gains(topology, setup.edge_gains):
        sums = np.bincount(topology.edges.ravel(), np.repeat(np.log(gain), 2), len(degree))
        mean = carrier.mean(sums / np.maximum(degree, 1))
        gains.append(np.exp(mean[edges].mean(axis=1)))
    return edges, gains[0], gains[1]
