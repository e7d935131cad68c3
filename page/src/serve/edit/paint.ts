// Paints the drawing of a case on a canvas.

import { areas_of, lines_of } from '../../draw/colours';
import { multiples } from '../../draw/numbers';
import type { Item, Point, Polygon, Scene } from './scene';
import type { Snapped } from './snap';

/** Place at the middle of the canvas and pixels per unit of length. */
export interface View {
  x: number;
  y: number;
  scale: number;
}

export interface Colours {
  ink: string;
  muted: string;
  rim: string;
  accent: string;
  bad: string;
  good: string;
  warn: string;
  surface: string;
  back: string;
  is_dark: boolean;
}

export function colours_of(element: Element): Colours {
  const style = getComputedStyle(element);
  const own = (name: string) => style.getPropertyValue(`--${name}`).trim();
  return {
    ink: own('ink'),
    muted: own('muted'),
    rim: own('rim'),
    accent: own('accent'),
    bad: own('bad'),
    good: own('good'),
    warn: own('warn'),
    surface: own('surface'),
    back: own('back'),
    is_dark: document.documentElement.dataset.theme === 'dark',
  };
}

/** Colour of the material of a number from 1 on. */
const of = (colours: string[], number: number) => colours[(Math.max(1, number) - 1) % colours.length];

export interface Picture {
  scene: Scene;
  blocks: Polygon[];
  view: View;
  width: number;
  height: number;
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

class Painter {
  constructor(
    readonly c: CanvasRenderingContext2D,
    readonly p: Picture,
    readonly own: Colours,
  ) {}

  at([x, y]: Point): Point {
    const { view, width, height } = this.p;
    return [width / 2 + (x - view.x) * view.scale, height / 2 - (y - view.y) * view.scale];
  }

  trace(points: Point[], is_closed: boolean): void {
    points.forEach((own, i) => {
      const [x, y] = this.at(own);
      if (i) this.c.lineTo(x, y);
      else this.c.moveTo(x, y);
    });
    if (is_closed) this.c.closePath();
  }

  line(points: Point[], colour: string, width: number, dash: number[] = [], is_closed = false): void {
    const { c } = this;
    c.beginPath();
    this.trace(points, is_closed);
    c.strokeStyle = colour;
    c.lineWidth = width;
    c.setLineDash(dash);
    c.stroke();
    c.setLineDash([]);
  }

  grid(): void {
    const { c, own } = this;
    const { view, width, height, grid } = this.p;
    if (!(grid > 0)) return;
    const [left, right] = [view.x - width / 2 / view.scale, view.x + width / 2 / view.scale];
    const [bottom, top] = [view.y - height / 2 / view.scale, view.y + height / 2 / view.scale];
    if ((right - left) / grid > 400) return;
    c.font = '10px system-ui, sans-serif';
    c.fillStyle = own.muted;
    const label = (value: number) => String(Number(value.toPrecision(8)));
    const every = grid * view.scale < 34 ? (grid * view.scale < 15 ? 5 : 2) : 1;
    for (const i of multiples(grid, left, right)) {
      const [x] = this.at([i * grid, 0]);
      this.line(
        [
          [i * grid, bottom],
          [i * grid, top],
        ],
        own.rim,
        i % 5 ? 0.5 : 1,
      );
      if (i % every === 0 && x > 40 && x < width - 16) {
        c.textAlign = 'center';
        c.fillText(label(i * grid), x, height - 4);
      }
    }
    for (const i of multiples(grid, bottom, top)) {
      const [, y] = this.at([0, i * grid]);
      this.line(
        [
          [left, i * grid],
          [right, i * grid],
        ],
        own.rim,
        i % 5 ? 0.5 : 1,
      );
      if (i % every === 0 && y > 12 && y < height - 16) {
        c.textAlign = 'left';
        c.fillText(label(i * grid), 3, y - 2);
      }
    }
  }

  blocks(): void {
    const { c, own, p } = this;
    const polygons = p.blocks.length ? p.blocks : p.scene.polygons;
    c.lineWidth = 0.6;
    c.strokeStyle = own.is_dark ? '#6a7584' : '#8b8371';
    for (const { material, loops } of polygons) {
      c.beginPath();
      for (const loop of loops) this.trace(loop, true);
      c.fillStyle = of(areas_of(own.is_dark), material);
      c.fill('evenodd');
      c.stroke();
    }
    if (!p.has_numbers) return;
    c.font = '11px system-ui, sans-serif';
    c.textAlign = 'center';
    c.fillStyle = own.ink;
    polygons.forEach(({ loops }, i) => {
      const [loop] = loops;
      const middle: Point = [
        loop.reduce((sum, q) => sum + q[0], 0) / loop.length,
        loop.reduce((sum, q) => sum + q[1], 0) / loop.length,
      ];
      const [x, y] = this.at(middle);
      c.fillText(String(i + 1), x, y + 4);
    });
  }

