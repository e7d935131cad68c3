// Paints a figure with a pen: bodies, what lies over them, legend and scale bar.

import type { StillThing } from '../data/contract';
import type { Geometry } from '../data/decode';
import { type Camera, type Size, to_screen } from './camera';
import { COMPRESSION, css_of, index_of, lines_of, TENSION } from './colours';
import { round_below, scaled_unit, show, show_with, ticks_of } from './numbers';
import type { Line, Pen } from './pen';
import { fraction, type Pose, type Shade, vertices_of } from './scene';

/** Colours of a theme, for the drawing. */
export interface Paint {
  background: string;
  surface: string;
  ink: string;
  muted: string;
  outline: string;
  /** Colour of outlines about dark fills. */
  outline_on_dark: string;
  plain: string;
  plain_fixed: string;
  chosen: string;
  near: string;
  stick: string;
  slide: string;
  open: string;
  /** Colours of classes that lines have. */
  classes: string[];
  bolt: string;
  crack: string;
  mark: string;
  tension: string;
  compression: string;
  missing: string;
}

export const LIGHT: Paint = {
  background: '#ffffff',
  surface: '#ffffff',
  ink: '#1b2330',
  muted: '#566273',
  outline: '#2b3442',
  outline_on_dark: '#8592a3',
  plain: '#dfe4ea',
  plain_fixed: '#b9c1cb',
  chosen: '#d6006c',
  near: '#d6006c',
  stick: '#0b5fa5',
  slide: '#d24a00',
  open: '#7a8594',
  classes: lines_of(false),
  bolt: '#7b2fbf',
  crack: '#c00000',
  mark: '#0a7a55',
  tension: TENSION,
  compression: COMPRESSION,
  missing: '#c9ced6',
};

export const DARK: Paint = {
  background: '#12161c',
  surface: '#1a2028',
  ink: '#e6eaf0',
  muted: '#a3b0bf',
  outline: '#0c0f13',
  outline_on_dark: '#7d8a9b',
  plain: '#46515f',
  plain_fixed: '#2f3843',
  chosen: '#ff5aa5',
  near: '#ff5aa5',
  stick: '#63b3ff',
  slide: '#ff9146',
  open: '#8b97a6',
  classes: lines_of(true),
  bolt: '#c792ff',
  crack: '#ff6b6b',
  mark: '#4fd1a0',
  tension: '#ff8a7a',
  compression: '#6fb1e8',
  missing: '#56606d',
};

/** Contacts at places of the frame; `force` x, y in turn. */
export interface ContactMarks {
  at: Float32Array;
  force: Float32Array;
  state: Uint32Array;
  /** Class of each contact's joint, for colours by joint; its names are in the legend. */
  joint: Uint32Array | null;
  joint_names: string[];
  /** 1 for contacts of the chosen body. */
  near: Uint8Array;
  /** Force that gets the widest line. */
  largest: number;
  unit: string;
  /** Index of the chosen contact. */
  chosen: number | null;
}

export interface LineMarks {
  name: string;
  ends: Float32Array;
  /** State of each line that dims it (broken bolts), if any. */
  broken?: Uint32Array;
  chosen: number | null;
}

export interface PointMarks {
  name: string;
  at: Float32Array;
  labels?: string[];
  chosen: number | null;
}

/** Arrows from places of bodies; `largest` gets the longest one. */
export interface Arrows {
  at: Float32Array;
  vector: Float32Array;
  largest: number;
  label: string;
  unit: string;
}

/** Principal stresses at places of bodies: greatest, least, direction of the greatest in radians. */
export interface Crosses {
  at: Float32Array;
  greatest: Float32Array;
  least: Float32Array;
  angle: Float32Array;
  largest: number;
  unit: string;
}

