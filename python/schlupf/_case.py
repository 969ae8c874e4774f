"""Cases: what to solve, with the sections and fields of the case file."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from inspect import Parameter, Signature
from numbers import Integral
from os import PathLike
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Any, ClassVar
from warnings import warn

from . import _core
from ._errors import CaseError, SchlupfWarning, UnknownName, described, quoted
from ._fields import FIELDS, SECTIONS, Field, no_field
from ._files import Unit, each_in_place, in_place, label, shown
from ._laws import LARGEST, Law, checked, sampled
from ._result import Result
from ._section import Section
from ._tasks import Tasks
from ._typing import Unpack
from ._units import plain, refused
from .sections import CaseFields, SectionFields, Sections

#: A family as the library reads it, its field, and the values as the case has them.
_Family = tuple[str, str, list[Any]]


def toml_value(field: Field | None, value: Any, folder: Path = Path()) -> str:
    """A value as it stands in a case file; numbers of dimensional fields are in SI units."""
    path = field.path if field else "a field"
    if field is not None and field.columns:
        value = in_place(value, field.columns, path, folder)
    value = plain(value, field or Unit(""), path)
    if getattr(value, "shape", None) == ():
        value = value.item()
    if field is not None and field.kind in ONE_VALUE:
        _check_one(field, value)
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(toml_value(field, entry, folder) for entry in value)}]"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        is_dimensional = field is not None and field.kind in ("quantity", "quantities")
        if not is_dimensional:
            return repr(value)
        try:
            number = repr(float(value))
        except OverflowError:
            raise refused(path, f"{path} must be a number, but is too large for one") from None
        return json.dumps(f"{number} {field.units}" if field and "n" not in number else number)
    if isinstance(value, str):
        # TOML escapes all that JSON does, and this.
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    raise TypeError(
        f"{path} must be a number, text, a sequence or a quantity, but is a {type(value).__name__}"
    )


#: Kinds of fields with a name, a text or a path, of which the library reads any text.
ONE_VALUE = {
    "path": "the path of a file",
    "text": "text",
    "choice": "one of several names",
    "flag": "True or False",
}


def _check_one(field: Field, value: Any) -> None:
    """Refuses what would only become text, such as an array."""
    is_text = isinstance(value, (str, os.PathLike))
    wanted = isinstance(value, bool) if field.kind == "flag" else is_text
    # A wrong text has a better message of the library.
    if not wanted and not is_text:
        expected = ONE_VALUE[field.kind]
        raise refused(field.path, f"{field.path} must be {expected}, but is {described(value)}")


def assignments(values: Mapping[str, Any], folder: Path, parent: str = "") -> Iterator[str]:
    """Nested values as ``section.field=value``; `None` removes a field."""
    for name, value in values.items():
        path = f"{parent}.{name}" if parent else name
        # A section within a section may be its file.
        field = FIELDS.get(path) or FIELDS.get(f"{path}.file" if "." in path else "")
        if isinstance(value, Section):
            value = value.given()
        if value is None:
            yield from _removed(path)
        elif isinstance(value, Mapping) and path not in FIELDS:
            yield from assignments(value, folder, path)
        elif path in SECTIONS and field is None:
            raise TypeError(f"{path} is a section: give its fields as a dictionary")
        else:
            text = toml_value(field, value, folder)
            is_number = field is not None and field.kind == "quantity" and " " in text
            if is_number and text[0] == '"' and not isinstance(value, str):
                # It needs no quotes, and in messages it is no text.
                text = text[1:-1]
            yield f"{path}={text}"


def _number(name: str, field: Field, value: Any) -> float:
    if not isinstance(value, str):
        return float(plain(value, field, name))
    try:
        empty = _core.CaseFile("", name, Path(), [])
        return float(empty.with_fields([f"{field.path}={json.dumps(value)}"]).value(field.path))
    except CaseError as error:
        message = error.errors[0]["message"].replace(field.path, name)
        raise refused(name, message) from None


def length(name: str, value: Any) -> float:
    """A length in m of a number, a text with its unit or a quantity.

    Raises
    ------
    CaseError
        If it is none.
    """
    try:
        return _number(name, FIELDS["history.shift_x"], value)
    except (TypeError, ValueError) as error:
        if isinstance(error, CaseError):
            raise
        raise refused(name, f"{name} must be a length in m, but is {quoted(value)}") from None


def _count(name: str, value: int) -> int:
    if not isinstance(value, Integral):
        raise TypeError(f"{name} must be a whole number, but is {quoted(value)}")
    if value < 0:
        raise refused(name, f"{name} must not be negative, but is {value}")
    return value


def _removed(path: str) -> Iterator[str]:
    """A field without its value, or all fields of a section."""
    section = SECTIONS.get(path)
    if section is None:
        yield f"{path}="
    else:
        inner = (field for field in FIELDS if field.startswith(f"{path}."))
        yield from (f"{field}=" for field in inner)


class Case(Sections, Tasks):
    """What to solve, as in a case file: one keyword for each section, with its fields.

    Parameters
    ----------
    title : str, optional
        For summaries and plots.
    **sections : mapping
        Fields of each section. Dimensional numbers are in SI units, temperatures in °C; text has
        its unit, such as ``"80 kN"``; quantities of pint are converted. What is left out has its
        default: a steel wheel on a steel rail.

    Raises
    ------
    CaseError
        If a field is unknown, or has a value that it must not have.

    Examples
    --------
    >>> import schlupf
    >>> case = schlupf.Case(normal={"load": "80 kN"}, kinematics={"creepage_x": 0.008})
    >>> case.normal.load
    80000.0
    >>> case.with_(normal={"load": 60e3}).normal.load
    60000.0
    """

    __slots__ = ("_file", "_folder", "_laws")
    _file: _core.CaseFile
    _folder: Path
    #: Arguments of `with_laws`.
    _laws: dict[str, Any]
    __signature__: ClassVar[Signature]

    def __init__(self, title: str | None = None, **sections: Unpack[SectionFields]) -> None:
        values: dict[str, Any] = dict(sections)
        if title is not None and not isinstance(title, str):
            raise TypeError(f"title must be text, but is {quoted(title)}; sections are keywords")
        if title is not None:
            values["title"] = title
        folder = Path()
        self._set(_core.CaseFile("", "Case", folder, list(assignments(values, folder))), folder, {})

    def _set(self, file: _core.CaseFile, folder: Path, laws: dict[str, Any]) -> None:
        object.__setattr__(self, "_file", file)
        object.__setattr__(self, "_folder", folder)
        object.__setattr__(self, "_laws", laws)

    @classmethod
    def _of(cls, file: _core.CaseFile, folder: Path, laws: dict[str, Any] | None = None) -> Case:
        case = cls.__new__(cls)
        case._set(file, folder, laws or {})
        return case

    @classmethod
    def from_file(cls, path: str | PathLike[str]) -> Case:
        """The case of a file; relative paths in it start in its folder.

        Raises
        ------
        CaseError
            If it cannot be read, or if something is wrong with it.
        """
        path = Path(path)
        return cls._of(_core.CaseFile.from_file(path), path.parent)

    @classmethod
    def from_toml(cls, text: str, folder: str | PathLike[str] = ".") -> Case:
        """The case of a TOML text; relative paths in it start in `folder`.

        Raises
        ------
        CaseError
            If something is wrong with it.
        """
        return cls._of(_core.CaseFile(text, "text", Path(folder), []), Path(folder))

    def to_toml(self, folder: str | PathLike[str] | None = None) -> str:
        """The case as TOML, with comments and layout of the text that it was read from.

        Parameters
        ----------
        folder : path, optional
            Where the text is to be: relative paths in it are adapted. By default where it was.

        Warns
        -----
        SchlupfWarning
            If the case has functions of `with_laws`, which no text has.
        """
        if self._laws:
            names = ", ".join(self._laws)
            warn(SchlupfWarning(f"functions are left out of the text: {names}"), stacklevel=2)
        return self._toml(folder)

    def _toml(self, folder: str | PathLike[str] | None = None) -> str:
        return self._file.to_toml(self._folder if folder is None else Path(folder))

    def with_(self, **sections: Unpack[CaseFields]) -> Case:
        """The same case with other fields; `None` removes a field or a section."""
        file = self._file.with_fields(list(assignments(sections, self._folder)))
        case = self._of(file, self._folder)
        # A load scales the pressure of a function.
        return case.with_laws(**self._laws) if self._laws else case

    def with_laws(
        self,
        *,
        friction: Law | None = None,
        pressure: Law | None = None,
        extent: tuple[tuple[float, float], tuple[float, float]] | None = None,
        partition: Law | None = None,
    ) -> Case:
        """The same case with functions in place of its laws; those it has already stay.

        They are called with arrays of equal shape and return such an array; an exception that they
        raise is that of the call that solves. This is the slow path: a solution calls the friction
        law some ten to a hundred thousand times, each of which takes microseconds.

        Parameters
        ----------
        friction : callable, optional
            Coefficient of friction μ of ``(temperature, slip_speed, y)``: of the contact, in K
            above ``friction.reference_temperature``; in m/s; in m. It must be smooth, positive at
            ``(0, 0, 0)`` and not negative elsewhere.
        pressure : callable, optional
            Normal pressure (Pa) of ``(x, y)`` (m, x along rolling), zero outside of the contact; it
            is sampled at 257 × 257 places, and scaled to ``normal.load`` where that is given.
        extent : ((float, float), (float, float)), optional
            Ranges of x and y, in m, that contain the contact; needed with `pressure`.
        partition : callable, optional
            Share of the wheel in the frictional heat, from 0 to 1, of the speeds at which the
            surfaces of wheel and rail pass, in m/s.

        Examples
        --------
        >>> import numpy as np, schlupf
        >>> case = schlupf.Case(kinematics={"creepage_x": 0.02}, grid={"cells_x": 8, "cells_y": 8})
        >>> def friction(temperature, slip_speed, y):
        ...     return 0.3 * np.exp(-slip_speed / 2.0)
        >>> bool(-case.with_laws(friction=friction).solve().normalised.x < 0.9)
        True
        """
        if (pressure is None) != (extent is None):
            raise TypeError("pressure and extent belong together")
        given: dict[str, Any] = {"friction": friction, "pressure": pressure, "extent": extent}
        given["partition"] = partition
        laws = {**self._laws, **{name: law for name, law in given.items() if law is not None}}
        friction, partition = laws.get("friction"), laws.get("partition")
        file = self._file.with_laws(
            None
            if friction is None
            else checked("friction", friction, "finite and not negative", LARGEST),
            None if partition is None else checked("partition", partition, "from 0 to 1", 1.0),
            sampled(laws["pressure"], laws["extent"]) if "pressure" in laws else None,
            self["normal.load"] if "normal.load" in self.given() else None,
        )
        return self._of(file, self._folder, laws)

    def given(self) -> list[str]:
        """Dotted paths of the fields that are given."""
        return self._file.given()

    def effective(self) -> dict[str, tuple[str, bool]]:
        """The fields that have an effect: value as text, and whether it is the default."""
        fields = {path: (value, default) for path, value, default in self._file.effective()}
        fields = {path: entry for path, entry in fields.items() if not self._is_replaced(path)}
        return fields | {name: (repr(law), False) for name, law in self._laws.items()}

    def _is_replaced(self, path: str) -> bool:
        """Whether a function stands in place of a field."""
        friction = path.startswith("friction.") and path != "friction.reference_temperature"
        pressure = path.startswith("normal.") and path != "normal.load"
        return (
            ("friction" in self._laws and friction)
            or ("pressure" in self._laws and pressure)
            or ("partition" in self._laws and path == "heat.partition")
        )

    def _check_varied(self, path: str) -> None:
        """Refuses to vary a field that has no effect."""
        if self._is_replaced(path):
            raise refused(path, f"{path} has no effect: a function is in place of it")

    if not TYPE_CHECKING:
        # A wrong name is told by those like it.
        def __getattr__(self, name: str) -> Any:
            raise AttributeError(no_field(name))

        def __setattr__(self, name: str, value: Any) -> None:
            self[name] = value

    def __getitem__(self, path: str) -> Any:
        if path in Section._OF_PATHS:
            return Section._OF_PATHS[path](self)
        if path not in FIELDS:
            raise UnknownName(no_field(path))
        return self._file.value(path)

    def __setitem__(self, path: str, value: Any) -> None:
        changed = self.with_(**{path: value})
        self._set(changed._file, self._folder, changed._laws)

    def __contains__(self, path: object) -> bool:
        return path in FIELDS or path in SECTIONS

    def __iter__(self) -> Iterator[str]:
        return iter(self.given())

    def keys(self) -> list[str]:
        """Dotted paths of the fields that are given, so that ``dict(case)`` has their values."""
        return self.given()

    def _ipython_key_completions_(self) -> list[str]:
        return [*FIELDS, *(name for name in SECTIONS if name)]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Case):
            return NotImplemented
        paths = set(self.given())
        same = paths == set(other.given()) and self._laws == other._laws
        return same and all(self[path] == other[path] for path in paths)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        values: dict[str, Any] = {}
        for path in dict.fromkeys(self.given()):
            *sections, name = path.split(".")
            inner = values
            for section in sections:
                inner = inner.setdefault(section, {})
            inner[name] = self[path]
        text = ", ".join(f"{name}={shown(value)}" for name, value in values.items())
        laws = ", ".join(f"{name}={law!r}" for name, law in self._laws.items())
        return f"Case({text}).with_laws({laws})" if laws else f"Case({text})"

    def __copy__(self) -> Case:
        return self._of(self._file, self._folder, self._laws)

    def __deepcopy__(self, memo: dict[int, Any]) -> Case:
        return self.__copy__()

    def __reduce__(self) -> tuple[Any, ...]:
        return rebuilt, (self._toml(), os.fspath(self._folder), self._laws)

    def solve(
        self,
        *,
        initial_state: bytes | None = None,
        fields_every: int = 0,
        strict: bool = True,
        warn: bool = True,
    ) -> Result:
        """Solves the case: steady rolling, or rolling over time where it has a history.

        Parameters
        ----------
        initial_state : bytes, optional
            State of an earlier result (`Result.state`) from which rolling continues.
        fields_every : int, optional
            Rolling over time: time steps from one instant of `Result.field_history` to the next; by
            default there is none.
        strict : bool, default True
            Whether to raise `NotConverged`; else look at ``result.status``.
        warn : bool, default True
            Whether to issue the warnings of the result.

        Returns
        -------
        Result
            Scalars as attributes, fields over x and y, the history over time.

        Raises
        ------
        CaseError
            If the case cannot be solved as it is.
        NotConverged
            If the solution has not converged; it has the result.
        """
        solution = self._file.solve(initial_state, _count("fields_every", fields_every))
        return Result._new(solution, strict=strict, warn=warn)

    def _family(self, path: str, values: Sequence[Any]) -> _Family:
        if path not in FIELDS:
            raise UnknownName(no_field(path))
        self._check_varied(path)
        values = [values] if isinstance(values, str) else values
        values = each_in_place(values, FIELDS[path].columns, path, self._folder)
        texts = [toml_value(FIELDS[path], value) for value in values]
        text = f"{path}={','.join(texts)}"
        members = [self._file.with_fields([f"{path}={entry}"]) for entry in texts]
        return text, path, [label(member.value(path)) for member in members]


def rebuilt(text: str, folder: str, laws: dict[str, Any]) -> Case:
    """A case from its text, in a folder, with laws."""
    case = Case.from_toml(text, folder)
    return case.with_laws(**laws) if laws else case


def _documentation() -> str:
    lines = [Case.__doc__ or "", "    Notes", "    -----", "    Sections and their fields:", ""]
    for section in SECTIONS.values():
        if section.name:
            lines += [f"    ``{section.name}``: {section.doc}", ""]
            for field in section.fields:
                default = f"; default: {field.default}" if field.default else ""
                names = " | ".join(f'"{name}"' for name, _ in field.choices)
                text = f"- ``{field.name}``{field.unit_text}: {field.doc}{default}"
                text += f"; {names}" if names else ""
                lines.append(fill(text, 95, initial_indent="    ", subsequent_indent="      "))
            lines.append("")
    return "\n".join(lines)


def _signature() -> Signature:
    """With a keyword for each section, which help and notebooks show."""
    keywords = [name for name in SECTIONS if name and "." not in name]
    title = Parameter("title", Parameter.POSITIONAL_OR_KEYWORD, default=None)
    sections = (Parameter(name, Parameter.KEYWORD_ONLY, default=None) for name in keywords)
    return Signature([title, *sections])


Case.__doc__ = _documentation()
Case.__signature__ = _signature()
