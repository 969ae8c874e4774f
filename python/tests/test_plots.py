"""Plots, compared by what they draw."""

from typing import get_args

import matplotlib.pyplot as plt
import numpy as np
import pytest

import schlupf


@pytest.mark.parametrize("name", ["traction", "pressure", "slip", "temperature"])
def test_a_map_shows_its_field(result, name):
    ax = getattr(result.plot, name)()
    (mesh,) = (c for c in ax.collections if type(c).__name__ == "QuadMesh")
    fields = result.fields
    # Of a cell at the edge the mean over its covered part: it is no darker than its neighbours.
    covered = fields["covered"]
    expected = {
        "traction": np.hypot(fields["traction_x"], fields["traction_y"]) * 1e-6 / covered,
        "pressure": fields["pressure"] * 1e-9 / covered,
        "slip": np.hypot(fields["slip_x"], fields["slip_y"]) * 1e3,
        "temperature": fields["temperature_rise_wheel"] + 20.0,
    }[name]
    np.testing.assert_allclose(
        np.ma.filled(mesh.get_array(), np.nan).reshape(expected.shape), expected, rtol=1e-12
    )
    assert ax.get_xlabel().startswith("$x$ (mm)")


def test_a_plot_leaves_the_settings_of_matplotlib_alone(result):
    plt.rcParams["font.size"] = 11.0
    plt.ion()
    result.plot.pressure()
    assert plt.rcParams["font.size"] == 11.0
    assert plt.isinteractive()
    plt.ioff()
    plt.rcdefaults()
    plt.switch_backend("agg")


def test_axes_can_be_given(result):
    _, ax = plt.subplots()
    assert result.plot.pressure(ax=ax) is ax


def test_stick_and_slip(result):
    ax = result.plot.stick_slip()
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["stick", "slip"]
    values = np.ma.compressed(ax.collections[0].get_array())
    assert values.mean() == pytest.approx(
        float(result.fields["sliding"].where(result.fields["contact"]).mean())
    )


def test_a_cut(result):
    ax = result.plot.cut("traction_x", y=1e-3)
    line = ax.lines[0]
    expected = result.fields["traction_x"].sel(y=1e-3, method="nearest") * 1e-6
    np.testing.assert_allclose(line.get_ydata(), expected)
    assert ax.get_ylabel() == "MPa"
    assert len(result.plot.cut(x=0.0).lines) == 3
    with pytest.raises(TypeError):
        result.plot.cut(x=0.0, y=0.0)


def test_every_variable_of_the_data_sets_is_drawn_and_nothing_else(case, result):
    names = get_args(schlupf.records.CellColumn)
    assert names == tuple(result.fields.data_vars)
    rolled = case.with_(history={"time": [0.0, 1e-3]}).solve(fields_every=1)
    for name in names:
        result.plot.surface(name)
        result.plot.cut(name)
        schlupf.plot_comparison([result, result], name)
        rolled.plot.animation(name)._draw_was_started = True
        plt.close("all")
    for name in get_args(schlupf.records.InstantColumn):
        rolled.plot.history(name)
    for plot in (result.plot.surface, result.plot.cut, rolled.plot.animation):
        with pytest.raises(KeyError, match="no field x; there are|did you mean"):
            plot("x")
    with pytest.raises(KeyError, match="no field time"):
        rolled.plot.history("time")


def test_a_history(case, result):
    with pytest.raises(ValueError, match="history"):
        result.plot.history()
    history = {"time": [0.0, 1e-3], "creepage_x": [0.0, 0.002]}
    rolled = case.with_(kinematics={"creepage_x": None}, history=history).solve()
    ax = rolled.plot.history("force_x")
    np.testing.assert_allclose(ax.lines[0].get_ydata(), rolled.history["force_x"] * 1e-3)
    assert ax.get_ylabel() == "kN"
    with pytest.raises(ValueError, match="fields of a history must have one unit"):
        rolled.plot.history("force_x", "speed")


def test_a_creep_curve(case):
    curve = case.curve(creepage_x=(0.0, 0.01), points=5)
    ax = curve.plot()
    np.testing.assert_allclose(ax.lines[0].get_ydata(), curve.points["force_x"] * 1e-3)
    assert ax.get_xlabel() == "longitudinal creepage"
    assert len(ax.lines) == 2
    # Nothing acts across but rounding.
    along = case.with_(kinematics=None).curve(creepage_x=(0.0, 0.01), points=5)
    assert len(along.plot().lines) == 1
    assert curve.plot(label="mine").get_legend().get_texts()[0].get_text() == "mine"


def test_comparison_and_animation(case, result):
    other = case.with_(normal={"load": 60e3}).solve()
    axes = schlupf.plot_comparison([result, other])
    limits = {ax.collections[0].get_clim() for ax in axes}
    assert len(axes) == 2 and len(limits) == 1
    movie = schlupf.animate([result, result], "traction_x")
    movie._draw_frame(1)
    movie._draw_was_started = True


def test_a_transient_is_animated_from_its_case(case):
    history = {"time": [0.0, 1e-3], "creepage_x": [0.0, 0.004]}
    result = case.with_(kinematics={"creepage_x": None, "speed": "10 m/s"}, history=history).solve(
        fields_every=2
    )
    animation = result.plot.animation("pressure", interval=20)
    ax = animation._fig.axes[0]
    count = result.field_history.sizes["time"]
    assert animation._save_count == count > 3
    animation._init_draw()
    animation._draw_frame(count - 1)
    shown = ax.collections[0].get_array().reshape(result.fields["pressure"].shape)
    np.testing.assert_allclose(
        np.ma.filled(shown, np.nan), result.fields["pressure"] * 1e-9, rtol=1e-12
    )
    assert ax.get_title().endswith("1 ms")


