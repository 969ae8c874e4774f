"""Results: scalars as attributes, fields as data sets."""

from __future__ import annotations

import errno
import html
import itertools
import json
import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import cached_property
from importlib.util import find_spec
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from . import _core
from ._errors import NotConverged
from ._record import Record
from ._tables import along, attributes, on_grid
from .records import Solved
from .warnings import emit

if TYPE_CHECKING:
    import pandas as pd

    from ._plots import ResultPlots


class Result(Solved):
    """A solved case.

    The scalars of the documented JSON are attributes, such as ``result.force.x`` (N, on the wheel),
    ``result.power.friction`` (W) and ``result.temperature.max_rise`` (K); see the page on results.

    >>> import schlupf
    >>> result = schlupf.Case(kinematics={"creepage_x": 0.002}).solve()
    >>> result.force.x < 0.0, result.fields["traction_x"].attrs["units"]
    (True, 'Pa')
    """

    _solution: _core.Solution

    @classmethod
    def _new(cls, solution: _core.Solution, *, strict: bool, warn: bool) -> Result:
        result = cls(json.loads(solution.json()))
        result._solution = solution
        if strict and not result.converged:
            raise NotConverged(result)
        if warn:
            emit(result.messages, stacklevel=3)
        return result

    @property
    def converged(self) -> bool:
        """Whether the equations are satisfied to the tolerance."""
        return self.status == "converged"

    @property
    def messages(self) -> list[tuple[str, str, str]]:
        """The warnings: code, field or quantity, text."""
        return self._solution.warnings()

    @cached_property
    def fields(self) -> xr.Dataset:
        """Stress, slip and temperature over x and y (m), on the grid of the patch.

        Values are means over whole cells, not a number where there is no contact. ``covered`` is
        the part of a cell that is in contact, and ``centroid_x``, ``centroid_y`` its centroid.
        """
        dataset = on_grid(self._solution.fields(), self._solution.axes()).isel(time=0)
        return dataset.assign_attrs(self._origin())

    @cached_property
    def field_history(self) -> xr.Dataset:
        """The same over ``time`` (s), where the case was solved with ``fields_every``.

        The coordinate ``step`` counts time steps, as `history` has them.

        Raises
        ------
        ValueError
            If there are no such fields.
        """
        steps, times, columns = self._solution.field_history()
        if not steps:
            raise ValueError(
                "there are no fields over time: give the case a history, or marching as its "
                "driver, and `solve` a `fields_every`"
            )
        units = attributes(self._solution.history()["time"])
        dataset = on_grid(columns, self._solution.axes())
        step = ("time", steps, {"long_name": "time step", "units": ""})
        dataset = dataset.assign_coords(time=("time", times, units), step=step)
        return dataset.assign_attrs(self._origin())

    def _origin(self) -> dict[str, str]:
        return {"title": self.title, "source": self.program}

    @cached_property
    def history(self) -> xr.Dataset:
        """Forces, powers and temperatures of each time step, over ``time`` (s)."""
        return along(self._solution.history(), "time", "time")

    @property
    def state(self) -> bytes | None:
        """The final state, from which another run may start."""
        return self._solution.state()

    @property
    def plot(self) -> ResultPlots:
        """Plots: ``result.plot.traction()`` and others."""
        from ._plots import ResultPlots

        return ResultPlots(self)

    def summary(self) -> str:
        """The summary that the command prints."""
        return self._solution.summary()

    def to_json(self, path: str | PathLike[str] | None = None) -> str:
        """The documented JSON; it is also written to `path` if that is given."""
        return written(self._solution.json(), path)

    def to_dataframe(self) -> pd.DataFrame:
        """The cells in contact as a data frame of pandas."""
        frame = self.fields.to_dataframe()
        return frame[frame["contact"]].drop(columns="contact").reset_index()

    def to_netcdf(self, path: str | PathLike[str], **options: Any) -> None:
        """Writes the result as NetCDF, for `open_result`.

        The fields, with the scalars as JSON in an attribute, and groups: ``history``,
        ``field_history`` and ``files``, what the command would write.

        Parameters
        ----------
        path : path
            The file.
        **options
            Of `xarray.Dataset.to_netcdf`; ``encoding`` is that of the fields, and ``engine`` by
            default h5netcdf where it is installed.
        """
        path = with_folder(path)
        if find_spec("h5netcdf"):
            # SciPy, which xarray may take, writes no groups.
            options = {"engine": "h5netcdf", **options}
        with unfinished(path) as part_of_file:
            for group, part in self._parts().items():
                part.to_netcdf(part_of_file, "a" if group else "w", group=group, **options)
                options.pop("encoding", None)

    def to_zarr(self, store: Any, **options: Any) -> None:
        """Writes the same as Zarr."""
        for group, part in self._parts().items():
            part.to_zarr(store, group=group, **options)
            options |= {"mode": "a", "consolidated": False}
            options.pop("encoding", None)

    def to_csv(self, path: str | PathLike[str]) -> None:
        """Writes the cells in contact as CSV, as the command does."""
        self._require_fields()
        written(self._solution.csv() or "", path)

    def to_vtk(self, path: str | PathLike[str]) -> None:
        """Writes the fields for ParaView, as a ``.vtk`` file."""
        self._require_fields()
        with open(with_folder(path), "wb") as file:
            file.write(self._solution.vtk() or b"")

    def _require_fields(self) -> None:
        if not len(self.fields["x"]):
            raise ValueError(f"the method {self.method} gives forces, but no fields")

    def _parts(self) -> dict[str | None, xr.Dataset]:
        """What is written, by its group."""
        answers = {name: getattr(self._solution, name)() for name in FILES}
        answers |= {"lines": json.dumps(answers["lines"]), "warnings": json.dumps(self.messages)}
        texts = {name: text for name, text in answers.items() if text is not None}
        files = {
            name: (
                f"{name}_byte",
                np.frombuffer(text.encode() if isinstance(text, str) else text, np.uint8),
            )
            for name, text in texts.items()
        }
        parts: dict[str | None, xr.Dataset] = {"history": self.history, "files": xr.Dataset(files)}
        with suppress(ValueError):
            parts["field_history"] = self.field_history
        saved = {"result": self._solution.json(), "groups": " ".join(map(str, parts))}
        return {None: self.fields.assign_attrs(saved), **parts}

    def __repr__(self) -> str:
        return self.summary().rstrip()

    def __reduce__(self) -> Any:
        # One that was opened has no other ones.
        own = {name: of for name, of in self.__dict__.items() if isinstance(of, xr.Dataset)}
        return restored, (type(self), {"_solution": Saved.of(self._solution), **own})

    def _repr_html_(self) -> str:
        """Summary and a small map of the traction."""
        text = table(self._solution.lines())
        picture = self.plot._thumbnail() if len(self.fields["x"]) else None
        if picture is None:
            return text
        image = f'<img alt="traction" src="data:image/png;base64,{picture}">'
        # Without the last one the picture is as high as the table.
        style = "display:flex;gap:1em;flex-wrap:wrap;align-items:flex-start"
        return f'<div style="{style}">{text}{image}</div>'


