"""Collections: the values of single models, stores that keep them, and exact neighbours."""

import json
import os
import resource
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pygirth
import pytest
from pygirth import collection
from pygirth.collection import _clients, _collection, _search, _store, _tasks
from shapes import as_obj, prism, tetrahedron, torus


@pytest.fixture
def files(tmp_path):
    """Twelve models of four kinds, of which two have the same surface."""
    folder = tmp_path / "models"
    folder.mkdir()
    meshes = [torus(16, 8, 3 + i / 4, 1) for i in range(4)] + [prism(5 + i, 6 + i, 9) for i in range(5)]
    meshes += [tetrahedron(), torus(20, 8), torus(20, 8)]
    paths = [folder / f"{i:02}.obj" for i in range(len(meshes))]
    for path, mesh in zip(paths, meshes):
        path.write_text(as_obj(*mesh))
    return paths


@pytest.fixture
def count(monkeypatch):
    """How many fields of how many models have been computed."""
    calls = []
    compute = pygirth._girth.compared_fields

    def counted(surface, names, *others):
        calls.append(tuple(names))
        return compute(surface, names, *others)

    monkeypatch.setattr(pygirth._girth, "compared_fields", counted)
    return calls


def test_the_fields_and_distances_of_single_models(files):
    models = collection.fields(files, names=["igf", "geofarthest"], faces=0)
    assert (len(models), models.computed, models.failed) == (12, 11, {})
    assert models.models[3] == str(files[3])
    for number in (0, 5, 9):
        mesh = pygirth.load(files[number])
        values, weights = models.values(number, "igf")
        np.testing.assert_allclose(values, mesh.igf().values / np.sqrt(mesh.area), rtol=1e-12)
        np.testing.assert_allclose(weights.sum(), 1, rtol=1e-12)
    single = pygirth.compare(files, ["igf", "geofarthest"], faces=0)
    for name in models.names:
        assert np.array_equal(models.distances(name, block=5), single[name])
    assert models.distances("igf")[10, 11] < 1e-15


def test_a_second_run_computes_nothing(files, tmp_path, count):
    store = tmp_path / "store"
    first = collection.fields(files, store=store, faces=0)
    assert (len(count), first.computed, first.reused) == (11, 11, 1)
    second = collection.fields(files, store=store, faces=0)
    assert (len(count), second.computed, second.reused) == (11, 0, 12)
    assert np.array_equal(first.distances(), second.distances())
    assert np.array_equal(first.values(4, "igf"), second.values(4, "igf"))
    # Another field is added, without the first; other parameters are other fields.
    collection.fields(files, store=store, names=["igf", "sdf"], faces=0)
    assert count[11:] == [("sdf",)] * 11
    collection.fields(files[:2], store=store, faces=100)
    collection.fields(files[:2], store=store, faces=0, smooth=3)
    assert len(count) == 26
    names = sorted(path.name for path in store.iterdir())
    assert len(names) == 5 and names[-1] == "store.json"
    assert not [path for path in store.rglob("*") if path.name.startswith(".")]


def test_what_was_written_before_a_stop_is_kept(files, tmp_path, count, monkeypatch):
    seen = []
    stopped = threading.Event()
    compute = pygirth._girth.compared_fields

    def held(*arguments):
        # On a busy machine all would be computed before the first result is looked at.
        if len(count) >= 7:
            stopped.wait()
        return compute(*arguments)

    monkeypatch.setattr(pygirth._girth, "compared_fields", held)

    def stop(fraction):
        seen.append(fraction)
        if len(seen) == 5:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt), ThreadPoolExecutor(1) as pool:
        options = {"store": tmp_path / "store", "faces": 0, "batch": 1, "save_every": 0}
        try:
            collection.fields(files, client=pool, progress=stop, **options)
        finally:
            stopped.set()
    before = len(count)
    assert 5 <= before < 11
    found = collection.fields(files, store=tmp_path / "store", faces=0)
    assert found.reused >= 5 and found.computed + found.reused == 12
    assert found.failed == {} and np.isfinite(found.distances()).all()


