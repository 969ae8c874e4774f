"""The gallery: a page for each case of the folder `cases`, and cards that lead to them.

A page has the case as TOML, the program in Python that asks the same, which is run for the figures,
and what the command prints. The programs that the comment at the head of a case names, such as
`schlupf subsurface`, are run, too. Pages are written when the site is built, and again only where
the package or the cases have changed.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import warnings
from collections.abc import Iterator
from contextlib import chdir
from pathlib import Path
from pprint import pformat
from typing import Any

import figure_text
import matplotlib as mpl
import matplotlib.pyplot as plt
import site_content
import tomllib
from docutils import nodes

import schlupf

FOLDER = site_content.DOCS / "gallery"
CASES = site_content.ROOT / "cases"

#: The folder with the explorer, if it was built: `cargo xtask web`.
EXPLORER = site_content.ROOT / "web/dist"

#: Columns of the code of a page.
WIDTH = 88


def title(path: Path) -> str:
    """The title of a case, with a capital."""
    text = tomllib.loads(path.read_text(encoding="utf-8")).get("title", path.stem)
    # Not a symbol, such as k_c.
    return text[:1].upper() + text[1:] if re.match(r"a |[a-z]{2,}\b", text) else text


# The program of a case.


def constructor(path: Path) -> list[str]:
    """The case as a call of the package."""
    values = tomllib.loads(path.read_text(encoding="utf-8"))
    arguments = (f"    {_keyword(name, value)}," for name, value in values.items())
    return ["case = schlupf.Case(", *"\n".join(arguments).splitlines(), ")"]


def _keyword(name: str, value: Any) -> str:
    """An argument with its value, which may take several lines."""
    text = pformat(value, width=WIDTH - len(name) - 6, sort_dicts=False).replace("'", '"')
    return f"{name}={text}".replace("\n", "\n" + " " * (len(name) + 5))


def plots(result: schlupf.Result, case: schlupf.Case) -> list[str]:
    """What a solution is shown by, if it has fields: the traction and what sets it apart."""
    if not result.fields["contact"].any():
        return []
    if result.history.sizes["time"] > 1:
        return ["traction", "history"]
    if case.normal.model not in ("hertz", "ellipse", "line"):
        return ["pressure", "traction"]
    return ["traction", "temperature" if result.temperature.max_rise else "stick_slip"]


_COMMAND = re.compile(r"""schlupf \w+(?: +cases/\w+\.toml)?(?: +--[\w-]+ +(?:"[^"]*"|[^\s"`])+)*""")


def tasks(path: Path) -> Iterator[tuple[str, list[str]]]:
    """Tasks that the comment at the head of a case names, with their options."""
    head = re.match(r"(?:#.*\n)*", path.read_text(encoding="utf-8"))
    assert head is not None
    comment = re.sub(r"\n#\s*", " ", head[0]).replace("\\ ", "")
    for found in _COMMAND.finditer(comment):
        task, *words = shlex.split(found[0].removeprefix("schlupf "))
        case = f"cases/{path.name}"
        if task != "solve" and hasattr(schlupf.Case, task) and (not words or words[0] == case):
            yield task, words[1:]


def call(task: str, options: list[str]) -> str:
    """A command as a call of the package."""
    arguments = []
    over = {}
    for name, value in zip(options[::2], options[1::2], strict=True):
        keyword = name.removeprefix("--").replace("-", "_")
        if keyword == "over":
            field, _, values = value.partition("=")
            over[field] = values.split(",")
        elif keyword != "figures":
            arguments.append(f'{keyword}="{value}"')
    arguments += [_keyword("over", over)] if over else []
    line = f"{task} = case.{task}({', '.join(arguments)})"
    if len(line) <= WIDTH:
        return line
    return "\n".join([f"{task} = case.{task}(", *(f"    {a}," for a in arguments), ")"])


# What is run.


class Program:
    """A program in Python, whose blocks are run one after the other."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.names: dict[str, Any] = {}

    def run(self, lines: list[str], apart: bool = True) -> None:
        self.lines += ["", *lines] if apart and self.lines else lines
        with warnings.catch_warnings(), chdir(CASES):
            warnings.simplefilter("ignore", schlupf.SchlupfWarning)
            exec("\n".join(lines), self.names)

    def __getitem__(self, name: str) -> Any:
        return self.names[name]


def figure(name: str) -> tuple[str, str]:
    """Saves the current figure of a page; its file and its description."""
    current = plt.gcf()
    words = figure_text.described(current)
    current.savefig(FOLDER / name)
    plt.close("all")
    return name, words


def write(path: Path) -> tuple[str, str]:
    """Writes the page of a case; the picture for its card, with its description.

    That is the traction, or what the task shows that the case is made for.
    """
    program = Program()
    program.run(["import schlupf"])
    program.run(constructor(path))
    case, original = program["case"], schlupf.Case.from_file(path)
    with chdir(CASES):
        if case.effective() != original.effective():
            raise AssertionError(f"{path.name} is another case in Python")
    program.run(["result = case.solve()"])
    pictures = []

    def draw(call: str, name: str) -> None:
        program.run([call], apart=False)
        pictures.append(figure(f"{path.stem}_{name}.png"))

    for name in plots(program["result"], case):
        draw(f"result.plot.{name}()", name)
    commands = [f"schlupf solve cases/{path.name} --figures figures"]
    for task, options in tasks(path):
        program.run([call(task, options)])
        commands.append(shlex.join(["schlupf", task, f"cases/{path.name}", *options]))
        if (plot := getattr(program[task], "plot", None)) is not None:
            # Where there are several plots, the last.
            last = [name for name in vars(type(plot)) if not name.startswith("_")][-1:]
            draw(f"{task}.plot{'' if callable(plot) else '.' + last[0]}()", task)
    relative = os.path.relpath(path, FOLDER)
    code = "\n".join(program.lines)
    shell = "\n".join(commands)
    page = [
        f"# {title(path)}",
        "",
        "::::{grid} 1 2 2 2",
        ":gutter: 2",
        *(f":::{{grid-item}}\n![{words}]({name})\n:::" for name, words in pictures),
        "::::",
        "::::{tab-set}",
        *_tab("Case file", "toml", path.read_text(encoding="utf-8").rstrip()),
        *_tab("Python", "python", code),
        *_tab("Command", "sh", shell),
        "::::",
        "",
        f"{{download}}`{path.name} <{relative}>`{_in_explorer(path.stem, '../', ', ')}",
        "",
        "## Summary",
        "",
        "```text",
        program["result"].summary().rstrip(),
        "```",
    ]
    (FOLDER / f"{path.stem}.md").write_text("\n".join(page) + "\n", encoding="utf-8")
    return pictures[-1 if len(commands) > 1 else 0]


