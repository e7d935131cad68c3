// Finds the place that a pointer means: an end, a crossing, a line or the grid near it.

import type { Point, Scene } from './scene';

export type SnapKind = 'end' | 'crossing' | 'line' | 'grid' | 'free';

export interface Snapped {
  point: Point;
  kind: SnapKind;
}

export interface Segment {
  from: Point;
  to: Point;
}

/** Sides of all items, without those that are left out. */
export function segments_of(scene: Scene, left_out: ReadonlySet<string> = new Set()): Segment[] {
  const found: Segment[] = [];
  for (const item of scene.items) {
    if (left_out.has(item.key)) continue;
    const { points } = item;
    for (let i = 0; i + 1 < points.length; i++) found.push({ from: points[i], to: points[i + 1] });
    if (item.is_closed && points.length > 2) found.push({ from: points.at(-1)!, to: points[0] });
  }
  return found;
}

const distance = (a: Point, b: Point) => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** Nearest point of a segment. */
export function foot_of({ from, to }: Segment, p: Point): Point {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = dx * dx + dy * dy;
  const t = length === 0 ? 0 : Math.max(0, Math.min(1, ((p[0] - from[0]) * dx + (p[1] - from[1]) * dy) / length));
  return [from[0] + t * dx, from[1] + t * dy];
}

/** Crossing of two segments, null if they do not cross in one point. */
export function crossing_of(a: Segment, b: Segment): Point | null {
  const [dx, dy] = [a.to[0] - a.from[0], a.to[1] - a.from[1]];
  const [ex, ey] = [b.to[0] - b.from[0], b.to[1] - b.from[1]];
  const sine = dx * ey - dy * ex;
  if (Math.abs(sine) < 1e-12 * Math.hypot(dx, dy) * Math.hypot(ex, ey) || sine === 0) return null;
  const [fx, fy] = [b.from[0] - a.from[0], b.from[1] - a.from[1]];
  const t = (fx * ey - fy * ex) / sine;
  const u = (fx * dy - fy * dx) / sine;
  return t >= 0 && t <= 1 && u >= 0 && u <= 1 ? [a.from[0] + t * dx, a.from[1] + t * dy] : null;
}

/** Rounds a place to what a pointer can tell apart. */
export function rounded(p: Point, pixel: number): Point {
  const power = 10 ** Math.floor(Math.log10(pixel));
  const round = (x: number) => Number((Math.round(x / power) * power).toPrecision(12));
  return [round(p[0]), round(p[1])];
}

export interface SnapOptions {
  /** Distance within which places count. */
  reach: number;
  /** Step of the grid; 0: no grid. */
  grid: number;
  is_on: boolean;
  /** Size of a pixel. */
  pixel: number;
  /** More places that count as ends. */
  ends?: Point[];
}

export function snap(p: Point, segments: Segment[], points: Point[], options: SnapOptions): Snapped {
  const { reach, grid, pixel } = options;
  if (!options.is_on) return { point: rounded(p, pixel), kind: 'free' };
  let best: Point | null = null;
  let least = reach;
  const consider = (q: Point) => {
    const own = distance(p, q);
    if (own <= least) {
      least = own;
      best = q;
    }
  };
  for (const { from, to } of segments) {
    consider(from);
    consider(to);
  }
  for (const q of [...points, ...(options.ends ?? [])]) consider(q);
  if (best) return { point: best, kind: 'end' };
  const near = segments.filter(own => distance(p, foot_of(own, p)) <= reach).slice(0, 60);
  for (let i = 0; i < near.length; i++)
    for (let j = i + 1; j < near.length; j++) {
      const q = crossing_of(near[i], near[j]);
      if (q) consider(q);
    }
  const clean = (q: Point): Point => [Number(q[0].toPrecision(10)), Number(q[1].toPrecision(10))];
  if (best) return { point: clean(best), kind: 'crossing' };
  const on_grid: Point | null = grid > 0 ? [on(p[0], grid), on(p[1], grid)] : null;
  if (on_grid && distance(p, on_grid) <= reach * 0.6) return { point: on_grid, kind: 'grid' };
  for (const own of near) consider(foot_of(own, p));
  if (best) return { point: clean(best), kind: 'line' };
  if (on_grid && distance(p, on_grid) <= reach) return { point: on_grid, kind: 'grid' };
  return { point: rounded(p, pixel), kind: 'free' };
}

function on(x: number, grid: number): number {
  return Number((Math.round(x / grid) * grid).toPrecision(12)) + 0;
}

/** Reads a typed place: "3, 4", "@1, 2" from the last point, or "5 < 30" as length and angle in degrees from it. */
export function typed_point(text: string, last: Point | null): Point | null {
  const number = '\\s*([-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?)\\s*';
  const polar = new RegExp(`^@?${number}<${number}$`).exec(text);
  const tidy = (x: number) => Number(x.toPrecision(10));
  if (polar) {
    const [length, angle] = [Number(polar[1]), (Number(polar[2]) * Math.PI) / 180];
    const [x, y] = last ?? [0, 0];
    return [tidy(x + length * Math.cos(angle)), tidy(y + length * Math.sin(angle))];
  }
  const plain = new RegExp(`^\\s*(@?)${number}(?:[,;]|\\s)${number}$`).exec(text);
  if (!plain) return null;
  const [x, y] = plain[1] ? (last ?? [0, 0]) : [0, 0];
  return [tidy(x + Number(plain[2])), tidy(y + Number(plain[3]))];
}
