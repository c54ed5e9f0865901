"""Which files are remembered: those that were opened or saved, as long as they are there."""

from __future__ import annotations

from pathlib import Path

from app.bundled import DEFAULT_MESH
from app.editor import commands as c
from app.workspace.recent import COUNT, Recent
from tests.app.person import Person, error_of, slab


def test_the_last_one_first_none_twice_and_no_more_than_ten(tmp_path: Path) -> None:
    kept: list[tuple[Path, ...]] = []
    recent = Recent([tmp_path / "old"], kept.append)
    paths = [tmp_path / str(number) for number in range(COUNT)]
    for path in paths:
        recent.add(path)
    assert recent.paths == tuple(reversed(paths))
    recent.add(tmp_path / "x" / ".." / "4")
    assert recent.paths[0] == tmp_path / "4"
    assert len(set(recent.paths)) == COUNT
    recent.drop(tmp_path / "4")
    assert tmp_path / "4" not in recent.paths
    count = len(kept)
    recent.drop(tmp_path / "4")
    assert len(kept) == count, "told of changes only"
    assert kept[-1] == recent.paths


def test_what_is_opened_and_saved_is_recent_and_what_is_gone_is_not(
    bar: Person, tmp_path: Path
) -> None:
    mesh = slab(3, 3, 1.0)
    mesh.save(tmp_path / "a.obj", mesh.vertices)
    work = bar.editor
    bar.do(c.OpenMesh(tmp_path / "a.obj"), c.SaveSession(tmp_path / "a.json"))
    assert work.recent.paths == (tmp_path / "a.json", tmp_path / "a.obj")
    bar.do(c.OpenSession(tmp_path / "a.json"), c.Export(tmp_path / "b.ply"))
    names = [path.name for path in work.recent.paths]
    assert names == ["b.ply", "a.json", "a.obj"]
    (tmp_path / "b.ply").unlink()
    bar.do(c.OpenMesh(tmp_path / "b.ply"))
    assert "b.ply: cannot be read: No such file" in error_of(bar)
    assert [path.name for path in work.recent.paths] == names[1:]
    (tmp_path / "a.json").write_text("{")
    bar.do(c.OpenSession(tmp_path / "a.json"))
    assert "a.json: line 1" in error_of(bar)
    assert tmp_path / "a.json" in work.recent.paths, "it is there, and can be mended"


def test_what_comes_with_the_program_is_not_recent(bar: Person) -> None:
    bar.do(c.OpenMesh(DEFAULT_MESH))
    assert bar.editor.recent.paths == ()
