"""Poses as morph targets of the meshes of a glTF file."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import numpy as np

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
            _add_targets(edit, meshes[mesh], X, own.values())
            _name_targets(edit.json["meshes"][mesh], before[mesh], list(own))
    added = {mesh: len(own) for mesh, own in chosen.items() if own}
    _widen_defaults(edit.json, before, added)
    widen_weights(edit, before, added)


def _add_targets(
    edit: Edit, shapes: list[DeformedPart], X: FloatArray, poses: Collection[FloatArray]
) -> None:
    primitives = edit.json["meshes"][shapes[0].part.mesh]["primitives"]
    with_normals = {i for i, primitive in enumerate(primitives) if _takes_normals(primitive)}
    before = [len(primitive.get("targets", [])) for primitive in primitives]
    for shape in shapes:
        for pose in poses:
            position = edit.append(_BOUNDED, shape.steps(X, pose))
            for i in shape.part.primitives:
                primitives[i].setdefault("targets", []).append({"POSITION": position})
        for accessor, users in shape.users("NORMAL").items():
            chosen = with_normals.intersection(users)
            if not chosen:
                continue
            normals = shape.directions("NORMAL", accessor, X)[0]
            for k, pose in enumerate(poses):
                turned = shape.directions("NORMAL", accessor, pose)[0] - normals
                number = edit.append(_OFFSETS, turned)
                for i in chosen:
                    primitives[i]["targets"][before[i] + k]["NORMAL"] = number
    # All primitives of a mesh have as many targets: points and lines, too.
    shown = {i for shape in shapes for i in shape.part.primitives}
    for i, primitive in enumerate(primitives):
        if i not in shown and "POSITION" in primitive["attributes"]:
            count = edit.json["accessors"][primitive["attributes"]["POSITION"]]["count"]
            still = edit.append(_BOUNDED, np.zeros((count, 3)))
            primitive.setdefault("targets", []).extend({"POSITION": still} for _ in poses)


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