def test_a_map_ends_at_the_edge_of_the_patch(result):
    ax = result.plot.pressure()
    edge = ax.patches[0].get_path().vertices
    a, b = result.normal.semi_axis_x * 1e3, result.normal.semi_axis_y * 1e3
    radii = np.hypot(edge[:, 0] / a, edge[:, 1] / b)
    # Hertz's ellipse is known.
    assert np.abs(radii - 1.0).max() < 1e-3
    assert ax.collections[0].get_clip_path() is not None


def test_a_cut_has_one_unit_and_a_place_within_the_patch(result):
    with pytest.raises(ValueError, match="must have one unit"):
        result.plot.cut("slip_x", "pressure")
    with pytest.raises(ValueError, match="y must be from"):
        result.plot.cut(y=5.0)
    one, other = (result.plot.cut("pressure", y=y).lines[0] for y in ("1 mm", 1e-3))
    np.testing.assert_array_equal(one.get_ydata(), other.get_ydata())


def test_films_and_comparisons_take_axes(result):
    _, axes = plt.subplots(1, 2)
    assert schlupf.plot_comparison([result, result], ax=list(axes)) == list(axes)
    with pytest.raises(ValueError, match="ax must have 1 axes"):
        schlupf.plot_comparison([result], ax=list(axes))
    _, ax = plt.subplots()
    film = schlupf.animate([result, result], "pressure", ax=ax)
    size = ax.title.get_fontsize()
    film._init_draw()
    assert ax.get_title() == result.title
    assert ax.title.get_fontsize() == size == 8.0


def test_titles_stay_over_their_axes(case, result):
    long = case.with_(title="a wheel that brakes on a wet rail in a curve " * 3).solve()
    axes = schlupf.plot_comparison([long, result])
    figure = axes[0].figure
    figure.draw_without_rendering()
    widths = [ax.title.get_window_extent().width for ax in axes]
    assert max(widths) < 0.55 * figure.bbox.width
    assert "\n" in axes[0].get_title()
    ax = long.plot.pressure()
    ax.figure.draw_without_rendering()
    bar = ax.figure.axes[1].get_window_extent()
    assert not ax.title.get_window_extent().overlaps(bar)


def test_names_are_words(case):
    curves = case.curve(creepage_x=(0.0, 0.01), over={"kinematics.speed": [5, 10, 20]}, points=5)
    assert curves.plot().get_legend().get_title().get_text() == "speed"
    ax = curves.plot_map("max_rise")
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("longitudinal creepage", "speed (m/s)")


def test_wheel_and_rail_do_not_hide_each_other(case):
    wheel, rail = case.temperature(warn=False).plot().lines[:2]
    assert (wheel.get_linestyle(), rail.get_linestyle()) == ("-", "--")


def test_free_rolling_has_no_arrows(case):
    rolling = case.with_(kinematics={"creepage_x": 0.0, "creepage_y": 0.0}).solve()
    ax = rolling.plot.slip()
    assert not any(type(entry).__name__ == "Quiver" for entry in ax.collections)


def test_a_fit_of_lateral_forces_is_drawn_over_their_creepage(case):
    creepage = np.array([0.001, 0.003, 0.006])
    constant = {"friction": {"model": "constant", "coefficient": 0.3}, "heat": {"model": "none"}}
    model = case.with_(kinematics={"creepage_x": 0.0}, **constant)
    ratio = -schlupf.forces(model, creepage_y=creepage)["force_y"].values / 80e3
    data = {"creepage_y": creepage, "force_ratio_y": ratio}
    ax = model.fit("friction.coefficient", data, warn=False).plot()
    assert ax.get_xlabel() == "lateral creepage"


def test_every_keyword_of_matplotlib_may_be_given(case, result):
    maps = {"cmap": "magma", "shading": "auto", "vmin": 0.0, "vmax": 1.0, "alpha": 0.5}
    for name in ("traction", "pressure", "slip", "temperature", "stick_slip"):
        ax = getattr(result.plot, name)(**maps)
        (mesh,) = (c for c in ax.collections if type(c).__name__ == "QuadMesh")
        assert (mesh.get_cmap().name, mesh.get_clim()) == ("magma", (0.0, 1.0)), name
    lines = {"c": "red", "lw": 2.0, "ls": ":", "label": "mine", "zorder": 5}
    curves = case.curve(creepage_x=(0.0, 0.01), over={"kinematics.speed": [10, 20]}, points=5)
    wear, heat = case.wear(warn=False), case.temperature(warn=False)
    for draw in (result.plot.cut, curves.plot, wear.plot, heat.plot):
        line = draw(**lines).lines[0]
        assert (line.get_color(), line.get_linewidth(), line.get_label()) == ("red", 2.0, "mine")
    surface = result.plot.surface(color="red").collections[0]
    np.testing.assert_allclose(surface.get_facecolor()[0, 1:3], 0.0)
    bars = case.compare(warn=False).plot(height=0.2, label="mine", color="red")
    assert bars.patches[0].get_height() == pytest.approx(0.2)
    many = case.curve(creepage_x=(0.0, 0.01), over={"kinematics.speed": [5, 10, 20]}, points=5)
    assert many.plot_map(levels=4, cmap="magma").collections
    animation = schlupf.animate([result], frames=1, interval=50)
    assert len(animation._fig.axes) == 2
    assert "<img" in animation.to_jshtml()


def test_the_picture_of_a_notebook_keeps_its_shape(result):
    html = result._repr_html_()
    assert "align-items:flex-start" in html
    assert html.count("<img") == 1
