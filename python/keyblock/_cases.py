"""Cases, plans and contexts.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import atexit
import ctypes
import hashlib
import json
import math
import os
import signal
import sys
import threading
import time
import weakref
from pathlib import Path
from typing import Any, Iterable, Mapping, Sequence, Union

from . import _keyblock

StrPath = Union[str, "os.PathLike[str]"]
_threads = 0  # of a context that does not say; children of a pool set 1


_libc = ctypes.CDLL(None)  # loaded before any fork


def end_with_parent(parent: int, is_of_main_thread: bool = True) -> None:
    """In a new child: it ends if its parent dies.

    The system kills a child at the end of the thread that began it. The child of a thread that may end before its parent
    looks after the parent itself.
    """
    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(0.2)
        os._exit(1)
    if is_of_main_thread:
        try:
            _libc.prctl(1, signal.SIGKILL)
        except AttributeError:
            pass
        if os.getppid() != parent:  # it died before
            os._exit(1)
    else:
        threading.Thread(target=watch, daemon=True).start()


def checked(name: str, value: Any, is_whole: bool = False) -> Any:
    """Returns a number that is finite and at least 0, or None. Raises ValueError."""
    if value is not None and not (math.isfinite(value) and value >= 0 and (not is_whole or value == int(value))):
        raise ValueError(f"{name}: expected a {'whole' if is_whole else 'finite'} number of at least 0, found {value}")
    return int(value) if is_whole and value is not None else value


def texts(given: str | Iterable[str]) -> list[str]:
    """Returns the histories as a list of texts; one text is a list of one. Raises TypeError."""
    wrong = "history: expected a text, such as 'block:4', or a list of texts, found {!r}"
    if isinstance(given, str):
        return [given]
    if not isinstance(given, Iterable):
        raise TypeError(wrong.format(given))
    found = list(given)
    for one in found:
        if not isinstance(one, str):
            raise TypeError(wrong.format(one))
    return found


def called(name: str, given: Any) -> Any:
    """Returns a function, or None. Raises TypeError."""
    if given is not None and not callable(given):
        raise TypeError(f"{name}: expected a function, found {given!r}")
    return given


def encoded(path: StrPath) -> bytes:
    """Name of a file for the library and the program, in UTF-8. Other bytes of a name stay."""
    return os.fspath(path).encode("utf-8", "surrogateescape")


class Context(_keyblock.Context):
    """Stops a computation and limits its threads and its time.

    threads: threads of a step, at most 256; 0 means all processors. Results do not depend on it.
    time_limit: seconds until the context stops what runs under it; None means no limit. The clock starts here.
    progress: True prints the progress of long searches to standard error.

    timed_out: True if the time limit stopped it; `end` of an outcome is "stopped" then, as after `stop`.

    A context that was stopped stays stopped. The clock and the progress lines end with the context, or with the block of
    `with Context(...) as c:`.
    """

    def __init__(self, threads: int | None = None, time_limit: float | None = None, progress: bool = False) -> None:
        checked("time_limit", time_limit)
        super().__init__(_threads if threads is None else threads)
        self.timed_out = False
        self._ended = threading.Event()
        self._end = None if time_limit is None else time.monotonic() + time_limit
        if time_limit is not None or progress:
            self._begin_to_watch(progress)
            _watched.add(self)

    def _begin_to_watch(self, progress: bool = False) -> None:
        ended = self._ended = threading.Event()
        of = weakref.ref(self, lambda _: ended.set())  # the thread does not keep the context
        threading.Thread(target=_watch, args=(of, ended, self._end, progress), daemon=True).start()

    def __enter__(self) -> Context:
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()


_watched: weakref.WeakSet[Context] = weakref.WeakSet()


def _watch_in_child() -> None:
    """In a new child, which has no other threads: limits of time go on."""
    for context in list(_watched):
        if context._end is not None and not context._ended.is_set():
            context._begin_to_watch()


os.register_at_fork(after_in_child=_watch_in_child)


def _watch(of: weakref.ref[Context], ended: threading.Event, end: float | None, progress: bool) -> None:
    """Stops a context at its limit; ends with the context."""
    printed = ""
    longest = 1.0 if progress else threading.TIMEOUT_MAX
    while not ended.wait(min(longest, threading.TIMEOUT_MAX if end is None else max(0.0, end - time.monotonic()))):
        context = of()
        if context is None:
            return
        if end is not None and time.monotonic() >= end:
            context.timed_out = True
            context.stop()
            return
        what, share = context.headway
        del context
        line = f"{what}: {share:.0%}" if share else what
        if progress and what and line != printed:
            print(line, file=sys.stderr, flush=True)
            printed = line


class Case:
    """Content of case files. Nothing changes it; `with_value` returns another case."""

    def __init__(self, case: _keyblock.Case, files: Iterable[str] = (), drawing: Mapping[str, Any] | None = None,
                 values: Iterable[tuple[str, Any]] = (), checksums: Mapping[str, str] | None = None) -> None:
        self._case = case
        self._read = tuple(files)        # paths
        self._drawing = dict(drawing or {})  # unit, join
        self._values = tuple(values)     # changed after reading
        self._checksums = dict(checksums or {})  # of each file

    def __reduce__(self) -> Any:
        self._require_files()
        return _read_again, (self._read, self._drawing, self._values, self._checksums)

    def _require_files(self) -> None:
        """Raises Error for a case that cannot be read again."""
        if not self._read:
            raise _keyblock.Error("expected a case whose files are known, found that of an interrupted run without run.json; "
                                  "read its files")

    @property
    def warnings(self) -> list[_keyblock.Warning]:
        """Warnings of reading: list of `Warning`."""
        return list(self._case.warnings)

    @property
    def units(self) -> tuple[str, ...]:
        """Names of the units of length, mass and time; each empty if the case does not declare it."""
        return tuple(self._case.units)

    @property
    def dialect(self) -> str:
        """Program of the original files: berkeley, shi, ddaml or manifold; empty for a case of Keyblock's own."""
        try:
            return str(self.get("/analysis/dialect"))
        except _keyblock.SettingError:
            return ""

    @property
    def profile(self) -> str:
        """Profile of a `Run` that names none. Studies take another one for old files: see `factor_of_safety`."""
        return self._case.profile

    @property
    def files(self) -> tuple[str, ...]:
        """Files of the case; empty if its content was changed."""
        return () if self._values else self._read

    def json(self) -> str:
        """Returns the text of the case as a case file of Keyblock."""
        return self._case.json()

    def get(self, pointer: str = "") -> Any:
        """Returns a value of the case file by its JSON pointer, such as /analysis/joint_materials/0/friction_angle_deg.

        A name may stand for the index of a list item: /analysis/joint_materials/bedding/friction_angle_deg. `*` stands for
        all items; the result is then a list. Raises SettingError if the case has no such value.
        """
        return json.loads(self._case.get(pointer))

    def with_value(self, pointer: str, value: Any) -> Case:
        """Returns the same case with another value at this pointer, or at all pointers that `*` stands for.

        A value is a number, a bool, a list, a dict, or a text with a unit ("50 kN") where the case file permits units. A
        key may be new in its object. Raises SettingError for a pointer to nothing, InputError for a key or a value that the
        file must not have.
        """
        value = _plain(value)
        changed = self._case.with_json(pointer, json.dumps(value))
        return Case(changed, self._read, self._drawing, (*self._values, (pointer, value)), self._checksums)

    def with_values(self, values: Mapping[str, Any]) -> Case:
        """Returns the same case with several values: a dict of pointers and values."""
        case = self
        for pointer, value in values.items():
            case = case.with_value(pointer, value)
        return case

    def pointers(self, pointer: str) -> list[str]:
        """Returns the JSON pointers that a pointer with names and `*` stands for. Raises SettingError if there are none."""
        return self._case.pointers(pointer)

    def write(self, path: StrPath, format: str = "keyblock-case") -> list[str]:
        """Writes the case in a format of `keyblock convert --to`; an existing file is an error.

        Returns sentences: content that the format cannot hold, content that is added, other rules of a run.
        """
        return self._case.write(encoded(path), format)

    def __repr__(self) -> str:
        names = ", ".join(Path(f).name for f in self._read) or "of an interrupted run"
        return f"<Case {names}{' with changed values' if self._values else ''}>"


