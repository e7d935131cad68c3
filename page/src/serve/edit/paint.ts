// Paints the drawing of a case on a canvas.

import { type Camera, type Size, to_screen, to_world } from '../../draw/camera';
import { areas_of, lines_of } from '../../draw/colours';
import { multiples } from '../../draw/numbers';
import { arrow } from '../../draw/paint';
import { CanvasPen, type Line } from '../../draw/pen';
import { flat_loops, type Item, type Kind, type Point, type Polygon, type Scene } from './scene';
import type { Snapped } from './snap';

export interface Colours {
  ink: string;
  muted: string;
  rim: string;
  accent: string;
  bad: string;
  good: string;
  warn: string;
  surface: string;
  fixed: string;
  is_dark: boolean;
}

export function colours_of(element: Element): Colours {
  const style = getComputedStyle(element);
  const own = (name: string) => style.getPropertyValue(`--${name}`).trim();
  const is_dark = document.documentElement.dataset.theme === 'dark';
  return {
    ink: own('ink'),
    muted: own('muted'),
    rim: own('rim'),
    accent: own('accent'),
    bad: own('bad'),
    good: own('good'),
    warn: own('warn'),
    surface: own('surface'),
    fixed: is_dark ? '#8fb0ff' : '#2a4fb5',
    is_dark,
  };
}

/** Colour of the material of a number from 1 on. */
const of = (colours: string[], number: number) => colours[(Math.max(1, number) - 1) % colours.length];

export interface Picture {
  scene: Scene;
  blocks: Polygon[];
  view: Camera;
  size: Size;
  grid: number;
  chosen: ReadonlySet<string>;
  hovered: string;
  /** Number of the joint material of items. */
  material: (item: Item) => number;
  /** Force of a load, if it is known; for the direction of its arrow. */
  force: (item: Item) => Point | null;
  /** Items that are being dragged, at their new places. */
  moved: Map<string, Point[]>;
  draft: Point[];
  is_draft_closed: boolean;
  pointer: Snapped | null;
  box: [Point, Point] | null;
  has_numbers: boolean;
}

/** Look of items that are lines of one colour: that colour, width in pixels, dashes. */
const LINES: Partial<Record<Kind, { colour: 'ink' | 'good' | 'bad'; width: number; dash?: number[] }>> = {
  outline: { colour: 'ink', width: 2 },
  material_line: { colour: 'good', width: 1.5, dash: [8, 3, 2, 3] },
  traction: { colour: 'bad', width: 3, dash: [4, 3] },
  crack: { colour: 'ink', width: 2.5 },
};

class Painter {
  private readonly pen: CanvasPen;

  constructor(
    c: CanvasRenderingContext2D,
    readonly p: Picture,
    readonly own: Colours,
  ) {
    this.pen = new CanvasPen(c);
    c.lineJoin = 'round';
  }

  at([x, y]: Point): Point {
    return to_screen(this.p.view, this.p.size, x, y);
  }

  flat(points: Point[]): number[] {
    return points.flatMap(point => this.at(point));
  }

  line(points: Point[], colour: string, width: number, dash: number[] = [], is_closed = false): void {
    const own = is_closed ? [...points, ...points.slice(0, 1)] : points;
    this.pen.polyline(this.flat(own), { colour, width, dash });
  }

  grid(): void {
    const { own, pen } = this;
    const { view, size, grid } = this.p;
    if (!(grid > 0)) return;
    const [left, top] = to_world(view, size, 0, 0);
    const [right, bottom] = to_world(view, size, size.width, size.height);
    if ((right - left) / grid > 400) return;
    const every = grid * view.scale < 34 ? (grid * view.scale < 15 ? 5 : 2) : 1;
    const texts: { x: number; y: number; i: number; anchor: 'start' | 'middle' }[] = [];
    const lines = { thin: [] as number[], thick: [] as number[] };
    for (const i of multiples(grid, left, right)) {
      const [x] = this.at([i * grid, 0]);
      lines[i % 5 ? 'thin' : 'thick'].push(x, 0, x, size.height);
      if (i % every === 0 && x > 40 && x < size.width - 16) texts.push({ x, y: size.height - 4, i, anchor: 'middle' });
    }
    for (const i of multiples(grid, bottom, top)) {
      const [, y] = this.at([0, i * grid]);
      lines[i % 5 ? 'thin' : 'thick'].push(0, y, size.width, y);
      if (i % every === 0 && y > 12 && y < size.height - 16) texts.push({ x: 3, y: y - 2, i, anchor: 'start' });
    }
    pen.segments(lines.thin, { colour: own.rim, width: 0.5, opacity: 0.7 });
    pen.segments(lines.thick, { colour: own.rim, width: 1, opacity: 0.7 });
    for (const { x, y, i, anchor } of texts)
      pen.text(x, y, String(Number((i * grid).toPrecision(8))), { size: 10, colour: own.muted, anchor });
  }

