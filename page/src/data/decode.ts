// Decodes chunks: zlib, byte planes, xor in time. Little endian, as every browser in use is.

import { type ColumnHead, ELEMENT_KIND, FIXED_BIT } from './contract';

/** Bytes of a base64 text. */
export function from_base64(text: string): Uint8Array {
  const own = Uint8Array as unknown as { fromBase64?: (text: string) => Uint8Array };
  if (own.fromBase64) return own.fromBase64(text);
  const chars = atob(text.trim());
  const bytes = new Uint8Array(chars.length);
  for (let i = 0; i < chars.length; i++) bytes[i] = chars.charCodeAt(i);
  return bytes;
}

/** Undoes zlib. */
export async function inflate(bytes: Uint8Array): Promise<Uint8Array> {
  const stream = new Blob([bytes as BlobPart]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Puts four planes of bytes, lowest bytes first, together to words. */
export function from_planes(bytes: Uint8Array): Uint32Array {
  const n = bytes.length >>> 2;
  if (n * 4 !== bytes.length) throw new Error('chunk with a broken length');
  const words = new Uint32Array(n);
  const second = n;
  const third = 2 * n;
  const fourth = 3 * n;
  for (let i = 0; i < n; i++) {
    words[i] = bytes[i] | (bytes[second + i] << 8) | (bytes[third + i] << 16) | (bytes[fourth + i] << 24);
  }
  return words;
}

/** Values of a field in a chunk: [part][frame][row]. */
export interface FieldChunk {
  parts: number;
  frames: number;
  rows: number;
  values: Float32Array;
}

/** Undoes planes and the xor of each frame with the frame before it. */
export function decode_field(bytes: Uint8Array, parts: number, frames: number, rows: number): FieldChunk {
  const words = from_planes(bytes);
  if (words.length !== parts * frames * rows) throw new Error('chunk of a field with a broken length');
  for (let part = 0; part < parts; part++) {
    const first = part * frames * rows;
    const end = first + frames * rows;
    for (let i = first + rows; i < end; i++) words[i] ^= words[i - rows];
  }
  return { parts, frames, rows, values: new Float32Array(words.buffer) };
}

/** Geometry of an epoch. Loop `l` has the vertices loop_start[l] to loop_start[l+1]; bodies' loops stand together. */
export interface Geometry {
  bodies: number;
  loops: number;
  vertices: number;
  key: Uint32Array;
  number: Uint32Array;
  material: Uint32Array;
  kind: Uint32Array;
  fixed: Uint8Array;
  /** x, y of each body's centroid, from the origin. */
  centroid: Float32Array;
  loop_body: Uint32Array;
  loop_start: Uint32Array;
  /** x, y of each vertex from the centroid of its body. */
  place: Float32Array;
  /** Body of each vertex. */
  vertex_body: Uint32Array;
  /** First loop of each body, and one more. */
  body_loop: Uint32Array;
  /** Row of a body by its key. */
  row_of_key: Map<number, number>;
}

export function is_element(geometry: Geometry, row: number): boolean {
  return (geometry.kind[row] & 255) === ELEMENT_KIND;
}

/** "block 7", or "element 7" of an NMM body. */
export function body_name(geometry: Geometry, row: number): string {
  return `${is_element(geometry, row) ? 'element' : 'block'} ${geometry.number[row]}`;
}

/** Word for bodies in the plural: blocks, elements, or both. */
export function word_for_bodies(geometry: Geometry): string {
  let elements = 0;
  for (let row = 0; row < geometry.bodies; row++) if (is_element(geometry, row)) elements++;
  if (elements === 0) return 'blocks';
  return elements === geometry.bodies ? 'elements' : 'blocks and elements';
}

export function decode_geometry(bytes: Uint8Array): Geometry {
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 0;
  const u32 = (n: number) => {
    const out = new Uint32Array(n);
    for (let i = 0; i < n; i++, at += 4) out[i] = data.getUint32(at, true);
    return out;
  };
  const f32 = (n: number) => {
    const out = new Float32Array(n);
    for (let i = 0; i < n; i++, at += 4) out[i] = data.getFloat32(at, true);
    return out;
  };
  const [bodies, loops, vertices] = u32(3);
  const key = u32(bodies);
  const number = u32(bodies);
  const material = u32(bodies);
  const kind = u32(bodies);
  const centroid = f32(2 * bodies);
  const loop_body = u32(loops);
  const loop_size = u32(loops);
  const place = f32(2 * vertices);
  if (at !== bytes.length) throw new Error('chunk of geometry with a broken length');
  return make_geometry({ key, number, material, kind, centroid, loop_body, loop_size, place });
}

export interface PlainGeometry {
  key: Uint32Array;
  number: Uint32Array;
  material: Uint32Array;
  kind: Uint32Array;
  centroid: Float32Array;
  loop_body: Uint32Array;
  loop_size: Uint32Array;
  place: Float32Array;
}

/** Adds starts of loops and bodies; puts loops in the order of their bodies if they are not. */
function make_geometry(from: PlainGeometry): Geometry {
  const bodies = from.key.length;
  const loops = from.loop_body.length;
  const vertices = from.place.length >>> 1;
  let sorted = true;
  for (let l = 1; l < loops; l++) if (from.loop_body[l] < from.loop_body[l - 1]) sorted = false;
  // Loops out of order would move vertices away from their fields, so the format's promise is checked.
  if (!sorted) throw new Error('loops of a body that do not stand together');
  const loop_start = new Uint32Array(loops + 1);
  const vertex_body = new Uint32Array(vertices);
  const body_loop = new Uint32Array(bodies + 1);
  let at = 0;
  for (let l = 0; l < loops; l++) {
    loop_start[l] = at;
    vertex_body.fill(from.loop_body[l], at, at + from.loop_size[l]);
    at += from.loop_size[l];
    body_loop[from.loop_body[l] + 1] = l + 1;
  }
  loop_start[loops] = at;
  if (at !== vertices) throw new Error('loops that do not fit their vertices');
  for (let b = 0; b < bodies; b++) if (body_loop[b + 1] < body_loop[b]) body_loop[b + 1] = body_loop[b];
  const fixed = new Uint8Array(bodies);
  for (let b = 0; b < bodies; b++) fixed[b] = from.kind[b] & FIXED_BIT ? 1 : 0;
  const row_of_key = new Map<number, number>();
  for (let b = 0; b < bodies; b++) row_of_key.set(from.key[b], b);
  return {
    bodies,
    loops,
    vertices,
    key: from.key,
    number: from.number,
    material: from.material,
    kind: from.kind,
    fixed,
    centroid: from.centroid,
    loop_body: from.loop_body,
    loop_start,
    place: from.place,
    vertex_body,
    body_loop,
    row_of_key,
  };
}

/** Rows of one frame of a table in time: values of each column, `parts` numbers a row. */
export interface PartRows {
  rows: number;
  columns: Record<string, Float32Array | Uint32Array>;
}

/** Undoes a chunk of a table in time; one entry a frame. */
export function decode_part(bytes: Uint8Array, frames: number, columns: ColumnHead[]): PartRows[] {
  const words = from_planes(bytes);
  const rows = Array.from(words.subarray(0, frames));
  const total = rows.reduce((sum, n) => sum + n, 0);
  const out: PartRows[] = rows.map(n => ({ rows: n, columns: {} }));
  let at = frames;
  for (const column of columns) {
    const parts = column.parts ?? 1;
    for (let f = 0; f < frames; f++) {
      const slice = words.slice(at, at + rows[f] * parts);
      out[f].columns[column.name] = column.type === 'u32' ? slice : new Float32Array(slice.buffer);
      at += rows[f] * parts;
    }
  }
  if (at !== words.length) throw new Error(`chunk of a table with a broken length (${total} rows)`);
  return out;
}
