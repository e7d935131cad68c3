"""Sweeps: one case under many values, each in a child process, as one table.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import csv
import hashlib
import html
import itertools
import json
import os
import random as _random
import statistics
import time
from typing import Any, Callable, Iterable, Mapping, Sequence

import numpy as np

from . import _keyblock
from ._cases import Case, StrPath, _plain, read, setting_pairs
from ._pool import Failed, Pool
from ._runs import Run, factor_of_safety


class Table(list):  # type: ignore[type-arg]
    """Rows of a sweep: a list of dicts with the same keys. `table["fos"]` is a column as an array."""

    def __getitem__(self, key: Any) -> Any:
        if not isinstance(key, str):
            return super().__getitem__(key)
        return np.array([row[key] for row in self])

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        return list(self[0]) if self else []

    def pandas(self) -> Any:
        """Returns the table as a pandas data frame."""
        import pandas
        return pandas.DataFrame(list(self), columns=self.columns)

    def write(self, path: StrPath) -> None:
        """Writes the table as CSV; an existing file is replaced."""
        with open(path, "w", newline="", encoding="utf-8") as file:
            out = csv.DictWriter(file, self.columns, lineterminator="\n")
            out.writeheader()
            out.writerows(self)

    def _repr_html_(self) -> str:
        cells = [[_short(v) for v in row.values()] for row in self]
        rows = ["<tr>" + "".join(f"<td>{html.escape(c)}</td>" for c in row) + "</tr>" for row in cells]
        heading = "".join(f"<th>{html.escape(c)}</th>" for c in self.columns)
        return f"<table><tr>{heading}</tr>{''.join(rows)}</table>"

    def __repr__(self) -> str:
        rows = [[_short(v) for v in row.values()] for row in self[:20]]
        widths = [max(len(t) for t in column) for column in zip(self.columns, *rows)]
        lines = ["  ".join(t.rjust(w) for t, w in zip(row, widths)) for row in [self.columns, *rows]]
        return "\n".join(lines + ([f"… {len(self)} rows"] if len(self) > 20 else []))


def _short(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def grid(over: Mapping[str, Iterable[Any]]) -> list[dict[str, Any]]:
    """Returns all combinations of values: a list of dicts. over: dict of keys and lists; the last key varies fastest."""
    lists = [v if isinstance(v, (list, tuple)) else list(v) for v in over.values()]
    return [dict(zip(over, map(_plain, values))) for values in itertools.product(*lists)]


class _Distribution:
    def __init__(self, inverse: Callable[[float], Any]) -> None:
        self.inverse = inverse  # of the cumulative distribution


def uniform(low: float, high: float) -> _Distribution:
    """Uniform distribution between two bounds."""
    return _Distribution(lambda p: low + (high - low) * p)


def normal(mean: float, deviation: float, low: float = -np.inf, high: float = np.inf) -> _Distribution:
    """Normal distribution, cut off below `low` and above `high`: no value lies outside."""
    base = statistics.NormalDist(mean, deviation)
    first, last = base.cdf(low) if low > -np.inf else 0.0, base.cdf(high) if high < np.inf else 1.0
    return _Distribution(lambda p: base.inv_cdf(min(max(first + (last - first) * p, 1e-16), 1 - 1e-16)))


def lognormal(mean: float, deviation: float) -> _Distribution:
    """Lognormal distribution with this mean and standard deviation of the value itself."""
    of_log = np.log1p((deviation / mean) ** 2)
    base = statistics.NormalDist(np.log(mean) - of_log / 2, np.sqrt(of_log))
    return _Distribution(lambda p: float(np.exp(base.inv_cdf(p))))


def choice(*values: Any) -> _Distribution:
    """One of some values, each as likely."""
    return _Distribution(lambda p: values[min(int(p * len(values)), len(values) - 1)])


def random(over: Mapping[str, _Distribution], count: int, seed: int = 1) -> list[dict[str, Any]]:
    """Returns a Latin hypercube of `count` rows: a list of dicts. over: dict of keys and distributions.

    Each distribution is cut into `count` parts of equal probability, and each part is used once. The same seed gives the
    same rows.
    """
    source = _random.Random(seed)
    columns = []
    for distribution in over.values():
        order = list(range(count))
        source.shuffle(order)
        columns.append([distribution.inverse((i + 1e-9 + (1 - 2e-9) * source.random()) / count) for i in order])
    return [dict(zip(over, values)) for values in zip(*columns)]


def _displacement(run: Run) -> float:
    return float(np.hypot(*run.frame().displacement.T).max())


_OUTPUTS: dict[str, Callable[[Run], Any]] = {
    "displacement": _displacement,
    "speed": lambda run: float(np.hypot(*run.frame().velocity.T).max()),
    "steps": lambda run: run.outcome.steps,
    "time": lambda run: run.outcome.time,
    "blocks": lambda run: run.plan.blocks,
}
_FACTORS = {"fos": "", "fos_joints": "joints", "fos_rock": "rock", "fos_both": "both"}


def _point_output(name: str) -> Callable[[Run], float] | None:
    """An output such as point1.dx; nothing if it is another name."""
    part, _, axis = name.partition(".")
    if not part.startswith("point") or not part[5:].isdigit() or axis not in ("dx", "dy"):
        return None
    row, column = int(part[5:]) - 1, "dx dy".split().index(axis)
    return lambda run: float(run.frame().point_displacement[row, column])


def _outputs(out: Iterable[str]) -> list[tuple[str, Callable[[Run], Any] | None]]:
    """(name, function) of each output; the function is None for a factor of safety."""
    found = []
    for name in out:
        function = _OUTPUTS.get(name) or _point_output(name)
        if not function and name not in _FACTORS:
            raise ValueError(f"out: expected one of {', '.join([*_OUTPUTS, *_FACTORS])}, point1.dx, found {name}")
        found.append((name, function))
    return found


def _row(case: Any, values: dict[str, Any], out: Any, profile: str | None, settings: Any) -> dict[str, Any]:
    """Verdict, doubts and outputs of one row: the work of a child."""
    keys = {k: v for k, v in values.items() if k.startswith("/")}
    names = {k: v for k, v in values.items() if not k.startswith("/")}
    if isinstance(case, Case):
        settings = dict(settings or {}, **names)
    else:
        case = case(**names)
    case = case.with_values(keys)
    row: dict[str, Any] = {"verdict": "", "doubt": ""}
    functions = None if callable(out) else _outputs(out)
    if functions is None or any(f for _, f in functions):
        run = Run(case, profile, settings)
        outcome = run.go_on()
        row["verdict"] = outcome.end
        row["doubt"] = outcome.reason or " ".join(d.code for d in outcome.doubts)
        if functions is None:
            result = out(run)
            row.update(_plain_dict(result if isinstance(result, dict) else {"out": result}))
    for name, function in functions or ():
        if function:
            row[name] = function(run)
            continue
        found = factor_of_safety(case, _FACTORS[name], profile=profile, settings=settings)
        row["verdict"] = row["verdict"] or found.end
        row[name] = found.stands if found.stands is not None else float("nan")
    return row


def _plain_dict(values: Mapping[str, Any]) -> dict[str, Any]:
    return {k: _plain(v) for k, v in values.items()}


def sweep(case: Case | StrPath | Callable[..., Case], over: Mapping[str, Iterable[Any]] | Iterable[Mapping[str, Any]],
          out: str | Iterable[str] | Callable[[Run], Any] = ("displacement",), jobs: int = 2,
          time_limit: float | None = None, memory_limit: int | None = None, profile: str | None = None,
          settings: Mapping[str, Any] | None = None, resume: StrPath | Sequence[StrPath] | None = None,
          shard: str | None = None) -> Table:
    """Runs a case under many values and returns a Table, one row per run in the order of `over`.

    case: a Case, a path, or a function that takes values by name and returns a Case, such as one that draws joints from a
    seed. over: a dict of lists (all combinations), or a list of dicts, such as `random` returns. A key that begins with /
    is a pointer into the case file, as `Case.with_value` has it; another key is a setting, or an argument of the function.
    out: names (displacement, speed, steps, time, blocks, point1.dx, fos, fos_rock, …), or a function of the finished Run
    that returns a number or a dict.

    Each run is a child process with one thread. One that crashes, is killed, or exceeds its time or memory is one row with
    its verdict: signal, time_limit or error; the doubt gives the reason. resume: a file to which each row is added as it
    ends; a second call with the same arguments computes the missing rows alone. Several files are read, and rows are added
    to the first. shard: "k/n" computes every n-th row from the k-th, k from 1 to n, and returns these rows alone; each
    shard needs a resume file of its own, and a call with all files and no shard returns the whole table.
    """
    if not callable(case) and not isinstance(case, Case):
        case = read(case)
    rows = grid(over) if isinstance(over, Mapping) else [_plain_dict(r) for r in over]
    if not callable(out):
        out = (out,) if isinstance(out, str) else tuple(out)
        _outputs(out)
    journal = _Journal(resume, [case.json() if isinstance(case, Case) else "", rows, "" if callable(out) else out,
                                profile, setting_pairs(settings)])
    wanted = _of_shard(len(rows), shard)
    missing = [i for i in wanted if i not in journal.done]

    def work(i: int) -> dict[str, Any]:
        began = time.perf_counter()
        row = _row(case, rows[i], out, profile, settings)
        return {**row, "seconds": round(time.perf_counter() - began, 3)}

    with Pool(jobs, time_limit, memory_limit) as pool:
        for at, result in pool.unordered(work, missing):
            if isinstance(result, Failed):
                result = {"verdict": result.reason, "doubt": result.message}
            journal.add(missing[at], result)
    columns: dict[str, None] = dict.fromkeys(["verdict", "doubt"])
    columns.update(dict.fromkeys([] if callable(out) else out))
    for done in journal.done.values():
        columns.update(dict.fromkeys(done))
    columns.pop("seconds", None)
    return Table({**rows[i], **{c: journal.done[i].get(c, float("nan")) for c in columns},
                  "seconds": journal.done[i].get("seconds", float("nan"))} for i in wanted)


def _of_shard(count: int, shard: str | None) -> range:
    if shard is None:
        return range(count)
    k, _, n = shard.partition("/")
    if not (k.isdigit() and n.isdigit() and 1 <= int(k) <= int(n)):
        raise ValueError(f"shard: expected k/n with k from 1 to n, found {shard}")
    return range(int(k) - 1, count, int(n))


class _Journal:
    """Rows that are done, also in files: their first line identifies the sweep, each further line is a row."""

    def __init__(self, paths: StrPath | Sequence[StrPath] | None, sweep: Any) -> None:
        self.done: dict[int, Any] = {}
        self.name = hashlib.sha256(json.dumps(sweep, default=str).encode()).hexdigest()
        names = [] if paths is None else [paths] if isinstance(paths, (str, os.PathLike)) else paths
        self.paths = [os.fspath(n) for n in names]
        for path in self.paths:
            if os.path.exists(path):
                self._read(path)
            elif path == self.paths[0]:
                self._append({"sweep": self.name})
            else:
                raise _keyblock.Error(f"{path}: error: no such file")

    def _read(self, path: str) -> None:
        with open(path, encoding="utf-8") as file:
            lines = file.read().split("\n")
        if json.loads(lines[0]).get("sweep") != self.name:
            raise _keyblock.Error(f"{path}: error: the file belongs to another sweep")
        for line in lines[1:-1]:  # the last one is empty, or was cut by a kill
            index, row = json.loads(line)
            self.done[index] = row
        if lines[-1] and path == self.paths[0]:
            with open(path, "r+", encoding="utf-8") as file:
                file.truncate(len("\n".join(lines[:-1]).encode()) + 1)

    def add(self, index: int, row: Any) -> None:
        self.done[index] = row
        if self.paths:
            self._append([index, row])

    def _append(self, entry: Any) -> None:
        with open(self.paths[0], "a", encoding="utf-8") as file:
            file.write(json.dumps(entry) + "\n")
