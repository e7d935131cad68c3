"""Citation of the program and of the works behind its methods.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

from . import _keyblock


def cite() -> str:
    """Returns BibTeX entries of Keyblock, with version and build, and of the works on its methods.

    The build is a hash of the library; results of the same build are the same.
    """
    return f"""@software{{keyblock,
  title = {{Keyblock: discontinuous deformation analysis and the numerical manifold method in two dimensions}},
  author = {{{{The Keyblock maintainers}}}},
  version = {{{_keyblock.version()}}},
  note = {{build {_keyblock.build()}}}
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
  booktitle = {{Transactions of the 9th Army Conference on Applied Mathematics and Computing, Report 92-1, US Army Research Office}},
  year = {{1991}}
}}
"""
