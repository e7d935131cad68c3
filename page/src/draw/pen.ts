// Pens draw the same figure on a canvas and into an SVG text, in pixels from the top left.

export interface Line {
  colour: string;
  width: number;
  dash?: number[];
  opacity?: number;
  /** Ends of segments are square, which is faster for many. */
  is_square?: boolean;
  /** Second colour of hatch lines. */
  second?: string;
}

export interface TextStyle {
  size: number;
  colour: string;
  anchor?: 'start' | 'middle' | 'end';
  weight?: number;
  /** Colour of a rim that keeps text readable on areas. */
  halo?: string;
}

export interface Pen {
  /** Fills loops by even-odd; each loop is x, y in turn from `from` to `to` in `places`. */
  area(places: ArrayLike<number>, starts: ArrayLike<number>, from: number, to: number, fill: string): void;
  /** Fills the loops of a list, each on its own, in one colour. */
  areas(places: ArrayLike<number>, starts: ArrayLike<number>, list: ArrayLike<number>, fill: string): void;
  /** Strokes closed loops, all in one style. */
  loops(places: ArrayLike<number>, starts: ArrayLike<number>, from: number, to: number, line: Line): void;
  /** Strokes the closed loops of a list. */
  some_loops(places: ArrayLike<number>, starts: ArrayLike<number>, list: ArrayLike<number>, line: Line): void;
  /** Separate segments x1, y1, x2, y2 in turn. */
  segments(ends: ArrayLike<number>, line: Line): void;
  polyline(places: ArrayLike<number>, line: Line): void;
  polygon(places: ArrayLike<number>, fill: string, opacity?: number): void;
  circle(x: number, y: number, radius: number, fill: string | null, line: Line | null): void;
  box(x: number, y: number, width: number, height: number, fill: string, radius?: number, opacity?: number): void;
  text(x: number, y: number, text: string, style: TextStyle): void;
  hatch(places: ArrayLike<number>, starts: ArrayLike<number>, from: number, to: number, line: Line): void;
}

export const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';

/** Distance of hatch lines in pixels. */
export const HATCH = 7;

export class CanvasPen implements Pen {
  private pattern: { key: string; made: CanvasPattern } | null = null;

  constructor(private readonly c: CanvasRenderingContext2D) {}

  private trace(places: ArrayLike<number>, starts: ArrayLike<number>, from: number, to: number): void {
    const c = this.c;
    for (let l = from; l < to; l++) {
      const end = starts[l + 1];
      let v = starts[l];
      if (v === end) continue;
      c.moveTo(places[2 * v], places[2 * v + 1]);
      for (v++; v < end; v++) c.lineTo(places[2 * v], places[2 * v + 1]);
      c.closePath();
    }
  }

  private stroke(line: Line): void {
    const c = this.c;
    c.strokeStyle = line.colour;
    c.lineWidth = line.width;
    c.globalAlpha = line.opacity ?? 1;
    c.setLineDash(line.dash ?? []);
    c.stroke();
    c.globalAlpha = 1;
  }

  area(places: ArrayLike<number>, starts: ArrayLike<number>, from: number, to: number, fill: string): void {
    const c = this.c;
    c.beginPath();
    this.trace(places, starts, from, to);
    c.fillStyle = fill;
    c.fill('evenodd');
  }

  loops(places: ArrayLike<number>, starts: ArrayLike<number>, from: number, to: number, line: Line): void {
    const c = this.c;
    c.lineJoin = 'round';
    c.lineCap = 'butt';
    // Long paths cost more than their parts, so a stroke takes a few hundred loops at a time.
    for (let first = from; first < to; first += 200) {
      c.beginPath();
      this.trace(places, starts, first, Math.min(first + 200, to));
      this.stroke(line);
    }
  }

  areas(places: ArrayLike<number>, starts: ArrayLike<number>, list: ArrayLike<number>, fill: string): void {
    const c = this.c;
    c.fillStyle = fill;
    for (let first = 0; first < list.length; first += 50) {
      c.beginPath();
      const end = Math.min(first + 50, list.length);
      for (let i = first; i < end; i++) this.trace(places, starts, list[i], list[i] + 1);
      c.fill();
    }
  }

  some_loops(places: ArrayLike<number>, starts: ArrayLike<number>, list: ArrayLike<number>, line: Line): void {
    const c = this.c;
    c.lineJoin = 'round';
    c.lineCap = 'butt';
    for (let first = 0; first < list.length; first += 200) {
      c.beginPath();
      const end = Math.min(first + 200, list.length);
      for (let i = first; i < end; i++) this.trace(places, starts, list[i], list[i] + 1);
      this.stroke(line);
    }
  }

