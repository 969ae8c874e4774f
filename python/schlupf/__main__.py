"""The command ``schlupf``."""

from ._command import main

main()
