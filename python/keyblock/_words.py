"""Messages of the program with arguments of Python instead of options of the command line.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import re
from typing import Iterable

_NAMES = {"design": "over", "set": "settings", "force": "force=True"}
_PHRASES = (
    (r"--set ([a-z_.]+)=([\w.]+)", r'settings={"\1": "\2"}'),
)


def in_arguments(message: str, lacks: Iterable[str] = ()) -> str:
    """Names arguments of Python instead of options: over= for --over.

    lacks: options that the function has no argument for; a remedy that names one is left out.
    """
    def argument(option: re.Match[str]) -> str:
        if option[1] is None:  # a command of the program
            return option[0]
        name = option[1].replace("-", "_")
        name = _NAMES.get(name, name)
        return name + option[2] if option[2] == ":" or "=" in name else name + "="
    for option in lacks:
        message = re.sub(rf",? or --{option}\b[^;,]*", "", message)
    for phrase, words in _PHRASES:
        message = re.sub(phrase, words, message)
    return re.sub(r"`keyblock [^`]*`|(?<![\w-])--([a-z]+(?:-[a-z]+)*)(:| (?=\d)|)", argument, message)
