"""Collections on a cluster of Dask: a scheduler and workers, each a process of its own."""

import os
import subprocess
import sys
from collections import Counter, defaultdict
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pygirth
import pytest
from distributed import Client
from pygirth import collection
from shapes import as_obj, tetrahedron, torus

HERE = Path(__file__).parent


class Cluster:
    def __init__(self, folder):
        self.file = folder / "scheduler.json"
        self.log = folder / "computed.log"
        self.processes = []
        self._start("scheduler", "--port", "0", "--no-dashboard", "--host", "127.0.0.1")

    def _start(self, what, *options, **environment):
        command = [sys.executable, "-m", f"distributed.cli.dask_{what}"]
        process = subprocess.Popen(
            [*command, "--scheduler-file", self.file, *options],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            cwd=self.file.parent,
            env={
                **os.environ,
                "GIRTH_TEST_LOG": str(self.log),
                "DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "1",
                **environment,
            },
        )
        self.processes.append(process)
        return process

    def worker(self, *options, **environment):
        options = ("--nthreads", "1", "--no-dashboard", "--preload", HERE / "watched_worker.py", *options)
        return self._start("worker", *options, **environment)

    def computed(self):
        """The processes that have begun to compute each model, by its area."""
        begun = defaultdict(list)
        for line in self.log.read_text().splitlines() if self.log.exists() else ():
            process, area = line.split()
            begun[area].append(int(process))
        return begun


@contextmanager
def cluster_in(folder):
    cluster = Cluster(folder)
    try:
        with Client(scheduler_file=str(cluster.file), timeout=60) as client:
            yield cluster, client
    finally:
        for process in cluster.processes[::-1]:
            process.terminate()
        for process in cluster.processes:
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()


@pytest.fixture
def files(tmp_path):
    """Ninety models of which none is like another, of some 50 ms each."""
    paths = [tmp_path / f"{i:02}.obj" for i in range(90)]
    for i, path in enumerate(paths):
        path.write_text(as_obj(*torus(36, 14, 3 + i / 50)))
    return paths


def test_a_worker_is_killed_and_another_comes(files, tmp_path):
    with cluster_in(tmp_path) as (cluster, client):
        workers = [cluster.worker("--no-nanny") for _ in range(3)]
        client.wait_for_workers(3, timeout=120)
        added = []

        def watch(fraction):
            if fraction > 0.25 and workers[0].poll() is None:
                workers[0].kill()
                workers[0].wait()
            if fraction > 0.4 and not added:
                added.append(cluster.worker("--no-nanny"))
                client.wait_for_workers(3, timeout=120)

        store = tmp_path / "store"
        models = collection.fields(files, client=client, store=store, faces=0, progress=watch)
        assert models.failed == {} and models.computed == 90
        begun = cluster.computed()
        assert len(begun) == 90
        # Only what was lost with the worker that was killed is computed again.
        again = {area: processes for area, processes in begun.items() if len(processes) > 1}
        for processes in again.values():
            assert processes[0] == workers[0].pid and len(processes) == 2
        shares = Counter(process for processes in begun.values() for process in processes)
        assert set(shares) == {worker.pid for worker in workers + added}

        # A second run computes nothing, whoever is there.
        cluster.log.unlink()
        second = collection.fields(files, client=client, store=store, faces=0)
        assert (second.computed, second.reused) == (0, 90) and not cluster.log.exists()

        # Nothing is lost, and the bits are those of one process.
        alone = pygirth.compare(files, ["igf"], faces=0)["igf"]
        assert np.array_equal(models.distances(client=client, block=20), alone)
        assert np.array_equal(second.distances(), alone)
        here, there = models.nearest(k=5), second.nearest(k=5, client=client)
        assert np.array_equal(here.numbers, there.numbers)
        assert np.array_equal(here.distances, there.distances)


def test_a_model_that_kills_its_workers_fails_alone(files, tmp_path):
    deadly = tmp_path / "deadly.obj"
    deadly.write_text(as_obj(*tetrahedron()))
    files[3].write_text("It is not a model.\n")
    with cluster_in(tmp_path) as (cluster, client):
        for _ in range(2):
            cluster.worker("--nanny", GIRTH_TEST_DEADLY="4")
        client.wait_for_workers(2, timeout=120)
        models = collection.fields(
            [*files[:12], deadly], client=client, store=tmp_path / "store", faces=0, retries=1
        )
    codes = {number: error.code for number, error in models.failed.items()}
    assert codes == {3: "UNKNOWN_FORMAT", 12: "INTERNAL"}
    assert "lost with its worker" in models.failed[12].message
    known = [number for number in range(12) if number != 3]
    assert np.isfinite(models.distances()[np.ix_(known, known)]).all()


def test_a_worker_of_another_version(files, tmp_path):
    with cluster_in(tmp_path) as (cluster, client):
        cluster.worker("--no-nanny", GIRTH_TEST_VERSION="0.0.7")
        client.wait_for_workers(1, timeout=120)
        with pytest.raises(pygirth.LimitError) as caught:
            collection.fields(files, client=client)
    assert caught.value.code == "PROGRAM_NOT_LOADED"
    assert "0.0.7" in caught.value.message and pygirth.__version__ in caught.value.message
