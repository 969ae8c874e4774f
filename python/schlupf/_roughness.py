"""Rough surfaces on their own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._report import RoughContact
from ._tasks import Tasks

if TYPE_CHECKING:
    from ._case import Case
    from ._units import Surface


def roughness(surface: Surface, *, case: Case | None = None, **options: Any) -> RoughContact:
    """k_c from a rough surface, with statistics, contact area and tangential curves.

    Parameters
    ----------
    surface : array, DataArray, path, Topography or Surface
        Heights: rows along x, in m, with their ``spacing`` (m) among the options; over x and y, or
        over x alone; levels of one-third octave bands (EN 15610), as a mapping or data frame with
        ``wavelength`` (m) and ``level`` (dB); a file of the library or of an instrument
        (`open_surface`); an object of SurfaceTopography or surfalize.
    case : Case, optional
        Of the bodies; by default steel wheel and rail.
    **options
        Of `Case.roughness`, such as ``second``, ``form``, ``cutoff`` and ``fill_holes``.

    Raises
    ------
    CaseError
        If it is no surface: with holes that are not to be filled, in a wrong unit, of cells that
        are not square.

    Examples
    --------
    >>> import numpy as np
    >>> import schlupf
    >>> heights = np.random.default_rng(1).normal(scale=1e-6, size=(64, 64))
    >>> found = schlupf.roughness(heights, spacing=1e-5, pressure=[0.4e9, 0.8e9], warn=False)
    >>> round(found.surface.root_mean_square_height * 1e6)
    1
    """
    of: Any = case
    # Without a case the pressures are others, too.
    return Tasks.roughness(of, surface=surface, **options)
