"""The fields of a case, from the one table of the library."""

from __future__ import annotations

import json
from dataclasses import dataclass, fields
from typing import Any

from ._core import catalogue, conditions
from ._errors import no_such


@dataclass(frozen=True)
class Field:
    """A field of a case."""

    path: str
    name: str
    kind: str
    units: str
    requirement: str
    default: str | None
    is_optional: bool
    choices: tuple[tuple[str, str], ...]
    used_with: tuple[tuple[str, tuple[str, ...]], ...]
    #: Columns with their units, of every table that its file may hold.
    columns: tuple[dict[str, str], ...]
    doc: str

    @property
    def unit_text(self) -> str:
        """The unit in brackets, where there is one."""
        return f" ({self.units})" if self.units else ""


@dataclass(frozen=True)
class SectionTable:
    """A section of a case."""

    name: str
    doc: str
    fields: tuple[Field, ...]


def _field(entry: dict[str, Any]) -> Field:
    return Field(
        **{
            **{of.name: entry[of.name] for of in fields(Field)},
            "choices": tuple((name, doc) for name, doc in entry["choices"]),
            "used_with": tuple((p, tuple(n)) for p, n in entry["used_with"]),
            "columns": tuple(dict(table) for table in entry["columns"]),
        }
    )


#: What the library has: sections of a case, tasks, and presets.
CATALOGUE: dict[str, list[dict[str, Any]]] = json.loads(catalogue())

#: Sections by name, in the order of the case file; the top level has an empty name.
SECTIONS: dict[str, SectionTable] = {
    of["name"]: SectionTable(of["name"], of["doc"], tuple(map(_field, of["fields"])))
    for of in CATALOGUE["sections"]
}

#: Fields by dotted path.
FIELDS: dict[str, Field] = {
    field.path: field for section in SECTIONS.values() for field in section.fields
}


#: Conditions that have a short name, with their fields.
CONDITIONS: dict[str, str] = dict(conditions())


def quantity(path: str) -> str:
    """The name in data sets of a field or quantity: its path with ``_`` for the dot.

    Creepages, spin and speed need no section. A name never is a method of a data set.
    """
    section, _, name = path.rpartition(".")
    is_short = section == "kinematics" and CONDITIONS.get(name) == path
    return name if is_short else path.replace(".", "_")


def column(name: str) -> str:
    """The name in data sets of a column of the library, by the same rule."""
    return quantity(CONDITIONS.get(name, name))


def no_field(path: object) -> str:
    """That there is no such field or section."""
    if path in SECTIONS:
        return f"{path} is a section: name its fields, such as {SECTIONS[str(path)].fields[0].path}"
    section, _, _ = str(path).rpartition(".")
    inside = [known for known in FIELDS if section and known.startswith(f"{section}.")]
    if not inside:
        # A field of another section, or a section.
        inside = [*(name for name in SECTIONS if name), *FIELDS]
        return no_such("field", path, inside) if "." in str(path) else _no_section(path)
    return no_such("field", path, inside)


def _no_section(name: object) -> str:
    """That there is no such section; a field without its section is told where it is."""
    paths = [path for path in FIELDS if path.rpartition(".")[2] == name]
    if paths:
        return f"no section {name}; did you mean {' or '.join(paths[:3])}?"
    return no_such("section", name, [name for name in SECTIONS if name and "." not in name])
