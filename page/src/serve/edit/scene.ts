// Drawing of a case file as items that a canvas shows and moves. The text stays the truth: each item knows its path.

import { add_places, type Box, empty_box } from '../../draw/camera';
import { is_inside } from '../../draw/rings';
import { find, type Node, type Path, parse, plain, type Value } from './case_text';

export type Point = [number, number];

export type Kind =
  | 'block'
  | 'outline'
  | 'joint'
  | 'material_line'
  | 'bolt'
  | 'fixed_line'
  | 'fixed_point'
  | 'load'
  | 'force'
  | 'point'
  | 'hole'
  | 'excavation'
  | 'cut'
  | 'region'
  | 'support'
  | 'traction'
  | 'crack';

export interface Item {
  /** Path as text: the same as long as rows before it stay. */
  key: string;
  kind: Kind;
  path: Path;
  points: Point[];
  is_closed: boolean;
  /** True if the path leads to a list of points, false if to a row of numbers. */
  is_list: boolean;
  /** Index of the stage that it belongs to, -1 if it is there from the start. */
  stage: number;
}

export interface Polygon {
  material: number;
  loops: Point[][];
}

export type Geometry = 'drawing' | 'blocks' | 'cover' | 'file' | 'none';

export interface Scene {
  geometry: Geometry;
  items: Item[];
  /** Blocks or elements that the text itself holds. */
  polygons: Polygon[];
  boundary_count: number;
  /** True if the case has bodies of the manifold method besides blocks. */
  has_covers: boolean;
  length: string;
  block_materials: string[];
  joint_materials: string[];
  stages: string[];
  root: Node;
}

const METRES: Record<string, number> = {
  m: 1,
  mm: 1e-3,
  cm: 1e-2,
  dm: 0.1,
  km: 1e3,
  in: 0.0254,
  ft: 0.3048,
  yd: 0.9144,
};

/** Splits "2.5 m" into number and unit. */
export function quantity_of(value: unknown): { number: number; unit: string } | null {
  if (typeof value === 'number') return { number: value, unit: '' };
  const found = typeof value === 'string' ? /^\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*(\S*)\s*$/.exec(value) : null;
  return found && Number.isFinite(Number(found[1])) ? { number: Number(found[1]), unit: found[2] } : null;
}

/** A typed value: a number, or a text with its unit. */
export function value_of(text: string): Value {
  const own = text.trim();
  return own !== '' && Number.isFinite(Number(own)) ? Number(own) : own;
}

/** Returns a length in the unit of the file, NaN if it is none. */
export function length_of(value: unknown, unit: string): number {
  const own = quantity_of(value);
  if (!own) return Number.NaN;
  if (!own.unit || own.unit === unit) return own.number;
  return own.unit in METRES && unit in METRES ? (own.number * METRES[own.unit]) / METRES[unit] : Number.NaN;
}

/** Returns the value to write for a length, with the unit that stood there before. */
export function length_as(before: unknown, value: number, unit: string): number | string {
  const own = quantity_of(before);
  const round = (x: number) => Number(x.toPrecision(12));
  if (!own?.unit || !(own.unit in METRES) || !(unit in METRES)) return round(value);
  return `${round((value * METRES[unit]) / METRES[own.unit])} ${own.unit}`;
}

class Reader {
  readonly items: Item[] = [];
  constructor(
    readonly root: Node,
    readonly unit: string,
  ) {}

  points_of(row: Node | undefined, count: number): Point[] | null {
    if (row?.kind !== 'array') return null;
    const numbers = row.items.slice(0, 2 * count).map(own => length_of(own.value, this.unit));
    if (numbers.length < 2 * count || numbers.some(Number.isNaN)) return null;
    return Array.from({ length: count }, (_, i) => [numbers[2 * i], numbers[2 * i + 1]]);
  }

  add(kind: Kind, path: Path, points: Point[] | null, stage: number, is_list = false, is_closed = is_list): void {
    if (points?.length) this.items.push({ key: path.join('/'), kind, path, points, is_closed, is_list, stage });
  }

  rows(kind: Kind | ((i: number) => Kind), path: Path, count: number, stage = -1): void {
    const list = find(this.root, path);
    if (list?.kind !== 'array') return;
    list.items.forEach((row, i) => {
      this.add(typeof kind === 'function' ? kind(i) : kind, [...path, i], this.points_of(row, count), stage);
    });
  }