  hatch(places: ArrayLike<number>, starts: ArrayLike<number>, from: number, to: number, line: Line): void {
    const c = this.c;
    const key = `${line.colour} ${line.width}`;
    if (this.pattern?.key !== key) {
      const tile = document.createElement('canvas');
      const ratio = 2;
      tile.width = tile.height = HATCH * ratio;
      const t = tile.getContext('2d')!;
      t.scale(ratio, ratio);
      t.lineWidth = line.width;
      // A dark and a light line side by side are seen on every colour.
      for (const [colour, aside] of [
        [line.colour, 0],
        [line.second ?? line.colour, line.width],
      ] as const) {
        t.strokeStyle = colour;
        t.beginPath();
        for (const shift of [-HATCH, 0, HATCH]) {
          t.moveTo(shift - 1 + aside, HATCH + 1);
          t.lineTo(shift + HATCH + 1 + aside, -1);
        }
        t.stroke();
      }
      const made = c.createPattern(tile, 'repeat')!;
      made.setTransform(new DOMMatrix().scale(1 / ratio));
      this.pattern = { key, made };
    }
    c.globalAlpha = line.opacity ?? 1;
    c.fillStyle = this.pattern.made;
    c.beginPath();
    this.trace(places, starts, from, to);
    c.fill('evenodd');
    c.globalAlpha = 1;
  }

  segments(ends: ArrayLike<number>, line: Line): void {
    const c = this.c;
    c.lineCap = line.is_square ? 'butt' : 'round';
    for (let first = 0; first < ends.length; first += 1200) {
      c.beginPath();
      const stop = Math.min(first + 1200, ends.length);
      for (let i = first; i < stop; i += 4) {
        c.moveTo(ends[i], ends[i + 1]);
        c.lineTo(ends[i + 2], ends[i + 3]);
      }
      this.stroke(line);
    }
    c.lineCap = 'butt';
  }

  polyline(places: ArrayLike<number>, line: Line): void {
    const c = this.c;
    c.beginPath();
    for (let i = 0; i < places.length; i += 2) {
      if (i === 0) c.moveTo(places[0], places[1]);
      else c.lineTo(places[i], places[i + 1]);
    }
    this.stroke(line);
  }

  polygon(places: ArrayLike<number>, fill: string, opacity = 1): void {
    const c = this.c;
    c.beginPath();
    for (let i = 0; i < places.length; i += 2) {
      if (i === 0) c.moveTo(places[0], places[1]);
      else c.lineTo(places[i], places[i + 1]);
    }
    c.closePath();
    c.fillStyle = fill;
    c.globalAlpha = opacity;
    c.fill();
    c.globalAlpha = 1;
  }

  circle(x: number, y: number, radius: number, fill: string | null, line: Line | null): void {
    const c = this.c;
    c.beginPath();
    c.arc(x, y, radius, 0, 2 * Math.PI);
    if (fill) {
      c.fillStyle = fill;
      c.fill();
    }
    if (line) this.stroke(line);
  }

  box(x: number, y: number, width: number, height: number, fill: string, radius = 0, opacity = 1): void {
    const c = this.c;
    c.globalAlpha = opacity;
    c.fillStyle = fill;
    c.beginPath();
    c.roundRect(x, y, width, height, radius);
    c.fill();
    c.globalAlpha = 1;
  }

  text(x: number, y: number, text: string, style: TextStyle): void {
    const c = this.c;
    c.font = `${style.weight ?? 400} ${style.size}px ${FONT}`;
    c.textAlign = style.anchor === 'middle' ? 'center' : style.anchor === 'end' ? 'right' : 'left';
    c.textBaseline = 'alphabetic';
    if (style.halo) {
      c.strokeStyle = style.halo;
      c.lineWidth = 3;
      c.lineJoin = 'round';
      c.setLineDash([]);
      c.strokeText(text, x, y);
    }
    c.fillStyle = style.colour;
    c.fillText(text, x, y);
  }
}

