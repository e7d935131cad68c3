// Places of bodies at a frame, their colours, and all else that a drawing shows.

import { NO_ROW } from '../data/contract';
import type { Geometry, PartRows } from '../data/decode';
import { type FieldAt, offset_of, type Store, value_at } from '../data/store';
import { add_places, empty_box } from './camera';
import { areas_of, class_table, type MapName, table_about_zero, table_of } from './colours';
import type { Measure } from './measures';
import { show_with } from './numbers';
import { area_of } from './rings';

export interface Pose {
  frame: number;
  epoch: number;
  magnification: number;
  geometry: Geometry;
  /** x, y of each vertex and of each body's centroid. */
  places: Float32Array;
  centres: Float32Array;
}

/**
 * Places at a frame with displacements magnified: centroid + X + s (u + G X), or vertex by vertex where the file
 * holds displacements of vertices. Returns nothing while the frame is not decoded.
 */
export function pose_of(store: Store, frame: number, magnification: number): Pose | undefined {
  const epoch = store.epoch_of(frame);
  const geometry = store.geometry_now(epoch);
  if (!geometry) return undefined;
  const { bodies, vertices, centroid, place, vertex_body } = geometry;
  const places = new Float32Array(2 * vertices);
  const centres = new Float32Array(2 * bodies);
  const s = magnification;
  const own = store.field_now('vertex_motion', frame);
  if (!own && store.covers('vertex_motion', frame)) return undefined;
  if (own) {
    const ux = offset_of(own, 0);
    const uy = offset_of(own, 1);
    const { values } = own.chunk;
    const count = new Uint32Array(bodies);
    for (let v = 0; v < vertices; v++) {
      const b = vertex_body[v];
      const dx = values[ux + v];
      const dy = values[uy + v];
      places[2 * v] = centroid[2 * b] + place[2 * v] + s * dx;
      places[2 * v + 1] = centroid[2 * b + 1] + place[2 * v + 1] + s * dy;
      centres[2 * b] += s * dx;
      centres[2 * b + 1] += s * dy;
      count[b]++;
    }
    for (let b = 0; b < bodies; b++) {
      const n = count[b] || 1;
      centres[2 * b] = centroid[2 * b] + centres[2 * b] / n;
      centres[2 * b + 1] = centroid[2 * b + 1] + centres[2 * b + 1] / n;
    }
    return { frame, epoch, magnification, geometry, places, centres };
  }
  const motion = store.field_now('motion', frame);
  if (!motion && store.covers('motion', frame)) return undefined;
  const at = motion ? [0, 1, 2, 3, 4, 5].map(part => offset_of(motion, part)) : [];
  const values = motion?.chunk.values;
  const { body_loop, loop_start } = geometry;
  for (let b = 0; b < bodies; b++) {
    let [ux, uy, g11, g12, g21, g22] = [0, 0, 0, 0, 0, 0];
    if (values) {
      ux = s * values[at[0] + b];
      uy = s * values[at[1] + b];
      g11 = s * values[at[2] + b];
      g12 = s * values[at[3] + b];
      g21 = s * values[at[4] + b];
      g22 = s * values[at[5] + b];
    }
    const cx = centroid[2 * b] + ux;
    const cy = centroid[2 * b + 1] + uy;
    centres[2 * b] = cx;
    centres[2 * b + 1] = cy;
    const end = loop_start[body_loop[b + 1]];
    for (let v = loop_start[body_loop[b]]; v < end; v++) {
      const x = place[2 * v];
      const y = place[2 * v + 1];
      places[2 * v] = cx + x + g11 * x + g12 * y;
      places[2 * v + 1] = cy + y + g21 * x + g22 * y;
    }
  }
  return { frame, epoch, magnification, geometry, places, centres };
}

const extents = new WeakMap<Geometry, number>();

/** Larger one of width and height of the undeformed model. */
export function extent_of(geometry: Geometry): number {
  let extent = extents.get(geometry);
  if (extent === undefined) {
    const { centroid, place, vertex_body, vertices } = geometry;
    const places = new Float32Array(2 * vertices);
    for (let i = 0; i < places.length; i++) places[i] = centroid[2 * vertex_body[i >> 1] + (i & 1)] + place[i];
    const box = empty_box();
    add_places(box, places);
    extent = Math.max(0, box.right - box.left, box.top - box.bottom);
    extents.set(geometry, extent);
  }
  return extent;
}

