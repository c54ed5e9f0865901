"""Makes a Scene of what is open; what has not changed is the same object as before."""

from __future__ import annotations

from dataclasses import replace

from app.latest import Latest
from app.scene.ghost import ghost
from app.scene.looks import FILE, FLAT
from app.scene.overlay import NOTHING, Overlay
from app.scene.regions import Borders, border_lines
from app.scene.scene import Dots, Lines, Scene, dot_radius
from app.scene.shading import Shaded, shaded
from app.scene.twin import ASIDE, Twin
from app.workspace.color_maps import MAPS
from app.workspace.workspace import Workspace
from solver.geometry.bounding_box import middle
from solver.types import FloatArray


class Stage:
    """The scene of one open document."""

    def __init__(self, work: Workspace) -> None:
        self._work = work
        self._colors: Latest[FloatArray] = Latest()
        self._dots: Latest[Dots | None] = Latest()
        self._borders: Borders | None = None
        self._lines: Latest[Lines | None] = Latest()
        self._ghost: Latest[FloatArray] = Latest()
        self._twin: Latest[Twin] = Latest()
        self._shaded: Latest[Shaded] = Latest()
        self._dot_radius = dot_radius(work.document.mesh.vertices, work.neighbours.edges)

    def scene(self, cursor: Overlay, rest: bool) -> Scene:
        """What is to be drawn now.

        rest: the rest shape in place of the surface, and no cursor on it.
        """
        work, document = self._work, self._work.document
        positions = document.rest_positions if rest else work.positions
        ghost = self._seen_through() if work.looks.rest and not rest else None
        twin = self._before() if work.looks.beside and not rest else None
        overlay, lines = (NOTHING, None) if rest else (cursor, self._border_lines())
        looks = work.looks
        if looks.shading == FILE and document.mesh.flat:
            looks = replace(looks, shading=FLAT)
        shown = positions, self.colors, self._pins(positions, rest), looks
        return Scene(self._polygons(), *shown, ghost, twin, lines, overlay)

    @property
    def colors(self) -> FloatArray:
        """(n, 3) RGB of the map that is shown; another array where they have changed."""
        return self._colors(self.colors_version, lambda: MAPS[self._work.map].paint(self._work))

    @property
    def colors_version(self) -> tuple[object, ...]:
        """Differs whenever `colors` may."""
        return (self._work.map, MAPS[self._work.map].version(self._work))

    def _polygons(self) -> Shaded:
        """Those of the parts that are seen, with the hard edges that are asked for."""
        work, mesh = self._work, self._work.document.mesh
        hard = work.looks.shading == FILE and mesh.smooth_corners is not None
        version = hard, work.parts.hidden
        return self._shaded(version, lambda: shaded(mesh, hard, work.parts.seen))

    def _pins(self, positions: FloatArray, rest: bool) -> Dots | None:
        """A dot on every vertex whose softness is pinned, on the maps that show them."""
        work, document = self._work, self._work.document
        if not MAPS[work.map].pins:
            return None
        shown = document.pinned & work.parts.visible
        version = document.revision["pinned"], work.surface.version, work.parts.hidden, rest
        return self._dots(
            version, lambda: Dots(positions[shown], self._dot_radius) if shown.any() else None
        )

    def _seen_through(self) -> FloatArray:
        """The rest shape as a ghost."""
        document = self._work.document
        return self._ghost(
            document.revision["rest"],
            lambda: ghost(document.rest_positions, document.mesh.faces, document.diagonal),
        )

    def _before(self) -> Twin:
        """The rest shape beside the surface."""
        document = self._work.document

        def made() -> Twin:
            V = document.rest_positions
            used = V[document.mesh.pieces >= 0]
            return Twin(V, middle(used), ASIDE * document.diagonal)

        return self._twin(document.revision["rest"], made)

    def _border_lines(self) -> Lines | None:
        """The borders of what is held; those before while a stroke is changing them."""
        work = self._work
        if work.interaction is None or self._borders is None:
            self._borders = work.regions.borders(work.document)
        borders, selected = self._borders, tuple(handle.key for handle in work.selected)
        radius = work.viewpoint.line_radius
        version = borders, work.surface.version, selected, radius
        return self._lines(version, lambda: border_lines(borders, work.positions, selected, radius))
