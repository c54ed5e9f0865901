"""A branching shape as an implicit solid: a cactus with two arms, y up, foot on y = 0."""

from __future__ import annotations

from assets.generator.implicit import Field, chain, cut, union

Y = 1
TRUNK = [(0.0, -0.3, 0.0), (0.0, 1.85, 0.0)], [0.24, 0.21]
# Each arm leaves the trunk sideways, turns upward and ends in a round tip.
ARMS = [
    ([(0.0, 0.85, 0.0), (0.52, 0.9, 0.05), (0.6, 0.98, 0.06), (0.62, 1.5, 0.08)], 0.135),
    ([(0.0, 1.15, 0.0), (-0.46, 1.2, -0.06), (-0.54, 1.28, -0.07), (-0.56, 1.68, -0.08)], 0.125),
]


def cactus() -> Field:
    """The whole plant, cut flat at its foot."""
    arms = (chain(0.05, points, [radius] * len(points)) for points, radius in ARMS)
    return cut(0.03, union(0.1, chain(0.05, *TRUNK), *arms), lambda p: p[:, Y])
