"""What the commands do to the pose."""

from __future__ import annotations

from app.editor import commands as c
from app.editor.action import Actions
from app.model.handles import Pose
from app.workspace.workspace import Workspace


def reset_pose(work: Workspace, command: c.ResetPose) -> None:
    if work.document.pose.at_rest:
        return
    with work.edit("Reset pose") as gesture:
        gesture.change("pose", Pose())


POSE_ACTIONS: Actions = {
    c.ResetPose: reset_pose,
}
