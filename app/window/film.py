"""Pictures of the scene, one or many: what is kept in memory, and the files it becomes.

Pillow writes them. It is optional: without it there are no pictures, and a line says so.
"""

from __future__ import annotations

import io
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from solver.errors import SolverError
from solver.storage import write_atomically

Picture = NDArray[np.uint8]  # (height, width, 3), red, green, blue

WIDEST = 640  # pixels of a film; a larger scene is made smaller
MOST_FRAMES = 300  # a film of that size takes some 250 MB
SHORTEST = 0.02  # seconds a frame lasts: viewers slow down what is shorter


class PictureError(SolverError):
    """A picture or film cannot be made."""


def check_pictures() -> None:
    """Raise PictureError where Pillow is missing."""
    if find_spec("PIL") is None:
        raise PictureError("pictures need Pillow: pip install pillow")


def save_picture(picture: Picture, path: Path) -> None:
    """As a PNG. Raises FileError."""
    from PIL import Image

    stream = io.BytesIO()
    Image.fromarray(picture).save(stream, "PNG")
    write_atomically(path, stream.getvalue())


class Film:
    """Frames of one size and when each was taken, up to as many as memory should hold."""

    def __init__(self) -> None:
        self._frames: list[Picture] = []
        self._times: list[float] = []

    @property
    def full(self) -> bool:
        """Whether no more frames are kept."""
        return len(self._frames) >= MOST_FRAMES

    @property
    def count(self) -> int:
        """Of the frames."""
        return len(self._frames)

    @property
    def seconds(self) -> float:
        """From the first frame to the last."""
        return self._times[-1] - self._times[0] if self._times else 0.0

    def add(self, picture: Picture, time: float) -> None:
        """A frame that was taken at so many seconds; another size than the first is left out."""
        step = -(-picture.shape[1] // WIDEST)
        frame = _smaller(picture, step)
        if not self.full and (not self._frames or frame.shape == self._frames[0].shape):
            self._frames.append(frame)
            self._times.append(time)

    def save(self, path: Path) -> None:
        """As a GIF that runs for ever, in the time it took. Raises FileError."""
        if self._frames:
            write_atomically(path, _gif(self._frames, self._durations()))

    def _durations(self) -> list[int]:
        """Milliseconds of each frame; the last one lasts as long as the one before it."""
        gaps = np.maximum(np.diff(self._times), SHORTEST)
        lasts = np.append(gaps, gaps[-1:] if len(gaps) else 1.0)
        # A GIF counts hundredths of a second: rounded one by one, a film would be too fast.
        ticks = np.diff(np.rint(100 * np.cumsum(lasts)), prepend=0)
        return [10 * int(tick) for tick in ticks]


def _smaller(picture: Picture, step: int) -> Picture:
    """The mean of blocks of step by step pixels."""
    if step == 1:
        return picture
    height, width = (length // step for length in picture.shape[:2])
    blocks = picture[: height * step, : width * step].reshape(height, step, width, step, 3)
    return np.asarray(blocks.mean(axis=(1, 3)).astype(np.uint8))


def _gif(frames: Sequence[Picture], durations: list[int]) -> bytes:
    from PIL import Image

    images = [Image.fromarray(frame).quantize(256, Image.Quantize.FASTOCTREE) for frame in frames]
    stream = io.BytesIO()
    images[0].save(
        stream, "GIF", save_all=True, append_images=images[1:], duration=durations, loop=0
    )
    return stream.getvalue()