  corners(node: Node | undefined): Point[] | null {
    if (node?.kind !== 'array') return null;
    const points = node.items.map(row => this.points_of(row, 1)?.[0]);
    return points.every(own => own !== undefined) ? (points as Point[]) : null;
  }

  /** Chains of points of NMM bodies: loads and supports along their boundary, and cracks. */
  chains(kind: Kind, path: Path): void {
    find(this.root, path)?.items.forEach((_, i) => {
      const own: Path = [...path, i, 'along'];
      this.add(kind, own, this.corners(find(this.root, own)), -1, true, false);
    });
  }

  regions(kind: Kind, path: Path, stage: number): void {
    find(this.root, path)?.items.forEach((_, i) => {
      const own: Path = [...path, i, 'outline'];
      this.add(kind, own, this.corners(find(this.root, own)), stage, true);
    });
  }

  /** Corners of blocks and of their holes. */
  blocks(): void {
    find(this.root, ['blocks', 'blocks'])?.items.forEach((row, i) => {
      const own: Path = ['blocks', 'blocks', i];
      this.add('block', [...own, 'outer'], this.corners(find(row, ['outer'])), -1, true);
      find(row, ['holes'])?.items.forEach((hole, j) => {
        this.add('block', [...own, 'holes', j], this.corners(hole), -1, true);
      });
    });
  }

  /** Elements of a cover: chains of its vertex slots. */
  elements(): Polygon[] {
    const slots = this.corners(find(this.root, ['cover', 'vertices'])) ?? [];
    const rows = find(this.root, ['cover', 'elements'])?.items ?? [];
    return rows.flatMap(row => {
      const [first, size, material] = row.items.map(own => Number(own.value));
      const loop = slots.slice(first - 1, first - 1 + size);
      return loop.length > 2 ? [{ material: material || 1, loops: [loop] }] : [];
    });
  }

  polygons(): Polygon[] {
    const rows = find(this.root, ['blocks', 'blocks'])?.items ?? [];
    const found: Polygon[] = [];
    for (const row of rows) {
      const outer = this.corners(find(row, ['outer']));
      if (!outer) continue;
      const holes = (find(row, ['holes'])?.items ?? []).map(own => this.corners(own)).filter(own => own !== null);
      const material = find(row, ['material'])?.value;
      found.push({ material: typeof material === 'number' ? material : 1, loops: [outer, ...holes] });
    }
    return found;
  }
}

function names_of(root: Node, path: Path, noun: string): string[] {
  const list = find(root, path);
  if (list?.kind !== 'array') return [];
  return list.items.map((row, i) => String(find(row, ['name'])?.value ?? `${noun} ${i + 1}`));
}

/** Reads the drawing of a case. Throws JsonError if the text is no JSON. */
export function scene_of(text: string): Scene {
  const root = parse(text);
  const length = String(find(root, ['units', 'length'])?.value ?? '');
  const reader = new Reader(root, length);
  const drawing = find(root, ['drawing']);
  const geometry: Geometry = drawing
    ? drawing.kind === 'object'
      ? 'drawing'
      : 'file'
    : find(root, ['blocks'])
      ? 'blocks'
      : find(root, ['cover'])
        ? 'cover'
        : 'none';
  const count = plain(find(root, ['drawing', 'boundary_count']));
  const boundary_count = typeof count === 'number' ? count : 0;
  reader.rows(i => (i < boundary_count ? 'outline' : 'joint'), ['drawing', 'joints'], 2);
  reader.rows('material_line', ['drawing', 'material_lines'], 2);
  reader.rows('fixed_line', ['drawing', 'fixed_lines'], 2);
  reader.rows('hole', ['drawing', 'hole_points'], 1);
  for (const part of ['drawing', 'blocks', 'cover']) {
    reader.rows('bolt', [part, 'bolts'], 2);
    reader.rows('fixed_point', [part, 'fixed_points'], 1);
    reader.rows('load', [part, 'loading_points'], 1);
    reader.rows('point', [part, 'measured_points'], 1);
  }
  reader.blocks();
  reader.rows('force', ['covers', 'forces'], 1);
  reader.chains('support', ['covers', 'displacements']);
  reader.chains('traction', ['covers', 'tractions']);
  reader.chains('crack', ['covers', 'cracks']);
  find(root, ['stages'])?.items.forEach((_, i) => {
    reader.regions('excavation', ['stages', i, 'excavations'], i);
    reader.regions('region', ['stages', i, 'block_materials'], i);
    reader.regions('region', ['stages', i, 'released'], i);
    reader.rows('cut', ['stages', i, 'cuts'], 2, i);
    reader.rows('bolt', ['stages', i, 'bolts'], 2, i);
    reader.rows('fixed_point', ['stages', i, 'held_points'], 1, i);
    reader.rows('force', ['stages', i, 'forces'], 1, i);
  });
  return {
    geometry,
    items: reader.items,
    polygons: geometry === 'cover' ? reader.elements() : reader.polygons(),
    boundary_count,
    has_covers: find(root, ['covers']) !== undefined,
    length,
    block_materials: names_of(root, ['analysis', 'block_materials'], 'material'),
    joint_materials: names_of(root, ['analysis', 'joint_materials'], 'joint'),
    stages: names_of(root, ['stages'], 'stage'),
    root,
  };
}

