"""Necks, handles, bottlenecks, profiles and cuts: closed forms, and the same bits as the command."""

import pickle

import numpy as np
import pygirth
import pytest
from shapes import as_obj, lathe, prism, tetrahedron, torus

#: Two waists of known length between three bellies.
RINGS = [(0, 1.8), (4, 1.0), (8.8, 2.2), (14.8, 0.7), (20, 2.0)]
SIDES = 8


def waists():
    return lathe(RINGS, SIDES)


def polygon_length(radius):
    return 2 * SIDES * radius * np.sin(np.pi / SIDES)


@pytest.fixture
def model(tmp_path):
    path = tmp_path / "waists.obj"
    path.write_text(as_obj(*waists()))
    return path


def test_necks_are_those_of_the_command(command, model):
    mesh = pygirth.load(model)
    found = mesh.necks()
    wanted = command("necks", model, as_json=True)
    assert found.unresolved == wanted["unresolved"] == 0
    np.testing.assert_allclose(found.lengths, [polygon_length(0.7), polygon_length(1)], rtol=1e-12)
    assert np.isinf(found.prominences[0])
    assert found.suggested_prominence == wanted["suggestedProminence"]
    assert found.suggested_prominence == pytest.approx(polygon_length(0.7) / 20)
    assert [neck.length for neck in found] == [neck.length for neck in found.necks]
    for neck, other in zip(found, wanted["necks"]):
        assert neck.length == other["length"]
        assert np.isinf(neck.prominence) or neck.prominence == other["prominence"]
        assert neck.vertices.tolist() == other["vertices"]
        assert neck.points.tolist() == [point["position"] for point in other["points"]]
        assert neck.centre.tolist() == other["centre"]
        assert neck.area == other["area"] and neck.radius == other["radius"]
        assert neck.sides.tolist() == [[side["area"], side["volume"]] for side in other["sides"]]
        assert neck.measures_girth and not neck.touches_boundary
    assert len(mesh.necks(min_prominence=np.inf)) == 1
    assert repr(found[0]) == "<pygirth.Neck: length 4.28605, prominence inf>"
    assert repr(found) == "<pygirth.Necks: 2 necks, lengths [4.286, 6.123]>"


def test_segments_are_those_of_the_command(command, model):
    mesh = pygirth.load(model)
    found = mesh.segments(girth=9, shape_diameter=3)
    wanted = command("segments", model, "--girth", 9, "--shape-diameter", 3, as_json=True)
    assert len(found) == len(wanted["segments"]) == 3
    assert (found.girth, found.shape_diameter) == (9, 3)
    assert found.crossing == wanted["crossing"] == []
    assert found.labels.tolist() == wanted["faces"]
    cut = mesh.cut(mesh.necks())
    assert found.labels.tolist() == cut.labels.tolist()
    for segment, part, other in zip(found, cut, wanted["segments"]):
        assert segment.area == other["area"]
        np.testing.assert_allclose(part.area, segment.area, rtol=1e-12)
        assert segment.kind == other["kind"] and segment.shares == other["shares"]
        assert list(segment.tips) == [tip["tip"] for tip in other["tips"]]
        assert segment.apexes.tolist() == [tip["apex"]["vertices"][0] for tip in other["tips"]]
    assert sorted(tip for segment in found for tip in segment.tips) == list(range(len(mesh.tips())))
    assert len(mesh.segments(min_prominence=1e6)) == 2
    assert repr(found).startswith("<pygirth.Segments: 3 segments: ")
    with pytest.raises(pygirth.InputError):
        mesh.segments(girth=-1)


def test_handles_are_those_of_the_command(command, tmp_path):
    path = tmp_path / "torus.obj"
    path.write_text(as_obj(*torus(12, 8)))
    found = pygirth.load(path).handles()
    wanted = command("handles", path, as_json=True)
    assert found.unresolved == 0
    assert [handle.kind for handle in found] == [one["kind"] for one in wanted["handles"]]
    assert sorted(handle.kind for handle in found) == ["handle", "tunnel"]
    for handle, other in zip(found, wanted["handles"]):
        assert handle.length == other["length"]
        assert handle.may_be_shorter_by == other["mayBeShorterBy"]
        assert handle.points.tolist() == [point["position"] for point in other["points"]]
    assert len(pygirth.Mesh(*tetrahedron()).handles()) == 0