  disc(point: Point, radius: number, fill: string, rim?: string): void {
    const { c } = this;
    const [x, y] = this.at(point);
    c.beginPath();
    c.arc(x, y, radius, 0, 2 * Math.PI);
    c.fillStyle = fill;
    c.fill();
    if (!rim) return;
    c.strokeStyle = rim;
    c.lineWidth = 1.5;
    c.stroke();
  }

  arrow(point: Point, direction: Point | null, colour: string): void {
    const { c } = this;
    const length = direction ? Math.hypot(direction[0], direction[1]) : 0;
    if (!direction || !(length > 0)) {
      this.disc(point, 5, colour, this.own.surface);
      return;
    }
    const [x, y] = this.at(point);
    const [ux, uy] = [direction[0] / length, -direction[1] / length];
    const [ex, ey] = [x + 38 * ux, y + 38 * uy];
    this.disc(point, 3.5, colour);
    c.strokeStyle = colour;
    c.lineWidth = 2.5;
    c.beginPath();
    c.moveTo(x, y);
    c.lineTo(ex - 6 * ux, ey - 6 * uy);
    c.stroke();
    c.beginPath();
    c.moveTo(ex, ey);
    c.lineTo(ex - 10 * ux - 4.5 * uy, ey - 10 * uy + 4.5 * ux);
    c.lineTo(ex - 10 * ux + 4.5 * uy, ey - 10 * uy - 4.5 * ux);
    c.fillStyle = colour;
    c.fill();
  }

  hatched(points: Point[], colour: string, width: number): void {
    const { c } = this;
    if (points.length > 2) {
      for (let i = 0; i + 1 < points.length; i++) this.hatched(points.slice(i, i + 2), colour, width);
      return;
    }
    this.line(points, colour, width);
    if (points.length < 2) return;
    const [a, b] = [this.at(points[0]), this.at(points[1])];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (length < 1) return;
    const [ux, uy] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    c.beginPath();
    for (let s = 5; s < length; s += 9) {
      c.moveTo(a[0] + s * ux, a[1] + s * uy);
      c.lineTo(a[0] + (s - 5) * ux - 6 * uy, a[1] + (s - 5) * uy + 6 * ux);
    }
    c.lineWidth = 1;
    c.stroke();
  }

  item(item: Item, is_chosen: boolean, is_hovered = false): void {
    const { c, own, p } = this;
    const points = p.moved.get(item.key) ?? item.points;
    const more = is_chosen ? 1.8 : is_hovered ? 1 : 0;
    const colour = (usual: string) => (is_chosen ? own.accent : usual);
    switch (item.kind) {
      case 'outline':
        this.line(points, colour(own.ink), 2 + more);
        return;
      case 'block':
        // The block itself is drawn below.
        if (more || p.moved.has(item.key)) this.line(points, colour(own.ink), 0.6 + more, [], true);
        return;
      case 'joint':
        this.line(points, colour(of(lines_of(own.is_dark), p.material(item))), 1.3 + more);
        return;
      case 'cut':
        this.line(points, colour(of(lines_of(own.is_dark), p.material(item))), 1.5 + more, [2, 4]);
        return;
      case 'material_line':
        this.line(points, colour(own.good), 1.5 + more, [8, 3, 2, 3]);
        return;
      case 'fixed_line':
        this.hatched(points, colour(own.is_dark ? '#8fb0ff' : '#2a4fb5'), 1.5 + more);
        return;
      case 'support':
        this.hatched(points, colour(own.is_dark ? '#8fb0ff' : '#2a4fb5'), 2 + more);
        return;
      case 'traction':
        this.line(points, colour(own.bad), 3 + more, [4, 3]);
        return;
      case 'crack':
        this.line(points, colour(own.ink), 2.5 + more);
        return;
      case 'bolt':
        this.line(points, colour(own.good), 3 + more);
        for (const end of points) this.disc(end, 3.5 + more / 2, colour(own.good));
        return;
      case 'fixed_point':
        this.disc(points[0], 5 + more / 2, colour(own.is_dark ? '#8fb0ff' : '#2a4fb5'), own.surface);
        return;
      case 'load':
      case 'force':
        this.arrow(points[0], p.force(item), colour(own.bad));
        return;
      case 'point':
        this.disc(points[0], 4.5 + more / 2, own.surface, colour(own.ink));
        this.disc(points[0], 1.5, colour(own.ink));
        return;
      case 'hole': {
        const [x, y] = this.at(points[0]);
        c.beginPath();
        c.moveTo(x - 5, y - 5);
        c.lineTo(x + 5, y + 5);
        c.moveTo(x + 5, y - 5);
        c.lineTo(x - 5, y + 5);
        c.lineWidth = 2 + more;
        c.strokeStyle = colour(own.bad);
        c.stroke();
        return;
      }
      case 'excavation':
      case 'region': {
        c.beginPath();
        this.trace(points, true);
        c.globalAlpha = is_chosen ? 0.25 : 0.14;
        c.fillStyle = colour(item.kind === 'excavation' ? own.warn : own.good);
        c.fill();
        c.globalAlpha = 1;
        this.line(points, colour(item.kind === 'excavation' ? own.warn : own.good), 1.8 + more, [6, 4], true);
        return;
      }
    }
  }

