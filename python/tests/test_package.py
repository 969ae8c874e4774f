"""What the package says of itself, in all places alike."""

import re
from pathlib import Path

import pytest

import schlupf

ROOT = Path(__file__).parents[2]


def lists(text, key):
    """The entries of a list in TOML or YAML, without their comments."""
    found = re.search(rf"^\s*{key}(?: = \[|:)\n((?:\s+(?:-|\"|#).*\n)+)", text, re.MULTILINE)
    entries = [line.strip().strip('-",').strip() for line in found[1].splitlines()]
    return [entry.strip('" ') for entry in entries if not entry.startswith("#")]


def test_the_recipe_of_conda_needs_what_the_package_needs():
    project = (ROOT / "pyproject.toml").read_text()
    recipe = (ROOT / "python/conda/meta.yaml").read_text()
    assert f'version = "{schlupf.__version__}"' in recipe
    named = {re.split(r"[ >=<;]", entry)[0]: entry for entry in lists(project, "dependencies")}
    run = {entry.split(" ")[0]: entry for entry in lists(recipe, "run")}
    assert set(run) == {"python", *named}
    for name, entry in named.items():
        assert re.search(r">=[\d.]+", entry)[0] in run[name], name
    least = re.search(r'requires-python = ">=([\d.]+)"', project)[1]
    assert f"skip: true  # [py<{least.replace('.', '')}]" in recipe
    assert re.search(r'requires = \["maturin(\S+)"\]', project)[1] in recipe


def test_the_citation_is_that_of_the_file():
    file = (ROOT / "CITATION.cff").read_text()
    text = schlupf.cite()
    for title in re.findall(r'title: "(.*)"', file):
        assert f"{{{title}}}" in text
    assert f"version: {schlupf.__version__}" in file and f"{{{schlupf.__version__}}}" in text
    assert "year      = {2014}" in text and "year: 2014" in file


@pytest.mark.parametrize("name", ["README.md", "python/README.md", "docs/python.md"])
def test_nobody_is_sent_to_an_index_where_it_is_not(name):
    assert not re.search(r"pip install \"?schlupf", (ROOT / name).read_text())


def test_a_star_import_keeps_the_warnings_of_python():
    names = {}
    exec("import warnings\nfrom schlupf import *", names)
    assert names["warnings"].__name__ == "warnings" and "Case" in names
