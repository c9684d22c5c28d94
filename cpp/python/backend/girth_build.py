"""The build backend (PEP 517): CMake compiles the module, the standard library makes the wheel.

Settings, as in ``pip install --config-settings build-dir=build/native ./cpp/python``:

build-dir
    A build tree of the repository, kept between builds. Default: ``build/python-cp311`` and so on.
"""

from __future__ import annotations

import base64
import gzip
import hashlib
import io
import json
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import zipfile
from pathlib import Path

CMAKE = (3, 25)

#: The viewer of `pygirth.show`, and its page; made by `npm run build:shown`, where there is Node.js.
VIEWER = tuple(Path(f"build/shown/girth-shown.{ending}") for ending in ("html", "js"))

PACKAGE = Path(__file__).resolve().parent.parent
REPOSITORY = PACKAGE.parent.parent
TAG = f"cp{sys.version_info[0]}{sys.version_info[1]}"

#: Where systems have what CMake finds.
PREFIXES = tuple(Path(prefix) for prefix in ("/usr", "/usr/local", "/opt/homebrew", sys.prefix))

METADATA = """\
Metadata-Version: 2.1
Name: pygirth
Version: {version}
Summary: The intrinsic girth function of triangle meshes: exact values and shortest geodesic loops
Home-page: {address}
Author: The Girth authors
Author-email: none yet
License: MIT
Requires-Python: >=3.9
Requires-Dist: {numpy}
Provides-Extra: collection
Requires-Dist: distributed; extra == 'collection'
Provides-Extra: pyvista
Requires-Dist: pyvista; extra == 'pyvista'
"""


def _version() -> str:
    return json.loads((REPOSITORY / "package.json").read_text(encoding="utf8"))["version"]


def _address() -> str:
    """The project's address on the web, which CITATION.cff has once there is one."""
    citation = (REPOSITORY / "CITATION.cff").read_text(encoding="utf8")
    found = re.search(r"^repository-code: *'?([^'\s]+)", citation, re.M)
    return found[1] if found else "no public address yet, see CITATION.cff"


def _pybind11_of_the_system() -> tuple[int, int] | None:
    """Version of the pybind11 that CMake finds on the system, as Debian's pybind11-dev puts it there."""
    for folder in PREFIXES:
        for place in ("share", "lib"):
            file = folder / place / "cmake/pybind11/pybind11ConfigVersion.cmake"
            found = file.exists() and re.search(r'VERSION "(\d+)\.(\d+)', file.read_text())
            if found:
                return int(found[1]), int(found[2])
    return None


def get_requires_for_build_wheel(config_settings: dict | None = None) -> list[str]:
    """Packages that pip is to fetch before: none that the system has."""
    wanted = [] if _pybind11_of_the_system() else ["pybind11>=2.12"]
    wanted += [] if _has_cmake() else [f"cmake>={CMAKE[0]}.{CMAKE[1]}"]
    return wanted + ([] if shutil.which("ninja") else ["ninja"])


def _has_cmake() -> bool:
    """Whether there is a CMake, and one that is new enough."""
    program = shutil.which("cmake")
    if program is None:
        return False
    said = subprocess.run([program, "--version"], capture_output=True, text=True).stdout
    found = re.search(r"version (\d+)\.(\d+)", said)
    return found is not None and (int(found[1]), int(found[2])) >= CMAKE


def _check_python() -> None:
    """Checks that this Python can have modules compiled for it, before the minutes that compiling takes."""
    header = Path(sysconfig.get_path("include")) / "Python.h"
    if not header.exists():
        number = f"{sys.version_info[0]}.{sys.version_info[1]}"
        raise SystemExit(
            f"pygirth: Python {number} ({sys.executable}) has no headers ({header} is missing): on Debian "
            "install python3-dev and use /usr/bin/python3; otherwise use a Python that has them"
        )


def _pybind11_folder() -> list[str]:
    """Where pip has put pybind11, if it has."""
    try:
        import pybind11
    except ImportError:
        return []
    return [f"-Dpybind11_DIR={pybind11.get_cmake_dir()}"]


def _numpy() -> str:
    """Which NumPy the module works with: arrays of NumPy 2 are laid out as pybind11 knows since 2.12."""
    try:
        import pybind11
    except ImportError:
        version = _pybind11_of_the_system() or (2, 12)
    else:
        version = pybind11.version_info[:2]
    return "numpy>=1.21" if version >= (2, 12) else "numpy>=1.21,<2"


def _file_of_metadata() -> bytes:
    return METADATA.format(version=_version(), address=_address(), numpy=_numpy()).encode()


def prepare_metadata_for_build_wheel(
    metadata_directory: str, config_settings: dict | None = None
) -> str:
    """Writes what the wheel will need, so that pip finds out at once if it cannot be had; the folder's name."""
    _check_python()
    name = f"pygirth-{_version()}.dist-info"
    folder = Path(metadata_directory) / name
    folder.mkdir()
    (folder / "METADATA").write_bytes(_file_of_metadata())
    return name


