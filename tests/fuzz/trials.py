"""One trial: something damaged or extreme through the program's own doors.

Whatever comes in is used, or refused by a SolverError of one line. A finding is all else: another
exception, a warning, what breaks a law, more than SECONDS or BYTES.
"""

from __future__ import annotations

import json
import shutil
import threading
import time
import traceback
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from random import Random
from typing import Any

import numpy as np
import psutil

from app.model.session.reading import read_session, to_document
from app.model.session.writing import write_session
from solver import Mesh, SolverError, load_mesh
from solver.mesh.formats.table import FORMATS
from solver.mesh.sizes import check_sizes
from solver.types import FloatArray
from tests.fuzz import corpus, surfaces
from tests.fuzz.mutator import damaged, damaged_json

Trial = Callable[[Random, Path], None]

SECONDS = 10.0
BYTES = 2 * 2**30
LONGEST_LINE = 2000


class Finding(AssertionError):
    """What should not have happened, in one line."""


def run(name: str, seed: int, folder: Path) -> bool:
    """The trial of this name and seed, in a folder of its own: whether the input was used.

    Raises Finding. What the trial has written stays in the folder.
    """
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    try:
        with warnings.catch_warnings(), _watched():
            warnings.simplefilter("error")
            TRIALS[name](Random(f"{name} {seed}"), folder)
    except SolverError as error:
        message = str(error)
        if len(message.splitlines()) != 1 or len(message) > LONGEST_LINE:
            raise Finding(f"{name} {seed}: no single line: {message[:200]!r}") from error
        return False
    except Finding as error:
        raise Finding(f"{name} {seed}: {error}") from error
    except Exception as error:
        place = traceback.extract_tb(error.__traceback__)[-1]
        where = f"{Path(place.filename).name}:{place.lineno}"
        raise Finding(f"{name} {seed}: {type(error).__name__} at {where}: {error}") from error
    return True


@contextmanager
def _watched() -> Iterator[None]:
    """Raises Finding at the end where it took too much time or memory."""
    process, over = psutil.Process(), threading.Event()
    start, most = time.monotonic(), process.memory_info().rss

    def look() -> None:
        nonlocal most
        while not over.wait(0.02):
            most = max(most, process.memory_info().rss)

    before = most
    watcher = threading.Thread(target=look, daemon=True)
    watcher.start()
    try:
        yield
    finally:
        over.set()
        watcher.join()
        took = time.monotonic() - start
        if took > SECONDS or most - before > BYTES:
            raise Finding(f"{took:.0f} s, {(most - before) / 2**20:.0f} MiB")


def _mesh_file(random: Random, folder: Path) -> None:
    """What is read can be saved in every format, and comes back from there."""
    name = random.choice(sorted(corpus.mesh_files()))
    data = corpus.mesh_files()[name]
    if corpus.is_json(name):
        data = damaged_json(random, data)
    elif name.endswith(".glb") and random.random() < 0.6:
        data = corpus.with_glb_json(data, damaged_json(random, corpus.glb_json(data)))
    else:
        data = damaged(random, data)
    path = folder / f"in{Path(name).suffix}"
    path.write_bytes(data)
    mesh = load_mesh(path)
    check_sizes(mesh.vertices, mesh.faces, str(path))  # as the window and the command line do
    for suffix in {path.suffix: 0, random.choice(sorted(FORMATS)): 0}:
        _round_trip(mesh, folder / f"out{suffix}", mesh.vertices * random.choice((1, 1.5)))


def _round_trip(mesh: Mesh, path: Path, X: FloatArray) -> None:
    mesh.save(path, X)
    try:
        again = load_mesh(path)
    except SolverError as error:
        raise Finding(f"saved, but then: {error}") from error
    if again.faces.shape != mesh.faces.shape:
        raise Finding(f"{path.suffix}: {mesh.faces.shape} saved, {again.faces.shape} read")
    size = np.abs(X).max()
    read, saved = again.outlines.corners, mesh.outlines.corners
    if len(read) != len(saved):  # of a format of triangles
        # Else polygons: one that has a corner twice may be cut into triangles in another way.
        read, saved = again.faces.ravel(), mesh.faces.ravel()
    if np.abs(again.vertices[read] - X[saved]).max() > 1e-5 * size:
        raise Finding(f"{path.suffix}: other positions come back")


def _session(random: Random, folder: Path) -> None:
    """A session that is read and fits comes back the same from what is written of it."""
    path, mesh = folder / "in.json", corpus.small_mesh()
    path.write_bytes(damaged_json(random, corpus.session_file()))
    document = to_document(read_session(path), mesh, folder / "mesh.obj")
    out = folder / "out.json"
    write_session(out, document)
    try:
        again = to_document(read_session(out), mesh, document.path)
    except SolverError as error:
        raise Finding(f"written, but then: {error}") from error
    write_session(folder / "again.json", again)
    if not _alike(json.loads(out.read_bytes()), json.loads((folder / "again.json").read_bytes())):
        raise Finding("another session comes back")


def _alike(a: Any, b: Any, exact: bool = True) -> bool:
    """Whether two sessions say the same; turns, which follow from transforms, but for rounding."""
    if isinstance(a, dict) and isinstance(b, dict):
        kept = {key: exact and key not in ("turn", "turns") for key in a}
        return a.keys() == b.keys() and all(_alike(a[k], b[k], kept[k]) for k in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(_alike(x, y, exact) for x, y in zip(a, b, strict=True))
    return bool(a == b if exact else abs(a - b) < 1e-6)


TRIALS: dict[str, Trial] = {
    "mesh file": _mesh_file,
    "session": _session,
    "solver": surfaces.deform,
}
