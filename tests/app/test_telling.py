"""One clear line, whatever arrives: hostile names, closed streams, few letters, Ctrl+C."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from app.__main__ import main
from app.telling import MOST, readable
from tests.app.command import ROOT, session, write, write_bar

UNSEEN = [
    ("two\nlines\r\n", r"two\nlines\r\n"),
    ("\x1b]0;title\x07\x1b[31mred", r"\x1b]0;title\x07\x1b[31mred"),
    ("\u202egnp.jbo", r"\u202egnp.jbo"),
    ("\u2066a\u2069", r"\u2066a\u2069"),
    ("line\u2028end\x85", r"line\u2028end\x85"),
    ("tab\there\0", r"tab\there\x00"),
    (os.fsdecode(b"caf\xe9.obj"), "caf" + ("é" if os.name == "nt" else r"\udce9") + ".obj"),
]
PLAIN = ["", "arm.obj", "C:\\meshes\\Körper.obj", "模型 — 手.ply", "a b"]


@pytest.mark.parametrize(("text", "shown"), UNSEEN)
def test_what_would_not_be_seen_is_escaped(text: str, shown: str) -> None:
    assert readable(text) == shown
    assert readable(shown) == shown


@pytest.mark.parametrize("text", PLAIN)
def test_what_can_be_read_stays(text: str) -> None:
    assert readable(text) == text


@pytest.mark.parametrize("letter", ["a", "\n", "\u202e"])
def test_a_long_line_keeps_its_ends(letter: str) -> None:
    line = readable(f"beginning {letter * 10_000_000} end")
    assert len(line) <= MOST + 3
    assert line.startswith("beginning ")
    assert line.endswith(" end")
    assert "..." in line


@pytest.fixture
def bar(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The working directory, with bar.obj and bar.json."""
    monkeypatch.chdir(tmp_path)
    write_bar()
    return tmp_path


HOSTILE = "a\n\x1b[2J\u202eb"


@pytest.mark.skipif(os.name == "nt", reason="its files have no such names")
@pytest.mark.parametrize(
    "words",
    [
        ("info", f"{HOSTILE}.obj"),
        ("info", f"bar.{HOSTILE}"),
        ("deform", "bar.obj", "--session", f"{HOSTILE}.json", "-o", "out.obj"),
        ("deform", "bar.obj", "--session", "bar.json", "-o", f"{HOSTILE}/out.obj"),
        ("deform", "bar.obj", "--session", "bar.json", "-o", "out.obj", "--pose", HOSTILE),
        ("deform", "bar.obj", "--session", "bar.json", "-o", "out.obj", f"--{HOSTILE}"),
        ("demo", "-o", f"{HOSTILE}/demo"),
        ("info", "x" * 5000 + ".obj"),
        ("info", "x" * 5000),
    ],
)
def test_a_hostile_name_is_one_line(
    bar: Path, capsys: pytest.CaptureFixture[str], words: tuple[str, ...]
) -> None:
    try:
        code: object = main(words)
    except SystemExit as end:
        code = end.code
    told = capsys.readouterr()
    assert (code, told.out) == (2, "")
    assert told.err.endswith("\n")
    assert told.err[:-1].isprintable()
    assert len(told.err) < 2 * MOST


def test_a_mesh_quotes_no_control_characters(bar: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write("m.obj", b"v 0 \x1b[2J\xff\x9b 0\nf 1 1 1\n")
    write("m.ply", b"ply\n\x1b[2J property\nelement \x1b[2J\nend_header\n")
    session("bar.json", **{"\x1b[2J\n": [1]})
    deform = ("deform", "bar.obj", "--session", "bar.json", "-o", "out.obj")
    for words in (("info", "m.obj"), ("info", "m.ply"), deform):
        assert main(words) == 2
        told = capsys.readouterr().err
        assert told[:-1].isprintable()


@pytest.mark.skipif(os.name == "nt", reason="its files have no such names")
def test_a_name_that_the_terminal_cannot_encode_does_no_harm(bar: Path) -> None:
    name = os.fsdecode(b"caf\xe9 \xe2\x82\xac.obj")
    Path("bar.obj").rename(name)
    done = _run("info", name, PYTHONIOENCODING="ascii")
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout.startswith(rb"caf\udce9 \u20ac.obj")
    done = _run("info", name[:-1], PYTHONIOENCODING="ascii")
    assert done.returncode == 2
    assert done.stderr.count(b"\n") == 1


@pytest.mark.skipif(os.name == "nt", reason="closed otherwise there")
@pytest.mark.parametrize("words", [("info", "bar.obj"), ("--help",), ("deform", "--help")])
def test_nobody_has_to_read_the_answer(bar: Path, words: tuple[str, ...]) -> None:
    ours, theirs = os.pipe()
    os.close(ours)
    done = subprocess.run(
        [sys.executable, "-P", "-m", "app", *words],
        env=_environment(),
        stdout=theirs,
        stderr=subprocess.PIPE,
        check=False,
        timeout=60,
    )
    os.close(theirs)
    assert (done.returncode, done.stderr) == (0, b"")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no disk that is always full")
def test_an_answer_that_cannot_be_written_is_one_line(bar: Path) -> None:
    with open("/dev/full", "wb") as full:
        done = subprocess.run(
            [sys.executable, "-P", "-m", "app", "info", "bar.obj"],
            env=_environment(),
            stdout=full,
            stderr=subprocess.PIPE,
            check=False,
            timeout=60,
        )
    assert done.returncode == 2
    assert done.stderr.count(b"\n") == 1


INTERRUPTED = """
import os, signal, sys, threading
signal.signal(signal.SIGINT, signal.default_int_handler)
moment = threading.Timer({seconds}, os.killpg, (os.getpgid(0), signal.SIGINT))
moment.daemon = True
moment.start()
from app.__main__ import main
sys.exit(main(sys.argv[1:]))
"""


@pytest.mark.skipif(os.name == "nt", reason="a console is interrupted in another way")
@pytest.mark.parametrize("seconds", [0.05, 0.3, 0.6, 0.9, 1.2])
@pytest.mark.parametrize("command", ["demo", "figures"])
def test_ctrl_c_ends_quietly_at_any_moment(bar: Path, command: str, seconds: float) -> None:
    Path("out").mkdir()
    done = subprocess.run(
        [sys.executable, "-P", "-c", INTERRUPTED.format(seconds=seconds), command, "-o", "out"],
        env=_environment(),
        capture_output=True,
        check=False,
        timeout=60,
        start_new_session=True,
    )
    # A shell shows both as 130; Python ends by the signal itself where that met a class being made.
    assert done.returncode in (130, -signal.SIGINT)
    assert done.stderr == b""


def test_ctrl_c_while_a_mesh_is_posed_ends_with_130(
    bar: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*arguments: object) -> None:
        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr("app.headless.check_memory", interrupted)
    assert main(["deform", "bar.obj", "--session", "bar.json", "-o", "out.obj"]) == 130
    assert capsys.readouterr() == ("", "")
    assert sorted(path.name for path in bar.iterdir()) == ["bar.json", "bar.obj"]


def _environment(**more: str) -> dict[str, str]:
    known = {k: v for k, v in os.environ.items() if not k.endswith("DISPLAY")}
    return known | {"PYTHONPATH": str(ROOT)} | more


def _run(*words: str, **environment: str) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(
        [sys.executable, "-P", "-m", "app", *words],
        env=_environment(**environment),
        capture_output=True,
        check=False,
        timeout=60,
    )
