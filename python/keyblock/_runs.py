"""Runs, factors of safety and stress intensity factors.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import math
import os
import threading
import time
from pathlib import Path
from typing import Any, Callable, Iterable, Mapping

from . import _keyblock
from ._cases import Case, Context, Plan, StrPath, checked, encoded, read, setting_pairs, texts
from ._frames import Frame
from ._records import Results


class Run:
    """Steps of a case, made one at a time. Nothing is printed, and nothing is written unless `record` made the run.

    case: a Case, a Plan, or the path of a case. profile, settings, history: see Plan. threads: see Context; not
    beside a context. load: a function of time that returns the acceleration (ax, ay) of a force per mass on every block,
    both in units of the case. It is called once per step, before the run. Its values go to the setting
    `body_acceleration_file`, which a Plan has already: load needs a case, without another table of accelerations. Where
    nothing accelerates, as in linear statics, the plan warns `setting_without_effect`.

    Iteration makes the steps: `for step in run`. Ctrl-C stops the computation within about a second and raises
    KeyboardInterrupt; a factorisation that runs may end behind it. A stopped run does not go on. Several runs in several
    threads are independent; one thread at a time may step a run. Raises InputError, SettingError, Stopped.
    """

    def __init__(self, case: Case | Plan | StrPath, profile: str | None = None, settings: Mapping[str, Any] | None = None,
                 threads: int | None = None, context: _keyblock.Context | None = None, history: str | Iterable[str] = (),
                 load: Callable[[float], tuple[float, float]] | None = None) -> None:
        if context is not None and threads is not None:
            raise ValueError("threads: expected none beside a context, which has its own; give them to the Context")
        self.context = context or Context(threads)
        self.load_seconds = 0.0
        if load is not None and isinstance(case, Plan):
            raise ValueError("load: expected a case, found a Plan, whose settings are fixed; load is one of them")
        if load is not None:
            settings = dict(settings or {}, **self._table_of(load, case, profile, settings))
        if isinstance(case, Plan):
            if profile or settings or history:
                raise ValueError("a Plan has its profile, settings and histories; give them to the Plan")
            self._plan: Plan | None = case
        else:
            self._plan = Plan(case, profile, settings, self.context, history)
        self._case = self._plan.case
        self._run = _keyblock.Run(self._plan._plan, self.context)
        self._folder: Path | None = None  # of results
        self._stepper = threading.RLock()

    def _table_of(self, load: Callable[[float], tuple[float, float]], case: Any, profile: str | None,
                  settings: Any) -> dict[str, str]:
        import tempfile
        plan = Plan(case, profile, settings, self.context)
        if _has_accelerations(plan):
            raise ValueError("load: expected a case without a table of accelerations, which load would replace; "
                             "add its values to those of load, and remove it")
        times = plan._plan.step_times
        self._file = tempfile.NamedTemporaryFile("w", suffix=".csv")  # read while the plan is made
        began = time.perf_counter()
        rows = [(t, *_acceleration(load(t), t)) for t in times]
        self.load_seconds = time.perf_counter() - began
        rows.append((2 * times[-1] - times[-2], *rows[-1][1:]))  # the run may end behind the last row by round-off
        self._file.write("time,ax,ay\n" + "".join(f"{t!r},{x!r},{y!r}\n" for t, x, y in rows))
        self._file.flush()
        return {"body_acceleration_file": self._file.name}

    @property
    def plan(self) -> Plan:
        """Plan of the run."""
        if self._plan is None:  # of `record` and `resume` with a condition
            self._plan = Plan(self._case, self._choices[0] or None, dict(self._choices[1]))
            self._plan._case = self._known
        return self._plan

    def __iter__(self) -> Run:
        return self

    def __next__(self) -> _keyblock.Step:
        if not self.advance():
            raise StopIteration
        return self.last

    def advance(self) -> bool:
        """Makes one step. Returns False if the run is at its end, stopped or failed; `outcome` gives the reason."""
        self._begin_to_step()
        try:
            return self._run.advance()
        finally:
            self._stepper.release()

    def _begin_to_step(self) -> None:
        """Refuses a second thread that steps the run."""
        if not self._stepper.acquire(blocking=False):
            raise _keyblock.Error("another thread steps this run; one thread at a time may step a run")

    def go_on(self, until: Callable[[Run], Any] | None = None) -> _keyblock.Outcome:
        """Makes steps to the end, or until `until(run)` is true after a step; the run may then go on.

        Returns the outcome, whose `end` is "running" if `until` ended the steps, also at the last one. A run made by
        `record` ends there instead: its results are written, run.json has the reason as `ended_early`, and `resume`
        continues it. A text that `until` returns is the reason. An exception of `until` passes through; a recorded run
        then ends as an interrupted one.
        """
        self._begin_to_step()
        try:
            if until is None:
                return self._run.finish()
            for _ in self:
                if met := until(self):
                    self._end_early(met if isinstance(met, str) else f"{getattr(until, '__name__', 'until')} is true")
                    break
            return self.outcome
        except BaseException:
            self._end_early("")
            raise
        finally:
            self._stepper.release()

    def _end_early(self, why: str) -> None:
        """Writes the results of a recorded run; does nothing to another run, or after its end."""
        if self._folder is not None:
            try:
                self._run.end_early(why)
            except _keyblock.Error:  # an interrupted computation still ends, and writes them
                if why:
                    raise

    def stop(self) -> None:
        """Stops the run, also from another thread. It does not go on."""
        self.context.stop()

    def frame(self, detail: str = "blocks") -> Frame:
        """Returns the state of now. detail="corners" adds displacement and stress of corners, and faces of cracks."""
        if detail not in ("blocks", "corners"):
            raise ValueError(f"detail: expected blocks or corners, found {detail}")
        return Frame(self._run.frame(detail == "corners"), self._case.units)

    def index_of(self, number: int) -> int:
        """Returns the row of the block with this number in the frame of now. Raises KeyError if there is none."""
        return self.frame().index_of(number)

    def histories(self) -> list[str]:
        """Returns the names of the histories: those of the case, and those of `history`."""
        return self._run.histories()

    def history(self, name: str) -> Any:
        """Returns a history so far: a data frame of time and quantities, with units in `attrs["units"]`.

        Without pandas: a dict of arrays. A quantity without a value at a time is nan there. Rows are those of
        histories.csv; those of "ledger" are of ledger.csv. A quantity of the energy balance, such as "kinetic", gives an
        array of its values. Raises SettingError for another name.
        """
        if name not in self._run.histories() and name in self._balance():
            return self._run.history("ledger", name)[:, 1]
        units = {"time": self._case.units[2], **dict(self._run.quantities(name))}
        columns: dict[str, Any] = {}
        for quantity in list(units)[1:]:
            rows = self._run.history(name, quantity)  # time and value
            columns.setdefault("time", rows[:, 0])
            columns[quantity] = rows[:, 1]
        try:
            import pandas
        except ImportError:
            return columns
        table = pandas.DataFrame(columns)
        table.attrs["units"] = units
        return table

    def _balance(self) -> list[str]:
        """Quantities of the energy balance; none without one."""
        try:
            return [quantity for quantity, _ in self._run.quantities("ledger")]
        except _keyblock.SettingError:
            return []

    @property
    def last(self) -> _keyblock.Step:
        """The last accepted step."""
        return self._run.last

    @property
    def outcome(self) -> _keyblock.Outcome:
        """End, reason, sentences, warnings and doubts; its `end` is "running" before the end."""
        return self._run.outcome

    def record(self, folder: StrPath, every: int = 0, history: str | Iterable[str] = (), force: bool = False,
               pictures: bool = True, contacts: str = "", frames: str = "automatic", checkpoint_every: float = 30,
               context: _keyblock.Context | None = None) -> Run:
        """Returns a run of the same case, from its start, that writes into a folder what `keyblock run` leaves there.

        The steps of this run are not used. Options are those of `record`. Step the new run by `go_on` or iteration. All
        results are in the folder when it has ended; `results` has them. A run that is dropped before its end leaves the
        folder of an interrupted run. The table of a `load` is a temporary file, which `resume` does not find later: for
        a run to resume, name a file of your own in the setting `body_acceleration_file`.
        """
        followed = [*self.plan._history, *texts(history)]
        run = recorded(self._case, folder, self.plan._choices, every, followed, force, pictures, contacts, frames,
                       checkpoint_every, context or Context(), self.plan)
        run._file, run.load_seconds = getattr(self, "_file", None), self.load_seconds
        return run

    @property
    def results(self) -> Results:
        """Results of a run made by `record`, after its end. Raises Error for another run, and before the end."""
        if self._folder is None or self.outcome.end == "running":
            raise _keyblock.Error("expected a recorded run that has ended; record(folder) makes one, go_on() ends it")
        return Results(self._folder)

    def __repr__(self) -> str:
        return f"<Run {self.outcome.end}, step {self.last.number} of {self.plan.steps}>"


def recorded(case: Case, folder: StrPath, choices: tuple[str, list[tuple[str, str]]], every: int, history: Iterable[str],
             force: bool, pictures: bool, contacts: str, frames: str, checkpoint_every: float, context: _keyblock.Context,
             plan: Plan | None = None) -> Run:
    """Returns a Run at its start that writes into a folder."""
    checked("every", every, is_whole=True)
    checked("checkpoint_every", checkpoint_every)
    run = _keyblock.Run.recorded(case._case, encoded(folder), every, force, pictures, checkpoint_every, list(history),
                                 contacts, frames, *choices, context)
    return _in_folder(run, folder, context, case, choices, plan)


def resumed(folder: StrPath, context: _keyblock.Context) -> Run:
    """Returns the interrupted run of a folder, at its checkpoint."""
    read_again = _case_of(folder)
    run = _keyblock.Run.resumed(encoded(folder), context)
    made = _in_folder(run, folder, context, Case(run.case))  # which has profile and settings of the run
    if read_again is not None and read_again.json() == run.case.json():  # a drawing may have had another unit
        made._known = read_again
    return made


def _case_of(folder: StrPath) -> Case | None:
    """Case of an interrupted run by the files in its run.json; None if that does not tell them."""
    try:
        told = Results(folder).run
        files = [os.path.join(told["made_by"]["folder"], file["file"]) for file in told["inputs"] if "setting" not in file]
        return read(*files).with_values(told.get("values", {}))
    except (OSError, ValueError, KeyError, TypeError, _keyblock.Error):
        return None


def _in_folder(of: _keyblock.Run, folder: StrPath, context: _keyblock.Context, case: Case,
               choices: tuple[str, list[tuple[str, str]]] = ("", []), plan: Plan | None = None) -> Run:
    run = Run.__new__(Run)
    run.context, run.load_seconds, run._stepper, run._folder = context, 0.0, threading.RLock(), Path(folder).absolute()
    run._run, run._case, run._choices, run._plan, run._known = of, case, choices, plan, case
    return run


def _has_accelerations(plan: Plan) -> bool:
    """Returns true if the case or its settings have accelerations over time."""
    try:
        return bool(plan.settings["body_acceleration_file"] or plan.case.get("/analysis/body_acceleration"))
    except _keyblock.SettingError:  # no such key, or no case file
        return False


def _acceleration(value: Any, at: float) -> tuple[float, float]:
    """Numbers of an acceleration that `load` returned for a time."""
    try:
        x, y = map(float, value)
    except (TypeError, ValueError):
        x = y = float("nan")
    if not (math.isfinite(x) and math.isfinite(y)):
        raise ValueError(f"load: expected an acceleration (ax, ay) of finite numbers at time {at:g}, found {value!r}")
    return x, y


class Strength:
    """Factor of safety: the bracket, its trials, and the states on both sides.

    stands: largest factor at which the case is stable, or None. falls: smallest factor at which it is unstable, or None.
    profile: of all trials; why_profile: the reason for it. settings: dict of names and values, all those of the trials,
    both text. unknowns: their number.
    end: bracketed, falls, stands, undecided or stopped. trials: list of Trial. notes: sentences. warnings: list of Warning.
    standing: Frame of the equilibrium at `stands`. falling: Frame at `falls`: the end of the search, out of balance, or an
    equilibrium far from the drawing. Each stays None if the search has none; neither has contacts.
    """

    def __init__(self, found: _keyblock.Strength, units: tuple[str, ...]) -> None:
        self.stands, self.falls, self.end = found.stands, found.falls, found.end
        self.profile, self.why_profile = found.profile, found.why_profile
        self.settings, self.unknowns = dict(found.settings), found.unknowns
        self.trials, self.notes, self.warnings = found.trials, found.notes, found.warnings
        self.standing = None if found.standing is None else Frame(found.standing, units)
        self.falling = None if found.falling is None else Frame(found.falling, units)

    def __repr__(self) -> str:
        return f"<Strength {self.end}, stands {self.stands}, falls {self.falls}, profile {self.profile}>"


def factor_of_safety(case: Case | StrPath, what: str = "", within: float = 0.0, profile: str | None = None,
                     settings: Mapping[str, Any] | None = None, context: _keyblock.Context | None = None) -> Strength:
    """Divides the strength of "joints", "rock" or "both" until the case is unstable, as `keyblock fos`.

    what, within: empty and 0 take what the `case.json` of a folder requests, else "joints" and 0.01. The result has the
    bracket (`stands`, `falls`), `end`, `trials`, `notes`, `warnings`, and the frames `standing` and `falling`. profile: None
    takes what the files request, else standard, also for old files: the rules of Shi's programs, which `Run` follows there,
    find no equilibrium. Unlike the command it makes no second search on a coarser mesh. Raises SettingError for another
    word or a width below 0.
    """
    case = case if isinstance(case, Case) else read(case)
    return Strength(_keyblock.factor_of_safety(case._case, what, within, profile or "", setting_pairs(settings),
                                               context or Context()), case.units)


class Tips(list):  # type: ignore[type-arg]
    """List of Tip. `warnings`: list of Warning, of reading, preparing and computing.

    `profile`, `why_profile`, `settings` (dict of names and values, both text) and `unknowns` are those of the run.
    """

    def __init__(self, found: _keyblock.Intensity) -> None:
        super().__init__(found.tips)
        self.warnings, self.profile, self.why_profile = list(found.warnings), found.profile, found.why_profile
        self.settings, self.unknowns = dict(found.settings), found.unknowns


def stress_intensity(case: Case | StrPath, profile: str | None = None, settings: Mapping[str, Any] | None = None,
                     context: _keyblock.Context | None = None) -> Tips:
    """Returns the stress intensity factors of all crack tips at the end of the loads, as `keyblock sif`: list of Tip.

    The list has `warnings`. `Tip` has x, y, k1, k2, j, kink_deg, k_equivalent, spread and doubt. Raises InputError for a
    case without cracks.
    """
    case = case if isinstance(case, Case) else read(case)
    return Tips(_keyblock.stress_intensity(case._case, profile or "", setting_pairs(settings), context or Context()))
