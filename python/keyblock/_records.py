"""Result folders: runs that leave what `keyblock run` leaves.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import csv
import functools
import json
from pathlib import Path
from typing import Any, Callable, Iterable, Mapping

from . import _keyblock
from ._cases import Case, Context, StrPath, called, checked, encoded, read, setting_pairs, texts
from ._program import number_of


class Results:
    """Folder of a recorded run, also of `keyblock run`.

    folder: its path. run: content of run.json; empty for a run that was killed, or goes on, whose tables may be read.
    Raises Error if the folder holds neither record nor tables.
    """

    def __init__(self, folder: StrPath) -> None:
        self.folder = Path(folder)
        record = self.folder / "run.json"
        if not record.exists() and not self.tables():
            raise _keyblock.Error(f"{folder}: expected the results of a run, found none")
        self.run = json.loads(record.read_text(encoding="utf-8")) if record.exists() else {}

    @property
    def end(self) -> str:
        """finished, stopped or failed; unfinished without a record."""
        return str(self.run["outcome"]["end"]) if self.run else "unfinished"

    @property
    def doubts(self) -> list[Any]:
        """Reasons not to trust the results."""
        return list(self.run.get("outcome", {}).get("doubts", []))

    def tables(self) -> list[str]:
        """Returns the names of the tables, such as history and contacts."""
        return sorted(p.stem for p in self.folder.glob("*.csv"))

    def table(self, name: str) -> Any:
        """Returns a table as a data frame with plain column names; its units are in `attrs["units"]`.

        Each column has one type: whole numbers, numbers (nan for an empty cell) or text. Without pandas: a dict of lists.
        """
        with open(self.folder / f"{name}.csv", newline="", encoding="utf-8") as file:
            heading, *rows = csv.reader(file)
        names, units = [], {}
        for text in heading:
            plain, _, unit = text.partition(" [")
            names.append(plain)
            units[plain] = unit.rstrip("]")
        columns = {n: _column(n, [row[i] for row in rows]) for i, n in enumerate(names)}
        try:
            import pandas
        except ImportError:
            return columns
        table = pandas.DataFrame(columns)
        table.attrs["units"] = units
        return table

    def __repr__(self) -> str:
        return f"<Results {self.folder}: {self.end}>"


_TEXTS = ("what", "name", "quantity", "unit", "state")


def _column(name: str, cells: list[str]) -> list[Any]:
    """Values of a column, all of one type. The name of a history may look like a number, and stays text."""
    if name in _TEXTS:
        return list(cells)
    values = [number_of(cell) if cell else float("nan") for cell in cells]
    if any(isinstance(value, str) for value in values):
        return list(cells)
    return values if all(isinstance(value, int) for value in values) else [float(value) for value in values]


def _results(folder: StrPath, end: str) -> Results:
    """Results of a run that has ended; one that was stopped before its first step left no run.json."""
    if end != "stopped" or (Path(folder) / "run.json").exists():
        return Results(folder)
    results = Results.__new__(Results)
    results.folder, results.run = Path(folder), {"outcome": {"end": end}}
    return results


def record(case: Case | StrPath, folder: StrPath, profile: str | None = None, settings: Mapping[str, Any] | None = None,
           every: int = 0, history: str | Iterable[str] = (), force: bool = False, pictures: bool = True, contacts: str = "",
           frames: str = "automatic", checkpoint_every: float = 30, on_step: Callable[[_keyblock.Step], Any] | None = None,
           context: _keyblock.Context | None = None, until: Callable[[Any], Any] | None = None) -> Results:
    """Runs a case to its end, with all files in a folder that `keyblock run` leaves there; returns its Results.

    every: steps per frame; 0 means as the case says, at most 100 frames. history: quantities to follow, such as
    "crest=point:12,20" or "block:4". force: overwrite results of an earlier run. contacts, frames: as `--contacts` and
    `--frames`. checkpoint_every: seconds between checkpoints; 0 means only at the start and at a stop. on_step: a function
    that is called with each step; an exception of it ends the run, and passes through. until: a function of the Run that
    ends it after the step where it is true, as in `Run.go_on`. A run that ended so, or was stopped, also by Ctrl-C, can be
    resumed. Raises InputError, SettingError, Error.
    """
    checked("every", every, is_whole=True)
    checked("checkpoint_every", checkpoint_every)
    history = texts(history)
    called("on_step", on_step)
    called("until", until)
    case = case if isinstance(case, Case) else read(case)
    choices, context = (profile or "", setting_pairs(settings)), context or Context()
    if until is not None or on_step is not None:
        from ._runs import recorded  # which imports this module
        return _watched(until, on_step, folder,
                        lambda: recorded(case, folder, choices, every, history, force, pictures, contacts, frames,
                                         checkpoint_every, context))
    return _results(folder, _keyblock.record(case._case, encoded(folder), every, force, pictures, checkpoint_every,
                                             history, contacts, frames, *choices, context).end)


def _watched(until: Callable[[Any], Any] | None, on_step: Callable[[_keyblock.Step], Any] | None, folder: StrPath,
             begin: Callable[[], Any]) -> Results:
    """Steps the recorded run that `begin` returns, to its end or until a condition is true."""
    @functools.wraps(until or _never)
    def is_met(run: Any) -> Any:
        if on_step is not None:
            on_step(run.last)
        return until is not None and until(run)
    try:
        run = begin()
    except _keyblock.Stopped:  # before its first step
        return _results(folder, "stopped")
    return _results(folder, run.go_on(is_met).end)


def _never(run: Any) -> bool:
    return False


def resume(folder: StrPath, on_step: Callable[[_keyblock.Step], Any] | None = None,
           context: _keyblock.Context | None = None, until: Callable[[Any], Any] | None = None) -> Results:
    """Continues an interrupted `record`, or `keyblock run` of the same build, from its checkpoint; returns its Results.

    until: as in `record`; its Run has the histories of the whole run. Raises InputError, and SettingError if there is
    nothing to resume.
    """
    context = context or Context()
    if called("until", until) is not None or called("on_step", on_step) is not None:
        from ._runs import resumed
        return _watched(until, on_step, folder, lambda: resumed(folder, context))
    return _results(folder, _keyblock.resume(encoded(folder), context).end)
