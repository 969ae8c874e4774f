"""Cases: fields, units, errors, and the way to TOML and back."""

import copy
import inspect
import pickle
import typing

import numpy as np
import pint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import schlupf
from schlupf._fields import FIELDS, SECTIONS


def test_numbers_are_in_si_and_text_has_its_unit():
    by_number = schlupf.Case(normal={"load": 60e3}, kinematics={"speed": 20})
    by_text = schlupf.Case(normal={"load": "60 kN"}, kinematics={"speed": "72 km/h"})
    assert by_number == by_text
    assert by_text.normal.load == 60e3 and by_text["kinematics.speed"] == 20.0


def test_sections_are_keywords_in_help_and_notebooks():
    parameters = inspect.signature(schlupf.Case).parameters
    assert list(parameters) == ["title", *(name for name in SECTIONS if name and "." not in name)]
    case = schlupf.Case(**{name: None for name in parameters})
    assert case == schlupf.Case() and not case.given()


def test_annotations_can_be_read():
    modules = (schlupf.sections, schlupf.records)
    classes = [kind for of in modules for kind in vars(of).values() if inspect.isclass(kind)]
    methods = [of for of in vars(schlupf.Case).values() if inspect.isfunction(of)]
    for annotated in (schlupf.Case, *classes, *methods, schlupf.Case.curve, schlupf.forces):
        typing.get_type_hints(annotated)
    hints = typing.get_type_hints(schlupf.sections.NormalFields)
    assert hints["file"] == schlupf._units.Data | None


def test_quantities_of_pint_are_converted():
    units = pint.UnitRegistry()
    case = schlupf.Case(
        normal={"load": 60 * units.kilonewton},
        history={"time": [0.0, 1.0] * units.millisecond, "creepage_x": np.array([0.0, 0.002])},
    )
    assert case.normal.load == pytest.approx(60e3)
    assert case.history.time == pytest.approx([0.0, 1e-3])


def test_defaults_are_those_of_the_field_table():
    case = schlupf.Case()
    assert case.kinematics.speed == 30.0
    assert case.friction.coefficient == 0.4
    assert case.grid.cells_x == 24 and isinstance(case.grid.cells_x, int)
    assert case.contact_law.roughness.hardness is None


def test_every_field_is_an_attribute_and_documented():
    case = schlupf.Case()
    for path in FIELDS:
        case[path]
        section = path.rpartition(".")[0]
        assert not section or path.rpartition(".")[2] in dir(case[section])
        assert path.rpartition(".")[2] in schlupf.Case.__doc__
    assert set(SECTIONS) - {""} >= {"kinematics", "wheel", "rail", "normal"}


def test_fields_can_be_set_and_taken_out():
    case = schlupf.Case(normal={"load": 60e3})
    case.normal.load = "70 kN"
    assert case.normal.load == 70e3
    case["normal.load"] = None
    assert case.given() == [] and case.normal.load == 80e3
    changed = case.with_(wheel={"young_modulus": 200e9}, title="other")
    assert changed.wheel.young_modulus == 200e9 and changed.title == "other"
    assert case.given() == []


def test_a_wrong_field_is_named_and_nothing_changes():
    case = schlupf.Case(normal={"load": 60e3})
    with pytest.raises(schlupf.CaseError, match="did you mean") as caught:
        case.normal.lod = 1.0
    assert caught.value.field == "normal.lod"
    with pytest.raises(schlupf.CaseError, match="between") as caught:
        case.normal.load = -1.0
    assert caught.value.field == "normal.load" and "-1.0 N" in caught.value.place
    assert case.normal.load == 60e3
    with pytest.raises(AttributeError, match="young_modulus"):
        case.wheel.youngs_modulus
    with pytest.raises(AttributeError, match="kinematics"):
        case.kinematic
    with pytest.raises(TypeError, match="complex"):
        schlupf.Case(normal={"load": 1j})


def test_all_errors_are_told():
    with pytest.raises(schlupf.CaseError) as caught:
        schlupf.Case(normal={"load": "80 km"}, grid={"cells_x": 0.5})
    assert [error["field"] for error in caught.value.errors] == ["normal.load", "grid.cells_x"]
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value)


