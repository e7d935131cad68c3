// Changes of a case's text as they come from the canvas.

import { find, type Path, parse, plain, remove, set, splice, type Value } from './case_text';
import { coordinates_of, type Item, is_within, length_as, loops_of, type Point, type Scene, scene_of } from './scene';

const tidy = (x: number) => Number(x.toPrecision(12));
const row = (...points: Point[]) => points.flat().map(tidy);
const same = (a: Point, b: Point) =>
  Math.hypot(a[0] - b[0], a[1] - b[1]) <= 1e-9 * (1 + Math.abs(a[0]) + Math.abs(a[1]));

/** Number of the block or element that carries a point, counted from 1; 0 if none does. */
function block_at(scene: Scene, point: Point): number {
  return scene.polygons.findIndex(own => is_within(own.loops, point)) + 1;
}

/** Part of the file that holds marks: drawing, blocks or cover. */
export function part_of(scene: Scene): 'drawing' | 'blocks' | 'cover' | null {
  const { geometry } = scene;
  return geometry === 'drawing' || geometry === 'blocks' || geometry === 'cover' ? geometry : null;
}

/** Appends a row to a list, which is made if it does not exist. */
export function append(text: string, path: Path, value: Value): string {
  const list = find(parse(text), path);
  if (!list) return set(text, path, [value]);
  return splice(text, path, list.items.length, 0, [value]);
}

/** Reference to a joint material: its name if it has one, otherwise its number. */
export function material_of(names: string[], index: number, noun: string): string | number {
  const name = names[index];
  return name && name !== `${noun} ${index + 1}` ? name : index + 1;
}

/** Kinds whose corners at one place move together. */
const SHARED = ['outline', 'block'];

/** Moves single points. Corners of the outline, or of blocks, at the same place go with them. */
export function move_points(text: string, scene: Scene, moves: { item: Item; index: number; to: Point }[]): string {
  const all = new Map<string, { item: Item; index: number; to: Point }>();
  for (const move of moves) {
    all.set(`${move.item.key}:${move.index}`, move);
    // A block that moves as a whole leaves its neighbours.
    if (!SHARED.includes(move.item.kind) || (move.item.kind === 'block' && moves.length > 1)) continue;
    const from = move.item.points[move.index];
    for (const item of scene.items)
      if (item.kind === move.item.kind)
        item.points.forEach((own, index) => {
          const key = `${item.key}:${index}`;
          if (same(own, from) && !all.has(key)) all.set(key, { item, index, to: move.to });
        });
  }
  const changes: { path: Path; value: Value }[] = [];
  for (const { item, index, to } of all.values()) {
    coordinates_of(item, index).forEach((path, axis) => {
      const before = find(scene.root, path)?.value;
      changes.push({ path, value: length_as(before, to[axis], scene.length) });
    });
    const is_carried = (item.path[0] === 'blocks' || item.path[0] === 'cover') && item.kind !== 'block';
    const carried = is_carried ? block_at(scene, to) : 0;
    if (carried) changes.push({ path: [...item.path, item.kind === 'bolt' ? 4 + index : 2], value: carried });
  }
  return replace_many(text, scene, changes);
}

/** Replaces values at their places, from the last to the first. */
function replace_many(text: string, scene: Scene, changes: { path: Path; value: Value }[]): string {
  const places = changes
    .map(({ path, value }) => ({ node: find(scene.root, path), value }))
    .filter(own => own.node)
    .sort((a, b) => b.node!.from - a.node!.from);
  let result = text;
  for (const { node, value } of places) {
    if (node!.value === value) continue;
    result = result.slice(0, node!.from) + JSON.stringify(value) + result.slice(node!.to);
  }
  return result;
}

export function move_items(text: string, scene: Scene, items: Item[], dx: number, dy: number): string {
  return move_points(
    text,
    scene,
    items.flatMap(item =>
      item.points.map((point, index) => ({ item, index, to: [tidy(point[0] + dx), tidy(point[1] + dy)] as Point })),
    ),
  );
}

