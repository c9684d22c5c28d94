"""The build backend tells pip what it needs before anything is compiled, and refuses some Pythons at once."""

import importlib.util
import sys
import sysconfig
import tarfile
import zipfile

import pytest


def backend_of(repository):
    spec = importlib.util.spec_from_file_location(
        "girth_build", repository / "cpp/python/backend/girth_build.py"
    )
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def backend(repository):
    return backend_of(repository)


def test_what_is_needed_is_known_without_compiling(backend, tmp_path):
    name = backend.prepare_metadata_for_build_wheel(str(tmp_path))
    assert [path.name for path in tmp_path.iterdir()] == [name]
    text = (tmp_path / name / "METADATA").read_text()
    assert text.startswith("Metadata-Version: 2.1\nName: pygirth\n") and "Requires-Dist: numpy>=1.21" in text


@pytest.mark.parametrize(
    "version, numpy", [("2.10.3", "numpy>=1.21,<2"), ("2.12.0", "numpy>=1.21"), ("3.0.1", "numpy>=1.21")]
)
def test_the_numpy_that_pybind11_knows(backend, monkeypatch, tmp_path, version, numpy):
    file = tmp_path / "share/cmake/pybind11/pybind11ConfigVersion.cmake"
    file.parent.mkdir(parents=True)
    file.write_text(f'set(PACKAGE_VERSION "{version}")\n')
    monkeypatch.setattr(backend, "PREFIXES", (tmp_path,))
    monkeypatch.setitem(sys.modules, "pybind11", None)
    assert backend._numpy() == numpy
    assert not [one for one in backend.get_requires_for_build_wheel() if "pybind11" in one]
    file.unlink()
    assert "pybind11>=2.12" in backend.get_requires_for_build_wheel()


@pytest.mark.parametrize("said, wanted", [("3.22.1", ["cmake>=3.25"]), ("3.25.1", []), ("4.0.0", [])])
def test_a_cmake_that_is_too_old_is_fetched(backend, monkeypatch, tmp_path, said, wanted):
    program = tmp_path / "cmake"
    program.write_text(f"#!/bin/sh\necho cmake version {said}\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    assert [one for one in backend.get_requires_for_build_wheel() if "cmake" in one] == wanted


def test_a_python_without_headers_is_refused_before_compiling(backend, monkeypatch, tmp_path):
    monkeypatch.setattr(sysconfig, "get_path", lambda name: str(tmp_path))
    monkeypatch.setattr(backend, "_compile", lambda settings: pytest.fail("compiled"))
    for call in (backend.prepare_metadata_for_build_wheel, backend.build_wheel):
        with pytest.raises(SystemExit, match="Python.h is missing.*python3-dev.*/usr/bin/python3"):
            call(str(tmp_path))


def test_the_source_archive_is_a_project_of_its_own(backend, repository, tmp_path):
    name = backend.build_sdist(str(tmp_path))
    assert name == f"pygirth-{backend._version()}.tar.gz"
    data = (tmp_path / name).read_bytes()
    assert backend.build_sdist(str(tmp_path)) == name and (tmp_path / name).read_bytes() == data
    with tarfile.open(tmp_path / name) as archive:
        archive.extractall(tmp_path)
    root = tmp_path / name.removesuffix(".tar.gz")
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted([name, root.name])
    project = (root / "pyproject.toml").read_text()
    assert 'backend-path = ["cpp/python/backend"]' in project and 'name = "pygirth"' in project
    assert (root / "PKG-INFO").read_text().startswith("Metadata-Version: 2.1\nName: pygirth\n")
    # Its own backend knows version, address and metadata without the repository.
    own = backend_of(root)
    assert own.REPOSITORY == root and own._file_of_metadata() == backend._file_of_metadata()
    (tmp_path / "metadata").mkdir()
    own.prepare_metadata_for_build_wheel(str(tmp_path / "metadata"))
    assert own.build_sdist(str(tmp_path / "metadata")) == name
    assert not list(root.rglob("__pycache__")) and not (root / "cpp/cli").exists()
    for folder in ("src", "io", "include", "python/pygirth"):
        ours = sorted(p.name for p in (repository / "cpp" / folder).rglob("*.*") if p.suffix != ".pyc")
        assert ours == sorted(path.name for path in (root / "cpp" / folder).rglob("*.*"))


def test_a_wheel_has_the_package_and_says_how_it_was_made(backend, monkeypatch, tmp_path):
    module = tmp_path / f"_girth{sysconfig.get_config_var('EXT_SUFFIX')}"
    module.write_bytes(b"a module")
    monkeypatch.setattr(backend, "_compile", lambda settings: module)
    name = backend.build_wheel(str(tmp_path))
    with zipfile.ZipFile(tmp_path / name) as wheel:
        names = wheel.namelist()
        record = wheel.read(f"pygirth-{backend._version()}.dist-info/RECORD").decode()
    assert {"pygirth/__init__.py", "pygirth/_girth.pyi", "pygirth/py.typed"} <= set(names)
    assert f"pygirth/{module.name}" in names
    assert [line.split(",")[0] for line in record.splitlines()] == names
