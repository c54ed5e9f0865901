"""What a person can ask for, as data; the actions do it. A file for each subject, as there."""

from app.editor.commands.choices import SetBrush, SetKeep, SetMap, SetTool, SetTurn
from app.editor.commands.command import Command, CommandError
from app.editor.commands.files import Export, OpenMesh, OpenSession, SaveSession
from app.editor.commands.history import CancelGesture, Redo, Undo
from app.editor.commands.parts import SetFollows, ShowPart
from app.editor.commands.poses import (
    BlendPoses,
    ChooseBlend,
    DeletePose,
    DuplicatePose,
    ExportPoses,
    GoToPose,
    KeepPose,
    MakeRest,
    MovePose,
    RenamePose,
    ReplacePose,
    ResetPose,
    RestoreRest,
)
from app.editor.commands.regions import (
    ActivateHandle,
    AddHandle,
    ClearFixed,
    ClearHandle,
    RemoveHandle,
    RenameHandle,
)
from app.editor.commands.settings import SetMaterial, SetSetting
from app.editor.commands.softness import ClearPins, ClearSoftness, FillSoftness, SmoothSoftness
from app.editor.commands.symmetry import MirrorPose, MirrorRegions, SetSymmetry, ToggleSymmetry
from app.editor.commands.view import FrameSelected, FrameVertices, SetLooks, SetUp, ViewFrom

__all__ = [
    "ActivateHandle",
    "AddHandle",
    "BlendPoses",
    "CancelGesture",
    "ChooseBlend",
    "ClearFixed",
    "ClearHandle",
    "ClearPins",
    "ClearSoftness",
    "Command",
    "CommandError",
    "DeletePose",
    "DuplicatePose",
    "Export",
    "ExportPoses",
    "FillSoftness",
    "FrameSelected",
    "FrameVertices",
    "GoToPose",
    "KeepPose",
    "MakeRest",
    "MirrorPose",
    "MirrorRegions",
    "MovePose",
    "OpenMesh",
    "OpenSession",
    "Redo",
    "RemoveHandle",
    "RenameHandle",
    "RenamePose",
    "ReplacePose",
    "ResetPose",
    "RestoreRest",
    "SaveSession",
    "SetBrush",
    "SetFollows",
    "SetKeep",
    "SetLooks",
    "SetMap",
    "SetMaterial",
    "SetSetting",
    "SetSymmetry",
    "SetTool",
    "SetTurn",
    "SetUp",
    "ShowPart",
    "SmoothSoftness",
    "ToggleSymmetry",
    "Undo",
    "ViewFrom",
]
