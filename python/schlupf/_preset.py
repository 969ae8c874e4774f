"""Presets: constants to start with, each with its source."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, ClassVar, Generic, TypeVar

from ._errors import UnknownName, no_such
from ._fields import CATALOGUE

if TYPE_CHECKING:
    from collections.abc import ItemsView, Iterator


#: Where a preset may stand: fields of a section, or of one of several.
Fields = TypeVar("Fields", contravariant=True)


class Preset(dict[str, Any], Generic[Fields]):
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


class Presets(Generic[Fields]):
    """Presets of one kind, by name."""

    _presets: ClassVar[dict[str, Preset[Any]]]

    def __init_subclass__(cls, group: str) -> None:
        cls._presets = {
            of["name"]: Preset(_nested(of["fields"]), of["doc"], of["source"])
            for of in CATALOGUE["presets"]
            if of["group"] == group
        }

    if not TYPE_CHECKING:
        # A wrong name is told by those like it.
        def __getattr__(self, name: str) -> Any:
            raise AttributeError(no_such("preset", name, self))

    def _ipython_key_completions_(self) -> list[str]:
        return list(self._presets)

    def __getitem__(self, name: str) -> Preset[Fields]:
        try:
            return self._presets[name]
        except (KeyError, TypeError):
            raise UnknownName(no_such("preset", name, self)) from None

    def __contains__(self, name: object) -> bool:
        return name in self._presets

    def items(self) -> ItemsView[str, Preset[Fields]]:
        """Names and presets."""
        return self._presets.items()

    def __iter__(self) -> Iterator[str]:
        return iter(self._presets)

    def __len__(self) -> int:
        return len(self._presets)

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