def test_a_bottleneck_is_that_of_the_command(command, model):
    mesh = pygirth.load(model)
    found = mesh.bottleneck(2 * SIDES, 4 * SIDES + 3)
    wanted = command("bottleneck", model, 2 * SIDES, 4 * SIDES + 3, as_json=True)
    assert found.kind == wanted["kind"] == "neck"
    assert found.girth == wanted["girth"]
    np.testing.assert_allclose(found.girth, polygon_length(0.7), rtol=1e-12)
    assert found.points.tolist() == [point["position"] for point in wanted["points"]]
    assert found.way.tolist() == [point["position"] for point in wanted["way"]]
    np.testing.assert_allclose(found.way[0], mesh.vertices[2 * SIDES])
    assert found.sides.shape == (2, 2)
    on_neck = mesh.bottleneck(2 * SIDES, 3 * SIDES)
    assert on_neck.kind == "end" and on_neck.sides.shape == (0, 2)
    in_faces = mesh.bottleneck((2 * SIDES, (0.2, 0.3, 0.5)), 4 * SIDES)
    assert in_faces.girth <= polygon_length(1) * (1 + 1e-12)


def test_a_profile_is_that_of_the_command(command, model):
    mesh = pygirth.load(model)
    words = (SIDES, 2 * SIDES + 1, "3:0.2,0.3,0.5", "--samples", 17)
    wanted = command("profile", model, *words, as_json=True)["stations"]
    found = mesh.profile(SIDES, 2 * SIDES + 1, (3, (0.2, 0.3, 0.5)), samples=17)
    assert found.distances.tolist() == [one["distance"] for one in wanted]
    assert found.girths.tolist() == [one["girth"] for one in wanted]
    assert found.points.tolist() == [one["point"]["position"] for one in wanted]
    assert len(found) == len(found.kinds) == len(wanted)
    even = mesh.profile(SIDES, 2 * SIDES, samples=5, crossings=False)
    np.testing.assert_allclose(even.distances, np.linspace(0, even.distances[-1], 5))


def test_a_profile_of_a_tube_is_its_perimeter():
    mesh = pygirth.Mesh(*prism(6, length=40.0, rings=41))
    np.testing.assert_allclose(mesh.profile(6 * 15, 6 * 25 + 2).girths, 6, rtol=1e-12)


def test_cuts_are_those_of_the_command(command, model):
    mesh = pygirth.load(model)
    necks = mesh.necks()
    cut = mesh.cut(necks)
    parts = command("cut", model, "--necks", as_json=True)["parts"]
    assert [part.area for part in cut] == [part["area"] for part in parts]
    assert [len(part.faces) for part in cut] == [part["faces"] for part in parts]
    assert [part.boundaries for part in cut] == [part["boundaries"] for part in parts]
    assert [None if np.isnan(part.volume) else part.volume for part in cut] == [
        part["volume"] for part in parts
    ]
    assert sum(len(part.faces) for part in cut) == len(mesh.faces)  # along edges
    for number, part in enumerate(cut):
        assert (cut.labels[part.face_rows] == number).all()
        assert part.genus == 0
    capped = mesh.cut(necks[0], cap=True)
    assert [part.boundaries for part in capped] == [0, 0]
    assert (capped[0].face_rows == -1).sum() == SIDES - 2
    assert pygirth.Mesh(capped[0].vertices, capped[0].faces).report["boundary_edges"] == 0
    # Whatever has a loop can be cut along; it survives being pickled.
    bottleneck = pickle.loads(pickle.dumps(mesh.bottleneck(2 * SIDES, 4 * SIDES)))
    assert [part.area for part in mesh.cut(bottleneck)] == [part.area for part in mesh.cut(necks[0])]
    assert len(mesh.cut(mesh.loop(SIDES))) == 2
    assert len(mesh.cut([])) == 1
    ring = pygirth.Mesh(*torus(12, 8))
    opened = ring.cut(ring.handles()[0])
    assert len(opened) == 1 and opened[0].boundaries == 2 and opened[0].genus == 0