export interface Figure {
  size: Size;
  camera: Camera;
  paint: Paint;
  pose: Pose;
  /** Places without displacement, dashed. */
  rest: Pose | null;
  shade: Shade | null;
  /** One fraction a body, for pens that colour bodies as a whole. */
  fractions: Float32Array | null;
  chosen: number | null;
  numbers: boolean;
  outlines: boolean;
  contacts: ContactMarks | null;
  lines: LineMarks[];
  points: PointMarks[];
  arrows: Arrows | null;
  crosses: Crosses | null;
  trails: Float32Array[];
  still: StillThing[];
  /** Width of a typical body. */
  typical: number;
  length_unit: string;
  legend: boolean;
  /** Line of text under the legend: step, time, magnification. */
  caption: string;
}

/** Places on the screen. */
export function screen_of(figure: Figure, places: ArrayLike<number>): Float32Array {
  const { camera, size } = figure;
  const out = new Float32Array(places.length);
  const left = size.width / 2 - camera.x * camera.scale;
  const top = size.height / 2 + camera.y * camera.scale;
  for (let i = 0; i < places.length; i += 2) {
    out[i] = left + places[i] * camera.scale;
    out[i + 1] = top - places[i + 1] * camera.scale;
  }
  return out;
}

/** Width of outlines: thin where bodies are small on the screen, 0 where outlines would hide their colours. */
export function outline_width(figure: Figure): number {
  const size = figure.typical * figure.camera.scale;
  return !figure.outlines || size < 4 ? 0 : size > 25 ? 1 : size > 8 ? 0.7 : 0.4;
}

const HATCH_LINE: Line = { colour: '#10151c', second: '#ffffff', width: 1, opacity: 0.42 };

/** Loops of bodies with light and with dark fills, whose outlines differ. */
export function split_loops(figure: Figure): [number[], number[]] {
  const { geometry } = figure.pose;
  const { shade, fractions } = figure;
  const light: number[] = [];
  const dark: number[] = [];
  for (let l = 0; l < geometry.loops; l++) {
    let is_dark = false;
    const t = fractions?.[geometry.loop_body[l]] ?? Number.NaN;
    if (shade && !Number.isNaN(t)) {
      const i = 3 * index_of(t);
      is_dark = 0.3 * shade.table[i] + 0.59 * shade.table[i + 1] + 0.11 * shade.table[i + 2] < 72;
    }
    (is_dark ? dark : light).push(l);
  }
  return [light, dark];
}

/** Bodies from which on those of one colour are filled together. */
const MANY = 1500;

/** Fills, hatches and outlines. */
export function paint_bodies(pen: Pen, figure: Figure, screen: Float32Array): void {
  const { geometry } = figure.pose;
  const { paint, shade, fractions } = figure;
  const { body_loop, loop_start, fixed } = geometry;
  // Bodies of one colour share paths where there are many: they are drawn by colour then, not by number.
  const classes = new Map<string, number[]>();
  // Without outlines the background would show through the smoothed edges of elements.
  const has_seams = !figure.outlines && geometry.bodies < 20_000;
  const is_many = geometry.bodies > MANY;
  for (let b = 0; b < geometry.bodies; b++) {
    let fill = fixed[b] ? paint.plain_fixed : paint.plain;
    if (shade && fractions) {
      const t = fractions[b];
      fill = Number.isNaN(t) ? paint.missing : css_of(shade.table, index_of(t));
    }
    const [from, to] = [body_loop[b], body_loop[b + 1]];
    if (!is_many || to - from !== 1) {
      pen.area(screen, loop_start, from, to, fill);
      if (has_seams) pen.loops(screen, loop_start, from, to, { colour: fill, width: 0.8 });
      continue;
    }
    const list = classes.get(fill);
    if (list) list.push(from);
    else classes.set(fill, [from]);
  }
  for (const [fill, list] of classes) {
    pen.areas(screen, loop_start, list, fill);
    if (has_seams) pen.some_loops(screen, loop_start, list, { colour: fill, width: 0.8 });
  }
  for (let b = 0; b < geometry.bodies; b++) {
    if (!fixed[b]) continue;
    pen.hatch(screen, loop_start, body_loop[b], body_loop[b + 1], HATCH_LINE);
  }
  const width = outline_width(figure);
  if (width > 0) {
    const [light, dark] = split_loops(figure);
    pen.some_loops(screen, loop_start, dark, { colour: paint.outline_on_dark, width });
    pen.some_loops(screen, loop_start, light, { colour: paint.outline, width });
  }
}

