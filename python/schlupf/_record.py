"""Records of results: named values."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NoReturn

from ._errors import UnknownName, no_such
from ._section import Entry, Value

if TYPE_CHECKING:
    from collections.abc import Iterator


class Record:
    """Named values of a result, as attributes and items; nested ones are records, too."""

    def __init__(self, values: dict[str, Any]) -> None:
        self._values: dict[str, Any] = {
            name: _nested(value, getattr(getattr(type(self), name, None), "record", Record))
            for name, value in values.items()
        }

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if name.startswith("_"):
                raise AttributeError(name)
            try:
                return self._values[name]
            except KeyError:
                raise AttributeError(no_such("result", name, self._values)) from None

        def __setattr__(self, name: str, value: Any) -> None:
            if not name.startswith("_"):
                raise AttributeError(f"a result is not changed: {name}")
            super().__setattr__(name, value)

    def __getitem__(self, name: str) -> Any:
        try:
            return self._values[name]
        except (KeyError, TypeError):
            raise UnknownName(no_such("result", name, self._values)) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def keys(self) -> list[str]:
        """The names, so that ``dict(record)`` has the values."""
        return list(self._values)

    def values(self) -> list[Any]:
        """The values, in the order of the names."""
        return list(self._values.values())

    def items(self) -> list[tuple[str, Any]]:
        """Names with their values."""
        return list(self._values.items())

    def _ipython_key_completions_(self) -> list[str]:
        return self.keys()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Record):
            return NotImplemented
        return self.to_dict() == other.to_dict()

    __hash__ = None  # type: ignore[assignment]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._values]

    def to_dict(self) -> dict[str, Any]:
        """The values as nested dictionaries."""
        return {name: _plain(value) for name, value in self._values.items()}

    def __repr__(self) -> str:
        return "\n".join(self._lines(""))

    def _lines(self, indent: str) -> Iterator[str]:
        for name, value in self._values.items():
            if isinstance(value, Record):
                yield f"{indent}{name}"
                yield from value._lines(indent + "  ")
            elif isinstance(value, list) and len(value) > 4:
                yield f"{indent}{name}: {len(value)} values"
            else:
                yield f"{indent}{name}: {value!r}"


class Found(Entry[Value, NoReturn]):
    """A value of a record, or a record of its own; `None` where this one has no such key."""

    def __init__(self, record: type[Record] = Record) -> None:
        self.record = record

    if not TYPE_CHECKING:

        def __get__(self, of: Record | None, owner: type[Record]) -> Any:
            return self if of is None else of._values.get(self._name)


def _nested(value: Any, record: type[Record]) -> Any:
    """Dictionaries as records, also those of a list."""
    if isinstance(value, list):
        return [_nested(entry, record) for entry in value]
    return record(value) if isinstance(value, dict) else value


def _plain(value: Any) -> Any:
    """The same back."""
    if isinstance(value, list):
        return [_plain(entry) for entry in value]
    return value.to_dict() if isinstance(value, Record) else value
