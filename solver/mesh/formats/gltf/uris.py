"""URIs of a glTF file: data inside the JSON, or files beside it."""

from __future__ import annotations

import base64
import binascii
from pathlib import Path
from urllib.parse import unquote, unquote_to_bytes, urlsplit

_BINARY = "application/octet-stream"


def is_data(uri: str) -> bool:
    """Whether the URI holds its data itself."""
    return uri[:5].lower() == "data:"


def data_uri(data: bytes, mime: str = _BINARY) -> str:
    """The data as a URI."""
    return f"data:{mime};base64,{base64.b64encode(data).decode()}"


def read_uri(uri: str, folder: Path) -> bytes:
    """What a URI names, relative to a folder. Raises ValueError saying why it cannot be read."""
    if is_data(uri):
        return _decoded(uri)
    path = local_path(uri, folder)
    if path is None:
        raise ValueError(f"{uri[:60]!r} is not a path relative to the file")
    try:
        # A device or a pipe might never end.
        if not path.is_file():
            raise ValueError(f"there is no file {uri[:200]!r} beside it")
        return path.read_bytes()
    except MemoryError as error:
        raise ValueError(f"{uri[:200]!r} is larger than the memory") from error
    except OSError as error:
        raise ValueError(f"{uri[:200]!r} cannot be read: {error.strerror}") from error


def local_path(uri: str, folder: Path) -> Path | None:
    """The file that a relative URI names, None for any other URI."""
    parts = urlsplit(uri)
    if parts.scheme or parts.netloc or uri.startswith("/"):
        return None
    # Some exporters leave '#' and '?' as they are, so the whole text is the path.
    return folder / unquote(uri)


def _decoded(uri: str) -> bytes:
    head, comma, body = uri.partition(",")
    if not comma:
        raise ValueError("the data URI has no comma")
    if not head.endswith(";base64"):
        return unquote_to_bytes(body)
    try:
        # Some exporters leave the padding out.
        return binascii.a2b_base64(unquote(body) + "==")
    except (ValueError, binascii.Error) as error:
        raise ValueError("the data URI is not base64") from error
