#!/usr/bin/env python3
"""Runs a dozen scenes of the repository, one command each, and writes a page with their pictures.

usage: docs/make_gallery.py PROGRAM FOLDER

FOLDER gets one results folder per scene and index.html, which names the command of each picture. Earlier results in these
folders are overwritten. The exit code is 1 if a scene was not drawn.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import html
import shlex
import subprocess
import sys
import time
from pathlib import Path

from make_board import STYLE

ROOT = Path(__file__).resolve().parent.parent

# Name, title, contents of the picture, picture, command without -o.
SCENES = [
    ("tunnel", "Tunnel in three stages", "Excavation of a tunnel in jointed rock, with bolts: vertical stress after the last stage.", "field.svg",
     "run docs/tunnel.json"),
    ("quarry", "Quarry face from a drawing", "A bench cut from a DXF drawing; layers of the drawing name outline, bedding and joints.", "picture.svg",
     "run docs/quarry.dxf docs/bench.json --layers docs/quarry_layers.csv"),
    ("wedge", "Factor of safety of two blocks", "The last stable and the first unstable state of a strength reduction.", "picture.svg",
     "fos legacy_cases/strength_reduction/two_blocks_steep"),
    ("toppling", "Goodman and Bray's slope", "Sixteen columns of Goodman and Bray's example rotate down the slope.", "picture.svg",
     "run legacy_cases/goodman_bray/falls --profile standard"),
    ("arch", "Collapse of an arch", "Fifteen voussoirs under 1.05 times the horizontal acceleration that they resist.", "picture.svg",
     "run legacy_cases/masonry_arch/quake_thin_falls --profile standard"),
    ("snap", "Snap-through of a flat arch", "A low beam of two elastic halves passes below its abutments; the halves are meshes of bonded blocks.", "picture.svg",
     "run legacy_cases/voussoir_beam/low_snaps"),
    ("stack", "Stack on a tilting plate", "Five bricks topple as one body.", "picture.svg",
     "run legacy_cases/tilting_stack/n5 --profile standard"),
    ("wall", "Brick wall by Shi's rules", "Stress in a wall of bricks under its suddenly applied weight, as the Berkeley program computes it.", "field.svg",
     "run legacy_cases/reference_traces/brick5/brick5.geo legacy_cases/reference_traces/brick5/brick5.ana"),
    ("footing", "Strip footing at its limit load", "Plastic strain, mean stress and yielded rock below one half of a footing.", "plastic.svg",
     "run docs/tutorials/footing.json"),
    ("membrane", "Cook's membrane of a metal that hardens", "Plastic strain, mean stress and yielded parts of a tapered panel.", "plastic.svg",
     "run legacy_cases/cook_membrane_plastic/coarse"),
    ("hole", "Plate with a hole", "Stress concentration at the edge of a hole, on a mesh refined by the estimated error.", "field.svg",
     "run legacy_cases/plate_with_hole/refined"),
    ("crack", "Curved path of a crack", "A tilted crack in a cantilever turns away; stress intensity factors and load over its length.", "cracks.svg",
     "run legacy_cases/crack_growth/cantilever_tilted"),
    ("disc", "Cracked disc under a diametral load", "Stress about an inclined crack in a disc.", "field.svg",
     "run legacy_cases/stress_intensity/cracked_disc_03_20"),
]


def draw(program, folder):
    """Runs all scenes; returns the names of those without a picture."""
    missing = []
    for name, title, _, picture, command in SCENES:
        begin = time.monotonic()
        done = subprocess.run([program, *shlex.split(command), "-o", str(folder / name), "--force"], cwd=ROOT, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        drawn = (folder / name / picture).is_file()
        print(f"{title}: " + (f"{time.monotonic() - begin:.1f} s" if drawn else f"no picture\n{done.stdout}"), flush=True)
        if not drawn:
            missing.append(name)
    return missing


def page(folder, version):
    figures = "".join(
        f'<article class="scene"><h3>{html.escape(title)}</h3><p class="soft">{html.escape(text)}</p>'
        f'<a class="picture" href="{name}/{picture}"><img loading="lazy" alt="{html.escape(text)}" src="{name}/{picture}"></a>'
        f"<pre><code>keyblock {html.escape(command)} -o {folder}/{name}</code></pre></article>\n"
        for name, title, text, picture, command in SCENES)
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>Keyblock: gallery</title><style>{STYLE}
.scenes {{ display: grid; grid-template-columns: repeat(auto-fit, minmax(min(380px, 100%), 1fr)); gap: 16px; margin: 16px 0 40px; }}
article.scene {{ display: flex; flex-direction: column; gap: 6px; margin: 0; }}
.scene .picture {{ flex: 1; }} .scene .picture img {{ height: 340px; object-position: center; }} .scene pre {{ font-size: 12px; }}
</style></head><body><header><h1>Keyblock: gallery</h1>
<p>{len(SCENES)} scenes, one command each, from the root of the repository. Drawn by {html.escape(version)}.
A click on a picture opens it in full size.</p></header>
<main><div class="scenes">
{figures}</div></main></body></html>
"""


def main(arguments):
    if len(arguments) != 2:
        sys.exit("usage: docs/make_gallery.py PROGRAM FOLDER")
    program, folder = str(Path(arguments[0]).resolve()), Path(arguments[1])
    folder.mkdir(parents=True, exist_ok=True)
    version = subprocess.run([program, "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout.split("\n")[0]
    missing = draw(program, folder.resolve())
    (folder / "index.html").write_text(page(folder, version), encoding="utf-8")
    print(f"gallery: {folder}/index.html")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
