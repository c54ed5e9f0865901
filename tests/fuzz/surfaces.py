"""Random surfaces, what is held of them, and how far it is moved: from usual to absurd."""

from __future__ import annotations

from pathlib import Path
from random import Random
from typing import Any

import numpy as np

from solver import Deformer, Material, Mesh
from solver.geometry.motions import motion, moved, rotation
from solver.types import FloatArray, IntArray
from tests.solver import shapes


def surface(random: Random) -> tuple[FloatArray, IntArray]:
    """A grid, bumpy, flat or as soup, of a size and at a place from usual to extreme."""
    numbers = np.random.default_rng(random.randrange(2**32))
    V, F = shapes.grid(random.randint(2, 9), random.randint(2, 9))
    V = V + random.choice((0, 1e-9, 0.2, 5)) * numbers.normal(size=V.shape)
    V = V * random.choice(([1, 1, 1], [1, 1e-6, 1], [1, 0, 1], [1, 1, 1e3]))
    if random.random() < 0.2:
        F = numbers.integers(0, len(V), F.shape)
    if random.random() < 0.2:
        V[numbers.integers(len(V), size=3)] = V[0]
    V = V + random.choice((0, 0, 0, 1, 1e6)) * numbers.normal(size=3)
    return V * 10.0 ** random.choice((0, 0, 0, 0, -3, 6, -20, 30, -70, 70)), F


def transform(random: Random, size: float) -> FloatArray:
    """(4, 4): a rigid motion, or anything else that 16 numbers can be."""
    numbers = np.random.default_rng(random.randrange(2**32))
    T = motion(rotation(numbers.normal(size=3), random.choice((0, 5, 90, 180, 359))), [0, 0, 0])
    T[:3, 3] = numbers.normal(size=3) * size * random.choice((0, 0.1, 1, 100))
    kind = random.randrange(8)
    if kind == 0:
        T[:3, :3] = numbers.normal(size=(3, 3)) * random.choice((1, 0, 100, 1e10))
    if kind == 1:
        place = tuple(numbers.integers(4, size=2))
        T[place] = random.choice((np.nan, np.inf, 1e308, -1e308, 1e-320, 0))
    return T


def how(random: Random, count: int) -> dict[str, Any]:
    """Options of a Deformer, some of them refused."""
    numbers = np.random.default_rng(random.randrange(2**32))
    softness = [None, numbers.random(count), np.round(numbers.random(count)), np.ones(count)]
    gains = [1.0, 1e-6, 1e6, 1e-3, 10.0, 0.0, np.nan, 1e300]
    material: Any = random.choice(("hinge", "paper", "clay"))
    if random.random() < 0.3:
        try:
            material = Material(*random.choices(gains, weights=(9, 2, 2, 9, 9, 1, 1, 1), k=2))
        except ValueError:
            material = "no such"
    return {
        "softness": random.choice(softness),
        "material": material,
        "bending_length": random.choice((0.01, 0.01, 0.1, 1e-12, 1e3, 0.0)),
        "orientation": random.random() < 0.7,
        "attach": random.random() < 0.7,
        "coarse": random.choice((None, None, None, 20)),
    }


def held(random: Random, mesh: Mesh) -> tuple[list[int], list[list[int]]]:
    """What is fixed and the handles; vertices that are welded are held as one."""
    order = random.sample(range(len(mesh.vertices)), len(mesh.vertices))
    cuts = sorted(random.choices(range(len(order) // 2 + 1), k=3))
    places = [mesh.welded[order[a:b]] for a, b in zip([0, *cuts[:-1]], cuts, strict=True)]
    taken = np.full(len(order), -1)
    for number, part in enumerate(places):
        taken[np.setdiff1d(part, np.flatnonzero(taken >= 0))] = number
    part_of = taken[mesh.welded]
    fixed, *handles = ([int(v) for v in np.flatnonzero(part_of == k)] for k in range(len(places)))
    return fixed, [part for part in handles if part]


def deform(random: Random, folder: Path) -> None:
    """Whatever is bound: positions are finite, and what is held is where it was put."""
    V, F = surface(random)
    fixed, handles = held(random, Mesh.from_arrays(V, F))
    size = float(np.linalg.norm(np.ptp(V, axis=0)))
    deformer = Deformer(V, F, fixed, handles, **how(random, len(V)))
    transforms = [transform(random, size) for _ in handles]
    X = deformer.pose(transforms, random.choice((0, 1, 2, 4)))
    assert np.isfinite(X).all(), "positions are not finite"
    assert np.array_equal(X[fixed], V[fixed]), "what is fixed moved"
    reach = size + np.abs(X).max() + np.abs(V).max()
    for part, T in zip(handles, transforms, strict=True):
        # The rest position times the linear part is rounded, wherever the two nearly cancel.
        away = np.abs(X[part] - moved(T, V[part])).max()
        rounding = reach + np.abs(T[:3, :3]).max() * np.abs(V).max()
        assert away <= 1e-9 * rounding, f"a handle is {away:g} from its place"
