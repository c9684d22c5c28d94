"""The workflow of Snakemake, on ten models."""

import csv
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
from pygirth import collection
from shapes import as_obj, prism, torus


def test_the_workflow_on_ten_models(tmp_path, repository):
    (tmp_path / "models/more").mkdir(parents=True)
    for i in range(9):
        mesh = torus(20, 10, 3 + i / 3) if i % 2 else prism(4 + i, 6)
        (tmp_path / f"models/{'more/' if i > 5 else ''}{i}.obj").write_text(as_obj(*mesh))
    (tmp_path / "models/bad.ply").write_text("nothing")

    def run():
        command = [sys.executable, "-m", "snakemake", "--cores", "2"]
        command += ["--snakefile", repository / "cpp/python/examples/Snakefile"]
        command += ["--config", "faces=0", "parts=3"]
        environment = {**os.environ, "HOME": str(tmp_path), "XDG_CACHE_HOME": str(tmp_path)}
        done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return done.stderr

    run()
    files = (tmp_path / "results/models.txt").read_text().splitlines()
    assert len(files) == 10
    bad = [Path(file).name for file in files].index("bad.ply")
    models = collection.fields(files, store=tmp_path / "results/store", faces=0)
    assert models.computed == 0 and list(models.failed) == [bad]
    assert np.array_equal(np.load(tmp_path / "results/igf.npy"), models.distances(), equal_nan=True)
    with open(tmp_path / "results/igf.csv", encoding="utf8", newline="") as file:
        assert {row["file"] for row in csv.DictReader(file)} == set(files) - {files[bad]}
    assert "Nothing to be done" in run()