def read(*paths: StrPath | Sequence[StrPath], layers: StrPath | None = None, unit: str | None = None,
         join: float | None = None) -> Case:
    """Reads the files of a case in any order, or its folder; also a list of files, such as one of `cases`.

    layers: table of the layers of a DXF drawing. unit: unit of length of a DXF drawing, instead of its own: in, ft, mm,
    cm, m, km, yd or dm. join: ends of lines nearer than this to a line are joined to it [unit of the drawing].
    Raises InputError with file, line and column, and SettingError for another unit, or a distance below 0.
    """
    given = [file for p in paths for file in (p if isinstance(p, (list, tuple)) else (p,))]
    files = [os.fspath(p) for p in (*given, *(() if layers is None else (layers,)))]
    return _read_again(files, {k: v for k, v in (("unit", unit), ("join", join)) if v is not None})


def _read_again(files: Sequence[str], drawing: Mapping[str, Any], values: Iterable[tuple[str, Any]] = (),
                checksums: Mapping[str, str] | None = None) -> Case:
    """Returns a case. checksums: those of an earlier reading, which must be the same."""
    paths = [os.path.abspath(f) for f in files]
    found = checksums_of(paths)  # before reading: a later change is seen
    require_unchanged(found if checksums is None else checksums, found)
    case = Case(_keyblock.Case.read([encoded(f) for f in files], drawing.get("unit", ""), drawing.get("join", 0.0)),
                paths, drawing, checksums=found)
    for pointer, value in values:
        case = case.with_value(pointer, value)
    return case