  blocks(): void {
    const { own, p, pen } = this;
    const polygons = p.blocks.length ? p.blocks : p.scene.polygons;
    const rim = { colour: own.is_dark ? '#6a7584' : '#8b8371', width: 0.6 };
    for (const { material, loops } of polygons) {
      const { places, starts } = flat_loops(loops.map(loop => loop.map(point => this.at(point))));
      pen.area(places, starts, 0, loops.length, of(areas_of(own.is_dark), material));
      pen.loops(places, starts, 0, loops.length, rim);
    }
    if (!p.has_numbers) return;
    polygons.forEach(({ loops: [loop] }, i) => {
      const [x, y] = [0, 1].map(axis => loop.reduce((sum, point) => sum + point[axis], 0) / loop.length);
      const [sx, sy] = this.at([x, y]);
      pen.text(sx, sy + 4, String(i + 1), { size: 11, colour: own.ink, anchor: 'middle' });
    });
  }

  disc(point: Point, radius: number, fill: string, rim?: string): void {
    const [x, y] = this.at(point);
    this.pen.circle(x, y, radius, fill, rim ? { colour: rim, width: 1.5 } : null);
  }

  cross([x, y]: Point, half: number, colour: string, width: number): void {
    const ends = [x - half, y - half, x + half, y + half, x + half, y - half, x - half, y + half];
    this.pen.segments(ends, { colour, width });
  }

  force(point: Point, direction: Point | null, colour: string): void {
    const length = direction ? Math.hypot(...direction) : 0;
    if (!direction || !(length > 0)) {
      this.disc(point, 5, colour, this.own.surface);
      return;
    }
    const [x, y] = this.at(point);
    this.disc(point, 3.5, colour);
    const [dx, dy] = [(38 * direction[0]) / length, (-38 * direction[1]) / length];
    arrow(this.pen, x, y, x + dx, y + dy, { colour, width: 2.5 });
  }

  /** Line with hatches on its right. */
  hatched(points: Point[], colour: string, width: number): void {
    this.line(points, colour, width);
    const ends: number[] = [];
    for (let i = 0; i + 1 < points.length; i++) {
      const [a, b] = [this.at(points[i]), this.at(points[i + 1])];
      const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
      if (length < 1) continue;
      const [ux, uy] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
      for (let s = 5; s < length; s += 9) {
        const [x, y] = [a[0] + s * ux, a[1] + s * uy];
        ends.push(x, y, x - 5 * ux - 6 * uy, y - 5 * uy + 6 * ux);
      }
    }
    this.pen.segments(ends, { colour, width: 1 });
  }

  item(item: Item, is_chosen: boolean, is_hovered = false): void {
    const { own, p } = this;
    const points = p.moved.get(item.key) ?? item.points;
    const more = is_chosen ? 1.8 : is_hovered ? 1 : 0;
    const colour = (usual: string) => (is_chosen ? own.accent : usual);
    const line = LINES[item.kind];
    if (line) {
      this.line(points, colour(own[line.colour]), line.width + more, line.dash);
      return;
    }
    switch (item.kind) {
      case 'block':
        // The block itself is drawn below.
        if (more || p.moved.has(item.key)) this.line(points, colour(own.ink), 0.6 + more, [], true);
        return;
      case 'joint':
      case 'cut': {
        const dash = item.kind === 'cut' ? [2, 4] : [];
        this.line(points, colour(of(lines_of(own.is_dark), p.material(item))), 1.4 + more, dash);
        return;
      }
      case 'fixed_line':
      case 'support':
        this.hatched(points, colour(own.fixed), 1.7 + more);
        return;
      case 'bolt':
        this.line(points, colour(own.good), 3 + more);
        for (const end of points) this.disc(end, 3.5 + more / 2, colour(own.good));
        return;
      case 'fixed_point':
        this.disc(points[0], 5 + more / 2, colour(own.fixed), own.surface);
        return;
      case 'load':
      case 'force':
        this.force(points[0], p.force(item), colour(own.bad));
        return;
      case 'point':
        this.disc(points[0], 4.5 + more / 2, own.surface, colour(own.ink));
        this.disc(points[0], 1.5, colour(own.ink));
        return;
      case 'hole':
        this.cross(this.at(points[0]), 5, colour(own.bad), 2 + more);
        return;
      case 'excavation':
      case 'region': {
        const usual = colour(item.kind === 'excavation' ? own.warn : own.good);
        this.pen.polygon(this.flat(points), usual, is_chosen ? 0.25 : 0.14);
        this.line(points, usual, 1.8 + more, [6, 4], true);
        return;
      }
    }
  }