def code_of(call):
    with pytest.raises(pygirth.GirthError) as raised:
        call()
    return raised.value.code


def test_bad_input_is_named():
    vertices, faces = waists()
    mesh = pygirth.Mesh(vertices, faces)
    for value in (-1, np.nan):
        assert code_of(lambda: mesh.necks(min_prominence=value)) == "INVALID_OPTION"
    assert code_of(lambda: mesh.handles(base_points=0)) == "INVALID_OPTION"
    assert code_of(lambda: mesh.bottleneck(0, 10_000)) == "VERTEX_OUT_OF_RANGE"
    assert code_of(lambda: mesh.bottleneck(0, (0, (0.5, 0.5, 0.5)))) == "INVALID_POINT"
    assert code_of(lambda: mesh.profile(0)) == "USAGE"
    assert code_of(lambda: mesh.profile(0, 1, samples=1)) == "INVALID_OPTION"
    assert code_of(lambda: mesh.profile(0, 1, samples=-1)) == "INVALID_OPTION"
    assert code_of(lambda: mesh.profile(0, 1, samples=0, crossings=False)) == "INVALID_OPTION"
    assert code_of(lambda: mesh.cut([3])) == "USAGE"
    two = pygirth.Mesh(np.vstack([vertices, vertices + 50]), np.vstack([faces, faces + len(vertices)]))
    assert code_of(lambda: two.bottleneck(0, len(vertices))) == "INVALID_POINT"
    assert code_of(lambda: two.profile(0, len(vertices))) == "INVALID_POINT"
    # A loop of another mesh.
    other = pygirth.Mesh(*torus())
    assert code_of(lambda: mesh.cut(other.handles()[0])) == "INVALID_POINT"


def test_progress_and_stopping():
    mesh = pygirth.Mesh(*torus())
    shares = []
    mesh.handles(progress=shares.append)
    assert shares == sorted(shares)

    class Stop(Exception):
        pass

    def stop(share):
        raise Stop

    for call in (mesh.necks, mesh.handles):
        with pytest.raises(Stop):
            call(progress=stop)


def test_distances_between_pairs_are_those_of_paths(command, model, tmp_path):
    mesh = pygirth.load(model)
    pairs = [(0, 20), (3, (5, (0.25, 0.25, 0.5)))]
    found = mesh.distances(pairs, paths=True)
    (tmp_path / "pairs.csv").write_text("0,20\n3,5:0.25,0.25,0.5\n")
    wanted = command("distance", model, "--between", tmp_path / "pairs.csv", "--paths", as_json=True)
    assert len(found.distances) == 2
    for pair, one, other in zip(pairs, found.distances, wanted["distances"]):
        path = mesh.path(*pair)
        assert one.length == path.length == other["length"] and one.straight == other["straight"]
        np.testing.assert_array_equal(one.points, path.points)
        assert one.points.tolist() == [point["position"] for point in other["points"]]
        np.testing.assert_array_equal(one.start, mesh.vertices[pair[0]])
    assert not len(mesh.distances(pairs).distances[0].points)
    assert repr(found) == "<pygirth.Distances: 2 distances>"


def test_sections_are_those_of_the_command(command, model, tmp_path):
    mesh = pygirth.load(model)
    low, high = mesh.vertices[:, 0].min(), mesh.vertices[:, 0].max()
    places = [low + 0.4 * (high - low), low + 0.5 * (high - low)]
    found = mesh.sections([1, 0, 0], places, inscribed=True)
    heights = [word for place in places for word in ("--at-height", repr(float(place)))]
    wanted = command("section", model, "--along", "x", "--inscribed", *heights, as_json=True)
    for section, other in zip(found.sections, wanted["sections"]):
        for name in ("offset", "perimeter", "tape", "area"):
            assert getattr(section, name) == other[name]
        for curve, one in zip(section.curves, other["curves"]):
            assert curve.inscribed_diameter == one["inscribedDiameter"] > 0
            assert curve.limb is None
    narrowest = mesh.extreme_section((1, 0, 0), "narrowest", low=places[0], high=places[1], measure="tape")
    within = f"{float(places[0])!r},{float(places[1])!r}"
    words = ("--narrowest", "--within", within, "--by-tape", "--along", "x")
    [other] = command("section", model, *words, as_json=True)["sections"]
    assert narrowest.tape == other["tape"] and narrowest.offset == other["offset"]
    through = mesh.sections_through([20], normal=(1, 0, 0))
    assert through.sections[0].offset == mesh.vertices[20, 0]


