"""What to do next, or what is missing before a drag is possible, in a line."""

from __future__ import annotations

from app.model.handles import FIRST_HANDLE, FIXED
from app.tools.table import TOOLS
from app.workspace.workspace import Workspace

TO_BEGIN = (
    f"Paint a handle ({TOOLS['handle'].key}), "
    f"or take the drag tool ({TOOLS['drag'].key}), click what stays and drag"
)
TO_DRAG = f"Take the drag tool ({TOOLS['drag'].key}), then press on a handle and drag"


def hint(work: Workspace, waits: bool) -> str:
    """waits: what is under way takes so long that a person should be told."""
    role = work.document.role
    if not (role >= FIRST_HANDLE).any():
        return TOOLS[work.tool].hint or TO_BEGIN
    if waits:
        return "Binding ..." if work.worker.binding else "Refining ..."
    if work.surface.bind_error:
        return work.surface.bind_error
    text = TOOLS[work.tool].hint or TO_DRAG
    if not (role == FIXED).any():
        return f"{text}; nothing is fixed"
    active, bound = work.active, work.surface.bound
    if active is not None and bound is not None and bound.is_loose(active.key):
        piece = work.document.mesh.pieces[work.document.vertices_of(active.key)[0]]
        text += f"; nothing holds {work.parts.name(int(piece))}, so it moves as a whole"
    return text
