"""The cost of a collection: time, memory and bytes a model, from files to 100 queries.

    build/python/environment/bin/python tests/bench/collections.py FOLDER [MODELS]

makes MODELS models (default: 10,000) of 500 faces in FOLDER, unless they are there, and prints the
costs as JSON. Times are those of the processor, summed over all cores.
"""

import json
import os
import resource
import sys
import time
from pathlib import Path

import numpy as np
from pygirth import collection

ROWS, COLUMNS = 10, 25
FAMILIES = 100


def sphere_faces():
    """500 triangles: rings of vertices between two poles."""
    faces = []
    for i in range(ROWS - 1):
        for j in range(COLUMNS):
            k = (j + 1) % COLUMNS
            a, b = i * COLUMNS + j, i * COLUMNS + k
            faces += [(a, a + COLUMNS, b), (b, a + COLUMNS, b + COLUMNS)]
    north, south, last = ROWS * COLUMNS, ROWS * COLUMNS + 1, (ROWS - 1) * COLUMNS
    for j in range(COLUMNS):
        k = (j + 1) % COLUMNS
        faces += [(north, j, k), (south, last + k, last + j)]
    return np.array(faces)


FACES = sphere_faces()


def model(number):
    """A body with limbs, its family by the number, twisted, bent and made uneven by chance."""
    family = np.random.default_rng(number % FAMILIES)
    chance = np.random.default_rng([number, 1])
    theta = np.pi * (np.arange(ROWS) + 0.5)[:, None] / ROWS
    phi = 2 * np.pi * np.arange(COLUMNS)[None, :] / COLUMNS
    radius = np.ones((ROWS, COLUMNS))
    for _ in range(int(family.integers(2, 6))):
        at, around, width, height = family.uniform([0.4, 0, 0.25, 0.3], [2.7, 6.3, 0.6, 1.6])
        away = np.angle(np.exp(1j * (phi - around))) * np.sin(theta)
        radius += height * np.exp(-((theta - at) ** 2 + away**2) / width**2)
    stretch = family.uniform(0.6, 2.5)
    points = np.stack(
        [
            radius * np.sin(theta) * np.cos(phi),
            radius * np.sin(theta) * np.sin(phi),
            stretch * radius * np.cos(theta),
        ],
        axis=2,
    ).reshape(-1, 3)
    ends = points.reshape(ROWS, COLUMNS, 3)[[0, -1]].mean(axis=1)
    points = np.vstack([points, ends])
    # Twisted about z, then bent in the plane of x and z.
    angle = chance.uniform(-0.4, 0.4) * points[:, 2]
    points[:, :2] = np.stack(
        [
            points[:, 0] * np.cos(angle) - points[:, 1] * np.sin(angle),
            points[:, 0] * np.sin(angle) + points[:, 1] * np.cos(angle),
        ],
        axis=1,
    )
    bend = chance.uniform(-0.15, 0.15)
    angle = bend * points[:, 2]
    points[:, 0], points[:, 2] = (
        points[:, 0] * np.cos(angle) + points[:, 2] * np.sin(angle),
        points[:, 2] * np.cos(angle) - points[:, 0] * np.sin(angle),
    )
    return points + chance.normal(0, 0.01, points.shape), FACES


def write_ply(path, points, faces):
    """Binary PLY."""
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
        "property double x\nproperty double y\nproperty double z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    rows = np.zeros(len(faces), [("count", "u1"), ("corners", "<i4", 3)])
    rows["count"], rows["corners"] = 3, faces
    path.write_bytes(header.encode() + points.astype("<f8").tobytes() + rows.tobytes())


def cost(work):
    """Seconds of processor and of the clock, and what it gives."""
    begun, clock = time.process_time(), time.monotonic()
    result = work()
    return result, time.process_time() - begun, time.monotonic() - clock


def main(folder, count):
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / f"{number:07}.ply" for number in range(count)]
    for number, file in enumerate(files):
        if not file.exists():
            write_ply(file, *model(number))
    store = folder / "store"
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    models, seconds, clock = cost(lambda: collection.fields(files, store=store, faces=0))
    known, again, _ = cost(lambda: collection.fields(files, store=store, faces=0))
    _, read, _ = cost(lambda: known.nearest(k=10, queries=[0]))
    queries = list(range(0, count, max(1, count // 100)))[:100]
    found, search, _ = cost(lambda: known.nearest(k=10, queries=queries))
    size = min(count, 512)
    some = collection.fields(files[:size], store=store, faces=0)
    some.nearest(k=1, queries=[0])
    _, block, _ = cost(some.distances)
    same = np.array(queries)[:, None] % FAMILIES == found.numbers % FAMILIES
    stored = sum(path.stat().st_size for path in store.rglob("*.npz"))
    print(
        json.dumps(
            {
                "models": count,
                "failed": len(models.failed),
                "computed now": models.computed,
                "fields, ms a model": 1e3 * seconds / models.computed if models.computed else None,
                "on the clock, s": clock,
                "found again, ms a model": 1e3 * again / count,
                "reading and index, ms a model": 1e3 * read / count,
                "query, ms": 1e3 * search / len(queries),
                "distances a query": found.compared / len(queries),
                "of the same family, %": 100 * same.mean(),
                "block of 512, us a distance": 1e6 * block / (size * (size + 1) / 2),
                "bytes a model in the store": stored / count,
                "bytes a model as a file": sum(file.stat().st_size for file in files) / count,
                "memory before, MB": before / 1e3,
                "memory at most, MB": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3,
                "cores": os.cpu_count(),
            },
            indent=2,
        )
    )


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 10_000)
