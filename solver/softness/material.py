"""Materials: from softness painted on vertices to the gains of edges on bending and stretching."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from solver.arrays import as_floats, check_unit_interval, locked
from solver.errors import MaterialError
from solver.geometry.topology import Topology
from solver.limits import LARGEST_GAIN, SMALLEST_GAIN, within
from solver.types import FloatArray, IntArray

GAINS = f"from {SMALLEST_GAIN:g} to {LARGEST_GAIN:g}"


@dataclass(frozen=True)
class Material:
    """Gains of a fully soft edge: E_f is multiplied by `bending`, E_x by `stretching`.

    An edge of softness s takes bending**s and stretching**s, so that rigid parts keep gain 1.
    Raises MaterialError unless both lie from 1e-6 to 1e6.

    >>> import solver
    >>> hinge = solver.Material(bending=0.1, stretching=1.0)
    >>> hinge == solver.PRESETS["hinge"]
    True
    """

    bending: float
    stretching: float

    def __post_init__(self) -> None:
        for name in ("bending", "stretching"):
            gain = getattr(self, name)
            if isinstance(gain, bool) or not isinstance(gain, int | float | np.number):
                raise MaterialError(f"material's {name} gain must be a number, got {gain!r}")
            if not within(gain, SMALLEST_GAIN, LARGEST_GAIN):
                raise MaterialError(f"material's {name} gain must be {GAINS}, got {gain}")


PRESETS: dict[str, Material] = {
    "hinge": Material(bending=0.1, stretching=1.0),
    "paper": Material(bending=2.0, stretching=0.5),
    "clay": Material(bending=0.1, stretching=0.1),
}

# Edges (k, 2), and the (k,) gains of each on bending and on stretching.
EdgeGains = tuple[IntArray, FloatArray, FloatArray]


def resolve_material(material: str | Material) -> Material:
    """The Material itself, or the preset of that name; MaterialError for an unknown name."""
    if isinstance(material, Material):
        return material
    if not isinstance(material, str) or material not in PRESETS:
        raise MaterialError(f"unknown material {material!r}, expected one of {', '.join(PRESETS)}")
    return PRESETS[material]


def softness_gains(
    topology: Topology, softness: ArrayLike | None, material: str | Material
) -> tuple[FloatArray, FloatArray]:
    """(bending, stretching) gains of each edge, (e,) each, from softness (n,) in [0, 1].

    The softness of an edge is the mean of its two ends. None means rigid everywhere.
    Raises MaterialError.
    """
    material = resolve_material(material)
    if softness is None:
        softness = np.zeros(topology.vertex_count)
    s = as_floats(softness, "softness", MaterialError)
    if s.shape != (topology.vertex_count,):
        raise MaterialError(f"softness must be ({topology.vertex_count},), got {s.shape}")
    check_unit_interval(s, "softness", MaterialError)
    edge_softness = s[topology.edges].mean(axis=1)
    return material.bending**edge_softness, material.stretching**edge_softness


def as_edge_gains(edge_gains: tuple[ArrayLike, ArrayLike, ArrayLike]) -> EdgeGains:
    """Read-only copies of (edges (k, 2), bending (k,), stretching (k,)).

    Raises MaterialError for another shape, or a gain out of bounds.
    """
    if len(edge_gains) != 3:
        raise MaterialError(
            f"edge_gains must be (edges, bending, stretching), got {len(edge_gains)} values"
        )
    edges = np.asarray(edge_gains[0])
    if edges.ndim != 2 or edges.shape[1] != 2 or not np.issubdtype(edges.dtype, np.integer):
        raise MaterialError(
            f"edge_gains' edges must be (k, 2) integers, got {edges.dtype} {edges.shape}"
        )
    bending, stretching = (
        as_floats(values, f"edge_gains' {name}", MaterialError)
        for name, values in zip(("bending", "stretching"), edge_gains[1:], strict=True)
    )
    for name, values in (("bending", bending), ("stretching", stretching)):
        if values.shape != (len(edges),):
            raise MaterialError(f"edge_gains' {name} must be ({len(edges)},), got {values.shape}")
        outside = (values < SMALLEST_GAIN) | (values > LARGEST_GAIN)
        if outside.any():
            raise MaterialError(f"edge_gains' {name} must be {GAINS}, got {values[outside][0]}")
    return locked(edges.astype(np.int64)), locked(bending), locked(stretching)


def explicit_gains(topology: Topology, edge_gains: EdgeGains) -> tuple[FloatArray, FloatArray]:
    """(bending, stretching) gains of each edge, (e,) each, from those of some edges.

    Edges may come in any order and direction; those not named have gain 1. Raises MaterialError
    for a pair that is no edge of the mesh.
    """
    edges, *named = edge_gains
    index = _find_edges(topology, edges)
    gains = np.ones((2, len(topology.edges)))
    gains[:, index] = named
    return gains[0], gains[1]


def _find_edges(topology: Topology, edges: IntArray) -> IntArray:
    low, high = edges.min(axis=1), edges.max(axis=1)
    keys = topology.edges[:, 0] * topology.vertex_count + topology.edges[:, 1]
    wanted = low * topology.vertex_count + high
    index = np.searchsorted(keys, wanted).clip(max=len(keys) - 1)
    missing = (keys[index] != wanted) | (low < 0) | (high >= topology.vertex_count)
    if missing.any():
        one, two = edges[missing][0].tolist()
        raise MaterialError(f"edge_gains names ({one}, {two}), which is no edge of the mesh")
    return index
