"""Sweeps: one case under many values, each in child processes, as one table.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import copyreg
import csv
import functools
import hashlib
import html
import itertools
import json
import math
import os
import pickle
import tempfile
import time
import types
from pathlib import Path
from typing import Any, Callable, Iterable, Iterator, Mapping, Sequence

import numpy as np

from . import _keyblock, _program
from ._cases import Case, StrPath, _plain, checked, checksums_of, read, require_unchanged, setting_pairs, texts
from ._pool import Failed, Pool
from ._runs import Run, Strength, factor_of_safety


class Table(list):  # type: ignore[type-arg]
    """Rows of a sweep: a list of dicts. Columns are the keys of all rows; `table["fos"]` is a column as an array.

    A row without a value of a column has nan in the array, and an empty cell in the file.
    `seconds`: wall time of each row; the rows have none, so that a sweep gives the same table on every machine.
    `units`: dict of the columns that have a unit, if outputs were given by name and the case declares its units.
    """

    def __init__(self, rows: Iterable[Mapping[str, Any]] = (), seconds: Iterable[float] = (),
                 units: Mapping[str, str] | None = None) -> None:
        super().__init__(rows)
        self.seconds = list(seconds)
        self.units = dict(units or {})

    def __getitem__(self, key: Any) -> Any:
        if not isinstance(key, str):
            return super().__getitem__(key)
        if self and not any(key in row for row in self):
            raise KeyError(key)
        return np.array([row.get(key, float("nan")) for row in self])

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
        return list(_union(self))

    def _texts(self, rows: Iterable[Mapping[str, Any]], text: Callable[[Any], str]) -> list[list[str]]:
        columns = self.columns
        return [[text(row[c]) if c in row else "" for c in columns] for row in rows]

    def pandas(self) -> Any:
        """Returns the table as a pandas data frame, with units in `attrs["units"]`."""
        import pandas
        frame = pandas.DataFrame(list(self), columns=self.columns)
        frame.attrs["units"] = self.units
        return frame

    def write(self, path: StrPath) -> None:
        """Writes the table as CSV, with the bytes of table.csv of `keyblock sweep`; an existing file is replaced.

        Raises TypeError for values of functions that are no numbers, text, lists or dicts.
        """
        cells = list(self._texts(self, _cell))  # before the file is opened: TypeError for values that have no text
        with open(path, "w", newline="", encoding="utf-8") as file:
            out = csv.writer(file, lineterminator="\n")
            out.writerow(self.columns)
            out.writerows(cells)

    def _repr_html_(self) -> str:
        cells = self._texts(self, _short)
        rows = ["<tr>" + "".join(f"<td>{html.escape(c)}</td>" for c in row) + "</tr>" for row in cells]
        heading = "".join(f"<th>{html.escape(c)}</th>" for c in self.columns)
        return f"<table><tr>{heading}</tr>{''.join(rows)}</table>"

    def __repr__(self) -> str:
        rows = self._texts(self[:20], _short)
        widths = [max(len(t) for t in column) for column in zip(self.columns, *rows)]
        lines = ["  ".join(t.rjust(w) for t, w in zip(row, widths)) for row in [self.columns, *rows]]
        return "\n".join(lines + ([f"… {len(self)} rows"] if len(self) > 20 else []))


def _union(rows: Iterable[Mapping[str, Any]]) -> dict[str, None]:
    """Keys of all rows, in the order in which they first appear."""
    return dict.fromkeys(key for row in rows for key in row)


def _short(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def _cell(value: Any) -> str:
    """The fewest digits that read back the same, without a point behind whole numbers."""
    if value is None or isinstance(value, float) and not np.isfinite(value):
        return ""
    if isinstance(value, str):
        return value
    if isinstance(value, float):
        text = repr(value)
        return text[:-2] if text.endswith(".0") else text
    try:
        return json.dumps(value, separators=(",", ":"), ensure_ascii=False)
    except (TypeError, ValueError):
        raise TypeError(f"out: expected numbers, text, lists or dicts, found {type(value).__name__}") from None


def grid(over: Mapping[str, Iterable[Any]]) -> list[dict[str, Any]]:
    """Returns all combinations of values: a list of dicts. over: dict of keys and lists; the last key varies fastest."""
    for key, values in over.items():
        if isinstance(values, str) or not isinstance(values, Iterable):
            raise ValueError(f"over: expected a list of values for {key}, such as [10, 15, 20], found {values!r}")
    lists = [v if isinstance(v, (list, tuple)) else list(v) for v in over.values()]
    return [dict(zip(over, map(_plain, values))) for values in itertools.product(*lists)]


class Distribution:
    """A distribution of a key, or values that are each as likely; `unit` belongs to the numbers."""

    def __init__(self, words: str, values: Sequence[Any] = ()) -> None:
        self.words = words
        self.values = tuple(values)

    def __repr__(self) -> str:
        return f"<Distribution {self.words or self.values}>"


def _law(name: str, numbers: Iterable[float], unit: str) -> Distribution:
    numbers = list(numbers)
    if not all(map(math.isfinite, numbers)):
        raise ValueError(f"{name}: expected finite numbers, found {', '.join(map(str, numbers))}")
    return Distribution(f"{name}({','.join(repr(float(n)) for n in numbers)}) {unit}".strip())


def _check_deviation(deviation: float) -> None:
    if not (math.isfinite(deviation) and deviation > 0):
        raise ValueError(f"deviation: expected a number above 0, found {deviation}")


def uniform(low: float, high: float, unit: str = "") -> Distribution:
    """Uniform distribution between two bounds. Raises ValueError unless low < high."""
    if not low < high:
        raise ValueError(f"low: expected a number below high, found {low} and {high}")
    return _law("uniform", (low, high), unit)


def triangular(low: float, mode: float, high: float, unit: str = "") -> Distribution:
    """Triangular distribution between two bounds, densest at the mode. Raises ValueError unless the mode is within."""
    if not (low <= mode <= high and low < high):
        raise ValueError(f"mode: expected a number from low to high, found {low}, {mode} and {high}")
    return _law("triangular", (low, mode, high), unit)


def normal(mean: float, deviation: float, low: float | None = None, high: float | None = None,
           unit: str = "") -> Distribution:
    """Normal distribution, truncated below `low` and above `high`: no value lies outside.

    A fraction p of a row is scaled to the probabilities of the bounds, and then inverted. Raises ValueError for a
    deviation of 0, and unless low < high.
    """
    _check_deviation(deviation)
    if low is not None and high is not None and not low < high:
        raise ValueError(f"low: expected a number below high, found {low} and {high}")
    if low is None and high is None:
        return _law("normal", (mean, deviation), unit)
    return _law("normal", (mean, deviation, -1e300 if low is None else low, 1e300 if high is None else high), unit)


def lognormal(mean: float, deviation: float, unit: str = "") -> Distribution:
    """Lognormal distribution with this mean and standard deviation of the value itself. Both are above 0."""
    _check_deviation(deviation)
    if not (math.isfinite(mean) and mean > 0):
        raise ValueError(f"mean: expected a number above 0, found {mean}")
    return _law("lognormal", (mean, deviation), unit)


def choice(*values: Any) -> Distribution:
    """One of some values, each as likely. Raises ValueError without a value."""
    if not values:
        raise ValueError("choice: expected at least one value, found none")
    return Distribution("", values)


def random(over: Mapping[str, Distribution | Iterable[Any]], count: int, seed: int = 1) -> list[dict[str, Any]]:
    """Returns a Latin hypercube of `count` rows: a list of dicts. over: dict of keys and distributions, or lists.

    Each distribution is cut into `count` parts of equal probability, and each part is used once. The same seed gives the
    same rows, which are those of `keyblock sweep --random`. Raises ValueError for a number below 0, and for a key without
    values.
    """
    count, seed = checked("count", count, is_whole=True), checked("seed", seed, is_whole=True)
    words, values = [], {}
    for i, (key, law) in enumerate(over.items()):
        if isinstance(law, Distribution) and law.words:
            words.append(f"{i}={law.words}")
            continue
        values[str(i)] = list(map(_plain, law.values if isinstance(law, Distribution) else law))
        if not values[str(i)]:
            raise ValueError(f"over: expected at least one value of {key}, found none")
        words.append(f"{i}=" + ",".join(map(str, range(len(values[str(i)])))))
    rows = json.loads(_keyblock.random_rows(words, count, seed))
    return [{key: values[str(i)][row[str(i)]] if str(i) in values else row[str(i)] for i, key in enumerate(over)}
            for row in rows]


_OUTPUTS: dict[str, Callable[[Run], Any]] = {
    "displacement": lambda run: run.outcome.displacement,
    "speed": lambda run: run.outcome.speed,
    "steps": lambda run: run.outcome.steps,
    "time": lambda run: run.outcome.time,
    "blocks": lambda run: run.plan.blocks,
}
_FACTORS = {"fos": "", "fos_joints": "joints", "fos_rock": "rock", "fos_both": "both"}


_RESERVED = ("verdict", "doubt", "warnings", "seconds", "job")


def _check_names(inputs: Iterable[str], outputs: Iterable[str]) -> None:
    """Refuses a column that would hide another one."""
    for role, names in (("over", inputs), ("out", outputs)):
        for name in names:
            if name in _RESERVED:
                raise ValueError(f"{role}: expected another name than {', '.join(_RESERVED)}, found {name}")
            if role == "out" and name in inputs:
                raise ValueError(f"out: expected names that over does not have, found {name}")


def _check_outputs(out: Iterable[str], histories: Iterable[str]) -> None:
    """Refuses numbers of measured points that no case has, such as point0.dx and point².dx."""
    for name in out:
        followed = name.partition(".")[0]
        number = followed[len("point"):] if followed.startswith("point") and followed not in histories else ""
        if number.isdigit() and not (number.isascii() and int(number) > 0):
            raise ValueError(f"out: expected the number of a measured point, from 1, found {name}")


def _row(case: Any, values: dict[str, Any], out: Any, profile: str | None, settings: Any,
         history: Iterable[str]) -> dict[str, Any]:
    """Verdict, doubt and outputs of one row of a function: the work of a child."""
    keys = {k: v for k, v in values.items() if k.startswith("/")}
    names = {k: v for k, v in values.items() if not k.startswith("/")}
    if isinstance(case, Case):
        settings = dict(settings or {}, **names)
    else:
        case = case(**names)
    case = case.with_values(keys)
    row: dict[str, Any] = {"verdict": "", "doubt": "", "warnings": ""}
    if callable(out) or any(name in _OUTPUTS for name in out):
        run = Run(case, profile, settings, history=history)
        outcome = run.go_on()
        row["verdict"] = outcome.end
        row["doubt"] = outcome.reason or (outcome.doubts[0].sentence if outcome.doubts else "")
        _add_warnings(row, outcome.warnings)
        if callable(out):
            result = out(run)
            found = _plain_output(result if isinstance(result, dict) else {"out": result})
            _check_names(list(values), found)
            row.update(found)
            return row
    for name in out:
        if name in _OUTPUTS:
            row[name] = _OUTPUTS[name](run)
            continue
        try:
            found = factor_of_safety(case, _FACTORS[name], profile=profile, settings=settings)
        except _keyblock.Error as error:  # such as fos_rock of a case whose rock has no strength: other outputs stay
            row.update({"verdict": "error", "doubt": str(error), name: float("nan")})
            continue
        _add_warnings(row, found.warnings)
        if found.end != "bracketed" and row["verdict"] in ("", "finished"):  # the number beside it is no factor
            row.update({"verdict": found.end, "doubt": _last_trial(found)})
        row["verdict"] = row["verdict"] or "finished"
        row[name] = found.stands if found.stands is not None else float("nan")
    return row


def _add_warnings(row: dict[str, Any], warnings: Iterable[_keyblock.Warning]) -> None:
    """Adds the codes of warnings that the row does not have yet, as the program does."""
    codes = row["warnings"].split() + [w.code for w in warnings if w.level == "warning"]
    row["warnings"] = " ".join(dict.fromkeys(codes))


def _last_trial(found: Strength) -> str:
    """Factor, verdict and reason of the last trial, in the words of the program."""
    if not found.trials:
        return ""
    last = found.trials[-1]
    return f"F = {last.factor:.6g}: {last.verdict}{last.why and ': ' + last.why}"


def _plain_dict(values: Mapping[str, Any]) -> dict[str, Any]:
    return {k: _plain(v) for k, v in values.items()}


def _plain_output(value: Any) -> Any:
    """Numbers of any type as int or float, also within lists and dicts; other values as they are."""
    value = _plain(value)
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, Mapping):
        return {k: _plain_output(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain_output(v) for v in value]
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        return value


def sweep(case: Case | StrPath | Callable[..., Case], over: Mapping[str, Iterable[Any]] | Iterable[Mapping[str, Any]],
          out: str | Iterable[str] | Callable[[Run], Any] = ("displacement",), jobs: int = 2,
          time_limit: float | None = None, memory_limit: int | None = None, profile: str | None = None,
          settings: Mapping[str, Any] | None = None, folder: StrPath | None = None, shard: str | None = None,
          history: str | Iterable[str] = (), client: Any = None, joints: Mapping[str, Any] | StrPath | None = None) -> Table:
    """Runs a case under many values and returns a Table, one row per run in the order of `over`.

    case: a Case, a path, or a function that takes values by name and returns a Case, such as one that draws joints from a
    seed. over: a dict of lists (all combinations), a list of dicts, such as `random` returns, or a DataFrame of pandas. A
    key that begins with / is a pointer into the case file, as `Case.with_value` has it; another key is a setting, or an
    argument of the function. The dicts of a list may have different keys; columns are those of all. verdict, doubt, seconds
    and job are no keys.
    out: names as those of `keyblock sweep --out` (displacement, fos, point1.dx, crest.vx, ledger.kinetic, …), or a function
    of the finished Run that returns a number or a dict. joints: statistics of joints, drawn anew for each row; a dict as
    docs/slope.json, or the path of one. A key that begins with joints:/ is a pointer into them: "joints:/seed".

    Each run is a child process with one thread. One that crashes, is killed, or exceeds its time or memory is one row with
    its verdict: signal, time_limit, memory_limit or error; the doubt gives the reason. If `out` has names and `case` is no
    function, the program `keyblock sweep` does the work, and the table is that of the command. history: quantities to
    follow, for `out`. profile: of all columns; None takes what the files request, for old files legacy for results of
    runs and standard for factors of safety.

    folder: keeps the results of rows as they end; a second call with the same arguments computes the missing rows alone.
    A folder refuses rows of another case, settings or outputs, and of another version of the library. With functions it
    also refuses those of another build or function, and a longer time limit computes rows anew that failed by a shorter
    one. Functions are compared by name, code, defaults, enclosed values and the object of a method, but not by functions
    and variables of their module that they use.
    shard: "k/n" computes a part of the rows and returns these alone; a call with all folders' journals in one folder and no
    shard returns the whole table. client: a client of Dask; its workers start the child processes. They must see `folder`.
    """
    if not callable(case) and not isinstance(case, Case):
        case = read(case)
    pool = Pool(jobs, time_limit, memory_limit)  # checks them
    if hasattr(over, "to_dict"):
        over = over.to_dict("records")
    rows = grid(over) if isinstance(over, Mapping) else [_plain_dict(r) for r in over]
    keys = list(_union(rows))
    if not keys:
        raise ValueError(f"over: expected at least one row with a key, found {over!r}")
    _check_names(keys, ())
    history = texts(history)
    if not callable(out):
        out = (out,) if isinstance(out, str) else tuple(out)
        _check_names(keys, out)
        _check_outputs(out, [h.partition("=")[0] for h in history])
    if isinstance(case, Case) and not callable(out):
        if time_limit is not None and time_limit < 1:
            raise ValueError(f"time_limit: expected at least 1 s for outputs by name, found {time_limit}")
        rows = [{key: row.get(key) for key in keys} for row in rows]  # None leaves a key as it is
        return _by_program(case, rows, out, pool.jobs, time_limit, memory_limit, profile, settings, folder, shard, history,
                           client, joints)
    if joints is not None:
        raise ValueError("joints: expected a case and outputs by name, found a function")
    if not callable(out) and not set(out) <= {*_OUTPUTS, *_FACTORS}:
        raise ValueError(f"out: expected some of {', '.join([*_OUTPUTS, *_FACTORS])}, found {', '.join(out)}")
    return _by_functions(case, rows, out, pool, profile, settings, folder, shard, client, history)


def _by_program(case: Case, rows: list[dict[str, Any]], out: tuple[str, ...], jobs: int, time_limit: float | None,
                memory_limit: int | None, profile: str | None, settings: Any, folder: StrPath | None, shard: str | None,
                history: list[str], client: Any, joints: Mapping[str, Any] | StrPath | None) -> Table:
    for key, value in ((k, v) for row in rows for k, v in row.items()):
        if isinstance(value, float) and not math.isfinite(value):
            raise ValueError(f"over: expected finite numbers, found {value} for {key}")
    case._require_files()
    require_unchanged(case._checksums, checksums_of(case._read))  # the program reads the files again
    texts = {"design.json": json.dumps(rows)}
    if isinstance(joints, Mapping):
        texts["joints.json"] = json.dumps(joints)
    statistics = _OWN + "joints.json" if isinstance(joints, Mapping) else None if joints is None else os.path.abspath(joints)
    pairs = [f"{name}={value}" for name, value in setting_pairs(settings)]
    values = [f"{pointer.replace('=', '~2')}={json.dumps(value)}" for pointer, value in case._values]
    with tempfile.TemporaryDirectory(prefix="keyblock_") as own:
        to = os.path.abspath(folder or os.path.join(own, "sweep"))
        command = ["sweep", *case._read, *_program._options(
            design=_OWN + "design.json", out=",".join(out), profile=profile, set=pairs, at=values, history=history,
            time_limit=None if time_limit is None else math.ceil(time_limit), memory_limit=memory_limit,
            joints=statistics, **case._drawing), "-o", to, "--resume", "--json"]
        if client is not None:
            _on_workers(client, texts, command, len(rows))
        text = _with_files(texts, [*command, *_program._options(jobs=jobs, shard=shard, merge=client is not None)],
                           None if folder is None else to)
    require_unchanged(case._checksums, checksums_of(case._read))
    found = json.loads(text)
    return Table([{k: float("nan") if v is None else v for k, v in row.items()} for row in found["rows"]],
                 found["seconds"], found["units"])


_OWN = "/keyblock-files-of-this-call/"  # stands for a folder that each process makes, or that of the results


def _with_files(texts: Mapping[str, str], command: Iterable[str], folder: StrPath | None = None) -> str:
    """Output of the program, whose command may name files with these texts. They stay in `folder`, unless it refuses them."""
    with tempfile.TemporaryDirectory(prefix="keyblock_") as temporary:
        own = Path(folder or temporary)
        before = {name: (own / name).read_bytes() for name in texts if (own / name).is_file()}
        try:
            own.mkdir(parents=True, exist_ok=True)
            for name, text in texts.items():
                _replace(own / name, text.encode())
        except OSError as error:
            raise _keyblock.Error(f"cannot write {error.filename}: {error.strerror}") from error
        try:
            return _program._run([word.replace(_OWN, f"{own}{os.sep}") for word in map(str, command)], (0, 1), lacks=["force"])
        except _program.ProgramError:
            for name in texts:
                if name in before:
                    _replace(own / name, before[name])
                else:
                    (own / name).unlink()
            raise


def _replace(path: Path, content: bytes) -> None:
    """Writes a file at once: another process may read it."""
    new = path.with_name(f"{path.name}.{os.getpid()}")
    new.write_bytes(content)
    os.replace(new, path)


def _on_workers(client: Any, texts: Mapping[str, str], command: list[str], rows: int) -> None:
    """Runs the shards of a sweep as tasks of Dask; each starts the program."""
    threads = sum(client.nthreads().values()) or 1
    count = max(1, min(rows, 4 * threads))
    tasks = [client.submit(_shard, _program.program(), texts, [*command, "--jobs", "1", "--shard", f"{k}/{count}"], pure=False)
             for k in range(1, count + 1)]
    client.gather(tasks)


def _shard(program: str, texts: Mapping[str, str], command: list[str]) -> None:
    os.environ["KEYBLOCK_PROGRAM"] = program
    _with_files(texts, command)


def _by_functions(case: Any, rows: list[dict[str, Any]], out: Any, pool: Pool, profile: str | None, settings: Any,
                  folder: StrPath | None, shard: str | None, client: Any, history: list[str]) -> Table:
    task: list[Any] = []
    if folder is not None:
        task = [_identity("case", case), _identity("out", out) if callable(out) else out, profile,
                setting_pairs(settings), _files_named_in(dict(settings or {}), [""]), history]
    journal = _Journal(folder, shard, task)
    names = [_name_of(row, _files_of_row(row, case)) for row in rows]
    wanted = [i for i, row in enumerate(rows) if _is_of_shard(_name_of(row), shard)]
    longest = math.inf if pool.time_limit is None else pool.time_limit
    missing = [i for i in wanted if _is_missing(journal.done.get(names[i]), longest)]

    def work(i: int) -> tuple[dict[str, Any], float]:
        began = time.perf_counter()
        return _row(case, rows[i], out, profile, settings, history), round(time.perf_counter() - began, 3)

    with pool:
        for at, result in pool.unordered(work, missing) if client is None else _by_client(client, pool, work, missing):
            if isinstance(result, Failed):
                seconds = longest if result.reason == "time_limit" else float("nan")
                result = ({"verdict": result.reason, "doubt": result.message, "warnings": ""}, seconds)
            journal.add(names[missing[at]], result)
    done = [journal.done[names[i]] for i in wanted]
    columns: dict[str, None] = dict.fromkeys(["verdict", "doubt", "warnings"])
    columns.update(dict.fromkeys([] if callable(out) else out))
    for result, _ in done:
        columns.update(dict.fromkeys(result))
    keys = _union(rows)
    whole: list[dict[str, Any]] = []
    for i, (result, _) in zip(wanted, done):
        row = {key: rows[i].get(key, float("nan")) for key in keys}
        whole.append({**row, **{c: result.get(c, float("nan")) for c in columns}})
    return Table(whole, [seconds for _, seconds in done])


def _by_client(client: Any, pool: Pool, work: Callable[[int], Any], missing: list[int]) -> Iterable[tuple[int, Any]]:
    """Yields (place, result) as tasks of Dask end; each starts a child process."""
    from distributed import as_completed  # type: ignore[import]
    tasks = {client.submit(_in_child, work, i, pool.time_limit, pool.memory_limit, pure=False): at
             for at, i in enumerate(missing)}
    for task in as_completed(list(tasks)):
        yield tasks[task], task.result()


def _in_child(work: Callable[[int], Any], i: int, time_limit: float | None, memory_limit: int | None) -> Any:
    with Pool(1, time_limit, memory_limit) as pool:
        return next(iter(pool.unordered(work, [i])))[1]


def _name_of(row: Mapping[str, Any], files: Sequence[str] = ()) -> str:
    """Name of a row. files: checksums of those that it names."""
    text = json.dumps([row, files] if files else row, default=str)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def _is_of_shard(name: str, shard: str | None) -> bool:
    if shard is None:
        return True
    k, _, n = shard.partition("/")
    if not (k.isdigit() and n.isdigit() and 1 <= int(k) <= int(n)):
        raise ValueError(f"shard: expected k/n with k from 1 to n, found {shard}")
    return int(name, 16) % int(n) + 1 == int(k)


class _Journal:
    """Rows that are done, also in files: their first line identifies the sweep, each further line is a row."""

    def __init__(self, folder: StrPath | None, shard: str | None, task: Any) -> None:
        self.done: dict[str, Any] = {}
        self.heading = {"sweep": hashlib.sha256(json.dumps(task, default=str).encode()).hexdigest(),
                        "library": f"{_keyblock.version()} {_keyblock.build()}"}
        self.path = ""
        if folder is None:
            return
        os.makedirs(folder, exist_ok=True)
        name = "journal.jsonl" if shard is None else f"journal-{shard.replace('/', '-of-')}.jsonl"
        self.path = os.path.join(folder, name)
        for file in sorted(os.listdir(folder)):
            if file.startswith("journal") and file.endswith(".jsonl"):
                self._read(os.path.join(folder, file))
        if not os.path.exists(self.path) or not os.path.getsize(self.path):
            self._append(json.dumps(self.heading))

    def _read(self, path: str) -> None:
        with open(path, "rb") as file:
            *lines, rest = file.read().split(b"\n")  # a kill leaves a part of the last line
        if not lines and not json.dumps(self.heading).encode().startswith(rest):
            raise _keyblock.Error(f"{path}:1: error: expected the first line of this sweep, found another text")
        for number, line in enumerate(lines, 1):
            try:
                entry = json.loads(line)
            except (ValueError, RecursionError):
                entry = None
            if number == 1:
                self._check_heading(path, entry)
            elif _is_entry(entry):
                if _is_missing(self.done.get(entry[0]), math.inf):
                    self.done[entry[0]] = entry[1]
            else:
                raise _keyblock.Error(f"{path}:{number}: error: expected a row of a sweep, found another text")
        if rest and path == self.path:
            os.truncate(path, os.path.getsize(path) - len(rest))

    def _check_heading(self, path: str, found: Any) -> None:
        if not isinstance(found, dict) or "sweep" not in found:
            raise _keyblock.Error(f"{path}:1: error: expected the first line of a sweep, found another text")
        if found["sweep"] != self.heading["sweep"]:
            raise _keyblock.Error(f"{path}: error: the file belongs to another sweep: its case, outputs, profile, settings "
                                  "or functions differ")
        if found != self.heading:
            raise _keyblock.Error(f"{path}: error: expected rows of the library {self.heading['library']}, found rows of "
                                  f"{found.get('library', 'an older one')}")

    def add(self, name: str, row: Any) -> None:
        if self.path:
            try:
                text = json.dumps([name, row])
            except (TypeError, ValueError) as error:
                doubt = f"out: expected numbers, text, lists or dicts: {error}"
                row = ({"verdict": "error", "doubt": doubt, "warnings": ""}, row[1])
                text = json.dumps([name, row])
            self._append(text)
            row = json.loads(text)[1]  # as a later call reads it
        self.done[name] = row

    def _append(self, line: str) -> None:
        with open(self.path, "a", encoding="utf-8") as file:
            file.write(line + "\n")


def _is_missing(row: Any, longest: float) -> bool:
    """True if there is no row, or one that failed by a shorter time limit."""
    return row is None or row[0].get("verdict") == "time_limit" and row[1] < longest


def _is_entry(entry: Any) -> bool:
    """True for [name, [outputs, seconds]]."""
    if not isinstance(entry, list) or len(entry) != 2 or not isinstance(entry[0], str) or not isinstance(entry[1], list):
        return False
    return len(entry[1]) == 2 and isinstance(entry[1][0], dict) and isinstance(entry[1][1], (int, float))


def _identity(role: str, value: Any) -> Any:
    """Identifies a case or a function in a journal. Raises ValueError for a value without a content that can be compared."""
    if not isinstance(value, (Case, functools.partial)) and not hasattr(value, "__code__"):
        raise ValueError(f"{role}: expected a function of Python, whose code identifies it in `folder`, found {value!r}")
    try:
        return _mark(value, ())
    except (TypeError, pickle.PicklingError) as error:
        raise ValueError(f"{role}: expected a function whose enclosed values can be pickled, for their content "
                         f"identifies it in `folder`; {error}") from error


def _mark(value: Any, within: tuple[int, ...]) -> Any:
    """Describes a value by its content. Raises TypeError if it has none that can be compared, such as a lock."""
    value = _plain(value)
    if id(value) in within:  # encloses itself
        return "again"
    within = (*within, id(value))
    if value is None or isinstance(value, (bool, int, float, complex, str, bytes)):
        return repr(value)
    if isinstance(value, Case):
        content: Any = [*value._checksums.values()] or value.json()
        return [content, value._drawing, value._values, _files_named_in(_contents_of(value), _folders_of(value))]
    if isinstance(value, types.CodeType):
        return [value.co_code.hex(), value.co_names, [_mark(v, within) for v in value.co_consts]]
    if isinstance(value, types.MethodType):
        return [_mark(v, within) for v in (value.__self__, value.__func__)]
    if hasattr(value, "__code__"):
        cells = [_content(cell) for cell in value.__closure__ or ()]
        parts = [_mark(v, within) for v in (value.__code__, value.__defaults__, value.__kwdefaults__, cells)]
        return [value.__module__, value.__qualname__, *parts]
    if isinstance(value, (type, types.ModuleType)):
        return [getattr(value, "__module__", ""), getattr(value, "__qualname__", value.__name__)]
    if type(value) in (list, tuple):
        return [_mark(v, within) for v in value]
    if type(value) in (set, frozenset):
        return sorted(json.dumps(_mark(v, within)) for v in value)
    if type(value) is dict:
        return [[_mark(k, within), _mark(v, within)] for k, v in value.items()]
    reduced = copyreg.dispatch_table.get(type(value), lambda v: v.__reduce_ex__(2))(value)  # as `pickle` does
    parts = reduced if isinstance(reduced, tuple) else (reduced,)
    return [_mark(list(part) if isinstance(part, Iterator) else part, within) for part in parts]


def _contents_of(case: Case) -> Iterator[Any]:
    """Content of a case file, and of the case.json of its folder."""
    yield json.loads(case.json())
    for file in case._checksums:
        if os.path.basename(file) == "case.json" and os.path.isfile(file):
            with open(file, encoding="utf-8") as text:
                yield json.load(text)


def _files_of_row(row: Mapping[str, Any], case: Any) -> list[str]:
    """Checksums of the files that a row names: a pointer from the folders of the case, a setting from the current one."""
    folders = _folders_of(case) if isinstance(case, Case) else []
    return [found for key, value in row.items()
            for found in _files_named_in({key: value}, folders if key.startswith("/") else [""])]


def _folders_of(case: Case) -> list[str]:
    return list(dict.fromkeys(map(os.path.dirname, case._checksums)))


def _files_named_in(value: Any, folders: Sequence[str]) -> list[str]:
    """Checksums of the files that settings within a value name, from any of the folders."""
    if not isinstance(value, Mapping):
        parts = value if isinstance(value, Iterable) and not isinstance(value, (str, bytes)) else ()
        return [found for part in parts for found in _files_named_in(part, folders)]
    found = []
    for key, part in value.items():
        if str(key).rpartition("/")[2] != "body_acceleration_file":
            found += _files_named_in(part, folders)
        elif part:
            found += list(checksums_of([os.path.join(folder, str(part)) for folder in folders]).values())
    return found


def _content(cell: types.CellType) -> Any:
    try:
        return cell.cell_contents
    except ValueError:  # empty
        return None
