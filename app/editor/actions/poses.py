"""What the commands do to the pose."""

from __future__ import annotations

from app.editor import commands as c
from app.editor.action import Actions, find_handle
from app.model.handles import Pose
from app.workspace.workspace import Workspace


def reset_pose(work: Workspace, command: c.ResetPose) -> None:
    if work.document.pose.at_rest:
        return
    with work.edit("Reset pose") as gesture:
        gesture.change("pose", Pose())


def reset_handle(work: Workspace, command: c.ResetHandle) -> None:
    handle = find_handle(work, command.key)
    with work.edit(f"Reset {handle.name}") as gesture:
        gesture.change("pose", work.document.pose.without(handle.key))


POSE_ACTIONS: Actions = {
    c.ResetPose: reset_pose,
    c.ResetHandle: reset_handle,
}
