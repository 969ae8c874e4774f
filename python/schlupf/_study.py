"""Studies: many states of a case, a row of results each."""

from __future__ import annotations

import functools
import json
import os
import re
import time
import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from importlib import import_module
from io import StringIO
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from . import _core
from ._case import Case, toml_value
from ._errors import CaseError, SchlupfWarning, UnknownName, described, quoted
from ._fields import CONDITIONS, FIELDS, no_field, quantity
from ._files import data_url, each_in_place
from ._forces import NUMBERS
from ._result import with_folder
from ._status import numbered
from ._tables import along
from ._units import Data, in_array, plain, refused
from .sections import FieldPath
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
        """The table along ``index``; see `open_table`."""
        return open_table(self.path)


class Study:
    """A case and what varies over it; `sweep` solves it.

    Of a file, or of Python's objects with `study`.
    """

    #: A path; or the case as TOML, its folder and the text of the study.
    _source: tuple[Any, ...]
    _study: _core.Study

    def __init__(self, path: str | PathLike[str]) -> None:
        self._set(Path(path))

    def _set(self, *source: Any) -> None:
        self._source = source
        self._study = _made(*source)

    @classmethod
    def _of(cls, *source: Any) -> Study:
        study = cls.__new__(cls)
        study._set(*source)
        return study

    @classmethod
    def from_file(cls, path: str | PathLike[str]) -> Study:
        """The study of a file (TOML)."""
        return cls(path)

    @property
    def rows(self) -> int:
        """Number of states."""
        return self._study.rows()

    def to_toml(self) -> str:
        """What varies, as in a study file, which names its case besides."""
        return str(self._source[-1]) if len(self._source) > 1 else self._source[0].read_text()

    def __repr__(self) -> str:
        return f"<schlupf.Study of {self.rows} states>"

    def __reduce__(self) -> Any:
        return Study._of, self._source


def _made(*source: Any) -> _core.Study:
    if len(source) == 1:
        return _core.Study(source[0])
    case, folder, text = source
    return _core.Study.of_case(Case.from_toml(case, folder)._file, text, Path())


def study(
    case: Case,
    *,
    vary: Mapping[FieldPath, Any] | None = None,
    sample: Mapping[str, Any] | None = None,
    states: Data | None = None,
    fields: Sequence[str] | bool = False,
    batch: int | None = None,
) -> Study:
    """A study of a case: its states are those of `vary`, of `sample` or of `states`.

    Parameters
    ----------
    case : Case
        What does not vary.
    vary : mapping, optional
        All combinations of values: fields by their dotted paths, such as ``"normal.load"``, each
        with a sequence, array or data array. The last field varies fastest. Numbers are in SI
        units; text and quantities of pint have theirs.
    sample : mapping, optional
        Values spread over ranges: ``method`` (``"sobol"`` or ``"latin-hypercube"``), ``count``,
        ``seed`` and ``range``, a mapping of fields to their two ends.
    states : path, mapping, DataFrame or Dataset, optional
        A row for each state, with columns named as fields; ``creepage_x``, ``creepage_y``,
        ``spin``, ``speed`` and ``load`` need no section.
    fields : bool or sequence of str, default False
        Whether to keep the cells of each state, or which of their quantities (Parquet).
    batch : int, optional
        States that are solved and kept together.

    Raises
    ------
    CaseError
        If something is wrong with the case or a value.

    Examples
    --------
    >>> import schlupf
    >>> case = schlupf.Case(friction={"model": "constant"}, solver={"method": "polach"})
    >>> study = schlupf.study(case, vary={"normal.load": [60e3, 80e3], "kinematics.spin": [0, 1]})
    >>> study.rows
    4
    """
    if case._laws:
        raise TypeError(f"a study takes no functions, but there are {', '.join(case._laws)}")
    if sum(design is not None for design in (vary, sample, states)) != 1:
        raise TypeError("a study takes one of vary, sample and states")
    if vary is not None and _is_long(vary, case):
        # A row for each value, which needs no list of values.
        vary, states = None, vary
    designs = {"vary": vary, "sample": sample, "states": states}
    text = "\n".join(_lines(designs, fields, batch, case._folder))
    try:
        return Study._of(case._toml(), case._folder, text)
    except CaseError as error:
        # Nobody has seen the text.
        places = [re.sub(r"^study(:.*)?$", "", each["place"]) for each in error.errors]
        told = zip(error.errors, places, strict=True)
        raise type(error)([{**each, "place": place} for each, place in told]) from None