def _compile(settings: dict) -> Path:
    """Compiles the module and returns its file."""
    tree = Path(settings.get("build-dir") or f"build/python-{TAG}")
    tree = tree if tree.is_absolute() else REPOSITORY / tree
    options = ["-DGIRTH_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}"]
    if not (tree / "CMakeCache.txt").exists():
        options += ["-G", "Ninja", "-DGIRTH_BUILD_TESTS=OFF", "-DGIRTH_BUILD_BENCHMARKS=OFF"]
        options += ["-DGIRTH_BUILD_COMMAND=OFF", "-DCMAKE_BUILD_TYPE=Release"]
        if shutil.which("ccache"):
            options.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    command = ["cmake", "-S", REPOSITORY, "-B", tree, *options, *_pybind11_folder()]
    subprocess.run(command, check=True)
    build = ["cmake", "--build", tree, "--target", "girth_python"]
    subprocess.run([*build, "--parallel", str(os.cpu_count() or 1)], check=True)
    return tree / "python" / f"_girth{sysconfig.get_config_var('EXT_SUFFIX')}"


def _files(module: Path) -> dict[str, bytes]:
    """Files of the package, by their places in the wheel."""
    content = {
        path.relative_to(PACKAGE).as_posix(): path.read_bytes()
        for path in sorted((PACKAGE / "pygirth").rglob("*"))
        if path.is_file() and path.suffix in (".py", ".pyi", ".typed")
    }
    content[f"pygirth/{module.name}"] = module.read_bytes()
    for viewer in (REPOSITORY / path for path in VIEWER):
        if viewer.exists():
            content[f"pygirth/{viewer.name}"] = viewer.read_bytes()
    return content


def build_wheel(
    wheel_directory: str,
    config_settings: dict | None = None,
    metadata_directory: str | None = None,
) -> str:
    """Makes the wheel and returns its name."""
    _check_python()
    version = _version()
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    tag = f"{TAG}-{TAG}-{platform}"
    folder = f"pygirth-{version}.dist-info"
    content = _files(_compile(config_settings or {}))
    content[f"{folder}/LICENSE"] = (REPOSITORY / "LICENSE").read_bytes()
    content[f"{folder}/METADATA"] = _file_of_metadata()
    wheel = f"Wheel-Version: 1.0\nGenerator: girth_build\nRoot-Is-Purelib: false\nTag: {tag}\n"
    content[f"{folder}/WHEEL"] = wheel.encode()
    record = ""
    for name, data in content.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(data)}\n"
    content[f"{folder}/RECORD"] = f"{record}{folder}/RECORD,,\n".encode()
    name = f"pygirth-{version}-{tag}.whl"
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, data in content.items():
            # A fixed date: the same files always make the same wheel.
            entry = zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0))
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
    return name


#: All that a wheel is made of, besides the viewer: files and folders of the repository.
SOURCES = (
    *("CMakeLists.txt", "CHANGELOG.md", "CITATION.cff", "LICENSE", "package.json"),
    *(f"cpp/{name}" for name in ("cmake", "include", "src", "io", "study", "python")),
)


def _sources() -> dict[str, bytes]:
    """The files of the source archive, by their paths."""
    paths = [*map(Path, SOURCES), *(path for path in VIEWER if (REPOSITORY / path).exists())]
    files = (REPOSITORY / path for path in paths)
    found = (one for file in files for one in (file.rglob("*") if file.is_dir() else [file]))
    content = {
        path.relative_to(REPOSITORY).as_posix(): path.read_bytes()
        for path in sorted(found)
        if path.is_file() and "__pycache__" not in path.parts
    }
    project = content["cpp/python/pyproject.toml"].decode()
    here = project.replace('backend-path = ["backend"]', 'backend-path = ["cpp/python/backend"]')
    return {**content, "pyproject.toml": here.encode(), "PKG-INFO": _file_of_metadata()}


def build_sdist(sdist_directory: str, config_settings: dict | None = None) -> str:
    """Makes the archive of the sources, of which pip makes a wheel as of the repository; its name."""
    folder = f"pygirth-{_version()}"
    name = f"{folder}.tar.gz"
    with open(Path(sdist_directory) / name, "wb") as file:
        # A fixed date: the same files always make the same archive.
        with gzip.GzipFile(filename="", mode="wb", fileobj=file, mtime=0) as packed:
            with tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
                for path, data in sorted(_sources().items()):
                    entry = tarfile.TarInfo(f"{folder}/{path}")
                    entry.size = len(data)
                    archive.addfile(entry, io.BytesIO(data))
    return name


def get_requires_for_build_sdist(config_settings: dict | None = None) -> list[str]:
    """Packages that pip is to fetch before: none."""
    return []
