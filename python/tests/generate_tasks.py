"""Makes schlupf/_tasks.py of the tasks of the library."""

from __future__ import annotations

import inspect
import json
import re
from pathlib import Path
from textwrap import fill
from typing import Any

import schlupf
from schlupf import _units
from schlupf._fields import CATALOGUE
from schlupf._report import Report

FILE = Path(__file__).parents[1] / "schlupf/_tasks.py"

HEAD = '''"""Tasks.

Made of the tasks of the library by tests/generate.py.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from ._ask import {asked}
from ._report import (
    {results},
)
from ._units import {units}

if TYPE_CHECKING:
    from ._case import Case


class Tasks:
    """What a case can be asked besides its solution."""
'''

#: Types of the fields of each kind, and what the documentation calls them.
TYPES = {
    "flag": ("bool", "bool"),
    "count": ("int", "int"),
    "number": ("Number", "float or str"),
    "numbers": ("Numbers", "float or str, or several"),
    "points": ("Points", "(start, end), array of values or str"),
    "family": ("Family", "mapping of fields to their values"),
    "file": ("File", "path"),
    "table": ("Data", "path or mapping"),
    "surface": ("Surface", "path, array, mapping, or surface of SurfaceTopography or surfalize"),
    "list": ("Texts", "str or sequence of str"),
    "text": ("str", "str"),
}


def is_surface(field: dict[str, Any]) -> bool:
    return any(name == "height" for table in field["columns"] for name, _ in table)


def types(field: dict[str, Any]) -> tuple[str, str]:
    return TYPES["surface" if is_surface(field) else field["kind"]]


def annotation(field: dict[str, Any]) -> str:
    if field["kind"] == "choice":
        return f"Literal[{', '.join(json.dumps(name) for name, _ in field['choices'])}]"
    kind, _ = types(field)
    return f"{kind} | list[{kind}]" if is_list(field) else kind


def is_list(field: dict[str, Any]) -> bool:
    """Whether it is one value or a list of them."""
    return field["is_several"] and field["kind"] != "family"


def default(field: dict[str, Any]) -> str | None:
    """The default as it stands in a signature."""
    if field["is_needed"]:
        return None
    if field["kind"] == "flag":
        return "False"
    text = field["default"]
    if text is None:
        return "None"
    return text if field["kind"] in ("count", "number") else json.dumps(text)


def argument(field: dict[str, Any]) -> str:
    kind, value = annotation(field), default(field)
    if value is None:
        return f"{field['name']}: {kind}"
    return f"{field['name']}: {kind}{' | None' if value == 'None' else ''} = {value}"


def paragraph(text: str, indent: int) -> str:
    margin = " " * indent
    text = re.sub(r"\s+", " ", text).strip()
    return fill(text, 91, initial_indent=margin, subsequent_indent=margin)


def parameter(field: dict[str, Any]) -> list[str]:
    unit = f" Numbers are in {field['units']}." if field["units"] else ""
    columns = (column for table in field["columns"] for column in table)
    columns = ", ".join(f"{name} in {unit}" for name, unit in columns if unit)
    columns = f" Columns of a mapping without a unit: {columns}." if columns else ""
    columns = " Files of instruments are read by `open_surface`." * is_surface(field) + columns
    choices = "; ".join(f'"{name}": {doc}' for name, doc in field["choices"])
    choices = f" ({choices})" if choices else ""
    doc = field["doc"].removesuffix(".") + choices + "." + unit + columns
    if field["kind"] == "choice":
        kind = "{" + ", ".join(f'"{name}"' for name, _ in field["choices"]) + "}"
    else:
        kind = types(field)[1] + (", or several" if is_list(field) else "")
    value = default(field)
    kind += "" if value is None else ", optional" if value == "None" else f", default {value}"
    return [f"{field['name']} : {kind}", paragraph(doc, 4)]


