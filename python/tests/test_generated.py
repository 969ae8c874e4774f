"""What is made of the tasks of the library is up to date."""

from generate_tasks import FILE, source

import schlupf
from schlupf import _core


def test_the_methods_of_tasks_are_those_of_the_library():
    assert FILE.read_text(encoding="utf-8") == source()


def test_every_task_is_at_hand():
    for task in _core.tasks():
        assert hasattr(schlupf if task["is_of_argument"] else schlupf.Case, task["function"])
