"""What is made of the library is up to date."""

import pytest
from generate import SOURCES

import schlupf
from schlupf._fields import CATALOGUE


@pytest.mark.parametrize("file", SOURCES, ids=lambda file: file.name)
def test_modules_follow_from_the_library(file):
    assert file.read_text(encoding="utf-8") == SOURCES[file]()


def test_every_task_is_at_hand():
    for task in CATALOGUE["tasks"]:
        assert hasattr(schlupf if task["is_of_argument"] else schlupf.Case, task["function"])
