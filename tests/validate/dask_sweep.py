#!/usr/bin/env python3
"""Sweeps random joint sets by kb.sweep on two workers of Dask; one worker is killed if requested.

usage: dask_sweep.py FOLDER COUNT OUTPUTS [--kill]    a part of many_runs.py, in a folder with face.json and joints.json
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import signal
import sys
import threading
import time
from pathlib import Path

import keyblock as kb
from distributed import Client


def kill_a_worker(client, folder, count):
    """Waits until an eighth of the rows is done."""
    while sum(len(j.read_text().split("\n")) - 2 for j in Path(folder).glob("journal*.jsonl")) < count / 8:
        time.sleep(0.05)
    os.kill(sorted(client.run(os.getpid).values())[0], signal.SIGKILL)


def main():
    folder, count, outputs = sys.argv[1], int(sys.argv[2]), sys.argv[3]
    rows = kb.random({"joints:/seed": range(1, count + 1), "joints:/sets/0/dip": kb.normal(35, 3)}, count)
    with Client(n_workers=2, threads_per_worker=1, dashboard_address=None) as client:
        if "--kill" in sys.argv:
            threading.Thread(target=kill_a_worker, args=(client, folder, count), daemon=True).start()
        kb.sweep("face.json", rows, out=outputs.split(","), joints="joints.json", folder=folder, client=client)


if __name__ == "__main__":
    main()
