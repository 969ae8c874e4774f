"""Inputs of other programs as cases."""

from __future__ import annotations

from os import PathLike
from pathlib import Path
from warnings import warn

from . import _core
from ._case import Case
from ._errors import SchlupfWarning, quoted
from .warnings import emit


def import_contact(
    path: str | PathLike[str], *, wheel_body: int = 1, available_only: bool = False
) -> list[Case]:
    """The cases of an input file of CONTACT (``.inp``), module 1 or 3.

    The steps of transient rolling are one case with a history. Tables of undeformed distances stay
    in memory; ``schlupf import`` writes them as files.

    Parameters
    ----------
    path : path
        The input file; profiles of module 1 are found from its folder.
    wheel_body : int, optional
        Which body of module 3 is the wheel, 1 or 2: signs follow from it.
    available_only : bool, optional
        Whether to leave out the cases that are not available, with a warning that says why.

    Raises
    ------
    CaseError
        If the file is wrong, or if something in it is not available: with name, value and line.
    """
    if wheel_body not in (1, 2):
        raise ValueError(f"wheel_body must be 1 or 2, but is {quoted(wheel_body)}")
    path = Path(path)
    files, messages, refused = _core.import_contact(path, wheel_body == 2, available_only)
    emit(messages, stacklevel=2)
    for sentence in refused:
        warn(SchlupfWarning(sentence), stacklevel=2)
    return [Case._of(file, path.parent) for file in files]
