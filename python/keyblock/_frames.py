"""Frames: one instant of a run as NumPy views, data frames and pictures.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

from typing import Any, Sequence

import numpy as np

from . import _keyblock

Array = np.ndarray[Any, Any]

def _column(part: str, name: str, doc: str) -> property:
    def get(self: Frame) -> Array:
        return self.column(part, name)
    return property(get, doc=doc)


class Frame:
    """One instant of a run. Its arrays are views that cannot be written; they stay valid without the run.

    A frame can be pickled, with its contacts.
    """

    __slots__ = ("_frame", "_units")

    def __init__(self, frame: _keyblock.Frame | _Columns, units: Sequence[str] = ("", "", "")) -> None:
        self._frame = frame
        self._units = tuple(units)

    def __reduce__(self) -> Any:
        return Frame, (self._frame if isinstance(self._frame, _Columns) else _Columns.of(self._frame), self.units)

    units = property(lambda self: self._units,
                     doc="Names of the units of length, mass and time; each empty if the case does not declare it.")
    step = property(lambda self: self._frame.step, doc="Number of the step; 0 is the initial state.")
    time = property(lambda self: self._frame.time, doc="Time [time].")
    load_factor = property(lambda self: self._frame.load_factor, doc="Factor of the loads under crack growth.")
    epoch = property(lambda self: self._frame.epoch,
                     doc="One more each time that blocks change, from 0; rows of one epoch are the same blocks.")

    number = _column("blocks", "block", "Number of each block, n.")
    material = _column("blocks", "material", "Number of the material of each block, n.")
    centroid = _column("blocks", "centroid", "Centroid of each block [length], n x 2.")
    displacement = _column("blocks", "displacement", "Displacement of centroids from the drawing [length], n x 2.")
    rotation = _column("blocks", "rotation", "Rotation to the left [rad], n.")
    velocity = _column("blocks", "velocity", "Velocity of centroids [length/time], n x 2.")
    rotation_rate = _column("blocks", "rotation_rate", "Rate of rotation to the left [rad/time], n.")
    stress = _column("blocks", "stress", "Stress xx, yy, xy, zz, tension positive [force/length²], n x 4.")
    area = _column("blocks", "area", "Area of each block [length²], n.")
    vertices = _column("corners", "place", "All corners, loop after loop [length], corners x 2.")
    loop_block = _column("loops", "row", "Row of the block of each loop, loops.")
    loop_corners = _column("loops", "corners", "Number of corners of each loop, loops.")
    point = _column("points", "place", "Measured points [length], p x 2.")
    point_displacement = _column("points", "displacement", "Their displacement [length], p x 2.")
    contact_block = _column("contacts", "block", "Number of the block of each contact, c.")
    contact_other = _column("contacts", "other", "Number of the other block of each contact, c.")
    contact_state = _column("contacts", "state", "State of each contact: 0 open, 1 sticks, 2 slides, c.")
    contact_point = _column("contacts", "place", "Place of each contact [length], c x 2.")
    contact_normal = _column("contacts", "normal", "Unit normal out of the other block, c x 2.")
    contact_pressure = _column("contacts", "normal_force", "Normal force per thickness [force/length], c.")
    contact_shear = _column("contacts", "shear_force", "Shear force per thickness [force/length], c.")
    contact_gap = _column("contacts", "gap", "Gap, positive if the faces are apart [length], c.")

    @staticmethod
    def parts() -> list[str]:
        """Returns the names of the parts: blocks, loops, corners, contacts, bolts, cracks, points, tips.

        Each row is one of them. Bolts have their ends and their force. Cracks are pairs of faces, with detail="corners".
        Tips have the stress intensity. `names`, `components` and `unit` describe the columns.
        """
        return _keyblock.Frame.parts()

    def names(self, part: str) -> list[str]:
        """Returns the names of the columns of a part. A part without rows has those of any frame."""
        return self._frame.names(part)

    def column(self, part: str, name: str) -> Array:
        """Returns a column of a part as a view. Raises SettingError if there is none."""
        return self._frame.column(part, name)

    def components(self, part: str, name: str) -> list[str]:
        """Returns the names of the numbers of a row, such as x and y; none for a single number."""
        return self._frame.components(part, name)

    def unit(self, part: str, name: str) -> str:
        """Returns the unit of a column; empty for a plain number, and if the case does not declare its units."""
        return self._frame.unit(part, name)

    def index_of(self, number: int) -> int:
        """Returns the row of the block with this number. Raises KeyError if there is none."""
        found = np.flatnonzero(self.number == number)
        if not len(found):
            raise KeyError(f"no block has the number {number}")
        return int(found[0])

    def part(self, part: str) -> Any:
        """Returns a part as a pandas data frame; without pandas as a dict of arrays.

        Columns of several numbers become several columns, such as displacement_x. `attrs` holds step, time, and under
        "units" the unit of each column; a unit is empty if the case does not declare it.
        """
        columns, units = {}, {}
        for name in self.names(part):
            suffixes, unit = self.components(part, name), self.unit(part, name)
            values = self.column(part, name)
            for i, suffix in enumerate(suffixes or ("",)):
                key = f"{name}_{suffix}" if suffix else name
                columns[key] = values[:, i] if suffixes else values
                units[key] = unit
        try:
            import pandas
        except ImportError:
            return columns
        table = pandas.DataFrame(columns)
        table.attrs.update(step=self.step, time=self.time, units=units)
        return table

    def polygons(self) -> list[list[Array]]:
        """Returns the loops of each block: a list of lists of arrays of corners."""
        loops = np.split(self.vertices, np.cumsum(self.loop_corners)[:-1]) if len(self.loop_corners) else []
        blocks: list[list[Array]] = [[] for _ in range(len(self.number))]
        for row, loop in zip(self.loop_block, loops):
            blocks[row].append(loop)
        return blocks

    def _outlines(self) -> tuple[Array, Array]:
        """First corner of the outline of each block, and its number of corners."""
        _, outer = np.unique(self.loop_block, return_index=True)  # the outline comes before the holes
        first = np.concatenate(([0], np.cumsum(self.loop_corners)))
        return first[outer], self.loop_corners[outer]

    def to_meshio(self) -> Any:
        """Returns a meshio.Mesh of the blocks as polygons, with their numbers, displacement and stress; needs meshio.

        Holes are left out. Corners are not shared by blocks.
        """
        import meshio
        first, counts = self._outlines()
        cells, rows = [], []
        for count in np.unique(counts):
            of_count = np.flatnonzero(counts == count)
            cells.append((_MESHIO_CELLS.get(int(count), "polygon"), first[of_count][:, None] + np.arange(count)))
            rows.append(of_count)
        data = {name: [self.column("blocks", name)[r] for r in rows] for name in _CELL_DATA}
        return meshio.Mesh(_in_space(self.vertices), cells, cell_data=data)

    def to_pyvista(self) -> Any:
        """Returns a pyvista.UnstructuredGrid of the blocks as polygons, with the data of `to_meshio`; needs pyvista."""
        import pyvista
        first, counts = self._outlines()
        cells = np.concatenate([np.r_[n, np.arange(at, at + n)] for at, n in zip(first, counts)] or [np.empty(0, int)])
        grid = pyvista.UnstructuredGrid(cells, np.full(len(counts), _VTK_POLYGON, np.uint8), _in_space(self.vertices))
        for name in _CELL_DATA:
            grid.cell_data[name] = self.column("blocks", name).copy()  # VTK would keep it, and these are read-only
        return grid

    def svg(self, colour: Any = None, width: int = 640) -> str:
        """Returns a picture as SVG text: blocks coloured by a number of each, by default their displacement."""
        return _svg(self, colour, width)

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        return f"<Frame of step {self.step}, time {self.time:g}: {len(self.number)} blocks>"


class _Columns:
    """Columns of a frame outside the library, which a pickled frame has."""

    step: int
    time: float
    load_factor: float
    epoch: int = 0
    parts: dict[str, dict[str, tuple[Array, list[str], str]]]  # column, components and unit

    @classmethod
    def of(cls, frame: _keyblock.Frame) -> _Columns:
        """Copies the columns of a frame."""
        columns = cls()
        columns.step, columns.time, columns.load_factor = frame.step, frame.time, frame.load_factor
        columns.epoch = frame.epoch
        columns.parts = {part: {name: (frame.column(part, name), frame.components(part, name), frame.unit(part, name))
                                for name in frame.names(part)}
                         for part in frame.parts()}
        return columns

    def _found(self, part: str, name: str) -> tuple[Array, list[str], str]:
        if part not in self.parts or name not in self.parts[part]:
            raise _keyblock.SettingError(f"expected a column of a frame, found {part}, {name}")
        return self.parts[part][name]

    def __setstate__(self, state: Any) -> None:
        self.__dict__.update(state)
        for columns in self.parts.values():
            for values, _, _ in columns.values():
                values.flags.writeable = False

    def names(self, part: str) -> list[str]:
        if part not in self.parts:
            raise _keyblock.SettingError(f"expected a part of a frame ({', '.join(self.parts)}), found {part}")
        return list(self.parts[part])

    def column(self, part: str, name: str) -> Array:
        return self._found(part, name)[0]

    def components(self, part: str, name: str) -> list[str]:
        return self._found(part, name)[1]

    def unit(self, part: str, name: str) -> str:
        return self._found(part, name)[2]


def _values(frame: Frame, colour: Any) -> tuple[Array, str]:
    """A number per block, and its name."""
    if colour is None:
        return np.hypot(*frame.displacement.T), "displacement"
    if isinstance(colour, str):
        values = frame.column("blocks", colour)
        values, name = (np.hypot(*values.T) if values.ndim == 2 and values.shape[1] == 2 else values), colour
    else:
        values, name = np.asarray(colour, float), ""
    if values.shape != frame.number.shape:
        raise ValueError(f"colour: expected a number for each of {len(frame.number)} blocks, "
                         f"found an array of shape {values.shape}")
    return values, name


_CELL_DATA = ("block", "material", "displacement", "stress")
_MESHIO_CELLS = {3: "triangle", 4: "quad"}  # by their corners; others are polygons
_VTK_POLYGON = 7


def _in_space(corners: Array) -> Array:
    return np.column_stack((corners, np.zeros(len(corners))))


# Ends and middle of a sequential scale, light to dark.
_SCALE = np.array([[255, 247, 217], [247, 184, 96], [205, 83, 52], [103, 22, 60]], float)


def _svg(frame: Frame, colour: Any, width: int) -> str:
    values, name = _values(frame, colour)
    corners = frame.vertices
    if not len(corners):
        return f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="20"/>'
    low, high = corners.min(axis=0), corners.max(axis=0)
    scale = (width - 20) / max(high[0] - low[0], 1e-300)
    height = int((high[1] - low[1]) * scale) + 40
    finite = values[np.isfinite(values)]
    least, greatest = (finite.min(), finite.max()) if len(finite) else (0.0, 0.0)
    shares = np.nan_to_num((values - least) / ((greatest - least) or 1.0)) * (len(_SCALE) - 1)
    colours = np.stack([np.interp(shares, range(len(_SCALE)), c) for c in _SCALE.T], axis=1).astype(int)
    unit = frame.unit("blocks", name) if name else ""
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
             f'viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">',
             '<g stroke="#333" stroke-width="0.6" fill-rule="evenodd">']
    for block, (loops, rgb) in enumerate(zip(frame.polygons(), colours)):
        path = "".join("M" + "L".join(f"{x:.2f} {y:.2f}" for x, y in
                                      np.column_stack(((l[:, 0] - low[0]) * scale + 10, (high[1] - l[:, 1]) * scale + 10)))
                       + "Z" for l in loops)
        lines.append(f'<path d="{path}" fill="#{rgb[0]:02x}{rgb[1]:02x}{rgb[2]:02x}">'
                     f"<title>block {frame.number[block]}: {values[block]:.3g} {unit}</title></path>")
    label = f"{name} {least:.3g} to {greatest:.3g} {unit}, " if name else ""
    lines.append(f'</g><text x="10" y="{height - 8}">{label}step {frame.step}, time {frame.time:.4g} {frame.units[2]}'
                 "</text></svg>")
    return "\n".join(lines)


def plot(frame: Frame, colour: Any = None, ax: Any = None, label: str | None = None, **options: Any) -> Any:
    """Draws the blocks of a frame with Matplotlib and returns the axes.

    colour: a number per block, or the name of a column of blocks; by default the displacement. ax: axes to draw on; by
    default those of a new figure. label: text of the colour bar. options: those of
    matplotlib.collections.PathCollection, such as cmap and edgecolors.
    """
    import matplotlib.pyplot as plt
    from matplotlib.collections import PathCollection
    from matplotlib.path import Path
    values, name = _values(frame, colour)
    if ax is None:
        _, ax = plt.subplots()
    paths = []
    for loops in frame.polygons():
        vertices, codes = [], []
        for i, loop in enumerate(loops):
            x, y = loop.T
            is_left = np.dot(x, np.roll(y, -1)) >= np.dot(y, np.roll(x, -1))
            if is_left == (i > 0):  # holes run the other way
                loop = loop[::-1]
            vertices += [loop, loop[:1]]
            codes += [Path.MOVETO] + [Path.LINETO] * (len(loop) - 1) + [Path.CLOSEPOLY]
        paths.append(Path(np.concatenate(vertices), codes))
    options.setdefault("edgecolors", "0.2")
    options.setdefault("linewidths", 0.5)
    blocks = PathCollection(paths, array=values, **options)
    ax.add_collection(blocks)
    ax.autoscale_view()
    ax.set_aspect("equal")
    unit = frame.unit("blocks", name) if name else ""
    ax.figure.colorbar(blocks, ax=ax, label=label or (f"{name} [{unit}]" if unit else name))
    ax.set_title(f"step {frame.step}, time {frame.time:.4g} {frame.units[2]}".rstrip())
    return ax
