"""Bad input ends in a clear error; what other libraries have is taken."""

import errno
import pickle
import sys
from types import SimpleNamespace

import numpy as np
import pygirth
import pytest
from shapes import prism, tetrahedron, torus

V, F = tetrahedron()


def error_of(call):
    with pytest.raises(pygirth.GirthError) as caught:
        call()
    error = caught.value
    assert isinstance(error, pygirth.InputError) and isinstance(error, ValueError)
    assert error.code in pygirth.errors.error_codes and error.message and error.hint
    assert error.code in str(error) and error.message in str(error) and error.hint in str(error)
    return error


@pytest.mark.parametrize(
    "vertices, faces, code, words",
    [
        (V.astype(complex), F, "USAGE", "complex128"),
        (V.astype(str), F, "USAGE", "<U"),
        (V.astype(object), F, "USAGE", "numbers"),
        ([[0, 0, 0], [1, 0]], F, "USAGE", "V"),
        (V[:, :2], F, "USAGE", "(4, 2)"),
        (V.ravel(), F, "USAGE", "(12,)"),
        (V[None], F, "USAGE", "(1, 4, 3)"),
        (3.5, F, "USAGE", "()"),
        (None, F, "USAGE", "numbers"),
        (V, F.astype(float), "USAGE", "float64"),
        (V, F.astype(bool), "USAGE", "bool"),
        (V, np.zeros((3, 4), int), "USAGE", "(3, 4)"),
        (V, np.zeros((0, 3), int), "EMPTY_MESH", ""),
        (V, [], "EMPTY_MESH", ""),
        (np.zeros((0, 3)), np.zeros((0, 3), int), "EMPTY_MESH", ""),
        (np.zeros((0, 3)), F, "INDEX_OUT_OF_RANGE", "vertex 0 of 0"),
        (np.zeros((4, 3)), F, "EMPTY_MESH", ""),
    ],
)
def test_arrays_that_are_no_mesh(vertices, faces, code, words):
    error = error_of(lambda: pygirth.igf(vertices, faces))
    assert error.code == code and words in error.message


@pytest.mark.parametrize("number", [4, -1, 2**31, 2**32, 2**63 - 1, -(2**63)])
def test_a_face_that_names_no_vertex(number):
    faces = F.astype(np.int64)
    faces[2, 1] = number
    error = error_of(lambda: pygirth.Mesh(V, faces))
    assert (error.code, error.element) == ("INDEX_OUT_OF_RANGE", 2)
    assert f"face 2 names vertex {number} of 4" in error.message


def test_numbers_beyond_64_bits_wrap_into_an_error():
    faces = F.astype(np.uint64)
    faces[1, 0] = 2**64 - 1
    assert error_of(lambda: pygirth.Mesh(V, faces)).element == 1


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_positions_that_are_no_numbers(value):
    vertices = V.copy()
    vertices[3, 1] = value
    error = error_of(lambda: pygirth.Mesh(vertices, F))
    assert (error.code, error.element) == ("NON_FINITE_POSITION", 3)


@pytest.mark.parametrize(
    "vertices, faces",
    [
        (np.asfortranarray(V), np.asfortranarray(F)),
        (np.repeat(V, 2, axis=0)[::2], np.repeat(F, 2, axis=1)[:, ::2]),
        (V[::-1][::-1], F.astype(np.uint16)),
        (V.astype(">f8"), F.astype(">i4")),
        (V.tolist(), F.tolist()),
        (np.ma.masked_array(V), F.astype(np.int8)),
    ],
)
def test_any_layout_gives_the_same_values(vertices, faces):
    assert np.array_equal(pygirth.igf(vertices, faces).values, pygirth.igf(V, F).values)


def test_float32_is_taken_as_it_is():
    single = V.astype(np.float32)
    assert np.array_equal(pygirth.igf(single, F).values, pygirth.igf(single.astype(float), F).values)


def test_nothing_is_copied_where_the_layout_allows():
    vertices, faces = torus()
    vertices, faces = np.ascontiguousarray(vertices), np.ascontiguousarray(faces, np.int64)
    mesh = pygirth.Mesh(vertices, faces)
    assert np.shares_memory(mesh.vertices, vertices) and np.shares_memory(mesh.faces, faces)
    assert not mesh.vertices.flags.writeable and vertices.flags.writeable
    values = mesh.geodesics(0).values
    # The memory of the core itself, kept alive by the array alone.
    del mesh
    assert values.base is not None and np.isfinite(values).all()


def test_a_result_outlives_its_mesh_and_is_written_to():
    field = pygirth.Mesh(*torus()).geodesics(0)
    field.values[:] = 1
    assert field.range == (1, 1)


