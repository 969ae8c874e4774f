"""Studies: tables, shards, and a cluster that loses a worker."""

import os
import signal
import threading
from types import SimpleNamespace

import numpy as np
import pytest

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
    assert table["force.x"].attrs["units"] == "N" and table.sizes["index"] == 20
    assert set(table["status"].values) == {"converged"}
    case = schlupf.Case.from_file(tmp_path / "case.toml")
    for row in (0, 13):
        motion = {
            "creepage_x": table["kinematics.creepage_x"].values[row],
            "spin": table["kinematics.spin"].values[row],
        }
        alone = case.with_(kinematics=motion).solve(warn=False)
        assert table["force.x"].values[row] == pytest.approx(alone.force.x, abs=1.0)
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
    each = (table["power.friction"] / table["kinematics.speed"]).values
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
    assert np.isnan(done.table["force.x"].values).tolist() == [False, True]
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
        return digest, _solve(str(study), digest, [0])[0][0][1]

    old, before = first_force(0.4)
    new, after = first_force(0.1)
    assert old != new
    assert before != after
    with pytest.raises(ValueError, match="another study on a worker"):
        _solve(str(study), old + "0", [0])
