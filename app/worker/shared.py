"""Objects with large arrays, handed from one process to another through shared memory."""

from __future__ import annotations

import os
import pickle
import secrets
import weakref
from dataclasses import dataclass
from multiprocessing.shared_memory import SharedMemory
from typing import Any


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

    One side owns it, so that whatever becomes of the other side nothing is left behind.
    """

    def __init__(self) -> None:
        self._memory: SharedMemory | None = None

    def of_size(self, size: int) -> SharedMemory:
        """Memory of at least this many bytes: the same as before, or a new one."""
        if self._memory is None or self._memory.size < size:
            self.release()
            self._memory = _create(max(size, 1))
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
        return self._memory


def _create(size: int) -> SharedMemory:
    """New memory, whose name tells which process it belongs to."""
    while True:
        # Short: some systems allow 31 characters.
        name = f"deform-{os.getpid()}-{secrets.token_hex(4)}"
        try:
            return SharedMemory(name, create=True, size=size)
        except FileExistsError:
            continue


def _remove(memory: SharedMemory) -> None:
    memory.close()
    memory.unlink()