/** Displacement of a body's centroid at a frame. */
export function displacement_of(store: Store, frame: number, row: number): [number, number] | undefined {
  const motion = store.field_now('motion', frame);
  if (motion && !store.covers('vertex_motion', frame)) return [value_at(motion, 0, row), value_at(motion, 1, row)];
  const own = store.field_now('vertex_motion', frame);
  const geometry = store.geometry_now(store.epoch_of(frame));
  if (!own || !geometry) return motion ? [value_at(motion, 0, row), value_at(motion, 1, row)] : undefined;
  const [from, to] = vertices_of(geometry, row);
  let x = 0;
  let y = 0;
  for (let v = from; v < to; v++) {
    x += value_at(own, 0, v);
    y += value_at(own, 1, v);
  }
  return [x / (to - from), y / (to - from)];
}

/** Area of a body at places of its vertices, without its holes. */
export function body_area(geometry: Geometry, places: ArrayLike<number>, row: number): number {
  const { body_loop, loop_start } = geometry;
  let area = 0;
  for (let l = body_loop[row]; l < body_loop[row + 1]; l++) {
    const own = Math.abs(area_of(places, loop_start[l], loop_start[l + 1]));
    area += l === body_loop[row] ? own : -own;
  }
  return area;
}

/** First vertex of a body and the one after its last. */
export function vertices_of(geometry: Geometry, row: number): [number, number] {
  return [geometry.loop_start[geometry.body_loop[row]], geometry.loop_start[geometry.body_loop[row + 1]]];
}

/** Moves a place of the drawing, on body `row`, to where the pose has it: with the body's motion, magnified. */
export function place_in_pose(store: Store, pose: Pose, row: number, x: number, y: number): [number, number] {
  const { geometry, magnification: s, frame } = pose;
  const corners = store.field_now('vertex_motion', frame);
  if (corners) {
    const best = nearest_vertex(geometry, row, x, y);
    return [x + s * value_at(corners, 0, best), y + s * value_at(corners, 1, best)];
  }
  const motion = store.field_now('motion', frame);
  if (!motion) return [x, y];
  const X = x - geometry.centroid[2 * row];
  const Y = y - geometry.centroid[2 * row + 1];
  const [ux, uy, g11, g12, g21, g22] = [0, 1, 2, 3, 4, 5].map(part => value_at(motion, part, row));
  return [x + s * (ux + g11 * X + g12 * Y), y + s * (uy + g21 * X + g22 * Y)];
}

/** Vertex of a body nearest to a place; it stands for the place, as elements are small. `motion`: where vertices are. */
function nearest_vertex(geometry: Geometry, row: number, x: number, y: number, motion?: FieldAt): number {
  const [first, end] = vertices_of(geometry, row);
  let best = first;
  let least = Infinity;
  for (let v = first; v < end; v++) {
    const px = geometry.centroid[2 * row] + geometry.place[2 * v] + (motion ? value_at(motion, 0, v) : 0) - x;
    const py = geometry.centroid[2 * row + 1] + geometry.place[2 * v + 1] + (motion ? value_at(motion, 1, v) : 0) - y;
    const distance = px * px + py * py;
    if (distance < least) {
      least = distance;
      best = v;
    }
  }
  return best;
}

/** Moves a place that a table gives for frame `from`, on body `row`, to where the pose has it. */
export function carry_place(
  store: Store,
  from: number,
  pose: Pose,
  row: number,
  x: number,
  y: number,
): [number, number] {
  const { geometry } = pose;
  if (row === NO_ROW || row >= geometry.bodies) return [x, y];
  if (from === pose.frame && pose.magnification === 1) return [x, y];
  const corners = store.field_now('vertex_motion', from);
  if (corners && store.field_now('vertex_motion', pose.frame)) {
    const best = nearest_vertex(geometry, row, x, y, corners);
    return place_in_pose(store, pose, row, x - value_at(corners, 0, best), y - value_at(corners, 1, best));
  }
  const old = store.field_now('motion', from);
  if (!old || !store.field_now('motion', pose.frame)) return [x, y];
  const cx = geometry.centroid[2 * row];
  const cy = geometry.centroid[2 * row + 1];
  const [ux, uy, g11, g12, g21, g22] = [0, 1, 2, 3, 4, 5].map(part => value_at(old, part, row));
  const rx = x - cx - ux;
  const ry = y - cy - uy;
  const determinant = (1 + g11) * (1 + g22) - g12 * g21 || 1;
  const X = ((1 + g22) * rx - g12 * ry) / determinant;
  const Y = ((1 + g11) * ry - g21 * rx) / determinant;
  return place_in_pose(store, pose, row, cx + X, cy + Y);
}

