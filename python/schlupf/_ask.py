"""How a task is asked: arguments in units of the library, and what comes back."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from . import _core
from ._errors import described, quoted
from ._fields import CATALOGUE
from ._files import are_rows, in_place
from ._units import Number, Series, in_array, plain, refused
from .sections import FieldPath

if TYPE_CHECKING:
    from ._report import Report

R = TypeVar("R", bound="Report")

#: A number, or several.
Numbers = Number | Series
#: Start and end (a tuple), or each point.
Points = tuple[Number, Number] | str | Series
#: Text, or several that belong together.
Texts = str | Sequence[str]
#: A field of the case by its dotted path, and its values.
Family = Mapping[FieldPath, Sequence[Any] | Series]


@dataclass(frozen=True)
class Argument:
    """A field of a request, as far as units are concerned."""

    units: str
    kind: str = "number"
    #: Columns of the tables that it may be, with their units.
    tables: tuple[dict[str, str], ...] = ()

    @classmethod
    def of(cls, entry: dict[str, Any]) -> Argument:
        """That of a field as the library describes it."""
        tables = tuple(dict(table) for table in entry["columns"])
        return cls(entry["units"], entry["kind"], tables)


#: By task and name.
ARGUMENTS = {
    task["name"]: {entry["name"]: Argument.of(entry) for entry in task["fields"]}
    for task in CATALOGUE["tasks"]
}


def _converted(argument: Argument, name: str, value: Any, folder: Path) -> Any:
    """A value without quantities of pint, data frames and mappings."""
    if value is None:
        return value
    if argument.kind == "points" and not isinstance(value, str):
        return _points(argument, name, value)
    if isinstance(value, (list, tuple)) and not (argument.tables and are_rows(value)):
        return [_converted(argument, name, part, folder) for part in value]
    if argument.tables:
        return in_place(value, argument.tables, name, folder)
    if isinstance(value, (str, os.PathLike)):
        return value
    if argument.kind == "file":
        raise refused(name, f"{name} must be the path of a file, but is {described(value)}")
    value = plain(value, argument, name)
    return np.asarray(value).tolist() if hasattr(value, "shape") else value


def _points(argument: Argument, name: str, value: Any) -> Any:
    """The ends of a range, a tuple of two; else each of several values."""
    is_several = isinstance(value, (Sequence, Iterator)) and not isinstance(value, bytes)
    given = [plain(each, argument, name) for each in value] if is_several else value
    array = in_array(given, argument, name)
    if array.ndim != 1 or array.size < 2:
        raise refused(
            name,
            f"{name} must be a tuple of start and end, or at least two values in one dimension, "
            f"but is {described(value)}",
        )
    numbers = given if is_several else array.tolist()
    return tuple(numbers) if isinstance(value, tuple) else numbers


def ask(
    result: type[R], name: str, case: Any, request: dict[str, Any], *, strict: bool, warn: bool
) -> R:
    """What a task finds for what it is asked of a case (`None`: that of the task)."""
    if case is not None and not hasattr(case, "_file"):
        raise TypeError(f"case must be a Case, but is {quoted(case)}")
    arguments = ARGUMENTS[name]
    families = {
        key: [case._family(*entry) for entry in (request[key] or {}).items()]
        for key, argument in arguments.items()
        if argument.kind == "family"
    }
    request |= {key: [text for text, _, _ in family] for key, family in families.items()}
    file, folder = (None, Path()) if case is None else (case._file, case._folder)
    values = {key: _converted(arguments[key], key, value, folder) for key, value in request.items()}
    report = _core.run(name, file, folder, values)
    found = result._new(report, warn=warn, strict=strict, depth=4)
    found._finish(case, {key: [entry[1:] for entry in family] for key, family in families.items()})
    return found
