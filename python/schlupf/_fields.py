"""The fields of a case, from the one table of the library."""

from __future__ import annotations

from dataclasses import dataclass

from ._core import conditions, field_table
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


def _read() -> dict[str, SectionTable]:
    sections = {}
    for section in field_table():
        fields = tuple(
            Field(
                **{
                    **entry,
                    "choices": tuple(entry["choices"]),
                    "used_with": tuple((p, tuple(n)) for p, n in entry["used_with"]),
                    "columns": tuple(dict(table) for table in entry["columns"]),
                }
            )
            for entry in section["fields"]
        )
        sections[section["name"]] = SectionTable(section["name"], section["doc"], fields)
    return sections


#: Sections by name, in the order of the case file; the top level has an empty name.
SECTIONS: dict[str, SectionTable] = _read()

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
