"""Threads, progress and stopping."""

import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pygirth
import pytest
from shapes import torus

#: Some tens of seconds of work, so that what is stopped cannot just have ended.
LARGE = "pygirth.Mesh(*torus(400, 160))"


def test_any_number_of_threads_gives_the_same_bits():
    vertices, faces = torus()
    results = [pygirth.Mesh(vertices, faces).igf(threads=threads).values for threads in (1, 2, 5, None)]
    for values in results[1:]:
        assert np.array_equal(values.view(np.uint64), results[0].view(np.uint64))


def test_several_python_threads_at_once_share_a_mesh():
    mesh = pygirth.Mesh(*torus())
    expected = [mesh.loop(v).length for v in range(64)]
    with ThreadPoolExecutor(8) as pool:
        loops = list(pool.map(lambda v: mesh.loop(v).length, list(range(64)) * 4))
        fields = list(pool.map(lambda _: pygirth.Mesh(*torus()).igf(threads=1).values, range(8)))
    assert loops == expected * 4
    for values in fields:
        assert np.array_equal(values, fields[0])


def test_other_python_threads_run_meanwhile():
    mesh = pygirth.Mesh(*torus(80, 40))
    finished = threading.Event()
    turns = 0

    def count():
        nonlocal turns
        while not finished.is_set():
            turns += 1

    worker = threading.Thread(target=count)
    seen = []
    worker.start()
    mesh.igf(threads=1, progress=lambda fraction: seen.append(turns))
    finished.set()
    worker.join()
    # From report to report the other thread has counted on.
    assert len(set(seen)) > 3


def test_progress_rises_to_one():
    seen = []
    pygirth.Mesh(*torus(80, 40)).igf(progress=seen.append)
    assert seen == sorted(seen) and seen[-1] == 1 and len(seen) > 2
    assert all(0 <= fraction <= 1 for fraction in seen)


def test_a_bar_is_filled():
    class Bar:
        total = 50
        n = 0.0

        def update(self, more):
            self.n += more

    bar = Bar()
    pygirth.compare([torus(20, 8), torus(20, 12)], ["igf", "sdf"], progress=bar)
    assert bar.n == pytest.approx(50)


def test_what_progress_raises_stops_the_work():
    class Enough(Exception):
        pass

    calls = []

    def stop(fraction):
        calls.append(fraction)
        raise Enough

    mesh = pygirth.Mesh(*torus(400, 160))
    with pytest.raises(Enough):
        mesh.igf(progress=stop)
    assert len(calls) == 1 and calls[0] < 1


def run_until_interrupted(work):
    """Seconds from Ctrl-C to KeyboardInterrupt in a program that computes."""
    program = f"""
import sys, time
sys.path.insert(0, {str(__file__).rsplit('/', 1)[0]!r})
import pygirth
from shapes import torus
mesh = {LARGE}
print("ready", flush=True)
try:
    {work}
except KeyboardInterrupt:
    print(time.monotonic(), flush=True)
mesh.loop(0)
print("goes on", flush=True)
"""
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "ready\n"
    time.sleep(0.5)
    sent = time.monotonic()
    child.send_signal(signal.SIGINT)
    output = child.stdout.read().split("\n")
    assert child.wait() == 0 and output[1] == "goes on"
    return float(output[0]) - sent


@pytest.mark.parametrize(
    "work",
    [
        "mesh.igf()",
        "mesh.tips()",
        "mesh.field('geofarthest')",
        "mesh.field('wks', pairs=3000)",
        "pygirth.compare([mesh, mesh], ['hks'], faces=0)",
    ],
)
def test_control_c_is_a_keyboard_interrupt(work, record_property):
    record_property("milliseconds", round(1000 * run_until_interrupted(work)))


def test_a_large_mesh_is_prepared_and_let_go_without_a_leak():
    vertices, faces = torus(100, 50)
    before = sys.getrefcount(vertices)
    for _ in range(5):
        mesh = pygirth.Mesh(vertices, faces)
        values = mesh.field("sdf", rays=2).values
        del mesh
    assert np.isfinite(values).all()
    assert sys.getrefcount(vertices) == before
