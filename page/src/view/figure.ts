// Makes the figure of the present state: what the renderers and the exports draw.

import { NO_ROW, type PartHead, type StillThing } from '../data/contract';
import type { Geometry, PartRows } from '../data/decode';
import { show } from '../draw/numbers';
import type { Arrows, ContactMarks, Crosses, Figure, LineMarks, PointMarks } from '../draw/paint';
import { pick_body, pick_point, typical_size } from '../draw/pick';
import {
  body_fractions,
  body_value,
  carry_place,
  displacement_of,
  type PartAt,
  type Pose,
  part_at,
  place_in_pose,
  pose_of,
  type Range,
  range_of,
  type Shade,
  shown_range,
  table_for,
  values_of,
} from '../draw/scene';
import * as state from './state';

/** Columns that name a row of a table over time. */
const IDENT: Record<string, string[]> = {
  contacts: ['block', 'other', 'joint'],
  bolts: ['bolt'],
  cracks: ['crack', 'side'],
  tips: ['crack', 'end'],
  points: ['point'],
};

/** Numbers that name a row; rows of bodies become keys, which hold over epochs. */
export function ident_of(what: string, rows: PartRows, i: number, pose_geometry: Pose['geometry']): number[] {
  const names = what === 'tips' && rows.columns.tip ? ['tip'] : (IDENT[what] ?? []).filter(name => rows.columns[name]);
  return names.map(name => {
    const value = rows.columns[name][i];
    if (name !== 'block' && name !== 'other') return value;
    return value === NO_ROW || value >= pose_geometry.bodies ? -1 : pose_geometry.key[value];
  });
}

/** Position of a row among the rows of the same name. */
export function nth_of(what: string, rows: PartRows, i: number, geometry: Pose['geometry']): number {
  const own = ident_of(what, rows, i, geometry).join();
  let nth = 0;
  for (let j = 0; j < i; j++) if (ident_of(what, rows, j, geometry).join() === own) nth++;
  return nth;
}

/** Row of a chosen thing in the rows of a frame, or nothing if it is not there. */
export function row_of(what: string, ident: number[], nth: number, rows: PartRows, geometry: Pose['geometry']) {
  const own = ident.join();
  let left = nth;
  let last: number | null = null;
  for (let i = 0; i < rows.rows; i++) {
    if (ident_of(what, rows, i, geometry).join() !== own) continue;
    last = i;
    if (left-- === 0) return i;
  }
  return last;
}

export function part_head(what: string): PartHead | undefined {
  return state.head.parts?.[what];
}

/** Chosen row of a table at this frame. */
function chosen_row(what: string, at: PartAt, geometry: Pose['geometry']): number | null {
  const own = state.chosen.value;
  if (own?.kind !== 'part' || own.what !== what) return null;
  return row_of(what, own.ident, own.nth, at.rows, geometry);
}

/** Row of the chosen body at this frame's epoch. */
export function chosen_body(geometry: Pose['geometry']): number | null {
  const own = state.chosen.value;
  if (own?.kind !== 'body') return null;
  return geometry.row_of_key.get(own.key) ?? null;
}

function joint_names(): string[] {
  return state.head.joints.map((name, i) => (name === String(i + 1) ? `Joint material ${name}` : name));
}

export function contacts_of(pose: Pose): { marks: ContactMarks; at: PartAt } | null {
  const at = part_at(state.store, 'contacts', pose.frame);
  if (!at) return null;
  const { place, normal, normal_force, shear_force, state: states, block, other } = at.rows.columns;
  if (!place || !normal || !normal_force) return null;
  const n = at.rows.rows;
  const places = new Float32Array(2 * n);
  const force = new Float32Array(2 * n);
  const near = new Uint8Array(n);
  const body = chosen_body(pose.geometry);
  let largest = 0;
  for (let i = 0; i < n; i++) {
    const [x, y] = carry_place(state.store, at.frame, pose, block ? block[i] : NO_ROW, place[2 * i], place[2 * i + 1]);
    places[2 * i] = x;
    places[2 * i + 1] = y;
    const [nx, ny] = [normal[2 * i], normal[2 * i + 1]];
    const shear = shear_force ? shear_force[i] : 0;
    force[2 * i] = normal_force[i] * nx - shear * ny;
    force[2 * i + 1] = normal_force[i] * ny + shear * nx;
    largest = Math.max(largest, Math.hypot(normal_force[i], shear));
    if (body !== null && (block?.[i] === body || other?.[i] === body)) near[i] = 1;
  }
  if (state.range_mode.value !== 'frame') largest = Math.max(largest, state.largest_force());
  return {
    at,
    marks: {
      at: places,
      force,
      state: states ? Uint32Array.from(states) : new Uint32Array(n).fill(1),
      joint:
        state.contact_colour.value === 'joint' && at.rows.columns.joint
          ? Uint32Array.from(at.rows.columns.joint)
          : null,
      joint_names: joint_names(),
      near,
      largest,
      unit: part_head('contacts')?.columns.find(c => c.name === 'normal_force')?.unit ?? '',
      chosen: chosen_row('contacts', at, pose.geometry),
    },
  };
}

