"""The package as it is installed: typed, documented, of one version."""

import ast
import copy
import importlib.metadata
import importlib.resources
import inspect
import json
import re

import pygirth
import pygirth._girth


def test_the_version_is_that_of_the_project(repository):
    version = json.loads((repository / "package.json").read_text())["version"]
    assert pygirth.__version__ == importlib.metadata.version("pygirth") == version


def test_the_metadata_say_what_the_project_file_says(repository):
    project = (repository / "cpp/python/pyproject.toml").read_text()
    metadata = importlib.metadata.metadata("pygirth")
    assert [one for one in importlib.metadata.requires("pygirth") if one.startswith("numpy>=1.21")]
    assert metadata["Summary"] == re.search(r'^description = "(.*)"', project, re.M).group(1)
    citation = (repository / "CITATION.cff").read_text()
    address = re.search(r"^repository-code: *'?([^'\s]+)", citation, re.M)
    assert metadata["Home-page"] == (address[1] if address else "no public address yet, see CITATION.cff")
    # The other lines that `pip show` has.
    assert all(metadata[name] for name in ("Name", "Author", "Author-email", "License"))
    assert metadata["Requires-Python"] == re.search(r'^requires-python = "(.*)"', project, re.M).group(1)


class Stub:
    """Declarations of the stub of the core, written as pybind11 writes them in the first line of a docstring."""

    def __init__(self, text):
        body = ast.parse(text).body
        self.aliases = {node.targets[0].id: node.value for node in body if isinstance(node, ast.Assign)}
        self.values = {node.target.id for node in body if isinstance(node, ast.AnnAssign)}
        self.functions = {node.name: node for node in body if isinstance(node, ast.FunctionDef)}
        self.classes = {
            node.name: {member.name: member for member in node.body}
            for node in body
            if isinstance(node, ast.ClassDef)
        }

    def type_of(self, annotation):
        stub = self

        class Aliases(ast.NodeTransformer):
            def visit_Name(self, node):
                return self.visit(stub.aliases[node.id]) if node.id in stub.aliases else node

        text = ast.unparse(Aliases().visit(copy.deepcopy(annotation)))
        for ours, theirs in {
            r"\bNDArray\[np\.": "numpy.ndarray[numpy.",
            r"\b(tuple)(?=\[)": "Tuple",
            r"\b(Sequence|list)(?=\[)": "List",
            r"\b(Mapping|dict)(?=\[)": "Dict",
            r"\b(Running|Surface)\b": r"pygirth._girth.\1",
            r"Optional\[Callable\[.*": "object",
        }.items():
            text = re.sub(ours, theirs, text)
        return text

    def line_of(self, function, of=None):
        """Such as ``loop(self: pygirth._girth.Surface, arg0: int) -> dict``."""
        given = function.args
        assert not (given.kwonlyargs or given.vararg or given.kwarg or given.defaults), function.name
        places = given.posonlyargs + given.args
        words = [f"self: pygirth._girth.{of}"] if of else []
        for number, argument in enumerate(places[1:] if of else places):
            # An argument without a name cannot be passed by one.
            name = f"arg{number}" if argument in given.posonlyargs else argument.arg
            words.append(f"{name}: {self.type_of(argument.annotation)}")
        return f"{function.name}({', '.join(words)})", self.type_of(function.returns)


def test_the_stub_of_the_core_is_the_core():
    folder = importlib.resources.files("pygirth")
    assert (folder / "py.typed").is_file()
    stub = Stub((folder / "_girth.pyi").read_text())
    core = pygirth._girth
    declared = {*stub.values, *stub.functions, *stub.classes}
    assert declared == {name for name in dir(core) if not name.startswith("__")}

    def check(function, native, of=None):
        line, result = stub.line_of(function, of)
        there, there_result = native.__doc__.split("\n")[0].split(" -> ")
        assert line == there
        # The core says no more than tuple, list or dict of some.
        kinds = {result, re.match(r"[\w.]+", result)[0].lower()}
        assert there_result in kinds, (line, result, there_result)

    for name, function in stub.functions.items():
        check(function, getattr(core, name))
    for of, members in stub.classes.items():
        native = vars(getattr(core, of))
        assert set(members) - {"__init__"} == {name for name in native if not name.startswith("_")}
        for name, member in members.items():
            if isinstance(native[name], property):
                assert [one.id for one in member.decorator_list] == ["property"]
            else:
                check(member, native[name], of)


def test_all_names_that_are_public_are_exported():
    for module in (pygirth.mesh, pygirth.results, pygirth.errors):
        own = {
            name
            for name, value in vars(module).items()
            if not name.startswith("_") and getattr(value, "__module__", "") == module.__name__
        }
        # The module of errors has one function that only the core calls, and one that only the package does.
        assert own - {"exception_of", "input_error"} <= set(module.__all__)
        assert all(hasattr(module, name) for name in module.__all__)
        assert set(module.__all__) - {"Point", "error_codes"} <= set(pygirth.__all__)


def test_everything_public_is_documented_and_annotated():
    def check(name, value):
        assert inspect.getdoc(value), name
        if inspect.isfunction(value):
            signature = inspect.signature(value)
            assert signature.return_annotation is not inspect.Signature.empty, name
            for parameter in list(signature.parameters.values()):
                known = parameter.annotation is not inspect.Parameter.empty
                assert known or parameter.name in ("self", "cls"), f"{name}({parameter.name})"

    public = {name: getattr(pygirth, name) for name in pygirth.__all__}
    public |= {name: getattr(pygirth.collection, name) for name in pygirth.collection.__all__}
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
