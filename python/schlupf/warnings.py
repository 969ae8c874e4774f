"""A category for each code of a warning, such as ``FewCellsWarning`` for ``few-cells``.

>>> import schlupf
>>> schlupf.warnings.FewCellsWarning.code
'few-cells'
"""

from __future__ import annotations

from typing import TYPE_CHECKING
from warnings import warn

from ._core import warning_codes
from ._errors import SchlupfWarning

if TYPE_CHECKING:
    from collections.abc import Iterable


def _category(code: str, meaning: str) -> type[SchlupfWarning]:
    name = "".join(part.capitalize() for part in code.split("-")) + "Warning"
    attributes = {"code": code, "__module__": __name__, "__doc__": f"``{code}``: {meaning}"}
    return type(name, (SchlupfWarning,), attributes)


#: Categories by code.
BY_CODE: dict[str, type[SchlupfWarning]] = {
    code: _category(code, meaning) for code, meaning in warning_codes()
}

globals().update({category.__name__: category for category in BY_CODE.values()})

__all__ = ["BY_CODE", *(category.__name__ for category in BY_CODE.values())]


def __getattr__(name: str) -> type[SchlupfWarning]:
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def emit(messages: Iterable[tuple[str, str, str]], stacklevel: int) -> None:
    """Issue messages (code, quantity, text) as warnings of their categories."""
    for code, quantity, text in messages:
        category = BY_CODE.get(code, SchlupfWarning)
        warn(
            category(f"{quantity}: {text}" if quantity not in text else text, quantity),
            stacklevel=stacklevel + 1,
        )