@pytest.mark.parametrize("vertex", [4, -1, 2**40, -(2**70)])
def test_vertices_that_there_are_not(vertex):
    mesh = pygirth.Mesh(V, F)
    for call in (mesh.loop, mesh.geodesics, lambda v: mesh.path(0, v)):
        assert error_of(lambda: call(vertex)).code == "VERTEX_OUT_OF_RANGE"


@pytest.mark.parametrize("vertex", ["1", 1.0, True, [0, "a"], object()])
def test_points_that_are_none(vertex):
    assert error_of(lambda: pygirth.Mesh(V, F).geodesics(vertex)).code == "VERTEX_OUT_OF_RANGE"


def test_a_vertex_that_no_face_uses():
    mesh = pygirth.Mesh(np.vstack([V, [[5, 5, 5]]]), F)
    error = error_of(lambda: mesh.loop(4))
    assert (error.code, error.element) == ("VERTEX_OUT_OF_RANGE", 4)
    field = mesh.igf()
    assert np.isnan(field.values[4]) and field.kinds[4] == 255 and np.isfinite(field.values[:4]).all()


@pytest.mark.parametrize(
    "arguments, code",
    [
        ({"face": 4}, "INVALID_POINT"),
        ({"face": -1}, "INVALID_POINT"),
        ({"face": 0, "weights": (1, 0)}, "INVALID_POINT"),
        ({"face": 0, "weights": (0.5, 0.6, 0.7)}, "INVALID_POINT"),
        ({"face": 0, "weights": (np.nan, 0, 1)}, "INVALID_POINT"),
        ({"face": 0, "weights": ("a", 0, 1)}, "INVALID_OPTION"),
        ({"vertex": 0, "face": 0}, "USAGE"),
        ({"vertex": 0, "weights": (1, 0, 0)}, "USAGE"),
        ({}, "USAGE"),
    ],
)
def test_places_that_are_none(arguments, code):
    assert error_of(lambda: pygirth.Mesh(V, F).loop(**arguments)).code == code


def test_a_face_that_was_left_out():
    faces = np.vstack([F, [[0, 1, 2]]])
    assert "left out" in error_of(lambda: pygirth.Mesh(V, faces).loop(face=4)).message


MESH = pygirth.Mesh(V, F)


@pytest.mark.parametrize(
    "call",
    [
        lambda: MESH.igf(threads=-1),
        lambda: MESH.igf(threads=10**9),
        lambda: MESH.igf(threads="two"),
        lambda: MESH.igf(progress=3),
        lambda: MESH.igf(method="quick"),
        lambda: MESH.igf(persistence=-1),
        lambda: MESH.igf(persistence=np.nan),
        lambda: MESH.igf(persistence=np.inf),
        lambda: MESH.igf(persistence="2%"),
        lambda: MESH.igf(method="ms", persistence=1),
        lambda: MESH.igf(method="refined", persistence=1),
        lambda: MESH.igf(method="refined", audit=-1),
        lambda: MESH.igf(method="refined", seed=0.5),
        lambda: MESH.loop(0, persistence=-1),
        lambda: MESH.tips(persistence=np.nan),
        lambda: MESH.barcode(0, max_persistence=-1),
        lambda: MESH.barcode(0, max_saddles=-1),
        lambda: MESH.barcode(0, max_saddles=1.5),
        lambda: MESH.field("height"),
        lambda: MESH.field(None),
        lambda: MESH.field("sdf", rays=0),
        lambda: MESH.field("sdf", rays=10**12),
        lambda: MESH.field("sdf", cone=np.nan),
        lambda: MESH.field("thickness", sharp=90),
        lambda: MESH.field("thickness", sharp="blunt"),
        lambda: MESH.field("hks", pairs=1),
        lambda: MESH.field("hks", times=[]),
        lambda: MESH.field("hks", times=[-1]),
        lambda: MESH.geodesics(0, radius=-1),
        lambda: MESH.geodesics(0, radius=np.nan),
        lambda: MESH.remesh(3),
        lambda: MESH.smooth(-1),
        lambda: MESH.smooth(101),
        lambda: MESH.smooth(10**20),
        lambda: MESH.smooth(1.5),
        lambda: MESH.remesh(-5),
        lambda: MESH.remesh(10**20),
        lambda: MESH.remesh(100.5),
        lambda: MESH.remesh(100, method="fast"),
        lambda: MESH.parts(girth=-1),
        lambda: MESH.parts(smoothing=np.nan),
        lambda: MESH.limbs(stations=0),
        lambda: MESH.limbs(stations=10**10),
        lambda: pygirth.Mesh(V, F, weld=-1),
        lambda: pygirth.Mesh(V, F, weld=np.nan),
        lambda: pygirth.Mesh(V, F, scale=0),
        lambda: pygirth.Mesh(V, F, scale=np.inf),
        lambda: pygirth.Mesh(V, F, components=[1]),
        lambda: pygirth.Mesh(V, F, components=[-1]),
        lambda: pygirth.compare([MESH]),
        lambda: pygirth.compare([MESH, MESH], ["beauty"]),
        lambda: pygirth.compare([MESH, MESH], []),
        lambda: pygirth.compare([MESH, MESH], faces=-1),
        lambda: pygirth.compare([MESH, MESH], smooth=101),
        lambda: pygirth.collection.fields([MESH], smooth=-1),
        lambda: pygirth.compare([MESH, 5]),
        lambda: pygirth.igf(V),
        lambda: pygirth.igf(5),
    ],
)
def test_options_out_of_range(call):
    error_of(call)