#: Values of a field that are a list in the text of a study.
MOST_LISTED = 10_000


def _is_long(vary: Mapping[Any, Any], case: Case) -> bool:
    """Whether one field alone varies, over an array of many numbers that all may stand there.

    If one may not, the list tells so.
    """
    paths = [path for path, each in vary.items() if path in FIELDS and hasattr(each, "dtype")]
    if not len(paths) == len(vary) == 1:
        return False
    (path,) = paths
    array = in_array(vary[path], FIELDS[path], path)
    if array.dtype.kind not in "iuf" or array.ndim != 1 or array.size <= MOST_LISTED:
        return False
    # What may stand in a field lies between two bounds, or has a magnitude between two.
    extremes = (array.min(), array.max(), array[np.abs(array).argmin()])
    try:
        for value in extremes:
            case._file.with_fields([f"{path}={toml_value(FIELDS[path], value)}"]).value(path)
    except CaseError:
        return False
    return bool(np.unique(array).size == array.size)


def _lines(
    designs: Mapping[str, Any], fields: Sequence[str] | bool, batch: int | None, folder: Path
) -> Iterator[str]:
    """The text of a study."""
    vary, sample, states = (designs[name] for name in ("vary", "sample", "states"))
    if batch is not None:
        yield f"batch = {toml_value(None, batch)}"
    if vary is not None:
        yield "[vary]"
        yield from _listed(vary, folder)
    if sample is not None:
        yield "[sample]"
        given = (name for name in sample if name != "range")
        yield from (f"{_key(name)} = {toml_value(None, sample[name])}" for name in given)
        yield "[sample.range]"
        yield from _listed(sample.get("range", {}), folder)
    if states is not None:
        yield "[states]"
        yield f"file = {json.dumps(_states(states), ensure_ascii=False)}"
    if fields is not False:
        yield "[fields]"
        if fields is not True:
            yield f"columns = {json.dumps([*fields])}"


def _key(name: str) -> str:
    return json.dumps(name, ensure_ascii=False)


def _listed(values: Mapping[Any, Any], folder: Path) -> Iterator[str]:
    """Fields with their values."""
    for path, each in values.items():
        if path not in FIELDS:
            raise UnknownName(no_field(path))
        field = FIELDS[path]
        given = plain(each, field, path)
        if isinstance(given, str) or not np.iterable(given):
            raise TypeError(f"{path} must be a sequence of values, but is {quoted(each)}")
        given = each_in_place(given, field.columns, path, folder)
        given = np.asarray(given).tolist() if hasattr(given, "shape") else given
        # A million of them are no list of texts.
        text = StringIO()
        for k, value in enumerate(given):
            text.write((", " if k else "") + toml_value(field, getattr(value, "values", value)))
        yield f"{_key(path)} = [{text.getvalue()}]"


#: Columns of states besides fields, which come back in the table.
CARRIED = {"time": "s", "distance": "m", "position_y": "m"}


def _states(states: Any) -> str:
    """A file of states, or data in its place."""
    if isinstance(states, (str, PathLike)):
        return os.fspath(Path(states).absolute())
    if hasattr(states, "to_frame"):
        states = states.to_frame()
    if not hasattr(states, "keys"):
        expected = "a path or columns named as fields"
        raise refused("states", f"states must be {expected}, but is {described(states)}")
    if hasattr(states, "rename"):
        states = states.rename(**_renaming(states))
    else:
        states = {CONDITIONS.get(str(name), str(name)): states[name] for name in states}
    units = {path: field.units for path, field in FIELDS.items() if field.kind in NUMBERS}
    return data_url(states, [units | CARRIED], "states")


def _renaming(states: Any) -> dict[str, Any]:
    """Short names of conditions in a data frame or data set."""
    names = {name: CONDITIONS[name] for name in states if name in CONDITIONS}
    return {"columns": names} if hasattr(states, "columns") else {"name_dict": names}


