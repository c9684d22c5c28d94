"""Refusals of `pygirth.show`, and the parts of its page; a browser tests how the page looks."""

import importlib.resources
import re

import numpy as np
import pygirth
import pytest
from shapes import tetrahedron, torus

MESH = pygirth.Mesh(*tetrahedron())


@pytest.mark.parametrize(
    "call, code",
    [
        (lambda: pygirth.show(5), "USAGE"),
        (lambda: pygirth.show(MESH, "beauty"), "INVALID_OPTION"),
        (lambda: pygirth.show(MESH, [1, 2, 3]), "USAGE"),
        (lambda: pygirth.show(MESH, np.ones((4, 2))), "USAGE"),
        (lambda: pygirth.show(MESH, np.array(list("abcd"))), "USAGE"),
        (lambda: pygirth.show(MESH, pygirth.igf(*torus())), "USAGE"),
        (lambda: pygirth.show(torus(), MESH.igf()), "USAGE"),
        (lambda: pygirth.show(pygirth.Mesh(*torus()).field("sihks", pairs=20)), "USAGE"),
        (lambda: pygirth.show(MESH, colormap="rainbow"), "INVALID_OPTION"),
        (lambda: pygirth.show(MESH, range=(2, 1)), "INVALID_OPTION"),
        (lambda: pygirth.show(MESH, range=(0, np.inf)), "INVALID_OPTION"),
        (lambda: pygirth.show(MESH, isolines=101), "INVALID_OPTION"),
        (lambda: pygirth.show(MESH, up="north"), "INVALID_OPTION"),
        (lambda: pygirth.show(MESH, height=3), "INVALID_OPTION"),
        (lambda: pygirth.show(MESH, loops=[4]), "VERTEX_OUT_OF_RANGE"),
        (lambda: pygirth.show(MESH, points=[-1]), "VERTEX_OUT_OF_RANGE"),
    ],
)
def test_what_cannot_be_shown(call, code):
    with pytest.raises(pygirth.InputError) as caught:
        call()
    assert caught.value.code == code and caught.value.hint


def test_a_page_is_whole_and_its_words_are_only_words(tmp_path):
    name = 'a </script><script>alert(1)</script> "x" &'
    shown = pygirth.show(MESH.igf(), name=name, title="<b>'\"</b>")
    assert shown.page.count("<script") == shown.page.count("</script>") == 2
    assert not re.search(r'(src|href)="(?!data:)', shown.page.split("<script")[0])
    assert "alert(1)</script>" not in shown.page and "<b>" not in shown.page.split("<script")[0]
    assert repr(shown).startswith("<pygirth.Shown: a </script>")
    fragment = shown._repr_html_()
    assert fragment.startswith("<iframe srcdoc=") and fragment.count('"') == 6
    shown.save(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text(encoding="utf8") == shown.page
    with pytest.raises(OSError):
        shown.save(tmp_path / "missing/page.html")


def test_without_the_viewer_there_is_one_command_to_have_it(monkeypatch, tmp_path):
    monkeypatch.setattr(importlib.resources, "files", lambda package: tmp_path)
    with pytest.raises(ImportError, match="npm run build:shown && python -m pip install ./cpp/python"):
        pygirth.show(MESH)


def test_the_same_input_gives_the_same_page():
    assert pygirth.show(MESH, "igf").page == pygirth.show(MESH.igf()).page
