"""Films as files: each frame is written when it comes, and then forgotten. FILMS is the table."""

from __future__ import annotations

from fractions import Fraction
from importlib.util import find_spec
from pathlib import Path
from typing import Any, ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from solver.errors import SolverError

Picture = NDArray[np.uint8]  # (height, width, 3), red, green, blue

SHORTEST = (
    2  # hundredths of a second that a frame of a GIF lasts: viewers slow down what is shorter
)
CLOCK = 1000  # an MP4 counts milliseconds
QUALITY = {"crf": "20", "preset": "veryfast"}  # hardly told from the scene, in a few ms a frame


class PictureError(SolverError):
    """A picture or film cannot be made."""


class FilmFile(Protocol):
    """A file that is being written.

    widest: pixels; a larger scene is made smaller.  most: frames that a file should hold.
    """

    widest: ClassVar[int]
    most: ClassVar[int]

    def __init__(self, path: Path) -> None: ...

    def add(self, frame: Picture, start: float, end: float) -> None:
        """The next frame, always of one size, and the seconds from when to when it is seen."""

    def close(self) -> None:
        """End the file."""


class GifFile:
    """Runs for ever; each frame has the 256 colours that suit it best."""

    widest: ClassVar[int] = 640
    most: ClassVar[int] = 300  # of some 100 kB each

    def __init__(self, path: Path) -> None:
        check_library("PIL")
        self._file = path.open("wb")
        self._end = 0

    def add(self, frame: Picture, start: float, end: float) -> None:
        """The next frame."""
        from PIL import Image
        from PIL.GifImagePlugin import getdata, getheader

        image = Image.fromarray(frame).quantize(256, Image.Quantize.FASTOCTREE)
        if self._file.tell() == 0:
            self._file.writelines(getheader(image, info={"loop": 0})[0])
        # In hundredths of a second: rounded one by one, a film would be too fast.
        before, self._end = self._end, max(round(100 * end), self._end + SHORTEST)
        lasts = 10 * (self._end - before)
        self._file.writelines(getdata(image, duration=lasts, include_color_table=True))

    def close(self) -> None:
        """End the file."""
        with self._file:
            self._file.write(b";")


class Mp4File:
    """H.264 in the colours that every player expects."""

    widest: ClassVar[int] = 1920
    most: ClassVar[int] = 7200  # ten minutes

    def __init__(self, path: Path) -> None:
        check_library("av")
        import av

        self._container = av.open(str(path), "w", format="mp4", options={"movflags": "faststart"})
        self._stream: Any = None
        self._last: tuple[Any, float] | None = None

    def add(self, frame: Picture, start: float, end: float) -> None:
        """The next frame; an odd row or column at its rim is left out, as the format wants it."""
        import av

        height, width = (length // 2 * 2 for length in frame.shape[:2])
        if self._stream is None:
            self._stream = self._begin(width, height)
        even = np.ascontiguousarray(frame[:height, :width])
        image = av.VideoFrame.from_ndarray(even, format="rgb24")
        image = image.reformat(format="yuv420p", dst_colorspace="ITU709")
        self._put(image, start)
        self._last = image, end

    def close(self) -> None:
        """End the file."""
        with self._container:
            if self._last is not None:
                self._put(*self._last)  # else the last frame would be seen for no time at all
                self._container.mux(self._stream.encode(None))

    def _put(self, image: Any, start: float) -> None:
        image.time_base, image.pts = Fraction(1, CLOCK), round(CLOCK * start)
        self._container.mux(self._stream.encode(image))

    def _begin(self, width: int, height: int) -> Any:
        stream: Any = self._container.add_stream("libx264", rate=CLOCK, options=QUALITY)
        stream.width, stream.height, stream.pix_fmt = width, height, "yuv420p"
        stream.codec_context.time_base = Fraction(1, CLOCK)
        stream.codec_context.thread_count = 1  # the others are the solver's
        stream.codec_context.colorspace = 1  # BT.709, as `reformat` makes it
        stream.codec_context.color_primaries = stream.codec_context.color_trc = 1
        return stream


FILMS: dict[str, type[FilmFile]] = {".gif": GifFile, ".mp4": Mp4File}
LIBRARIES = {"PIL": ("pictures", "pillow"), "av": ("MP4 films", "av")}


def check_library(module: str) -> None:
    """Raise PictureError where one of LIBRARIES is missing, all of which are optional."""
    what, package = LIBRARIES[module]
    if find_spec(module) is None:
        raise PictureError(f"{what} need {package}: pip install {package}")