def test_files(tmp_path):
    text = '# ours\n[normal]\nload = "60 kN" # heavy\n'
    path = tmp_path / "case.toml"
    path.write_text(text)
    case = schlupf.Case.from_file(path)
    assert case.to_toml() == text
    assert "# heavy" in case.with_(normal={"load": 70e3}).to_toml()
    with pytest.raises(OSError, match="missing.toml"):
        schlupf.Case.from_file(tmp_path / "missing.toml")


def test_copies_are_independent_and_pickles_equal():
    case = schlupf.Case(normal={"load": 60e3}, title='naïve "ß" \x7f\\')
    for other in (copy.copy(case), copy.deepcopy(case), pickle.loads(pickle.dumps(case))):
        assert other == case
        other.normal.load = 70e3
        assert case.normal.load == 60e3


NUMBERS = st.floats(min_value=1e-3, max_value=1e6, allow_nan=False)


@settings(max_examples=60)
@given(
    load=st.floats(min_value=1e-3, max_value=1e12),
    creepage=st.floats(min_value=-0.5, max_value=0.5),
    conductivity=NUMBERS,
    temperature=st.floats(min_value=-200, max_value=600),
    cells=st.integers(min_value=2, max_value=1024),
    title=st.text(st.characters(exclude_categories=["Cs"]), max_size=30),
)
def test_a_case_survives_its_text(load, creepage, conductivity, temperature, cells, title):
    case = schlupf.Case(
        title=title,
        normal={"load": load},
        kinematics={"creepage_x": creepage},
        wheel={"conductivity": conductivity, "bulk_temperature": temperature},
        grid={"cells_x": cells},
    )
    assert case.normal.load == pytest.approx(load, rel=1e-15)
    assert case.title == title
    assert schlupf.Case.from_toml(case.to_toml()) == case


def test_a_section_can_be_taken_out():
    case = schlupf.Case(history={"time": [0.0, 1e-3], "creepage_x": [0.0, 0.002]})
    assert case.with_(history=None).given() == []
    with pytest.raises(schlupf.CaseError, match="unknown field `histry`"):
        case.with_(histry=None)


def test_a_case_is_like_a_mapping_of_what_it_gives():
    case = schlupf.Case(normal={"load": "80 kN"}, kinematics={"creepage_x": 0.002})
    assert dict(case) == {"normal.load": 80e3, "kinematics.creepage_x": 0.002}
    assert dict(case.normal) == {"load": 80e3} and "load" in case.normal
    assert "normal" in case and "normal.load" in case and "normal.laod" not in case
    with pytest.raises(TypeError, match="sections are keywords"):
        schlupf.Case({"normal": {"load": 80e3}})


def test_a_case_shows_how_it_is_made():
    case = schlupf.Case("braking", normal={"load": "80 kN"}, kinematics={"creepage_x": 0.002})
    assert eval(repr(case), {"Case": schlupf.Case}) == case
    with pytest.raises(TypeError, match="normal is a section"):
        schlupf.Case(normal="hertz")


def test_sections_can_be_copied():
    case = schlupf.Case(normal={"load": 60e3})
    assert copy.deepcopy(case.normal).load == 60e3


def test_quantities_of_another_kind_are_refused():
    ureg = pytest.importorskip("pint").UnitRegistry()
    wrong = [
        ({"friction": {"temperature_at_zero_friction": ureg.Quantity(700, "degC")}}, "difference"),
        ({"kinematics": {"angular_velocity": ureg.Quantity(10, "Hz")}}, "a frequency"),
        ({"normal": {"load": ureg.Quantity(1, "m")}}, "must be given in N"),
        ({"normal": {"load": 10**400}}, "too large"),
    ]
    for sections, part in wrong:
        with pytest.raises(schlupf.CaseError, match=part):
            schlupf.Case(**sections)
    with pytest.raises(TypeError, match="normal is a section"):
        schlupf.Case(normal=5)