/** Line with a head at its second end, from a length on at which one is seen. */
export function arrow(pen: Pen, x0: number, y0: number, x1: number, y1: number, line: Line): void {
  const dx = x1 - x0;
  const dy = y1 - y0;
  const length = Math.hypot(dx, dy);
  if (length < 1.5) return;
  const head = Math.min(Math.max(7, 4 * line.width), length * 0.5);
  const ex = dx / length;
  const ey = dy / length;
  pen.segments([x0, y0, x1 - ex * head * 0.7, y1 - ey * head * 0.7], line);
  pen.polygon(
    [
      x1,
      y1,
      x1 - ex * head - ey * head * 0.42,
      y1 - ey * head + ex * head * 0.42,
      x1 - ex * head + ey * head * 0.42,
      y1 - ey * head - ex * head * 0.42,
    ],
    line.colour,
  );
}

/** Ends of the line of a contact's force on the screen, and its width. */
export function contact_line(figure: Figure, marks: ContactMarks, i: number): [number, number, number, number, number] {
  const { camera, size } = figure;
  const [x, y] = to_screen(camera, size, marks.at[2 * i], marks.at[2 * i + 1]);
  const fx = marks.force[2 * i];
  const fy = marks.force[2 * i + 1];
  const force = Math.hypot(fx, fy);
  const share = marks.largest > 0 ? force / marks.largest : 0;
  const reach = Math.max(5, Math.min(26, 0.24 * figure.typical * camera.scale)) * (0.55 + 0.45 * Math.sqrt(share));
  const ex = force > 0 ? fx / force : 0;
  const ey = force > 0 ? -fy / force : 0;
  const widest = Math.max(1.5, Math.min(6, 0.1 * figure.typical * camera.scale));
  return [x - ex * reach, y - ey * reach, x + ex * reach, y + ey * reach, 1 + widest * share];
}

function paint_contacts(pen: Pen, figure: Figure, marks: ContactMarks): void {
  const { paint } = figure;
  const count = marks.state.length;
  const some_near = figure.chosen !== null || marks.chosen !== null;
  // Lines of one look go into one path: widths in seven classes, three states, dimmed or not.
  const classes = new Map<number, { line: Line; ends: number[] }>();
  const rim: number[] = [];
  for (let i = 0; i < count; i++) {
    const [x0, y0, x1, y1, width] = contact_line(figure, marks, i);
    if (Math.max(x0, x1) < -20 || Math.min(x0, x1) > figure.size.width + 20) continue;
    if (Math.max(y0, y1) < -20 || Math.min(y0, y1) > figure.size.height + 20) continue;
    const state = marks.state[i];
    const joint = marks.joint ? marks.joint[i] % paint.classes.length : 0;
    const colour = marks.joint
      ? paint.classes[joint]
      : state === 2
        ? paint.slide
        : state === 1
          ? paint.stick
          : paint.open;
    const dim = some_near && !marks.near[i] && marks.chosen !== i;
    const rounded = Math.round(width);
    const key = 64 * (marks.joint ? joint : state) + 2 * rounded + (dim ? 1 : 0);
    let entry = classes.get(key);
    if (!entry) {
      entry = { line: { colour, width: rounded, opacity: dim ? 0.35 : 1, is_square: count > 1500 }, ends: [] };
      classes.set(key, entry);
    }
    entry.ends.push(x0, y0, x1, y1);
    if (marks.near[i] || marks.chosen === i) rim.push(x0, y0, x1, y1);
  }
  if (rim.length) pen.segments(rim, { colour: paint.near, width: 10, opacity: 0.45 });
  const light = [...classes.values()].sort((a, b) => a.line.width - b.line.width);
  for (const { line, ends } of light) {
    if (count <= 1500 && line.opacity === 1) {
      pen.segments(ends, { colour: paint.background, width: line.width + 2, opacity: 0.8 });
    }
    pen.segments(ends, line);
  }
  if (marks.chosen !== null) {
    const [x0, y0, x1, y1] = contact_line(figure, marks, marks.chosen);
    pen.circle((x0 + x1) / 2, (y0 + y1) / 2, 9, null, { colour: paint.chosen, width: 2 });
  }
}

