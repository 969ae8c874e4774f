"""Rolling contact of wheel and rail: creep forces, stress, slip and temperature.

>>> import schlupf
>>> case = schlupf.Case(normal={"load": "80 kN"}, kinematics={"creepage_x": 0.008})
>>> result = case.solve()
>>> round(result.force.x / 1000)  # kN, on the wheel
-30
>>> result.fields["pressure"].attrs["units"]
'Pa'

Numbers are in SI units (temperatures in °C, differences in K), text has its unit. Forces and
tractions act on the wheel.
"""

from . import examples, records, sections
from . import warnings as warnings
from ._case import Case
from ._cite import cite
from ._contact_table import ContactTableErrors, Spread, contact_table
from ._core import __version__
from ._element import Element, Evaluation, Signal, element
from ._errors import CaseError, CaseFileError, CaseNotConverged, NotConverged, SchlupfWarning
from ._forces import Solver, forces
from ._imports import import_contact
from ._look_up_table import LookUpTable, TableForces
from ._plots import ResultPlots
from ._plots import comparison as plot_comparison
from ._plots import frames as animate
from ._preset import Preset
from ._presets import conditions, friction, layers, materials, methods, roughnesses
from ._record import Record
from ._report import (
    BulkTemperature,
    Calibration,
    Comparison,
    Curve,
    Damage,
    Fit,
    Report,
    RoughContact,
    Subsurface,
    Temperatures,
    Wear,
    Wheelset,
)
from ._report_plots import RoughContactPlots
from ._result import Result, open_result
from ._section import Section
from ._status import Status
from ._study import Study, Sweep, merge, open_table, read_table, study, sweep
from ._surfaces import open_surface
from ._tasks import damage, roughness

__all__ = [
    "BulkTemperature",
    "Calibration",
    "Case",
    "CaseError",
    "CaseFileError",
    "CaseNotConverged",
    "Comparison",
    "ContactTableErrors",
    "Curve",
    "Damage",
    "Element",
    "Evaluation",
    "Fit",
    "LookUpTable",
    "NotConverged",
    "Preset",
    "Record",
    "Report",
    "Result",
    "ResultPlots",
    "RoughContact",
    "RoughContactPlots",
    "SchlupfWarning",
    "Section",
    "Signal",
    "Solver",
    "Spread",
    "Status",
    "Study",
    "Subsurface",
    "Sweep",
    "TableForces",
    "Temperatures",
    "Wear",
    "Wheelset",
    "__version__",
    "animate",
    "cite",
    "conditions",
    "contact_table",
    "damage",
    "element",
    "examples",
    "forces",
    "friction",
    "import_contact",
    "layers",
    "materials",
    "merge",
    "methods",
    "open_result",
    "open_surface",
    "open_table",
    "plot_comparison",
    "read_table",
    "records",
    "roughness",
    "roughnesses",
    "sections",
    "study",
    "sweep",
]
