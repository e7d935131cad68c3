"""Jobs in child processes: one job is one process, and a job that dies is one `Failed`.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import os
import pickle
import resource
import selectors
import signal
import sys
import threading
import time
import traceback
from dataclasses import dataclass
from typing import Any, Callable, Iterable, Iterator, NoReturn

from . import _cases


@dataclass(frozen=True)
class Failed:
    """Stands for the result of a job that has none.

    reason: "signal", "time_limit", "memory_limit" or "error". signal: number of the signal, or 0. message: one line.
    """

    reason: str
    signal: int = 0
    message: str = ""

    def __float__(self) -> float:
        return float("nan")

    def __bool__(self) -> bool:
        return False


def _name_of(number: int) -> str:
    """Name of a signal; those of real time have none."""
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


_starting = threading.Lock()  # a child of one thread must not inherit the write end of another: its pipe would not end


class _Job:
    def __init__(self, index: int, pid: int, pipe: int, limit: float | None) -> None:
        self.index, self.pid, self.pipe = index, pid, pipe
        self.data: list[bytes] = []
        self.code = 0
        self.end = None if limit is None else time.monotonic() + limit
        self.is_late = False

    def kill(self) -> None:
        try:
            os.kill(self.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass


class Pool:
    """Runs jobs in child processes, so that a crash ends one job and never the caller.

    jobs: child processes at a time; None or 0 means all processors. time_limit: seconds by the clock of each job.
    memory_limit: MiB of address space of each job. Steps in a child have one thread unless the job asks for more.
    """

    def __init__(self, jobs: int | None = None, time_limit: float | None = None, memory_limit: int | None = None) -> None:
        self.jobs = _cases.checked("jobs", jobs, is_whole=True) or os.cpu_count() or 1
        self.time_limit = _cases.checked("time_limit", time_limit)
        self.memory_limit = _cases.checked("memory_limit", memory_limit, is_whole=True)
        self._running: dict[int, _Job] = {}
        self._selector = selectors.DefaultSelector()

    def __enter__(self) -> Pool:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Kills the jobs that still run."""
        for job in list(self._running.values()):
            job.kill()
            self._end(job)

    def map(self, function: Callable[[Any], Any], items: Iterable[Any]) -> Iterator[Any]:
        """Yields `function(item)` for each item, in their order; `Failed` stands for a job without a result.

        The function may be any function of the caller, also a lambda or one of a notebook; its results are pickled.
        """
        ready: dict[int, Any] = {}
        wanted = 0
        for index, result in self.unordered(function, items):
            ready[index] = result
            while wanted in ready:
                yield ready.pop(wanted)
                wanted += 1

    def unordered(self, function: Callable[[Any], Any], items: Iterable[Any]) -> Iterator[tuple[int, Any]]:
        """Yields (index, result) as jobs end."""
        if self._running:
            raise RuntimeError("the pool still has jobs of another call")
        waiting = iter(enumerate(items))
        mine: set[int] = set()
        is_more = True
        try:
            while is_more or mine:
                while is_more and len(self._running) < self.jobs:
                    try:
                        index, item = next(waiting)
                    except StopIteration:
                        is_more = False
                        break
                    mine.add(self._start(index, function, item))
                for job in self._ended() if mine else ():
                    mine.discard(job.pid)
                    yield job.index, self._result(job)
        finally:
            for pid in mine & set(self._running):
                job = self._running[pid]
                job.kill()
                self._end(job)

    def _start(self, index: int, function: Callable[[Any], Any], item: Any) -> int:
        sys.stdout.flush()
        sys.stderr.flush()
        parent = os.getpid(), threading.current_thread() is threading.main_thread()
        with _starting:  # the child leaves it too
            read_end, write_end = os.pipe()
            pid = os.fork()
            if pid != 0:
                os.close(write_end)
        if pid == 0:
            os.close(read_end)
            self._work(parent, write_end, function, item)
        job = _Job(index, pid, read_end, self.time_limit)
        self._running[pid] = job
        self._selector.register(read_end, selectors.EVENT_READ, job)
        return pid

    def _work(self, parent: tuple[int, bool], pipe: int, function: Callable[[Any], Any], item: Any) -> NoReturn:
        """The child: never returns."""
        try:
            _cases.end_with_parent(*parent)
            signal.signal(signal.SIGINT, signal.SIG_DFL)
            _cases._threads = 1
            if self.memory_limit:
                resource.setrlimit(resource.RLIMIT_AS, (self.memory_limit << 20,) * 2)
            try:
                answer = ("result", function(item))
                data = pickle.dumps(answer)
            except BaseException as error:
                message = traceback.format_exception_only(type(error), error)[-1].strip()
                is_starved = self.memory_limit and isinstance(error, MemoryError)
                data = pickle.dumps(("memory_limit" if is_starved else "error", message))
            with os.fdopen(pipe, "wb") as out:
                out.write(data)
            sys.stdout.flush()
            sys.stderr.flush()
        finally:
            os._exit(0)

    def _ended(self) -> list[_Job]:
        """Waits until at least one job has ended or a little time has passed."""
        limits = [j.end for j in self._running.values() if j.end is not None and not j.is_late]
        wait = max(0.0, min(limits) - time.monotonic()) if limits else None
        ended = []
        for key, _ in self._selector.select(wait):
            data = os.read(key.fd, 1 << 20)
            if data:
                key.data.data.append(data)
            else:
                self._end(key.data)
                ended.append(key.data)
        now = time.monotonic()
        for job in self._running.values():
            if job.end is not None and now >= job.end and not job.is_late:
                job.is_late = True
                job.kill()
        return ended

    def _end(self, job: _Job) -> None:
        self._selector.unregister(job.pipe)
        os.close(job.pipe)
        _, status = os.waitpid(job.pid, 0)
        job.code = os.waitstatus_to_exitcode(status)
        del self._running[job.pid]

    def _result(self, job: _Job) -> Any:
        if job.is_late and job.code < 0:
            return Failed("time_limit", -job.code, f"longer than {self.time_limit:g} s")
        if job.code < 0:
            return Failed("signal", -job.code, _name_of(-job.code))
        try:
            kind, value = pickle.loads(b"".join(job.data))
        except Exception:
            return Failed("error", 0, "the job left no result")
        return value if kind == "result" else Failed(kind, 0, value)