def test_paths_that_are_no_mesh(tmp_path, repository):
    missing = error_of(lambda: pygirth.load(tmp_path / "missing.obj"))
    assert missing.code == "FILE_NOT_FOUND" and missing.file.endswith("missing.obj")
    assert isinstance(missing, FileNotFoundError) and isinstance(missing, pygirth.InputError)
    assert missing.errno == errno.ENOENT and missing.filename == str(tmp_path / "missing.obj")
    assert type(missing) is pygirth.MissingFileError and "missing.obj: FILE_NOT_FOUND" in str(missing)
    again = pickle.loads(pickle.dumps(missing))
    assert (again.code, again.filename, str(again)) == (missing.code, missing.filename, str(missing))
    assert error_of(lambda: pygirth.load(tmp_path)).code in ("FILE_UNREADABLE", "FILE_NOT_FOUND")
    (tmp_path / "text.obj").write_text("It is not a model.\n")
    assert error_of(lambda: pygirth.igf(str(tmp_path / "text.obj"))).code == "UNKNOWN_FORMAT"
    (tmp_path / "empty.ply").write_bytes(b"")
    assert error_of(lambda: pygirth.igf(tmp_path / "empty.ply")).code == "EMPTY_FILE"
    assert error_of(lambda: pygirth.load("a\0b.obj")).code == "FILE_NOT_FOUND"
    bad = [path for path in (repository / "tests/data/bad").iterdir() if path.is_file()]
    assert len(bad) > 5
    for path in bad:
        try:
            pygirth.load(path)
        except pygirth.GirthError as error:
            assert error.file == str(path) and error.hint


def test_a_path_with_letters_of_any_kind(tmp_path, repository):
    path = tmp_path / "Größe ♥.obj"
    path.write_bytes((repository / "tests/data/prism.obj").read_bytes())
    assert len(pygirth.load(path).vertices) == 44
    assert len(pygirth.as_mesh(bytes(path)).vertices) == 44


def block(kind, data):
    return SimpleNamespace(type=kind, data=np.array(data))


def polygons(points, faces):
    return SimpleNamespace(points=points, faces=np.array(faces), n_cells=1)


QUADS = [(0, 1, 2, 3), (4, 5, 6, 7)]
CORNERS = np.array([(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], float)


def test_meshes_of_other_libraries(repository):
    trimesh = SimpleNamespace(vertices=V, faces=F)
    meshio = SimpleNamespace(
        points=V, cells=[block("line", [[0, 1]]), block("triangle", F[:2]), block("triangle", F[2:])]
    )
    pyvista = polygons(V, np.hstack([np.full((4, 1), 3), F]).ravel())
    path = repository / "tests/data/prism.obj"
    expected = pygirth.igf(V, F).values
    for model in ((V, F), [V, F], trimesh, meshio, pyvista, pygirth.Mesh(V, F)):
        assert np.array_equal(pygirth.igf(model).values, expected)
        assert pygirth.compare([model, path], ["igf"])["igf"].shape == (2, 2)
    assert len(pygirth.igf(path)) == len(pygirth.igf(str(path))) == 44


def test_quads_become_triangles():
    halves = [(0, 1, 2), (0, 2, 3), (4, 5, 6), (4, 6, 7)]
    meshio = SimpleNamespace(points=CORNERS, cells=[block("quad", QUADS)])
    pyvista = polygons(CORNERS, [4, 0, 1, 2, 3, 3, 4, 5, 6, 3, 4, 6, 7])
    for model in (meshio, pyvista):
        assert pygirth.as_mesh(model).faces.tolist() == [list(face) for face in halves]


@pytest.mark.parametrize(
    "model",
    [
        SimpleNamespace(points=V, cells=[block("tetra", [[0, 1, 2, 3]])]),
        SimpleNamespace(points=V, cells=[]),
        polygons(V, [3, 0, 1]),
        polygons(V, [2, 0, 1]),
        polygons(V, [-7, 0, 1]),
        polygons(V, []),
        SimpleNamespace(vertices=V, faces=None),
        (V, F, F),
        {"V": V},
    ],
)
def test_models_without_a_surface(model):
    error_of(lambda: pygirth.as_mesh(model))


def test_without_pyvista_the_error_names_what_to_install(monkeypatch):
    # As where it is not installed: importing it fails.
    monkeypatch.setitem(sys.modules, "pyvista", None)
    mesh = pygirth.Mesh(V, F)
    for call in (mesh.to_pyvista, mesh.igf().to_pyvista, mesh.geodesics(0).to_pyvista):
        with pytest.raises(pygirth.MissingPackageError) as caught:
            call()
        error = caught.value
        assert isinstance(error, ImportError) and isinstance(error, pygirth.GirthError)
        assert (error.code, error.name) == ("PROGRAM_NOT_LOADED", "pyvista")
        assert "PyVista" in error.message and sys.executable in error.message
        assert "pip install pyvista" in error.hint and error.hint in str(error)
        assert pickle.loads(pickle.dumps(error)).hint == error.hint


def test_what_pyvista_itself_lacks_is_its_own_matter(monkeypatch, tmp_path):
    (tmp_path / "pyvista.py").write_text("import a_package_that_there_is_not\n")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "pyvista", raising=False)
    with pytest.raises(ModuleNotFoundError, match="a_package_that_there_is_not") as caught:
        pygirth.Mesh(V, F).to_pyvista()
    assert not isinstance(caught.value, pygirth.GirthError)


