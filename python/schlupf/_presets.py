"""Constants to start with, each with its source.

Made of the presets of the library by tests/generate.py.
"""

from __future__ import annotations

from ._preset import Preset, Presets
from ._section import Entry
from ._typing import Never
from .sections import (
    FrictionFields,
    LayerFields,
    RailFields,
    RoughnessFields,
    SectionFields,
    WheelFields,
)


class Conditions(Presets[SectionFields], group="conditions"):
    """Conditions of the rail, for a first guess: ``Case(**conditions.wet)``."""

    dry: Entry[Preset[SectionFields], Never] = Entry()
    """dry rail: friction falls with the slip speed; Polach's method takes methods.polach_dry, too
    (Polach, Wear 258 (2005) 992–1000)."""
    leaves: Entry[Preset[SectionFields], Never] = Entry()
    """damp film of leaves: middle of 0.05 to 0.1, measured on the rail by hand-pushed tribometer
    (Olofsson and Lewis, in: Iwnicki (ed.), Handbook of Railway Vehicle Dynamics (2006), ch. 5)."""
    oil: Entry[Preset[SectionFields], Never] = Entry()
    """much grease on the rail: middle of 0.05 to 0.1, measured by hand-pushed tribometer (Olofsson
    and Lewis, in: Iwnicki (ed.), Handbook of Railway Vehicle Dynamics (2006), ch. 5)."""
    sanded: Entry[Preset[SectionFields], Never] = Entry()
    """dry rail with a layer of sand, which flows at 400 MPa; that it softens (layers.sand) is left
    out (Polach, Wear 258 (2005) 992–1000; Hou, Kalousek and Magel (1997), by way of the user guide
    for CONTACT)."""
    wet: Entry[Preset[SectionFields], Never] = Entry()
    """wet rail: friction falls with the slip speed; Polach's method takes methods.polach_wet, too
    (Polach, Wear 258 (2005) 992–1000)."""


class Friction(Presets[FrictionFields], group="friction"):
    """Friction laws with their constants, for ``friction``."""

    eurosprinter: Entry[Preset[FrictionFields], Never] = Entry()
    """locomotive Eurosprinter 127 001, from modified FASTSIM (Spiryagin, Polach and Cole, Vehicle
    System Dynamics 51 (2013), as CONTACT's example has it)."""
    neuhaus_sextro: Entry[Preset[FrictionFields], Never] = Entry()
    """falls linearly with temperature and vanishes 700 K above the reference (Neuhaus and Sextro,
    ICCM 2014, Eq. (23))."""
    polach_dry: Entry[Preset[FrictionFields], Never] = Entry()
    """dry rail; falls with the slip speed (Polach, Wear 258 (2005) 992–1000)."""
    polach_wet: Entry[Preset[FrictionFields], Never] = Entry()
    """wet rail; falls with the slip speed (Polach, Wear 258 (2005) 992–1000)."""


class Layers(Presets[LayerFields], group="layers"):
    """Layers between the surfaces, for ``layer``."""

    clay: Entry[Preset[LayerFields], Never] = Entry()
    """clay: elastic to 40 µm, 200 MPa, then 400 MPa/mm of the whole displacement; under 900 MPa
    (Hou, Kalousek and Magel (1997), by way of the user guide for CONTACT)."""
    eurosprinter: Entry[Preset[LayerFields], Never] = Entry()
    """contaminants under the locomotive Eurosprinter 127 001: h/G = 1.52e-13 m/Pa (Vollebregt,
    User guide for CONTACT, example of creep force curves)."""
    magnetite: Entry[Preset[LayerFields], Never] = Entry()
    """magnetite: elastic to 70 µm, then at 560 MPa; under 900 MPa. Only h/G counts, h is set to 1
    mm (Hou, Kalousek and Magel (1997), by way of the user guide for CONTACT)."""
    molybdenum_disulphide: Entry[Preset[LayerFields], Never] = Entry()
    """MoS2: elastic to 20 µm, 20 MPa, then 20 MPa/mm of the whole displacement; under 900 MPa
    (Hou, Kalousek and Magel (1997), by way of the user guide for CONTACT)."""
    sand: Entry[Preset[LayerFields], Never] = Entry()
    """sand: elastic to 50 µm, 400 MPa, then −200 MPa/mm of the whole displacement; under 900 MPa
    (Hou, Kalousek and Magel (1997), by way of the user guide for CONTACT)."""


class Materials(Presets[WheelFields | RailFields], group="materials"):
    """Materials, for ``wheel`` and ``rail``."""

    aluminium: Entry[Preset[WheelFields | RailFields], Never] = Entry()
    """pure aluminium, for twin-disc tests (Kaye and Laby, Tables of physical and chemical
    constants (elastic); CRC Handbook of chemistry and physics (thermal))."""
    steel: Entry[Preset[WheelFields | RailFields], Never] = Entry()
    """wheel and rail steel (Neuhaus and Sextro, ICCM 2014)."""
    steel_contact: Entry[Preset[WheelFields | RailFields], Never] = Entry()
    """wheel and rail steel with G = 82 GPa, as in the examples of CONTACT (Vollebregt, User guide
    for CONTACT)."""


class Methods(Presets[SectionFields], group="methods"):
    """Fast methods with their constants: ``Case(**methods.polach_dry)``."""

    eurosprinter: Entry[Preset[SectionFields], Never] = Entry()
    """modified FASTSIM of the locomotive Eurosprinter 127 001; goes with friction.eurosprinter
    (Spiryagin, Polach and Cole, Vehicle System Dynamics 51 (2013); β = 0.62 there, whose ε is half
    of ours)."""
    modified_fastsim: Entry[Preset[SectionFields], Never] = Entry()
    """modified FASTSIM; constants that make its longitudinal forces those of Polach on a dry rail
    (Spiryagin, Polach and Cole, Vehicle System Dynamics 51 (2013); constants by schlupf)."""
    polach_dry: Entry[Preset[SectionFields], Never] = Entry()
    """Polach's method with the reductions of a dry rail; goes with friction.polach_dry (Polach,
    Wear 258 (2005) 992–1000)."""
    polach_wet: Entry[Preset[SectionFields], Never] = Entry()
    """Polach's method with the reductions of a wet rail; goes with friction.polach_wet (Polach,
    Wear 258 (2005) 992–1000)."""


class Roughnesses(Presets[RoughnessFields], group="roughnesses"):
    """Roughnesses, for ``contact_law={"roughness": …}``."""

    ground_rail: Entry[Preset[RoughnessFields], Never] = Entry()
    """the roughest a reprofiled rail may be, Ra = 10 µm; h_rms = √(π/2) Ra for Gaussian heights
    (EN 13231-5)."""
    neuhaus_sextro: Entry[Preset[RoughnessFields], Never] = Entry()
    """both surfaces together: gives the k_c = 5e6 1/m of the paper with μ0 = 0.4 and γ = 0.45
    (Neuhaus and Sextro, ICCM 2014, by the closed form of Persson (2007))."""


#: Conditions of the rail, for a first guess: ``Case(**conditions.wet)``.
conditions = Conditions()
#: Friction laws with their constants, for ``friction``.
friction = Friction()
#: Layers between the surfaces, for ``layer``.
layers = Layers()
#: Materials, for ``wheel`` and ``rail``.
materials = Materials()
#: Fast methods with their constants: ``Case(**methods.polach_dry)``.
methods = Methods()
#: Roughnesses, for ``contact_law={"roughness": …}``.
roughnesses = Roughnesses()