/** Ends of bolts or cracks: x1, y1, x2, y2 in turn. */
function ends_of(rows: PartRows): Float32Array | null {
  const { from, to } = rows.columns;
  if (!from || !to) return null;
  const out = new Float32Array(4 * rows.rows);
  for (let i = 0; i < rows.rows; i++) out.set([from[2 * i], from[2 * i + 1], to[2 * i], to[2 * i + 1]], 4 * i);
  return out;
}

/** Moves ends of bolts with the bodies that hold them at the frame of their table. */
function carry_ends(ends: Float32Array, from: number, pose: Pose): void {
  const held = pose_of(state.store, from, 1);
  if (!held || held.geometry !== pose.geometry || ends.length > 4000) return;
  for (let i = 0; i < ends.length; i += 2) {
    const row = pick_body(held, ends[i], ends[i + 1]) ?? pick_near(held, ends[i], ends[i + 1]);
    const [x, y] = carry_place(state.store, from, pose, row, ends[i], ends[i + 1]);
    ends[i] = x;
    ends[i + 1] = y;
  }
}

/** Body of the vertex nearest to a place. */
function pick_near(pose: Pose, x: number, y: number): number {
  const v = pick_point(pose.places, x, y, Infinity);
  return v === null ? NO_ROW : pose.geometry.vertex_body[v];
}

/** Places of a table's rows, moved with magnification if a column holds displacements. */
function places_of(what: string, rows: PartRows, pose: Pose): Float32Array | null {
  const { place, displacement } = rows.columns;
  const s = pose.magnification;
  if (!place) return null;
  const out = Float32Array.from(place);
  if (what === 'tips') {
    // Places of tips are undeformed: each moves with the vertex nearest to it.
    const rest = pose_of(state.store, pose.frame, 0);
    if (!rest) return out;
    for (let i = 0; i < out.length; i += 2) {
      const v = pick_point(rest.places, out[i], out[i + 1], Infinity);
      if (v === null) continue;
      out[i] += pose.places[2 * v] - rest.places[2 * v];
      out[i + 1] += pose.places[2 * v + 1] - rest.places[2 * v + 1];
    }
    return out;
  }
  if (displacement && displacement.length === out.length && s !== 1) {
    for (let i = 0; i < out.length; i++) out[i] += (s - 1) * displacement[i];
  }
  return out;
}

export function lines_of(pose: Pose): { marks: LineMarks; at: PartAt }[] {
  const out: { marks: LineMarks; at: PartAt }[] = [];
  for (const what of ['bolts', 'cracks'] as const) {
    if (!state.layers.value[what] || !state.store.has(what)) continue;
    const at = part_at(state.store, what, pose.frame);
    const ends = at && ends_of(at.rows);
    if (!at || !ends) continue;
    const { displacement, broken } = at.rows.columns;
    if (displacement && displacement.length === ends.length && pose.magnification !== 1) {
      for (let i = 0; i < ends.length; i++) ends[i] += (pose.magnification - 1) * displacement[i];
    } else if (pose.magnification !== 1 || at.frame !== pose.frame) {
      carry_ends(ends, at.frame, pose);
    }
    const marks: LineMarks = {
      name: what,
      ends,
      broken: broken as Uint32Array | undefined,
      chosen: chosen_row(what, at, pose.geometry),
    };
    out.push({ marks, at });
  }
  return out;
}

export function points_of(pose: Pose): { marks: PointMarks; at: PartAt }[] {
  const out: { marks: PointMarks; at: PartAt }[] = [];
  for (const what of ['points', 'tips'] as const) {
    if (!state.layers.value[what] || !state.store.has(what)) continue;
    const at = part_at(state.store, what, pose.frame);
    const places = at && places_of(what, at.rows, pose);
    if (!at || !places) continue;
    // A run writes these tables from time to time: at later frames they would stand where they were.
    if (state.is_running.value && at.frame !== pose.frame) continue;
    const number = at.rows.columns.point;
    const marks: PointMarks = {
      name: what,
      at: places,
      labels: number ? Array.from(number, n => String(n)) : undefined,
      chosen: chosen_row(what, at, pose.geometry),
    };
    out.push({ marks, at });
  }
  return out;
}