class Saved:
    """All answers of an object of the library, which itself cannot be pickled."""

    def __init__(self, answers: dict[str, Any]) -> None:
        self.answers = answers

    @classmethod
    def of(cls, source: Any) -> Saved:
        """Asks for them."""
        if isinstance(source, Saved):
            return source
        names = [name for name in dir(source) if not name.startswith("_")]
        return cls({name: getattr(source, name)() for name in names})

    def __getattr__(self, name: str) -> Any:
        try:
            answer = self.__dict__["answers"][name]
        except KeyError:
            raise AttributeError(name) from None
        return lambda: answer


#: Answers of a solution that are written as they are.
FILES = ("summary", "lines", "warnings", "csv", "vtk", "state")


def open_result(path: str | PathLike[str], **options: Any) -> Result:
    """The result that `Result.to_netcdf` or `Result.to_zarr` has written.

    Parameters
    ----------
    path : path
        The file, or the folder of a Zarr store.
    **options
        Of `xarray.open_dataset`, such as ``engine``.

    Raises
    ------
    FileNotFoundError
        If there is none.
    ValueError
        If it is no result.
    """
    path = Path(path)
    if not path.exists():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), os.fspath(path))
    if path.is_dir():
        options = {"engine": "zarr", "consolidated": False, **options}

    def part(group: str | None) -> xr.Dataset:
        with xr.open_dataset(path, group=group, **options) as dataset:
            return dataset.load()

    refused = f"{path} must be a result that schlupf has written, but is not"
    try:
        fields = part(None)
    except (ImportError, PermissionError):
        raise
    # Whatever engines raise for what they do not read.
    except Exception as error:
        # Without their advice about engines.
        reason = " ".join(str(error).split()).partition(". ")[0]
        raise ValueError(f"{refused}: {reason}") from error
    if "groups" not in fields.attrs:
        raise ValueError(refused)
    scalars = fields.attrs.pop("result")
    parts = {name: part(name) for name in fields.attrs.pop("groups").split()}
    files = {str(name): data.values.tobytes() for name, data in parts.pop("files").items()}
    answers: dict[str, Any] = dict.fromkeys(FILES) | files | {"json": scalars}
    answers |= {name: files[name].decode() for name in ("summary", "csv") if name in files}
    lines = json.loads(files["lines"])
    answers["lines"] = [line if isinstance(line, str) else tuple(line) for line in lines]
    answers["warnings"] = [tuple(message) for message in json.loads(files["warnings"])]
    answers["field_history"] = ([], [], {})
    solution = Saved(answers)
    result = restored(Result, {"_solution": solution, "fields": fields, **parts})
    assert isinstance(result, Result)
    return result