/** Compares paths so that later rows of a list come first. */
function later(a: Path, b: Path): number {
  for (let i = 0; i < Math.min(a.length, b.length); i++) {
    if (a[i] === b[i]) continue;
    return typeof a[i] === 'number' && typeof b[i] === 'number'
      ? Number(b[i]) - Number(a[i])
      : String(a[i]) < String(b[i])
        ? 1
        : -1;
  }
  return b.length - a.length;
}

/** Deletes items. Loads go with their forces, regions whole. */
export function remove_items(text: string, scene: Scene, items: Item[]): string {
  let result = text;
  // Points name blocks by their number: a block is removed in the text, where both can be seen.
  items = items.filter(own => own.kind !== 'block');
  const outlines = items.filter(own => own.kind === 'outline').length;
  for (const item of [...items].sort((a, b) => later(a.path, b.path))) {
    result = remove(result, item.is_list ? item.path.slice(0, -1) : item.path);
    if (item.kind === 'load') result = remove(result, ['analysis', 'point_loads', Number(item.path.at(-1))]);
  }
  if (outlines) result = set(result, ['drawing', 'boundary_count'], Math.max(0, scene.boundary_count - outlines));
  return result;
}

/** Sides of a closed chain as rows of joints. */
export function sides_of(corners: Point[], material: Value): Value[] {
  return corners.map((corner, i) => [...row(corner, corners[(i + 1) % corners.length]), material]);
}

/** Replaces the outline, with its openings, by a closed chain. */
export function set_outline(text: string, scene: Scene, corners: Point[], material: Value): string {
  let result = text;
  if (!find(scene.root, ['drawing', 'joints'])) result = set(result, ['drawing', 'joints'], []);
  result = splice(result, ['drawing', 'joints'], 0, scene.boundary_count, sides_of(corners, material));
  return set(result, ['drawing', 'boundary_count'], corners.length);
}

/** Adds an opening: a loop of the outline, and a point in it whose block is removed. */
export function add_opening(text: string, scene: Scene, corners: Point[], material: Value): string {
  let result = splice(text, ['drawing', 'joints'], scene.boundary_count, 0, sides_of(corners, material));
  result = set(result, ['drawing', 'boundary_count'], scene.boundary_count + corners.length);
  return append(result, ['drawing', 'hole_points'], row(inner_point(corners)));
}

/** A point inside a chain: the middle of the widest piece of a level line through it. */
export function inner_point(corners: Point[]): Point {
  const heights = corners.map(own => own[1]).sort((a, b) => a - b);
  // A level that meets no corner.
  let y = (heights[0] + heights.at(-1)!) / 2;
  let gap = 0;
  for (let i = 1; i < heights.length; i++)
    if (heights[i] - heights[i - 1] > gap) {
      gap = heights[i] - heights[i - 1];
      y = (heights[i] + heights[i - 1]) / 2;
    }
  const crossings: number[] = [];
  for (let i = 0; i < corners.length; i++) {
    const [a, b] = [corners[i], corners[(i + 1) % corners.length]];
    if (a[1] > y !== b[1] > y) crossings.push(a[0] + ((y - a[1]) * (b[0] - a[0])) / (b[1] - a[1]));
  }
  crossings.sort((a, b) => a - b);
  let [x, width] = [crossings[0] ?? corners[0][0], 0];
  for (let i = 0; i + 1 < crossings.length; i += 2)
    if (crossings[i + 1] - crossings[i] > width) {
      width = crossings[i + 1] - crossings[i];
      x = (crossings[i] + crossings[i + 1]) / 2;
    }
  return [x, y];
}

export function add_line(
  text: string,
  name: 'joints' | 'material_lines' | 'fixed_lines',
  from: Point,
  to: Point,
  material?: Value,
): string {
  return append(text, ['drawing', name], [...row(from, to), ...(material === undefined ? [] : [material])]);
}

