"""Exceptions and the base of all warnings."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ._report import Report
    from ._result import Result


def quoted(value: object) -> str:
    """A value as a message quotes it: no more of it than fits on a line."""
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else f"{text[:60]}…"


class CaseError(ValueError):
    """Something is wrong with a case.

    Attributes
    ----------
    field : str
        Dotted path of the first field that is wrong, such as ``"normal.load"``; may be empty.
    place : str
        Where it was given.
    help : str or None
        What to do about it.
    errors : list of dict
        All that is wrong, each with ``field``, ``message``, ``place`` and ``help``.
    """

    def __init__(self, errors: Sequence[dict[str, Any]]) -> None:
        self.errors = list(errors)
        first = self.errors[0]
        self.field: str = first["field"]
        self.place: str = first["place"]
        self.help: str | None = first["help"]
        super().__init__("\n".join(_sentence(error) for error in self.errors))

    def __reduce__(self) -> tuple[type[CaseError], tuple[list[dict[str, Any]]]]:
        return type(self), (self.errors,)


def _sentence(error: dict[str, Any]) -> str:
    place = f"{error['place']}: " if error["place"] else ""
    advice = f" ({error['help']})" if error["help"] else ""
    return f"{place}{error['message']}{advice}"


class CaseFileError(CaseError, OSError):
    """A file that a case names cannot be read."""


class NotConverged(RuntimeError):
    """A solution has not converged.

    Attributes
    ----------
    result : Result, Report or None
        What was found, with its residual; nothing where the case could not even be posed.
    """

    def __init__(self, result: Result | Report) -> None:
        self.result: Result | Report | None = result
        reasons = [text for code, _, text in result.messages if code == "not-converged"]
        super().__init__("; ".join(reasons) or _verdict(result))

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.result,)


def _verdict(result: Result | Report) -> str:
    residual = result.to_dict().get("residual")
    return "not converged" if residual is None else f"not converged: residual {residual:.2e}"


class CaseNotConverged(CaseError, NotConverged):
    """A case cannot be posed, because its normal contact or its micro model does not converge."""

    def __init__(self, errors: Sequence[dict[str, Any]]) -> None:
        CaseError.__init__(self, errors)
        self.result = None


class SchlupfWarning(UserWarning):
    """Base of all warnings; `schlupf.warnings` has a category for each code.

    Attributes
    ----------
    code, quantity : str
        Code of the warning, and the field or quantity that it is about.
    """

    code = ""

    def __init__(self, message: str, quantity: str = "") -> None:
        super().__init__(message)
        self.quantity = quantity