def sweep(
    study: Study | str | PathLike[str],
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
    study : Study or path
        Of `schlupf.study`, or a study file (TOML).
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

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import schlupf
    >>> case = schlupf.Case(friction={"model": "constant"}, solver={"method": "polach"})
    >>> study = schlupf.study(case, vary={"kinematics.creepage_x": [0.0, 0.002, 0.004]})
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     table = schlupf.sweep(study, pathlib.Path(folder) / "forces.parquet").table
    >>> (table["force_x"].diff("index") < 0.0).values.tolist()
    [True, True]
    """
    study, output = study if isinstance(study, Study) else Study(study), with_folder(output)
    if client is not None and not hasattr(client, "submit"):
        raise TypeError(f"client must be a distributed.Client, but is {quoted(client)}")
    if not 1 <= shard[0] <= shard[1]:
        raise ValueError(f"shard must be (i, n) with i from 1 to n, but is {shard}")
    opened = study._study
    if client is None:
        counts = opened.run(list(shard), output)
    elif tuple(shard) != (1, 1):
        raise TypeError("a cluster solves all of a study: leave out the shard")
    else:
        run = _core.StudyRun(opened, output)
        _on_cluster(client, study, opened.digest(), run)
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

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import schlupf
    >>> case = schlupf.Case(friction={"model": "constant"}, solver={"method": "polach"})
    >>> study = schlupf.study(case, vary={"kinematics.creepage_x": [0.0, 0.002, 0.004]})
    >>> with tempfile.TemporaryDirectory() as name:
    ...     folder = pathlib.Path(name)
    ...     shards = [folder / "1.csv", folder / "2.csv"]
    ...     swept = [schlupf.sweep(study, shards[k], shard=(k + 1, 2)) for k in (0, 1)]
    ...     whole = schlupf.merge(shards, folder / "all.csv")
    >>> sum(sweep.rows for sweep in swept), whole.rows
    (3, 3)
    """
    output = with_folder(output)
    counts = _core.merge([Path(table) for table in tables], output)
    result = Sweep(output, *counts)
    if warn:
        _warn(result)
    return result


def open_table(path: str | PathLike[str]) -> xr.Dataset:
    """The table of a study, along ``index``: what varies, ``status`` (`Status`), and results.

    A column ``force.x`` of the file is ``force_x``, as in all data sets, with its units.

    Raises
    ------
    ValueError
        If it is no table of a study.
    OSError
        If it cannot be read.
    """
    table = _read(path)
    names = {name: quantity(str(name)) for name in table if quantity(str(name)) != name}
    return numbered(table.rename(names))


def read_table(path: str | PathLike[str]) -> xr.Dataset:
    """Deprecated: `open_table`, whose names are those of all data sets."""
    warnings.warn("read_table is now open_table", DeprecationWarning, stacklevel=2)
    return _read(path)


def _read(path: str | PathLike[str]) -> xr.Dataset:
    columns = _core.read_table(Path(path))
    described = {name: {**column, "long_name": name} for name, column in columns.items()}
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
def _opened(source: tuple[Any, ...], digest: str) -> _core.Study:
    study = _made(*source)
    if study.digest() != digest:
        raise ValueError(
            f"{source[0] if len(source) == 1 else 'the study'} is another study on a worker than "
            "on the client: their files, or their versions of schlupf, differ"
        )
    return study


def _solve(
    source: tuple[Any, ...], digest: str, batches: list[int]
) -> tuple[list[tuple[int, str]], float]:
    """Solves batches on a worker; returns their rows, and the time that it took (in s)."""
    start = time.perf_counter()
    study = _opened(source, digest)
    solved = [(batch, study.solve(batch)) for batch in batches]
    return solved, time.perf_counter() - start


def _on_cluster(client: Any, study: Study, digest: str, run: _core.StudyRun) -> None:
    """Has the batches that are left solved by workers; each is kept as soon as it is back."""
    # It has no types.
    as_completed: Any = import_module("distributed").as_completed
    # Workers need not have the same working directory.
    source = study._source if len(study._source) > 1 else (study._source[0].resolve(),)
    left = list(reversed(run.left()))
    size = 1

    def submitted() -> Any:
        batches = [left.pop() for _ in range(min(size, len(left)))]
        # A batch may be solved twice, by a worker that is lost and by another one.
        return client.submit(_solve, source, digest, batches, pure=False)

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
