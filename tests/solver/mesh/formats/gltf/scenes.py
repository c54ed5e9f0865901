"""glTF files by hand: arrays become accessors of any layout, and JSON goes around them."""

from __future__ import annotations

import base64
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.transform import Rotation

from solver.mesh.mesh import Mesh, load_mesh
from solver.types import FloatArray, IntArray

Json = dict[str, Any]
CODES = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123, "u4": 5125, "f4": 5126}
TYPES = {1: "SCALAR", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
# A bent strip of four triangles, not flat anywhere.
P = np.array([[0, 0, 0], [1, 0, 0.25], [0, 1, 0.5], [1, 1, 0], [0, 2, 0.75], [1, 2, 1.5]])
F = np.array([[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]])

TURN = Rotation.from_euler("xyz", [0.3, -0.5, 0.7])


class Scene:
    """A glTF file that grows: `json` may be changed at will, `data` holds the one buffer."""

    def __init__(self) -> None:
        self.json: Json = {"asset": {"version": "2.0"}, "accessors": [], "bufferViews": []}
        self.data = b""

    def view(self, data: bytes, **members: int) -> int:
        """A buffer view of the data."""
        self.data += bytes(-len(self.data) % 4)
        entry = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)} | members
        self.data += data
        self.json["bufferViews"].append(entry)
        return len(self.json["bufferViews"]) - 1

    def accessor(self, values: ArrayLike, kind: str = "f4", **members: Any) -> int:
        """An accessor of rows of numbers, tight in a buffer view of its own."""
        array = np.asarray(values)
        array = array.reshape(len(array), -1)
        entry = {
            "componentType": CODES[kind],
            "count": len(array),
            "type": TYPES[array.shape[1]],
        } | members
        if "bufferView" not in members and "sparse" not in members:
            entry["bufferView"] = self.view(array.astype("<" + kind).tobytes())
        self.json["accessors"].append(entry)
        return len(self.json["accessors"]) - 1

    def positions(self, values: ArrayLike) -> int:
        """An accessor of positions with their bounds."""
        array = np.asarray(values, dtype=np.float32)
        return self.accessor(array, min=array.min(axis=0).tolist(), max=array.max(axis=0).tolist())

    def mesh(self, *primitives: Json, **members: Any) -> int:
        """A mesh of primitives."""
        self.json.setdefault("meshes", []).append({"primitives": list(primitives)} | members)
        return len(self.json["meshes"]) - 1

    def node(self, **members: Any) -> int:
        """A node, in the scene unless it is another's child."""
        self.json.setdefault("nodes", []).append(members)
        return len(self.json["nodes"]) - 1

    def glb(self) -> bytes:
        """The bytes of a GLB."""
        root = {"buffers": [{"byteLength": len(self.data)}]} | self.json
        return pack_glb(root, self.data)

    def gltf(self) -> bytes:
        """The bytes of a .gltf with its data inside."""
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.data).decode()
        root = {"buffers": [{"byteLength": len(self.data), "uri": uri}]} | self.json
        return json.dumps(root).encode()

    def load(self, folder: Path, name: str = "source.glb") -> Mesh:
        """Write the file, and read it with the program."""
        (folder / name).write_bytes(self.glb() if name.endswith("glb") else self.gltf())
        return load_mesh(folder / name)


def strip(V: ArrayLike = P, **attributes: ArrayLike) -> tuple[Scene, Json]:
    """A scene with the bent strip as its one mesh, and its primitive."""
    scene = Scene()
    numbers = {"POSITION": scene.positions(V)}
    numbers |= {name: scene.accessor(values) for name, values in attributes.items()}
    primitive = {"attributes": numbers, "indices": scene.accessor(F.ravel(), "u2")}
    scene.node(mesh=scene.mesh(primitive))
    return scene, primitive


def trs(t: list[float], turn: Rotation, scale: list[float]) -> FloatArray:
    """(4, 4) scale, then turn, then translation."""
    result = np.eye(4)
    result[:3] = np.column_stack([turn.as_matrix() * scale, t])
    return result


def skinned() -> tuple[Scene, FloatArray, IntArray, FloatArray]:
    """The strip on two joints that do not stand as they were bound.

    Also the transform of each joint from the mesh to the scene, and the joints (6, 4) and weights
    of every vertex.
    """
    scene, primitive = strip()
    rng = np.random.default_rng(0)
    first, second = trs([1, 0, 0], TURN, [1, 1, 1]), trs([0, 1, 0], TURN, [1, 2, 1])
    world = np.array([first, first @ second])
    inverse = np.array([np.eye(4), trs([0.5, 0, 0], TURN.inv(), [1, 1, 1])])
    # Weights as exporters round them: they do not add up to one.
    joints, weights = rng.integers(0, 2, (6, 4)), rng.random((6, 4)).astype("<f4") + 0.1
    primitive["attributes"]["JOINTS_0"] = scene.accessor(joints, "u1")
    primitive["attributes"]["WEIGHTS_0"] = scene.accessor(weights)
    scene.json["nodes"][0] |= {"skin": 0, "translation": [9, 9, 9]}
    lower = scene.node(matrix=second.T.ravel().tolist())
    upper = scene.node(matrix=first.T.ravel().tolist(), children=[lower])
    matrices = scene.accessor(inverse.transpose(0, 2, 1))
    scene.json["skins"] = [{"joints": [upper, lower], "inverseBindMatrices": matrices}]
    return scene, world @ inverse, joints, weights.astype(np.float64)


def pack_glb(root: Json, data: bytes) -> bytes:
    text = json.dumps(root).encode()
    chunks = [(b"JSON", text + b" " * (-len(text) % 4)), (b"BIN\0", data + bytes(-len(data) % 4))]
    body = b"".join(struct.pack("<I", len(part)) + kind + part for kind, part in chunks)
    return b"glTF" + struct.pack("<II", 2, 12 + len(body)) + body


def unpack(path: Path) -> tuple[Json, bytes]:
    """The JSON of a GLB or .gltf whose data is inside, and its first buffer."""
    data = path.read_bytes()
    if not data.startswith(b"glTF"):
        root = json.loads(data)
        return root, base64.b64decode(root["buffers"][0]["uri"].partition(",")[2])
    size = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20 : 20 + size]), data[28 + size :]


def values(path: Path, number: int) -> NDArray[Any]:
    """A dense accessor of a saved file, (count, width), as it is stored."""
    root, data = unpack(path)
    accessor = root["accessors"][number]
    view = root["bufferViews"][accessor["bufferView"]]
    kind = next("<" + kind for kind, code in CODES.items() if code == accessor["componentType"])
    width = next(width for width, name in TYPES.items() if name == accessor["type"])
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    step = view.get("byteStride", np.dtype(kind).itemsize * width)
    rows = [np.frombuffer(data, kind, width, start + i * step) for i in range(accessor["count"])]
    return np.array(rows)


def bent(V: FloatArray) -> FloatArray:
    """Other positions, every one moved."""
    return V + 0.1 + 0.2 * np.sin(2 * V[:, [1, 2, 0]])
