"""Closed forms, and the same bits as the command."""

import inspect
import keyword

import numpy as np
import pygirth
import pytest
from pygirth import _girth
from shapes import as_obj, limbed_body, prism, tetrahedron, torus


def bits(values):
    return np.asarray(values, np.float64).view(np.uint64)


def assert_same_bits(one, other):
    one, other = np.asarray(one, np.float64), np.asarray(other, np.float64)
    assert one.shape == other.shape
    assert np.array_equal(np.isnan(one), np.isnan(other))
    known = ~np.isnan(one)
    assert np.array_equal(bits(one[known]), bits(other[known]))


@pytest.mark.parametrize("sides", [3, 4, 6, 12])
def test_a_prism_has_the_girth_of_its_polygon(sides):
    vertices, faces = prism(sides, length=40.0, rings=41)
    field = pygirth.igf(vertices, faces)
    middle = np.abs(vertices[:, 2] - 20) < 5
    np.testing.assert_allclose(field.values[middle], sides, rtol=1e-12)
    assert (field.kinds[middle] == 0).all()


def test_a_tetrahedron():
    # From a corner the farthest point is the middle of the opposite face: a height of a triangle and a
    # third of the next one's.
    field = pygirth.igf(*tetrahedron())
    np.testing.assert_allclose(field.values, field.values[0], rtol=1e-12)
    mesh = pygirth.Mesh(*tetrahedron())
    np.testing.assert_allclose(mesh.geodesics(0).values, [0, 1, 1, 1], rtol=1e-15)
    np.testing.assert_allclose(mesh.area, np.sqrt(3), rtol=1e-15)


def test_a_loop_around_a_prism():
    mesh = pygirth.Mesh(*prism(6, length=40.0, rings=41))
    vertex = 6 * 20
    loop = mesh.loop(vertex)
    assert loop.kind == "loop"
    np.testing.assert_allclose(loop.length, 6, rtol=1e-12)
    np.testing.assert_allclose(loop.points[0], mesh.vertices[vertex], atol=1e-12)
    np.testing.assert_allclose(loop.points[-1], loop.points[0])
    along = np.linalg.norm(np.diff(loop.points, axis=0), axis=1).sum()
    np.testing.assert_allclose(along, loop.length, rtol=1e-12)
    np.testing.assert_allclose(loop.angle, np.pi, rtol=1e-9)


def test_a_loop_at_a_point_of_a_face():
    vertices, faces = prism(6, length=40.0, rings=41)
    mesh = pygirth.Mesh(vertices, faces)
    weights = np.array([0.2, 0.3, 0.5])
    loop = mesh.loop(face=240, weights=weights)
    np.testing.assert_allclose(loop.base, weights @ vertices[faces[240]], atol=1e-12)
    np.testing.assert_allclose(loop.length, 6, rtol=1e-12)
    middle = mesh.loop(face=240)
    np.testing.assert_allclose(middle.base, vertices[faces[240]].mean(axis=0), atol=1e-12)


def test_weights_belong_to_the_corners_of_a_face_that_was_turned_over():
    vertices, faces = torus()
    turned = faces.copy()
    turned[7] = turned[7][[0, 2, 1]]
    mesh = pygirth.Mesh(vertices, turned)
    assert mesh.report["reoriented_faces"] == 1
    for row in (6, 7, 8):
        base = mesh.loop(face=row, weights=(0.1, 0.2, 0.7)).base
        np.testing.assert_allclose(base, np.array([0.1, 0.2, 0.7]) @ vertices[turned[row]])


def test_distances_and_paths_on_an_unfolded_prism():
    vertices, faces = prism(4, length=10.0, rings=11)
    mesh = pygirth.Mesh(vertices, faces)
    # One side on, three up.
    np.testing.assert_allclose(mesh.geodesics(0).values[4 * 3 + 1], np.sqrt(10), rtol=1e-14)
    path = mesh.path(0, 4 * 3 + 1)
    np.testing.assert_allclose(path.length, np.sqrt(10), rtol=1e-12)
    np.testing.assert_allclose(path.points[[0, -1]], vertices[[0, 13]], atol=1e-14)
    several = mesh.geodesics([0, 4 * 10]).values
    single = np.minimum(mesh.geodesics(0).values, mesh.geodesics(40).values)
    np.testing.assert_allclose(several, single, rtol=1e-14)
    inside = mesh.geodesics((0, (0.5, 0.5, 0.0)))
    np.testing.assert_allclose(inside.values[faces[0][:2]], [0.5, 0.5])
    assert np.isinf(mesh.geodesics(0, radius=2.0).values).any()


