"""The long run: `python -m tests.fuzz [MINUTES]`, an hour by default; one trial again by its name
and seed: `python -m tests.fuzz "mesh file" 17`. Findings and their files stay in build/fuzz."""

from __future__ import annotations

import faulthandler
import os
import shutil
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

from benchmarks.tables import table
from tests.fuzz.trials import TRIALS, Finding, run

BUILD = Path(__file__).resolve().parents[2] / "build" / "fuzz"
STUCK = 120  # seconds: then the run ends, and tells where it stands


def main(words: list[str]) -> int:
    """0, or 1 where something was found."""
    folder = Path(tempfile.mkdtemp())
    try:
        if len(words) == 2:
            print("used" if run(words[0], int(words[1]), folder) else "refused")
            return 0
        return _long_run(float(words[0]) if words else 60.0, folder / "trial")
    finally:
        shutil.rmtree(folder)


def _long_run(minutes: float, folder: Path) -> int:
    first, start = int.from_bytes(os.urandom(3)) * 1000, time.monotonic()
    used, refused, found = Counter[str](), Counter[str](), Counter[str]()
    seed = first
    while time.monotonic() - start < 60 * minutes:
        for name in TRIALS:
            faulthandler.dump_traceback_later(STUCK, exit=True)
            try:
                (used if run(name, seed, folder) else refused)[name] += 1
            except Finding as finding:
                found[name] += 1
                print(finding, flush=True)
                kept = BUILD / f"{name.replace(' ', '-')}-{seed}"
                shutil.copytree(folder, kept, dirs_exist_ok=True)
        seed += 1
    faulthandler.cancel_dump_traceback_later()
    print(f"{minutes:g} minutes, seeds {first} to {seed - 1}\n")
    rows = [[name, *(str(tally[name]) for tally in (used, refused, found))] for name in TRIALS]
    print(table(["trial", "used", "refused", "findings"], rows))
    return bool(found.total())


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
