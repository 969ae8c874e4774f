"""Studies: tables, shards, and a cluster that loses a worker."""

import os
import pickle
import signal
import threading
from types import SimpleNamespace

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import schlupf

STUDY = """
case = "case.toml"
batch = 8
[sample]
method = "sobol"
count = {count}
[sample.range]
kinematics.creepage_x = [-0.01, 0.01]
kinematics.spin = ["-1 1/m", "1 1/m"]
"""


@pytest.fixture
def study(tmp_path):
    """A study of a coarse case."""
    (tmp_path / "case.toml").write_text("[grid]\ncells_x = 10\ncells_y = 10\n")

    def made(count):
        path = tmp_path / "study.toml"
        path.write_text(STUDY.format(count=count))
        return path

    return made


def test_a_study_has_a_row_for_each_state(study, tmp_path):
    done = schlupf.sweep(study(20), tmp_path / "table.parquet")
    assert (done.rows, done.failed, done.resumed) == (20, 0, 0)
    table = done.table
    assert table["force_x"].attrs["units"] == "N" and table.sizes["index"] == 20
    assert set(table["status"].values) == {schlupf.Status.CONVERGED}
    case = schlupf.Case.from_file(tmp_path / "case.toml")
    for row in (0, 13):
        motion = {
            "creepage_x": table["creepage_x"].values[row],
            "spin": table["spin"].values[row],
        }
        alone = case.with_(kinematics=motion).solve(warn=False)
        assert table["force_x"].values[row] == pytest.approx(alone.force.x, abs=1.0)
    again = schlupf.sweep(study(20), tmp_path / "table.parquet")
    assert again.resumed == 20


def test_shards_are_merged(study, tmp_path):
    whole = schlupf.sweep(study(40), tmp_path / "whole.csv").path.read_bytes()
    shards = [tmp_path / f"{k}.csv" for k in (1, 2)]
    for k, shard in enumerate(shards):
        schlupf.sweep(study(40), shard, shard=(k + 1, 2))
    assert schlupf.merge(shards, tmp_path / "merged.csv").path.read_bytes() == whole
    with pytest.raises(ValueError, match="shard 2/2 is missing"):
        schlupf.merge(shards[:1], tmp_path / "other.csv")
    with pytest.raises(ValueError, match="table of another study"):
        schlupf.sweep(study(41), tmp_path / "whole.csv")
    with pytest.raises(ValueError, match="shard must be"):
        schlupf.sweep(study(40), tmp_path / "other.csv", shard=(3, 2))


def test_a_cluster_is_not_asked_for_fields(study, tmp_path):
    path = study(20)
    path.write_text(path.read_text() + "[fields]\n")
    with pytest.raises(ValueError, match="fields stay on the machine that solves them"):
        schlupf.sweep(path, tmp_path / "table.csv", client=SimpleNamespace(submit=None))
    with pytest.raises(TypeError, match="must be a distributed.Client, but is 'tcp://"):
        schlupf.sweep(path, tmp_path / "table.csv", client="tcp://10.0.0.1:8786")
    assert sorted(file.name for file in tmp_path.iterdir()) == ["case.toml", "study.toml"]


@pytest.mark.filterwarnings("ignore")
def test_a_study_ends_with_its_warnings_counted_by_code(study, tmp_path):
    path = study(1)
    path.write_text('case = "case.toml"\n[states]\nfile = "states.csv"\n')
    (tmp_path / "states.csv").write_text("normal.load [MN]\n0.08\n80\n200\n")
    with pytest.warns(schlupf.warnings.BeyondElasticWarning) as caught:
        done = schlupf.sweep(path, tmp_path / "table.csv")
    assert all(warning.filename == __file__ for warning in caught)
    (text,) = [text for code, _, text in done.messages if code == "beyond-elastic"]
    assert text.startswith("beyond-elastic in 2 of 3 states, worst in row 2: normal.peak_pressure")
    with pytest.warns(schlupf.warnings.BeyondElasticWarning, match="2 of 3 states, first in row 1"):
        schlupf.sweep(path, tmp_path / "table.csv")


RUN = "distance [m],position_y [mm],kinematics.creepage_x\n" + "".join(
    f"{25 * k},{k % 3},{0.001 * k}\n" for k in range(6)
)


