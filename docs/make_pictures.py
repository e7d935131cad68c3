#!/usr/bin/env python3
"""Draws the three pictures of the README from scenes of the repository.

usage: docs/make_pictures.py PROGRAM

Writes docs/pictures/block.svg, slope.svg and tunnel.svg, each at most 40 kB.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import picture_size

ROOT = Path(__file__).resolve().parent.parent
LARGEST = 40_000  # bytes
WIDTH = "84"  # mm: large letters, as a third of the page needs them

# Name of the picture, commands; {} is a fresh folder.
PICTURES = [
    ("block", ["new block -o {}/block.json",
               "run {}/block.json -o {}/out",
               f"plot {{}}/out --field displacement --width {WIDTH} -o {{}}/block.svg"]),
    ("slope", ["new slope -o {}/slope.json",
               "run {}/slope.json --at /analysis/joint_materials/*/friction_angle_deg=5 "
               "--at /analysis/joint_materials/1/cohesion=0 --set steps=2400 -o {}/out",
               f"plot {{}}/out --field displacement --width {WIDTH} -o {{}}/slope.svg"]),
    ("tunnel", ["new tunnel -o {}/tunnel.json",
                "run {}/tunnel.json -o {}/out",
                f"plot {{}}/out --field s3 --width {WIDTH} -o {{}}/tunnel.svg"]),
]


def main():
    program = str(Path(sys.argv[1]).resolve())
    for name, commands in PICTURES:
        with tempfile.TemporaryDirectory() as folder:
            for command in commands:
                done = subprocess.run([program, *command.replace("{}", folder).split()], cwd=ROOT, capture_output=True,
                                      text=True, check=False)
                if done.returncode != 0:
                    sys.exit(f"{command}: exit code {done.returncode}\n{done.stderr}")
            text = picture_size.smaller((Path(folder) / f"{name}.svg").read_text(encoding="utf-8"), LARGEST)
        file = ROOT / "docs/pictures" / f"{name}.svg"
        file.write_text(text, encoding="utf-8")
        print(f"{file.relative_to(ROOT)}: {len(text.encode())} bytes")


if __name__ == "__main__":
    main()
