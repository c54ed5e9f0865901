"""What a person can ask for, as data; the actions do it. A file for each subject, as there."""

from app.editor.commands.choices import SetBrush, SetMap, SetTool, SetTurn
from app.editor.commands.command import Command, CommandError
from app.editor.commands.files import Export, OpenMesh, OpenSession, SaveSession
from app.editor.commands.history import CancelGesture, Redo, Undo
from app.editor.commands.parts import SetFollows, ShowPart
from app.editor.commands.placing import (
    MoveHandles,
    PickPivot,
    SetPlacing,
    SetPosition,
    SetRotation,
    TurnHandles,
)
from app.editor.commands.poses import ResetHandle, ResetPose
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
from app.editor.commands.view import FrameSelected, SetUp, ViewFrom

__all__ = [
    "ActivateHandle",
    "AddHandle",
    "CancelGesture",
    "ClearFixed",
    "ClearHandle",
    "ClearPins",
    "ClearSoftness",
    "Command",
    "CommandError",
    "Export",
    "FillSoftness",
    "FrameSelected",
    "MoveHandles",
    "OpenMesh",
    "OpenSession",
    "PickPivot",
    "Redo",
    "RemoveHandle",
    "RenameHandle",
    "ResetHandle",
    "ResetPose",
    "SaveSession",
    "SelectHandle",
    "SetBrush",
    "SetFollows",
    "SetMap",
    "SetMaterial",
    "SetPlacing",
    "SetPosition",
    "SetRotation",
    "SetSetting",
    "SetTool",
    "SetTurn",
    "SetUp",
    "ShowPart",
    "SmoothSoftness",
    "TurnHandles",
    "Undo",
    "ViewFrom",
]
