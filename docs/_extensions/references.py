"""Links from what pages cite, such as `Polach 2005`, to the bibliography.

The bibliography is `references.bib` with the entries of `schlupf.cite()`. A page that cites what it
does not have is a warning, and so is an entry that no page cites.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from docutils import nodes
from pybtex.database import BibliographyData, Entry, parse_file
from sphinx.util import logging

#: The page with the bibliography.
PAGE = "reference/bibliography"

#: What is cited by its name, not as a publication.
PROGRAMS = ("schlupf",)

logger = logging.getLogger(__name__)

_NAME = r"[A-ZÄÖÜ][a-zß-ÿ][\w’'-]*"
_YEAR = r"1[789]\d\d|20\d\d"
#: Anything that looks like a citation: names and a year, which may be in brackets.
_CITATION = re.compile(
    rf"\b(?P<names>{_NAME}(?:(?:,\s{_NAME})*\s(?:and|&)\s{_NAME}|\set\sal\.)?)"
    rf"(?:\s(?P<year>{_YEAR})\b|\s\((?P<bracketed>{_YEAR})\))"
)
#: The end of a text in which a name is part of a title: `Railway Vehicle` before `Dynamics (2006)`.
_WITHIN_TITLE = re.compile(r"[A-Z]\w+\s$")

#: Nodes whose text is not prose.
_NO_PROSE = (
    nodes.FixedTextElement,
    nodes.literal,
    nodes.math,
    nodes.raw,
    nodes.reference,
    nodes.title,
)


def names(entry: Entry) -> list[str]:
    """How the authors of an entry are named in a page."""
    found = [" ".join([*p.prelast_names, *p.last_names]) for p in entry.persons["author"]]
    found = [name.strip("{}") for name in found]
    if len(found) == 1:
        return found
    forms = [f"{', '.join(found[:-1])} and {found[-1]}"]
    return forms if len(found) == 2 else [*forms, f"{found[0]} et al."]


@dataclass
class Bibliography:
    """Keys of entries by the names of their authors and the year."""

    keys: dict[tuple[str, str], str]

    @classmethod
    def of(cls, data: BibliographyData) -> Bibliography:
        keys: dict[tuple[str, str], str] = {}
        for key, entry in data.entries.items():
            if key in PROGRAMS:
                continue
            for form in names(entry):
                place = (form, entry.fields["year"])
                if place in keys:
                    raise ValueError(f"{key} and {keys[place]} cannot be told apart: {place}")
                keys[place] = key
        return cls(keys)

    def citations(self, text: str) -> Iterator[tuple[re.Match[str], str | None]]:
        """What looks like a citation, with the key of its entry, if there is one."""
        for match in _CITATION.finditer(text):
            year = match["year"] or match["bracketed"]
            authors = " ".join(match["names"].split()).replace("&", "and")
            key = self.keys.get((authors, year))
            if key or not _WITHIN_TITLE.search(text[: match.start()]):
                yield match, key


def _prose(doctree: nodes.document) -> Iterator[nodes.TextElement]:
    """Elements with text of sentences; texts in them that follow each other become one."""
    for element in doctree.findall(nodes.TextElement):
        parent = element
        while parent is not None and not isinstance(parent, _NO_PROSE):
            parent = parent.parent
        if parent is None:
            joined: list[nodes.Node] = []
            for child in element.children:
                is_text = isinstance(child, nodes.Text)
                if is_text and joined and isinstance(joined[-1], nodes.Text):
                    child = nodes.Text(joined.pop().astext() + child.astext())
                joined.append(child)
            element.children = []
            element.extend(joined)
            yield element


def _texts(element: nodes.TextElement) -> Iterator[str]:
    return (child.astext() for child in element.children if isinstance(child, nodes.Text))


def _of(app: Any) -> Bibliography:
    if not hasattr(app, "schlupf_bibliography"):
        files = [Path(app.srcdir) / name for name in app.config.bibtex_bibfiles]
        data = BibliographyData()
        for file in files:
            data.add_entries(parse_file(str(file)).entries.items())
        app.schlupf_bibliography = Bibliography.of(data)
    return app.schlupf_bibliography


def _collect(app: Any, doctree: nodes.document) -> None:
    """Notes what a page cites."""
    env = app.env
    cited = env.__dict__.setdefault("schlupf_cited", {})[env.docname] = set()
    for element in _prose(doctree) if env.docname != PAGE else ():
        for match, key in (found for text in _texts(element) for found in _of(app).citations(text)):
            if key is None:
                logger.warning("%s is not in the bibliography", match[0], location=element)
            else:
                cited.add(key)


def _purge(app: Any, env: Any, docname: str) -> None:
    env.__dict__.setdefault("schlupf_cited", {}).pop(docname, None)


def _merge(app: Any, env: Any, docnames: set[str], other: Any) -> None:
    """Takes over what pages cite that another process has read."""
    cited = env.__dict__.setdefault("schlupf_cited", {})
    cited.update({name: keys for name, keys in other.schlupf_cited.items() if name in docnames})


def _check(app: Any, env: Any) -> None:
    cited = set().union(*env.schlupf_cited.values())
    for key in sorted(set(_of(app).keys.values()) - cited):
        logger.warning("no page cites %s of the bibliography", key)


def _link(app: Any, doctree: nodes.document, docname: str) -> None:
    if docname == PAGE:
        return
    places = {
        citation.key: f"{app.builder.get_relative_uri(docname, PAGE)}#{citation.citation_id}"
        for citation in app.env.get_domain("cite").citations
    }
    for element in list(_prose(doctree)):
        parts: list[nodes.Node] = []
        for child in element.children:
            is_text = isinstance(child, nodes.Text)
            parts += _linked(child.astext(), _of(app), places) if is_text else [child]
        element.children = []
        element.extend(parts)


def _linked(text: str, bibliography: Bibliography, places: dict[str, str]) -> Iterator[nodes.Node]:
    """The same text with its citations as links."""
    end = 0
    for match, key in bibliography.citations(text):
        if key is not None:
            yield nodes.Text(text[end : match.start()])
            yield nodes.reference("", match[0], refuri=places[key], internal=True)
            end = match.end()
    yield nodes.Text(text[end:])


def setup(app: Any) -> dict[str, bool]:
    app.connect("doctree-read", _collect)
    app.connect("env-purge-doc", _purge)
    app.connect("env-merge-info", _merge)
    app.connect("env-check-consistency", _check)
    app.connect("doctree-resolved", _link)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
