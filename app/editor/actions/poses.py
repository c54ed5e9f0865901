"""What the commands do to the pose and to the kept ones."""

from __future__ import annotations

from dataclasses import replace

from app.editor import commands as c
from app.editor.action import Actions, check_between, find_handle, given
from app.model.document import Document
from app.model.handles import Pose
from app.model.names import free_name
from app.model.poses import REST, REST_NAME, KeptPose, blended_pose
from app.model.settings import is_number
from app.workspace.workspace import Workspace


def reset_pose(work: Workspace, command: c.ResetPose) -> None:
    _take(work, Pose(), "Reset pose")


def keep_pose(work: Workspace, command: c.KeepPose) -> None:
    document = work.document
    kept = document.new_pose(document.pose, command.name.strip())
    _check_free(document, kept)
    add_pose(work, f"Keep {kept.name}", kept)


def add_pose(work: Workspace, label: str, kept: KeptPose) -> None:
    """Put one behind the kept ones; where the slider leads nowhere yet it leads there."""
    _list(work, label, (*work.document.poses, kept))
    if work.blend.end == REST:
        work.blend = replace(work.blend, end=kept.key, pose=None)


def replace_pose(work: Workspace, command: c.ReplacePose) -> None:
    kept = _kept(work, command.key)
    _put(work, f"Replace {kept.name}", kept, replace(kept, pose=work.document.pose))


def rename_pose(work: Workspace, command: c.RenamePose) -> None:
    kept, name = _kept(work, command.key), command.name.strip()
    if not name:
        raise c.CommandError("a pose's name must not be empty")
    renamed = replace(kept, name=name)
    _check_free(work.document, renamed)
    _put(work, f"Rename {kept.name}", kept, renamed)


def move_pose(work: Workspace, command: c.MovePose) -> None:
    kept, poses = _kept(work, command.key), list(work.document.poses)
    place = poses.index(kept)
    there = min(max(place + command.step, 0), len(poses) - 1)
    poses.insert(there, poses.pop(place))
    _list(work, f"Move {kept.name}", tuple(poses))


def duplicate_pose(work: Workspace, command: c.DuplicatePose) -> None:
    kept, poses = _kept(work, command.key), list(work.document.poses)
    name = free_name(kept.name, (other.name for other in poses), 2)
    copy = work.document.new_pose(kept.pose, name)
    poses.insert(poses.index(kept) + 1, copy)
    _list(work, f"Duplicate {kept.name}", tuple(poses))


def delete_pose(work: Workspace, command: c.DeletePose) -> None:
    kept = _kept(work, command.key)
    _list(work, f"Delete {kept.name}", tuple(p for p in work.document.poses if p is not kept))


def go_to_pose(work: Workspace, command: c.GoToPose) -> None:
    pose = _pose(work, command.key)
    name = REST_NAME if command.key == REST else _kept(work, command.key).name
    _take(work, pose, f"Go to {name}")


def blend_poses(work: Workspace, command: c.BlendPoses) -> None:
    ends = command.start, command.end
    start, end = (_pose(work, key) for key in ends)
    if not is_number(command.share):
        raise c.CommandError(f"the share of a blend must be a number, got {command.share!r}")
    share = min(max(float(command.share), 0.0), 1.0)
    pose = blended_pose(start, end, share, work.handle_centres)
    _take(work, pose, "Blend poses", merge=f"blend {ends}")
    work.blend = replace(
        work.blend, start=ends[0], end=ends[1], share=share, pose=work.document.pose
    )


def choose_blend(work: Workspace, command: c.ChooseBlend) -> None:
    changes = given(command)
    for name in {"start", "end"} & changes.keys():
        _pose(work, changes[name])
    if "between" in changes:
        changes["between"] = check_between(changes["between"])
    work.blend = replace(work.blend, **changes, pose=None)


def _take(work: Workspace, pose: Pose, label: str, merge: str = "") -> None:
    if pose != work.document.pose:
        with work.edit(label, merge) as gesture:
            gesture.change("pose", pose)


def _list(work: Workspace, label: str, poses: tuple[KeptPose, ...]) -> None:
    with work.edit(label) as gesture:
        gesture.change("poses", poses)


def _put(work: Workspace, label: str, kept: KeptPose, changed: KeptPose) -> None:
    _list(work, label, tuple(changed if p is kept else p for p in work.document.poses))


def _kept(work: Workspace, key: int) -> KeptPose:
    kept = next((kept for kept in work.document.poses if kept.key == key), None)
    if kept is None:
        raise c.CommandError(f"there is no kept pose with key {key!r}")
    return kept


def _pose(work: Workspace, key: int) -> Pose:
    return Pose() if key == REST else _kept(work, key).pose


def _check_free(document: Document, kept: KeptPose) -> None:
    if any(other.name == kept.name for other in document.poses if other.key != kept.key):
        raise c.CommandError(f"another pose is called {kept.name!r}, expected another name")


def reset_handle(work: Workspace, command: c.ResetHandle) -> None:
    handle = find_handle(work, command.key)
    with work.edit(f"Reset {handle.name}") as gesture:
        gesture.change("pose", work.document.pose.without(handle.key))


POSE_ACTIONS: Actions = {
    c.ResetPose: reset_pose,
    c.KeepPose: keep_pose,
    c.ReplacePose: replace_pose,
    c.RenamePose: rename_pose,
    c.MovePose: move_pose,
    c.DuplicatePose: duplicate_pose,
    c.DeletePose: delete_pose,
    c.GoToPose: go_to_pose,
    c.BlendPoses: blend_poses,
    c.ChooseBlend: choose_blend,
    c.ResetHandle: reset_handle,
}