  draft(): void {
    const { c, own, p } = this;
    const { draft, pointer } = p;
    const points = pointer && draft.length ? [...draft, pointer.point] : draft;
    if (p.is_draft_closed && points.length > 2) {
      c.beginPath();
      this.trace(points, true);
      c.globalAlpha = 0.12;
      c.fillStyle = own.accent;
      c.fill();
      c.globalAlpha = 1;
    }
    if (points.length > 1) this.line(points, own.accent, 2);
    for (const point of draft) this.disc(point, 4, own.surface, own.accent);
    if (!pointer) return;
    const [x, y] = this.at(pointer.point);
    c.strokeStyle = own.accent;
    c.lineWidth = 1.5;
    c.beginPath();
    if (pointer.kind === 'end') c.rect(x - 6, y - 6, 12, 12);
    else if (pointer.kind === 'crossing') {
      c.moveTo(x - 6, y - 6);
      c.lineTo(x + 6, y + 6);
      c.moveTo(x + 6, y - 6);
      c.lineTo(x - 6, y + 6);
    } else if (pointer.kind === 'line') c.arc(x, y, 6, 0, 2 * Math.PI);
    else {
      c.moveTo(x - 6, y);
      c.lineTo(x + 6, y);
      c.moveTo(x, y - 6);
      c.lineTo(x, y + 6);
    }
    c.stroke();
  }

  handles(item: Item): void {
    const { c, own, p } = this;
    for (const point of p.moved.get(item.key) ?? item.points) {
      const [x, y] = this.at(point);
      c.fillStyle = own.surface;
      c.strokeStyle = own.accent;
      c.lineWidth = 1.5;
      c.fillRect(x - 4, y - 4, 8, 8);
      c.strokeRect(x - 4, y - 4, 8, 8);
    }
  }

  /** The part that does not change with the pointer. */
  ground(): void {
    const { c, own, p } = this;
    c.fillStyle = own.surface;
    c.fillRect(0, 0, p.width, p.height);
    c.lineJoin = 'round';
    this.blocks();
    c.globalAlpha = 0.7;
    this.grid();
    c.globalAlpha = 1;
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
    const { c, own, p } = this;
    const hovered = p.hovered && !p.chosen.has(p.hovered) && p.scene.items.find(one => one.key === p.hovered);
    if (hovered) this.item(hovered, false, true);
    if (p.box) {
      const [a, b] = p.box.map(corner => this.at(corner));
      c.setLineDash([4, 3]);
      c.strokeStyle = own.accent;
      c.lineWidth = 1;
      c.strokeRect(Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.abs(a[0] - b[0]), Math.abs(a[1] - b[1]));
      c.setLineDash([]);
    }
    this.draft();
  }
}

/** Picture without the pointer, kept while nothing in it changes. */
export class Ground {
  private readonly canvas = document.createElement('canvas');
  private made_of: unknown[] = [];

  paint(c: CanvasRenderingContext2D, picture: Picture, colours: Colours): void {
    const { scene, blocks, view, width, height, grid, chosen, moved, has_numbers } = picture;
    const ratio = window.devicePixelRatio || 1;
    const now = [scene, blocks, view, width, height, grid, chosen, moved, has_numbers, colours.ink, ratio];
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
