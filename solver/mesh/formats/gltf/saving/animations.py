"""Animated weights of morph targets, which grow with the number of targets."""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np

from solver.errors import MeshError
from solver.mesh.formats.gltf.accessors import read_floats
from solver.mesh.formats.gltf.saving.edit import Edit
from solver.mesh.formats.gltf.schema import Json

_POINTER = re.compile(r"/(meshes|nodes)/(\d{1,9})/weights")


def widen_weights(edit: Edit, before: Mapping[int, int], added: Mapping[int, int]) -> None:
    """Keep every animation of weights as it is: the targets added to a mesh stay at 0.

    before, added: the number of targets of each mesh.
    """
    for animation in edit.json.get("animations", []):
        for number, sampler in enumerate(list(animation["samplers"])):
            users = [c for c in animation["channels"] if c["sampler"] == number]
            sizes: dict[tuple[int, int], list[Json]] = {}
            for channel in users:
                mesh = _animated_mesh(edit.json, channel["target"])
                if mesh is not None and mesh in added and before[mesh]:
                    sizes.setdefault((before[mesh], added[mesh]), []).append(channel)
            for size, channels in sizes.items():
                output = _widened(edit, sampler["output"], *size)
                if channels == users:
                    sampler["output"] = output
                else:
                    # Others read the same sampler for meshes of other sizes.
                    _give_own_sampler(animation, channels, {**sampler, "output": output})


def _animated_mesh(root: Json, target: Json) -> int | None:
    """The mesh whose weights an animation's target names."""
    nodes, meshes = root.get("nodes", []), root.get("meshes", [])
    node = target.get("node") if target.get("path") == "weights" else None
    if target.get("path") == "pointer":
        extension = target.get("extensions", {}).get("KHR_animation_pointer", {})
        match = _POINTER.fullmatch(str(extension.get("pointer")))
        number = int(match[2]) if match else -1
        if match and match[1] == "meshes":
            return number if number < len(meshes) else None
        node = number if 0 <= number < len(nodes) else None
    return None if node is None else nodes[node].get("mesh")


def _widened(edit: Edit, output: int, before: int, added: int) -> int:
    """An accessor with zeros behind each `before` values of another one.

    What does not hold so many values is no animation of them, and stays.
    """
    try:
        weights = read_floats(edit.gltf, output, "SCALAR")
    except MeshError:
        return output
    if len(weights) % before:
        return output
    wider = np.pad(weights.reshape(-1, before), ((0, 0), (0, added)))
    return edit.append(edit.gltf.json["accessors"][output], wider.reshape(-1, 1))


def _give_own_sampler(animation: Json, channels: list[Json], sampler: Json) -> None:
    for channel in channels:
        channel["sampler"] = len(animation["samplers"])
    animation["samplers"].append(sampler)
