"""Studies: many states of a case, a row of results each."""

from __future__ import annotations

import functools
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from importlib import import_module
from os import PathLike
from pathlib import Path
from typing import Any

import xarray as xr

from . import _core
from ._errors import SchlupfWarning, quoted
from ._result import with_folder
from ._tables import along
from .warnings import emit

#: Work that a task of a cluster has at least, in s: handing it out takes milliseconds.
LEAST_WORK = 1.0


@dataclass(frozen=True)
class Sweep:
    """What a study has come to.

    Attributes
    ----------
    path : Path
        The table.
    rows, resumed, not_converged, failed : int
        Rows of it; those that an earlier run had solved; those whose solution has not converged;
        those that could not be solved.
    first_failure : tuple of int and str, optional
        The first row that failed, and why.
    messages : list of tuple
        Warnings of the rows, each code once with the number of rows: code, field, text.
    """

    path: Path
    rows: int
    resumed: int
    not_converged: int
    failed: int
    first_failure: tuple[int, str] | None = field(default=None)
    messages: list[tuple[str, str, str]] = field(default_factory=list)

    @property
    def table(self) -> xr.Dataset:
        """The table along ``index``; see `read_table`."""
        return read_table(self.path)


def sweep(
    study: str | PathLike[str],
    output: str | PathLike[str],
    *,
    shard: tuple[int, int] = (1, 1),
    client: Any = None,
    warn: bool = True,
) -> Sweep:
    """Solves a study: a case and what varies over it, a row of results for each state.

    A run that ended early goes on where it was, and the table is the same, byte for byte, on any
    number of cores and machines.

    Parameters
    ----------
    study : path
        A study file (TOML).
    output : path
        The table, a ``.csv`` or ``.parquet`` file.
    shard : (int, int), default (1, 1)
        Which share of the study to solve, from 1, and of how many; `merge` puts them together.
    client : distributed.Client, optional
        A cluster whose workers solve the batches, in tasks of at least a second; by default all
        cores of this machine. The workers read the study under the same path.
    warn : bool, default True
        Whether to warn of states that failed or have not converged, and to issue the warnings of
        all states, each code once.

    Returns
    -------
    Sweep
        How many rows there are, and how many failed; the ``table``.

    Raises
    ------
    CaseError
        If something is wrong with the study or its case.
    ValueError
        If there is a table of another study, or one that is no table.
    OSError
        If a file cannot be read or written; what is done is kept.
    """
    path, output = Path(study), with_folder(output)
    if client is not None and not hasattr(client, "submit"):
        raise TypeError(f"client must be a distributed.Client, but is {quoted(client)}")
    if not 1 <= shard[0] <= shard[1]:
        raise ValueError(f"shard must be (i, n) with i from 1 to n, but is {shard}")
    opened = _core.Study(path)
    if client is None:
        counts = opened.run(list(shard), output)
    elif tuple(shard) != (1, 1):
        raise TypeError("a cluster solves all of a study: leave out the shard")
    else:
        run = _core.StudyRun(opened, output)
        _on_cluster(client, path, opened.digest(), run)
        counts = run.finish()
    result = Sweep(output, *counts)
    if warn:
        _warn(result)
    return result


def merge(
    tables: Sequence[str | PathLike[str]], output: str | PathLike[str], *, warn: bool = True
) -> Sweep:
    """Puts the tables of all shards of a study together.

    Parameters
    ----------
    tables : sequence of paths
        The tables of all shards.
    output : path
        The table of the whole study.
    warn : bool, default True
        As in `sweep`.

    Raises
    ------
    ValueError
        If they are not all shards of one study, each once and whole.
    OSError
        If a file cannot be read or written.
    """
    output = with_folder(output)
    counts = _core.merge([Path(table) for table in tables], output)
    result = Sweep(output, *counts)
    if warn:
        _warn(result)
    return result


def read_table(path: str | PathLike[str]) -> xr.Dataset:
    """The table of a study, along ``index``: what varies, ``status``, and results such as
    ``force.x``, with their units as attributes.

    Raises
    ------
    ValueError
        If it is no table of a study.
    OSError
        If it cannot be read.
    """
    columns = _core.read_table(Path(path))
    described = {
        name: {**column, "long_name": name, "symbol": "", "source": ""}
        for name, column in columns.items()
    }
    return along(described, "index", "index")


def _warn(result: Sweep) -> None:
    from warnings import warn

    if result.failed or result.not_converged:
        parts = [(result.not_converged, "have not converged"), (result.failed, "failed")]
        text = " and ".join(f"{count} {what}" for count, what in parts if count)
        first = result.first_failure
        reason = f"; row {first[0]}: {first[1]}" if first else ""
        message = f"of {result.rows} states {text}{reason}"
        warn(SchlupfWarning(message, "status"), stacklevel=3)
    emit(result.messages, stacklevel=3)


@functools.lru_cache(maxsize=4)
def _opened(path: str, digest: str) -> _core.Study:
    study = _core.Study(Path(path))
    if study.digest() != digest:
        raise ValueError(
            f"{path} is another study on a worker than on the client: their files, or their "
            "versions of schlupf, differ"
        )
    return study


def _solve(path: str, digest: str, batches: list[int]) -> tuple[list[tuple[int, str]], float]:
    """Solves batches on a worker; returns their rows, and the time that it took (in s)."""
    start = time.perf_counter()
    study = _opened(path, digest)
    solved = [(batch, study.solve(batch)) for batch in batches]
    return solved, time.perf_counter() - start


def _on_cluster(client: Any, path: Path, digest: str, run: _core.StudyRun) -> None:
    """Has the batches that are left solved by workers; each is kept as soon as it is back."""
    # It has no types.
    as_completed: Any = import_module("distributed").as_completed
    left = list(reversed(run.left()))
    size = 1

    def submitted() -> Any:
        batches = [left.pop() for _ in range(min(size, len(left)))]
        # A batch may be solved twice, by a worker that is lost and by another one.
        return client.submit(_solve, str(path.resolve()), digest, batches, pure=False)

    workers = max(1, sum(client.nthreads().values()))
    futures = as_completed([submitted() for _ in range(2 * workers) if left], with_results=True)
    for future, (solved, elapsed) in futures:
        for batch, text in solved:
            run.keep(batch, text)
        future.release()
        each = max(elapsed / len(solved), 1e-6)
        # Towards the end all workers have something to do.
        size = max(1, min(int(LEAST_WORK / each) + 1, len(left) // (2 * workers)))
        if left:
            futures.add(submitted())
