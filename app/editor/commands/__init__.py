"""What a person can ask for, as data; the actions do it. A file for each subject, as there."""

from app.editor.commands.choices import SetBrush, SetMap, SetMarking, SetTool, SetTurn
from app.editor.commands.command import Command, CommandError
from app.editor.commands.files import Export, OpenMesh, OpenSession, SaveSession
from app.editor.commands.history import CancelGesture, Redo, Undo
from app.editor.commands.marks import ChangeMarks, FindLimbs
from app.editor.commands.parts import SetFollows, ShowPart
from app.editor.commands.poses import ResetPose
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
from app.editor.commands.view import FrameSelected, SetUp, ViewFrom

__all__ = [
    "ActivateHandle",
    "AddHandle",
    "CancelGesture",
    "ChangeMarks",
    "ClearFixed",
    "ClearHandle",
    "ClearPins",
    "ClearSoftness",
    "Command",
    "CommandError",
    "Export",
    "FillSoftness",
    "FindLimbs",
    "FrameSelected",
    "OpenMesh",
    "OpenSession",
    "Redo",
    "RemoveHandle",
    "RenameHandle",
    "ResetPose",
    "SaveSession",
    "SetBrush",
    "SetFollows",
    "SetMap",
    "SetMarking",
    "SetMaterial",
    "SetSetting",
    "SetTool",
    "SetTurn",
    "SetUp",
    "ShowPart",
    "SmoothSoftness",
    "Undo",
    "ViewFrom",
]