def test_a_run_has_its_damage(study, tmp_path):
    path = study(1)
    path.write_text('case = "case.toml"\n[states]\nfile = "run.csv"\n')
    (tmp_path / "run.csv").write_text(RUN)
    found = schlupf.damage(path)
    table = schlupf.sweep(path, tmp_path / "table.parquet").table
    each = (table["power_friction"] / table["speed"]).values
    assert found.energy == pytest.approx(25.0 * np.sum(0.5 * (each[1:] + each[:-1])), rel=1e-9)
    assert found.profile["wheel_archard"].attrs["units"] == "m"
    np.testing.assert_allclose(found.run["energy"][-1], found.energy)
    assert found.plot().get_xlabel() == "$y$ across the profile (mm)"
    case = schlupf.Case.from_file(tmp_path / "case.toml").with_(
        damage={"shear_yield_stress": "100 MPa"}
    )
    assert schlupf.damage(tmp_path / "table.parquet").fatigue.max == found.fatigue.max
    softer = schlupf.damage(tmp_path / "table.parquet", case)
    assert softer.fatigue.max > found.fatigue.max + 0.1
    with pytest.raises(ValueError, match="no table of a study"):
        schlupf.damage(tmp_path / "run.csv")


def test_states_that_fail_are_told(study, tmp_path):
    path = study(1)
    path.write_text('case = "case.toml"\n[vary]\n"kinematics.creepage_x" = [0.001, 1.5]\n')
    with pytest.warns(schlupf.SchlupfWarning, match=r"of 2 states 1 failed; row 1: kinematics"):
        done = schlupf.sweep(path, tmp_path / "table.csv")
    assert np.isnan(done.table["force_x"].values).tolist() == [False, True]
    path.write_text("[vray]\n")
    with pytest.raises(schlupf.CaseError, match="did you mean `vary`"):
        schlupf.sweep(path, tmp_path / "other.csv")
    with pytest.raises(OSError):
        schlupf.sweep(tmp_path / "missing.toml", tmp_path / "other.csv")


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
@pytest.mark.filterwarnings("ignore")
def test_a_cluster_that_loses_a_worker_has_the_same_table(study, tmp_path):
    distributed = pytest.importorskip("distributed")
    path = study(4000)
    whole = schlupf.sweep(path, tmp_path / "whole.parquet").path.read_bytes()
    cluster = distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
    )
    with cluster, distributed.Client(cluster) as client:
        workers = client.run(os.getpid)
        lost = next(iter(workers.values()))
        timer = threading.Timer(0.5, os.kill, (lost, signal.SIGKILL))
        timer.start()
        done = schlupf.sweep(path, tmp_path / "cluster.parquet", client=client)
        timer.join()
        assert lost not in client.run(os.getpid).values()
    assert done.rows == 4000 and done.resumed == 0
    assert done.path.read_bytes() == whole


def test_workers_solve_the_study_of_the_client(tmp_path):
    """A worker opens a study anew where its files have changed, and refuses another one."""
    from schlupf import _core
    from schlupf._study import _solve

    case, study = tmp_path / "case.toml", tmp_path / "study.toml"
    study.write_text('case = "case.toml"\n[vary]\nkinematics.creepage_x = [0.01, 0.02]\n')

    def first_force(friction):
        case.write_text(
            f'solver.method = "polach"\nfriction.model = "constant"\n'
            f"friction.coefficient = {friction}\n"
        )
        digest = _core.Study(study).digest()
        return digest, _solve((study,), digest, [0])[0][0][1]

    old, before = first_force(0.4)
    new, after = first_force(0.1)
    assert old != new
    assert before != after
    with pytest.raises(ValueError, match="another study on a worker"):
        _solve((study,), old + "0", [0])


POLACH = schlupf.Case(friction={"model": "constant"}, solver={"method": "polach"})


def test_a_study_of_objects_is_that_of_a_file(tmp_path):
    vary = {"normal.load": ["60 kN", 80e3], "kinematics.creepage_x": np.linspace(0, 0.01, 3)}
    (tmp_path / "case.toml").write_text(POLACH.to_toml())
    text = (
        'case = "case.toml"\n[vary]\nnormal.load = ["60 kN", "80 kN"]\n'
        "kinematics.creepage_x = [0.0, 0.005, 0.01]\n"
    )
    (tmp_path / "study.toml").write_text(text)
    expected = schlupf.sweep(tmp_path / "study.toml", tmp_path / "file.csv").table
    study = schlupf.study(POLACH, vary=vary)
    assert study.rows == 6
    assert schlupf.Study(str(tmp_path / "study.toml")).to_toml() == text
    for k, each in enumerate((study, pickle.loads(pickle.dumps(study)))):
        xr.testing.assert_equal(schlupf.sweep(each, tmp_path / f"{k}.csv").table, expected)
    sample = {"method": "sobol", "count": 8, "range": {"normal.load": (50e3, 100e3)}}
    loads = schlupf.sweep(schlupf.study(POLACH, sample=sample), tmp_path / "sample.csv").table
    assert loads.sizes["index"] == 8 and float(loads["normal_load"].min()) >= 50e3


