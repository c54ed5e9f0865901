"""The panel beside the scene: shows what the Editor holds and returns what the person asks for."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import polyscope.imgui as psim

from app import commands as c
from app.colors import ACTIVE_COLOR, FIXED_COLOR, MAPS, OTHER_COLOR
from app.editor import Editor
from app.files import default_export_path, default_session_path, open_command
from app.input import SHORTCUTS, WindowAction
from app.tools import TOOLS
from solver.material import PRESETS, Material, resolve_material

WIDTH = 310.0
SMALLEST_GAIN, LARGEST_GAIN = 0.01, 10.0
HIGHEST_RIGID = 10
TOOLS_A_ROW = 3
BUTTON_COLUMN = WIDTH - 86.0  # where the buttons behind a region begin
ERROR_COLOR = (1.0, 0.45, 0.4, 1.0)
BUSY_COLOR = (1.0, 0.8, 0.3, 1.0)
SOFT_COLOR = (0.36, 0.79, 0.39)
CHOSEN_COLOR = (0.18, 0.5, 0.85, 1.0)
FIXED_PANEL = (
    psim.ImGuiWindowFlags_NoTitleBar
    | psim.ImGuiWindowFlags_NoResize
    | psim.ImGuiWindowFlags_NoMove
    | psim.ImGuiWindowFlags_NoCollapse
    | psim.ImGuiWindowFlags_NoBringToFrontOnFocus
)


class Panel:
    """Holds only what a person is typing and which parts are unfolded.

    show_edges, show_help: switches of the window itself.
    """

    def __init__(self) -> None:
        self.show_edges = False
        self.show_help = False
        self.focus_open = False
        self._open_text = ""
        self._export_text: str | None = None
        self._session_text: str | None = None

    def draw(self, editor: Editor) -> list[c.Command]:
        """Draw the panel; the commands of what was pressed, moved or typed in this frame."""
        asked: list[c.Command] = []
        psim.SetNextWindowPos((0.0, 0.0))
        psim.SetNextWindowSize((WIDTH, psim.GetIO().DisplaySize[1]))
        psim.SetNextWindowBgAlpha(1.0)
        psim.Begin("##panel", FIXED_PANEL)
        try:
            psim.PushItemWidth(-110.0)
            for section in (_status, _tools, _tool_options, _handles, _material, _pose):
                section(editor, asked)
            self._display(editor, asked)
            self._files(editor, asked)
            psim.PopItemWidth()
        finally:
            psim.End()
        if self.show_help:
            self._help()
        return asked

    def forget_paths(self) -> None:
        """Another document is open: propose its own paths again."""
        self._export_text = self._session_text = None

    def _display(self, editor: Editor, asked: list[c.Command]) -> None:
        psim.SeparatorText("Colours")
        for name in MAPS:
            if psim.RadioButton(name.capitalize(), editor.map == name):
                asked.append(c.SetMap(name))
            psim.SameLine()
        _, self.show_edges = psim.Checkbox("Edges", self.show_edges)
        if psim.Button("Frame (F)"):
            asked.append(WindowAction("frame"))
        psim.SameLine()
        if psim.Button("Help (F1)"):
            asked.append(WindowAction("help"))

    def _files(self, editor: Editor, asked: list[c.Command]) -> None:
        psim.SeparatorText("Files")
        self._open_text, go = self._path_row("Open", "mesh or session", self._open_text)
        if go and self._open_text.strip():
            asked.append(open_command(Path(self._open_text.strip()).expanduser()))
        session = self._session_text or _short(default_session_path(editor))
        session, go = self._path_row("Save session", "session (.json)", session)
        self._session_text = session
        if go and session.strip():
            asked.append(c.SaveSession(Path(session.strip()).expanduser()))
        target = self._export_text or _short(default_export_path(editor))
        target, go = self._path_row("Export mesh", "deformed mesh", target)
        self._export_text = target
        if go and target.strip():
            asked.append(c.Export(Path(target.strip()).expanduser()))
        psim.TextDisabled("or drop a file on the window")

    def _path_row(self, label: str, hint: str, text: str) -> tuple[str, bool]:
        if label == "Open" and self.focus_open:
            psim.SetKeyboardFocusHere()
            self.focus_open = False
        _, text = psim.InputTextWithHint(f"##{label}", hint, text)
        entered = psim.IsItemDeactivatedAfterEdit() and psim.IsKeyPressed(psim.ImGuiKey_Enter)
        if psim.IsItemHovered() and text:
            psim.SetTooltip(text)
        psim.SameLine()
        return text, psim.Button(label, (-1.0, 0.0)) or entered

    def _help(self) -> None:
        psim.SetNextWindowPos((WIDTH + 30.0, 30.0), psim.ImGuiCond_FirstUseEver)
        _, self.show_help = psim.Begin("Help", True, psim.ImGuiWindowFlags_AlwaysAutoResize)
        try:
            psim.Text("Paint what stays (2), what you move (3), where it bends (4); then drag (5).")
            psim.Text("Left drag beside the surface or with Navigate orbits, right drag pans,")
            psim.Text("the wheel zooms. Shift while painting erases.")
            psim.Separator()
            for shortcut in SHORTCUTS:
                psim.Text(f"{shortcut.keys}")
                psim.SameLine(130.0)
                psim.Text(shortcut.meaning)
        finally:
            psim.End()


def _status(editor: Editor, asked: list[c.Command]) -> None:
    document = editor.document
    mark = " *" if editor.dirty else ""
    psim.Text(f"{document.path.name}{mark}")
    faces = len(document.mesh.outlines.sizes)
    psim.TextDisabled(f"{len(document.role):,} vertices, {faces:,} faces")
    if editor.busy:
        psim.TextColored(BUSY_COLOR, editor.hint)
    else:
        psim.TextWrapped(editor.hint)
    bound = editor.bind_seconds
    bind = "-" if bound is None else f"{1e3 * bound:.0f} ms"
    drag = f"{1e3 * editor.drag_seconds:.1f} ms" if editor.drag_seconds else "-"
    psim.TextDisabled(f"bind {bind}   drag frame {drag}")


def _tools(editor: Editor, asked: list[c.Command]) -> None:
    psim.SeparatorText("Tools")
    room, gap = psim.GetContentRegionAvail()[0], psim.GetStyle().ItemSpacing[0]
    size = ((room - (TOOLS_A_ROW - 1) * gap) / TOOLS_A_ROW, 0.0)
    for number, (name, tool) in enumerate(TOOLS.items()):
        if number % TOOLS_A_ROW:
            psim.SameLine()
        chosen = editor.tool == name
        if chosen:
            psim.PushStyleColor(psim.ImGuiCol_Button, CHOSEN_COLOR)
        if psim.Button(f"{tool.key} {tool.label}", size):
            asked.append(c.SetTool(name))
        if chosen:
            psim.PopStyleColor(1)


def _tool_options(editor: Editor, asked: list[c.Command]) -> None:
    brush = editor.brush
    if TOOLS[editor.tool].paints:
        moved, radius = psim.SliderFloat(
            "brush radius", brush.radius, 0.005, 0.3, "%.3f", psim.ImGuiSliderFlags_Logarithmic
        )
        if moved:
            asked.append(c.SetBrush(radius=radius))
    if editor.tool == "softness":
        for label in ("value", "strength"):
            moved, number = psim.SliderFloat(label, getattr(brush, label), 0.0, 1.0, "%.2f")
            if moved:
                asked.append(c.SetBrush(**{label: number}))
    if editor.tool == "drag":
        changed, turn = psim.Checkbox("turns by itself", editor.turn)
        if changed:
            asked.append(c.SetTurn(turn))


def _handles(editor: Editor, asked: list[c.Command]) -> None:
    document = editor.document
    psim.SeparatorText("Regions")
    _region_row("fixed", FIXED_COLOR, len(document.fixed), c.ClearFixed(), asked)
    soft = int((document.softness > 0).sum())
    _region_row("soft", SOFT_COLOR, soft, c.ClearSoftness(), asked)
    for handle in document.handles:
        psim.PushID(str(handle.key))
        active = editor.active is not None and handle.key == editor.active.key
        _swatch(ACTIVE_COLOR if active else OTHER_COLOR)
        if psim.RadioButton("##active", active):
            asked.append(c.ActivateHandle(handle.key))
        psim.SetItemTooltip("Paint and drag this handle")
        psim.SameLine()
        psim.SetNextItemWidth(110.0)
        _, name = psim.InputText("##name", handle.name)
        if name.strip() and name != handle.name:
            asked.append(c.RenameHandle(handle.key, name))
        psim.SameLine()
        psim.Text(f"{len(document.vertices_of(handle.key)):,}")
        psim.SameLine(BUTTON_COLUMN)
        if psim.SmallButton("remove"):
            asked.append(c.RemoveHandle(handle.key))
        psim.PopID()
    if psim.Button("New handle"):
        asked.append(c.AddHandle())


def _region_row(
    label: str,
    color: tuple[float, float, float],
    count: int,
    clear: c.Command,
    asked: list[c.Command],
) -> None:
    _swatch(color)
    psim.Text(f"{label}  {count:,}")
    psim.SameLine(BUTTON_COLUMN)
    with _disabled(count == 0):
        if psim.SmallButton(f"clear##{label}"):
            asked.append(clear)


def _material(editor: Editor, asked: list[c.Command]) -> None:
    psim.SeparatorText("Soft parts")
    document = editor.document
    names = [*PRESETS, "custom"]
    material = document.material
    chosen = names.index("custom" if isinstance(material, Material) else material)
    changed, index = psim.Combo("material", chosen, names)
    gains = resolve_material(material)
    if changed:
        asked.append(c.SetMaterial(gains if names[index] == "custom" else names[index]))
    if not psim.TreeNode("gains and bending length"):
        return
    for label in ("bending", "stretching"):
        moved, gain = psim.SliderFloat(
            f"{label} gain",
            getattr(gains, label),
            SMALLEST_GAIN,
            LARGEST_GAIN,
            "%.3g",
            psim.ImGuiSliderFlags_Logarithmic,
        )
        if moved and gain > 0:
            asked.append(c.SetMaterial(Material(**{**vars(gains), label: gain})))
    moved, length = psim.SliderFloat(
        "bend length",
        document.bending_length,
        1e-3,
        0.3,
        "%.3g",
        psim.ImGuiSliderFlags_Logarithmic,
    )
    psim.SetItemTooltip("How far a bend spreads, in diagonals of the mesh")
    if moved and length > 0:
        asked.append(c.SetSetting("bending_length", length))
    psim.TreePop()


def _pose(editor: Editor, asked: list[c.Command]) -> None:
    psim.SeparatorText("Pose")
    document = editor.document
    moved, rigid = psim.SliderInt("rigid", document.rigid, 0, HIGHEST_RIGID)
    psim.SetItemTooltip("0: linear, shrinks in large turns. 1: keeps lengths. More: rounds of both")
    if moved:
        asked.append(c.SetSetting("rigid", rigid))
    changed, on = psim.Checkbox("handles hold orientation", document.orientation)
    if changed:
        asked.append(c.SetSetting("orientation", on))
    if psim.Button("Reset pose (R)"):
        asked.append(c.ResetPose())
    psim.SameLine()
    for label, command, entries in (
        ("Undo", c.Undo(), editor.history.done),
        ("Redo", c.Redo(), editor.history.undone),
    ):
        with _disabled(not entries):
            if psim.Button(label):
                asked.append(command)
            if entries:
                psim.SetItemTooltip(entries[-1].label)
        psim.SameLine()
    psim.NewLine()


def _swatch(color: tuple[float, float, float]) -> None:
    red, green, blue = map(float, color)
    flags = psim.ImGuiColorEditFlags_NoTooltip
    psim.AlignTextToFramePadding()
    psim.ColorButton("##swatch", (red, green, blue, 1.0), flags, (12.0, psim.GetFrameHeight()))
    psim.SameLine()


def _short(path: Path) -> str:
    """Relative to the working directory where it lies below."""
    try:
        return str(path.resolve().relative_to(Path.cwd()))
    except ValueError:
        return str(path)


@contextmanager
def _disabled(off: bool) -> Iterator[None]:
    psim.BeginDisabled(off)
    yield
    psim.EndDisabled()