def checksums_of(paths: Iterable[str]) -> dict[str, str]:
    """SHA-256 of each file of a case. A folder has those that are named after it, and its case.json."""
    files = []
    for path in paths:
        if os.path.isdir(path):
            files += [os.path.join(folder, name) for folder, _, names in sorted(os.walk(path)) for name in sorted(names)
                      if name == "case.json" or Path(name).stem == Path(folder).name]
        else:
            files += [path + ending for ending in ("", ".json", ".yaml") if os.path.isfile(path + ending)][:1]
    return {file: hashlib.sha256(Path(file).read_bytes()).hexdigest() for file in files}


def require_unchanged(expected: Mapping[str, str], found: Mapping[str, str]) -> None:
    """Raises Error if files of a case have other content than when they were read."""
    for file in {**expected, **found}:
        if expected.get(file) != found.get(file):
            raise _keyblock.Error(f"{file} has changed since the case was read; read the case again")


class Plan:
    """A case made ready for its first step. Many runs may share it.

    profile: legacy, draft, standard or reference; None takes what the files request.
    settings: a dict, as `--set` of the program: {"time_step": "2 ms", "steps": 500}. True and False mean on and off.
    history: quantities that a run keeps in memory, such as "crest=point:12,20": a text or a list. Raises InputError,
    SettingError, Stopped.
    """

    def __init__(self, case: Case | StrPath, profile: str | None = None, settings: Mapping[str, Any] | None = None,
                 context: _keyblock.Context | None = None, history: str | Iterable[str] = ()) -> None:
        self._case = case if isinstance(case, Case) else read(case)
        self._choices = (profile or "", setting_pairs(settings))
        self._history = texts(history)
        self._plan = _keyblock.Plan(self._case._case, *self._choices, self._history, context or Context())

    @property
    def case(self) -> Case:
        """Case of the plan."""
        return self._case

    @property
    def profile(self) -> str:
        """Profile of a run."""
        return self._plan.profile

    @property
    def why_profile(self) -> str:
        """Reason for the profile."""
        return self._plan.why_profile

    @property
    def settings(self) -> dict[str, str]:
        """All settings: dict of names and values, both text."""
        return dict(self._plan.settings)

    @property
    def warnings(self) -> list[_keyblock.Warning]:
        """Warnings of reading, cutting and preparing."""
        return list(self._plan.warnings)

    @property
    def unknowns(self) -> int:
        """Number of unknowns."""
        return self._plan.unknowns

    @property
    def blocks(self) -> int:
        """Number of blocks; elements of NMM bodies count each."""
        return self._plan.blocks

    @property
    def steps(self) -> int:
        """Number of steps, if none is cut and no stage ends early."""
        return self._plan.steps

    def __repr__(self) -> str:
        return f"<Plan {self.blocks} blocks, {self.unknowns} unknowns, {self.steps} steps, profile {self.profile}>"


def setting_pairs(settings: Mapping[str, Any] | None) -> list[tuple[str, str]]:
    """Settings as pairs of text."""
    def text(value: Any) -> str:
        value = _plain(value)
        if isinstance(value, bool):
            return "on" if value else "off"
        return os.fspath(value) if isinstance(value, (str, os.PathLike)) else repr(value)
    return [(str(name), text(value)) for name, value in (settings or {}).items()]


def _plain(value: Any) -> Any:
    """Numbers and arrays of NumPy as those of Python."""
    return value.tolist() if hasattr(value, "tolist") else value


@atexit.register
def _leave() -> None:
    """Ends the process if an interrupted computation still runs: its thread must not outlive the interpreter."""
    if _keyblock.left_behind():
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(130)
