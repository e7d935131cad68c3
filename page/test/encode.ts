// Encodes scenes by the contract of the page, for tests: the counterpart of src/data/decode.ts.

import { deflateSync } from 'node:zlib';
import type { ColumnHead, FieldHead, Head } from '../src/data/contract';

export interface Body {
  key: number;
  number: number;
  material: number;
  kind: number;
  /** Loops of places from the origin. */
  loops: [number, number][][];
}

/** Centroid of a body, holes taken off. */
export function centroid_of(loops: [number, number][][]): [number, number] {
  let area = 0;
  let x = 0;
  let y = 0;
  loops.forEach((loop, index) => {
    let a = 0;
    let sx = 0;
    let sy = 0;
    loop.forEach(([x0, y0], i) => {
      const [x1, y1] = loop[(i + 1) % loop.length];
      const cross = x0 * y1 - x1 * y0;
      a += cross / 2;
      sx += ((x0 + x1) * cross) / 6;
      sy += ((y0 + y1) * cross) / 6;
    });
    const sign = Math.sign(a) * (index === 0 ? 1 : -1);
    area += sign * a;
    x += sign * sx;
    y += sign * sy;
  });
  return [x / area, y / area];
}

export function encode_geometry(bodies: Body[]): Uint8Array {
  const loops = bodies.flatMap((body, row) => body.loops.map(loop => ({ row, loop })));
  const vertices = loops.reduce((sum, { loop }) => sum + loop.length, 0);
  const out = new DataView(new ArrayBuffer(4 * (3 + 6 * bodies.length + 2 * loops.length + 2 * vertices)));
  let at = 0;
  const u32 = (value: number) => {
    out.setUint32(at, value, true);
    at += 4;
  };
  const f32 = (value: number) => {
    out.setFloat32(at, value, true);
    at += 4;
  };
  u32(bodies.length);
  u32(loops.length);
  u32(vertices);
  for (const body of bodies) u32(body.key);
  for (const body of bodies) u32(body.number);
  for (const body of bodies) u32(body.material);
  for (const body of bodies) u32(body.kind);
  const centroids = bodies.map(body => centroid_of(body.loops));
  for (const [x, y] of centroids) {
    f32(x);
    f32(y);
  }
  for (const { row } of loops) u32(row);
  for (const { loop } of loops) u32(loop.length);
  for (const { row, loop } of loops) {
    const [cx, cy] = [Math.fround(centroids[row][0]), Math.fround(centroids[row][1])];
    for (const [x, y] of loop) {
      f32(x - cx);
      f32(y - cy);
    }
  }
  return new Uint8Array(out.buffer);
}

/** Rounds the mantissa of float32 bits to `bits` bits. */
export function round_bits(word: number, bits: number): number {
  if (bits >= 23 || (word & 0x7f800000) === 0x7f800000) return word;
  const drop = 23 - bits;
  return ((word + (1 << (drop - 1))) & ~((1 << drop) - 1)) >>> 0;
}

export function to_planes(words: Uint32Array): Uint8Array {
  const n = words.length;
  const out = new Uint8Array(4 * n);
  for (let i = 0; i < n; i++) {
    for (let plane = 0; plane < 4; plane++) out[plane * n + i] = (words[i] >>> (8 * plane)) & 255;
  }
  return out;
}

/** Values [frame][row][part] of a field as the bytes of a chunk. */
export function encode_field(values: number[][][], parts: number, bits: number): Uint8Array {
  const frames = values.length;
  const rows = values[0].length;
  const words = new Uint32Array(parts * frames * rows);
  const bits_of = new Uint32Array(1);
  const float = new Float32Array(bits_of.buffer);
  let at = 0;
  for (let part = 0; part < parts; part++) {
    for (let f = 0; f < frames; f++) {
      for (let row = 0; row < rows; row++) {
        float[0] = values[f][row][part];
        words[at++] = round_bits(bits_of[0], bits);
      }
    }
    const first = part * frames * rows;
    for (let i = at - 1; i >= first + rows; i--) words[i] ^= words[i - rows];
  }
  return to_planes(words);
}

/** Rows [frame][row][column] → numbers, as the bytes of a chunk. */
export function encode_part(columns: ColumnHead[], frames: number[][][][]): Uint8Array {
  const words: number[] = frames.map(rows => rows.length);
  const bits = new Uint32Array(1);
  const float = new Float32Array(bits.buffer);
  columns.forEach((column, c) => {
    for (const rows of frames) {
      for (const row of rows) {
        for (const value of row[c]) {
          if (column.type === 'u32') bits[0] = value;
          else float[0] = value;
          words.push(bits[0]);
        }
      }
    }
  });
  return to_planes(Uint32Array.from(words));
}

/** Collects the chunks of a page. */
export class PageWriter {
  readonly chunks: { id: string; text: string }[] = [];

  add(bytes: Uint8Array): string {
    const id = `c${this.chunks.length}`;
    this.chunks.push({ id, text: deflateSync(bytes).toString('base64') });
    return id;
  }

  /** Adds a field in chunks of at most 25 frames that never span two epochs. */
  field(head: Head, field: Pick<FieldHead, 'name' | 'parts' | 'bits'>, values: number[][][]): void {
    let from = 0;
    while (from < head.frames.length) {
      let to = from;
      while (to + 1 < head.frames.length && to - from < 24 && head.frames[to + 1].epoch === head.frames[from].epoch)
        to++;
      const id = this.add(encode_field(values.slice(from, to + 1), field.parts, field.bits));
      head.chunks.push({ id, what: field.name, from, to, epoch: head.frames[from].epoch });
      from = to + 1;
    }
  }

  /** Scripts that take the place of the line in the built page. */
  scripts(head: Head): string {
    const json = JSON.stringify(head).replaceAll('<', '\\u003c');
    return [
      `<script type="application/json" id="keyblock-head">${json}</script>`,
      ...this.chunks.map(({ id, text }) => `<script type="text/plain" id="${id}">${text}</script>`),
    ].join('\n');
  }
}
