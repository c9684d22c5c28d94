"""The programs in the documents run, each in a process of its own, on the built-in examples; but what needs a cluster."""

import re
import shutil
import subprocess
import sys

import pytest

import shapes
from conftest import REPOSITORY

DOCUMENTS = REPOSITORY / "web/docs"


def programs():
    """Each ```python block, named by its document."""
    for document in [REPOSITORY / "README.md", *sorted(DOCUMENTS.rglob("*.md"))]:
        blocks = re.findall(r"^```python\n(.*?)^```$", document.read_text(), re.M | re.S)
        for number, block in enumerate(blocks, 1):
            if "from distributed import" in block:
                continue
            yield pytest.param(block, id=f"{document.relative_to(REPOSITORY)}, {number}")


@pytest.mark.parametrize("program", programs())
def test_program_of_a_document(program, tmp_path):
    for model in (REPOSITORY / "web/app/public/examples").glob("*.glb"):
        shutil.copy(model, tmp_path)
    (tmp_path / "models").mkdir()
    for size in range(1, 13):
        text = shapes.as_obj(*shapes.prism(length=size, rings=5))
        (tmp_path / "models" / f"{size}.obj").write_text(text)
    # A file, as programs that start processes are.
    (tmp_path / "program.py").write_text(program)
    done = subprocess.run([sys.executable, "program.py"], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip()


def test_there_are_programs():
    assert len(list(programs())) >= 5
