"""What pages contain that is generated, from the package and from files outside of docs.

A page names a part by a comment of its own line, ``<!-- generated: NAME ARGUMENTS -->``; the part
is Markdown and replaces the comment when the page is read.
"""

from __future__ import annotations

import hashlib
import importlib.util
import inspect
import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import figure_text
from docutils import nodes
from myst_nb.sphinx_ import NbMetadataCollector

import schlupf
from schlupf._core import error_codes, warning_codes
from schlupf._fields import FIELDS, SECTIONS, Field

DOCS = Path(__file__).parent.parent
ROOT = DOCS.parent
LAWS = DOCS / "laws"

#: The target directory of cargo.
TARGET = ROOT / os.environ.get("CARGO_TARGET_DIR", "target")


def of_notebooks() -> list[Path]:
    """Files that notebooks depend on: the package, data, cases, their modules."""
    package = Path(inspect.getfile(schlupf)).parent
    pages = [DOCS / "validation", DOCS / "laws", DOCS / "theory"]
    folders = [package, ROOT / "data", ROOT / "cases", *pages]
    endings = {".csv", ".npy", ".py", ".so", ".pyd", ".toml"}
    paths = (path for folder in folders for path in folder.iterdir())
    return sorted(path for path in paths if path.suffix in endings)


def _of_pages() -> list[Path]:
    """Files that pages depend on and Sphinx does not see."""
    texts = sorted(ROOT.glob("*.md"))
    return [*of_notebooks(), *texts, ROOT / "data" / "README.md", DOCS / "messages.md"]


def digest(files: list[Path]) -> str:
    """A short sum of files."""
    sums = hashlib.sha256()
    for path in files:
        sums.update(path.name.encode())
        sums.update(path.read_bytes())
    return sums.hexdigest()[:16]


def cache() -> Path:
    """The folder for results of notebooks that are computed with this package."""
    parent = TARGET / "site-cache"
    own = parent / digest([*of_notebooks(), DOCS / "matplotlibrc", Path(figure_text.__file__)])
    for other in parent.iterdir() if parent.is_dir() else ():
        if other != own:
            shutil.rmtree(other)
    return own


def kernels() -> Path:
    """A folder of IPython with settings of the kernels: they report errors only."""
    folder = TARGET / "site-ipython"
    profile = folder / "profile_default"
    profile.mkdir(parents=True, exist_ok=True)
    settings = profile / "ipython_kernel_config.py"
    lines = [
        "c = get_config()",
        'c.IPKernelApp.log_level = "ERROR"',
    ]
    settings.write_text("\n".join(lines) + "\n")
    startup = profile / "startup" / "describe_figures.py"
    startup.parent.mkdir(exist_ok=True)
    folder_of_modules = str(Path(figure_text.__file__).parent)
    lines = ["import sys", f"sys.path.insert(0, {folder_of_modules!r})", "import figure_text"]
    startup.write_text("\n".join([*lines, "figure_text.install()"]) + "\n")
    return folder


# Fields of case files.


def _cell(text: str) -> str:
    return text.replace("|", r"\|").replace("\n", " ")


def _either(names: tuple[str, ...]) -> str:
    return " or ".join([", ".join(f"`{name}`" for name in names[:-1])] * (len(names) > 1)
                       + [f"`{names[-1]}`"])


def _field_rows(fields: list[Field], path: bool) -> Iterator[str]:
    yield "| field | unit | default | meaning |"
    yield "|---|---|---|---|"
    for field in fields:
        parts = [capitalised(field.doc)]
        if field.requirement and field.kind not in ("choice", "flag", "path", "text"):
            parts.append(f"Must be {field.requirement}.")
        if field.choices:
            parts.append("; ".join(f"`{name}`: {doc}" for name, doc in field.choices) + ".")
        used = [f"`{other}` = {_either(names)}" for other, names in field.used_with]
        parts += [f"Used with {' or '.join(used)}."] if used else []
        name = field.path if path else field.name
        default = f"`{field.default}`" if field.default else ""
        meaning = " ".join(part if part.endswith((".", ")")) else f"{part}." for part in parts)
        unit = field.units.replace("^2", "²").replace("^3", "³")
        yield f"| `{name}` | {unit} | {_cell(default)} | {_cell(meaning)} |"


def case_file() -> str:
    """Every section and field."""
    lines: list[str] = []
    for section in SECTIONS.values():
        title = f"`[{section.name}]`" if section.name else "Top level"
        lines += [f"({anchor(section.name)})=", f"## {title}", "", *_sentence(section.doc)]
        if section.fields:
            lines += [*_field_rows(list(section.fields), path=False), ""]
    return "\n".join(lines)


def anchor(section: str) -> str:
    return f"section-{section or 'top'}".replace(".", "-").replace("_", "-")


def _sentence(text: str) -> list[str]:
    """A paragraph, unless it is empty."""
    text = text.strip().removesuffix(".")
    return [f"{capitalised(text)}.", ""] if text else []


