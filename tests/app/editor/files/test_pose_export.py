"""All kept poses saved at once: what is in the files, and what is left alone."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
import pytest

from app.editor import commands as c
from app.editor.files.pose_export import SOLVING
from app.model.handles import Pose
from app.model.poses import blended_pose
from app.worker.service import bind
from app.worker.snapshot import bind_request
from solver import load_mesh
from solver.geometry.motions import motion, rotation
from solver.types import FloatArray
from tests.app.inline import SlowWorker
from tests.app.person import Person, error_of, question_of, slab, state

UP = motion(rotation([0, 1, 0], -40), [1.0, 0, 3])
TURNED = motion(rotation([0, 0, 1], 100), [1.0, 2, 3], centre=[19.0, 2, -1])


@pytest.fixture
def two(tmp_path: Path) -> Person:
    """The bar from bar.obj, with poses "up" and "turned"; somewhere else now."""
    slab(20, 4, 2.0).save(tmp_path / "bar.obj", slab(20, 4, 2.0).vertices)
    path = tmp_path / "bar.obj"
    person = Person(load_mesh(path), path, worker=SlowWorker())
    person.ready_bar()
    document = person.editor.document
    handle = document.handles[0].key
    for name, T in (("up", UP), ("turned", TURNED)):
        kept = document.new_pose(Pose({handle: T}), name)
        document.change("poses", (*document.poses, kept))
    person.stroke([19, 2, 0], [17, 5, 0])
    person.editor.settle()
    return person


def solved(person: Person, pose: Pose) -> FloatArray:
    document = person.editor.document
    deformer = bind(bind_request(document))
    return deformer.pose(list(pose.stacked(document.bound_keys)), rigid=document.rigid)


def files(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir() if path.name != "bar.obj")


def test_every_pose_is_a_file_beside_what_is_on_screen(two: Person, tmp_path: Path) -> None:
    document = two.editor.document
    before, shown = state(document), two.editor.positions
    entries = len(two.editor.history.done)
    two.do(c.ExportPoses(tmp_path / "out.obj"))
    assert files(tmp_path) == ["out-turned.obj", "out-up.obj", "out.obj"]
    for kept in document.poses:
        X = load_mesh(tmp_path / f"out-{kept.name}.obj").vertices
        np.testing.assert_allclose(X, solved(two, kept.pose), atol=1e-8)
    np.testing.assert_allclose(load_mesh(tmp_path / "out.obj").vertices, shown, atol=1e-8)
    assert state(document) == before
    assert len(two.editor.history.done) == entries
    np.testing.assert_allclose(two.editor.positions, shown, atol=1e-12)


def test_shapes_between_are_numbered_files_from_the_rest_shape_on(
    two: Person, tmp_path: Path
) -> None:
    two.do(c.ExportPoses(tmp_path / "out.ply", between=1))
    expected = ["000-rest", "001", "002-up", "003", "004-turned"]
    assert files(tmp_path) == [*(f"out-{name}.ply" for name in expected), "out.ply"]
    document = two.editor.document
    up, turned = (kept.pose for kept in document.poses)
    centres = document.handle_centres()
    halves = [blended_pose(a, b, 0.5, centres) for a, b in ((Pose(), up), (up, turned))]
    poses = [Pose(), halves[0], up, halves[1], turned]
    for name, pose in zip(expected, poses, strict=True):
        X = load_mesh(tmp_path / f"out-{name}.ply").vertices
        np.testing.assert_allclose(X, solved(two, pose), atol=1e-5)


def test_a_gltf_holds_poses_and_what_is_between_as_morph_targets(
    two: Person, tmp_path: Path
) -> None:
    two.do(c.ResetPose(), c.ExportPoses(tmp_path / "out.gltf", between=2))
    assert files(tmp_path) == ["out.gltf"]
    mesh = json.loads((tmp_path / "out.gltf").read_text())["meshes"][0]
    names = ["up 1/3", "up 2/3", "up", "turned 1/3", "turned 2/3", "turned"]
    assert mesh["extras"]["targetNames"] == names
    assert len(mesh["primitives"][0]["targets"]) == 6
    rest = two.editor.document.mesh.vertices
    np.testing.assert_allclose(load_mesh(tmp_path / "out.gltf").vertices, rest, atol=1e-6)


def test_a_file_of_somebody_else_is_asked_about_and_may_be_spared(
    two: Person, tmp_path: Path
) -> None:
    for name in ("out-turned.obj", "out-2-up.obj"):
        (tmp_path / name).write_text("mine")
    two.do(c.ExportPoses(tmp_path / "out.obj"))
    assert f"{tmp_path / 'out-turned.obj'} is there already" in question_of(two)
    assert files(tmp_path) == ["out-2-up.obj", "out-turned.obj"]
    two.answer("Save as out-3.obj")
    assert {"out-3-turned.obj", "out-3-up.obj", "out-3.obj"} < set(files(tmp_path))
    for name in ("out-turned.obj", "out-2-up.obj"):
        assert (tmp_path / name).read_text() == "mine"


def test_what_an_export_wrote_it_may_write_again_until_somebody_changes_it(
    two: Person, tmp_path: Path
) -> None:
    out, up = tmp_path / "out.obj", tmp_path / "out-up.obj"
    two.do(c.ExportPoses(out))
    first = up.read_bytes()
    two.do(c.SetSetting("bending_length", 0.1), c.ExportPoses(out))
    assert up.read_bytes() != first
    changed = up.read_bytes() + b"# mine\n"
    up.write_bytes(changed)
    os.utime(up, ns=(1, 1))
    two.do(c.ExportPoses(out))
    assert "out-up.obj was changed by somebody else meanwhile" in question_of(two)
    assert up.read_bytes() == changed
    two.answer("Replace")
    assert up.read_bytes() != changed


def test_the_open_mesh_is_not_replaced_unasked(two: Person, tmp_path: Path) -> None:
    document = two.editor.document
    before = (tmp_path / "bar.obj").read_bytes()
    two.do(c.ExportPoses(tmp_path / "bar.obj"))
    assert "is the mesh that is open" in question_of(two)
    two.answer("Cancel")
    (tmp_path / "bar.obj").rename(tmp_path / "a-up.obj")
    document.path = tmp_path / "a-up.obj"
    two.do(c.ExportPoses(tmp_path / "a.obj"))
    assert "a-up.obj is the mesh that is open" in question_of(two)
    two.answer("Cancel")
    assert (tmp_path / "a-up.obj").read_bytes() == before
    assert not (tmp_path / "a.obj").exists()


def test_what_cannot_be_saved_is_a_message(two: Person, tmp_path: Path) -> None:
    two.do(c.ExportPoses(tmp_path / "out.obj", between=-1))
    assert "shapes between two poses must be 0 to 100, got -1" in error_of(two)
    two.do(c.ExportPoses(tmp_path / "out.docx"))
    assert "unknown mesh format" in error_of(two)
    kept = two.editor.document.poses
    two.do(c.RenamePose(kept[0].key, "turned 1/2"))
    two.do(c.ExportPoses(tmp_path / "out.glb", between=1))
    assert "two poses would be called 'turned 1/2'" in error_of(two)
    for pose in kept:
        two.do(c.DeletePose(pose.key))
    two.do(c.ExportPoses(tmp_path / "out.obj"))
    assert "no pose is kept" in error_of(two)
    assert files(tmp_path) == []


def test_a_pose_that_cannot_be_solved_leaves_all_as_it_was(two: Person, tmp_path: Path) -> None:
    document = two.editor.document
    wild = np.eye(4)
    wild[:3, 3] = np.inf
    kept = document.new_pose(Pose({document.handles[0].key: wild}), "wild")
    document.change("poses", (*document.poses, kept))
    before = state(document)
    two.do(c.ExportPoses(tmp_path / "out.obj"))
    assert error_of(two)
    assert state(document) == before
    assert files(tmp_path) == []


def test_it_says_how_far_it_is_and_the_window_answers_meanwhile(
    two: Person, tmp_path: Path
) -> None:
    shown = two.editor.positions
    two.editor.execute(c.ExportPoses(tmp_path / "out.obj"))
    told: list[float] = []
    while (task := two.editor.tasks.now) is not None:
        assert task.fraction is not None
        told.append(task.fraction)
        two.frame([10, 2, 0])
    assert told == sorted(told)
    assert {round(SOLVING * part / 3, 6) for part in (1, 2)} <= {round(part, 6) for part in told}
    assert told.count(told[0]) > 1, "also while one is waited for"
    np.testing.assert_allclose(load_mesh(tmp_path / "out.obj").vertices, shown, atol=1e-8)


def test_what_is_done_meanwhile_is_not_in_it(two: Person, tmp_path: Path) -> None:
    shown, document = two.editor.positions, two.editor.document
    expected = {kept.name: solved(two, kept.pose) for kept in document.poses}
    two.editor.execute(c.ExportPoses(tmp_path / "out.obj"))
    two.stroke([17, 5, 0], [15, 8, 0])
    two.editor.execute(c.DeletePose(document.poses[0].key))
    two.editor.execute(c.SetSetting("bending_length", 0.1))
    two.editor.complete()
    assert files(tmp_path) == ["out-turned.obj", "out-up.obj", "out.obj"]
    expected |= {"": shown}
    for name, X in expected.items():
        path = tmp_path / ("out" + (name and f"-{name}") + ".obj")
        np.testing.assert_allclose(load_mesh(path).vertices, X, atol=1e-8)


def test_an_export_that_is_cancelled_leaves_all_as_it_was(two: Person, tmp_path: Path) -> None:
    before = state(two.editor.document)
    two.editor.execute(c.ExportPoses(tmp_path / "out.obj"))
    two.frame([10, 2, 0])
    two.do(c.CancelGesture())
    assert two.editor.message is not None
    assert two.editor.message.text == "Exporting out.obj was cancelled"
    assert state(two.editor.document) == before
    assert files(tmp_path) == []


def test_a_file_that_appears_meanwhile_is_not_replaced(two: Person, tmp_path: Path) -> None:
    two.editor.execute(c.ExportPoses(tmp_path / "out.obj"))
    (tmp_path / "out-up.obj").write_text("mine")
    two.editor.complete()
    assert "out-up.obj is there already" in question_of(two)
    assert files(tmp_path) == ["out-up.obj"]
