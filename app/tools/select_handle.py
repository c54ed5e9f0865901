"""Ctrl+click: another handle to be placed together with those that are selected, or one less."""

from __future__ import annotations

from app.pointing.picking import Hit
from app.tools.tool import on_surface
from app.viewpoint.events import Input
from app.workspace.interaction import HeldPress, Interaction
from app.workspace.workspace import Workspace


@on_surface
def begin_select(work: Workspace, press: Input, hit: Hit) -> Interaction | None:
    """With Ctrl, the handle under the cursor joins or leaves the selection."""
    handle = work.document.find(int(work.document.role[hit.vertex]))
    if handle is None or not press.ctrl:
        return None
    work.chosen.select(handle.key)
    return HeldPress()