/** Half length in pixels of the longest cross in a dense mesh, which has one cross a cell of the screen. */
const MESH_CROSS = 13;

function paint_crosses(pen: Pen, figure: Figure, crosses: Crosses): void {
  const own = 0.42 * figure.typical * figure.camera.scale;
  const is_dense = own < MESH_CROSS;
  const reach = Math.max(own, MESH_CROSS);
  const at = screen_of(figure, crosses.at);
  const taken = new Set<number>();
  const pull: number[] = [];
  const push: number[] = [];
  const factor = crosses.largest > 0 ? reach / crosses.largest : 0;
  for (let i = 0; i < crosses.greatest.length; i++) {
    if (is_dense) {
      const cell = Math.floor(at[2 * i] / 28) * 10000 + Math.floor(at[2 * i + 1] / 28);
      if (taken.has(cell)) continue;
      taken.add(cell);
    }
    for (const [value, turn] of [
      [crosses.greatest[i], 0],
      [crosses.least[i], Math.PI / 2],
    ]) {
      const half = Math.min(Math.abs(value) * factor, reach);
      if (!(half > 0.7)) continue;
      const dx = Math.cos(crosses.angle[i] + turn) * half;
      const dy = -Math.sin(crosses.angle[i] + turn) * half;
      const x = at[2 * i];
      const y = at[2 * i + 1];
      (value > 0 ? pull : push).push(x - dx, y - dy, x + dx, y + dy);
    }
  }
  const { paint } = figure;
  for (const [ends, colour] of [
    [push, paint.compression],
    [pull, paint.tension],
  ] as const) {
    pen.segments(ends, { colour: paint.background, width: 3, opacity: 0.7 });
    pen.segments(ends, { colour, width: 1.6 });
  }
}

function paint_still(pen: Pen, figure: Figure): void {
  const { paint, camera, size } = figure;
  for (const thing of figure.still) {
    const [x, y] = to_screen(camera, size, ...thing.at);
    if (thing.kind === 'load' && thing.force) {
      const length = Math.hypot(...thing.force) || 1;
      const [fx, fy] = [(thing.force[0] / length) * 30, (-thing.force[1] / length) * 30];
      arrow(pen, x - fx, y - fy, x, y, { colour: paint.crack, width: 2 });
    } else if (thing.kind.startsWith('fixed')) {
      const half = figure.still.length > 20 ? 3.5 : 5.5;
      pen.polygon([x, y, x - half, y + 1.7 * half, x + half, y + 1.7 * half], paint.mark);
    } else {
      pen.circle(x, y, 3.5, paint.background, { colour: paint.mark, width: 2 });
    }
  }
}