export function shade_at(pose: Pose): Shade | null {
  const own = state.measure.value;
  if (!own) return null;
  const values = values_of(state.store, own, pose.frame);
  if (!values) return null;
  let range: Range;
  if (own.kind === 'state') range = { low: 0, high: 255 };
  else if (state.range_mode.value === 'own') range = state.own_range.value;
  else if (state.range_mode.value === 'frame') range = shown_range(range_of(values));
  else range = shown_range(state.run_range(own));
  return { measure: own, values, ...range, table: table_for(own, range, state.map_name.value, state.is_dark.value) };
}

function arrows_of(pose: Pose): Arrows | null {
  const kind = state.arrows.value;
  if (kind === 'none') return null;
  const size = state.measures.find(m => m.id === `${kind}.size`);
  if (!size) return null;
  const parts = ['x', 'y'].map(axis => {
    const own = state.measures.find(m => m.id === `${kind}.${axis}`);
    const values = own && values_of(state.store, own, pose.frame);
    return own && values ? { own, values } : null;
  });
  if (!parts[0] || !parts[1]) return null;
  const { geometry } = pose;
  const vector = new Float32Array(2 * geometry.bodies);
  let largest = 0;
  for (let b = 0; b < geometry.bodies; b++) {
    const x = body_value(parts[0].own, parts[0].values, geometry, b);
    const y = body_value(parts[1].own, parts[1].values, geometry, b);
    vector[2 * b] = Number.isNaN(x) ? 0 : x;
    vector[2 * b + 1] = Number.isNaN(y) ? 0 : y;
    largest = Math.max(largest, Math.hypot(vector[2 * b], vector[2 * b + 1]));
  }
  if (state.range_mode.value !== 'frame') largest = Math.max(largest, state.run_range(size).high);
  return { at: pose.centres, vector, largest, label: size.group, unit: size.unit };
}

function crosses_of(pose: Pose): Crosses | null {
  if (!state.layers.value.crosses) return null;
  const wanted = ['xx', 'yy', 'xy'].map(part => state.measures.find(m => m.id === `stress.${part}`));
  const values = wanted.map(own => own && values_of(state.store, own, pose.frame));
  if (!wanted[0] || values.some(v => !v)) return null;
  const { geometry } = pose;
  const greatest = new Float32Array(geometry.bodies);
  const least = new Float32Array(geometry.bodies);
  const angle = new Float32Array(geometry.bodies);
  for (let b = 0; b < geometry.bodies; b++) {
    const [xx, yy, xy] = values.map((v, i) => body_value(wanted[i]!, v!, geometry, b));
    const middle = (xx + yy) / 2;
    const radius = Math.hypot((xx - yy) / 2, xy);
    greatest[b] = middle + radius;
    least[b] = middle - radius;
    angle[b] = Math.atan2(2 * xy, xx - yy) / 2;
  }
  const own = state.largest_cross_at(pose.frame) ?? 0;
  const largest = state.range_mode.value === 'frame' ? own : Math.max(own, state.largest_cross());
  return { at: pose.centres, greatest, least, angle, largest, unit: wanted[0].unit };
}

function is_near(a: Float32Array, i: number, b: Float32Array, j: number): boolean {
  const size = 1e-5 * (1 + Math.abs(b[2 * j]) + Math.abs(b[2 * j + 1]));
  return Math.abs(a[2 * i] - b[2 * j]) < size && Math.abs(a[2 * i + 1] - b[2 * j + 1]) < size;
}

/** Path of a body's centroid up to this frame, magnified; at most `most` places. */
function trail_of(key: number, to: number, s: number, most: number): Float32Array {
  const out: number[] = [];
  const stride = Math.max(1, Math.ceil((to + 1) / most));
  const now = state.store.geometry_now(state.store.epoch_of(to));
  const now_row = now?.row_of_key.get(key);
  if (!now || now_row === undefined) return new Float32Array(0);
  for (let f = 0; ; f = Math.min(to, f + stride)) {
    const geometry = state.store.geometry_now(state.store.epoch_of(f));
    const row = geometry?.row_of_key.get(key);
    const moved = geometry && row !== undefined ? displacement_of(state.store, f, row) : undefined;
    // A body that was cut has another centroid: its trail begins anew.
    const same =
      geometry === now ||
      (row !== undefined && geometry !== undefined && is_near(geometry.centroid, row, now.centroid, now_row));
    if (geometry && row !== undefined && moved && same) {
      out.push(geometry.centroid[2 * row] + s * moved[0], geometry.centroid[2 * row + 1] + s * moved[1]);
    }
    if (f >= to) break;
  }
  return Float32Array.from(out);
}

