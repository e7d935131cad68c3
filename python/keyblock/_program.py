"""The program `keyblock` in a child process, for work that the library cannot do yet.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import csv
import functools
import json
import os
import shutil
import signal
import subprocess
import tempfile
from pathlib import Path
from typing import Any, Iterable

from . import _keyblock
from ._cases import Case, StrPath, encoded, end_with_parent, read
from ._words import in_arguments


class ProgramError(_keyblock.Error):
    """The program ended with an exit code that is no answer. `code`: the exit code; the text is its message."""

    def __init__(self, message: str, code: int) -> None:
        super().__init__(message)
        self.code = code


def program() -> str:
    """Returns the path of the program.

    That is the environment variable KEYBLOCK_PROGRAM, else the program of this package, else that of the search path.
    """
    own = Path(__file__).with_name("bin") / "keyblock"
    found = os.environ.get("KEYBLOCK_PROGRAM") or (str(own) if own.is_file() else shutil.which("keyblock"))
    if not found:
        raise ProgramError("the program keyblock is not on the search path; KEYBLOCK_PROGRAM may name it", 127)
    return found


def _run(arguments: Iterable[Any], accepted: tuple[int, ...] = (0,), lacks: Iterable[str] = ()) -> str:
    """Output of the program. Ctrl-C stops it within a second; it keeps its checkpoint. It ends if this process is killed.

    lacks: options that the function has no argument for.
    """
    path = program()
    try:
        child = subprocess.Popen([path, *map(encoded, map(str, arguments))], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                 encoding="utf-8", errors="surrogateescape",
                                 preexec_fn=functools.partial(end_with_parent, os.getpid()))
    except OSError as error:
        raise ProgramError(f"the program {path} does not start: {error.strerror}; KEYBLOCK_PROGRAM may name another",
                           127) from error
    try:
        out, errors = child.communicate()
    except BaseException:
        if child.poll() is None:
            child.send_signal(signal.SIGTERM)
            try:
                child.wait(1)
            except subprocess.TimeoutExpired:
                child.kill()
                child.wait()
        raise
    if child.returncode in accepted:
        return out
    told = [line for line in errors.splitlines() if not line.startswith("Run with --help")]
    lines = [line for line in told if "error" in line] or told[-1:] or out.splitlines()[-1:]
    raise ProgramError(in_arguments("\n".join(lines), lacks), child.returncode)


def _options(**given: Any) -> list[str]:
    """Options of the command line; None and False are left out."""
    all: list[str] = []
    for name, value in given.items():
        option = "--" + name.replace("_", "-")
        if value is True:
            all.append(option)
        elif isinstance(value, (list, tuple)):
            all += [text for one in value for text in (option, str(one))]
        elif value is not None and value is not False:
            all += [option, str(value)]
    return all


def convert(*files: StrPath, output: StrPath, to: str | None = None, strict: bool = False, force: bool = False,
            layers: StrPath | None = None, unit: str | None = None, join: float | None = None) -> Any:
    """Converts files with `keyblock convert`. Returns its report: outputs, losses and warnings.

    Raises ProgramError.
    """
    return json.loads(_run(["convert", *map(str, files), "-o", output, "--json",
                            *_options(to=to, strict=strict, force=force, layers=layers, unit=unit, join=join)]))


def new(kind: str, path: StrPath, force: bool = False) -> Path:
    """Writes a commented example case with `keyblock new`: slope, arch, beam, tunnel or block. Returns its path.

    Raises ProgramError.
    """
    _run(["new", kind, "-o", path, *_options(force=force)])
    return Path(path)


def joints(spec: dict[str, Any] | StrPath, path: StrPath, seed: int | None = None, force: bool = False) -> Path:
    """Draws joint sets with `keyblock joints` into a drawing. Returns its path.

    spec: a dict as docs/slope.json, or the path of one. path: ends in .dxf, .json, .xml or .geo. seed: overrides that of
    spec. force: overwrite an existing file. Raises ProgramError.
    """
    with tempfile.TemporaryDirectory(prefix="keyblock_") as folder:
        if isinstance(spec, dict):
            file = Path(folder) / "joints.json"
            file.write_text(json.dumps(spec), encoding="utf-8")
            spec = file
        _run(["joints", spec, "-o", path, *_options(seed=seed, force=force)])
    return Path(path)


def number_of(text: str) -> int | float | str:
    if "_" in text:  # Python reads 1_0 as 10
        return text
    for kind in (int, float):
        try:
            return kind(text)  # type: ignore[no-any-return]
        except ValueError:
            pass
    return text


def compare(*cases: StrPath, profile: str | None = None, all: bool = False, threads: int | None = None) -> Any:
    """Reruns case folders against their expected values with `keyblock compare`. Returns its report.

    Raises ProgramError.
    """
    return json.loads(_run(["compare", *map(str, cases), "--json", *_options(profile=profile, all=all, threads=threads)],
                           (0, 1)))


def element(case: Case | StrPath, path: str, to: float | Iterable[float] = (), material: int | None = None,
            confining: float | None = None, cycles: int | None = None, steps: int | None = None,
            size: float | None = None) -> tuple[Any, list[dict[str, Any]]]:
    """Drives one element of a material along a path with `keyblock element`. Returns (report, curve).

    path: uniaxial, triaxial, biaxial, oedometer, shear, cyclic, or a table. to: a strain, or several, one after another.
    curve: a list of dicts, one per increment. Raises InputError, ProgramError.
    """
    with tempfile.TemporaryDirectory(prefix="keyblock_") as folder:
        file = case
        if isinstance(case, Case) or os.path.isdir(case):
            file = os.path.join(folder, "case.json")
            (case if isinstance(case, Case) else read(case)).write(file)
        curve = os.path.join(folder, "curve.csv")
        strains = ",".join(repr(float(strain)) for strain in (to if isinstance(to, Iterable) else (to,)))
        targets = _options(to=strains) if strains else []
        report = _run(["element", file, "--path", path, "-o", curve, "--json", *targets,
                       *_options(material=material, confining=confining, cycles=cycles, steps=steps, size=size)], (0, 1))
        with open(curve, newline="", encoding="utf-8") as rows:
            return json.loads(report), [{k: number_of(v) for k, v in row.items()} for row in csv.DictReader(rows)]


def fit(curve: StrPath, triaxial: bool = False, toughness: str | None = None, compression: str | None = None,
        strain_factor: float | None = None, friction: float | None = None) -> Any:
    """Finds parameters of rock from measured curves with `keyblock fit`. Returns its report. Raises ProgramError."""
    return json.loads(_run(["fit", curve, "--json", *_options(triaxial=triaxial, toughness=toughness, compression=compression,
                                                              strain_factor=strain_factor, friction=friction)], (0, 1)))


def cases(folder: StrPath, root: StrPath | None = None) -> list[Path | tuple[Path, ...]]:
    """Returns the cases at or below a folder, sorted: those that `keyblock batch` runs. `read` and `Run` take each.

    A case is its folder if that has a `case.json`, a file, or a tuple of files. folder: also the name of a verification
    problem, such as "stress_intensity". root: folder of the problems; by default KEYBLOCK_CASES, else legacy_cases below
    the current folder. Raises ProgramError if there is none.
    """
    if root is not None or not os.path.isdir(folder):
        folder = Path(root or os.environ.get("KEYBLOCK_CASES") or "legacy_cases") / folder
    found: dict[Path | tuple[Path, ...], None] = {}
    for case in json.loads(_run(["batch", folder, "--list", "--json"])):
        files = tuple(map(Path, case["files"]))
        own = files[0].parent
        is_folder = files[0].stem == own.name and (own / "case.json").is_file()
        found[own if is_folder else files if len(files) > 1 else files[0]] = None
    return list(found)