/** All that lies over the bodies. */
export function paint_over(pen: Pen, figure: Figure, screen: Float32Array): void {
  const { paint, pose } = figure;
  const { geometry } = pose;
  if (figure.rest) {
    const rest = screen_of(figure, figure.rest.places);
    const edges = rest_edges(geometry, figure.rest.places, figure.typical);
    const ends = new Float32Array(2 * edges.length);
    for (let i = 0; i < edges.length; i++) {
      ends[2 * i] = rest[2 * edges[i]];
      ends[2 * i + 1] = rest[2 * edges[i] + 1];
    }
    pen.segments(ends, { colour: paint.ink, width: 0.9, dash: [5, 4], opacity: 0.75 });
  }
  for (const trail of figure.trails) {
    const line = screen_of(figure, trail);
    let length = 0;
    for (let i = 2; i < line.length; i += 2) length += Math.hypot(line[i] - line[i - 2], line[i + 1] - line[i - 1]);
    if (length < 1.5) continue;
    pen.polyline(line, { colour: paint.background, width: 3.5, opacity: 0.6 });
    pen.polyline(line, { colour: paint.chosen, width: 1.5 });
  }
  paint_still(pen, figure);
  for (const marks of figure.lines) {
    const ends = screen_of(figure, marks.ends);
    const is_crack = marks.name.startsWith('crack');
    const colour = is_crack ? paint.crack : paint.bolt;
    const whole: number[] = [];
    const broken: number[] = [];
    for (let i = 0; i < ends.length; i += 4) {
      (marks.broken?.[i >> 2] ? broken : whole).push(ends[i], ends[i + 1], ends[i + 2], ends[i + 3]);
    }
    pen.segments(whole, { colour: paint.background, width: 5, opacity: 0.7 });
    pen.segments(whole, { colour, width: is_crack ? 2.5 : 3 });
    pen.segments(broken, { colour, width: 2, dash: [3, 5] });
    if (!is_crack) {
      for (let i = 0; i < ends.length; i += 2) {
        pen.circle(ends[i], ends[i + 1], 3, paint.background, { colour, width: 1.5 });
      }
    }
    if (marks.chosen !== null && 4 * marks.chosen < ends.length) {
      const i = 4 * marks.chosen;
      pen.segments(ends.subarray(i, i + 4), { colour: paint.chosen, width: 7, opacity: 0.6 });
    }
  }
  if (figure.crosses) paint_crosses(pen, figure, figure.crosses);
  if (figure.contacts) paint_contacts(pen, figure, figure.contacts);
  if (figure.arrows) {
    const at = screen_of(figure, figure.arrows.at);
    const factor = figure.arrows.largest > 0 ? 48 / figure.arrows.largest : 0;
    const { vector } = figure.arrows;
    // Dense meshes get one arrow a cell of the screen: the first of each.
    const taken = new Set<number>();
    for (let i = 0; i < at.length; i += 2) {
      const cell = Math.floor(at[i] / 22) * 10000 + Math.floor(at[i + 1] / 22);
      if (taken.has(cell)) continue;
      taken.add(cell);
      const x1 = at[i] + vector[i] * factor;
      const y1 = at[i + 1] - vector[i + 1] * factor;
      arrow(pen, at[i], at[i + 1], x1, y1, { colour: paint.ink, width: 1.4 });
    }
  }
  for (const marks of figure.points) {
    const at = screen_of(figure, marks.at);
    for (let i = 0; i < at.length; i += 2) {
      const is_chosen = marks.chosen === i >> 1;
      pen.circle(at[i], at[i + 1], is_chosen ? 6 : 4, paint.background, {
        colour: is_chosen ? paint.chosen : paint.mark,
        width: 2.2,
      });
      const label = marks.labels?.[i >> 1];
      if (label) {
        const style = { size: 12, colour: paint.ink, weight: 600, halo: paint.background };
        pen.text(at[i] + 8, at[i + 1] - 6, label, style);
      }
    }
  }
  if (figure.chosen !== null && figure.chosen < geometry.bodies) {
    const b = figure.chosen;
    const [from, to] = [geometry.body_loop[b], geometry.body_loop[b + 1]];
    pen.loops(screen, geometry.loop_start, from, to, { colour: paint.background, width: 5 });
    pen.loops(screen, geometry.loop_start, from, to, { colour: paint.chosen, width: 2.5 });
  }
  if (figure.numbers) {
    const at = screen_of(figure, pose.centres);
    for (let b = 0; b < geometry.bodies; b++) {
      const [x, y] = [at[2 * b], at[2 * b + 1]];
      if (x < 0 || y < 0 || x > figure.size.width || y > figure.size.height) continue;
      const [from, to] = vertices_of(geometry, b);
      let left = Infinity;
      let right = -Infinity;
      for (let v = from; v < to; v++) {
        left = Math.min(left, screen[2 * v]);
        right = Math.max(right, screen[2 * v]);
      }
      if (right - left < 16) continue;
      const style = { size: 11, colour: paint.ink, anchor: 'middle', halo: paint.background } as const;
      pen.text(x, y + 4, String(geometry.number[b]), style);
    }
  }
}

/** Letters of a name that fit into the legend. */
const MOST_LETTERS = 44;