def _in_explorer(case: str, top: str, before: str) -> str:
    """A link from below the top folder to the explorer with a case, if the site has both."""
    if not ((EXPLORER / "explore/index.html").exists() and (CASES / f"{case}.toml").exists()):
        return ""
    return f'{before}<a href="{top}explore/index.html#case={case}">open it in the explorer</a>'


#: Pages of which figures need no further link to the explorer.
LINKED = ("gallery/", "explorer")


def _link_figures(app: Any, doctree: nodes.document) -> None:
    """Figures lead to their case in the explorer: in notebooks that of the code that draws them,
    elsewhere that of the command before them in their section."""
    page = app.env.docname
    if page.startswith(LINKED):
        return
    case = ""
    kinds = (nodes.section, nodes.literal_block, nodes.image)
    for node in list(doctree.findall(lambda node: isinstance(node, kinds))):
        if isinstance(node, nodes.section):
            case = ""
        elif isinstance(node, nodes.literal_block):
            case = figure_text.case_named(node.astext()) or case
        else:
            path = Path(app.srcdir) / node["uri"]
            is_picture = path.suffix == ".png" and path.is_file()
            is_drawn = is_picture and figure_text.of_picture(path)
            of = figure_text.of_picture(path, figure_text.CASE) if is_drawn else case
            if link := _in_explorer(of, "../" * page.count("/"), "<br>"):
                place = node.parent.index(node) + 1
                node.parent.insert(place, nodes.raw("", link, format="html"))


def _tab(name: str, language: str, text: str) -> list[str]:
    return [f":::{{tab-item}} {name}", f"````{language}", text, "````", ":::"]


def cards() -> str:
    """A card for each case."""
    lines = ["::::{grid} 2 2 3 3", ":gutter: 3", ""]
    for path in sorted(CASES.glob("*.toml")):
        name, words = (FOLDER / f"{path.stem}.card").read_text(encoding="utf-8").split("\n", 1)
        lines += [
            f":::{{grid-item-card}} {title(path)}",
            f":link: {path.stem}",
            ":link-type: doc",
            f":img-top: /gallery/{name}",
            f":img-alt: {words.strip()}",
            ":::",
        ]
    lines += ["::::", "", "```{toctree}", ":hidden:", ""]
    return "\n".join([*lines, *(path.stem for path in sorted(CASES.glob("*.toml"))), "```"])


def _write_all(app: Any) -> None:
    """Writes the pages, unless they are those of this package and these cases."""
    files = [*site_content.of_notebooks(), Path(__file__), Path(figure_text.__file__)]
    wanted = site_content.digest([*files, site_content.DOCS / "matplotlibrc"])
    mark = FOLDER / "made_of"
    if mark.is_file() and mark.read_text(encoding="utf-8") == wanted:
        return
    for old in FOLDER.iterdir() if FOLDER.is_dir() else ():
        if old.name not in KEPT:
            shutil.rmtree(old) if old.is_dir() else old.unlink()
    mpl.use("agg")
    with mpl.rc_context(fname=site_content.DOCS / "matplotlibrc"):
        for path in sorted(CASES.glob("*.toml")):
            name, words = write(path)
            (FOLDER / f"{path.stem}.card").write_text(f"{name}\n{words}", encoding="utf-8")
    mark.write_text(wanted, encoding="utf-8")


#: The only file of the folder that is not made.
KEPT = ("index.md",)


def setup(app: Any) -> dict[str, bool]:
    site_content.GENERATED["gallery"] = cards
    # Before Sphinx looks for pages.
    app.connect("builder-inited", _write_all)
    # Before Sphinx collects the pictures.
    app.connect("doctree-read", _link_figures, priority=100)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