def test_pyvista_is_handed_what_it_takes(monkeypatch):
    made = SimpleNamespace(point_data={})

    def poly_data(points, faces):
        made.points, made.faces = points, faces
        return made

    monkeypatch.setitem(sys.modules, "pyvista", SimpleNamespace(PolyData=poly_data))
    field = pygirth.igf(V, F)
    assert field.to_pyvista() is made
    assert np.array_equal(made.points, V) and made.faces.tolist()[:4] == [3, *F[0]]
    assert np.array_equal(made.point_data["igf"], field.values)
    assert np.array_equal(made.point_data["igf_kind"], field.kinds)


def test_a_field_is_an_array():
    field = pygirth.igf(V, F)
    values = field.values
    assert np.asarray(field) is values and field.shape == values.shape and field.dtype == values.dtype
    for result, wanted in (
        (field / 2 + 1, values / 2 + 1),
        (2 * field, 2 * values),
        (field - field, values - values),
        (field > values.mean(), values > values.mean()),
        (np.sqrt(field), np.sqrt(values)),
        (field[3:7], values[3:7]),
        (field[field < values.mean()], values[values < values.mean()]),
        (np.percentile(field, 30), np.percentile(values, 30)),
        (list(field), list(values)),
    ):
        assert np.array_equal(result, wanted)
    assert type(field + 1) is np.ndarray and field[2] == values[2]
    assert (field.min(), field.max(), field.mean()) == (values.min(), values.max(), values.mean())
    assert (field.argmin(), field.argmax()) == (values.argmin(), values.argmax())
    assert not np.add.reduce(field) - values.sum()


def test_load_takes_the_unit_that_a_file_does_not_state(repository):
    path = repository / "tests/data/prism.obj"
    assert pygirth.load(path).unit == ""
    assert pygirth.load(path, unit="millimetre").unit == "millimetre"
    assert pygirth.load(path, unit="mm").unit == "millimetre"
    with pytest.raises(pygirth.InputError, match="INVALID_OPTION.*parsec.*um, mm, cm"):
        pygirth.load(path, unit="parsec")
    assert pygirth.load(repository / "tests/data/prism_seams.glb").unit == "metre"


def test_igf_takes_a_persistence():
    wanted = pygirth.Mesh(V, F).igf(persistence=0.2)
    found = pygirth.igf(V, F, persistence=0.2)
    assert found.persistence == 0.2 and np.array_equal(found.values, wanted.values)


def test_meshes_and_results_go_to_other_processes(repository):
    mesh = pygirth.load(repository / "tests/data/prism_seams.glb", weld=0.001)
    again = pickle.loads(pickle.dumps(mesh))
    assert (again.unit, again.report) == ("metre", mesh.report)
    assert np.array_equal(pickle.loads(pickle.dumps(mesh.igf())).values, mesh.igf().values)
    error = pickle.loads(pickle.dumps(error_of(lambda: mesh.loop(-1))))
    assert error.code == "VERTEX_OUT_OF_RANGE" and error.element == -1


def test_what_is_printed():
    vertices, faces = prism()
    mesh = pygirth.Mesh(vertices, faces, unit="metre")
    assert repr(mesh) == "<pygirth.Mesh: 126 vertices, 240 faces, area 60, in metres>"
    for result in (mesh.igf(), mesh.loop(60), mesh.tips(), mesh.parts(), mesh.path(0, 100)):
        assert repr(result).startswith(f"<pygirth.{type(result).__name__}: ") and "\n" not in repr(result)
    assert repr(mesh.igf()).endswith(" metre>")
