"""How the scene is looked at: shading, pictures of it, and how large the interface is drawn."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import polyscope.imgui as psim

from app.editor import commands as c
from app.editor.editor import Editor
from app.model.free_path import free_path
from app.model.preferences import PreferencesFile
from app.scene.looks import FILE, FLAT, SHADINGS, SMOOTH
from app.viewpoint.viewpoint import SIDES, UPS
from app.window.file_dialogs import FileDialogs
from app.window.films.film import TakeFilm, default_film_path
from app.window.films.studio import Studio
from app.window.panel.widgets import CHOSEN_COLOR, halves, shares, short_path, typed_path
from app.window.shortcuts import SetInterface, WindowAction

SWITCHES = (
    ("edges", "edges", "Draw the edges of the polygons"),
    ("rest", "rest shape", "See the rest shape through the surface"),
    ("beside", "beside", "See the rest shape beside the surface: before and after"),
)
SHADING_TIPS = {
    SMOOTH: "Shade over all edges",
    FLAT: "Shade each polygon flat",
    FILE: "Smooth but for the hard edges that the file has",
}
PICTURES = (
    ("Picture", "picture", "Save what is seen as a PNG beside the mesh"),
    ("Before, after", "before-after", "Save a PNG of the rest shape and of the surface, in a row"),
)
FILMS = (
    ("Turntable", "turntable", "Film one turn around it, as MP4 or GIF"),
    ("Record", "record", "Film what happens from now on, as MP4 or GIF"),
)
SCALES = (None, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0)


class LookingRows:
    """The rows, which know what pictures are being taken and what a person prefers."""

    def __init__(self, studio: Studio, preferences: PreferencesFile, dialogs: FileDialogs) -> None:
        self._studio = studio
        self._preferences = preferences
        self._dialogs = dialogs
        self._typed = -1, ""  # the document that a film is of, and where it goes

    def draw(self, editor: Editor, asked: list[c.Command]) -> None:
        """What was pressed goes into `asked`."""
        for number, (name, label, tip) in enumerate(SWITCHES):
            if number:
                psim.SameLine()
            changed, on = psim.Checkbox(label, getattr(editor.looks, name))
            psim.SetItemTooltip(tip)
            if changed:
                asked.append(c.SetLooks(**{name: on}))
        _shading(editor, asked)
        for (label, size), (_, name, tip) in zip(_evenly(PICTURES), PICTURES, strict=True):
            if psim.Button(label, size):
                asked.append(WindowAction(name))
            psim.SetItemTooltip(tip)
        self._films(editor, asked)
        _camera(editor, asked)
        self._interface(asked)

    def _films(self, editor: Editor, asked: list[c.Command]) -> None:
        """Buttons that ask where a film goes; where there are no dialogs, a field that tells."""
        for (label, size), (_, name, tip) in zip(_evenly(FILMS), FILMS, strict=True):
            if name == "record" and self._studio.recording is not None:
                psim.PushStyleColor(psim.ImGuiCol_Button, CHOSEN_COLOR)
                if psim.Button(f"Stop {self._studio.recording:.0f} s###Record", size):
                    asked.append(WindowAction("stop"))
                psim.PopStyleColor(1)
                psim.SetItemTooltip("Save the recording")
                continue
            if psim.Button(label, size):
                known = self._dialogs.available
                asked.append(WindowAction(name) if known else TakeFilm(name, self._path(editor)))
            psim.SetItemTooltip(tip)
        if not self._dialogs.available:
            _, typed = psim.InputTextWithHint("film", ".mp4 or .gif", self._film(editor))
            self._typed = editor.document.serial, typed
            psim.SetItemTooltip("Where films go, under the next free name")

    def _film(self, editor: Editor) -> str:
        serial, typed = self._typed
        if serial == editor.document.serial:
            return typed
        return short_path(default_film_path(editor.document.path, "film"))

    def _path(self, editor: Editor) -> Path:
        return free_path(typed_path(self._film(editor)))

    def _interface(self, asked: list[c.Command]) -> None:
        scale = self._preferences.values.interface_scale
        scales = SCALES if scale in SCALES else (*SCALES, scale)
        labels = [f"{100 * s:.0f} %" if s is not None else "as the screen" for s in scales]
        changed, index = psim.Combo("interface size", scales.index(scale), labels)
        if changed:
            asked.append(SetInterface(scales[index]))


def _evenly(rows: tuple[tuple[str, str, str], ...]) -> Iterator[tuple[str, tuple[float, float]]]:
    return shares(*(label for label, _, _ in rows))


def _shading(editor: Editor, asked: list[c.Command]) -> None:
    """One of the ways that there are for this mesh."""
    mesh = editor.document.mesh
    hard = mesh.flat or mesh.smooth_corners is not None
    chosen = editor.looks.shading if hard or editor.looks.shading != FILE else SMOOTH
    for name in SHADINGS if hard else (SMOOTH, FLAT):
        if name != SMOOTH:
            psim.SameLine()
        if psim.RadioButton("as in the file" if name == FILE else name, chosen == name):
            asked.append(c.SetLooks(shading=name))
        psim.SetItemTooltip(SHADING_TIPS[name])


def _camera(editor: Editor, asked: list[c.Command]) -> None:
    """From which side, and which axis is upright."""
    for label in halves("##side", "##up"):
        if label == "##side":
            if psim.BeginCombo(label, "view from ..."):
                for side in SIDES:
                    if psim.Selectable(side):
                        asked.append(c.ViewFrom(side))
                psim.EndCombo()
            continue
        names = list(UPS)
        at = names.index(editor.viewpoint.up_name)
        changed, index = psim.Combo(label, at, [f"{name} is up" for name in names])
        if changed:
            asked.append(c.SetUp(names[index]))