/** Text that XML reads back as it is. */
export function escape_xml(text: string): string {
  return text.replace(/[&<>"]/g, c => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c] as string);
}

const short = (value: number) => String(Math.round(value * 100) / 100);

export class SvgPen implements Pen {
  private readonly out: string[] = [];
  private readonly patterns = new Map<string, string>();

  private path(places: ArrayLike<number>, starts: ArrayLike<number>, from: number, to: number): string {
    let d = '';
    for (let l = from; l < to; l++) {
      for (let v = starts[l]; v < starts[l + 1]; v++) {
        d += `${v === starts[l] ? 'M' : 'L'}${short(places[2 * v])} ${short(places[2 * v + 1])}`;
      }
      d += 'Z';
    }
    return d;
  }

  private look(line: Line): string {
    const dash = line.dash ? ` stroke-dasharray="${line.dash.join(' ')}"` : '';
    const opacity = line.opacity === undefined ? '' : ` stroke-opacity="${line.opacity}"`;
    return `fill="none" stroke="${line.colour}" stroke-width="${short(line.width)}"${dash}${opacity}`;
  }

  area(places: ArrayLike<number>, starts: ArrayLike<number>, from: number, to: number, fill: string): void {
    this.out.push(`<path d="${this.path(places, starts, from, to)}" fill="${fill}" fill-rule="evenodd"/>`);
  }

  loops(places: ArrayLike<number>, starts: ArrayLike<number>, from: number, to: number, line: Line): void {
    this.out.push(`<path d="${this.path(places, starts, from, to)}" ${this.look(line)} stroke-linejoin="round"/>`);
  }

  areas(places: ArrayLike<number>, starts: ArrayLike<number>, list: ArrayLike<number>, fill: string): void {
    let d = '';
    for (let i = 0; i < list.length; i++) d += this.path(places, starts, list[i], list[i] + 1);
    if (d) this.out.push(`<path d="${d}" fill="${fill}"/>`);
  }

  some_loops(places: ArrayLike<number>, starts: ArrayLike<number>, list: ArrayLike<number>, line: Line): void {
    let d = '';
    for (let i = 0; i < list.length; i++) d += this.path(places, starts, list[i], list[i] + 1);
    if (d) this.out.push(`<path d="${d}" ${this.look(line)} stroke-linejoin="round"/>`);
  }

  hatch(places: ArrayLike<number>, starts: ArrayLike<number>, from: number, to: number, line: Line): void {
    const key = `${line.colour} ${line.width}`;
    let id = this.patterns.get(key);
    if (!id) {
      id = `hatch${this.patterns.size}`;
      this.patterns.set(key, id);
      const path = (colour: string, aside: number) => {
        const d = [-HATCH, 0, HATCH].map(x => `M${x - 1 + aside} ${HATCH + 1}L${x + HATCH + 1 + aside} -1`).join('');
        return `<path d="${d}" stroke="${colour}" stroke-width="${line.width}"/>`;
      };
      this.out.unshift(
        `<defs><pattern id="${id}" width="${HATCH}" height="${HATCH}" patternUnits="userSpaceOnUse">` +
          `${path(line.colour, 0)}${path(line.second ?? line.colour, line.width)}</pattern></defs>`,
      );
    }
    const path = this.path(places, starts, from, to);
    this.out.push(`<path d="${path}" fill="url(#${id})" fill-rule="evenodd" fill-opacity="${line.opacity ?? 1}"/>`);
  }

  segments(ends: ArrayLike<number>, line: Line): void {
    let d = '';
    for (let i = 0; i < ends.length; i += 4) {
      d += `M${short(ends[i])} ${short(ends[i + 1])}L${short(ends[i + 2])} ${short(ends[i + 3])}`;
    }
    if (d) this.out.push(`<path d="${d}" ${this.look(line)} stroke-linecap="round"/>`);
  }

  polyline(places: ArrayLike<number>, line: Line): void {
    let points = '';
    for (let i = 0; i < places.length; i += 2) points += `${short(places[i])},${short(places[i + 1])} `;
    this.out.push(`<polyline points="${points.trim()}" ${this.look(line)}/>`);
  }

  polygon(places: ArrayLike<number>, fill: string, opacity = 1): void {
    let points = '';
    for (let i = 0; i < places.length; i += 2) points += `${short(places[i])},${short(places[i + 1])} `;
    this.out.push(`<polygon points="${points.trim()}" fill="${fill}" fill-opacity="${opacity}"/>`);
  }

  circle(x: number, y: number, radius: number, fill: string | null, line: Line | null): void {
    const stroke = line ? ` stroke="${line.colour}" stroke-width="${line.width}"` : '';
    this.out.push(`<circle cx="${short(x)}" cy="${short(y)}" r="${short(radius)}" fill="${fill ?? 'none'}"${stroke}/>`);
  }

  box(x: number, y: number, width: number, height: number, fill: string, radius = 0, opacity = 1): void {
    this.out.push(
      `<rect x="${short(x)}" y="${short(y)}" width="${short(width)}" height="${short(height)}" ` +
        `rx="${radius}" fill="${fill}" fill-opacity="${opacity}"/>`,
    );
  }

  text(x: number, y: number, text: string, style: TextStyle): void {
    const halo = style.halo
      ? ` stroke="${style.halo}" stroke-width="3" paint-order="stroke" stroke-linejoin="round"`
      : '';
    this.out.push(
      `<text x="${short(x)}" y="${short(y)}" font-size="${style.size}" font-weight="${style.weight ?? 400}" ` +
        `text-anchor="${style.anchor ?? 'start'}" fill="${style.colour}"${halo}>${escape_xml(text)}</text>`,
    );
  }

  done(width: number, height: number, background: string, title: string): string {
    return [
      `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" ` +
        `font-family='${FONT}'>`,
      `<title>${escape_xml(title)}</title>`,
      `<rect width="${width}" height="${height}" fill="${background}"/>`,
      ...this.out,
      '</svg>',
      '',
    ].join('\n');
  }
}
