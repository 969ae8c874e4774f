"""Types that Python has since 3.11."""

from __future__ import annotations

import sys

if sys.version_info >= (3, 11):
    from typing import Never, Self, TypedDict, Unpack
else:
    from typing_extensions import Never, Self, TypedDict, Unpack

__all__ = ["Never", "Self", "TypedDict", "Unpack"]