def restored(kind: type[Record], attributes: dict[str, Any]) -> Record:
    """A pickled result: what it had, the answers of the library among it."""
    (saved,) = (value for value in attributes.values() if isinstance(value, Saved))
    record = kind(json.loads(saved.json()))
    record.__dict__.update(attributes)
    return record


#: Text among entries: a page's style for code does not make it a box.
PLAIN = "margin:0;padding:0.3em;border:0;background:none"


def table(lines: Sequence[tuple[str, str, str, str] | str]) -> str:
    """A summary as HTML: entries in columns, other lines as they are."""
    rows = []
    for is_text, group in itertools.groupby(lines, lambda line: isinstance(line, str)):
        if is_text:
            text = html.escape("\n".join(map(str, group)).strip("\n"))
            pre = f'<pre style="{PLAIN}">{text}</pre>' if text else ""
            rows.append(f'<tr><td colspan="4" style="text-align:left">{pre}</td></tr>')
        else:
            rows += [_row(line) for line in group if not isinstance(line, str)]
    return f"<table>{''.join(rows)}</table>"


def _row(entry: tuple[str, str, str, str]) -> str:
    """Name, value, unit and remark as a row."""
    name, value, unit, remark = entry
    indent = "padding-left:1.5em;" if name.startswith(" ") else ""
    cells = [(name.strip(), f"{indent}text-align:left"), (value, "text-align:right")]
    cells += [(unit, "text-align:left"), (remark, "text-align:left")]
    columns = (f'<td style="padding:0 0.3em;{s}">{html.escape(cell)}</td>' for cell, s in cells)
    return f"<tr>{''.join(columns)}</tr>"


def written(text: str, path: str | PathLike[str] | None) -> str:
    if path is not None:
        with open(with_folder(path), "w", encoding="utf-8") as file:
            file.write(text)
    return text


def with_folder(path: str | PathLike[str]) -> Path:
    """The path of an output, whose folder is made where it is missing."""
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    return path


@contextmanager
def unfinished(path: Path) -> Iterator[Path]:
    """The path of an output while it is written; there is none if that fails."""
    part = path.with_name(f"{path.name}.part")
    try:
        yield part
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)
