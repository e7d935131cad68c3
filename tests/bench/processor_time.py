# SPDX-License-Identifier: GPL-3.0-or-later
"""Processor time of a program that is run: on a busy machine it wanders less than what a clock on the wall shows."""
import resource
import subprocess


def timed(command, **more):
    """What the program left, and its seconds, of its own and of the system on its behalf."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, capture_output=True, text=True, **more)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
