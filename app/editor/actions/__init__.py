"""What the commands do, by subject. ACTIONS is the table of all."""

from __future__ import annotations

from app.editor.action import Actions
from app.editor.actions.choices import CHOICE_ACTIONS
from app.editor.actions.history import HISTORY_ACTIONS
from app.editor.actions.marks import MARK_ACTIONS
from app.editor.actions.parts import PART_ACTIONS
from app.editor.actions.placing import PLACING_ACTIONS
from app.editor.actions.posed_meshes import POSED_MESH_ACTIONS
from app.editor.actions.poses import POSE_ACTIONS
from app.editor.actions.regions import REGION_ACTIONS
from app.editor.actions.rest import REST_ACTIONS
from app.editor.actions.settings import SETTING_ACTIONS
from app.editor.actions.softness import SOFTNESS_ACTIONS
from app.editor.actions.symmetry import SYMMETRY_ACTIONS
from app.editor.actions.view import VIEW_ACTIONS
from app.editor.files.actions import FILE_ACTIONS
from app.editor.files.pose_export import POSE_EXPORT_ACTIONS

ACTIONS: Actions = {
    **CHOICE_ACTIONS,
    **REGION_ACTIONS,
    **MARK_ACTIONS,
    **SOFTNESS_ACTIONS,
    **SETTING_ACTIONS,
    **PART_ACTIONS,
    **POSE_ACTIONS,
    **REST_ACTIONS,
    **PLACING_ACTIONS,
    **HISTORY_ACTIONS,
    **SYMMETRY_ACTIONS,
    **VIEW_ACTIONS,
    **FILE_ACTIONS,
    **POSE_EXPORT_ACTIONS,
    **POSED_MESH_ACTIONS,
}
