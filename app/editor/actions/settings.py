"""What the commands do to the material and the solver's settings."""

from __future__ import annotations

from app.editor import commands as c
from app.editor.action import Actions, check_name
from app.model.settings import SETTINGS
from app.workspace.workspace import Workspace
from solver.softness.material import resolve_material


def set_material(work: Workspace, command: c.SetMaterial) -> None:
    resolve_material(command.material)
    if command.material != work.document.material:
        with work.edit("Material", merge="material") as gesture:
            gesture.change("material", command.material)


def set_setting(work: Workspace, command: c.SetSetting) -> None:
    name, value = command.name, command.value
    check_name(name, SETTINGS, "setting")
    if not SETTINGS[name].accepts(value):
        raise c.CommandError(f"{name} must be {SETTINGS[name].expected}, got {value!r}")
    if value != getattr(work.document, name):
        with work.edit(name.replace("_", " ").capitalize(), merge=name) as gesture:
            gesture.change(name, value)


SETTING_ACTIONS: Actions = {
    c.SetMaterial: set_material,
    c.SetSetting: set_setting,
}
