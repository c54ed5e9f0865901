"""A virtual screen: Xvfb on a free display, its picture read from its framebuffer file."""

from __future__ import annotations

import os
import select
import struct
import subprocess
import zlib
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]

START_SECONDS = 20


class VirtualDisplay:
    """An Xvfb server with one 24-bit screen; `folder` holds its framebuffer and its log.

    pointer: whether its pictures show the mouse pointer, which the server draws some time later.
    """

    def __init__(
        self, folder: Path, width: int = 1600, height: int = 1000, pointer: bool = False
    ) -> None:
        self._framebuffer = folder / "Xvfb_screen0"
        screen = f"{width}x{height}x24"
        read_end, write_end = os.pipe()
        command = ["Xvfb", "-displayfd", str(write_end), "-screen", "0", screen]
        command += ["-fbdir", str(folder), "-nolisten", "tcp", "-noreset"]
        if not pointer:
            command.append("-nocursor")
        with (folder / "xvfb.log").open("wb") as log:
            self._server = subprocess.Popen(command, pass_fds=[write_end], stdout=log, stderr=log)
        os.close(write_end)
        with os.fdopen(read_end) as answer:
            ready, _, _ = select.select([answer], [], [], START_SECONDS)
            number = answer.readline().strip() if ready else ""
        if not number:
            self.stop()
            raise RuntimeError(f"Xvfb did not start: {(folder / 'xvfb.log').read_text()}")
        self.name = f":{number}"

    def picture(self) -> Picture:
        """What the screen shows, (height, width, 3), red, green, blue."""
        # XWD format: a big-endian header, a colour map, then rows of 4-byte pixels.
        data = self._framebuffer.read_bytes()
        header = struct.unpack(">25I", data[:100])
        width, height, little_endian, row = header[4], header[5], header[7] == 0, header[12]
        start = header[0] + 12 * header[19]
        rows = np.frombuffer(data, np.uint8, height * row, start).reshape(height, row)
        pixels = rows[:, : 4 * width].reshape(height, width, 4)
        return pixels[..., [2, 1, 0] if little_endian else [1, 2, 3]]

    def stop(self) -> None:
        self._server.terminate()
        self._server.wait()


def save_png(path: Path, picture: Picture) -> None:
    """Write an (h, w, 3) picture as a PNG file."""
    height, width, _ = picture.shape
    rows = np.zeros((height, 1 + 3 * width), np.uint8)  # each row begins with filter type 0
    rows[:, 1:] = picture.reshape(height, -1)
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    parts = [(b"IHDR", header), (b"IDAT", zlib.compress(rows.tobytes())), (b"IEND", b"")]
    chunks = [
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        for kind, body in parts
    ]
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(chunks))
