"""Objects with large arrays, handed from one process to another through shared memory."""

from __future__ import annotations

import contextlib
import errno
import os
import pickle
import secrets
import weakref
from dataclasses import dataclass
from multiprocessing.shared_memory import SharedMemory
from pathlib import Path
from typing import Any

from solver.storage import is_gone

FOLDER = Path("/dev/shm")  # where Linux has it
PREFIX = "deform-"


@dataclass(frozen=True)
class Parcel:
    """A pickled object without the contents of its arrays.

    spans: where those lie in the memory, (offset, bytes) each; None: `data` holds them too.
    """

    data: bytes
    spans: tuple[tuple[int, int], ...] | None


class Packed:
    """An object taken apart: what a message carries, and the bytes of its arrays, uncopied."""

    def __init__(self, content: Any) -> None:
        self._content = content
        buffers: list[pickle.PickleBuffer] = []
        self._data = pickle.dumps(content, protocol=5, buffer_callback=buffers.append)
        self._arrays = [buffer.raw() for buffer in buffers]

    @property
    def size(self) -> int:
        """Bytes of all arrays together."""
        return sum(array.nbytes for array in self._arrays)

    def put(self, memory: SharedMemory) -> Parcel:
        """Copy the arrays into the memory, if it has the room, over whatever was there."""
        if self.size > memory.size:
            return Parcel(pickle.dumps(self._content, protocol=5), None)
        assert memory.buf is not None
        spans, offset = [], 0
        for array in self._arrays:
            memory.buf[offset : offset + array.nbytes] = array
            spans.append((offset, array.nbytes))
            offset += array.nbytes
        return Parcel(self._data, tuple(spans))


def unpack(parcel: Parcel, memory: SharedMemory) -> Any:
    """The object again, with arrays of its own: the memory may be written over."""
    if parcel.spans is None:
        return pickle.loads(parcel.data)
    assert memory.buf is not None
    arrays = [bytearray(memory.buf[start : start + size]) for start, size in parcel.spans]
    return pickle.loads(parcel.data, buffers=arrays)


class Block:
    """Shared memory that grows as needed and is gone with its owner.

    One side owns it, and the other takes its name away as soon as it has it: whatever becomes of
    either side, even of both at once, nothing is left behind.
    """

    def __init__(self) -> None:
        self._memory: SharedMemory | None = None

    def of_size(self, size: int) -> SharedMemory:
        """Memory of this many bytes, the same as before or a new one; less where there is less.

        What does not fit goes another way, see Packed.put.
        """
        if self._memory is None or self._memory.size < size:
            self.release()
            self._memory = _create(max(size, 1)) or _create(1)
            if self._memory is None:
                raise OSError(errno.ENOSPC, "there is no shared memory")
            # also when nobody calls `release`, and at the end of the program
            self._end = weakref.finalize(self, _remove, self._memory)
        return self._memory

    @property
    def memory(self) -> SharedMemory:
        """What `of_size` returned last."""
        assert self._memory is not None
        return self._memory

    def release(self) -> None:
        """Give the memory back to the system."""
        if self._memory is not None:
            self._end()
            self._memory = None


class Guest:
    """The other side: attaches to whichever block the owner names."""

    def __init__(self) -> None:
        self._memory: SharedMemory | None = None

    def attach(self, name: str) -> SharedMemory:
        """The memory of this name."""
        if self._memory is None or self._memory.name != name:
            if self._memory is not None:
                self._memory.close()
            self._memory = SharedMemory(name)
            self._memory.unlink()
        return self._memory


def _create(size: int) -> SharedMemory | None:
    """New memory, whose name tells which process it belongs to; None where there is not as much."""
    _remove_orphans()
    while True:
        # Short: some systems allow 31 characters.
        name = f"{PREFIX}{os.getpid()}-{secrets.token_hex(4)}"
        try:
            memory = SharedMemory(name, create=True, size=size)
        except FileExistsError:
            continue
        if _reserve(name, size):
            return memory
        _remove(memory)
        return None


def _reserve(name: str, size: int) -> bool:
    """Have the system set all of it aside: a container's shared memory may be smaller than what it
    promises, and writing to what is not there would end the program."""
    if not FOLDER.is_dir():
        return True
    number = os.open(FOLDER / name, os.O_RDWR)
    try:
        os.posix_fallocate(number, 0, size)
    except OSError:
        return False
    finally:
        os.close(number)
    return True


def _remove_orphans() -> None:
    """What programs left that were killed before their solver had taken the name away."""
    if not FOLDER.is_dir():
        return
    for path in FOLDER.glob(f"{PREFIX}*"):
        owner = path.name.removeprefix(PREFIX).partition("-")[0]
        if owner.isdecimal() and is_gone(int(owner)):
            with contextlib.suppress(OSError):
                path.unlink()


def _remove(memory: SharedMemory) -> None:
    memory.close()
    with contextlib.suppress(FileNotFoundError):  # the other side has done it already
        memory.unlink()
