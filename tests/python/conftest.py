"""Fixtures of all tests of the Python package."""

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

REPOSITORY = Path(__file__).resolve().parent.parent.parent
COMMAND = REPOSITORY / os.environ.get("GIRTH_COMMAND", "build/native/cpp/cli/girth")


@pytest.fixture
def repository():
    return REPOSITORY


@pytest.fixture
def command(tmp_path):
    """Runs the native command; with `output` it is that file's array, with `json` the object."""

    def run(*words, output=None, as_json=False):
        arguments = [str(COMMAND), *map(str, words)]
        path = tmp_path / f"command{output}" if output else None
        if path:
            arguments += ["-o", str(path), "--force"]
        if as_json:
            arguments.append("--json")
        done = subprocess.run(arguments, check=True, capture_output=True, text=True)
        if path and output == ".npy":
            return np.load(path)
        return json.loads(path.read_text() if path else done.stdout)

    return run