def test_unreadable_models_among_many(files, tmp_path):
    files[3].write_text("It is not a model.\n")
    files[7].unlink()
    files[8].write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")
    given = [*files, (np.zeros((3, 3)), [[0, 1, 2]]), tetrahedron(), 5]
    models = collection.fields(given, store=tmp_path / "store", faces=0)
    codes = {number: error.code for number, error in models.failed.items()}
    assert codes == {
        3: "UNKNOWN_FORMAT", 7: "FILE_NOT_FOUND", 8: "INDEX_OUT_OF_RANGE", 12: "EMPTY_MESH", 14: "USAGE"
    }
    assert models.failed[3].file == str(files[3]) and models.models[13] == "model 13"
    distances = models.distances()
    bad = np.isnan(distances).all(axis=1)
    assert np.flatnonzero(bad).tolist() == [3, 7, 8, 12, 14]
    assert np.isfinite(distances[~bad][:, ~bad]).all()
    with pytest.raises(pygirth.InputError) as caught:
        models.values(3, "igf")
    assert caught.value.code == "UNKNOWN_FORMAT"
    numbers, far, _ = models.nearest(k=12)
    assert (numbers[3] == -1).all() and np.isnan(far[3]).all()
    assert not np.isin(numbers, [3, 7, 8, 12, 14]).any() and (numbers[0, :9] >= 0).all()
    assert numbers[0, 9:].tolist() == [-1, -1, -1]


def test_a_file_that_comes_back_is_tried_again(files, tmp_path, monkeypatch):
    hidden = files[4].rename(tmp_path / "hidden")
    real = _tasks.as_mesh

    def late(model):
        try:
            return real(model)
        except pygirth.GirthError:
            hidden.exists() and hidden.rename(files[4])
            raise

    monkeypatch.setattr(_tasks, "as_mesh", late)
    assert collection.fields(files, faces=0).failed == {}


def as_nobody():
    """Whether this process is one that no file stops, and now is another one."""
    if os.geteuid() == 0:
        os.seteuid(65534)
        return True
    return False


def test_a_read_only_store(files, tmp_path):
    store = tmp_path / "store"
    collection.fields(files[:4], store=store, faces=0)
    folders = [store, *(path for path in store.iterdir() if path.is_dir())]
    for path in [*tmp_path.parents][:-1] + [tmp_path]:
        if path.stat().st_uid == os.getuid():
            path.chmod(path.stat().st_mode | 0o055)
    for folder in folders:
        folder.chmod(0o555)
    was_root = as_nobody()
    try:
        models = collection.fields(files, store=store, faces=0)
        again = collection.fields(files[:4], store=store, faces=0)
    finally:
        if was_root:
            os.seteuid(0)
        for folder in folders:
            folder.chmod(0o755)
    assert (models.computed, models.reused) == (7, 5) and models.failed == {}
    assert models.unsaved.code == "FILE_UNWRITABLE" and "7 models" in models.unsaved.message
    assert models.unsaved.file.startswith(str(store)) and models.unsaved.hint
    assert np.isfinite(models.distances()).all() and len(models.values(11, "igf")[0]) == 160
    # Where there is nothing to write, there is nothing to complain of.
    assert again.unsaved is None and again.computed == 0


def test_a_full_disk(files, tmp_path, count):
    store = tmp_path / "store"
    collection.fields(files[:2], store=store, faces=0)
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2000, hard))
    try:
        models = collection.fields(files, store=store, faces=0)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert models.unsaved.code == "FILE_UNWRITABLE" and "too large" in models.unsaved.message
    assert np.isfinite(models.distances()).all()
    assert len(list(store.rglob("*.npz"))) == 1 and not list(store.rglob("*.part"))
    again = collection.fields(files, store=store, faces=0)
    assert (again.reused, again.unsaved) == (3, None) and len(count) == 2 + 9 + 9


@pytest.mark.parametrize(
    "header, code",
    [
        ('{"format": 2, "program": "9.0.0"}', "UNSUPPORTED_FEATURE"),
        ("{}", "MALFORMED_FILE"),
        ("[]", "MALFORMED_FILE"),
        ("\x00", "MALFORMED_FILE"),
    ],
)
def test_a_store_of_another_program(files, tmp_path, header, code):
    (tmp_path / "store.json").write_text(header)
    with pytest.raises(pygirth.InputError) as caught:
        collection.fields(files, store=tmp_path)
    assert caught.value.code == code and caught.value.file == str(tmp_path / "store.json")
    assert code == "MALFORMED_FILE" or "9.0.0" in caught.value.hint


