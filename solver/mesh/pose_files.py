"""Where the poses of a mesh go that its format does not hold: a file each beside the mesh's."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from pathlib import Path

from solver.errors import MeshError
from solver.mesh.formats.table import format_of


def pose_paths(path: str | os.PathLike[str], poses: Iterable[str]) -> dict[str, str]:
    """The file of each pose that `Mesh.save` writes beside `path`; none where that holds them.

    Each is named after its pose as far as a file's name allows. Raises MeshError where two poses
    would have one file, also where the system takes capitals for small letters.

    >>> from solver.mesh.pose_files import pose_paths
    >>> pose_paths("out.obj", ["fist", "open hand"])
    {'fist': 'out-fist.obj', 'open hand': 'out-open_hand.obj'}
    """
    if format_of(path).keeps_poses:
        return {}
    whole = Path(path)
    paths: dict[str, str] = {}
    taken: set[str] = set()
    for pose in poses:
        safe = re.sub(r"[^\w.-]+", "_", pose)
        name = str(whole.with_name(f"{whole.stem}-{safe}{whole.suffix}"))
        if name.casefold() in taken:
            raise MeshError(f"{name}: two poses would be saved there, expected distinct names")
        taken.add(name.casefold())
        paths[pose] = name
    return paths