  draft(): void {
    const { own, p, pen } = this;
    const { draft, pointer } = p;
    const points = pointer && draft.length ? [...draft, pointer.point] : draft;
    if (p.is_draft_closed && points.length > 2) pen.polygon(this.flat(points), own.accent, 0.12);
    if (points.length > 1) this.line(points, own.accent, 2);
    for (const point of draft) this.disc(point, 4, own.surface, own.accent);
    if (!pointer) return;
    const [x, y] = this.at(pointer.point);
    const line = { colour: own.accent, width: 1.5 };
    if (pointer.kind === 'end') this.frame(x - 6, y - 6, x + 6, y + 6, line);
    else if (pointer.kind === 'crossing') this.cross([x, y], 6, own.accent, 1.5);
    else if (pointer.kind === 'line') pen.circle(x, y, 6, null, line);
    else pen.segments([x - 6, y, x + 6, y, x, y - 6, x, y + 6], line);
  }

  frame(left: number, top: number, right: number, bottom: number, line: Line): void {
    this.pen.loops([left, top, right, top, right, bottom, left, bottom], [0, 4], 0, 1, line);
  }

  handles(item: Item): void {
    for (const point of this.p.moved.get(item.key) ?? item.points) {
      const [x, y] = this.at(point);
      this.pen.box(x - 4, y - 4, 8, 8, this.own.surface);
      this.frame(x - 4, y - 4, x + 4, y + 4, { colour: this.own.accent, width: 1.5 });
    }
  }

  /** The part that does not change with the pointer. */
  ground(): void {
    const { own, p } = this;
    this.pen.box(0, 0, p.size.width, p.size.height, own.surface);
    this.blocks();
    this.grid();
    const under = (item: Item) => (item.is_closed ? 0 : item.kind === 'outline' ? 2 : item.points.length > 1 ? 1 : 3);
    const items = [...p.scene.items].sort((a, b) => under(a) - under(b));
    for (const item of items) if (!p.chosen.has(item.key)) this.item(item, false);
    for (const item of items)
      if (p.chosen.has(item.key)) {
        this.item(item, true);
        if (p.chosen.size <= 12) this.handles(item);
      }
  }

  above(): void {
    const { own, p } = this;
    const hovered = p.hovered && !p.chosen.has(p.hovered) && p.scene.items.find(one => one.key === p.hovered);
    if (hovered) this.item(hovered, false, true);
    if (p.box) {
      const [a, b] = p.box.map(corner => this.at(corner));
      this.frame(a[0], a[1], b[0], b[1], { colour: own.accent, width: 1, dash: [4, 3] });
    }
    this.draft();
  }
}

/** Picture without the pointer, kept while nothing in it changes. */
export class Ground {
  private readonly canvas = document.createElement('canvas');
  private made_of: unknown[] = [];

  paint(c: CanvasRenderingContext2D, picture: Picture, colours: Colours): void {
    const { scene, blocks, view, size, grid, chosen, moved, has_numbers } = picture;
    const { width, height } = size;
    const ratio = window.devicePixelRatio || 1;
    const now = [scene, blocks, view, size, grid, chosen, moved, has_numbers, colours.ink, ratio];
    if (now.some((own, i) => own !== this.made_of[i])) {
      this.made_of = now;
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
      const own = this.canvas.getContext('2d')!;
      own.setTransform(ratio, 0, 0, ratio, 0, 0);
      new Painter(own, picture, colours).ground();
    }
    c.drawImage(this.canvas, 0, 0, width, height);
    new Painter(c, picture, colours).above();
  }
}
