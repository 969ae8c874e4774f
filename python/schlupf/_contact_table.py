"""Tables of the contacts of a wheel with two profiles."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple
from warnings import warn as issue

from . import _core
from ._ask import Argument
from ._errors import SchlupfWarning
from ._result import unfinished, with_folder
from ._units import File, Number, plain

if TYPE_CHECKING:
    from ._case import Case


class Spread(NamedTuple):
    """An error over random poses."""

    median: float
    #: 90 % are below it.
    ninety_percent: float
    #: 99 % are below it.
    ninety_nine_percent: float
    largest: float


class ContactTableErrors(NamedTuple):
    """Errors of the contacts of a table against exact ones, in random poses."""

    #: Whether the normal force between nodes is within the tolerance.
    is_within_tolerance: bool
    #: Nodes without an exact contact, which have the values of their neighbours.
    failed_nodes: int
    #: Number of poses that have an exact contact.
    poses: int
    #: Of the normal force of a contact over that of the wheel.
    load: Spread
    #: Of the place on the rail, in m.
    place: Spread
    #: Of the contact angle, in rad.
    angle: Spread
    #: Of the centre of pressure, in m.
    centre: Spread


def contact_table(
    case: Case,
    path: File,
    *,
    largest_roll_angle: Number | None = None,
    largest_yaw_angle: Number | None = None,
    tolerance: float | None = None,
    most_nodes: int = 200_000,
    poses: int = 400,
    warn: bool = True,
) -> ContactTableErrors:
    """Makes the table of the contacts of a wheel with two profiles, for its force element.

    With ``element={"contact_table": path}`` in the case `schlupf.element` is the wheel. Ctrl-C ends
    the work, and then there is no file.

    Parameters
    ----------
    case : Case
        One with ``normal.model = "wheel-rail"``.
    path : path
        The table, a ``.npz`` file.
    largest_roll_angle, largest_yaw_angle : float or str, optional
        Largest angles of the wheelset relative to the rail, either way, in rad or as text with a
        unit; by default 15 mrad and 30 mrad.
    tolerance : float, default 0.005
        Largest error of the normal force between nodes, above which the table is refined.
    most_nodes : int, default 200000
        Refining that would need more is not begun.
    poses : int, default 400
        Random poses in which the errors are measured.
    warn : bool, default True
        Whether to warn of a table that is not within the tolerance.

    Returns
    -------
    ContactTableErrors
        The errors, which the file states, too.

    Raises
    ------
    CaseError
        If the case has no two profiles, or if they change along the way.

    Examples
    --------
    >>> import schlupf
    >>> case = schlupf.Case(
    ...     normal={"model": "wheel-rail", "load": "50 kN"},
    ...     wheel={"profile": "S1002"},
    ...     rail={"profile": "60E1", "cant": 0.025},
    ...     friction={"model": "constant", "coefficient": 0.3},
    ...     solver={"method": "polach"},
    ... )
    >>> errors = schlupf.contact_table(case, "contacts.npz", tolerance=0.05)  # doctest: +SKIP
    >>> case.element.contact_table = "contacts.npz"  # doctest: +SKIP
    >>> wheel = schlupf.element(case)  # doctest: +SKIP
    """
    for name, count in (("most_nodes", most_nodes), ("poses", poses)):
        if count < 1:
            raise ValueError(f"{name} must be at least 1, but is {count}")
    path = with_folder(path)
    if path.suffix != ".npz":
        raise ValueError(f"path must end in .npz, but is {path}")
    angles = [
        plain(value, Argument("rad"), name)
        for name, value in (
            ("largest_roll_angle", largest_roll_angle),
            ("largest_yaw_angle", largest_yaw_angle),
        )
    ]
    # A file that cannot be written is told before the work.
    with unfinished(path) as part, part.open("wb") as file:
        made = _core.contact_table(case._file, angles, tolerance, (most_nodes, poses))
        bytes_of_table, (is_within_tolerance, failed_nodes, found), spreads = made
        file.write(bytes_of_table)
    if warn and not is_within_tolerance:
        text = f"{path} is not within the tolerance: refining needs more than {most_nodes} nodes"
        issue(SchlupfWarning(text, "is_within_tolerance"), stacklevel=2)
    of_poses = [Spread(*spread) for spread in spreads]
    return ContactTableErrors(is_within_tolerance, failed_nodes, found, *of_poses)
