"""Pictures and films as files; needs no graphics library."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.window.film import (
    MOST_FRAMES,
    WIDEST,
    Film,
    Picture,
    PictureError,
    check_pictures,
    save_picture,
)

Image = pytest.importorskip("PIL.Image")
SHADES = (0, 85, 170, 255)


def shade(value: int, height: int = 30, width: int = 40) -> Picture:
    return np.full((height, width, 3), value, np.uint8)


def test_a_picture_is_kept_as_it_is(tmp_path: Path) -> None:
    picture = np.random.default_rng(0).integers(0, 256, (7, 5, 3)).astype(np.uint8)
    save_picture(picture, tmp_path / "a.png")
    with Image.open(tmp_path / "a.png") as image:
        np.testing.assert_array_equal(np.asarray(image), picture)


def test_a_film_shows_its_frames_in_the_time_they_took(tmp_path: Path) -> None:
    film = Film()
    times = (5.0, 5.1, 5.133, 5.4)
    for value, time in zip(SHADES, times, strict=True):
        film.add(shade(value), time)
    film.add(shade(9, 31), 6.0)  # the window was made larger: no frame of this film
    assert film.count == 4
    film.save(tmp_path / "a.gif")
    with Image.open(tmp_path / "a.gif") as image:
        assert (image.n_frames, image.size, image.info["loop"]) == (4, (40, 30), 0)
        durations = []
        for number, value in enumerate(SHADES):
            image.seek(number)
            durations.append(image.info["duration"])
            assert np.abs(np.asarray(image.convert("RGB")).astype(int) - value).max() < 12
    assert sum(durations[:3]) == pytest.approx(1000 * (times[-1] - times[0]), abs=10)
    assert durations[:3] == pytest.approx(1000 * np.diff(times), abs=10)


def test_a_film_is_bounded_in_size_and_number() -> None:
    film = Film()
    wide = shade(0, 300, 3 * WIDEST)
    wide[:, ::2] = 200
    for time in range(MOST_FRAMES + 5):
        assert film.full == (time >= MOST_FRAMES)
        film.add(wide, float(time))
    assert film.count == MOST_FRAMES
    assert film.seconds == MOST_FRAMES - 1


def test_nothing_recorded_is_no_file(tmp_path: Path) -> None:
    Film().save(tmp_path / "a.gif")
    assert not any(tmp_path.iterdir())


def test_without_pillow_it_says_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    check_pictures()
    monkeypatch.setattr("app.window.film.find_spec", lambda name: None)
    with pytest.raises(PictureError, match="pip install pillow"):
        check_pictures()
