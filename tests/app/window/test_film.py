"""Pictures and films as files; needs no graphics library."""

from __future__ import annotations

import time
from itertools import pairwise
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import pytest

from app.window.films.files import FILMS, GifFile, Mp4File, Picture, PictureError
from app.window.films.film import WAITING, Film, default_film_path, save_picture

Image = pytest.importorskip("PIL.Image")
av = pytest.importorskip("av")
SHADES = (0, 85, 170, 255)
TIMES = (5.0, 5.1, 5.133, 5.4)
SUFFIXES = sorted(FILMS)


def shade(value: int, height: int = 30, width: int = 40) -> Picture:
    return np.full((height, width, 3), value, np.uint8)


def filmed(path: Path, pictures: list[Picture], times: tuple[float, ...] = TIMES) -> Film:
    film = Film(path)
    for picture, at in zip(pictures, times, strict=True):
        film.add(picture, at)
    film.end()
    film.wait()
    return film


def seen(path: Path) -> tuple[list[Picture], list[float]]:
    """The frames of a film, and the seconds that each lasts."""
    if path.suffix == ".mp4":
        with av.open(str(path)) as container:
            frames = list(container.decode(container.streams.video[0]))
            starts = [frame.time for frame in frames]
            pictures = [frame.to_ndarray(format="rgb24") for frame in frames]
            # The last one is there once more, where it ends.
            assert np.array_equal(pictures[-1], pictures[-2])
        return pictures[:-1], list(np.diff(starts))
    pictures, durations = [], []
    with Image.open(path) as image:
        assert image.info["loop"] == 0, "for ever"
        for number in range(image.n_frames):
            image.seek(number)
            pictures.append(np.asarray(image.convert("RGB")))
            durations.append(image.info["duration"] / 1000)
    return pictures, durations