def returned(result: type[Report]) -> list[str]:
    # Without the example.
    doc = (inspect.getdoc(result) or "").partition(">>>")[0].strip()
    return ["Returns", "-------", result.__name__, paragraph(doc, 4), ""]


RAISES = """\
Raises
------
CaseError
    If something is wrong with the case or an argument.
NotConverged
    If the result has not converged; it has the result."""


def alone(task: dict[str, Any]) -> dict[str, Any]:
    """A task as a function about what stands without its name."""
    return task | {"is_of_argument": True}


def documentation(task: dict[str, Any], fields: list[dict[str, Any]]) -> list[str]:
    lines = [paragraph(f'"""{task["about"]}.', 0), "", "Parameters", "----------"]
    for field in fields:
        lines += parameter(field)
    if task["is_of_argument"]:
        lines += ["case : Case, optional", paragraph(f"The case {task['case']}.", 4)]
    lines += [f"strict : bool, default {not task['has_several']}"]
    lines += ["    Whether to raise `NotConverged`; else look at ``converged``."]
    lines += ["warn : bool, default True", "    Whether to issue the warnings of the result.", ""]
    lines += [*returned(result_of(task)), *RAISES.splitlines()]
    if task["sources"]:
        lines += ["", "References", "----------", paragraph(task["sources"], 0)]
    return [*lines, '"""']


def result_of(task: dict[str, Any]) -> type[Report]:
    return Report.OF_TASKS.get(task["name"], Report)


def function(task: dict[str, Any]) -> list[str]:
    """A method of a case, or a function for a task that is about an argument."""
    leads = "is_positional" if task["is_of_argument"] else "is_needed"
    fields = sorted(task["fields"], key=lambda field: not field[leads])
    needed = [argument(field) for field in fields if field[leads]]
    others = [argument(field) for field in fields if not field[leads]]
    others += [f"strict: bool = {not task['has_several']}", "warn: bool = True"]
    result, case = result_of(task).__name__, "case" if task["is_of_argument"] else "self"
    first = [*needed, "case: Case | None = None"] if task["is_of_argument"] else ["self", *needed]
    lines = [f"def {task['function']}("]
    lines += [f"    {each}," for each in (*first, "*", *others)]
    lines += [f") -> {result}:"]
    text = "\n".join(documentation(task, fields))
    lines += [f"    {line}" if line else "" for line in text.splitlines()]
    lines += ["    request: dict[str, object] = {"]
    lines += [f'        "{field["name"]}": {field["name"]},' for field in fields]
    lines += ["    }"]
    if not fields:
        lines[-2:] = ["    request: dict[str, object] = {}"]
    asked = f'{result}, "{task["name"]}", {case}, request'
    return [*lines, f"    return ask({asked}, strict=strict, warn=warn)"]


def indented(lines: list[str], indent: str) -> str:
    text = "\n".join(lines)
    return "\n".join(indent + line if line else "" for line in text.splitlines()) + "\n"


def source() -> str:
    # A case has these itself.
    tasks = [task for task in CATALOGUE["tasks"] if task["function"] not in vars(schlupf.Case)]
    unknown = set(Report.OF_TASKS) - {task["name"] for task in tasks}
    assert not unknown, f"there are no tasks {unknown}"
    text = "\n".join(indented(function(t), "    ") for t in tasks if not t["is_of_argument"])
    about = [task for task in tasks if any(field["is_positional"] for field in task["fields"])]
    text += "".join("\n\n" + indented(function(alone(task)), "") for task in about)
    results = sorted({result_of(task).__name__ for task in tasks})
    types = sorted({kind for kind, _ in TYPES.values() if re.search(rf"\b{kind}\b", text)})
    types = [kind for kind in types if kind[0].isupper()]
    units = [kind for kind in types if kind in vars(_units)]
    asked = [kind for kind in types if kind not in units]
    head = HEAD.replace("{results}", ",\n    ".join(results))
    head = head.replace("{asked}", ", ".join([*asked, "ask"])).replace("{units}", ", ".join(units))
    return f"{head}\n{text}"
