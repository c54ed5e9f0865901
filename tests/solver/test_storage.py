from __future__ import annotations

import os
import stat
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from solver.errors import FileError
from solver.storage import read_bytes, write_atomically

posix_only = pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions and links")


def test_what_is_written_is_read_back(tmp_path: Path) -> None:
    write_atomically(tmp_path / "a.obj", b"one\r\n\x00\xff")
    write_atomically(tmp_path / "a.obj", b"two")
    assert read_bytes(tmp_path / "a.obj") == b"two"
    assert os.listdir(tmp_path) == ["a.obj"]


def test_pieces_become_one_file_or_none(tmp_path: Path) -> None:
    def pieces(last: Exception | None) -> Iterator[bytes]:
        yield b"one "
        if last is not None:
            raise last
        yield b"two"

    write_atomically(tmp_path / "a.mp4", pieces(None))
    assert read_bytes(tmp_path / "a.mp4") == b"one two"
    with pytest.raises(FileError, match="cannot be written: gone"):
        write_atomically(tmp_path / "a.mp4", pieces(OSError("gone")))
    assert read_bytes(tmp_path / "a.mp4") == b"one two"
    assert os.listdir(tmp_path) == ["a.mp4"]


@pytest.mark.parametrize("name", ["missing.obj", "", "nul\0.obj"])
def test_reading_what_is_no_file_is_one_clear_line(tmp_path: Path, name: str) -> None:
    with pytest.raises(FileError) as caught:
        read_bytes(tmp_path / name)
    assert str(tmp_path) in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_missing_folder_is_named(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="no-such-folder does not exist"):
        write_atomically(tmp_path / "no-such-folder" / "a.obj", b"")


def test_a_folder_is_not_replaced(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="not a regular file"):
        write_atomically(tmp_path, b"")
    assert tmp_path.is_dir()


def test_a_write_protected_file_is_left_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = tmp_path / "a.obj"
    target.write_bytes(b"old")
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    with pytest.raises(FileError, match="write-protected"):
        write_atomically(target, b"new")
    assert target.read_bytes() == b"old"


@pytest.mark.parametrize("step", ["fsync", "replace"])
def test_a_failed_write_keeps_the_old_file_and_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, step: str
) -> None:
    def fail(*args: object) -> None:
        raise OSError(28, "No space left on device")

    target = tmp_path / "a.obj"
    target.write_bytes(b"old")
    monkeypatch.setattr(os, step, fail)
    with pytest.raises(FileError, match=r"a\.obj: cannot be written: No space left on device"):
        write_atomically(target, b"new")
    assert target.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["a.obj"]


@posix_only
def test_permissions_of_an_existing_file_are_kept(tmp_path: Path) -> None:
    target = tmp_path / "a.obj"
    target.write_bytes(b"old")
    target.chmod(0o640)
    write_atomically(target, b"new")
    assert stat.S_IMODE(target.stat().st_mode) == 0o640


@posix_only
def test_a_new_file_has_the_permissions_of_any_new_file(tmp_path: Path) -> None:
    (tmp_path / "plain").write_bytes(b"")
    write_atomically(tmp_path / "atomic", b"")
    assert (tmp_path / "atomic").stat().st_mode == (tmp_path / "plain").stat().st_mode


@posix_only
def test_a_symbolic_link_is_written_through(tmp_path: Path) -> None:
    target, link = tmp_path / "real.obj", tmp_path / "link.obj"
    target.write_bytes(b"old")
    link.symlink_to(target)
    write_atomically(link, b"new")
    assert link.is_symlink()
    assert target.read_bytes() == b"new"


@posix_only
def test_a_private_file_never_passes_through_a_readable_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target, modes = tmp_path / "a.json", []
    target.write_bytes(b"old")
    target.chmod(0o600)
    replace = os.replace

    def watched(source: Path, goal: Path) -> None:
        modes.append(stat.S_IMODE(Path(source).stat().st_mode))
        replace(source, goal)

    def at_flush(number: int) -> None:
        modes.append(stat.S_IMODE(os.fstat(number).st_mode))

    monkeypatch.setattr(os, "fsync", at_flush)
    monkeypatch.setattr(os, "replace", watched)
    write_atomically(target, b"new")
    assert modes[:2] == [0o600, 0o600]


@posix_only
def test_the_folder_is_flushed_after_the_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    flushed: list[bool] = []
    monkeypatch.setattr(
        os, "fsync", lambda number: flushed.append(stat.S_ISDIR(os.fstat(number).st_mode))
    )
    write_atomically(tmp_path / "a.obj", b"new")
    assert flushed == [False, True]


KILLED = """
import os, signal, sys
from pathlib import Path
from solver import storage
os.replace = lambda *names: os.kill(os.getpid(), signal.SIGKILL)
storage.write_atomically(Path(sys.argv[1]), b"half")
"""


@posix_only
def test_what_a_killed_save_left_is_removed_by_the_next_one(tmp_path: Path) -> None:
    target = tmp_path / "a.json"
    target.write_bytes(b"old")
    root = Path(__file__).resolve().parents[2]
    environment = os.environ | {"PYTHONPATH": str(root)}
    done = subprocess.run([sys.executable, "-c", KILLED, str(target)], env=environment, check=False)
    assert done.returncode != 0
    assert target.read_bytes() == b"old"
    assert len(os.listdir(tmp_path)) == 2
    mine = tmp_path / ".deform-notes.tmp"
    mine.write_bytes(b"a person's own")
    write_atomically(tmp_path / "b.json", b"new")
    assert sorted(os.listdir(tmp_path)) == [".deform-notes.tmp", "a.json", "b.json"]
