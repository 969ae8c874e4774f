"""Sections of a case: their fields are attributes and items."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Generic, TypeVar, overload
from warnings import warn

from ._fields import SECTIONS, no_field
from ._files import shown
from ._typing import Self

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ._case import Case
    from ._forces import Solver

Value = TypeVar("Value")
Given = TypeVar("Given", contravariant=True)


class Entry(Generic[Value, Given]):
    """An item that is an attribute, too: its value, and what it may be set to."""

    def __set_name__(self, owner: type[Any], name: str) -> None:
        self._name = name

    @overload
    def __get__(self, of: None, owner: type[Any]) -> Self: ...
    @overload
    def __get__(self, of: Any, owner: type[Any]) -> Value: ...
    def __get__(self, of: Any, owner: type[Any]) -> Any:
        try:
            return self if of is None else of[self._name]
        except KeyError:
            raise AttributeError(self._name) from None

    if TYPE_CHECKING:
        # What it belongs to sets all its attributes itself.
        def __set__(self, of: Any, value: Given) -> None: ...


class Section:
    """A section of a case: its fields are attributes and items, and may be set.

    A field that is not given has its default, in SI units; `None` if it has none or if it follows
    from other fields.
    """

    __slots__ = ("_case",)
    _path: ClassVar[str]
    if TYPE_CHECKING:
        # A case is made of sections.
        _case: Case

    #: All sections by their dotted paths.
    _OF_PATHS: ClassVar[dict[str, type[Section]]] = {}

    def __init_subclass__(cls, path: str = "") -> None:
        if path:
            cls._path = path
            Section._OF_PATHS[path] = cls

    def __init__(self, case: Case) -> None:
        object.__setattr__(self, "_case", case)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._case,)

    if not TYPE_CHECKING:
        # A wrong name is told by those like it.
        def __getattr__(self, name: str) -> Any:
            raise AttributeError(no_field(f"{self._path}.{name}"))

        def __setattr__(self, name: str, value: Any) -> None:
            self[name] = value

    def __getitem__(self, name: str) -> Any:
        return self._case[f"{self._path}.{name}"]

    def __setitem__(self, name: str, value: Any) -> None:
        self._case[f"{self._path}.{name}"] = value

    def __contains__(self, name: object) -> bool:
        return isinstance(getattr(type(self), str(name), None), Entry)

    def __iter__(self) -> Iterator[str]:
        return iter(self.given())

    def keys(self) -> list[str]:
        """Names of the fields that are given, so that ``dict(section)`` has their values."""
        return list(self.given())

    def _ipython_key_completions_(self) -> list[str]:
        return [field.name for field in SECTIONS[self._path].fields]

    def given(self) -> dict[str, Any]:
        """The fields that are given, with their values in SI units."""
        prefix = f"{self._path}."
        paths = [path for path in self._case.given() if path.startswith(prefix)]
        return {path[len(prefix) :]: self._case[path] for path in paths}

    def __repr__(self) -> str:
        values = ((field.name, self[field.name]) for field in SECTIONS[self._path].fields)
        lines = (f"  {name} = {shown(value)}" for name, value in values if value is not None)
        return "\n".join([f"[{self._path}]", *lines])


class SolverSection(Section):
    """The section ``solver``."""

    __slots__ = ()

    def __call__(self) -> Solver:
        """Deprecated: `schlupf.Solver` of the case."""
        from ._forces import Solver

        message = "case.solver() is now schlupf.Solver(case): case.solver is a section"
        warn(message, DeprecationWarning, stacklevel=2)
        return Solver(self._case)