export interface Shade {
  measure: Measure;
  /** One value a body or vertex. */
  values: Float32Array;
  low: number;
  high: number;
  table: Uint8Array;
}

export interface Range {
  low: number;
  high: number;
}

/** Values of a measure at a frame, or nothing while they are not decoded. */
export function values_of(store: Store, measure: Measure, frame: number): Float32Array | undefined {
  const geometry = store.geometry_now(store.epoch_of(frame));
  if (!geometry) return undefined;
  const at = measure.field ? store.field_now(measure.field, frame) : undefined;
  if (measure.field && !at && store.covers(measure.field, frame)) return undefined;
  const out = new Float32Array(measure.on === 'body' ? geometry.bodies : geometry.vertices);
  measure.fill(out, at, geometry, frame);
  return out;
}

/** Least and greatest of the values that are numbers. */
export function range_of(values: ArrayLike<number>, into?: Range): Range {
  const range = into ?? { low: Infinity, high: -Infinity };
  for (let i = 0; i < values.length; i++) {
    const value = values[i];
    if (value < range.low) range.low = value;
    if (value > range.high) range.high = value;
  }
  return range;
}

/** Range that a legend shows: it begins or ends at zero unless all values are far from it, and is never empty. */
export function shown_range(range: Range): Range {
  let { low, high } = range;
  if (!(high >= low)) return { low: 0, high: 1 };
  if (low > 0 && low <= 0.5 * high) low = 0;
  if (high < 0 && high >= 0.5 * low) high = 0;
  if (high === low) {
    if (high === 0) high = 1;
    else if (high > 0) low = 0;
    else high = 0;
  }
  return { low, high };
}

/** Colours that suit a measure and its range. */
export function table_for(measure: Measure, range: Range, chosen: MapName, is_dark: boolean): Uint8Array {
  if (measure.kind === 'state') return class_table(areas_of(is_dark));
  return measure.is_signed ? table_about_zero(range.low, range.high) : table_of(chosen);
}

/** Fraction of the legend at which a value stands; NaN for missing values. */
export function fraction(shade: Shade, value: number): number {
  if (shade.measure.kind === 'state') return (value % 256) / 255;
  return (value - shade.low) / (shade.high - shade.low);
}

/** One fraction a body: the mean of its vertices where values stand at vertices. */
export function body_fractions(shade: Shade, geometry: Geometry): Float32Array {
  const out = new Float32Array(geometry.bodies);
  if (shade.measure.on === 'body') {
    for (let b = 0; b < geometry.bodies; b++) out[b] = fraction(shade, shade.values[b]);
    return out;
  }
  for (let b = 0; b < geometry.bodies; b++) {
    const [from, to] = vertices_of(geometry, b);
    let sum = 0;
    for (let v = from; v < to; v++) sum += shade.values[v];
    out[b] = fraction(shade, sum / (to - from));
  }
  return out;
}

/** Value of a measure for a body. */
export function body_value(measure: Measure, values: Float32Array, geometry: Geometry, row: number): number {
  if (measure.on === 'body') return values[row];
  const [from, to] = vertices_of(geometry, row);
  let sum = 0;
  for (let v = from; v < to; v++) sum += values[v];
  return sum / (to - from);
}

export interface PartAt {
  /** Frame that the rows belong to: the newest one stored. */
  frame: number;
  rows: PartRows;
}

/** Rows of a table in time for a frame: those of the newest frame that has them. */
export function part_at(store: Store, what: string, frame: number): PartAt | undefined {
  const stored = store.stored_frame(what, frame);
  if (stored === null) return undefined;
  const rows = store.part_now(what, stored);
  return rows ? { frame: stored, rows } : undefined;
}

/** A measure's value as text: name of its state, or number with unit. */
export function unit_of_value(measure: Measure, value: number): string {
  if (measure.kind === 'state')
    return measure.names?.[Math.round(value)] ?? (Number.isNaN(value) ? '–' : String(value));
  return show_with(value, measure.unit, measure.digits);
}
