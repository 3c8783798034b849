"""The stub of the extension against the extension: names, and the parameters of each function in their order."""
import ast
import pathlib
import re
import unittest

import honeycomb
from honeycomb import _honeycomb

STUB = ast.parse((pathlib.Path(honeycomb.__file__).parent / "_honeycomb.pyi").read_text(encoding="utf-8"))
# What pybind11 gives every class, and Python every module.
USUAL = {"__doc__", "__module__", "__name__", "__package__", "__loader__", "__spec__", "__file__"}


def names(thing):
    """What a module or class has of its own: nothing of what is inherited, or that only says there is no constructor."""
    own = {name for name in vars(thing) if name not in USUAL}
    made = vars(thing).get("__init__")
    return own if made and (made.__doc__ or "").startswith("__init__(self: ") else own - {"__init__"}


def declared(body):
    """Names of a stub's body with their nodes."""
    found = {}
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            found[node.name] = node
        elif isinstance(node, ast.AnnAssign):
            found[node.target.id] = node
    return found


def parameters(node):
    arguments = node.args
    listed = [argument.arg for argument in arguments.args]
    if arguments.kwonlyargs:
        listed += ["*"] + [argument.arg for argument in arguments.kwonlyargs]
    listed += ["**" + arguments.kwarg.arg] if arguments.kwarg else []
    return [name for name in listed if name != "self"]


def parameters_of(function):
    """Of the signature that pybind11 writes into the first line of the text."""
    inside = re.match(r"\w+\((.*)\) ->", function.__doc__).group(1)
    listed = re.findall(r"(?:^|, )(\*{0,2}\w+|\*)(?=[,:=]|$)", inside)
    return [name for name in listed if name not in ("self", "cls")]


class Stub(unittest.TestCase):
    def compare(self, where, own, nodes):
        self.assertEqual(own, set(nodes), where)
        for name, node in nodes.items():
            if isinstance(node, ast.FunctionDef) and not node.decorator_list:
                thing = where.__dict__[name]
                theirs = parameters_of(getattr(thing, "__func__", thing))
                # Some have no names in C++: self alone, or self called otherwise.
                self.assertEqual([p for p in theirs if not re.match(r"arg\d", p)], parameters(node), f"{where} {name}")

    def test_is_the_extension(self):
        nodes = declared(STUB.body)
        self.compare(_honeycomb, names(_honeycomb), nodes)
        for name, node in nodes.items():
            if isinstance(node, ast.ClassDef):
                own = getattr(_honeycomb, name)
                self.compare(own, names(own), declared(node.body))

    def test_marks_properties_as_such(self):
        for node in STUB.body:
            if isinstance(node, ast.ClassDef):
                for member in node.body:
                    if isinstance(member, ast.FunctionDef):
                        own = vars(getattr(_honeycomb, node.name))[member.name]
                        stubbed = [decorator.id for decorator in member.decorator_list]
                        self.assertEqual(isinstance(own, property), stubbed == ["property"], f"{node.name}.{member.name}")

    def test_everything_public_is_documented(self):
        for name in set(honeycomb.__all__) - {"__version__"}:
            lines = (getattr(honeycomb, name).__doc__ or "").splitlines()
            # The first line of a function of pybind11 is its signature.
            self.assertTrue([line for line in lines if line and not line.startswith(name + "(")], name)

    def test_package_says_it_has_types(self):
        self.assertTrue((pathlib.Path(honeycomb.__file__).parent / "py.typed").exists())


if __name__ == "__main__":
    unittest.main()