def capitalised(text: str) -> str:
    """With a capital, unless a symbol is the beginning."""
    word = re.match(r"[a-z]{2,}\b", text)
    return text[:1].upper() + text[1:] if word else text


def fields(*selected: str) -> str:
    """Fields by name, or all that are used with a choice, as in ``friction.model=polach``."""
    found: list[Field] = []
    for entry in selected:
        selector, _, choice = entry.partition("=")
        if not choice:
            found.append(FIELDS[selector])
            continue
        if choice not in [name for name, _ in FIELDS[selector].choices]:
            raise ValueError(f"{selector} has no choice {choice}")
        used = [f for f in FIELDS.values() if choice in dict(f.used_with).get(selector, ())]
        found += [field for field in used if field not in found]
    return "\n".join(_field_rows(found, path=True))


#: Choices that are no laws.
_NO_LAWS = ("none", "full")


def laws(path: str) -> str:
    """The choices of a field, each with its page."""
    section = path.partition(".")[0]
    rows = []
    for name, doc in FIELDS[path].choices:
        stem = name.replace("-", "_")
        pages = [page for page in (f"{stem}_{section}", stem) if (LAWS / f"{page}.md").exists()]
        if not pages and name not in _NO_LAWS:
            raise ValueError(f"{path} = {name} has no page in {LAWS.name}")
        shown = f"[`{name}`](/laws/{pages[0]}.md)" if pages else f"`{name}`"
        rows.append(f"| {shown} | {_cell(doc)} |")
    return "\n".join([f"| `{path}` | |", "|---|---|", *rows])


# Python.


NO_BREAK = chr(0xA0)

#: Kinds of presets: heading and where the fields go.
PRESETS = {
    "materials": ("Materials", "For the sections `wheel` and `rail`."),
    "roughnesses": ("Roughnesses", 'For `contact_law={"roughness": …}`.'),
    "friction": ("Friction", "For the section `friction`."),
    "layers": ("Layers", "For the section `layer`."),
    "conditions": (
        "Conditions of the rail",
        "A first guess, for several sections: `Case(**schlupf.conditions.…)`.",
    ),
    "methods": ("Fast methods", "For several sections: `Case(**schlupf.methods.…)`."),
}


def presets() -> str:
    """Every preset with its fields and its source, group by group."""
    lines: list[str] = []
    for name, (title, use) in PRESETS.items():
        lines += [f"## {title}", "", use, ""]
        lines += ["| `schlupf.`… | what it is | fields | source |", "|---|---|---|---|"]
        group = getattr(schlupf, name)
        for preset, fields in ((preset, group[preset]) for preset in group):
            # Value and unit stay on one line.
            given = "<br>".join(
                f"`{path}`{NO_BREAK}{str(value).replace(' ', NO_BREAK)}"
                for path, value in _flat(fields)
            )
            what = capitalised(_cell(fields.doc))
            source = _cell(fields.source)
            lines.append(f"| `{name}.{preset}` | {what} | {given} | {source} |")
        lines.append("")
    return "\n".join(lines)


def _flat(fields: dict[str, Any], parent: str = "") -> Iterator[tuple[str, Any]]:
    for name, value in fields.items():
        path = f"{parent}.{name}" if parent else name
        if isinstance(value, dict):
            yield from _flat(value, path)
        else:
            yield path, value


def warnings() -> str:
    """Every warning with its category in Python and its meaning."""
    lines = ["| code | category in `schlupf.warnings` | meaning |", "|---|---|---|"]
    for code, meaning in sorted(warning_codes()):
        category = schlupf.warnings.BY_CODE[code].__name__
        lines.append(f"| `{code}` | `{category}` | {_cell(meaning)} |")
    return "\n".join(lines)


def errors() -> str:
    """Every error and its meaning."""
    lines = ["| code | meaning |", "|---|---|"]
    lines += [f"| `{code}` | {_cell(meaning)} |" for code, meaning in sorted(error_codes())]
    return "\n".join(lines)


def _shortened(app: Any, what: str, name: str, obj: Any, options: Any, lines: list[str]) -> None:
    """Leaves the fields of a case to the reference of the case file."""
    if name == "schlupf.Case" and "Notes" in lines:
        start = lines.index("Notes")
        lines[start:] = [
            "Notes",
            "-----",
            "Sections and fields: :doc:`/reference/case_file`.",
            "",
        ]


# The command.


def _help(*command: str) -> str:
    words = [sys.executable, "-m", "schlupf", *command, "--help"]
    environment = {**os.environ, "COLUMNS": "100", "NO_COLOR": "1"}
    run = subprocess.run(words, capture_output=True, text=True, check=True, env=environment)
    return run.stdout.rstrip()


def commands() -> str:
    """What each command takes, as it says itself."""
    listed = _help().partition("Commands:\n")[2].partition("\n\n")[0]
    names = re.findall(r"^  (\w+) ", listed, re.M)
    lines: list[str] = []
    for name in names:
        if name != "help":
            lines += [f"### {name}", "", "```text", _help(name), "```", ""]
    return "\n".join(lines)


# Files outside of docs.


