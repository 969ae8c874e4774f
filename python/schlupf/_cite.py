"""How to cite the package."""

from __future__ import annotations

from ._core import __version__

#: That of the software, and of the model that it implements, as in CITATION.cff.
ENTRIES = """\
@software{{schlupf,
  author  = {{{{The schlupf developers}}}},
  title   = {{schlupf: rolling contact with friction, coupled elasticity, roughness and heat}},
  version = {{{version}}},
}}

@inproceedings{{neuhaus_sextro_2014,
  author    = {{Neuhaus, Jan and Sextro, Walter}},
  title     =
    {{Thermo-Mechanical Model for Wheel Rail Contact using Coupled Point Contact Elements}},
  booktitle = {{Proceedings of the International Conference on Computational Methods (ICCM 2014)}},
  year      = {{2014}},
}}
"""


def cite() -> str:
    """Entries of BibTeX: the software in its version, and the model that it implements.

    Sources of single laws and methods are in their documentation and in the summary of a task.

    >>> import schlupf
    >>> print(schlupf.cite().splitlines()[0])
    @software{schlupf,
    """
    return ENTRIES.format(version=__version__)
