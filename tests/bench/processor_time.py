# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the processor time of a program: on a busy machine it varies less than wall-clock time."""
import resource
import subprocess


def timed(command, **more):
    """Returns the result of the program, and its seconds of user and system time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, capture_output=True, text=True, **more)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
