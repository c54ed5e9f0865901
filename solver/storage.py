"""Reading and writing whole files: a save never leaves half a file behind."""

from __future__ import annotations

import contextlib
import os
import platform
import re
import shutil
import stat
import uuid
import zlib
from collections.abc import Iterable
from pathlib import Path

from solver.errors import FileError

_TEMPORARY = re.compile(r"\.deform-[0-9a-f]{8}-([1-9][0-9]{0,9})-[0-9a-f]{32}\.tmp")
_BINARY = getattr(os, "O_BINARY", 0)  # Windows would translate line ends


def read_bytes(path: str | os.PathLike[str]) -> bytes:
    """Everything in the file. Raises FileError, in one line, where it cannot be read."""
    try:
        # Before it is opened: a pipe waits for its other end, and a device may have no end.
        kind = os.stat(path).st_mode
        if stat.S_ISREG(kind):
            return Path(path).read_bytes()
    except (OSError, ValueError) as error:
        raise FileError(f"{path}: cannot be read: {_reason(error)}") from error
    except MemoryError as error:
        raise FileError(f"{path}: cannot be read: it is larger than the memory") from error
    what = "a folder" if stat.S_ISDIR(kind) else "a pipe or a device"
    raise FileError(f"{path}: is {what}, expected a file")


def write_atomically(
    path: str | os.PathLike[str], data: bytes | bytearray | Iterable[bytes]
) -> None:
    """Write beside the target, flush to the disk, then replace, and flush the folder too.

    data: all of it, or piece by piece.
    A symbolic link is written through; an existing file keeps its permissions and its owner, and
    at no time is anything of it in a file that more people may read.
    Raises FileError and leaves the old file (and nothing else) where the new one cannot be written.
    """
    try:
        target = Path(os.path.realpath(path))
        _check_target(target)
        remove_orphans(target.parent)
        _replace(target, data)
    except (OSError, ValueError) as error:
        raise FileError(f"{path}: cannot be written: {_reason(error)}") from error


def _check_target(target: Path) -> None:
    if not target.parent.is_dir():
        raise FileNotFoundError(f"the folder {target.parent} does not exist")
    # Replacing a folder or a device such as /dev/null would destroy it.
    if target.exists() and not target.is_file():
        raise OSError("it is not a regular file")
    # A rename needs no right to write the old file, so a write-protected one is refused here.
    if target.exists() and not os.access(target, os.W_OK):
        raise PermissionError("it is write-protected")


def _replace(target: Path, data: bytes | bytearray | Iterable[bytes]) -> None:
    temporary = target.parent / f"{_prefix(os.getpid())}{uuid.uuid4().hex}.tmp"
    known = target.exists()
    try:
        mode = 0o600 if known else 0o666  # the latter as any new file: the umask takes its part
        number = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL | _BINARY, mode)
        with os.fdopen(number, "wb") as stream:
            stream.writelines([data] if isinstance(data, bytes | bytearray) else data)
            stream.flush()
            os.fsync(stream.fileno())
        if known:
            _keep_rights(target, temporary)
        os.replace(temporary, target)
        _flush_folder(target.parent)
    finally:
        with contextlib.suppress(OSError):
            temporary.unlink()


def _keep_rights(target: Path, temporary: Path) -> None:
    """Owner first: changing it may take rights away."""
    status = target.stat()
    if hasattr(os, "chown") and (status.st_uid, status.st_gid) != (os.getuid(), os.getgid()):
        with contextlib.suppress(OSError):
            os.chown(temporary, status.st_uid, status.st_gid)
    with contextlib.suppress(OSError):
        shutil.copymode(target, temporary)


def _flush_folder(folder: Path) -> None:
    """The new name is on the disk as well; not every system can be asked for that."""
    if os.name != "posix":
        return
    with contextlib.suppress(OSError):
        number = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(number)
        finally:
            os.close(number)


def _prefix(process: int) -> str:
    """Begins the names of a process's temporaries. Folders may be shared by several machines."""
    return f".deform-{zlib.crc32(platform.node().encode()):08x}-{process}-"


def remove_orphans(folder: Path) -> None:
    """Take away what processes of this machine left that ended in the middle of a save."""
    if os.name != "posix":
        return
    with contextlib.suppress(OSError):
        for name in os.listdir(folder):
            found = _TEMPORARY.fullmatch(name)
            if found and name.startswith(_prefix(int(found[1]))) and is_gone(int(found[1])):
                (folder / name).unlink(missing_ok=True)


def is_gone(process: int) -> bool:
    """Whether no process of this number runs; POSIX alone can be asked without harm."""
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return True
    except OSError:
        return False
    return False


def _reason(error: OSError | ValueError) -> str:
    """What went wrong, without the path that the caller already names."""
    return (isinstance(error, OSError) and error.strerror) or str(error)
