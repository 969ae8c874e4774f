"""Makes schlupf/_records.py of results: those of the gallery by all methods.

Names and kinds of values are those of the documented JSON; the columns of the library tell what
they are, and that there is a result with each of them.
"""

from __future__ import annotations

import contextlib
import inspect
import itertools
import keyword
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from generate_sections import PACKAGE, camel, docstring, literal

import schlupf
from schlupf import _core
from schlupf._fields import FIELDS
from schlupf._record import Found

FILE = PACKAGE / "_records.py"

HEAD = '''"""What results have.

Made of results and of the columns of the library by tests/generate.py.
"""

from __future__ import annotations

from typing import Literal

from ._record import Found, Record
'''

GRID = {"cells_x": 8, "cells_y": 8}
RICH = {"cells_x": 24, "cells_y": 24}
SPIN = {"creepage_x": 0.002, "spin": 1.0}


@dataclass
class Seen:
    """What stands in one place of several results."""

    kinds: set[str] = field(default_factory=set)
    members: dict[str, Seen] = field(default_factory=dict)
    entries: Seen | None = None

    def add(self, value: Any) -> None:
        if isinstance(value, dict):
            for name, member in value.items():
                self.members.setdefault(name, Seen()).add(member)
        elif isinstance(value, list):
            self.entries = self.entries or Seen()
            for entry in value:
                self.entries.add(entry)
        else:
            self.kinds.add("None" if value is None else type(value).__name__)


def results() -> Iterator[schlupf.Result]:
    yield schlupf.Case(grid=RICH, solver={"extrapolate": True}).solve(strict=False, warn=False)
    methods = [name for name, _ in FIELDS["solver.method"].choices]
    gallery = [getattr(schlupf.examples, name) for name in schlupf.examples.__all__]
    for case, method in itertools.product([*gallery, schlupf.Case(kinematics=SPIN)], methods):
        asked = case.with_(grid=GRID, solver={"method": method})
        # Not every method can solve every case.
        with contextlib.suppress(schlupf.CaseError):
            yield asked.solve(strict=False, warn=False)


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
        else:
            kind, record = " | ".join(sorted(seen.kinds - {"None"})) or "object", ""
        return (f"{kind} | None" if "None" in seen.kinds else kind), record

    def add(self, name: str, about: str, seen: Seen, prefix: str, owner: type | None = None):
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
    docs = columns("solution") | columns("wheel")
    docs |= {f"contact.{path}": doc for path, doc in columns("contact").items()}
    classes = Classes(docs)
    classes.add("Solved", "The scalars of a result", seen, "", schlupf.Result)
    lacking = set(columns("solution")) - classes.paths
    assert not lacking, f"no case has {lacking}"
    names = [
        *["#: Columns of the cells.", *literal("CellColumn", list(columns("cells")))],
        *["#: Columns of the time steps.", *literal("InstantColumn", list(columns("instants")))],
    ]
    text = "\n".join([HEAD, *names]) + "\n"
    return text + "".join("\n\n" + "\n".join(lines) + "\n" for lines in classes.lines.values())