/** Paths of the two coordinates of a point of an item. */
export function coordinates_of(item: Item, index: number): [Path, Path] {
  if (item.is_list)
    return [
      [...item.path, index, 0],
      [...item.path, index, 1],
    ];
  return [
    [...item.path, 2 * index],
    [...item.path, 2 * index + 1],
  ];
}

/** Closed chains of the outline: corners in order. Pieces that do not close are left out. */
export function loops_of(scene: Scene): Point[][] {
  const loops: Point[][] = [];
  let chain: Point[] = [];
  const near = (a: Point, b: Point) =>
    Math.hypot(a[0] - b[0], a[1] - b[1]) <= 1e-9 * (1 + Math.abs(a[0]) + Math.abs(a[1]));
  for (const item of scene.items) {
    if (item.kind !== 'outline') continue;
    const [start, end] = item.points;
    if (!chain.length || !near(chain.at(-1)!, start)) chain = [start];
    if (chain.length > 1 && near(chain[0], end)) {
      loops.push(chain);
      chain = [];
    } else chain.push(end);
  }
  return loops;
}

/** Vertices of loops, x, y in turn; loop l has those from starts[l] on. */
export function flat_loops(loops: Point[][]): { places: number[]; starts: number[] } {
  const starts = [0];
  for (const loop of loops) starts.push(starts.at(-1)! + loop.length);
  return { places: loops.flat(2), starts };
}

export function is_within(loops: Point[][], [x, y]: Point): boolean {
  const { places, starts } = flat_loops(loops);
  return is_inside(places, starts, 0, loops.length, x, y);
}

/** Box around points, if there are any. */
export function box_of(points: Point[]): Box | null {
  const box = empty_box();
  add_places(box, points.flat());
  return points.length ? box : null;
}

/** Box around what matters of a scene: outline and blocks, otherwise all items. */
export function extent_of(scene: Scene, polygons: Polygon[]): Box | null {
  const solid = [
    ...scene.items.filter(own => own.kind === 'outline').flatMap(own => own.points),
    ...[...scene.polygons, ...polygons].flatMap(own => own.loops.flat()),
  ];
  return box_of(solid.length ? solid : scene.items.flatMap(own => own.points));
}

export const WORDS: Record<Kind, string> = {
  block: 'Block',
  outline: 'Outline',
  joint: 'Joint',
  material_line: 'Material line',
  bolt: 'Bolt',
  fixed_line: 'Fixed line',
  fixed_point: 'Fixed point',
  load: 'Load',
  force: 'Force',
  point: 'Measured point',
  hole: 'Hole point',
  excavation: 'Excavation',
  cut: 'Cut',
  region: 'Region',
  support: 'Support',
  traction: 'Traction',
  crack: 'Crack',
};

/** Name of an item for people: its kind and number. */
export function title_of(item: Item): string {
  if (item.kind === 'block') {
    const block = `Block ${Number(item.path[2]) + 1}`;
    return item.path.length > 4 ? `Hole ${Number(item.path[4]) + 1} of block ${Number(item.path[2]) + 1}` : block;
  }
  const index = item.is_list ? item.path.at(-2) : item.path.at(-1);
  return `${WORDS[item.kind]} ${Number(index) + 1}${item.stage < 0 ? '' : ` of stage ${item.stage + 1}`}`;
}