def test_folders_that_are_no_store(files, tmp_path):
    for path in (files[0], files[0].parent):
        with pytest.raises(pygirth.InputError) as caught:
            collection.fields(files, store=path)
        assert caught.value.file == str(path)


def test_a_folder_in_which_another_program_begins_a_store(files, tmp_path):
    (tmp_path / "store").mkdir()
    (tmp_path / "store/.0123.part").write_text("")
    assert collection.fields(files[:1], store=tmp_path / "store", faces=0).unsaved is None


def test_a_broken_file_of_a_store_is_passed_over_and_computed_again(files, tmp_path):
    store = tmp_path / "store"
    collection.fields(files, store=store, faces=0)
    (path,) = store.rglob("*.npz")
    path.write_bytes(path.read_bytes()[:500])
    with pytest.warns(UserWarning, match="passed over"):
        models = collection.fields(files, store=store, faces=0)
    assert models.computed == 11


def test_other_bytes_in_a_file_of_a_store_are_found_when_they_are_read(files, tmp_path):
    store = tmp_path / "store"
    known = collection.fields(files, store=store, faces=0).distances()
    (path,) = store.rglob("*.npz")
    content = bytearray(path.read_bytes())
    content[content.index(b"weights.npy") + 300] ^= 1
    path.write_bytes(content)
    models = collection.fields(files, store=store, faces=0)
    with pytest.raises(pygirth.InputError) as caught:
        models.distances()
    assert (caught.value.code, caught.value.file) == ("MALFORMED_FILE", str(path))
    assert "delete it" in caught.value.hint
    path.unlink()
    assert np.array_equal(collection.fields(files, store=store, faces=0).distances(), known)


def test_a_store_that_carries_code_does_not_run_it(files, tmp_path):
    store = tmp_path / "store"
    collection.fields(files, store=store, faces=0)
    (path,) = store.rglob("*.npz")

    class Evil:
        def __reduce__(self):
            return (os.mkdir, (str(tmp_path / "ran"),))

    np.savez(path, keys=np.array([Evil()], object), offsets=np.array([0]))
    with pytest.warns(UserWarning, match="passed over"):
        collection.fields(files, store=store, faces=0)
    assert not (tmp_path / "ran").exists()


def test_workers_of_another_version(files, monkeypatch):
    monkeypatch.setattr(_collection._girth, "version", "9.9.9", raising=True)
    with pytest.raises(pygirth.LimitError) as caught:
        monkeypatch.setattr(
            _collection, "_keys_task", lambda _, version, models: _tasks.check_version("1.0.0")
        )
        collection.fields(files)
    assert caught.value.code == "PROGRAM_NOT_LOADED"
    assert "9.9.9" in caught.value.message and "1.0.0" in caught.value.message


@pytest.mark.parametrize(
    "call",
    [
        lambda f: collection.fields(f, names=[]),
        lambda f: collection.fields(f, names=["hks"]),
        lambda f: collection.fields(f, faces=3),
        lambda f: collection.fields(f, batch=0),
        lambda f: collection.fields(f, retries=-1),
        lambda f: collection.fields(f, save_every=-1),
        lambda f: collection.fields(f, save_every=np.nan),
        lambda f: collection.fields(f, client="scheduler:8786"),
        lambda f: collection.fields(str(f[0])),
        lambda f: collection.fields(f, faces=0).distances("sdf"),
        lambda f: collection.fields(f, faces=0).distances(block=0),
        lambda f: collection.fields(f, faces=0).distances(out=np.zeros((3, 3))),
        lambda f: collection.fields(f, faces=0).nearest(k=0),
        lambda f: collection.fields(f, faces=0).nearest(queries=[12]),
        lambda f: collection.fields(f, faces=0).values(12, "igf"),
    ],
)
def test_options_out_of_range(files, call):
    with pytest.raises(pygirth.InputError) as caught:
        call(files)
    assert caught.value.code in pygirth.errors.error_codes and caught.value.hint


def test_an_empty_collection():
    models = collection.fields([])
    assert len(models) == 0 and models.distances().shape == (0, 0)
    assert models.nearest(k=3).numbers.shape == (0, 3)


