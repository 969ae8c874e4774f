"""Checks of the built pages: every link within the site leads somewhere, every picture has a text
in its place. Links to other sites are listed in `external_links.txt`, each with its pages.
"""

from __future__ import annotations

import re
from collections import defaultdict
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

import figure_text
from docutils import nodes
from sphinx.util import logging

LIST = "external_links.txt"

#: Folders with pages of other programs, which are checked as targets only.
FOREIGN = ("explore", "rust", "_static")

#: Signs on the buttons of films.
BUTTONS = {
    "minus": "−",
    "fast-backward": "|◀",
    "step-backward": "‹",
    "play fa-flip-horizontal": "◀",
    "pause": "||",
    "play": "▶",
    "step-forward": "›",
    "fast-forward": "▶|",
    "plus": "+",
}

logger = logging.getLogger(__name__)


class Page(HTMLParser):
    """What a page links to, what may be linked to, and its pictures without text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.anchors: set[str] = set()
        self.links: set[str] = set()
        self.bare: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        self.anchors |= {name for key in ("id", "name") if (name := given.get(key))}
        link = given.get("href") if tag in ("a", "link") else given.get("src")
        if link and not link.startswith(("data:", "mailto:", "javascript:")):
            self.links.add(link)
        if tag == "img" and not (given.get("alt") or "").strip():
            self.bare.append((given.get("src") or "")[:60])


class Site:
    """The pages of a folder."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self._pages: dict[Path, Page] = {}

    def page(self, path: Path) -> Page:
        if path not in self._pages:
            self._pages[path] = Page(path.read_text(encoding="utf-8"))
        return self._pages[path]

    def own(self) -> list[Path]:
        """Pages that are made of the documentation."""
        paths = sorted(self.root.rglob("*.html"))
        return [p for p in paths if p.relative_to(self.root).parts[0] not in FOREIGN]

    def is_there(self, source: Path, link: str) -> bool:
        """Whether a link of a page within the site leads to something."""
        parts = urlsplit(link)
        target = source
        if parts.path:
            target = (source.parent / unquote(parts.path)).resolve()
        if target.is_dir():
            target /= "index.html"
        if not target.is_file() or not target.is_relative_to(self.root):
            return False
        anchor = unquote(parts.fragment)
        # What a script reads is no anchor.
        is_anchor = bool(anchor) and "=" not in anchor and target.suffix == ".html"
        return not is_anchor or anchor in self.page(target).anchors


def _check(app: Any, error: Exception | None) -> None:
    if error is not None or app.builder.name != "html":
        return
    site = Site(Path(app.outdir).resolve())
    external: defaultdict[str, list[str]] = defaultdict(list)
    for path in site.own():
        name = path.relative_to(site.root).as_posix()
        for picture in site.page(path).bare:
            logger.warning("%s: a picture has no text in its place: %s", name, picture)
        for link in sorted(site.page(path).links):
            if urlsplit(link).netloc:
                external[link].append(name)
            elif not site.is_there(path, link):
                logger.warning("%s: a link leads nowhere: %s", name, link)
    lines = (f"{link}\t{' '.join(pages)}\n" for link, pages in sorted(external.items()))
    (site.root / LIST).write_text("".join(lines), encoding="utf-8")


def _describe(app: Any, doctree: nodes.document) -> None:
    """Gives the pictures of notebooks their texts."""
    for image in doctree.findall(nodes.image):
        path = Path(app.srcdir) / image["uri"]
        if not image.get("alt") and path.suffix == ".png" and path.is_file():
            image["alt"] = figure_text.of_picture(path)
    for raw in doctree.findall(nodes.raw):
        # A film has a picture that a script fills, and buttons with letters of another site.
        text = re.sub(r"<img (?![^>]*\balt=)", '<img alt="frame of the film" ', raw.astext())
        text = re.sub(r'<link rel="stylesheet"\s+href="https?:[^>]*font-awesome[^>]*>', "", text)
        for name, sign in BUTTONS.items():
            text = re.sub(rf'<i class="fa fa-{name}">\s*</i>', sign, text)
        raw.children = [nodes.Text(text)]


def setup(app: Any) -> dict[str, bool]:
    # Before Sphinx collects the pictures.
    app.connect("doctree-read", _describe, priority=100)
    # After everything has been copied.
    app.connect("build-finished", _check, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