/** Adds a point to a list; a point of blocks or a cover names the block or element that carries it. */
function add_mark(text: string, scene: Scene, name: string, point: Point): string {
  const part = part_of(scene);
  if (!part) return text;
  const carried = part === 'drawing' ? [] : [Math.max(1, block_at(scene, point))];
  return append(text, [part, name], [...row(point), ...carried]);
}

export const add_point = (text: string, scene: Scene, point: Point) => add_mark(text, scene, 'measured_points', point);
export const add_hole = (text: string, scene: Scene, point: Point) => add_mark(text, scene, 'hole_points', point);
export const add_fixed_point = (text: string, scene: Scene, point: Point) =>
  add_mark(text, scene, 'fixed_points', point);

/** Adds a constant force at a point, from the start of the run on. */
export function add_load(text: string, scene: Scene, point: Point, force: [Value, Value]): string {
  const part = part_of(scene);
  if (!part) return text;
  const index = find(scene.root, [part, 'loading_points'])?.items.length ?? 0;
  return set_force(add_mark(text, scene, 'loading_points', point), index, force);
}

/** Replaces the forces of a load by one that is constant in time. */
export function set_force(text: string, index: number, force: [Value, Value]): string {
  let result = text;
  const count = find(parse(result), ['analysis', 'point_loads'])?.items.length ?? 0;
  for (let i = count; i < index; i++) result = append(result, ['analysis', 'point_loads'], []);
  const rows: Value = [[0, force[0], force[1]]];
  return index < count
    ? set(result, ['analysis', 'point_loads', index], rows)
    : append(result, ['analysis', 'point_loads'], rows);
}

/** First force of a load, as written. */
export function force_of(scene: Scene, index: number): { rows: number; force: [Value, Value] } {
  const list = plain(find(scene.root, ['analysis', 'point_loads', index]));
  const first = Array.isArray(list) && Array.isArray(list[0]) ? list[0] : null;
  return { rows: Array.isArray(list) ? list.length : 0, force: [first?.[1] ?? 0, first?.[2] ?? 0] };
}

/** Adds a support or a traction along a line of the boundary of NMM bodies. */
export function add_chain(
  text: string,
  name: 'displacements' | 'tractions',
  from: Point,
  to: Point,
  values: Value,
): string {
  const own = { along: [row(from), row(to)], ...(values as Record<string, Value>) };
  return append(text, ['covers', name], own);
}

/** Adds the analysis that a geometry needs to run: usual values, with one entry per material that it names. */
export function add_analysis(text: string, rock: string): string {
  const scene = scene_of(text);
  const count_in = (lists: Path[]) =>
    Math.max(
      1,
      ...lists.flatMap(path =>
        (find(scene.root, path)?.items ?? []).map(row => {
          const own = row.kind === 'array' ? row.items.at(-1)?.value : find(row, ['material'])?.value;
          return typeof own === 'number' ? own : 1;
        }),
      ),
    );
  const corners = (find(scene.root, ['blocks', 'blocks'])?.items ?? []).flatMap(
    row => find(row, ['outer'])?.items ?? [],
  );
  const joints = Math.max(count_in([['drawing', 'joints']]), ...corners.map(row => Number(row.items[2]?.value) || 1));
  const rocks = count_in([
    ['drawing', 'material_lines'],
    ['blocks', 'blocks'],
  ]);
  let result = set(text, ['keyblock'], 2);
  const declares = (...keys: string[]) => keys.some(key => find(scene.root, ['units', key]));
  if (!declares('length')) result = set(result, ['units', 'length'], scene.length || 'm');
  if (!declares('mass', 'force', 'stress')) result = set(result, ['units', 'mass'], 'kg');
  if (!declares('time')) result = set(result, ['units', 'time'], 's');
  return set(result, ['analysis'], {
    step_count: 1000,
    time_step: '1 ms',
    gravity: '9.81 m/s2',
    block_materials: Array.from({ length: rocks }, (_, i) => ({ name: `rock ${i + 1}`, like: rock })),
    joint_materials: Array.from({ length: joints }, (_, i) => ({ name: `joint ${i + 1}`, friction_angle_deg: 30 })),
  });
}

