"""Small meshes whose girth is known, drawn by their formulas."""

import numpy as np


def grid_faces(rows, columns, wraps_rows=False):
    """Triangles of a grid of vertices whose columns wrap round."""
    faces = []
    for i in range(rows if wraps_rows else rows - 1):
        for j in range(columns):
            a, b = i * columns + j, i * columns + (j + 1) % columns
            c, d = (a + columns) % (rows * columns), (b + columns) % (rows * columns)
            faces += [(a, b, d), (a, d, c)]
    return np.array(faces)


def prism(sides=6, length=10.0, rings=21):
    """An open tube over a regular polygon with sides of length 1: its girth is `sides` midway."""
    angles = 2 * np.pi * np.arange(sides) / sides
    radius = 0.5 / np.sin(np.pi / sides)
    ring = np.stack([radius * np.cos(angles), radius * np.sin(angles)], axis=1)
    heights = np.linspace(0, length, rings)
    vertices = np.array([(x, y, z) for z in heights for x, y in ring])
    return vertices, grid_faces(rings, sides)


def lathe(rings, sides):
    """A closed surface of revolution: regular polygons at heights, with radii to their corners."""
    angles = 2 * np.pi * np.arange(sides) / sides
    vertices = [(r * np.cos(a), r * np.sin(a), z) for z, r in rings for a in angles]
    faces = grid_faces(len(rings), sides).tolist()
    bottom, last = len(vertices), (len(rings) - 1) * sides
    for j in range(sides):
        k = (j + 1) % sides
        faces += [(bottom, k, j), (bottom + 1, last + j, last + k)]
    ends = [(0, 0, rings[0][0]), (0, 0, rings[-1][0])]
    return np.array(vertices + ends, float), np.array(faces)


def torus(rows=40, columns=16, large=3.0, small=1.0):
    """A torus: loops around its tube are the shortest."""
    u = 2 * np.pi * np.arange(rows)[:, None] / rows
    v = 2 * np.pi * np.arange(columns)[None, :] / columns
    x = (large + small * np.cos(v)) * np.cos(u)
    y = (large + small * np.cos(v)) * np.sin(u)
    z = np.broadcast_to(small * np.sin(v), x.shape)
    vertices = np.stack([x, y, z], axis=2).reshape(-1, 3)
    return vertices, grid_faces(rows, columns, wraps_rows=True)[:, ::-1]


def tetrahedron():
    """A regular tetrahedron with edges of length 1."""
    vertices = np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]) / np.sqrt(8)
    return vertices, np.array([(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)])


def limbed_body(limbs=8, rows=48, columns=96):
    """A ball with long limbs around its equator, like an octopus."""
    theta = np.linspace(0.04, np.pi - 0.04, rows)[:, None]
    phi = 2 * np.pi * np.arange(columns)[None, :] / columns
    bumps = np.maximum(0, np.cos(limbs * phi)) ** 6 * np.exp(-(((theta - np.pi / 2) / 0.3) ** 2))
    radius = 1 + 2.5 * bumps
    x = radius * np.sin(theta) * np.cos(phi)
    y = radius * np.sin(theta) * np.sin(phi)
    z = np.broadcast_to(np.cos(theta), x.shape) * 0.8
    body = np.stack([x, y, z], axis=2).reshape(-1, 3)
    faces = grid_faces(rows, columns).tolist()
    poles = np.array([(0, 0, 0.8), (0, 0, -0.8)])
    north, last = len(body), (rows - 1) * columns
    for j in range(columns):
        k = (j + 1) % columns
        faces += [(north, k, j), (north + 1, last + j, last + k)]
    return np.vstack([body, poles]), np.array(faces)[:, ::-1]


def as_obj(vertices, faces):
    """The text of an OBJ with the same bits."""
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in np.asarray(vertices).tolist()]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in np.asarray(faces).tolist()]
    return "\n".join(lines) + "\n"
