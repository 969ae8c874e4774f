"""Makes schlupf/records.py of results: those of the gallery by all methods, and of every choice.

Names and kinds of values are those of the documented JSON; the columns of the library tell what
they are, and that there is a result with each of them. What some results lack may be `None`.
"""

from __future__ import annotations

import contextlib
import inspect
import itertools
import keyword
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from generate_sections import PACKAGE, camel, docstring, literal

import schlupf
from schlupf import _core
from schlupf._fields import FIELDS
from schlupf._record import Found

FILE = PACKAGE / "records.py"

HEAD = '''"""Records of results: their classes, to annotate with.

>>> import schlupf
>>> def resultant(force: schlupf.records.Force) -> float:
...     return (force.x**2 + force.y**2) ** 0.5

Made of results and of the columns of the library by tests/generate.py.
"""

from __future__ import annotations

from typing import Literal

from ._record import Found, Record
from .sections import {aliases}
'''

#: Values that are choices of fields.
CHOICES = {
    "method": "solver.method",
    "reference.point": "kinematics.reference",
    "wheelset.side": "wheelset.side",
}

GRID = {"cells_x": 8, "cells_y": 8}
RICH = {"cells_x": 24, "cells_y": 24}
SPIN = {"creepage_x": 0.002, "spin": 1.0}


@dataclass
class Seen:
    """What stands in one place of several results."""

    kinds: set[str] = field(default_factory=set)
    texts: set[str] = field(default_factory=set)
    members: dict[str, Seen] = field(default_factory=dict)
    entries: Seen | None = None
    #: How often there is something, and how often that is a record.
    times: int = 0
    records: int = 0

    def add(self, value: Any) -> None:
        self.times += 1
        if isinstance(value, dict):
            self.records += 1
            for name, member in value.items():
                self.members.setdefault(name, Seen()).add(member)
        elif isinstance(value, list):
            self.entries = self.entries or Seen()
            for entry in value:
                self.entries.add(entry)
        else:
            self.kinds.add("None" if value is None else type(value).__name__)
            self.texts |= {value} if isinstance(value, str) else set()

    def within(self) -> Iterator[Seen]:
        """Itself and all records in it."""
        inner = [*self.members.values(), *([self.entries] if self.entries else [])]
        yield from (self, *(seen for each in inner for seen in each.within()))

    def complete(self) -> None:
        """What a record lacks is `None`; so is what is `None` in another one with its names."""
        alike: dict[frozenset[str], list[Seen]] = defaultdict(list)
        for seen in self.within():
            alike[frozenset(seen.members)].append(seen)
            for member in seen.members.values():
                member.kinds |= {"None"} if member.times < seen.records else set()
        for names, records in alike.items():
            for name in names:
                kinds = set().union(*(seen.members[name].kinds for seen in records))
                for seen in records:
                    seen.members[name].kinds |= kinds


def results() -> Iterator[schlupf.Result]:
    yield schlupf.Case(grid=RICH, solver={"extrapolate": True}).solve(strict=False, warn=False)
    methods = [name for name, _ in FIELDS["solver.method"].choices]
    gallery = [getattr(schlupf.examples, name) for name in schlupf.examples.__all__]
    cases = [*gallery, schlupf.Case(kinematics=SPIN)]
    asked = [
        case.with_(grid=GRID, solver={"method": method})
        for case, method in itertools.product(cases, methods)
    ]
    choices = [(path, name) for path, of in FIELDS.items() for name, _ in of.choices]
    for case in asked:
        # Not every method can solve every case.
        with contextlib.suppress(schlupf.CaseError):
            yield case.solve(strict=False, warn=False)
    for path, name in choices:
        # Not every choice stands alone.
        with contextlib.suppress(schlupf.CaseError):
            yield schlupf.Case(grid=GRID).with_(**{path: name}).solve(strict=False, warn=False)


def names() -> dict[str, tuple[str, list[str]]]:
    """Texts that are one of several: their type, and what they may be."""
    # The others are of conditions without a solution.
    status = ("Status", _core.condition_status()[:2])
    choices = {
        path: (camel(of), [name for name, _ in FIELDS[of].choices]) for path, of in CHOICES.items()
    }
    return {"status": status, "contact.status": status, **choices}


def columns(record: str) -> dict[str, str]:
    """The columns of a record, and what they are."""
    for name, described in _core.column_table():
        if name == record:
            return {path: f"{doc} ({unit})" if unit else doc for path, unit, doc in described}
    raise KeyError(record)


class Classes:
    """Classes of records, each after those within it."""

    def __init__(self, docs: dict[str, str]) -> None:
        self.docs = docs
        self.names = names()
        self.lines: dict[str, list[str]] = {}
        self.paths: set[str] = set()

    def type_of(self, seen: Seen, path: str) -> tuple[str, str]:
        """Type of a value, and the class of the records in it if there are some."""
        if seen.entries is not None:
            kind, record = self.type_of(seen.entries, path.removesuffix("s"))
            kind = f"list[{kind}]"
        elif seen.members:
            record = kind = camel(path)
            self.add(record, f"``{path}`` of a result", seen, f"{path}.")
        elif path in self.names:
            (kind, known), record = self.names[path], ""
            assert seen.texts <= set(known), f"{path} is one of {seen.texts}"
        else:
            kind, record = " | ".join(sorted(seen.kinds - {"None"})) or "object", ""
        return (f"{kind} | None" if "None" in seen.kinds else kind), record

    def add(self, name: str, about: str, seen: Seen, prefix: str, owner: type | None = None):
        assert name not in self.lines, f"two records would be a class {name}"
        lines = [*docstring(about), ""]
        for member, of in seen.members.items():
            known = inspect.getattr_static(owner, member, None) if owner else None
            if keyword.iskeyword(member) or not isinstance(known, (Found, type(None))):
                # It is an item alone.
                continue
            self.paths.add(prefix + member)
            kind, record = self.type_of(of, prefix + member)
            line = f"    {member}: Found[{kind}] = Found({record})"
            if len(line) > 100:
                line = line.replace("= Found(", "= Found(\n        ")[:-1] + "\n    )"
            lines.append(line)
            if prefix + member in self.docs and not record:
                lines += docstring(self.docs[prefix + member])
        self.lines[name] = [f"class {name}(Record):", *lines]


def records() -> str:
    seen = Seen()
    for result in results():
        seen.add(result.to_dict())
    seen.complete()
    of_contact = {f"contact.{path}": doc for path, doc in columns("contact").items()}
    docs = {f"contact.{path}": doc for path, doc in columns("solution").items()}
    docs |= columns("solution") | columns("wheel") | of_contact
    classes = Classes(docs)
    classes.add("Solved", "The scalars of a result", seen, "", schlupf.Result)
    lacking = {*columns("solution"), *columns("wheel"), *of_contact} - classes.paths
    assert not lacking, f"no result has {lacking}"
    result = schlupf.Case(grid=GRID).solve(strict=False, warn=False)
    status, known = names()["status"]
    lines = [
        "#: Whether the equations are satisfied.",
        *literal(status, known),
        "#: Variables of ``fields``.",
        *literal("CellColumn", list(result.fields.data_vars)),
        "#: Variables of ``history``.",
        *literal("InstantColumn", list(result.history.data_vars)),
    ]
    text = HEAD.replace("{aliases}", ", ".join(sorted(map(camel, CHOICES.values()))))
    text = "\n".join([text, *lines]) + "\n"
    return text + "".join("\n\n" + "\n".join(lines) + "\n" for lines in classes.lines.values())
