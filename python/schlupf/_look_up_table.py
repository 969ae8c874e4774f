"""Creep forces from look-up tables, with derivatives, for arrays of states."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _core
from ._errors import quoted

if TYPE_CHECKING:
    import os

    from numpy.typing import ArrayLike, NDArray


class TableForces(NamedTuple):
    """Forces of an array of states, and where the table holds."""

    #: Fx, Fy and Mz along the last axis: in N and N m, or normalised.
    force: NDArray[np.float64]
    #: Their derivatives: the last axis counts what they are taken by, the one before it Fx, Fy, Mz.
    derivatives: NDArray[np.float64]
    #: Whether the table covers the shape of the patch; where not, forces are those of the nearest.
    in_range: NDArray[np.bool_]


class LookUpTable:
    """A table of `schlupf table`: creep forces of the half-space with Coulomb's law.

    Forces act on the wheel; Mz is taken about the centre of the patch. All arguments broadcast.

    >>> import schlupf
    >>> table = schlupf.LookUpTable()
    >>> found = table.forces(6e-3, 4e-3, 24e3, creepage_x=[0.0, 1e-4, 0.02])
    >>> bool(found.force[2, 0] < -23.9e3 and found.in_range.all())
    True
    """

    def __init__(self, path: str | os.PathLike[str] | None = None) -> None:
        """Read a table from a .npz file; without one, take the standard table (ν = 0.28)."""
        self._table = _core.LookUpTable(None if path is None else Path(path))

    @property
    def metadata(self) -> dict[str, Any]:
        """What the file says: ν, nodes, errors, version."""
        found: dict[str, Any] = json.loads(self._table.metadata())
        return found

    @property
    def axis_ratios(self) -> tuple[float, float]:
        """Smallest and largest a/b."""
        low, high = self._table.axis_ratios()
        return low, high

    def __repr__(self) -> str:
        """Show ν and the range of a/b."""
        low, high = self.axis_ratios
        return f"LookUpTable(a/b from {low:g} to {high:g}, ν = {self.metadata['poisson_ratio']:g})"

    def normalised(
        self,
        axis_ratio: ArrayLike,
        creepage_x: ArrayLike = 0.0,
        creepage_y: ArrayLike = 0.0,
        spin: ArrayLike = 0.0,
    ) -> TableForces:
        """Fx/(μN), Fy/(μN), Mz/(μN √(ab)) at a/b and (ξ', η', φ') = G ab/(μN) (ξ, η, √(ab) φ).

        Derivatives are with respect to ξ', η' and φ'.
        """
        arrays = np.broadcast_arrays(axis_ratio, creepage_x, creepage_y, spin)
        shape = arrays[0].shape
        flat: list[NDArray[np.float64]] = [np.array(part, dtype=float).ravel() for part in arrays]
        ratio, *creepages = flat
        force, derivatives, in_range = self._table.normalised(ratio, creepages)
        return TableForces(
            force.reshape(*shape, 3), derivatives.reshape(*shape, 3, 3), in_range.reshape(shape)
        )

    def forces(
        self,
        semi_axis_x: ArrayLike,
        semi_axis_y: ArrayLike,
        friction_limit: ArrayLike,
        creepage_x: ArrayLike = 0.0,
        creepage_y: ArrayLike = 0.0,
        spin: ArrayLike = 0.0,
        shear_modulus: ArrayLike = 210e9 / 2.56,
    ) -> TableForces:
        """Forces in N and N m on patches with semi-axes in m, under creepages and spin (in 1/m).

        The friction limit is μN in N, above 0; the shear modulus the combined one of both bodies in
        Pa, that of steel by default. Derivatives are with respect to ξ, η and φ.
        """
        return self._scaled(
            (semi_axis_x, semi_axis_y, friction_limit, shear_modulus),
            (creepage_x, creepage_y, spin),
            1.0,
        )

    def standstill_forces(
        self,
        semi_axis_x: ArrayLike,
        semi_axis_y: ArrayLike,
        friction_limit: ArrayLike,
        slip: tuple[ArrayLike, ArrayLike, ArrayLike],
        speed: ArrayLike,
        standstill_speed: float,
        shear_modulus: ArrayLike = 210e9 / 2.56,
    ) -> TableForces:
        """Forces under slip velocities (m/s, m/s, rad/s) at a rolling speed that may be zero.

        Creepages are slip velocities over √(v² + v_s²), with the standstill speed v_s in m/s, so
        that forces go by the slip velocities alone at v = 0. A negative speed is that of rolling
        backwards, where the lateral force of a spin has the other sign; between -v_s and v_s one
        passes into the other. Derivatives are with respect to the slip velocities, and finite.
        """
        if not standstill_speed > 0.0:
            raise ValueError(f"standstill_speed must be above 0, but is {quoted(standstill_speed)}")
        reference = np.hypot(speed, standstill_speed)
        x, y, about = (np.asarray(part, dtype=float) / reference for part in slip)
        patch = (semi_axis_x, semi_axis_y, friction_limit, shear_modulus)
        place = np.clip(np.asarray(speed, dtype=float) / standstill_speed, -1.0, 1.0)
        forwards = self._scaled(patch, (x, y, about), reference)
        if (place >= 1.0).all():
            return forwards
        # The frame turned by π rolls forwards.
        turn = np.array([-1.0, -1.0, 1.0])
        turned = self._scaled(patch, (-x, -y, about), reference)
        share = np.broadcast_to(0.5 + 0.25 * place * (3.0 - place**2), forwards.in_range.shape)
        ahead, back = share[..., None], 1.0 - share[..., None]
        return TableForces(
            ahead * forwards.force + back * turn * turned.force,
            ahead[..., None] * forwards.derivatives
            + back[..., None] * turn[:, None] * turn * turned.derivatives,
            forwards.in_range,
        )

    def _scaled(
        self,
        patch: tuple[ArrayLike, ArrayLike, ArrayLike, ArrayLike],
        creepages: tuple[ArrayLike, ArrayLike, ArrayLike],
        speed: ArrayLike,
    ) -> TableForces:
        arrays = np.broadcast_arrays(*patch, *creepages, speed)
        a, b, limit, shear, xi, eta, spin, reference = (
            np.asarray(part, dtype=float) for part in arrays
        )
        names = ("semi_axis_x", "semi_axis_y", "friction_limit", "shear_modulus")
        for name, part in zip(names, (a, b, limit, shear), strict=True):
            wrong = ~((part > 0.0) & np.isfinite(part))
            if wrong.any():
                raise ValueError(f"{name} must be above 0 and finite, but is {part[wrong][0]}")
        lever = np.sqrt(a * b)
        unit = shear * a * b / limit
        found = self.normalised(a / b, unit * xi, unit * eta, unit * lever * spin)
        one = np.ones_like(lever)
        arms = np.stack([one, one, lever], axis=-1)
        slope = (limit * unit / reference)[..., None, None]
        derivatives = slope * arms[..., :, None] * arms[..., None, :] * found.derivatives
        return TableForces(limit[..., None] * arms * found.force, derivatives, found.in_range)
