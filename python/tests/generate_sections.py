"""Makes schlupf/sections.py of the table of fields, and schlupf/_presets.py of the presets."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from textwrap import fill

from schlupf import _core
from schlupf._fields import CATALOGUE, FIELDS, SECTIONS, Field, SectionTable
from schlupf._forces import NUMBERS
from schlupf._tasks import Tasks

PACKAGE = Path(__file__).parents[1] / "schlupf"

HEAD = '''"""Sections of a case as classes, and what they are given as dictionaries.

>>> import schlupf
>>> load: schlupf.sections.NormalFields = {"load": "80 kN"}
>>> case = schlupf.Case(normal=load)
>>> isinstance(case.normal, schlupf.sections.Normal)
True

Made of the fields of the library by tests/generate.py.
"""

from __future__ import annotations

from typing import Generic, Literal, TypeVar

from ._preset import Preset
from ._section import Entry, Section, SolverSection
from ._typing import TypedDict
from ._units import Count, Data, File, Flag, Heights, Number, Plain, Series, Surface

V = TypeVar("V")
'''

PRESETS = '''"""Constants to start with, each with its source.

Made of the presets of the library by tests/generate.py.
"""

from __future__ import annotations

from ._preset import Preset, Presets
from ._section import Entry
from ._typing import Never
from .sections import (
    {imported},
)
'''

#: What the groups of presets are.
GROUPS = {
    "materials": "Materials, for ``wheel`` and ``rail``.",
    "roughnesses": 'Roughnesses, for ``contact_law={"roughness": …}``.',
    "friction": "Friction laws with their constants, for ``friction``.",
    "layers": "Layers between the surfaces, for ``layer``.",
    "conditions": "Conditions of the rail, for a first guess: ``Case(**conditions.wet)``.",
    "methods": "Fast methods with their constants: ``Case(**methods.polach_dry)``.",
}

#: Sections that can do more than others.
BASES = {"solver": "SolverSection"}

#: What the value of a field of each kind is, and what may be given.
TYPES = {
    "quantity": ("float", "Number"),
    "number": ("float", "Plain"),
    "number-or-choice": ("float", "Plain"),
    "count": ("int", "Count"),
    "flag": ("bool", "Flag"),
    "text": ("str", "str"),
    "path": ("str", "File"),
    "quantities": ("list[float]", "Series"),
    "numbers": ("list[float]", "Series"),
}


def camel(path: str) -> str:
    return "".join(part.capitalize() for part in re.split(r"[._]", path))


def name_of(section: str) -> str:
    """The class of a section."""
    return camel(section.rpartition(".")[2])


def types(field: Field) -> tuple[str, str]:
    """What its value is, and what may be given."""
    value, given = TYPES.get(field.kind, ("", ""))
    if field.columns:
        given = "Surface" if any("height" in table for table in field.columns) else "Data"
    if field.choices:
        names = camel(field.path)
        value, given = (f"{kind} | {names}" if kind else names for kind in (value, given))
    return (f"{value} | None" if field.is_optional else value), f"{given} | None"


def docstring(text: str, indent: str = "    ") -> list[str]:
    text = re.sub(r"\s+", " ", text).strip().removesuffix(".")
    text = fill(f'"""{text}."""', 99, initial_indent=indent, subsequent_indent=indent)
    return text.splitlines()


def documentation(field: Field) -> list[str]:
    default = f"; default: {field.default}" if field.default else ""
    choices = "; ".join(f'"{name}": {doc}' for name, doc in field.choices)
    choices = f" ({choices})" if choices else ""
    tables = (", ".join(f"{c} ({u or 1})" for c, u in table.items()) for table in field.columns)
    tables = f"; or a table of {' or '.join(tables)}" if field.columns else ""
    return docstring(f"{field.doc}{field.unit_text}{default}{choices}{tables}")


def literal(name: str, values: list[str]) -> list[str]:
    if len(values) == 1:
        return [f'{name} = Literal["{values[0]}"]']
    return [f"{name} = Literal[", *(f'    "{value}",' for value in values), "]"]


def inner(section: str) -> list[str]:
    """The sections within a section; of none those of the case."""
    of = f"{section}." if section else ""
    names = (name[len(of) :] for name in SECTIONS if name and name.startswith(of))
    return [of + name for name in names if "." not in name]


def given_for(path: str) -> str:
    name = name_of(path)
    # A table would be a mapping, as its fields are.
    is_file = "." in path and f"{path}.file" in FIELDS
    text = "Heights | " if is_file else ""
    return f"{text}{name}Fields | {name} | Preset[{name}Fields] | None"


def members(
    fields: Sequence[Field], section: str | None
) -> Iterator[tuple[str, tuple[str, str], list[str]]]:
    """Fields, and what is in a section: name, value and what may be given, documentation."""
    for field in fields:
        yield field.name, types(field), documentation(field)
    for path in [] if section is None else inner(section):
        name = path.rpartition(".")[2]
        yield name, (name_of(path), given_for(path)), docstring(SECTIONS[path].doc)


def dictionary(head: str, about: str, fields: Sequence[Field], section: str | None) -> list[str]:
    lines = [f"class {head}, total=False):", *docstring(about), ""]
    for name, (_, given), doc in members(fields, section):
        lines += [f"    {name}: {given}", *doc]
    return lines


def owner(head: str, about: str, section: SectionTable) -> list[str]:
    lines = [f"class {head}:", *docstring(about), "", "    __slots__ = ()"]
    for name, (value, given), doc in members(section.fields, section.name):
        if not section.name and hasattr(Tasks, name):
            # It is a method of a case, and the section an item alone.
            continue
        line = f"    {name}: Entry[{value}, {given}] = Entry()"
        if len(line) > 106:
            line = f"    {name}: Entry[\n        {value}, {given}\n    ] = Entry()"
        elif len(line) > 100:
            line = line.replace("= Entry()", "= (\n        Entry()\n    )")
        lines += [line, *doc]
    return lines


def conditions() -> list[str]:
    short = dict(_core.conditions())
    numbers = {path.replace(".", "__"): path for path in FIELDS if FIELDS[path].kind in NUMBERS}
    lines = ["class Conditions(TypedDict, Generic[V], total=False):"]
    lines += [*docstring("Conditions of `schlupf.forces`, with numbers or arrays"), ""]
    for name, path in (short | numbers).items():
        lines += [f"    {name}: V", *docstring(FIELDS[path].doc)]
    return lines


def sections() -> str:
    aliases = {camel(f.path): [n for n, _ in f.choices] for f in FIELDS.values() if f.choices}
    parts = [[line for name in aliases for line in literal(name, aliases[name])]]
    parts[0] += ["", "#: Dotted paths of all fields.", *literal("FieldPath", list(FIELDS))]
    for path, section in SECTIONS.items():
        if path:
            name, base = name_of(path), BASES.get(path, "Section")
            about = f"Fields of the section `{path}`"
            parts += [dictionary(f"{name}Fields(TypedDict", about, section.fields, path)]
            parts += [owner(f'{name}({base}, path="{path}")', section.doc, section)]
    title = SECTIONS[""].fields
    parts += [dictionary("SectionFields(TypedDict", "Sections with their fields", (), "")]
    parts += [dictionary("CaseFields(SectionFields", "Title and sections", title, None)]
    parts += [owner("Sections", "The title of a case, and its sections", SECTIONS[""])]
    parts += [conditions()]
    text = HEAD + "\n" + "\n\n".join("\n".join(lines) + "\n" for lines in parts)
    defined = Counter(re.findall(r"^(?:class )?(\w+)(?=[(:]| = )", text, re.M))
    several = [name for name, times in defined.items() if times > 1]
    assert not several, f"several would be called {several}"
    return text


def fields_of(group: str) -> list[str]:
    """The dictionaries that the presets of a group may be: of sections with all of its fields."""
    presets = (preset for preset in CATALOGUE["presets"] if preset["group"] == group)
    fields = {field for preset in presets for field, _ in preset["fields"]}
    fitting = [
        path for path in SECTIONS if all(f"{path}.{f}".removeprefix(".") in FIELDS for f in fields)
    ]
    assert fitting, f"no section has the fields of {group}"
    return [f"{name_of(path) or 'Section'}Fields" for path in fitting]


def presets() -> str:
    groups: dict[str, list[str]] = {}
    of_groups = {group: fields_of(group) for group in GROUPS}
    for preset in CATALOGUE["presets"]:
        kind = " | ".join(of_groups[preset["group"]])
        lines = [f"    {preset['name']}: Entry[Preset[{kind}], Never] = Entry()"]
        lines += docstring(f"{preset['doc']} ({preset['source']})")
        groups.setdefault(preset["group"], []).extend(lines)
    imported = ",\n    ".join(sorted({name for names in of_groups.values() for name in names}))
    text = PRESETS.replace("{imported}", imported)
    for group, lines in groups.items():
        kind = " | ".join(of_groups[group])
        head = [f'class {camel(group)}(Presets[{kind}], group="{group}"):']
        head += [*docstring(GROUPS[group]), ""]
        text += "\n\n" + "\n".join([*head, *lines]) + "\n"
    made = [f"#: {GROUPS[group]}\n{group} = {camel(group)}()" for group in groups]
    return text + "\n\n" + "\n".join(made) + "\n"
