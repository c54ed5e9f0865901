"""The measurement of speed: `python -m benchmarks [--sizes N ...] [-o FILE]`."""

from __future__ import annotations

from benchmarks.speed.__main__ import main

if __name__ == "__main__":
    main()