def random_distributions(count, seed):
    """Distributions with ties, copies, single values and none at all."""
    generator = np.random.default_rng(seed)
    parts = []
    for number in range(count):
        size = int(generator.integers(0 if number % 17 == 5 else 1, 40))
        values = np.round(np.sort(generator.gamma(2, generator.uniform(0.1, 1), size)), 1 + number % 3)
        shares = generator.random(size)
        parts.append((values, shares / shares.sum() if size else shares))
    return parts + parts[:7]


@pytest.mark.parametrize("seed", range(4))
def test_neighbours_are_those_of_the_whole_matrix(seed):
    parts = random_distributions(150, seed)
    all = _collection._joined(parts)
    matrix = _search.block_of(all, all, True)
    assert np.array_equal(matrix, matrix.T, equal_nan=True)
    index = _search.Index(all)
    for query in range(0, len(all), 3):
        for k in (1, 8, 200):
            numbers, distances, compared = index.nearest(query, k)
            order = sorted(
                (distance, number)
                for number, distance in enumerate(matrix[query])
                if number != query and not np.isnan(distance)
            )[:k]
            assert numbers[: len(order)].tolist() == [number for _, number in order]
            assert distances[: len(order)].tolist() == [distance for distance, _ in order]
            assert (numbers[len(order) :] == -1).all()
    # Bounds never exceed the distances.
    bounds = np.abs(index.means[:, None] - index.means[None]).sum(axis=2) / _search.INTERVALS
    known = ~np.isnan(matrix)
    assert (bounds[known] <= matrix[known] * (1 + 1e-12) + 1e-12).all()


def test_neighbours_of_far_more_models_take_few_distances(files):
    generator = np.random.default_rng(3)
    parts = [
        (np.sort(generator.normal(at, 0.1 + at % 0.3, 30)), np.full(30, 1 / 30))
        for at in generator.uniform(0, 10, 2000)
    ]
    index = _search.Index(_collection._joined(parts))
    compared = [index.nearest(query, 5)[2] for query in range(0, 2000, 50)]
    assert np.mean(compared) < 30


def test_neighbours_of_files(files):
    models = collection.fields(files, faces=0)
    matrix = models.distances()
    np.fill_diagonal(matrix, np.inf)
    found = models.nearest(k=4, queries=[0, 10, 5])
    assert found.distances.tolist() == np.sort(matrix[[0, 10, 5]], axis=1)[:, :4].tolist()
    assert found.numbers[1, 0] == 11 and found.distances[1, 0] < 1e-15
    everyone = models.nearest(k=4)
    assert np.array_equal(everyone.numbers[[0, 10, 5]], found.numbers)


def test_work_that_is_left_is_cancelled():
    with ThreadPoolExecutor(1) as pool:
        work = _clients.Work(pool, time.sleep)
        for _ in range(2000):
            work.add(0.01)
        for _ in work:
            break
    # Leaving the pool has waited for what could not be cancelled: far less than all.


@pytest.mark.parametrize("own_pool", [True, False])
def test_what_threads_are_at_is_stopped(files, monkeypatch, own_pool):
    ends = {}
    compute = pygirth._girth.compared_fields

    def watched(surface, *others):
        try:
            result = compute(surface, *others)
            ends[surface.face_count] = "values"
            return result
        except BaseException as error:
            ends[surface.face_count] = type(error).__name__
            raise

    monkeypatch.setattr(pygirth._girth, "compared_fields", watched)

    def stop(fraction):
        raise KeyboardInterrupt

    # Some tens of seconds of work, which the interrupt does not wait for.
    models = [torus(400, 160), files[9]]
    with ThreadPoolExecutor(2) as pool, pytest.raises(KeyboardInterrupt):
        client = None if own_pool else pool
        collection.fields(models, client=client, faces=0, batch=1, progress=stop)
    assert ends == {4: "values", 128000: "_Stopped"}


def test_what_the_documents_say_of_a_store(files, tmp_path):
    collection.fields(files, store=tmp_path / "store")
    assert json.loads((tmp_path / "store/store.json").read_text()) == {
        "format": _store.FORMAT, "program": pygirth.__version__
    }
    (text,) = (tmp_path / "store").rglob("parameters.txt")
    assert "igf" in text.read_text() and "faces 10000" in text.read_text()
    (path,) = (tmp_path / "store").rglob("*.npz")
    with np.load(path) as shard:
        assert set(shard.files) == {"keys", "offsets", "weights", "igf"}
        assert len(shard["igf"]) == len(shard["weights"]) == shard["offsets"][-1]
