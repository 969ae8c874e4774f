"""Constants to start with, each with its source."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from ._core import presets
from ._errors import UnknownName, no_such

if TYPE_CHECKING:
    from collections.abc import ItemsView, Iterator


class Preset(dict[str, Any]):
    """Fields of a section as a dictionary, with what they are and where they come from.

    Attributes
    ----------
    doc, source : str
    """

    def __init__(self, fields: dict[str, Any], doc: str, source: str) -> None:
        super().__init__(fields)
        self.doc = doc
        self.source = source

    def __repr__(self) -> str:
        return f"{super().__repr__()}\n{self.doc}\nsource: {self.source}"

    def __reduce__(self) -> Any:
        return type(self), (dict(self), self.doc, self.source)


class Presets:
    """Presets of one kind, by name."""

    def __init__(self, group: str) -> None:
        self._presets = {
            name: Preset(_nested(fields), doc, source)
            for of, name, doc, source, fields in presets()
            if of == group
        }

    def __getattr__(self, name: str) -> Preset:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self._presets[name]
        except KeyError:
            raise AttributeError(no_such("preset", name, self)) from None

    def __getitem__(self, name: str) -> Preset:
        try:
            return self._presets[name]
        except (KeyError, TypeError):
            raise UnknownName(no_such("preset", name, self)) from None

    def __contains__(self, name: object) -> bool:
        return name in self._presets

    def items(self) -> ItemsView[str, Preset]:
        """Names and presets."""
        return self._presets.items()

    def __iter__(self) -> Iterator[str]:
        return iter(self._presets)

    def __len__(self) -> int:
        return len(self._presets)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self]

    def __repr__(self) -> str:
        width = max(map(len, self), default=0)
        return "\n".join(f"{name:{width}}  {p.doc}" for name, p in self._presets.items())


def _nested(fields: list[tuple[str, str]]) -> dict[str, Any]:
    nested: dict[str, Any] = {}
    for path, value in fields:
        *sections, name = path.split(".")
        inner = nested
        for section in sections:
            inner = inner.setdefault(section, {})
        # Text and numbers of TOML are those of JSON, too.
        inner[name] = json.loads(value)
    return nested


#: Materials, for ``wheel`` and ``rail``.
materials = Presets("materials")

#: Roughnesses, for ``contact_law={"roughness": …}``.
roughnesses = Presets("roughnesses")

#: Friction laws with their constants, for ``friction``.
friction = Presets("friction")

#: Layers between the surfaces, for ``layer``.
layers = Presets("layers")

#: Conditions of the rail, for a first guess: ``Case(**conditions.wet)``.
conditions = Presets("conditions")

#: Fast methods with their constants: ``Case(**methods.polach_dry)``.
methods = Presets("methods")
