"""Citation of the program and of the works behind its methods.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import json
import shlex
from typing import Any

from . import _keyblock


def cite(results: Any = None) -> str:
    """Returns BibTeX entries of Keyblock, with version, commit, compiler and build, and of the works on its methods.

    The build is a hash of the library; results of the same build are the same. results: a Results, whose command, changed
    values and checksums of files are added as lines that begin with %. run.json also has the checksums of frames.
    """
    return _entries() + ("" if results is None else _origin(results.run))


def _origin(run: Any) -> str:
    """Lines on the origin of a run, from run.json."""
    made = run.get("made_by", {})
    lines = [f"keyblock {run.get('version', '')}, commit {made.get('commit', 'unknown')}, {made.get('compiler', '')}",
             f"build {made.get('build', '')}", f"command {shlex.join(made.get('command', []))}",
             f"folder {made.get('folder', '')}", f"seed {made.get('seed')}"]
    lines += [f"value {pointer}={json.dumps(value)}" for pointer, value in run.get("values", {}).items()]
    lines += [f"input {i['sha256']} {i['file']}" for i in run.get("inputs", [])]
    outputs = run.get("output_sha256", {})
    lines += [f"output {outputs[name]} {name}" for name in outputs if not name.startswith("frames/")]
    return "".join(f"% {line}\n" for line in lines)


def _entries() -> str:
    return f"""@software{{keyblock,
  title = {{Keyblock: discontinuous deformation analysis and the numerical manifold method in two dimensions}},
  author = {{{{The Keyblock maintainers}}}},
  version = {{{_keyblock.version()}}},
  note = {{commit {_keyblock.commit()}, {_keyblock.compiler()}, build {_keyblock.build()}}}
}}
@phdthesis{{shi1988,
  title = {{Discontinuous deformation analysis: a new numerical model for the statics and dynamics of block systems}},
  author = {{Shi, Gen-hua}},
  school = {{University of California, Berkeley}},
  year = {{1988}}
}}
@inproceedings{{shi1991,
  title = {{Manifold method of material analysis}},
  author = {{Shi, Gen-hua}},
  booktitle = {{Transactions of the 9th Army Conference on Applied Mathematics and Computing,
    Report 92-1, US Army Research Office}},
  year = {{1991}}
}}
"""
