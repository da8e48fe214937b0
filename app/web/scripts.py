"""The scripts of the page: the modules in ``static/js/`` are written as browsers load them, and sent view by view.

A view has up to fifteen modules, and a browser beside two busy workers has one file much sooner than fifteen
(``python -m benchmarks.page``). Of the language, this needs no more than how the modules are written.
"""

import re
from functools import cache
from pathlib import Path

MODULES = Path(__file__).parent / "static" / "js"
IMPORT = re.compile(r'^import (\{.*\}) from "\./(\w[\w-]*)\.js";$', re.MULTILINE)
EXPORT = re.compile(r"^export (?=(?:const|class) ([\w$]+))", re.MULTILINE)


def script(view: str) -> str:
    """What a view needs, in one file: each module is a function's body, after those that it imports from."""
    return "\n".join(map(_body, dict.fromkeys([*_ordered("page"), *_ordered(view)])))


def needs(view: str, module: str) -> bool:
    """Whether a view's script has some module."""
    return module in _ordered(view)


@cache
def _text(name: str) -> str:
    return (MODULES / f"{name}.js").read_text()


@cache
def _ordered(name: str) -> list[str]:
    needed = (each for _, module in IMPORT.findall(_text(name)) for each in _ordered(module))
    return list(dict.fromkeys([*needed, name]))


@cache
def _body(name: str) -> str:
    exported = ", ".join(EXPORT.findall(_text(name)))
    text = EXPORT.sub("", IMPORT.sub(lambda found: f"const {found[1]} = {_variable(found[2])};", _text(name)))
    return f"const {_variable(name)} = (() => {{ // {name}.js\n{text}return {{ {exported} }};\n}})();\n"


def _variable(name: str) -> str:
    return "$" + name.replace("-", "_")
