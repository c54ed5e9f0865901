"""The kept poses: a row each, the slider between two of them, and what saves them all."""

from __future__ import annotations

from collections.abc import Callable

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.action import MOST_BETWEEN
from app.editor.editor import Editor
from app.model.poses import REST, REST_NAME, KeptPose
from app.telling import readable
from app.window.panel.widgets import REST_OF_LINE, halves, text_field
from app.window.scaling import scaled
from app.window.shortcuts import WindowAction

ROWS, HEIGHT = 3, 800.0  # more than these scroll in a window of this height
NAME_WIDTH = 216.0
BETWEEN_WIDTH = 36.0
SLIDE = "slide to blend"


def poses(editor: Editor, asked: list[c.Command]) -> None:
    """What is kept, and what can be done with it."""
    kept = editor.document.poses
    if psim.Button("Keep pose"):
        asked.append(c.KeepPose())
    psim.SetItemTooltip("Put where the handles are now into the list")
    psim.SameLine()
    if psim.Button("Add ..."):
        asked.append(WindowAction("add pose"))
    psim.SetItemTooltip(
        "Add a pose from a mesh with the same vertices: handles go where it has them"
    )
    if kept:
        _export(editor, asked)
        _rows(editor, asked)
        _blend(editor, asked)


def rest_menu(editor: Editor, asked: list[c.Command]) -> None:
    """A button whose menu makes the surface the rest shape, and goes back to the file's."""
    if psim.Button("Rest ..."):
        psim.OpenPopup("rest")
    psim.SetItemTooltip("What is the shape at rest")
    if psim.BeginPopup("rest"):
        for label, command, usable in (
            ("Make this the rest shape", c.MakeRest(), not editor.document.pose.at_rest),
            ("Back to the file's rest shape", c.RestoreRest(), editor.document.rest is not None),
        ):
            if psim.MenuItem(label, None, False, usable):
                asked.append(command)
        psim.EndPopup()


def _rows(editor: Editor, asked: list[c.Command]) -> None:
    kept, line = editor.document.poses, psim.GetFrameHeightWithSpacing()
    room = ROWS + max(int((psim.GetIO().DisplaySize[1] - scaled(HEIGHT)) / line), 0)
    psim.BeginChild("##poses", (0.0, min(len(kept), room) * line))
    for pose in kept:
        psim.PushID(str(pose.key))
        _row(editor, pose, asked)
        psim.PopID()
    psim.EndChild()


def _row(editor: Editor, kept: KeptPose, asked: list[c.Command]) -> None:
    """Go there, its name, and what else can be done with it."""
    if psim.RadioButton("##go", editor.document.pose == kept.pose):
        asked.append(c.GoToPose(kept.key))
    psim.SetItemTooltip("Go to this pose")
    psim.SameLine()
    psim.SetNextItemWidth(scaled(NAME_WIDTH))
    _, name = text_field("##pose", kept.name)
    # Once it is typed: on the way to its name it may be called like another.
    if psim.IsItemDeactivatedAfterEdit() and name != kept.name:
        asked.append(c.RenamePose(kept.key, name))
    psim.SameLine()
    if psim.Button("...", REST_OF_LINE):
        psim.OpenPopup("more")
    psim.SetItemTooltip("Replace, duplicate, move, delete")
    if psim.BeginPopup("more"):
        _menu(editor, kept, asked)
        psim.EndPopup()


def _menu(editor: Editor, kept: KeptPose, asked: list[c.Command]) -> None:
    place, last = editor.document.poses.index(kept), len(editor.document.poses) - 1
    for label, command, usable in (
        ("Replace by the pose of now", c.ReplacePose(kept.key), editor.document.pose != kept.pose),
        ("Duplicate", c.DuplicatePose(kept.key), True),
        ("Move up", c.MovePose(kept.key, -1), place > 0),
        ("Move down", c.MovePose(kept.key, 1), place < last),
        ("Delete", c.DeletePose(kept.key), True),
    ):
        if psim.MenuItem(label, None, False, usable):
            asked.append(command)


def _blend(editor: Editor, asked: list[c.Command]) -> None:
    """From which pose to which, and how far."""
    blend = editor.blend
    keys = [REST, *(kept.key for kept in editor.document.poses)]
    names = [REST_NAME, *(readable(kept.name) for kept in editor.document.poses)]
    # One that was deleted leads from or to the rest shape.
    start, end = (key if key in keys else REST for key in (blend.start, blend.end))
    ends: tuple[tuple[str, int, Callable[[int], c.Command], str], ...] = (
        ("##from", start, lambda key: c.ChooseBlend(start=key), "What the slider leads from"),
        ("##to", end, lambda key: c.ChooseBlend(end=key), "What the slider leads to"),
    )
    for label, (_, key, choose, tip) in zip(
        halves(*(label for label, *_ in ends)), ends, strict=True
    ):
        changed, index = psim.Combo(label, keys.index(key), names)
        psim.SetItemTooltip(tip)
        if changed:
            asked.append(choose(keys[index]))
    shown = blend.pose is not None and blend.pose == editor.document.pose
    psim.SetNextItemWidth(REST_OF_LINE[0])
    share = blend.share if shown else 0.0
    moved, share = psim.SliderFloat("##share", share, 0.0, 1.0, "%.3f" if shown else SLIDE)
    psim.SetItemTooltip("Every shape on the way is solved: handles move on screws")
    if moved:
        asked.append(c.BlendPoses(start, end, share))


def _export(editor: Editor, asked: list[c.Command]) -> None:
    """The button, and how many shapes it puts between one pose and the next."""
    if psim.Button("Export poses"):
        asked.append(WindowAction("export poses"))
    psim.SetItemTooltip(
        "The mesh as Export saves it, and all poses:\n"
        "morph targets of a GLB or glTF, else files beside it"
    )
    psim.SameLine()
    psim.SetNextItemWidth(scaled(BETWEEN_WIDTH))
    changed, between = psim.InputInt("between", editor.blend.between, 0)
    psim.SetItemTooltip("How many shapes an export has between one pose and the next")
    if changed:
        asked.append(c.ChooseBlend(between=min(max(between, 0), MOST_BETWEEN)))
