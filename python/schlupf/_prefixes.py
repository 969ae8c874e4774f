"""SI prefixes for axes."""

from __future__ import annotations

PREFIXES = {-9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}

#: Units that take prefixes; others stay as they are.
SCALED = ("Pa", "N", "N m", "W", "W/m^2", "J", "m", "m/s")


def scaled(largest: float, unit: str) -> tuple[float, str]:
    """Factor and unit with a prefix with which the largest value lies between 1 and 1000.

    >>> scaled(8.1e8, "Pa")
    (1e-06, 'MPa')
    """
    if unit == "degC":
        return 1.0, "°C"
    shown = unit.replace("^2", "²").replace("^3", "³")
    if unit not in SCALED or not 0.0 < largest < float("inf"):
        return 1.0, shown
    exponent = min(PREFIXES)
    for candidate in PREFIXES:
        if largest >= 10.0**candidate:
            exponent = candidate
    return 10.0**-exponent, PREFIXES[exponent] + shown