def test_states_of_a_study_may_be_a_data_frame(tmp_path):
    frame = pd.DataFrame(
        {
            "creepage_x": [0.001, 0.002],
            "load": [60e3, 80e3],
            "solver.method": ["polach", "fastsim"],
            "grid.cells_x": [10, 12],
            "time": [0.0, 1.0],
        },
        index=["slow", "fast"],
    )
    titled = schlupf.study(POLACH, states=frame.assign(title=["slow, dry", 'the "fast" one']))
    titles = schlupf.sweep(titled, tmp_path / "titles.csv", warn=False).table["title"]
    assert titles.values.tolist() == ["slow, dry", 'the "fast" one']
    for k, states in enumerate((frame, frame.to_xarray().drop_vars("index"), dict(frame))):
        done = schlupf.sweep(
            schlupf.study(POLACH, states=states), tmp_path / f"{k}.csv", warn=False
        )
        assert done.table["normal_load"].values.tolist() == [60e3, 80e3] and done.failed == 0
        assert done.table["time"].values.tolist() == [0.0, 1.0]
    for row in range(2):
        motion = {"creepage_x": frame["creepage_x"].iloc[row]}
        grid = {"cells_x": int(frame["grid.cells_x"].iloc[row])}
        method = {"method": frame["solver.method"].iloc[row]}
        alone = POLACH.with_(
            kinematics=motion, normal={"load": frame["load"].iloc[row]}, solver=method, grid=grid
        )
        force = alone.solve(warn=False).force.x
        assert float(done.table["force_x"][row]) == pytest.approx(force, rel=1e-6)
    with pytest.raises(schlupf.CaseError, match="states, row fast: normal.load must be a number"):
        schlupf.study(POLACH, states=frame.assign(load=["60e3", "x"]))


def test_many_numbers_of_one_field_are_states():
    loads = np.linspace(60e3, 80e3, 10_001)
    for vary in (loads, xr.DataArray(loads, dims="load", attrs={"units": "N"}), pd.Series(loads)):
        study = schlupf.study(POLACH, vary={"normal.load": vary})
        assert study.rows == 10_001 and study.to_toml().startswith("[states]")
    listed = schlupf.study(POLACH, vary={"normal.load": loads[1:]})
    assert listed.rows == 10_000 and listed.to_toml().startswith("[vary]")
    masked = np.ma.masked_equal(loads, loads[3])
    for wrong, told in (
        (np.append(loads, loads[0]), "must differ, but .* is repeated"),
        (np.append(loads, np.nan), "normal.load must be between"),
        (np.append(loads, -1.0), "normal.load must be between"),
        (masked, "normal.load must be between"),
        (np.tile(loads, (2, 1)), "normal.load must be a force"),
        (loads + 0j, "normal.load must be real numbers"),
    ):
        with pytest.raises(schlupf.CaseError, match=told):
            schlupf.study(POLACH, vary={"normal.load": wrong})


def test_wrong_studies_are_told():
    asked = [
        ({"vary": {"normal.lod": [1]}}, KeyError, "did you mean normal.load"),
        ({"vary": {"normal.load": 80e3}}, TypeError, "normal.load must be a sequence"),
        ({"vary": {"normal.load": [-1.0]}}, ValueError, "^normal.load must be between"),
        ({"sample": {"metod": "sobol"}}, ValueError, "did you mean `method`"),
        ({}, TypeError, "one of vary, sample and states"),
    ]
    for arguments, error, told in asked:
        with pytest.raises(error, match=told):
            schlupf.study(POLACH, **arguments)


def test_the_old_name_of_open_table_is_told(study, tmp_path):
    path = schlupf.sweep(study(2), tmp_path / "table.csv").path
    with pytest.warns(DeprecationWarning, match="open_table"):
        assert set(schlupf.read_table(path)["status"].values) == {"converged"}
    assert float(schlupf.open_table(path).force_x[0]) == float(
        schlupf.open_table(path)["force_x"][0]
    )
