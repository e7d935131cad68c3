"""Makes SVG pictures of Keyblock smaller: fewer decimals, relative coordinates, each side of a mesh once.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re

PAIR = re.compile(r"(-?[\d.]+(?:e-?\d+)?),(-?[\d.]+(?:e-?\d+)?)")


def short(number):
    text = f"{number / 10:.1f}".rstrip("0").rstrip(".")
    return re.sub(r"^(-?)0\.", r"\1.", text) if text not in ("-0", "") else "0"


def relative(match):
    """The path in tenths of a pixel, each corner relative to the one before."""
    out = []
    for part in re.findall(r"M([^MZ]*)(Z?)", match.group(1)):
        at = None
        corners = []
        for x, y in PAIR.findall(part[0]):
            to = round(float(x) * 10), round(float(y) * 10)
            if at is None:
                corners.append(f"M{short(to[0])},{short(to[1])}")
            elif to != at or len(corners) < 3:
                corners.append(f"{'l' if len(corners) == 1 else ' '}{short(to[0] - at[0])},{short(to[1] - at[1])}")
            at = to
        out.append("".join(corners) + part[1].lower())
    return f'd="{"".join(out)}"'


def thinned(match):
    """A curve without the corners that lie within a tenth of a pixel of the line between their neighbours."""
    points = [(float(x), float(y)) for x, y in PAIR.findall(match.group(1))]
    kept = points[:1]
    i = 0
    while i < len(points) - 1:
        j = i + 1
        while j + 1 < len(points) and j - i < 200 and all(
                distance(points[k], points[i], points[j + 1]) < 0.1 for k in range(i + 1, j + 1)):
            j += 1
        kept.append(points[j])
        i = j
    return 'points="' + " ".join(f"{short(round(x * 10))},{short(round(y * 10))}" for x, y in kept) + '"'


def distance(point, begin, end):
    along = end[0] - begin[0], end[1] - begin[1]
    length = (along[0] ** 2 + along[1] ** 2) ** 0.5
    off = point[0] - begin[0], point[1] - begin[1]
    if length == 0:
        return (off[0] ** 2 + off[1] ** 2) ** 0.5
    at = (off[0] * along[0] + off[1] * along[1]) / length
    if at < 0 or at > length:
        return (off[0] ** 2 + off[1] ** 2) ** 0.5
    return abs(off[0] * along[1] - off[1] * along[0]) / length


def chains(edges):
    """The edges as few lists of corners, each edge once."""
    others = {}
    for a, b in edges:
        others.setdefault(a, []).append(b)
        others.setdefault(b, []).append(a)
    # Ends of uneven degree first, so that a chain ends only where it has to.
    for begin in sorted(others, key=lambda node: (len(others[node]) % 2 == 0, node)):
        while others[begin]:
            chain = [begin]
            while others[chain[-1]]:
                to = others[chain[-1]].pop()
                others[to].remove(chain[-1])
                chain.append(to)
            yield chain


def path_of(chain_list):
    out = []
    for chain in chain_list:
        out.append(f"M{short(chain[0][0])},{short(chain[0][1])}l" +
                   " ".join(f"{short(b[0] - a[0])},{short(b[1] - a[1])}" for a, b in zip(chain, chain[1:])))
    return "".join(out)


def mesh(match, grid):
    """A group of many elements as two paths: its area, and each side of an element once. `grid` is in tenths of a pixel."""
    count = {}
    for corners in re.findall(r'd="M([^"MZ]*)Z"', match.group(2)):
        nodes = [(round(float(x) * 10 / grid) * grid, round(float(y) * 10 / grid) * grid) for x, y in PAIR.findall(corners)]
        for a, b in zip(nodes, nodes[1:] + nodes[:1]):
            if a != b:
                edge = min(a, b), max(a, b)
                count[edge] = count.get(edge, 0) + 1
    area = path_of(chains([edge for edge, n in count.items() if n % 2]))
    return (f'{match.group(1)}\n<path stroke="none" d="{area}"/>\n<path fill="none" d="{path_of(chains(list(count)))}"/>\n</g>')


def smaller(text, most):
    """The picture in at most `most` bytes if short coordinates and meshes of single lines reach that."""
    for grid in (1, 2, 5, 10):
        made = text
        if len(text) > most:
            made = re.sub(r'(<g fill="#[0-9a-f]{6}"[^>]*>)\n((?:<path d="M[^"MZ]*Z"/>\n){300,})</g>',
                          lambda m: mesh(m, grid), made)  # pylint: disable=cell-var-from-loop
        made = re.sub(r'\bd="(M[^"l]*Z)"', relative, made)
        made = re.sub(r'points="([^"]*)"', thinned, made)
        if len(made.encode()) <= most:
            break
    return made