const short = (name: string): string => {
  const letters = [...name];
  return letters.length > MOST_LETTERS ? `${letters.slice(0, MOST_LETTERS - 1).join('')}…` : name;
};

/** Legend at the bottom left, scale bar at the bottom right, caption above the legend. */
export function paint_legend(pen: Pen, figure: Figure): void {
  const { paint, size, shade } = figure;
  const left = 12;
  const rows: string[] = [];
  const swatches: { name: string; colour: string }[] = [];
  if (figure.arrows) {
    const largest = show_with(figure.arrows.largest, figure.arrows.unit, 3);
    rows.push(`Longest arrow: ${figure.arrows.label.toLowerCase()} ${largest}`);
  }
  if (figure.crosses) {
    const largest = show_with(figure.crosses.largest, figure.crosses.unit, 3);
    rows.push(`Longest cross: ${largest} or more; blue compression, red tension`);
  }
  if (figure.contacts) {
    const largest = show_with(figure.contacts.largest, figure.contacts.unit, 3);
    const { joint, joint_names } = figure.contacts;
    rows.push(`Widest contact line: ${largest}${joint ? '' : '; blue sticks, orange slides'}`);
    if (joint)
      swatches.push(
        ...joint_names.map((name, i) => ({ name: short(name), colour: paint.classes[i % paint.classes.length] })),
      );
  }
  const width = Math.min(320, size.width - 24);
  const states = shade?.measure.kind === 'state' ? (shade.measure.names ?? []).map(short) : null;
  const bar = shade && !states;
  const state_rows = states?.length ? layout_states(states, width) : null;
  const height = (shade ? (states && !state_rows ? 0 : 22) : 0) + (bar ? 32 : 0) + (state_rows?.height ?? 0);
  const swatch_rows = swatches.length
    ? layout_states(
        swatches.map(own => own.name),
        width,
      )
    : null;
  const room = height + rows.length * 16 + (swatch_rows?.height ?? 0);
  let y = size.height - 10 - room;
  // Text is taken as 6.2 pixels a letter.
  const widest = Math.min(size.width - 24, Math.max(width, ...rows.map(row => row.length * 6.2)));
  if (room > 0) pen.box(left - 4, y - 4, widest + 8, room + 8, paint.surface, 6, 0.88);
  for (const row of rows) {
    pen.text(left, y + 12, row, { size: 11.5, colour: paint.muted });
    y += 16;
  }
  if (swatch_rows) {
    swatch_rows.places.forEach(([x, dy], i) => {
      pen.box(left + x, y + dy + 4, 12, 4, swatches[i].colour, 2);
      pen.text(left + x + 17, y + dy + 10.5, swatches[i].name, { size: 11.5, colour: paint.ink });
    });
    y += swatch_rows.height;
  }
  if (shade && height > 0) {
    const scaled = states ? { factor: 1, unit: '' } : unit_of(shade);
    const title = `${shade.measure.label}${scaled.unit ? ` [${scaled.unit}]` : ''}`;
    pen.text(left, y + 13, title, { size: 12.5, colour: paint.ink, weight: 600 });
    y += 22;
    if (bar) {
      const steps = 64;
      for (let i = 0; i < steps; i++) {
        const colour = css_of(shade.table, Math.round((i / (steps - 1)) * 255));
        pen.box(left + (i * width) / steps, y, width / steps + 0.6, 12, colour);
      }
      const style = { size: 11, colour: paint.ink } as const;
      const low = shade.low / scaled.factor;
      const high = shade.high / scaled.factor;
      const ticks = ticks_of(low, high, width > 250 ? 5 : 4);
      const digits = shade.measure.digits;
      for (const tick of ticks) {
        const x = left + ((tick - low) / (high - low)) * width;
        pen.segments([x, y + 12, x, y + 15], { colour: paint.ink, width: 1 });
        const anchor = x < left + 12 ? 'start' : x > left + width - 12 ? 'end' : 'middle';
        pen.text(x, y + 27, show(tick, digits), { ...style, anchor });
      }
    } else if (state_rows && states) {
      state_rows.places.forEach(([x, dy], i) => {
        const colour = css_of(shade.table, index_of(fraction(shade, i)));
        pen.box(left + x, y + dy, 12, 12, colour, 2);
        pen.text(left + x + 17, y + dy + 10.5, states[i], { size: 11.5, colour: paint.ink });
      });
    }
  }
  paint_scale_bar(pen, figure);
}

