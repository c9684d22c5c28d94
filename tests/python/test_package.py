"""The package as it is installed: typed, documented, of one version."""

import importlib.metadata
import importlib.resources
import inspect
import json
import re

import girth
import girth._girth


def test_the_version_is_that_of_the_project(repository):
    version = json.loads((repository / "package.json").read_text())["version"]
    assert girth.__version__ == importlib.metadata.version("girth") == version


def test_the_metadata_say_what_the_project_file_says(repository):
    project = (repository / "cpp/python/pyproject.toml").read_text()
    metadata = importlib.metadata.metadata("girth")
    dependencies = re.search(r'^dependencies = \["(.*)"\]', project, re.M).group(1)
    assert dependencies in importlib.metadata.requires("girth")
    assert metadata["Summary"] == re.search(r'^description = "(.*)"', project, re.M).group(1)
    assert metadata["Requires-Python"] == re.search(r'^requires-python = "(.*)"', project, re.M).group(1)


def test_the_package_is_typed():
    folder = importlib.resources.files("girth")
    assert (folder / "py.typed").is_file()
    stub = (folder / "_girth.pyi").read_text()
    declared = set(re.findall(r"^(?:def|class) (\w+)|^(\w+):", stub, re.M))
    names = {one or other for one, other in declared}
    assert names == {name for name in dir(girth._girth) if not name.startswith("__")}
    methods = set(re.findall(r"^    def (\w+)", stub, re.M)) - {"__init__"}
    native = girth._girth.Surface.__dict__ | girth._girth.Running.__dict__
    assert methods == {name for name in native if not name.startswith("_")}


def test_everything_public_is_documented_and_annotated():
    def check(name, value):
        assert inspect.getdoc(value), name
        if inspect.isfunction(value):
            signature = inspect.signature(value)
            assert signature.return_annotation is not inspect.Signature.empty, name
            for parameter in list(signature.parameters.values()):
                known = parameter.annotation is not inspect.Parameter.empty
                assert known or parameter.name in ("self", "cls"), f"{name}({parameter.name})"

    public = {name: getattr(girth, name) for name in girth.__all__}
    public |= {name: getattr(girth.collection, name) for name in girth.collection.__all__}
    for name, value in public.items():
        if inspect.ismodule(value) or isinstance(value, (dict, tuple)):
            continue
        check(name, value)
        if inspect.isclass(value):
            for member, content in vars(value).items():
                if not member.startswith("_"):
                    content = getattr(content, "fget", content)
                    if inspect.isfunction(content):
                        check(f"{name}.{member}", content)