def test_a_picture_is_kept_as_it_is(tmp_path: Path) -> None:
    picture = np.random.default_rng(0).integers(0, 256, (7, 5, 3)).astype(np.uint8)
    save_picture(picture, tmp_path / "a.png")
    with Image.open(tmp_path / "a.png") as image:
        np.testing.assert_array_equal(np.asarray(image), picture)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_film_shows_its_frames_in_the_time_they_took(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"a{suffix}"
    film = Film(path)
    for value, at in zip(SHADES, TIMES, strict=True):
        film.add(shade(value), at)
    film.add(shade(9, 31), 6.0)  # the window was made larger: no frame of this film
    assert (film.count, film.full) == (4, False)
    assert film.seconds == pytest.approx(0.4)
    film.end()
    film.wait()
    assert film.saved == (f"Saved {path}", True)
    pictures, lasts = seen(path)
    for picture, value in zip(pictures, SHADES, strict=True):
        assert picture.shape == (30, 40, 3)
        assert np.abs(picture.astype(int) - value).max() < 12
    assert lasts == pytest.approx([*np.diff(TIMES), TIMES[-1] - TIMES[-2]], abs=0.0101)
    assert sum(lasts[:3]) == pytest.approx(TIMES[-1] - TIMES[0], abs=0.0101)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_colours_are_those_of_the_scene(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"a{suffix}"
    colors = [(178, 60, 60), (60, 178, 178), (30, 200, 60), (233, 233, 238)]
    filmed(path, [np.full((40, 60, 3), color, np.uint8) for color in colors])
    for picture, color in zip(seen(path)[0], colors, strict=True):
        assert np.abs(picture.astype(int) - color).max() < 9


def test_a_large_scene_becomes_smaller_and_odd_rims_are_left_out(tmp_path: Path) -> None:
    wide = shade(0, 303, 3 * GifFile.widest)
    wide[:, ::2] = 200
    filmed(tmp_path / "a.gif", [wide], (0.0,))
    (frame,), lasts = seen(tmp_path / "a.gif")
    assert (frame.shape, lasts) == ((101, GifFile.widest, 3), [1.0])
    assert 60 < frame.mean() < 140
    filmed(tmp_path / "a.mp4", [shade(0, 301, 403)], (0.0,))
    (frame,), lasts = seen(tmp_path / "a.mp4")
    assert (frame.shape, lasts) == ((300, 402, 3), [1.0])


class Slow:
    """Holds what it was given, and waits until it is told to go on."""

    widest: ClassVar[int] = 640
    most: ClassVar[int] = 20
    held: ClassVar[list[Picture]]
    waits: ClassVar[bool]

    def __init__(self, path: Path) -> None:
        self.path = path
        Slow.held = []
        Slow.waits = True

    def add(self, frame: Picture, start: float, end: float) -> None:
        Slow.held.append(frame)
        while Slow.waits:
            time.sleep(0.001)

    def close(self) -> None:
        self.path.write_bytes(bytes(len(Slow.held)))


def test_frames_do_not_pile_up_while_they_wait_to_be_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(FILMS, ".gif", Slow)
    film = Film(tmp_path / "a.gif")
    number = 0
    while film.ready or len(Slow.held) == 0:
        if film.ready:
            film.add(shade(number), float(number))
            number += 1
    assert WAITING <= number <= WAITING + 3
    Slow.waits = False
    while not film.full:
        film.add(shade(0), float(number))
        number += 1
    assert number == Slow.most
    film.add(shade(0), 99.0)
    film.end()
    film.wait()
    assert (tmp_path / "a.gif").stat().st_size == Slow.most


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_nothing_recorded_is_no_file(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"a{suffix}"
    film = filmed(path, [], ())
    assert film.saved == (f"{path}: no film was saved: nothing was recorded", False)
    assert not any(tmp_path.iterdir())


@pytest.fixture
def spool(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where films are while they are written."""
    folder = tmp_path / "spool"
    folder.mkdir()
    monkeypatch.setattr("tempfile.tempdir", str(folder))
    return folder


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_film_that_cannot_go_where_it_should_is_kept(
    tmp_path: Path, spool: Path, suffix: str
) -> None:
    folder = tmp_path / "gone"
    folder.mkdir()
    film = Film(folder / f"a{suffix}")
    film.add(shade(50), 0.0)
    folder.rmdir()
    film.end()
    film.wait()
    (kept,) = spool.iterdir()
    assert film.saved is not None
    text, well = film.saved
    assert not well
    assert text.endswith(f"; the film is kept in {kept}")
    assert "cannot be written" in text
    assert len(text.splitlines()) == 1
    assert np.abs(seen(kept)[0][0].astype(int) - 50).max() < 12


@pytest.mark.parametrize(("suffix", "kind"), [(".gif", GifFile), (".mp4", Mp4File)])
def test_what_was_written_before_a_fault_is_saved(
    tmp_path: Path, spool: Path, monkeypatch: pytest.MonkeyPatch, suffix: str, kind: Any
) -> None:
    add = kind.add

    def full_disk(self: Any, frame: Picture, start: float, end: float) -> None:
        if start > 2:
            raise OSError(28, "No space left on device")
        add(self, frame, start, end)

    monkeypatch.setattr(kind, "add", full_disk)
    path = tmp_path / f"a{suffix}"
    film = filmed(path, [shade(v) for v in range(0, 200, 10)], tuple(map(float, range(20))))
    assert film.saved is not None
    assert film.saved[0].startswith(f"Saved {path}, which ends too early: ")
    assert film.saved[0].endswith("No space left on device")
    assert (film.saved[1], len(seen(path)[0])) == (False, 3)
    assert not any(spool.iterdir())


@pytest.mark.parametrize(("suffix", "kind"), [(".gif", GifFile), (".mp4", Mp4File)])
def test_a_film_that_cannot_be_ended_replaces_nothing(
    tmp_path: Path, spool: Path, monkeypatch: pytest.MonkeyPatch, suffix: str, kind: Any
) -> None:
    close = kind.close

    def full_disk(self: Any) -> None:
        close(self)
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(kind, "close", full_disk)
    path = tmp_path / f"a{suffix}"
    path.write_bytes(b"another")
    film = filmed(path, [shade(v) for v in range(4)])
    expected = f"{path}: no film was saved: [Errno 28] No space left on device"
    assert film.saved == (expected, False)
    assert path.read_bytes() == b"another"
    assert not any(spool.iterdir())


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("a.avi", "a film is one of .gif, .mp4"),
        ("a", "a film is one of .gif, .mp4"),
        ("no/a.gif", "its folder is not there or cannot be written to"),
    ],
)
def test_where_no_film_can_be(tmp_path: Path, spool: Path, name: str, words: str) -> None:
    with pytest.raises(PictureError) as caught:
        Film(tmp_path / name)
    assert str(caught.value) == f"{tmp_path / name}: {words}"
    assert not any(spool.iterdir())


def test_the_suffix_is_understood_in_capitals(tmp_path: Path) -> None:
    film = filmed(tmp_path / "A.MP4", [shade(7)] * 4)
    assert film.saved == (f"Saved {tmp_path / 'A.MP4'}", True)
    with av.open(str(tmp_path / "A.MP4")) as container:
        assert container.streams.video[0].codec_context.name == "h264"


def test_without_a_library_it_says_what_to_do(
    tmp_path: Path, spool: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mesh = tmp_path / "m.obj"
    assert default_film_path(mesh, "film") == tmp_path / "m-film.mp4"
    monkeypatch.setattr("app.window.films.files.find_spec", lambda name: None)
    monkeypatch.setattr("app.window.films.film.find_spec", lambda name: None)
    assert default_film_path(mesh, "film") == tmp_path / "m-film.gif"
    with pytest.raises(PictureError, match="pictures need pillow: pip install pillow"):
        save_picture(shade(0), tmp_path / "a.png")
    for suffix, package in ((".gif", "pillow"), (".mp4", "av")):
        with pytest.raises(PictureError, match=f"pip install {package}"):
            Film(tmp_path / f"a{suffix}")
    assert not any(spool.iterdir())


def test_times_only_grow(tmp_path: Path) -> None:
    """Frames a viewer could not tell apart in time still follow each other."""
    times = tuple(0.001 * k for k in range(12))
    for suffix in SUFFIXES:
        filmed(tmp_path / f"a{suffix}", [shade(20 * k) for k in range(12)], times)
        pictures, lasts = seen(tmp_path / f"a{suffix}")
        assert len(pictures) == 12
        assert min(lasts) > 0
        assert all(a.mean() < b.mean() for a, b in pairwise(pictures))


def test_where_it_is_is_said_from_the_root_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    film = filmed(Path("a.gif"), [shade(value) for value in SHADES])
    monkeypatch.chdir(tmp_path.parent)
    assert film.saved == (f"Saved {tmp_path / 'a.gif'}", True)
