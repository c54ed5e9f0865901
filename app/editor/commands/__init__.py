"""What a person can ask for, as data; the actions do it. A file for each subject, as there."""

from app.editor.commands.choices import SetBrush, SetKeep, SetMap, SetMarking, SetTool, SetTurn
from app.editor.commands.command import Command, CommandError
from app.editor.commands.files import Export, OpenMesh, OpenSession, SaveSession
from app.editor.commands.history import CancelGesture, Redo, Undo
from app.editor.commands.marks import ChangeMarks, FindLimbs
from app.editor.commands.parts import SetFollows, ShowPart
from app.editor.commands.placing import (
    MoveHandles,
    PickPivot,
    SetPlacing,
    SetPosition,
    SetRotation,
    TurnHandles,
)
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
    ResetHandle,
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
    SelectHandle,
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
    "ChangeMarks",
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
    "FindLimbs",
    "FrameSelected",
    "FrameVertices",
    "GoToPose",
    "KeepPose",
    "MakeRest",
    "MirrorPose",
    "MirrorRegions",
    "MoveHandles",
    "MovePose",
    "OpenMesh",
    "OpenSession",
    "PickPivot",
    "Redo",
    "RemoveHandle",
    "RenameHandle",
    "RenamePose",
    "ReplacePose",
    "ResetHandle",
    "ResetPose",
    "RestoreRest",
    "SaveSession",
    "SelectHandle",
    "SetBrush",
    "SetFollows",
    "SetKeep",
    "SetLooks",
    "SetMap",
    "SetMarking",
    "SetMaterial",
    "SetPlacing",
    "SetPosition",
    "SetRotation",
    "SetSetting",
    "SetSymmetry",
    "SetTool",
    "SetTurn",
    "SetUp",
    "ShowPart",
    "SmoothSoftness",
    "ToggleSymmetry",
    "TurnHandles",
    "Undo",
    "ViewFrom",
]
