"""100 kill -9 at random moments: `python -m benchmarks.killing [COUNT]` (needs Xvfb).

The window while it saves, exports and keeps unsaved work, and the command line while it deforms.
Lost: what was said to be saved and is not, or unsaved work of longer than the pause between two
autosaves and two seconds, since drawing shares the machine. Damaged: a file that cannot be read, or
is not what was written.
"""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from app.unsaved.places import PLACE, kept_work
from benchmarks.killing.busy import TASKS
from benchmarks.tables import table
from solver import load_mesh
from solver.errors import SolverError
from tests.gui.display import VirtualDisplay

ROOT = Path(__file__).resolve().parents[2]
MESH = ROOT / "assets" / "mannequin.obj"
SESSION = ROOT / "assets" / "mannequin-elbow.json"
PAUSE = 0.2  # seconds between two autosaves
SLACK = 2.0
START, MOMENT = 60.0, 1.0  # seconds: a start at most, and the window's work before a kill at most


@dataclass
class Tally:
    """lost, damaged: how many there were; after: files that a kill left, until the next start."""

    kills: Counter[str] = field(default_factory=Counter)
    lost: Counter[str] = field(default_factory=Counter)
    damaged: Counter[str] = field(default_factory=Counter)
    after: Counter[str] = field(default_factory=Counter)
    oldest: float = 0.0

    def rows(self) -> list[list[str]]:
        counts = self.kills, self.lost, self.damaged, self.after
        return [[task, *(str(count[task]) for count in counts)] for task in self.kills]


class Killer:
    """Somebody who starts the program in a folder, and ends it without a word."""

    def __init__(self, display: VirtualDisplay, folder: Path) -> None:
        self.folder, self.tally = folder, Tally()
        self.mesh = folder / "figure.obj"
        self.mesh.write_bytes(MESH.read_bytes())
        (folder / "preferences").write_text(json.dumps({"dialogs": False, "autosave": PAUSE}))
        os.environ[PLACE] = str(folder / "state")
        self._environment = os.environ | {
            "DISPLAY": display.name,
            "SURFACE_DEFORMATION_PREFERENCES": str(folder / "preferences"),
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "PYTHONPATH": str(ROOT),
            "XDG_SESSION_TYPE": "x11",
        }
        self._log = folder / "log"
        self._out = folder / "out.obj"
        begun = time.monotonic()
        self.start_deform().wait()
        self._deform_seconds, self._whole = time.monotonic() - begun, self._out.read_bytes()

    def window(self, task: str) -> None:
        """Kill a window that is at it."""
        process = self.start_window(task)
        time.sleep(random.uniform(0.0, MOMENT))
        killed = time.time()
        process.kill()
        process.wait()
        done = [json.loads(line) for line in self._log.read_text().splitlines() if line[-1] == "]"]
        if task == "autosave":
            self._check_kept(done, killed)
        elif task == "save":
            self._check_session(done[-1][0])
        else:
            self._check_export()
        self._count(task)

    def deform(self) -> None:
        """Kill the command line somewhere in its work."""
        self._out.unlink(missing_ok=True)
        process = self.start_deform()
        time.sleep(random.uniform(0.0, 1.05) * self._deform_seconds)
        process.kill()
        process.wait()
        if self._out.exists() and self._out.read_bytes() != self._whole:
            self.tally.damaged["deform"] += 1
        self._count("deform")

    def start_window(self, task: str) -> subprocess.Popen[bytes]:
        """A window that has begun its task."""
        self._log.unlink(missing_ok=True)
        process = self._start("benchmarks.killing.busy", task, self._log, self.mesh)
        deadline = time.monotonic() + START
        while not (self._log.exists() and self._log.stat().st_size):
            assert time.monotonic() < deadline, "the window does not open"
            assert process.poll() is None, (self.folder / "output").read_text()
            time.sleep(0.02)
        return process

    def start_deform(self) -> subprocess.Popen[bytes]:
        """The command line at work."""
        return self._start("app", "deform", self.mesh, "--session", SESSION, "-o", self._out)

    def left(self) -> list[Path]:
        """What the program wrote for itself alone."""
        return [p for p in self.folder.rglob("*") if p.suffix in (".tmp", ".lock")]

    def _start(self, module: str, *words: object) -> subprocess.Popen[bytes]:
        command = [sys.executable, "-P", "-m", module, *map(str, words)]
        with (self.folder / "output").open("wb") as output:
            return subprocess.Popen(
                command, cwd=self.folder, env=self._environment, stdout=output, stderr=output
            )

    def _count(self, task: str) -> None:
        self.tally.kills[task] += 1
        self.tally.after[task] += len(self.left())
        if self.mesh.read_bytes() != MESH.read_bytes():
            self.tally.damaged[task] += 1

    def _check_session(self, number: int) -> None:
        try:
            session = json.loads(self.mesh.with_suffix(".json").read_text())
        except (OSError, ValueError):
            self.tally.damaged["save"] += 1
        else:
            self.tally.lost["save"] += int(session["handles"][0]["name"]) < number

    def _check_export(self) -> None:
        try:
            load_mesh(self.mesh.with_name("figure-deformed.obj"))
        except SolverError:
            self.tally.damaged["export"] += 1

    def _check_kept(self, done: list[tuple[int, float]], killed: float) -> None:
        """What the next start offers, which is then dismissed."""
        kept = kept_work()
        number = 0
        for one in kept:
            try:
                number = int(json.loads(one.path.read_text())["handles"][0]["name"])
            except ValueError:
                self.tally.damaged["autosave"] += 1
            one.dismiss()
        since = killed - next((at for n, at in done if n > number), killed)
        self.tally.oldest = max(self.tally.oldest, since)
        self.tally.lost["autosave"] += since > PAUSE + SLACK


def main(count: int) -> None:
    tasks = *TASKS, "deform"
    with tempfile.TemporaryDirectory() as name:
        display = VirtualDisplay(Path(name))
        try:
            (Path(name) / "work").mkdir()
            killer = Killer(display, Path(name) / "work")
            for number in range(count):
                task = tasks[number % len(tasks)]
                killer.deform() if task == "deform" else killer.window(task)
            last = killer.start_window("save")
            killer.start_deform().wait()
            last.terminate()
            last.wait()
            left = len(killer.left())
        finally:
            display.stop()
    tally = killer.tally
    print(table(["killed while it does", "kills", "lost", "damaged", "left behind"], tally.rows()))
    print(f"\nUnsaved work lost: the last {tally.oldest:.2f} s at most; kept every {PAUSE} s.")
    print(f"Temporaries and locks left after the next start: {left}.")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 100)
