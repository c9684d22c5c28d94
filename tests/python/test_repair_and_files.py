"""Print checks, removed handles, maxima, refined meshes, and files: those of the command, to the bit."""

import json
import subprocess

import numpy as np
import pygirth
import pytest
from conftest import COMMAND
from shapes import prism, torus
from test_values import assert_same_bits


def typed(*words, status=0):
    """Runs the command for the file that it writes."""
    done = subprocess.run([str(COMMAND), *map(str, words), "--force"], capture_output=True, text=True)
    assert done.returncode == status, done.stderr


@pytest.fixture
def example(repository):
    return lambda name: repository / f"web/app/public/examples/{name}.glb"


def test_the_print_check_of_the_command(example, tmp_path):
    limits = ["--min-tube", 0.02, "--min-wall", 0.02, "--min-gap", 0.02]
    output = tmp_path / "check.json"
    mesh = pygirth.load(example("hook"))
    check = mesh.print_check(tube_diameter=0.02, wall_thickness=0.02, gap=0.02)
    typed("parts", example("hook"), *limits, "-o", output, status=4)
    theirs = json.loads(output.read_text())
    assert not check.passes and check.passes == theirs["passes"]
    assert_same_bits(check.passing_scale, theirs["passingScale"])
    assert_same_bits(check.failing_share, theirs["failingShare"])
    assert len(check.places) == len(theirs["places"]) > 0
    for place, other in zip(check.places, theirs["places"]):
        assert (place.kind, place.measure) == (other["kind"], other["measure"])
        assert_same_bits([place.least, place.area], [other["least"], other["area"]])
        assert place.vertices.tolist() == other["vertices"]
        assert place.faces.tolist() == other["faces"]
        assert (place.opposite is None) == (place.kind == "tube") == (other["opposite"] is None)
    assert mesh.print_check(tube_diameter=1e-9).passes
    with pytest.raises(pygirth.InputError, match="INVALID_OPTION.*gap"):
        mesh.print_check(gap=-1)


def test_removed_handles_are_those_of_the_command(example, tmp_path):
    mesh = pygirth.load(example("handles"))
    shortest = mesh.handles().lengths.min()
    removal = mesh.remove_handles(1.01 * shortest)
    assert removal.genus_after < removal.genus_before and len(removal.removed) >= 1
    assert removal.removed[0].kind in ("handle", "tunnel")
    assert removal.removed[0].length == shortest
    assert removal.proven_length == 1.01 * shortest and removal.crossing_faces == 0
    path = tmp_path / "repaired.ply"
    typed("remesh", example("handles"), "--remove-handles", repr(1.01 * shortest), "-o", path)
    theirs = pygirth.load(path)
    assert_same_bits(removal.mesh.vertices, theirs.vertices)
    assert np.array_equal(removal.mesh.faces, theirs.faces)
    assert removal.mesh.unit == mesh.unit == "metre"
    assert mesh.remove_handles(0).removed == []
    assert mesh.remove_handles(np.inf).genus_after == 0


def test_maxima_are_vertices_above_all_their_neighbours(example, command):
    mesh = pygirth.load(example("hook"))
    field = mesh.field("sdf")
    found = mesh.maxima(field)
    theirs = command("field", example("hook"), "--field", "sdf", "--maxima", 3, as_json=True)
    for one, other in zip(found, theirs["maxima"]):
        assert one.vertex == other["vertex"]
        assert_same_bits([one.value, one.persistence], [other["value"], other["persistence"]])
    highest = found[0]
    assert highest.value == field.values[highest.vertex] == np.nanmax(field)
    assert highest.saddle == -1 and found[1].persistence <= highest.persistence
    assert [one.vertex for one in mesh.maxima("sdf")] == [one.vertex for one in found]
    least = mesh.maxima(field, minima=True)
    assert least[0].value == np.nanmin(field)
    assert [one.vertex for one in mesh.maxima(-field)] == [one.vertex for one in least]
    with pytest.raises(pygirth.InputError, match="USAGE.*one value for each vertex"):
        mesh.maxima(field.values[1:])


