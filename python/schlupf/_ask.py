"""How a task is asked: arguments in units of the library, and what comes back."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from . import _core
from ._tables import csv
from ._units import File, Number, Series, plain
from .sections import FieldPath

if TYPE_CHECKING:
    from ._report import Report

R = TypeVar("R", bound="Report")

#: A number, or several.
Numbers = Number | Series
#: Start and end.
Range = tuple[Number, Number] | str
#: Text, or several that belong together.
Texts = str | Sequence[str]
#: A field of the case by its dotted path, and its values.
Family = Mapping[FieldPath, Sequence[Any] | Series]
#: A path, or columns of numbers by name (mapping, data frame).
Data = File | Mapping[str, Any]


@dataclass(frozen=True)
class Argument:
    """A field of a request, or a column of its table, as far as units are concerned."""

    units: str
    kind: str = "number"
    columns: dict[str, Argument] = field(default_factory=dict)

    @classmethod
    def of(cls, entry: dict[str, Any]) -> Argument:
        """That of a field as the library describes it."""
        columns = {name: cls(units) for name, units in entry["columns"]}
        return cls(entry["units"], entry["kind"], columns)


#: By task and name.
ARGUMENTS = {
    task["name"]: {entry["name"]: Argument.of(entry) for entry in task["fields"]}
    for task in _core.tasks()
}


def _converted(argument: Argument, name: str, value: Any) -> Any:
    """A value without quantities of pint, data frames and mappings."""
    if value is None or isinstance(value, (str, os.PathLike)):
        return value
    if isinstance(value, (list, tuple)):
        return [_converted(argument, name, part) for part in value]
    if argument.columns:
        return "arrays", csv(value, argument.columns)
    value = plain(value, argument, name)
    return value.tolist() if hasattr(value, "tolist") else value


def ask(
    result: type[R], name: str, case: Any, request: dict[str, Any], *, strict: bool, warn: bool
) -> R:
    """What a task finds for what it is asked of a case (`None`: that of the task)."""
    arguments = ARGUMENTS[name]
    families = {
        key: [case._family(*entry) for entry in (request[key] or {}).items()]
        for key, argument in arguments.items()
        if argument.kind == "family"
    }
    request |= {key: [text for text, _, _ in family] for key, family in families.items()}
    values = {key: _converted(arguments[key], key, value) for key, value in request.items()}
    file, folder = (None, Path()) if case is None else (case._file, case._folder)
    report = _core.run(name, file, folder, values)
    found = result._new(report, warn=warn, strict=strict, depth=4)
    found._finish(case, {key: [entry[1:] for entry in family] for key, family in families.items()})
    return found
