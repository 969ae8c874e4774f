"""The gallery of cases: each attribute is a new case.

>>> import schlupf
>>> schlupf.examples.steel_wheel_braking.title
'steel wheel, 80 kN, braking'
"""

from __future__ import annotations

from pathlib import Path

from ._case import Case
from ._errors import no_such

_CASES = {path.stem: path for path in sorted((Path(__file__).parent / "cases").glob("*.toml"))}

__all__ = list(_CASES)


def __getattr__(name: str) -> Case:
    if name not in _CASES:
        raise AttributeError(no_such("example", name, _CASES))
    return Case.from_file(_CASES[name])


def __dir__() -> list[str]:
    return __all__