def included(name: str) -> str:
    """A text of the top folder; its links to docs become links of the site."""
    text = (ROOT / name).read_text(encoding="utf-8")
    text = re.sub(r"\]\(docs/", "](/", text)
    # What else there is in the repository has no page.
    return re.sub(r"\[([^\]]*)\]\((?!/|https?:|#)[^)]*\)", r"\1", text)


def _readme(start: str, end: str) -> str:
    """Part of the README, from one text to another."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return text[text.index(start) : text.index(end, text.index(start))].strip()


def purpose() -> str:
    """What it is for, and for whom."""
    return _readme("schlupf computes", "![")


def cite() -> str:
    """The entries of `schlupf.cite()`."""
    return f"```bibtex\n{schlupf.cite().rstrip()}\n```"


def cited() -> Path:
    """A file with the same, for the bibliography."""
    path = TARGET / "site-cite.bib"
    path.parent.mkdir(exist_ok=True)
    path.write_text(schlupf.cite(), encoding="utf-8")
    return path


def alternatives() -> str:
    """The table against other programs."""
    table = _readme("| | schlupf |", "\n\n")
    return f"{table}\n\nIf a cell of this table is wrong or outdated, please open an issue."


def rust_example() -> str:
    """The program in Rust of the README."""
    return _readme("```rust", "```\n") + "\n```"


def data() -> str:
    """The validation data, to be downloaded."""
    text = included("data/README.md")
    return re.sub(r"`(\w[\w.]*\.csv)`", r"{download}`\1 </../data/\1>`", text)


GENERATED: dict[str, Callable[..., str]] = {
    "alternatives": alternatives,
    "case-file": case_file,
    "cite": cite,
    "commands": commands,
    "laws": laws,
    "data": data,
    "fields": fields,
    "included": included,
    "presets": presets,
    "purpose": purpose,
    "rust-example": rust_example,
    "warnings": warnings,
    "errors": errors,
}

COMMENT = re.compile(r"^<!-- generated: (.*) -->$", re.M)

#: Links to what lies outside of docs, with the pages that have it.
OUTSIDE = [
    (re.compile(r"\]\((?:\.\./)+data\)"), "](/reference/data.md)"),
    (re.compile(r"\]\((?:\.\./)+CHANGELOG\.md\)"), "](/reference/changelog.md)"),
    (re.compile(r"\]\((?:\.\./)+ARCHITECTURE\.md\)"), "](/reference/architecture.md)"),
    (re.compile(r"\]\((?:\.\./)+cases/?\)"), "](/gallery/index.md)"),
    (
        re.compile(r"\]\((?:\.\./)+cases/(\w+)\.toml\)"),
        lambda match: f"](/gallery/{match[1]}.md)",
    ),
]


def _read(app: Any, page: str, source: list[str]) -> None:
    def part(match: re.Match[str]) -> str:
        name, *arguments = shlex.split(match[1])
        return GENERATED[name](*arguments)

    text = COMMENT.sub(part, source[0])
    for pattern, target in OUTSIDE:
        text = pattern.sub(target, text)
    source[0] = text


def _seconds(app: Any, docname: str) -> float | None:
    """How long the code of a tutorial ran, with the wheel that is installed."""
    if not docname.startswith("tutorials/"):
        return None
    data = NbMetadataCollector.get_exec_data(app.env, docname)
    return data and data["runtime"]


def _tell_time(app: Any, doctree: nodes.document, docname: str) -> None:
    if seconds := _seconds(app, docname):
        text = f"The code of this page ran in {seconds:.0f} s when the site was built."
        title = next(doctree.findall(nodes.title))
        title.parent.insert(1, nodes.paragraph("", text))


def _print_times(app: Any, error: Exception | None) -> None:
    for docname in sorted(app.env.found_docs) if error is None else ():
        if seconds := _seconds(app, docname):
            print(f"{docname}: its code ran in {seconds:.1f} s")


def _add_mathjax(app: Any, error: Exception | None) -> None:
    spec = importlib.util.find_spec("sphinx-mathjax-offline")
    if error is None and app.builder.name == "html" and spec and spec.origin:
        script = app.config.mathjax_path
        target = Path(app.outdir) / "_static" / script
        target.parent.mkdir(exist_ok=True)
        shutil.copy(Path(spec.origin).parent / "static" / script, target)


def _add_rustdoc(app: Any, error: Exception | None) -> None:
    folder = TARGET / "doc"
    if error is None and folder.is_dir() and app.builder.name == "html":
        shutil.copytree(folder, Path(app.outdir) / "rust", dirs_exist_ok=True)


def setup(app: Any) -> dict[str, bool]:
    # Pages are read again when it changes.
    app.add_config_value("schlupf_digest", digest([*_of_pages(), Path(__file__)]), "env", str)
    app.connect("source-read", _read)
    app.connect("autodoc-process-docstring", _shortened, priority=100)
    app.connect("doctree-resolved", _tell_time)
    app.connect("build-finished", _print_times)
    app.connect("build-finished", _add_mathjax)
    app.connect("build-finished", _add_rustdoc)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
