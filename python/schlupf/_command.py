"""The command ``schlupf``, also as ``python -m schlupf``."""

from __future__ import annotations

import sys

from ._core import command


def main() -> None:
    """Runs the command with the arguments of the process, and ends it with its exit code."""
    sys.exit(command(["schlupf", *sys.argv[1:]]))
