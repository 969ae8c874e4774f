"""How a task is asked: arguments in units of the library, and what comes back."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from . import _core
from ._errors import quoted
from ._fields import CATALOGUE
from ._files import in_place
from ._units import Number, Series, plain, refused
from .sections import FieldPath

if TYPE_CHECKING:
    from ._report import Report

R = TypeVar("R", bound="Report")

#: A number, or several.
Numbers = Number | Series
#: Start and end, or all places of a curve.
Range = tuple[Number, Number] | str | Series
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
    default: str | None = None

    @classmethod
    def of(cls, entry: dict[str, Any]) -> Argument:
        """That of a field as the library describes it."""
        tables = tuple(dict(table) for table in entry["columns"])
        return cls(entry["units"], entry["kind"], tables, entry["default"])


#: By task and name.
ARGUMENTS = {
    task["name"]: {entry["name"]: Argument.of(entry) for entry in task["fields"]}
    for task in CATALOGUE["tasks"]
}


def _converted(argument: Argument, name: str, value: Any, folder: Path) -> Any:
    """A value without quantities of pint, data frames and mappings."""
    if value is None:
        return value
    if isinstance(value, (list, tuple)):
        return [_converted(argument, name, part, folder) for part in value]
    if argument.tables:
        return in_place(value, argument.tables, name, folder)
    if isinstance(value, (str, os.PathLike)):
        return value
    value = plain(value, argument, name)
    return value.tolist() if hasattr(value, "tolist") else value


def _spaced(arguments: dict[str, Argument], request: dict[str, Any]) -> dict[str, Any]:
    """The ends of arrays in place of ranges, with the number of their points."""
    found: dict[str, Any] = {}
    for name, argument in arguments.items():
        value = request[name]
        if argument.kind != "range" or isinstance(value, str) or np.size(value) <= 2:
            continue
        places = np.asarray(_converted(argument, name, value, Path()))
        if places.ndim != 1 or places.dtype.kind not in "iuf":
            raise refused(name, f"{name} must be numbers or two ends, but is {quoted(value)}")
        if found.setdefault("points", places.size) != places.size:
            which = f"{found['points']} places, as the one before"
            raise refused(name, f"{name} must have {which}, but has {places.size}")
        ends = (float(places[0]), float(places[-1]))
        if not np.allclose(places, np.linspace(*ends, places.size), 0, 1e-9 * np.ptp(places)):
            advice = "schlupf.forces takes any array"
            raise refused(name, f"{name} must have even steps, but has not ({advice})")
        found[name] = ends
    if not found:
        return found
    if request["points"] not in (int(arguments["points"].default or 0), found["points"]):
        text = f"points must be left out where an array has the places, but is {request['points']}"
        raise refused("points", text)
    if "spacing" in arguments:
        if request["spacing"] not in (None, "even"):
            raise refused("spacing", "spacing must be left out where an array has the places")
        found["spacing"] = "even"
    return found


def ask(
    result: type[R], name: str, case: Any, request: dict[str, Any], *, strict: bool, warn: bool
) -> R:
    """What a task finds for what it is asked of a case (`None`: that of the task)."""
    arguments = ARGUMENTS[name]
    if "points" in arguments:
        request |= _spaced(arguments, request)
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