/** Unit of a legend, with a prefix that suits its range. */
export function unit_of(shade: Shade) {
  return scaled_unit(shade.measure.unit, Math.max(Math.abs(shade.low), Math.abs(shade.high)));
}

/** Places of states' names in rows of a legend: text is taken as 6.4 pixels a letter. */
function layout_states(names: string[], width: number): { places: [number, number][]; height: number } {
  const places: [number, number][] = [];
  let x = 0;
  let y = 0;
  for (const name of names.slice(0, 24)) {
    const own = 17 + name.length * 6.4 + 14;
    if (x > 0 && x + own > width) {
      x = 0;
      y += 18;
    }
    places.push([x, y]);
    x += own;
  }
  return { places, height: y + 18 };
}

function paint_scale_bar(pen: Pen, figure: Figure): void {
  const { paint, size, camera } = figure;
  const length = round_below(Math.min(160, size.width * 0.25) / camera.scale);
  const width = length * camera.scale;
  // On narrow drawings the legend takes the bottom, so the bar goes to the top left.
  const is_narrow = size.width < 640;
  const right = is_narrow ? 16 + width : size.width - 16;
  const y = is_narrow ? 28 : size.height - 14;
  const label = show_with(length, figure.length_unit, 3);
  pen.box(right - width - 8, y - 20, width + 16, 28, paint.surface, 6, 0.88);
  const line = { colour: paint.ink, width: 1.5 };
  pen.segments([right - width, y, right, y], line);
  pen.segments([right - width, y - 4, right - width, y + 4], line);
  pen.segments([right, y - 4, right, y + 4], line);
  pen.text(right - width / 2, y - 6, label, { size: 11.5, colour: paint.ink, anchor: 'middle' });
}

/** Caption for exported drawings, top left. */
export function paint_caption(pen: Pen, figure: Figure): void {
  pen.text(12, 20, figure.caption, { size: 13, colour: figure.paint.ink, weight: 600, halo: figure.paint.background });
}

const known_edges = new WeakMap<Geometry, Uint32Array>();

/** Vertices of edges, two an edge, without those that two elements share: outlines of blocks and of meshed bodies. */
export function rest_edges(geometry: Geometry, places: ArrayLike<number>, typical: number): Uint32Array {
  let edges = known_edges.get(geometry);
  if (edges) return edges;
  const grid = 1e-4 * typical;
  const name = (v: number) => `${Math.round(places[2 * v] / grid)},${Math.round(places[2 * v + 1] / grid)}`;
  const list: number[] = [];
  const seen = new Map<string, number>();
  for (let l = 0; l < geometry.loops; l++) {
    const is_element = (geometry.kind[geometry.loop_body[l]] & 255) === 1;
    const end = geometry.loop_start[l + 1];
    for (let v = geometry.loop_start[l]; v < end; v++) {
      const next = v + 1 === end ? geometry.loop_start[l] : v + 1;
      if (is_element) {
        const [a, b] = [name(v), name(next)].sort();
        const before = seen.get(`${a} ${b}`);
        if (before !== undefined) {
          // Shared: neither of the two is drawn.
          list[before] = list[before + 1] = -1;
          continue;
        }
        seen.set(`${a} ${b}`, list.length);
      }
      list.push(v, next);
    }
  }
  edges = Uint32Array.from(list.filter(v => v >= 0));
  known_edges.set(geometry, edges);
  return edges;
}

/** Whole drawing. */
export function paint_all(pen: Pen, figure: Figure, with_caption: boolean): void {
  const screen = screen_of(figure, figure.pose.places);
  paint_bodies(pen, figure, screen);
  paint_over(pen, figure, screen);
  if (figure.legend) paint_legend(pen, figure);
  if (with_caption) paint_caption(pen, figure);
}
