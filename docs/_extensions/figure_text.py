"""What figures show, in words: the descriptions of pictures that are drawn while the site is built.

In notebooks a picture carries its description as the text `Description` of the PNG, from which it
becomes the text in place of the picture, and the case of the gallery that it is about as `Case`.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

KEY = "Description"
CASE = "Case"

#: Where code names a case of the gallery, or makes a case of its own.
_CASE = re.compile(r"\bcases/(\w+)\.toml|\bexamples\.(\w+)|\bCase\(")

#: Letters of formulas, and the names of TeX for the rest.
_TEX = re.compile(r"[${}\\]|\\mathrm")


def _plain(text: str) -> str:
    return " ".join(_TEX.sub("", text.replace(r"\mu", "μ")).split())


def _axes(ax: Any) -> str:
    """Title, axes, colours and lines of one diagram."""
    title, x, y = map(_plain, (ax.get_title(), ax.get_xlabel(), ax.get_ylabel()))
    over = " over ".join(label for label in (y, x) if label)
    bars = [getattr(mappable, "colorbar", None) for mappable in (*ax.collections, *ax.images)]
    colours = [_plain(bar.ax.get_ylabel() or bar.ax.get_title()) for bar in bars if bar]
    legend = ax.get_legend()
    lines = [_plain(entry.get_text()) for entry in legend.get_texts()] if legend else []
    parts = [
        title,
        f"colours show {', '.join(dict.fromkeys(filter(None, colours)))}" if any(colours) else "",
        f"axes {over}" if colours and over else over,
        f"with {', '.join(lines)}" if lines else "",
    ]
    return "; ".join(part for part in parts if part)


def described(figure: Any) -> str:
    """A figure of matplotlib in words."""
    # Colour bars are told with what they belong to.
    diagrams = [ax for ax in figure.axes if ax.get_visible() and not hasattr(ax, "_colorbar")]
    words = [figure.get_suptitle(), *map(_axes, diagrams)]
    return ". ".join(dict.fromkeys(filter(None, words))) or "figure"


def case_named(code: str) -> str:
    """The case of the gallery that code is about: the last it names, unless it makes another."""
    found = list(_CASE.finditer(code))
    return found[-1][1] or found[-1][2] or "" if found else ""


def install() -> None:
    """Lets a kernel of IPython describe all figures that it shows."""
    from IPython import get_ipython
    from IPython.core import pylabtools

    draw = pylabtools.print_figure

    def with_description(figure: Any, *args: Any, **options: Any) -> Any:
        case = case_named("\n".join(get_ipython().user_ns["In"]))
        metadata = {**options.pop("metadata", {}), KEY: described(figure), CASE: case}
        return draw(figure, *args, metadata=metadata, **options)

    pylabtools.print_figure = with_description


def of_picture(path: Path, key: str = KEY) -> str:
    """The description that a PNG carries, or its case, or nothing."""
    from PIL import Image

    with Image.open(path) as picture:
        return str(picture.info.get(key, ""))
