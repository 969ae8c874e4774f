"""The reference of the Python package: a page for each topic, with attributes and their types."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import site_content
from sphinx.pycode import ModuleAnalyzer

import schlupf
from schlupf import records
from schlupf._fields import SECTIONS
from schlupf._tasks import Tasks

FOLDER = site_content.DOCS / "reference" / "python"


@dataclass
class Topic:
    """A page: what it is about, where it is explained, and the names that it has."""

    title: str
    about: str
    names: tuple[str, ...]
    #: Whether the tasks of a case are told beside the classes of their results.
    tasks: bool = False


#: Pages in their order; together they have every public name once.
TOPICS = {
    "cases": Topic(
        "Cases",
        "What to solve. Fields: [case file](/reference/case_file.md); constants: "
        "[presets](/reference/presets.md).",
        ("Case", "Section", "Preset", "import_contact"),
    ),
    "results": Topic(
        "Results",
        "What `Case.solve` returns; in words: [results](/results.md). The records that it is made "
        "of are on [a page of their own](records.md).",
        ("Result", "open_result", "Status", "Record"),
    ),
    "tasks": Topic(
        "Tasks",
        "What a case can be asked besides its solution, each with its result.",
        (
            "Report",
            "Curve",
            "Comparison",
            "Temperatures",
            "BulkTemperature",
            "Subsurface",
            "Wear",
            "Fit",
            "Calibration",
            "RoughContact",
            "Wheelset",
            "roughness",
            "open_surface",
            "damage",
            "Damage",
        ),
        tasks=True,
    ),
    "conditions": Topic(
        "Many conditions",
        "Forces for arrays ([many conditions](/recipes/many_conditions.md)) and tables of many "
        "states ([studies](/studies.md)).",
        (
            "forces",
            "Solver",
            "study",
            "Study",
            "sweep",
            "Sweep",
            "merge",
            "open_table",
            "read_table",
        ),
    ),
    "simulations": Topic(
        "Simulations",
        "A contact in the loop of a simulation ([guides](/simulation/index.md)), and forces from a "
        "[look-up table](/look_up_table.md).",
        (
            "element",
            "Element",
            "Evaluation",
            "Signal",
            "contact_table",
            "ContactTableErrors",
            "Spread",
            "LookUpTable",
            "TableForces",
        ),
    ),
    "figures": Topic(
        "Figures",
        "With matplotlib (extra `plot`). Methods return axes and take `ax`.",
        ("ResultPlots", "RoughContactPlots", "plot_comparison", "animate"),
    ),
    "errors": Topic(
        "Errors and warnings",
        "Their codes: [warnings and errors](/messages.md).",
        ("CaseError", "CaseFileError", "NotConverged", "CaseNotConverged", "SchlupfWarning"),
    ),
    "citing": Topic(
        "Citing", "See also the [bibliography](/reference/bibliography.md).", ("cite",)
    ),
}


def _public() -> list[str]:
    """Names of all public classes and functions."""
    members = ((name, getattr(schlupf, name)) for name in schlupf.__all__)
    return [name for name, m in members if inspect.isclass(m) or inspect.isfunction(m)]


def _documented(name: str, member: Any) -> Iterator[str]:
    """A class, function or exception for Sphinx."""
    if inspect.isfunction(member):
        yield from (f".. autofunction:: schlupf.{name}", "")
        return
    is_exception = issubclass(member, BaseException)
    yield f".. auto{'exception' if is_exception else 'class'}:: schlupf.{name}"
    yield "   :members:"
    yield from ["   :undoc-members:"] if issubclass(member, schlupf.Status) else []
    yield from ["   :show-inheritance:"] if is_exception else []
    yield ""


def _page(topic: Topic) -> Iterator[str]:
    yield from (f"# {topic.title}", "", topic.about, "")
    asked = {}
    for name, method in inspect.getmembers(Tasks, inspect.isfunction) if topic.tasks else ():
        asked.setdefault(inspect.signature(method).return_annotation, []).append(name)
    for name in topic.names:
        yield from (f"## {name}", "", "```{eval-rst}")
        for task in asked.get(name, ()):
            yield from (f".. automethod:: schlupf.Case.{task}", "")
        yield from _documented(name, getattr(schlupf, name))
        yield "```"
        yield from _of_record(getattr(schlupf, name))
        yield ""


# Records.


def _anchor(record: str) -> str:
    return f"record-{record.lower()}"


def _type(annotation: str) -> str:
    """What an attribute is, with links to the records it is made of."""
    inner = re.fullmatch(r"Found\[(.*)\]", annotation)
    parts = re.split(r"(\w+)", inner[1] if inner else annotation)
    linked = [f"[{p}](#{_anchor(p)})" if p in _RECORDS else p for p in parts]
    return "".join(linked).replace("|", r"\|")


_RECORDS = {
    name: record
    for name, record in vars(records).items()
    if inspect.isclass(record) and schlupf.Record in record.__bases__
}


def _attributes(record: type[Any]) -> Iterator[str]:
    analyzer = ModuleAnalyzer.for_module(record.__module__)
    analyzer.analyze()
    yield from ("| attribute | type | |", "|---|---|---|")
    for name, annotation in record.__annotations__.items():
        doc = " ".join(analyzer.attr_docs.get((record.__name__, name), []))
        yield f"| `{name}` | {_type(annotation)} | {site_content.capitalised(doc.strip())} |"


def _of_record(member: Any) -> Iterator[str]:
    """The attributes that a case has of its sections, and a result of its record."""
    if member is schlupf.Case:
        yield from ("", "| attribute | type | |", "|---|---|---|")
        for section in SECTIONS.values():
            if section.name and "." not in section.name:
                link = f"[Section](#{site_content.anchor(section.name)})"
                doc = site_content.capitalised(section.doc.strip())
                yield f"| `{section.name}` | {link} | {doc} |"
    for base in getattr(member, "__mro__", ()):
        if base in _RECORDS.values():
            yield from ("", *_attributes(base))


def _records() -> Iterator[str]:
    yield from ("# Records", "", "Values of results as named attributes, in SI units.", "")
    for name, record in _RECORDS.items():
        yield from (f"({_anchor(name)})=", f"## {name}", "", str(record.__doc__), "")
        yield from (*_attributes(record), "")


# The folder.


def _write(app: Any) -> None:
    """Writes what has changed: Sphinx reads pages again that are newer."""
    told = [name for topic in TOPICS.values() for name in topic.names]
    if sorted(told) != sorted(_public()):
        raise AssertionError(f"told once and public differ: {set(told) ^ set(_public())}")
    pages = {slug: _page(topic) for slug, topic in TOPICS.items()} | {"records": _records()}
    FOLDER.mkdir(exist_ok=True)
    for slug, lines in pages.items():
        path, text = FOLDER / f"{slug}.md", "\n".join(lines) + "\n"
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")


def contents() -> str:
    """Topics with the names that each has."""
    lines = ["| | |", "|---|---|"]
    for slug, topic in TOPICS.items():
        found = ", ".join(f"`{name}`" for name in topic.names)
        lines.append(f"| [{topic.title}](python/{slug}.md) | {found} |")
    lines.append("| [Records](python/records.md) | what results are made of |")
    tree = [f"python/{slug}" for slug in (*TOPICS, "records")]
    return "\n".join([*lines, "", "```{toctree}", ":hidden:", "", *tree, "```"])


def setup(app: Any) -> dict[str, bool]:
    site_content.GENERATED["python"] = contents
    app.connect("builder-inited", _write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
