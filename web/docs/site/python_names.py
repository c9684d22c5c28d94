"""Prints the public names of the Python package as JSON, with signatures and docstrings, read from its sources."""

import ast
import inspect
import json
import sys
from pathlib import Path

PACKAGE = Path(sys.argv[1])


def trees():
    return {path.stem: ast.parse(path.read_text("utf8")) for path in PACKAGE.rglob("*.py")}


def classes_and_functions(modules):
    kinds = (ast.ClassDef, ast.FunctionDef)
    # Classes of results inherit their docstrings from classes in _members, most of them of the same name.
    ordered = sorted(modules.items(), key=lambda item: item[0] == "_members", reverse=True)
    return {
        (name == "_members", node.name): node
        for name, tree in ordered
        for node in tree.body
        if isinstance(node, kinds)
    }


def base_of(node, known):
    for base in getattr(node, "bases", []):
        if isinstance(base, ast.Attribute) and base.value.id == "_members":
            return known[(True, base.attr)]
    return known.get((True, node.name))


def docstring(node, known):
    own = ast.get_docstring(node)
    base = base_of(node, known)
    inherited = ast.get_docstring(base) if base else None
    if own or not isinstance(node, ast.ClassDef):
        return own or ""
    for statement in node.body:
        if isinstance(statement, ast.Assign) and statement.targets[0].id == "__doc__":
            pieces = statement.value.values
            raw = ast.get_docstring(base, clean=False)
            texts = [piece.value if isinstance(piece, ast.Constant) else raw for piece in pieces]
            return inspect.cleandoc("".join(texts))
    return inherited or ""


def signature(node):
    arguments = ast.unparse(node.args)
    for first in ("self, ", "cls, ", "self", "cls"):
        if arguments.startswith(first):
            arguments = arguments[len(first):].removeprefix("/, ")
            break
    result = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    return f"({arguments}){result}"


def decorated(node, name):
    return any(isinstance(one, ast.Name) and one.id == name for one in node.decorator_list)


def described(name, node, known):
    one = {"name": name, "doc": docstring(node, known)}
    if isinstance(node, ast.FunctionDef):
        one["signature"] = "" if decorated(node, "property") else signature(node)
    return one


def public(tree):
    for node in tree.body:
        if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "__all__":
            return [element.value for element in node.value.elts]
    return []


def main():
    modules = trees()
    known = classes_and_functions(modules)
    sources = [("pygirth", PACKAGE / "__init__.py"), ("pygirth.collection", PACKAGE / "collection/__init__.py")]
    found = []
    for module, source in sources:
        for name in public(ast.parse(source.read_text("utf8"))):
            node = known.get((False, name))
            if node is None:
                continue
            found.append(described(f"{module}.{name}", node, known))
            for member in node.body if isinstance(node, ast.ClassDef) else []:
                if isinstance(member, ast.FunctionDef) and not member.name.startswith("_"):
                    found.append(described(f"{name}.{member.name}", member, known))
    json.dump(found, sys.stdout)


main()
