"""Poses as morph targets of the meshes of a glTF file."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

from solver.mesh.formats.gltf.accessors import FLOAT
from solver.mesh.formats.gltf.primitives import target_count
from solver.mesh.formats.gltf.saving.animations import widen_weights
from solver.mesh.formats.gltf.saving.deform import DeformedPart
from solver.mesh.formats.gltf.saving.edit import Edit
from solver.mesh.formats.gltf.schema import Json
from solver.types import FloatArray

_OFFSETS: Json = {"type": "VEC3"}
# Positions state their bounds.
_BOUNDED: Json = {"type": "VEC3", "min": [], "max": []}


def add_poses(
    edit: Edit, shapes: Sequence[DeformedPart], X: FloatArray, poses: Mapping[str, FloatArray]
) -> None:
    """Give the meshes a morph target of weight 0 for each pose, behind those they have.

    At weight 1 the target takes positions X of the surface to those of the pose. A mesh that a
    pose leaves as it is goes without, but for a pose that is X itself. A name that is taken gets a
    number behind it.
    """
    meshes: dict[int, list[DeformedPart]] = {}
    for shape in shapes:
        meshes.setdefault(shape.part.mesh, []).append(shape)
    chosen: dict[int, dict[str, FloatArray]] = {mesh: {} for mesh in meshes}
    for name, pose in poses.items():
        changes = [m for m, own in meshes.items() if any(s.moved(X, pose).any() for s in own)]
        for mesh in changes or meshes:
            chosen[mesh][name] = pose
    before = {mesh: target_count(edit.json["meshes"][mesh]) for mesh in meshes}
    for mesh, own in chosen.items():
        if own:
            _add_targets(edit, edit.json["meshes"][mesh], meshes[mesh], X, own.values())
            _name_targets(edit.json["meshes"][mesh], before[mesh], list(own))
    added = {mesh: len(own) for mesh, own in chosen.items() if own}
    _widen_defaults(edit.json, before, added)
    widen_weights(edit, before, added)


def _add_targets(
    edit: Edit, mesh: Json, shapes: list[DeformedPart], X: FloatArray, poses: Collection[FloatArray]
) -> None:
    """All primitives of a mesh have as many targets: points, lines and odd ones get still ones."""
    primitives, before = mesh["primitives"], target_count(mesh)
    for primitive in primitives:
        _fill(edit, primitive, before)
    with_normals = {i for i, primitive in enumerate(primitives) if _takes_normals(primitive)}
    for shape in shapes:
        for pose in poses:
            position = edit.append(_BOUNDED, shape.steps(X, pose))
            for i in shape.part.primitives:
                primitives[i].setdefault("targets", []).append({"POSITION": position})
        for accessor, users in shape.users("NORMAL").items():
            new = [primitives[i]["targets"][before:] for i in with_normals.intersection(users)]
            _add_normals(edit, shape, accessor, X, zip(poses, zip(*new, strict=True), strict=False))
    for primitive in primitives:
        _fill(edit, primitive, before + len(poses))


def _add_normals(
    edit: Edit,
    shape: DeformedPart,
    accessor: int,
    X: FloatArray,
    targets: Iterable[tuple[FloatArray, Iterable[Json]]],
) -> None:
    """Normals from X to each pose, in the targets of it."""
    normals = shape.directions("NORMAL", accessor, X)[0]
    for pose, own in targets:
        turned = shape.directions("NORMAL", accessor, pose)[0] - normals
        number = edit.append(_OFFSETS, turned)
        for target in own:
            target["NORMAL"] = number


def _fill(edit: Edit, primitive: Json, size: int) -> None:
    """Targets that move nothing, up to so many; an accessor without data is all zeros."""
    missing = size - len(primitive.get("targets", []))
    if missing > 0 and "POSITION" in primitive["attributes"]:
        accessors = edit.json["accessors"]
        count = accessors[primitive["attributes"]["POSITION"]]["count"]
        still = {"POSITION": len(accessors)}
        bounds = {"min": [0, 0, 0], "max": [0, 0, 0]}
        accessors.append({"componentType": FLOAT, "count": count, "type": "VEC3"} | bounds)
        primitive.setdefault("targets", []).extend(dict(still) for _ in range(missing))


def _takes_normals(primitive: Json) -> bool:
    """Viewers expect the same attributes in every target of a primitive."""
    return all("NORMAL" in target for target in primitive.get("targets", []))


def _name_targets(mesh: Json, before: int, names: list[str]) -> None:
    extras = mesh.get("extras", {})
    if not isinstance(extras, dict):
        extras = {"extras": extras}
    old = extras.get("targetNames")
    taken = list(map(str, old))[:before] if isinstance(old, list) else []
    taken += [f"target {i}" for i in range(len(taken), before)]
    for name in names:
        free, number = name, 0
        while free in taken:
            number += 1
            free = f"{name}.{number:03}"
        taken.append(free)
    mesh["extras"] = extras | {"targetNames": taken}


def _widen_defaults(root: Json, before: Mapping[int, int], added: Mapping[int, int]) -> None:
    """Default weights of 0 for the new targets, in meshes and in the nodes that have their own."""
    holders = [(root["meshes"][mesh], mesh) for mesh in added]
    holders += [
        (node, node["mesh"])
        for node in root.get("nodes", [])
        if node.get("mesh") in added and "weights" in node
    ]
    for holder, mesh in holders:
        weights = (holder.get("weights", []) + [0] * before[mesh])[: before[mesh]]
        holder["weights"] = weights + [0] * added[mesh]