def test_components_apart_are_infinitely_far():
    vertices, faces = tetrahedron()
    both = pygirth.Mesh(np.vstack([vertices, vertices + 9]), np.vstack([faces, faces + 4]))
    assert np.isinf(both.geodesics(0).values[4:]).all()
    path = both.path(0, 5)
    assert np.isinf(path.length) and len(path.points) == 0
    kept = pygirth.Mesh(np.vstack([vertices, vertices + 9]), np.vstack([faces, faces + 4]), components=[1])
    assert np.isnan(kept.igf().values[:4]).all() and np.isfinite(kept.igf().values[4:]).all()


def test_the_tips_of_a_body_with_eight_limbs():
    vertices, faces = limbed_body(8, 30, 64)
    mesh = pygirth.Mesh(vertices, faces)
    far = [tip for tip in mesh.tips() if np.linalg.norm(vertices[tip.apex]) > 3.4]
    assert len(far) == 8
    angles = np.sort(np.arctan2(*vertices[[tip.apex for tip in far]][:, 1::-1].T) % (2 * np.pi))
    np.testing.assert_allclose(np.diff(angles), np.pi / 4, atol=0.1)
    limbs = [limb for limb in mesh.limbs(stations=16) if limb.length > 1]
    assert len(limbs) == 8 and limbs[0].profile.shape == (16, 4)
    axis = mesh.axis(limbs[0])
    assert 2 <= len(axis) <= 16 and axis[0].distance == 0
    steps = [np.linalg.norm(b.centre - a.centre) for a, b in zip(axis, axis[1:])]
    np.testing.assert_allclose(np.diff([loop.distance for loop in axis]), steps, rtol=1e-9)
    for loop in axis:
        around = np.linalg.norm(np.diff(loop.points, axis=0), axis=1).sum()
        np.testing.assert_allclose(loop.girth, around, rtol=1e-9)
    assert len(mesh.cut(axis[len(axis) // 2]).parts) == 2


def test_vertices_of_results_are_rows_all_copies_among_them():
    vertices, faces = limbed_body(8, 30, 64)
    limb = pygirth.Mesh(vertices, faces).limbs(stations=8)[0]
    assert limb.distances.shape == limb.vertices.shape and limb.distances.max() <= limb.length
    assert limb.distances[limb.vertices == limb.apex] == 0
    # A corner of its own for each face: the preparation welds them.
    corners = vertices[faces].reshape(-1, 3)
    welded = pygirth.Mesh(corners, np.arange(len(corners)).reshape(-1, 3)).limbs(stations=8)[0]
    assert limb.length == welded.length
    rows = np.flatnonzero(np.isin(faces.ravel(), limb.vertices))
    assert np.array_equal(welded.vertices, rows) and welded.apex in rows
    assert_same_bits(
        welded.distances, limb.distances[np.searchsorted(limb.vertices, faces.ravel()[rows])]
    )


def test_parts_cover_the_mesh():
    mesh = pygirth.Mesh(*torus())
    parts = mesh.parts(girth=7.0, shape_diameter=3.0)
    assert len(parts) == 1 and parts[0].kind == "tube" and (parts.labels == 0).all()
    assert (parts.girth, parts.shape_diameter) == (7.0, 3.0)
    np.testing.assert_allclose(parts[0].area, mesh.area, rtol=1e-9)


def test_the_shape_diameter_has_its_older_name_too():
    mesh = pygirth.Mesh(*torus())
    with pytest.warns(DeprecationWarning, match="older name of shape_diameter"):
        parts = mesh.parts(girth=7.0, thickness=3.0)
    with pytest.warns(DeprecationWarning, match="older name of shape_diameter"):
        assert parts.thickness == parts.shape_diameter == 3
    with pytest.warns(DeprecationWarning, match="older name of median_shape_diameter"):
        assert parts[0].median_thickness == parts[0].median_shape_diameter
    with pytest.raises(pygirth.InputError, match="state one"):
        mesh.segments(shape_diameter=3, thickness=3)
    assert not hasattr(parts[0], "shape_radius")


def test_other_triangles_of_the_same_surface():
    mesh = pygirth.Mesh(*torus())
    for method in ("fitting", "even"):
        other = mesh.remesh(600, method=method)
        assert abs(len(other.faces) - 600) <= 12
        np.testing.assert_allclose(other.area, mesh.area, rtol=0.05)


def test_smoothed_it_is_nearer_to_what_it_was_before_noise():
    vertices, faces = torus()
    noise = np.random.default_rng(1).normal(scale=0.1, size=vertices.shape)
    rough = pygirth.Mesh(vertices + noise, faces)
    smooth = rough.smooth(3)
    np.testing.assert_array_equal(smooth.faces, rough.faces)
    error = [np.abs(one.vertices - vertices).mean() for one in (rough, smooth)]
    assert error[1] < 0.7 * error[0]
    np.testing.assert_array_equal(rough.smooth(0).vertices, rough.vertices)
    # Compared it is smoothed likewise, and nearer.
    plain = pygirth.Mesh(vertices, faces)
    distances = [
        pygirth.compare([plain, rough], "igf", smooth=steps)["igf"][0, 1] for steps in (0, 3)
    ]
    both = pygirth.compare([plain.smooth(3), smooth], "igf")["igf"][0, 1]
    np.testing.assert_allclose(distances[1], both, rtol=1e-9)
    assert distances[1] < distances[0]


def test_shapes_of_any_size_and_place_are_the_same():
    vertices, faces = torus()
    turned = vertices[:, [1, 2, 0]] * 7 + 3
    names = ["igf", "2*igf+log-igf"]
    compared = pygirth.compare([(vertices, faces), (turned, faces), prism()], names)
    assert list(compared.descriptors) == names
    for matrix in compared.distances.values():
        assert matrix.shape == (3, 3) and np.array_equal(matrix, matrix.T)
        assert matrix[0, 1] < 1e-9 < matrix[0, 2]


@pytest.fixture(params=["prism.obj", "prism_seams.glb", "mended.obj"])
def model(request, tmp_path, repository):
    """Models that the preparation leaves alone, welds, and mends."""
    if request.param != "mended.obj":
        return repository / "tests/data" / request.param
    vertices, faces = torus(24, 10)
    faces[5] = faces[5][::-1]
    vertices = np.vstack([vertices, [[9, 9, 9]], vertices[:3]])
    faces[11][faces[11] == 0] = 241
    path = tmp_path / request.param
    path.write_text(as_obj(vertices, faces))
    return path


def test_the_bits_of_the_command(model, command):
    mesh = pygirth.load(model)
    assert_same_bits(mesh.igf().values, command("igf", model, output=".npy"))
    assert_same_bits(mesh.igf(method="ms").values, command("igf", model, "--method", "ms", output=".npy"))
    for name in ("sdf", "thickness", "geoaverage", "geofarthest", "angle", "hks"):
        assert_same_bits(mesh.field(name).values, command("field", model, "--field", name, output=".npy"))
    exact = command("field", model, "--field", "geofarthest", "--exact", output=".npy")
    assert_same_bits(mesh.field("geofarthest", exact=True).values, exact)
    blunt = command("field", model, "--field", "thickness", "--sharp", 30, output=".npy")
    assert_same_bits(mesh.field("thickness", sharp=30).values, blunt)


def test_the_refined_girth_of_the_command(tmp_path, command):
    vertices, faces = torus(60, 24)
    path = tmp_path / "fine.obj"
    path.write_text(as_obj(vertices, faces))
    mesh = pygirth.load(path)
    refined = mesh.igf(method="refined", audit=30, threads=2)
    assert_same_bits(
        refined.values,
        command("igf", path, "--method", "refined", "--audit", 30, output=".npy"),
    )
    assert refined.method == "refined"
    assert refined.audit["vertices"] == 30
    share = refined.audit["equal"] / 30
    assert refined.audit["at_least"] <= share <= refined.audit["at_most"]
    # Proved ones are the exact ones.
    proved = refined.states == pygirth.RefinedGirth.STATES.index("proved")
    assert proved.sum() >= 30
    assert_same_bits(refined.values[proved], mesh.igf().values[proved])
    other = mesh.igf(method="refined", audit=30, seed=2)
    assert not np.array_equal(other.states, refined.states)


def test_the_persistent_girth_of_the_command(model, command):
    mesh = pygirth.load(model)
    tau = 0.02 * mesh.area**0.5
    field = mesh.igf(persistence=tau)
    assert field.persistence == tau and len(field.mesh.tips(persistence=tau)) >= 0
    theirs = command("igf", model, "--persistence", "2%", output=".npy")
    assert_same_bits(field.values, theirs)
    assert_same_bits(mesh.igf(persistence=tau).values, theirs)
    assert_same_bits(mesh.igf().values, command("igf", model, output=".npy"))
    assert (field.values >= mesh.igf().values)[~np.isnan(field.values)].all()
    for vertex in (0, 20):
        barcode = mesh.barcode(vertex, max_persistence=tau, loops=True)
        assert len(barcode) == len(barcode.births) == len(barcode.loops)
        assert [2 * birth for birth in barcode.births] == [loop.length for loop in barcode.loops]
        assert barcode.girth(tau)[0] == field.values[vertex]
        assert mesh.loop(vertex, persistence=tau).length == field.values[vertex]
        assert (mesh.barcode(vertex).births[: len(barcode)] == barcode.births).all()
        assert len(mesh.barcode(vertex, max_saddles=1)) <= 1


def test_the_same_arrays_as_the_file(model):
    mesh = pygirth.load(model)
    again = pygirth.Mesh(mesh.vertices, mesh.faces)
    assert_same_bits(mesh.igf().values, again.igf().values)
    assert mesh.report == again.report


def test_loops_tips_and_parts_of_the_command(model, command):
    mesh = pygirth.load(model)
    for place, words in ((mesh.loop(20), ["20"]), (mesh.loop(face=5), ["--face", "5"])):
        theirs = command("loop", model, *words, output=".json")
        assert_same_bits(place.length, theirs["length"])
        assert_same_bits(place.points, [point["position"] for point in theirs["points"]])
    theirs = command("tips", model, as_json=True)
    assert mesh.tips().apexes.tolist() == [
        tip["apex"]["vertices"][0] for tip in theirs["tips"]
    ]
    parts = command("parts", model, as_json=True)
    assert [part.kind for part in mesh.parts()] == [part["kind"] for part in parts["parts"]]
    assert_same_bits([part.area for part in mesh.parts()], [part["area"] for part in parts["parts"]])


def test_distances_of_the_command(model, command, repository):
    others = [model, repository / "tests/data/prism.obj"]
    theirs = command("compare", *others, "--descriptors", "igf,hks", as_json=True)
    ours = pygirth.compare(others, ["igf", "hks"])
    for descriptor in theirs["descriptors"]:
        assert_same_bits(ours[descriptor["name"]], descriptor["distances"])


def test_parameters_of_fields_are_keywords_with_the_defaults_of_cpp():
    keywords = inspect.signature(pygirth.Mesh.field).parameters
    for name in pygirth.FIELDS:
        for parameter in _girth.field_parameters(name):
            # A keyword of Mesh.igf alone is no keyword of Mesh.field; words of Python have a line behind.
            own = parameter + "_" if keyword.iskeyword(parameter) else parameter
            assert parameter == "persistence" or own in keywords
    mesh = pygirth.Mesh(*prism(4, length=4.0, rings=4))
    plain = mesh.field("sdf").values
    assert np.array_equal(plain, mesh.field("sdf", rays=30, cone=120).values)
    assert not np.array_equal(plain, mesh.field("sdf", rays=3).values)
    with pytest.raises(pygirth.InputError, match="rays"):
        mesh.field("sdf", rays=0)
