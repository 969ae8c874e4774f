"""Makes schlupf/_tasks.py of the tasks of the library."""

from __future__ import annotations

import json
import re
from pathlib import Path
from textwrap import fill
from typing import Any

from schlupf import _core

FILE = Path(__file__).parents[1] / "schlupf/_tasks.py"

#: What a task gives; its name in Python where that is another one.
RESULTS = {
    "curve": "Curve",
    "roughness": "RoughContact",
    "compare": "Comparison",
    "temperature": "Temperatures",
    "subsurface": "Subsurface",
    "wear": "Wear",
    "bulk": "BulkTemperature",
    "calibrate": "Calibration",
    "fit": "Fit",
    "wheelset": "Wheelset",
}
METHODS = {"bulk": "bulk_temperature"}

#: Those with a status for each of several results.
LENIENT = ("curve", "roughness", "compare")

HEAD = '''"""The methods of a case that ask for more than its solution.

Made of the tasks of the library by tests/generate_tasks.py.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from ._ask import Asking
from ._report import (
    {results},
)

if TYPE_CHECKING:
    from ._ask import Data, Family, Number, Range, Texts


class Tasks(Asking):
    """What a case can be asked besides its solution."""
'''

#: What the documentation calls them.
KINDS = {
    "Number": "float or str",
    "Range": "(float, float) or str",
    "Family": "mapping",
    "Data": "path or mapping",
    "Data | list[Data]": "path, or several",
    "Texts": "str or float",
}

TYPES = {
    "flag": "bool",
    "count": "int",
    "number": "Number",
    "range": "Range",
    "family": "Family",
    "file": "Data",
    "text": "Texts",
}


def annotation(field: dict[str, Any]) -> str:
    if field["kind"] == "choice":
        return f"Literal[{', '.join(json.dumps(name) for name, _ in field['choices'])}]"
    kind = TYPES[field["kind"]]
    return f"{kind} | list[{kind}]" if field["is_several"] and kind == "Data" else kind


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


def parameter(field: dict[str, Any]) -> list[str]:
    unit = f" Numbers are in {field['units']}." if field["units"] else ""
    choices = "; ".join(f'"{name}": {doc}' for name, doc in field["choices"])
    choices = f" ({choices})" if choices else ""
    doc = re.sub(r"\s+", " ", field["doc"])
    doc = doc.removesuffix(".") + choices + "." + unit
    optional = ", optional" if default(field) is not None else ""
    kind = KINDS.get(annotation(field), annotation(field))
    if field["kind"] == "choice":
        kind = "{" + ", ".join(f'"{name}"' for name, _ in field["choices"]) + "}"
    head = f"        {field['name']} : {kind}{optional}"
    return [head, fill(doc, 99, initial_indent=" " * 12, subsequent_indent=" " * 12)]


def method(task: dict[str, Any]) -> str:
    name, result = task["name"], RESULTS[task["name"]]
    needed = [field for field in task["fields"] if field["is_needed"]]
    others = [field for field in task["fields"] if not field["is_needed"]]
    lines = [f"    def {METHODS.get(name, name)}(", "        self,"]
    lines += [f"        {argument(field)}," for field in needed]
    lines += ["        *,"]
    lines += [f"        {argument(field)}," for field in others]
    strict = name not in LENIENT
    lines += [f"        strict: bool = {strict},", "        warn: bool = True,"]
    lines += [f"    ) -> {result}:"]
    about = fill(f'"""{task["about"]}.', 99, initial_indent=" " * 8, subsequent_indent=" " * 8)
    lines += [about, ""]
    lines += ["        Parameters", "        ----------"]
    for field in needed + others:
        lines += parameter(field)
    lines += [f"        strict : bool, default {strict}"]
    lines += ["            Whether to raise `NotConverged`; else look at ``converged``."]
    lines += ["        warn : bool, default True"]
    lines += ["            Whether to issue the warnings of the result.", ""]
    lines += ["        Raises", "        ------", "        CaseError"]
    lines += ["            If something is wrong with the case or an argument."]
    lines += ["        NotConverged"]
    lines += ["            If the result has not converged; the exception has it."]
    if task["sources"]:
        lines += ["", "        References", "        ----------"]
        lines += [fill(task["sources"], 99, initial_indent=" " * 8, subsequent_indent=" " * 8)]
    lines += ['        """', "        request: dict[str, object] = {"]
    lines += [f'            "{field["name"]}": {field["name"]},' for field in needed + others]
    lines += ["        }"]
    if not task["fields"]:
        lines[-2:] = ["        request: dict[str, object] = {}"]
    lines += [f'        return self._ask({result}, "{name}", request, strict=strict, warn=warn)']
    return "\n".join(lines) + "\n"


def source() -> str:
    tasks = [task for task in _core.tasks() if task["name"] in RESULTS]
    head = HEAD.replace("{results}", ",\n    ".join(sorted(RESULTS.values())))
    return head + "\n" + "\n".join(map(method, tasks))


if __name__ == "__main__":
    FILE.write_text(source(), encoding="utf-8")
