"""The command line: python -m app ..., or surface-deformation ... where it is installed."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import NoReturn

from app.bundled import DEFAULT_SESSION
from app.telling import flush, tell

USAGE_ERROR, INTERRUPTED = 2, 130
LONGEST_LEVEL = 20  # digits: Python refuses to read thousands of them
SESSION_SUFFIX = ".json"
COMMAND = "surface-deformation"
PROGRAM = COMMAND if Path(sys.argv[0]).stem == COMMAND else "python -m app"
WINDOW_HELP = """\
other commands (each has --help):
  deform MESH --session FILE -o OUT [--rigid K] [--pose NAME] [--poses] [--exact] [--force]
                                                  pose a mesh as a session says; no window
  learn MESH POSED... [--session FILE] -o SESSION
                                                  softness from poses of the mesh, into a session
  info MESH                                       what a mesh is and what is wrong with it
  demo -o DIR [--force]                           paint, fold and save, by itself
  figures -o DIR [--force]                        the paper's figures"""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """One line, where argparse would print its usage too."""
        tell(f"{self.prog}: {message} (see --help)", error=True)
        self.exit(USAGE_ERROR)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command; 0: done, 2: the input or the command is wrong, 130: Ctrl+C."""
    try:
        return _run(list(sys.argv[1:] if arguments is None else arguments))
    except KeyboardInterrupt:
        return INTERRUPTED
    finally:
        flush()


def _run(arguments: list[str]) -> int:
    # Here, as in every command: loading them takes its time, and Ctrl+C may come meanwhile.
    from solver.errors import SolverError

    try:
        if arguments and arguments[0] in COMMANDS:
            COMMANDS[arguments[0]](arguments[1:])
        else:
            _window(arguments)
    except (SolverError, OSError) as error:
        tell(f"{PROGRAM}: {error}", error=True)
        return USAGE_ERROR
    return 0


def _window(arguments: Sequence[str]) -> None:
    from app.graphics import loading
    from solver.mesh.formats.table import FORMATS

    parser = _Parser(
        prog=PROGRAM,
        description="Open a mesh or a session in a window: paint, drag, save.",
        epilog=WINDOW_HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    file_help = f"a mesh file ({', '.join(FORMATS)}) or a session file (.json)"
    parser.add_argument("file", nargs="?", type=Path, metavar="MESH | SESSION", help=file_help)
    parser.add_argument("--session", type=Path, metavar="FILE", help="a session file, on MESH")
    parser.add_argument("--export", type=Path, metavar="FILE", help="where Ctrl+E saves the mesh")
    options, others = parser.parse_known_args(arguments)
    mesh, session = options.file, options.session
    if others and others[0].lower().endswith(SESSION_SUFFIX):
        parser.error(f"{others[0]} on {mesh} needs --session before it")
    if others:
        parser.error(f"unrecognized arguments: {' '.join(others)}")
    if mesh is not None and mesh.suffix.lower() == SESSION_SUFFIX:
        if session is not None:
            parser.error(f"{mesh} and {session} are two sessions, expected a mesh and a session")
        mesh, session = None, mesh
    if mesh is None and session is None:
        session = DEFAULT_SESSION
    if options.export is not None:  # what else is there the window asks about
        from app.model.outputs import check_outputs

        inputs = [path for path in (mesh, session) if path is not None]
        check_outputs([options.export], True, inputs)
    # Polyscope is loaded here, so that the commands without a window need no graphics library.
    with loading():
        from app.window.main import run_window
    run_window(mesh, session, options.export)


def _deform(arguments: Sequence[str]) -> None:
    parser = _Parser(
        prog=f"{PROGRAM} deform", description="Pose a mesh as a session says, without a window."
    )
    parser.add_argument("mesh", type=Path, metavar="MESH")
    parser.add_argument("--session", type=Path, metavar="FILE", required=True)
    parser.add_argument("-o", "--output", type=Path, metavar="OUT", required=True)
    parser.add_argument("--rigid", type=_level, metavar="K", help="in place of the session's level")
    parser.add_argument("--pose", metavar="NAME", help="a kept pose in place of the current one")
    parser.add_argument(
        "--poses",
        action="store_true",
        help="save all kept poses too: morph targets, or files beside OUT",
    )
    parser.add_argument(
        "--exact", action="store_true", help="large meshes too: frames for every triangle"
    )
    _add_force(parser)
    if arguments and arguments[0].lower().endswith(SESSION_SUFFIX):
        parser.error(f"{arguments[0]} is a session, expected MESH --session {arguments[0]}")
    options = parser.parse_args(arguments)
    from app.headless import Wish, deform

    wish = Wish(options.rigid, options.pose, options.poses, options.exact, options.force)
    left_out = deform(options.mesh, options.session, options.output, wish)
    if left_out:
        tell(f"saved {options.output}; {left_out}", error=True)


def _learn(arguments: Sequence[str]) -> None:
    parser = _Parser(
        prog=f"{PROGRAM} learn",
        description="Find the softness with which a mesh takes the shapes of examples.",
    )
    parser.add_argument("mesh", type=Path, metavar="MESH")
    posed_help = "the same mesh in another shape, of any size and in any place"
    parser.add_argument("posed", type=Path, nargs="+", metavar="POSED", help=posed_help)
    session_help = "what is fixed, handles and material; else what moves rigidly is found"
    parser.add_argument("--session", type=Path, metavar="FILE", help=session_help)
    parser.add_argument("-o", "--output", type=Path, metavar="SESSION", required=True)
    _add_force(parser)
    options = parser.parse_args(arguments)
    from app.learning import learn

    learn(options.mesh, options.posed, options.session, options.output, options.force)


def _info(arguments: Sequence[str]) -> None:
    parser = _Parser(
        prog=f"{PROGRAM} info", description="What a mesh is and what is wrong with it."
    )
    parser.add_argument("mesh", type=Path, metavar="MESH")
    options = parser.parse_args(arguments)
    from app.headless import info

    for line in info(options.mesh):
        tell(line)


def _demo(arguments: Sequence[str]) -> None:
    from app.demo import FILES, demo

    demo(_folder("demo", "Paint, fold and save the default mesh, by itself.", arguments, FILES))


def _figures(arguments: Sequence[str]) -> None:
    from app.figures import FILES, figures

    figures(_folder("figures", "The paper's figures, on the default mesh.", arguments, FILES))


def _folder(
    command: str, description: str, arguments: Sequence[str], patterns: Sequence[str]
) -> Path:
    """The folder of `-o DIR`, made if its parent is there.

    patterns: of the files that will be written. Raises FileError where one is there already.
    """
    parser = _Parser(prog=f"{PROGRAM} {command}", description=description)
    parser.add_argument("-o", "--output", type=Path, metavar="DIR", required=True)
    _add_force(parser)
    options = parser.parse_args(arguments)
    folder: Path = options.output
    try:
        folder.mkdir(exist_ok=True)
    except OSError as error:
        parser.error(f"{folder}: no folder can be made there ({error.strerror})")
    from app.model.outputs import check_outputs

    there = (file for pattern in patterns for file in sorted(folder.glob(pattern)))
    check_outputs(there, options.force)
    return folder


def _add_force(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--force", action="store_true", help="replace files that are there already")


def _level(text: str) -> int:
    from solver.limits import HIGHEST_LEVEL

    if not text.isdecimal() or len(text) > LONGEST_LEVEL or int(text) > HIGHEST_LEVEL:
        expected = f"an integer from 0 to {HIGHEST_LEVEL}"
        raise argparse.ArgumentTypeError(f"expected {expected}, got {text[:60]!r}")
    return int(text)


COMMANDS = {"deform": _deform, "learn": _learn, "info": _info, "demo": _demo, "figures": _figures}

if __name__ == "__main__":
    sys.exit(main())
