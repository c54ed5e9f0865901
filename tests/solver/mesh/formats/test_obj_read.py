"""Reading OBJ files: every way to write one, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from solver.errors import MeshError
from solver.mesh.mesh import Mesh, load_mesh

CORNERS = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
V4 = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"


def load(folder: Path, data: bytes) -> Mesh:
    path = folder / "mesh.obj"
    path.write_bytes(data)
    return load_mesh(path)


@pytest.mark.parametrize(
    "faces",
    [
        b"f 1 2 3 4",
        b"f 1/1 2/1 3/1 4/1",
        b"f 1//1 2//1 3//1 4//1",
        b"f 1/1/1 2/1/1 3/1/1 4/1/1",
        b"f 1/1/1 2//1 3 4/1",
        b"f 1/1/1 2//1 3//1 4/1/1",
        b"f 1/1/ 2/1/ 3/1/ 4/1/",
        b"f -4 -3 -2 -1",
        b"f -4/-1/-1 -3/-1/-1 -2/-1/-1 -1/-1/-1",
        b"f 1 -3 3 -1",
        b"f\t1  2 \t 3 4 ",
        b"  f 1 2 3 4",
        b"f 1 2 \\\n3 4",
        b"f 1 2 \\ \r\n 3\\\r\n 4",
        b"f 1 2 3 4 # a square",
        b"f 1 2 3 4#1 2",
        b"f 1/x/1 2/x/1 3/x/1 4/x/1",
    ],
)
def test_every_way_to_write_a_face_is_the_same_face(tmp_path: Path, faces: bytes) -> None:
    mesh = load(tmp_path, V4 + b"vt 0 0\nvn 0 0 1\n" + faces + b"\n")
    assert mesh.vertices.tolist() == CORNERS
    assert mesh.faces.tolist() == [[0, 1, 2], [0, 2, 3]]
    assert np.asarray(mesh.polygons).tolist() == [[0, 1, 2, 3]]


@pytest.mark.parametrize(
    "line",
    [
        b"v 1 2.5 -3",
        b"v 1 2.5 -3 1",
        b"v 1 2.5 -3 0.2 0.3 0.4",
        b"v 1.0 25e-1 -.3E+1 1 0.2 0.3 0.4",
        b"v\t1   2.5\t-3",
        b" v 1 2.5 -3 # corner",
        b"v 1 2.5 -3#corner",
        b"v 1 \\\n 2.5 \\\n -3",
    ],
)
@pytest.mark.parametrize("ending", [b"\n", b"\r\n", b"\r"])
@pytest.mark.parametrize("bom", [b"", b"\xef\xbb\xbf"])
def test_every_way_to_write_a_vertex(
    tmp_path: Path, line: bytes, ending: bytes, bom: bytes
) -> None:
    data = (line + b"\n" + V4 + b"f 1 2 3").replace(b"\n", ending)
    assert load(tmp_path, bom + data).vertices.tolist() == [[1, 2.5, -3], *CORNERS]


@pytest.mark.parametrize("ending", [b"\n", b"\r\n", b"\r"])
@pytest.mark.parametrize(
    "line", [b"usemtl dir\\", b" mtllib C:\\", b"o a\\ ", b"g a \\", b"# dir\\", b"\tusemtl \\"]
)
def test_a_name_that_ends_in_a_backslash_keeps_the_next_line(
    tmp_path: Path, line: bytes, ending: bytes
) -> None:
    lines = line + b"\n" + V4 + line + b"\nf 1 2 3\n" + line + b"\nf 1 3 4\n"
    data = lines.replace(b"\n", ending)
    mesh = load(tmp_path, data)
    assert mesh.vertices.tolist() == CORNERS
    assert mesh.faces.tolist() == [[0, 1, 2], [0, 2, 3]]
    mesh.save(tmp_path / "out.obj", mesh.vertices)
    assert (tmp_path / "out.obj").read_bytes() == data


@pytest.mark.parametrize("end", [b"\\", b" \\", b" \\ ", b" \\\n", b"\\\r\n"])
def test_a_backslash_at_the_end_of_a_file_joins_nothing(tmp_path: Path, end: bytes) -> None:
    mesh = load(tmp_path, V4 + b"f 1 2 3 4" + end)
    assert mesh.outlines.tolist() == [[0, 1, 2, 3]]
    mesh.save(tmp_path / "out.obj", mesh.vertices)
    assert (tmp_path / "out.obj").read_bytes() == V4 + b"f 1 2 3 4" + end
    moved = load(tmp_path, b"f 1 2 3\n" + V4[:-1] + end)
    moved.save(tmp_path / "out.obj", moved.vertices + 1)
    assert (load_mesh(tmp_path / "out.obj").vertices == moved.vertices + 1).all()


def test_negative_numbers_count_from_the_face_back(tmp_path: Path) -> None:
    negative = load(tmp_path, V4 + b"f -4 -3 -2\n" + V4 + b"f -4 -3 -2\nv 9 9 9\nf -1 -3 -6\n")
    positive = load(tmp_path, V4 + b"f 1 2 3\n" + V4 + b"f 5 6 7\nv 9 9 9\nf 9 7 4\n")
    assert negative.faces.tolist() == positive.faces.tolist()
    assert negative.vertices.tolist() == positive.vertices.tolist()


def test_everything_else_is_ignored(tmp_path: Path) -> None:
    other = (
        b"# na\xefve \xff\xfe\nmtllib C:\\a b.mtl\no \xe9\ng one two\n"
        b"s off\nusemtl red\nvp 1 2\nl 1 2 3\np 4\ncurv 0 1 1 2\nfoo\nvertex 1\nfaces 1 2\n\n \t \n"
        b"# a comment may end in a backslash \\\n"
    )
    mesh = load(tmp_path, other + V4 + other + b"f 1 2 3 4\n" + other)
    assert mesh.vertices.tolist() == CORNERS
    assert len(mesh.faces) == 2


def test_faces_may_come_first_and_repeat_vertices(tmp_path: Path) -> None:
    mesh = load(tmp_path, b"f 1 1 2\nf 1 2 3\nf 1 2 3\n" + V4)
    assert mesh.faces.tolist() == [[0, 0, 1], [0, 1, 2], [0, 1, 2]]


def test_faces_of_mixed_sizes_are_lists_for_display(tmp_path: Path) -> None:
    mesh = load(tmp_path, V4 + b"f 1 2 3\nf 1 2 3 4\n")
    assert mesh.polygons == [[0, 1, 2], [0, 1, 2, 3]]


def test_unreadable_normals_are_no_error(tmp_path: Path) -> None:
    mesh = load(
        tmp_path, V4 + b"vn -nan(ind) 0 0\nvn\nvn nan 0 1\nf 1//1 2//2 3//9\nf 1//3 2// 3//0"
    )
    assert len(mesh.faces) == 2


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "empty, expected an OBJ mesh"),
        (b" \r\n\n", "empty, expected an OBJ mesh"),
        (b"\x7fELF\0\0\x01f 1 2 3", "binary data, expected an OBJ mesh"),
        (b"hello\nworld\n", "no vertices, expected an OBJ mesh"),
        (b"<html>f 1 2 3</html>", "no vertices, expected an OBJ mesh"),
        (V4, "no faces, expected at least one"),
        (V4 + b"f 1 2 5\n", "line 5: the face names vertex 5, but the file has 4, got 'f 1 2 5'"),
        (V4 + b"f 1/1 2/1 9/1\n", "line 5: the face names vertex 9, but the file has 4"),
        (V4 + b"f 1//1 2//1 9//1\n", "line 5: the face names vertex 9, but the file has 4"),
        (V4 + b"f 0 1 2\n", "line 5: the face names vertex 0, but the first vertex is 1"),
        (V4 + b"f 0 0 0\n", "line 5: the face names vertex 0, but the first vertex is 1"),
        (b"v 0 0 0\nf -1 -2 -3\n" + V4, "line 2: the face names vertex -2, but 1 come before it"),
        (V4 + b"f 1 2 3\nf 1 2\n", "line 6: a face needs at least three corners, got 'f 1 2'"),
        (V4 + b"f\nf 1 2 3\n", "line 5: a face needs at least three corners, got 'f'"),
        (V4 + b"f a b c\n", "line 5: expected corners v, v/vt, v//vn or v/vt/vn, got 'f a b c'"),
        (V4 + b"f 1 2 3.5\n", "line 5: expected corners"),
        (V4 + b"f 1//x 2//1 3//1\n", "line 5: expected corners"),
        (V4 + b"f 1/1/- 2/1/1 3/1/1\n", "line 5: expected corners"),
        (V4 + b"f /1/1 2/1/1 3/1/1\n", "line 5: expected corners"),
        (V4 + b"f 1 2 99999999999999999999999\n", "line 5: expected corners"),
        (V4 + b"v 1 2\nf 1 2 3\n", "line 5: expected three numbers x y z, got 'v 1 2'"),
        (V4 + b"v\nf 1 2 3\n", "line 5: expected three numbers x y z, got 'v'"),
        (V4 + b"v 1 two 3\nf 1 2 3\n", "line 5: expected three numbers x y z, got 'v 1 two 3'"),
        (V4 + b"v 1,0 2,0 3,0\nf 1 2 3\n", "line 5: expected three numbers x y z"),
        (V4 + b"v nan 0 0\nf 1 2 3\n", "line 5: expected finite coordinates, got 'v nan 0 0'"),
        (V4 + b"v 0 -inf 0\nf 1 2 3\n", "line 5: expected finite coordinates"),
        (V4 + b"v 0 1e999 0\nf 1 2 3\n", "line 5: expected finite coordinates"),
        (b"g a \\\n b \\\n c\r\n" + V4 + b"f 1 2 9\n", "line 8: the face names vertex 9"),
        (b"# a\r\n# b\r# c\n\n" + V4 + b"f 1 2 9\r\n", "line 9: the face names vertex 9"),
    ],
)
def test_bad_files_give_one_line_that_names_the_place(
    tmp_path: Path, data: bytes, words: str
) -> None:
    with pytest.raises(MeshError) as caught:
        load(tmp_path, data)
    message = str(caught.value)
    assert words in message
    assert message.startswith(str(tmp_path / "mesh.obj"))
    assert len(message.splitlines()) == 1


def test_a_long_or_strange_line_is_quoted_in_short(tmp_path: Path) -> None:
    with pytest.raises(MeshError) as caught:
        load(tmp_path, V4 + b"f 1 2 \x07\xff" + b"x" * 10_000)
    assert len(str(caught.value)) < len(str(tmp_path)) + 200
    assert str(caught.value).isprintable()


def test_a_file_cut_anywhere_loads_or_gives_one_clear_line(tmp_path: Path) -> None:
    whole = V4 + b"vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1 4/1/1\nf 1//1 \\\n 2//1 3//1\n"
    loaded = 0
    for length in range(len(whole)):
        message = ""
        try:
            loaded += len(load(tmp_path, whole[:length]).faces) > 0
        except MeshError as error:
            message = str(error)
        assert len(message.splitlines()) <= 1
    assert 0 < loaded < len(whole)
