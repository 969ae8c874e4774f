"""Values of the literature (`literature.toml`), and what was computed in their place."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterable
from pathlib import Path

import pandas as pd
from IPython.display import Markdown

HERE = Path(__file__).parent

#: Validation data with their sources.
DATA = HERE.parent.parent / "data"

_TABLE = tomllib.loads((HERE / "literature.toml").read_text(encoding="utf-8"))
_SOURCES = _TABLE.pop("sources")
_found: dict[str, tuple[float, float | None, float]] = {}


def data(name: str) -> pd.DataFrame:
    """A file of validation data."""
    return pd.read_csv(DATA / name, comment="#")


def compare(name: str, computed: float, expected: float | None = None) -> None:
    """Compares a value with that of the table, or with a closed form."""
    entry = _TABLE[name]
    expected = entry["value"] if expected is None else expected
    tolerance = entry["relative"] * abs(expected) if "relative" in entry else entry["tolerance"]
    _found[name] = (float(computed), float(expected), tolerance)


def compare_all(name: str, differences: Iterable[float]) -> None:
    """Compares many values: their largest difference counts, and one that is no number."""
    largest = max((abs(float(d)) for d in differences), key=lambda d: math.inf if d != d else d)
    _found[name] = (largest, None, _TABLE[name]["tolerance"])


def _is_fine(name: str) -> bool:
    computed, expected, tolerance = _found[name]
    return abs(computed - (expected or 0.0)) <= tolerance


def _number(value: float) -> str:
    """Five digits."""
    text = f"{value:.5g}"
    return text.replace("-", "−")


def _short(value: float) -> str:
    """Two digits."""
    number = float(f"{value:.2g}")
    return _number(number) if number == 0.0 or 1e-4 <= number < 1e4 else f"{number:.0e}"


def table(*names: str) -> Markdown:
    """The comparisons of these names, with their sources."""
    lines = [
        "| quantity | unit | literature | schlupf | difference | allowed | |",
        "|---|---|--:|--:|--:|--:|---|",
    ]
    for name in names:
        entry = _TABLE[name]
        computed, expected, tolerance = _found[name]
        literature = "" if expected is None else _number(expected)
        ours = "" if expected is None else _number(computed)
        difference = _short(abs(computed - (expected or 0.0)))
        mark = "✓" if _is_fine(name) else "✗"
        lines.append(
            f"| {entry['what']} | {entry['unit']} | {literature} | {ours} | {difference} | "
            f"{_short(tolerance)} | {mark} |"
        )
    sources = dict.fromkeys(_SOURCES[_TABLE[name]["source"]] for name in names)
    return Markdown("\n".join([*lines, "", f"Literature: {'; '.join(sources)}."]))


def conclude() -> Markdown:
    """How many comparisons there are; fails if one is outside of its tolerance or missing."""
    missing = [name for name in _TABLE if name not in _found]
    wrong = [name for name in _found if not _is_fine(name)]
    if missing or wrong:
        raise AssertionError(f"not compared: {missing}; outside of the tolerance: {wrong}")
    return Markdown(f"All {len(_found)} comparisons are within their tolerances.")