def test_a_subdivided_mesh_has_the_girth_of_the_coarse_one(tmp_path):
    mesh = pygirth.Mesh(*prism(6, length=4.0, rings=5), unit="millimetre")
    fine = mesh.subdivide(200)
    assert len(fine.faces) in (200, 201) and fine.unit == "millimetre"
    assert_same_bits(fine.vertices[: len(mesh.vertices)], mesh.vertices)
    np.testing.assert_allclose(
        fine.igf().values[: len(mesh.vertices)], mesh.igf().values, rtol=1e-9
    )
    assert len(mesh.subdivide(3).faces) == len(mesh.faces)
    mesh.save(tmp_path / "coarse.obj")
    typed("remesh", tmp_path / "coarse.obj", "--subdivide", 200, "-o", tmp_path / "fine.ply")
    assert_same_bits(pygirth.load(tmp_path / "fine.ply").vertices, fine.vertices)
    for wrong in (0, 10**9):
        with pytest.raises(pygirth.InputError, match="INVALID_OPTION"):
            mesh.subdivide(wrong)


@pytest.mark.parametrize("ending", [".obj", ".ply", ".stl", ".off", ".glb"])
def test_a_saved_mesh_is_read_again(ending, tmp_path):
    mesh = pygirth.Mesh(*torus(12, 6), unit="millimetre")
    path = tmp_path / f"torus{ending}"
    mesh.save(path)
    again = pygirth.load(path)
    assert again.unit == ("metre" if ending == ".glb" else "millimetre")
    assert len(again.surface().faces) == len(mesh.faces)
    if ending in (".obj", ".ply", ".off"):
        assert_same_bits(again.vertices, mesh.vertices)
        assert np.array_equal(again.faces, mesh.faces)


@pytest.mark.parametrize("ending", [".csv", ".npy", ".ply", ".glb"])
def test_saved_fields_are_the_bytes_of_the_command(ending, tmp_path, repository):
    model = repository / "tests/data/prism_seams.glb"
    mesh = pygirth.load(model)
    ours, theirs = tmp_path / f"ours{ending}", tmp_path / f"theirs{ending}"
    for field, words in (
        (mesh.igf(), ["igf"]),
        (mesh.igf(persistence=0.25), ["igf", "--persistence", "0.25"]),
        (mesh.igf(method="ms"), ["igf", "--method", "ms"]),
        (mesh.igf(method="refined", audit=5), ["igf", "--method", "refined", "--audit", 5]),
        (mesh.field("sdf", rays=7), ["field", "--field", "sdf", "--rays", 7]),
        (mesh.field("thickness"), ["field", "--field", "thickness"]),
        (mesh.field("geofarthest", exact=True), ["field", "--field", "geofarthest", "--exact"]),
        (mesh.field("hks", pairs=20), ["field", "--field", "hks", "--pairs", 20]),
    ):
        if isinstance(field, pygirth.RefinedGirth) and ending == ".npy":
            continue
        field.save(ours)
        typed(words[0], model, *words[1:], "-o", theirs)
        assert ours.read_bytes() == theirs.read_bytes(), words


def test_several_fields_are_columns_of_one_file(tmp_path):
    mesh = pygirth.Mesh(*torus(12, 6))
    mesh.save(tmp_path / "both.csv", mesh.igf(), mesh.field("sdf"))
    assert (tmp_path / "both.csv").read_text().startswith("vertex,igf,kind,sdf\n0,")
    own = pygirth.Field(mesh, "height", mesh.vertices[:, 2], "")
    own.save(tmp_path / "height.npy")
    assert_same_bits(np.load(tmp_path / "height.npy"), mesh.vertices[:, 2])


def test_files_that_cannot_be_written_say_why(tmp_path):
    mesh = pygirth.Mesh(*torus(12, 6))
    field = mesh.igf()
    for save, code in (
        (lambda: mesh.save(tmp_path / "torus.csv"), "USAGE.*write .obj"),
        (lambda: field.save(tmp_path / "girth.obj"), "USAGE.*use .csv"),
        (lambda: mesh.save(tmp_path / "two.csv", field, field), "USAGE.*is taken"),
        (lambda: mesh.field("sihks").save(tmp_path / "many.csv"), "USAGE.*one value"),
        (lambda: mesh.save(tmp_path / "absent" / "torus.obj"), "FILE_UNWRITABLE"),
    ):
        with pytest.raises(pygirth.InputError, match=code):
            save()
    assert list(tmp_path.iterdir()) == []


def test_a_mended_model_has_the_values_of_its_surface(tmp_path):
    vertices, faces = torus(12, 6)
    faces[5] = faces[5][::-1]
    mesh = pygirth.Mesh(np.vstack([vertices, vertices[:3], [[9, 9, 9]]]), faces)
    mesh.igf().save(tmp_path / "girth.npy")
    assert_same_bits(np.load(tmp_path / "girth.npy"), mesh.igf().values)