function trails_of(pose: Pose): Float32Array[] {
  const kind = state.trails.value;
  if (kind === 'none') return [];
  const { geometry } = pose;
  if (kind === 'chosen') {
    const body = chosen_body(geometry);
    return body === null ? [] : [trail_of(geometry.key[body], pose.frame, pose.magnification, 400)];
  }
  const most = geometry.bodies > 1000 ? 15 : 50;
  const out: Float32Array[] = [];
  for (let b = 0; b < geometry.bodies; b++) {
    if (!geometry.fixed[b]) out.push(trail_of(geometry.key[b], pose.frame, pose.magnification, most));
  }
  return out;
}

export function caption_of(frame: number, s: number): string {
  const own = state.head.frames[frame];
  const parts = [`Step ${own.step}`];
  const place = state.place_in_run(own);
  if (place) parts.push(place);
  if (own.stage) parts.push(own.stage);
  if (s !== 1) parts.push(s === 0 ? 'undeformed' : `displacements × ${show(s, 4)}`);
  return parts.join(' · ');
}

/** Supports and loads where their bodies have moved them. */
function still_now(pose: Pose): StillThing[] {
  return (state.head.still ?? []).map(thing => {
    const row = thing.block === undefined ? undefined : pose.geometry.row_of_key.get(thing.block);
    return row === undefined ? thing : { ...thing, at: place_in_pose(state.store, pose, row, ...thing.at) };
  });
}

const typical = new WeakMap<Geometry, number>();

/** The figure, or nothing while its frame is not decoded. */
export function figure_now(): Figure | null {
  void state.decoded.value;
  const s = state.magnification.value;
  const pose = pose_of(state.store, state.frame.value, s);
  if (!pose) return null;
  const rest = state.layers.value.undeformed ? (pose_of(state.store, pose.frame, 0) ?? null) : null;
  const shade = shade_at(pose);
  let width = typical.get(pose.geometry);
  if (width === undefined) {
    width = typical_size(pose);
    typical.set(pose.geometry, width);
  }
  return {
    size: state.size.value,
    camera: state.camera.value,
    paint: state.paint.value,
    pose,
    rest,
    shade,
    fractions: shade && body_fractions(shade, pose.geometry),
    chosen: chosen_body(pose.geometry),
    numbers: state.layers.value.numbers,
    outlines: state.layers.value.outlines,
    contacts: state.layers.value.contacts || state.chosen.value !== null ? contacts_shown(pose) : null,
    lines: lines_of(pose).map(own => own.marks),
    points: points_of(pose).map(own => own.marks),
    arrows: arrows_of(pose),
    crosses: crosses_of(pose),
    trails: trails_of(pose),
    still: state.layers.value.still ? still_now(pose) : [],
    typical: width,
    length_unit: state.head.units?.length ?? '',
    legend: state.layers.value.legend,
    caption: caption_of(pose.frame, s),
  };
}

/** All contacts if they are shown; those of the chosen body or the chosen one alone if not. */
function contacts_shown(pose: Pose): ContactMarks | null {
  const own = contacts_of(pose);
  if (!own) return null;
  if (state.layers.value.contacts) return own.marks;
  const { marks } = own;
  const kept: number[] = [];
  for (let i = 0; i < marks.state.length; i++) if (marks.near[i] || marks.chosen === i) kept.push(i);
  if (!kept.length) return null;
  const pair = (from: Float32Array) => Float32Array.from(kept.flatMap(i => [from[2 * i], from[2 * i + 1]]));
  return {
    at: pair(marks.at),
    force: pair(marks.force),
    state: Uint32Array.from(kept, i => marks.state[i]),
    joint: marks.joint && Uint32Array.from(kept, i => marks.joint![i]),
    joint_names: marks.joint_names,
    near: Uint8Array.from(kept, i => marks.near[i]),
    largest: marks.largest,
    unit: marks.unit,
    chosen: marks.chosen === null ? null : kept.indexOf(marks.chosen),
  };
}
