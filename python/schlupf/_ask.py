"""How a task is asked: arguments in units of the library, and what comes back."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from . import _core
from ._fields import FIELDS
from ._tables import csv
from ._units import plain

if TYPE_CHECKING:
    from ._case import Case
    from ._fields import Field
    from ._report import Report

R = TypeVar("R", bound="Report")

#: A number in SI units, or text with its unit, or a quantity of pint.
Number = Any
#: Start and end.
Range = tuple[Number, Number] | str
#: Text, or several that belong together.
Texts = str | Number | Sequence[str]
#: A field of the case by its dotted path, and its values.
Family = Mapping[str, Sequence[Any]]
#: A path; where columns of numbers are read, they may be given by name (mapping, data frame).
Data = str | PathLike[str] | Mapping[str, Any]

#: The fields that columns of measured points are like.
COLUMNS = {
    "creepage_x": "kinematics.creepage_x",
    "creepage_y": "kinematics.creepage_y",
    "spin": "kinematics.spin",
    "speed": "kinematics.speed",
    "load": "normal.load",
}


class _Argument:
    """A field of a request, as far as units are concerned."""

    def __init__(self, field: dict[str, Any]) -> None:
        self.units: str = field["units"]
        self.kind: str = field["kind"]


_ARGUMENTS = {
    task["name"]: {field["name"]: _Argument(field) for field in task["fields"]}
    for task in _core.tasks()
}


def _converted(argument: Any, name: str, value: Any) -> Any:
    """A value without quantities of pint, data frames and mappings."""
    if argument.kind == "file":
        return _file(value)
    if isinstance(value, (list, tuple)):
        return [_converted(argument, name, part) for part in value]
    value = plain(value, argument, name)
    return value.tolist() if hasattr(value, "tolist") else value


def _file(value: Any) -> Any:
    if value is None:
        return None
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if isinstance(value, (list, tuple)):
        return [_file(part) for part in value]
    fields: dict[str, Field] = {name: FIELDS[path] for name, path in COLUMNS.items()}
    return "arrays", csv(value, fields)


def run(
    name: str,
    case: _core.CaseFile | None,
    request: Mapping[str, Any],
    files: Sequence[tuple[str, Path]] = (),
) -> _core.Report:
    """What a task finds for what it is asked."""
    arguments = _ARGUMENTS[name]
    values = {key: _converted(arguments[key], key, value) for key, value in request.items()}
    return _core.run(name, case, values, files=list(files))


class Asking:
    """Whatever can be asked for more than its solution."""

    _file: _core.CaseFile

    def _ask(
        self, result: type[R], name: str, request: Mapping[str, Any], *, strict: bool, warn: bool
    ) -> R:
        case: Case = self  # type: ignore[assignment]
        request, own = result._prepared(case, dict(request))
        report = run(name, case._file, request, result._files(case))
        found = result._new(report, warn=warn, strict=strict, depth=4)
        found._finish(case, own)
        return found
