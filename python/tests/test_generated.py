"""What is made of the tasks of the library is up to date."""

from generate_tasks import FILE, source


def test_the_methods_of_tasks_are_those_of_the_library():
    assert FILE.read_text(encoding="utf-8") == source()
