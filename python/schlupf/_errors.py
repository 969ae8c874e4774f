"""Exceptions and the base of all warnings."""

from __future__ import annotations

import errno
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from ._report import Report
    from ._result import Result


def quoted(value: object) -> str:
    """A value as a message quotes it: no more of it than fits on a line."""
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else f"{text[:60]}…"


def described(value: Any) -> str:
    """What a value of a wrong kind is."""
    return f"an array of shape {value.shape}" if hasattr(value, "shape") else quoted(value)


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

    def __str__(self) -> str:
        return "\n".join(_sentence(error) for error in self.errors)

    def __reduce__(self) -> tuple[type[CaseError], tuple[list[dict[str, Any]]]]:
        return type(self), (self.errors,)


def _sentence(error: dict[str, Any]) -> str:
    place = f"{error['place']}: " if error["place"] else ""
    advice = f" ({error['help']})" if error["help"] else ""
    # What stands without quotes there is no text: the package has written it.
    written = error["place"].rpartition("=")[2]
    message = error["message"].replace(f'"{written}"', written) if written else error["message"]
    text = f"{place}{message}{advice}"
    file = error.get("filename")
    return text if file is None or str(file) in text else f"{text}: {file}"


class CaseFileError(CaseError, OSError):
    """A file that a case names cannot be read.

    Attributes
    ----------
    errno, filename : int and str
        As those of `OSError`.
    """

    def __init__(self, errors: Sequence[dict[str, Any]]) -> None:
        super().__init__(errors)
        self.errno = self.errors[0].get("errno")
        self.filename = self.errors[0].get("filename")
        self.strerror = self.errors[0]["message"]


class CaseFileNotFound(CaseFileError, FileNotFoundError):
    """There is no file that a case names."""


def file_error(errors: Sequence[dict[str, Any]]) -> CaseFileError:
    """The error of a file, by its reason."""
    is_missing = errors[0].get("errno") == errno.ENOENT
    return (CaseFileNotFound if is_missing else CaseFileError)(errors)


class UnknownName(KeyError):
    """Something has no such name; the message tells which it has."""

    def __str__(self) -> str:
        return str(self.args[0])


def no_such(what: str, name: object, known: Iterable[object]) -> str:
    """That something has no such name, with the names like it or else all that there are."""
    names = [str(entry) for entry in known]
    like = get_close_matches(str(name), names, n=3)
    if like:
        return f"no {what} {name}; did you mean {' or '.join(like)}?"
    return f"no {what} {name}; there are {', '.join(names)}" if names else f"no {what} {name}"


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
