"""Random arrays, right and wrong in many ways: each pair ends in values or in a coded error, never in a crash."""

import os

import numpy as np
import pygirth
import pytest

# 10,000 in `npm run test:all`, where the module carries sanitizers.
COUNT = int(os.environ.get("GIRTH_RANDOM_ARRAYS", 300))
# A crash ends the program: its test's name then says among which arrays the cause is.
BATCH = 500

TYPES = [np.float64, np.float32, np.float16, np.int64, np.int32, np.int8, np.uint64, np.uint8, bool, complex]
ODD = [np.nan, np.inf, -np.inf, 0.0, -0.0, 1e308, -1e308, 5e-324, 2.0**63, -(2.0**63), 2.0**32, 1e-160]


def shape_of(generator, rows):
    """Mostly (rows, 3)."""
    choice = generator.integers(12)
    if choice == 0:
        return tuple(generator.integers(0, 5, generator.integers(0, 4)).tolist())
    return (rows, int(generator.integers(0, 6))) if choice == 1 else (rows, 3)


def layout_of(generator, array):
    """An array with the same numbers, lying otherwise in memory."""
    choice = generator.integers(6)
    if choice == 0:
        return np.asfortranarray(array)
    if choice == 1 and array.ndim:
        return np.repeat(array, 2, axis=0)[::2]
    if choice == 2 and array.ndim:
        return array[::-1]
    if choice == 3:
        return array.astype(array.dtype.newbyteorder())
    if choice == 4 and array.ndim:
        array.flags.writeable = False
    return array


def arrays_of(generator):
    """Vertices and faces: of nothing, of noise, and of surfaces with a few wrong numbers."""
    corners, count = int(generator.integers(0, 14)), int(generator.integers(0, 24))
    vertices = generator.normal(size=shape_of(generator, corners))
    if generator.random() < 0.3:
        vertices = np.round(vertices)
    faces = generator.integers(0, max(1, corners), shape_of(generator, count))
    if generator.random() < 0.5 and corners > 3:
        # A closed surface: a double cone.
        ring = np.arange(corners - 2)
        after = np.roll(ring, -1)
        top, bottom = np.full(len(ring), corners - 2), np.full(len(ring), corners - 1)
        faces = np.vstack([np.stack([ring, after, top], 1), np.stack([after, ring, bottom], 1)])
    if vertices.size and generator.random() < 0.3:
        vertices.flat[generator.integers(vertices.size, size=2)] = generator.choice(ODD, 2)
    if faces.size and generator.random() < 0.3:
        wrong = generator.choice([-1, corners, 2**31, 2**32 - 1, 2**32, 2**63 - 1, -(2**63)])
        faces.flat[generator.integers(faces.size)] = wrong
    with np.errstate(all="ignore"):
        if generator.random() < 0.2:
            vertices = vertices.astype(TYPES[generator.integers(len(TYPES))])
        if generator.random() < 0.2:
            faces = faces.astype(TYPES[generator.integers(len(TYPES))])
    return layout_of(generator, vertices), layout_of(generator, faces)


def is_even(mesh):
    """Whether no edge is more than 10,000 times as long as another: distances take windows in that proportion."""
    corners = mesh.vertices[mesh.faces]
    lengths = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    return lengths.max() < 1e4 * lengths.min()


@pytest.mark.parametrize("begin", range(0, COUNT, BATCH))
def test_random_arrays(begin):
    ends = {"values": 0}
    count = min(BATCH, COUNT - begin)
    for number in range(begin, begin + count):
        generator = np.random.default_rng(number)
        vertices, faces = arrays_of(generator)
        options = {}
        if generator.random() < 0.3:
            options["weld"] = float(generator.choice([0, 1e-9, 0.5, 100]))
            options["close_holes"] = bool(generator.integers(2))
        try:
            mesh = pygirth.Mesh(vertices, faces, **options)
            field = mesh.igf(threads=1)
            assert field.values.shape == field.kinds.shape == (len(mesh.vertices),)
            used = field.kinds != 255
            assert (field.values[used] >= 0).all() and np.isnan(field.values[~used]).all(), number
            mesh.loop(int(np.flatnonzero(used)[0]))
            if is_even(mesh):
                mesh.geodesics(int(np.flatnonzero(used)[-1]))
                mesh.tips(threads=1)
            mesh.field("sdf", rays=3, threads=1)
            ends["values"] += 1
        except pygirth.GirthError as error:
            assert error.code in pygirth.errors.error_codes and error.code != "INTERNAL", (number, error)
            ends[error.code] = ends.get(error.code, 0) + 1
    # The arrays are as different as they are meant to be.
    assert sum(ends.values()) == count and ends["values"] > count / 8 and len(ends) >= 5, ends
    for code in ("USAGE", "EMPTY_MESH", "INDEX_OUT_OF_RANGE", "NON_FINITE_POSITION"):
        assert ends[code] > count / 500, ends