export interface BoltValues {
  stiffness: Value;
  strength: Value;
  pretension: Value;
}

/** Adds a bolt to the drawing, the blocks, or a stage. */
export function add_bolt(
  text: string,
  scene: Scene,
  from: Point,
  to: Point,
  values: BoltValues,
  stage: number,
): string {
  const { stiffness, strength, pretension } = values;
  if (stage < 0 && scene.geometry === 'blocks')
    return append(
      text,
      ['blocks', 'bolts'],
      [
        ...row(from, to),
        Math.max(1, block_at(scene, from)),
        Math.max(1, block_at(scene, to)),
        stiffness,
        strength,
        pretension,
      ],
    );
  const bolt: Value = [...row(from, to), stiffness, strength, pretension, 1];
  return append(text, stage < 0 ? ['drawing', 'bolts'] : ['stages', stage, 'bolts'], bolt);
}

/** Adds a stage at the end. The first stage of a file is the state before any change. Returns its index, too. */
export function add_stage(text: string, name: string): { text: string; index: number } {
  const stage = (own: string): Value => ({ name: own, steps: 400, equilibrium: 0.001 });
  const count = find(parse(text), ['stages'])?.items.length ?? 0;
  const first = count ? text : append(text, ['stages'], stage('in situ'));
  const index = count || 1;
  return { text: append(first, ['stages'], stage(name)), index };
}

export function add_excavation(text: string, stage: number, corners: Point[], material: Value): string {
  return append(text, ['stages', stage, 'excavations'], {
    outline: corners.map(own => row(own)),
    joint_material: material,
  });
}

/** Fixed lines just inside base and upright sides of the outline; each ends outside it. */
export function support_lines(loop: Point[]): [Point, Point][] {
  const xs = loop.map(own => own[0]);
  const ys = loop.map(own => own[1]);
  const [left, right, bottom, top] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const size = Math.max(right - left, top - bottom);
  const round = (x: number) => Number(x.toPrecision(6));
  const near = size / 3000;
  const beyond = size / 30;
  const lines: [Point, Point][] = [];
  const sides = loop.map((own, i) => [own, loop[(i + 1) % loop.length]] as [Point, Point]);
  const level = sides.filter(([a, b]) => Math.abs(a[1] - bottom) < near && Math.abs(b[1] - bottom) < near);
  if (level.length) {
    const x = level.flat().map(own => own[0]);
    lines.push([
      [round(Math.min(...x) - beyond), round(bottom + near)],
      [round(Math.max(...x) + beyond), round(bottom + near)],
    ]);
  }
  for (const [side, inward] of [
    [left, near],
    [right, -near],
  ]) {
    const upright = sides.filter(([a, b]) => Math.abs(a[0] - side) < near && Math.abs(b[0] - side) < near);
    if (!upright.length) continue;
    const y = upright.flat().map(own => own[1]);
    lines.push([
      [round(side + inward), round(Math.min(...y) - beyond)],
      [round(side + inward), round(Math.max(...y) + beyond)],
    ]);
  }
  return lines;
}

/** Replaces all fixed lines by those of base and sides. */
export function fix_base_and_sides(text: string): string {
  const scene = scene_of(text);
  const [loop] = loops_of(scene);
  if (!loop) return text;
  const rows = support_lines(loop).map(([a, b]) => row(a, b));
  const count = find(scene.root, ['drawing', 'fixed_lines'])?.items.length ?? 0;
  return count ? splice(text, ['drawing', 'fixed_lines'], 0, count, rows) : set(text, ['drawing', 'fixed_lines'], rows);
}

/** Replaces the first `count` joints behind the outline. */
export function put_joints(text: string, rows: Value[], count: number): string {
  const scene = scene_of(text);
  const joints = find(scene.root, ['drawing', 'joints'])?.items.length ?? 0;
  const from = scene.boundary_count;
  return splice(text, ['drawing', 'joints'], from, Math.min(count, joints - from), rows);
}