def test_tubes_are_those_of_the_command(command, model):
    mesh = pygirth.load(model)
    found = mesh.tubes(ends=[0, 20], spacing=0.05, girth=False)
    mesh_size = float(np.ptp(mesh.vertices, axis=0).max())
    words = ("--ends", "0,20", "--every", "0.05", "--no-girth")
    wanted = command("tube", model, *words, as_json=True)
    assert len(found.stations) == len(wanted["stations"])
    assert [one.reason for one in found.others] == [one["reason"] for one in wanted["others"]]
    for station, one in zip(found.stations, wanted["stations"]):
        assert station.area == one["area"] and station.distance == one["distance"]
        np.testing.assert_array_equal(station.centre, one["centre"])
        assert np.isnan(station.girth) and station.distance < 3 * mesh_size
    with pytest.raises(pygirth.InputError):
        mesh.tubes(reference="both")
    with pytest.raises(pygirth.GirthError):
        mesh.tubes(least_degree=0)


def test_tight_curves_are_those_of_the_command(command, model):
    mesh = pygirth.load(model)
    for closed in (False, True):
        found = mesh.tighten([0, 20, 7, 40], closed=closed)
        words = ("--along", "0,20,7,40", *(("--closed",) if closed else ()))
        wanted = command("tighten", model, *words, as_json=True)
        assert (found.kind, found.promise) == (wanted["kind"], wanted["promise"])
        assert found.length == wanted["length"] <= found.length_before == wanted["lengthBefore"]
        places = [one["position"] for one in wanted["points"]]
        np.testing.assert_array_equal(found.points, np.reshape(places, (-1, 3)))
        assert len(found.pieces) == 1
    stays = mesh.tighten([0, 20, 7], fixed=True)
    assert [one.promise for one in stays.pieces] == ["shortest", "shortest"]
    assert stays.pieces[0].length == pytest.approx(mesh.path(0, 20).length, rel=1e-12)
    assert mesh.tighten([5]).kind == "point"
    with pytest.raises(pygirth.GirthError):
        mesh.tighten([])


def test_measures_at_landmarks_have_their_names(model):
    mesh = pygirth.load(model)
    landmarks = [
        {"name": "loop", "point": 20, "how": "girth"},
        {"name": "way", "point": 0, "how": "distance", "to": 20},
        {"name": "tape", "point": 20, "how": "tape", "across": True},
    ]
    loop, way, tape = mesh.measure_landmarks(landmarks).measures
    assert loop.length == mesh.loop(20).length and way.length == mesh.path(0, 20).length
    assert tape.name == "tape" and tape.how == "tape" and tape.length > 0
    for wrong in ({"name": "a", "point": 0}, {"name": "a", "point": 0, "how": "width"}, 3):
        with pytest.raises(pygirth.InputError):
            mesh.measure_landmarks([wrong])
    with pytest.raises(pygirth.GirthError):
        mesh.measure_landmarks([{"name": "a", "point": 0, "how": "distance"}])
    with pytest.raises(pygirth.InputError):
        mesh.sections([0, 1], [1.0])


def test_the_field_of_distances_is_that_of_geodesics():
    mesh = pygirth.Mesh(*waists())
    sources = [2, (7, (0.5, 0.25, 0.25))]
    for radius in (None, 3.0):
        field = mesh.field("distance", from_=sources, radius=radius)
        wanted = mesh.geodesics(sources, radius=np.inf if radius is None else radius)
        np.testing.assert_array_equal(field.values, wanted.values)
    np.testing.assert_array_equal(mesh.field("distance", from_=3), mesh.geodesics(3))
