"""The scene of a glTF file: which mesh stands where, and how skins and weights shape it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from solver.mesh.formats.gltf.accessors import read_floats, read_integers
from solver.mesh.formats.gltf.container import Gltf
from solver.mesh.formats.gltf.schema import Json
from solver.types import FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class Placement:
    """How vertices of a mesh come to their place in the scene: x -> linear x + offset.

    linear: (3, 3) for all vertices, or (n, 3, 3) where a skin blends its joints at each.
    offset: (3,) or (n, 3).
    """

    linear: FloatArray
    offset: FloatArray

    def apply(self, local: FloatArray) -> FloatArray:
        """(n, 3) positions in the scene."""
        return np.einsum("...ij,...j->...i", self.linear, local) + self.offset

    @property
    def mirrors(self) -> bool:
        """Whether it turns triangles inside out; skins do not count."""
        return self.linear.ndim == 2 and bool(np.linalg.det(self.linear) < 0)


def nodes_with_meshes(gltf: Gltf) -> list[int]:
    """Nodes of the default scene (the first where none is named, all nodes where there is none)
    that show a mesh, in the order of the tree."""
    nodes, scenes = gltf.entries("nodes"), gltf.entries("scenes")
    first = gltf.json.get("scene", 0)
    roots = scenes[first].get("nodes", []) if scenes else _roots(gltf)
    return [node for node, _ in _walk(gltf, roots) if "mesh" in nodes[node]]


def world_transforms(gltf: Gltf) -> FloatArray:
    """(nodes, 4, 4) from the space of each node to that of the scene."""
    nodes = gltf.entries("nodes")
    world = np.tile(np.eye(4), (len(nodes), 1, 1))
    for node, parent in _walk(gltf, [*_roots(gltf), *range(len(nodes))]):
        local = _local_transform(nodes[node])
        world[node] = local if parent is None else world[parent] @ local
    return world


def placement(gltf: Gltf, node: int, primitive: Json, world: FloatArray) -> Placement:
    """Where the scene puts the vertices of a primitive.

    A skin moves vertices by its joints as they stand, weighted, whatever the node's own transform.
    """
    skin = gltf.entries("nodes")[node].get("skin")
    attributes = primitive["attributes"]
    if skin is None or "JOINTS_0" not in attributes or "WEIGHTS_0" not in attributes:
        return Placement(world[node, :3, :3], world[node, :3, 3])
    joints = _joint_transforms(gltf, gltf.json["skins"][skin], world)
    blended = _blend(gltf, attributes, joints)
    return Placement(blended[:, :, :3], blended[:, :, 3])


def _roots(gltf: Gltf) -> list[int]:
    nodes = gltf.entries("nodes")
    children = {child for node in nodes for child in node.get("children", [])}
    return [node for node in range(len(nodes)) if node not in children]


def _walk(gltf: Gltf, roots: list[int]) -> Iterator[tuple[int, int | None]]:
    """Every node below the roots once, with its parent, parents first. Circles are cut."""
    nodes = gltf.entries("nodes")
    seen: set[int] = set()
    todo: list[tuple[int, int | None]] = [(root, None) for root in reversed(roots)]
    while todo:
        node, parent = todo.pop()
        if node not in seen:
            seen.add(node)
            yield node, parent
            todo += [(child, node) for child in reversed(nodes[node].get("children", []))]


def _local_transform(node: Json) -> FloatArray:
    if "matrix" in node:
        # Column by column in the file.
        return np.array(node["matrix"], dtype=np.float64).reshape(4, 4).T
    result = np.eye(4)
    rotation = _rotation(np.array(node.get("rotation", [0, 0, 0, 1]), dtype=np.float64))
    result[:3, :3] = rotation * np.array(node.get("scale", [1, 1, 1]), dtype=np.float64)
    result[:3, 3] = node.get("translation", [0, 0, 0])
    return result


def _rotation(quaternion: FloatArray) -> FloatArray:
    """(x, y, z, w) of any length as a matrix; a zero one turns nothing."""
    largest = np.abs(quaternion).max()
    if largest == 0 or (quaternion[:3] == 0).all():
        return np.eye(3)
    q = quaternion / largest
    x, y, z, w = q / np.linalg.norm(q)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + 2 * (w * cross + cross @ cross)


def _joint_transforms(gltf: Gltf, skin: Json, world: FloatArray) -> FloatArray:
    """(joints, 3, 4) from the space of the mesh to the scene."""
    transforms = world[skin["joints"]]
    if "inverseBindMatrices" in skin:
        inverse = read_floats(gltf, skin["inverseBindMatrices"], "MAT4")[: len(transforms)]
        if len(inverse) < len(transforms):
            raise gltf.error(f"a skin with {len(transforms)} joints and {len(inverse)} matrices")
        transforms = transforms @ inverse.reshape(-1, 4, 4).transpose(0, 2, 1)
    return transforms[:, :3]


def _blend(gltf: Gltf, attributes: dict[str, int], joints: FloatArray) -> FloatArray:
    """(n, 3, 4) for every vertex the mean of its joints, by weight."""
    sets = [i for i in range(len(attributes)) if {f"JOINTS_{i}", f"WEIGHTS_{i}"} <= set(attributes)]
    index = [read_integers(gltf, attributes[f"JOINTS_{i}"], "VEC4") for i in sets]
    weight = [read_floats(gltf, attributes[f"WEIGHTS_{i}"], "VEC4") for i in sets]
    count = gltf.json["accessors"][attributes["POSITION"]]["count"]
    if {len(array) for array in [*index, *weight]} != {count}:
        raise gltf.error(f"expected joints and weights for {count} vertices")
    return _mean(gltf, np.concatenate(index, axis=1), np.concatenate(weight, axis=1), joints)


def _mean(gltf: Gltf, index: IntArray, weight: FloatArray, joints: FloatArray) -> FloatArray:
    used = np.where(weight != 0, index, 0)
    if used.size and used.max() >= len(joints):
        raise gltf.error(f"a vertex hangs on joint {used.max()}, but the skin has {len(joints)}")
    # Without any weight, the first joint has it all, as viewers do.
    total = weight.sum(axis=1, keepdims=True)
    unweighted = ~(total > 0)
    weight = np.where(unweighted, 0.0, weight) / np.where(unweighted, 1.0, total)
    weight[:, :1] += unweighted
    result = np.zeros((len(index), 3, 4))
    for k in range(index.shape[1]):
        result += weight[:, k, None, None] * joints[used[:, k]]
    return result
