"""``python -m pygirth.collection``: the same results from a shell, in shares."""

import csv
import errno
import os
import signal
import subprocess
import sys
import time

import numpy as np
import pygirth
import pytest
from pygirth import collection
from pygirth.collection import __main__ as command
from pygirth.collection import _store
from shapes import as_obj, prism, torus


@pytest.fixture
def listed(tmp_path):
    """A list of six models in the folder 'models', one of which is none."""
    (tmp_path / "models").mkdir()
    names = [f"models/{i}, é.obj" for i in range(6)]
    for i, name in enumerate(names):
        (tmp_path / name).write_text(as_obj(*prism(4 + i, 5, 6)))
    (tmp_path / names[4]).write_text("nothing\n")
    path = tmp_path / "list.txt"
    path.write_text("".join(f"{name}\n" for name in names) + "\n", encoding="utf8")
    return path


def test_shares_and_what_is_made_of_them(listed, tmp_path, capsys):
    store = str(tmp_path / "store")
    codes = [
        command.run(["fields", str(listed), "--store", store, "--faces", "0", "--part", f"{i}/3"])
        for i in (1, 2, 3)
    ]
    assert codes == [0, 2, 0]
    said = capsys.readouterr()
    assert "4, é.obj: UNKNOWN_FORMAT" in said.err
    assert said.out.splitlines()[1] == "2 models: 1 computed, 0 found in the store, 1 failed"
    outputs = [tmp_path / "igf.npy", tmp_path / "igf.csv"]
    for what, output in zip(("matrix", "nearest"), outputs):
        words = [what, str(listed), "--store", store, "--faces", "0", "-o", str(output)]
        assert command.run(words + (["-k", "2"] if what == "nearest" else [])) == 2
        assert "0 computed, 5 found" in capsys.readouterr().out
    models = [tmp_path / line for line in listed.read_text(encoding="utf8").splitlines() if line]
    alone = collection.fields(models, faces=0)
    assert np.array_equal(np.load(outputs[0]), alone.distances(), equal_nan=True)
    rows = list(csv.DictReader(outputs[1].open(encoding="utf8", newline="")))
    found = alone.nearest(k=2)
    assert len(rows) == 10
    assert [float(row["distance"]) for row in rows if row["file"] == str(models[5])] == (
        found.distances[5].tolist()
    )
    assert rows[0]["neighbour"] == str(models[found.numbers[0, 0]])


@pytest.mark.parametrize(
    "change, code",
    [
        ({"--store": "list.txt"}, 2),
        ({"list": "missing.txt"}, 2),
        ({"--names": "beauty"}, 1),
        ({"--faces": "3"}, 1),
        ({"--jobs": "-1"}, 1),
    ],
)
def test_wrong_words(listed, tmp_path, monkeypatch, capsys, change, code):
    monkeypatch.chdir(tmp_path)
    words = {"list": "list.txt", "--store": "store", "--names": "igf", "--faces": "0", "--jobs": "1", **change}
    listed_as = words.pop("list")
    assert command.run(["fields", listed_as, *(w for pair in words.items() for w in pair)]) == code
    assert capsys.readouterr().err.strip()


@pytest.mark.parametrize("part", ["0/3", "4/3", "1", "x/y"])
def test_parts_that_there_are_not(listed, part, capsys):
    with pytest.raises(SystemExit):
        command.run(["fields", str(listed), "--store", "store", "--part", part])
    assert "3/40" in capsys.readouterr().err


def test_an_output_that_cannot_be_written(listed, tmp_path, capsys):
    output = tmp_path / "missing/igf.npy"
    words = ["matrix", str(listed), "--store", str(tmp_path / "store"), "--faces", "0"]
    assert command.run([*words, "-o", str(output)]) == 2
    assert "FILE_UNWRITABLE" in capsys.readouterr().err


def test_a_full_disk_keeps_the_store_and_not_the_answer(listed, tmp_path, capsys, monkeypatch):
    def full(path, content):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))

    monkeypatch.setattr(_store, "_write_whole", full)
    words = [str(listed), "--store", str(tmp_path / "store"), "--faces", "0"]
    assert command.run(["fields", *words]) == 2
    said = capsys.readouterr()
    assert "FILE_UNWRITABLE" in said.err and "No space left" in said.err and "make room" in said.err
    assert "6 models: 5 computed, 0 found in the store, 1 failed" in said.out
    # The matrix that was asked for goes elsewhere, and is written.
    assert command.run(["matrix", *words, "-o", str(tmp_path / "igf.npy")]) == 2
    assert "No space left" in capsys.readouterr().err
    matrix = np.load(tmp_path / "igf.npy")
    assert np.isnan(matrix[4]).all() and np.isfinite(np.delete(np.delete(matrix, 4, 0), 4, 1)).all()
    monkeypatch.undo()
    assert command.run(["fields", *words]) == 2
    assert "5 computed, 0 found" in capsys.readouterr().out
    assert command.run(["fields", *words]) == 2
    assert "0 computed, 5 found" in capsys.readouterr().out


def test_what_a_scheduler_stops_is_written(tmp_path):
    paths = [tmp_path / f"{i}.obj" for i in range(200)]
    for i, path in enumerate(paths):
        path.write_text(as_obj(*torus(30, 12, 3 + i / 100)))
    (tmp_path / "list.txt").write_text("".join(f"{path.name}\n" for path in paths))
    words = ["fields", tmp_path / "list.txt", "--store", tmp_path / "store", "--faces", "0"]
    child = subprocess.Popen(
        [sys.executable, "-m", "pygirth.collection", *words, "--jobs", "1", "--save-every", "0"], stderr=subprocess.PIPE, text=True
    )
    while not list((tmp_path / "store").rglob("*.npz")) and child.poll() is None:
        time.sleep(0.05)
    child.send_signal(signal.SIGTERM)
    assert "stopped" in child.communicate()[1] and child.returncode == 3
    shards = list((tmp_path / "store").rglob("*.npz"))
    kept = sum(len(np.load(path)["keys"]) for path in shards)
    assert 0 < kept < 200
    assert pygirth.collection.fields(paths, store=tmp_path / "store", faces=0).reused == kept
