"""Run by a Python that has bpy: `python in_blender.py TASK.npz ITERATIONS OUT.npz`.

TASK: V (n, 3), F (m, 3), held (k,), goals (k, 3).  OUT: X (n, 3), and the seconds of the bind and
of one deformation. Nothing of this project is imported: bpy comes with libraries of its own.
"""

import sys
import time

import bpy  # type: ignore[import-not-found]
import numpy as np


def main(task: str, iterations: str, out: str) -> None:
    data = np.load(task)
    V, held, goals = data["V"], data["held"], data["goals"]
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(V.tolist(), [], data["F"].tolist())
    thing = bpy.data.objects.new("object", mesh)
    bpy.context.scene.collection.objects.link(thing)
    bpy.context.view_layer.objects.active = thing
    thing.vertex_groups.new(name="anchors").add(held.tolist(), 1.0, "REPLACE")
    modifier = thing.modifiers.new("modifier", "LAPLACIANDEFORM")
    modifier.vertex_group, modifier.iterations = "anchors", int(iterations)
    start = time.perf_counter()
    bpy.ops.object.laplaciandeform_bind(modifier=modifier.name)
    evaluated(thing)
    bind = time.perf_counter() - start
    moved = V.copy()
    moved[held] = goals
    mesh.vertices.foreach_set("co", moved.ravel().astype(np.float32))
    mesh.update()
    start = time.perf_counter()
    result = evaluated(thing)
    seconds = time.perf_counter() - start
    np.savez(out, X=result, bind=bind, deformation=seconds)


def evaluated(thing: "bpy.types.Object") -> np.ndarray:
    """(n, 3) the vertices under the modifier."""
    thing.data.update_tag()
    graph = bpy.context.evaluated_depsgraph_get()
    graph.update()
    vertices = thing.evaluated_get(graph).data.vertices
    found = np.empty(3 * len(vertices), dtype=np.float32)
    vertices.foreach_get("co", found)
    return found.reshape(-1, 3)


if __name__ == "__main__":
    main(*sys.argv[1:])
