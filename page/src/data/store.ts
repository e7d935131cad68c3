// Keeps decoded chunks and decodes those that are needed next.

import { type ChunkHead, type FieldHead, type Head, PageError, type Update } from './contract';
import {
  decode_field,
  decode_geometry,
  decode_part,
  type FieldChunk,
  from_base64,
  type Geometry,
  inflate,
  type PartRows,
} from './decode';

export interface FieldAt {
  chunk: FieldChunk;
  /** Index of the frame within the chunk. */
  frame: number;
}

/** Value of a part of a field in one row. */
export function value_at(at: FieldAt, part: number, row: number): number {
  const { frames, rows, values } = at.chunk;
  return values[(part * frames + at.frame) * rows + row];
}

/** First index of a part in the values of a field at a frame; rows follow one another. */
export function offset_of(at: FieldAt, part: number): number {
  return (part * at.chunk.frames + at.frame) * at.chunk.rows;
}

/** Motion that the page reads as fields besides those of the head. */
export const MOTION: FieldHead = { name: 'motion', label: 'Motion', unit: '', on: 'body', parts: 6, bits: 14 };
export const VERTEX_MOTION: FieldHead = {
  name: 'vertex_motion',
  label: 'Motion of vertices',
  unit: '',
  on: 'vertex',
  parts: 2,
  bits: 14,
};

/** Chunks that are decoded at once. */
const AT_ONCE = 4;

export class Store {
  private readonly by_what = new Map<string, ChunkHead[]>();
  private readonly geometries = new Map<number, Geometry>();
  private readonly fields = new Map<string, FieldChunk>();
  private readonly parts = new Map<string, PartRows[]>();
  private readonly waiting = new Map<string, Promise<void>>();
  readonly field_heads = new Map<string, FieldHead>();
  /** Chunks of later frames that are not decoded yet. */
  private readonly later_bytes = new Map<string, Uint8Array>();

  constructor(
    readonly head: Head,
    private readonly text_of: (id: string) => string | null,
  ) {
    for (const field of [MOTION, VERTEX_MOTION, ...head.fields]) this.field_heads.set(field.name, field);
    for (const chunk of head.chunks) this.add_chunk(chunk);
    for (const list of this.by_what.values()) list.sort((a, b) => a.from - b.from);
  }

  private add_chunk(chunk: ChunkHead): void {
    const list = this.by_what.get(chunk.what);
    if (list) list.push(chunk);
    else this.by_what.set(chunk.what, [chunk]);
  }

  /** Adds frames that a run has written since. Returns whether they have fields that no frame before had. */
  append(update: Update): boolean {
    const { head } = this;
    const frames = head.frames.length;
    const epochs = head.epochs.length;
    const own_id = (id: string) => `${frames}.${id}`;
    const had_vertices = this.has('vertex_motion');
    const new_fields = update.fields.filter(field => !this.field_heads.has(field.name));
    for (const field of new_fields) {
      head.fields.push(field);
      this.field_heads.set(field.name, field);
    }
    head.parts = { ...update.parts, ...head.parts };
    for (const [id, bytes] of Object.entries(update.bytes)) this.later_bytes.set(own_id(id), bytes);
    for (const own of update.epochs) head.epochs.push({ ...own, geometry: own_id(own.geometry) });
    for (const own of update.chunks) {
      this.add_chunk({
        ...own,
        id: own_id(own.id),
        from: frames + own.from,
        to: frames + own.to,
        epoch: epochs + own.epoch,
        frames: own.frames?.map(f => frames + f),
      });
    }
    for (const own of update.frames) head.frames.push({ ...own, epoch: epochs + own.epoch });
    return new_fields.length > 0 || this.has('vertex_motion') !== had_vertices;
  }

  /** Names of all fields and tables. */
  kinds(): string[] {
    return [...this.by_what.keys()];
  }

  has(what: string): boolean {
    return this.by_what.has(what);
  }

  /** True if a field or table has a chunk for this frame, decoded or not. */
  covers(what: string, frame: number): boolean {
    return this.chunk_of(what, frame) !== undefined;
  }

  epoch_of(frame: number): number {
    return this.head.frames[frame].epoch;
  }

  /** Newest frame at or before this one, in the same epoch, for which a table in time has rows. */
  stored_frame(what: string, frame: number): number | null {
    const epoch = this.epoch_of(frame);
    let best: number | null = null;
    for (const chunk of this.by_what.get(what) ?? []) {
      if (chunk.epoch !== epoch || chunk.from > frame) continue;
      if (!chunk.frames) best = Math.min(frame, chunk.to);
      else for (const f of chunk.frames) if (f <= frame && (best === null || f > best)) best = f;
    }
    return best;
  }

  private chunk_of(what: string, frame: number): ChunkHead | undefined {
    const list = this.by_what.get(what);
    if (!list) return undefined;
    let low = 0;
    let high = list.length - 1;
    while (low < high) {
      const mid = (low + high + 1) >> 1;
      if (list[mid].from <= frame) low = mid;
      else high = mid - 1;
    }
    const chunk = list[low];
    if (chunk.from > frame || frame > chunk.to) return undefined;
    if (chunk.frames && !chunk.frames.includes(frame)) return undefined;
    return chunk;
  }

  private async bytes_of(id: string): Promise<Uint8Array> {
    const bytes = this.later_bytes.get(id);
    if (bytes) {
      this.later_bytes.delete(id);
      return bytes;
    }
    const text = this.text_of(id);
    if (text === null) throw new PageError('A part of this page is missing: it was cut off or changed.');
    return inflate(from_base64(text));
  }

  private once(id: string, make: () => Promise<void>): Promise<void> {
    let promise = this.waiting.get(id);
    if (!promise) {
      promise = make();
      this.waiting.set(id, promise);
    }
    return promise;
  }

  geometry_now(epoch: number): Geometry | undefined {
    return this.geometries.get(epoch);
  }

  need_geometry(epoch: number): Promise<void> {
    const id = this.head.epochs[epoch].geometry;
    return this.once(id, async () => {
      this.geometries.set(epoch, decode_geometry(await this.bytes_of(id)));
    });
  }

  /** Decodes what the drawing of a frame needs: bodies, their motion, and the fields and tables in `more`. */
  async need_frame(frame: number, more: (string | null | undefined)[]): Promise<void> {
    const wanted = ['motion', 'vertex_motion', ...more].filter(what => what !== null && what !== undefined);
    await Promise.all([this.need_geometry(this.epoch_of(frame)), ...wanted.map(what => this.need(what, frame))]);
  }

  /** Decodes the chunk of a field or table that holds a frame, if there is one. */
  need(what: string, frame: number): Promise<void> {
    const chunk = this.chunk_of(what, frame);
    return chunk ? this.need_chunk(chunk) : Promise.resolve();
  }

  private need_chunk(chunk: ChunkHead): Promise<void> {
    return this.once(chunk.id, async () => {
      const bytes = await this.bytes_of(chunk.id);
      const field = this.field_heads.get(chunk.what);
      const frames = chunk.frames ? chunk.frames.length : chunk.to - chunk.from + 1;
      if (field) {
        const epoch = this.head.epochs[chunk.epoch];
        const rows = field.on === 'body' ? epoch.bodies : epoch.vertices;
        this.fields.set(chunk.id, decode_field(bytes, field.parts, frames, rows));
      } else {
        const part = this.head.parts?.[chunk.what];
        if (part) this.parts.set(chunk.id, decode_part(bytes, frames, part.columns));
      }
    });
  }

  field_now(what: string, frame: number): FieldAt | undefined {
    const chunk = this.chunk_of(what, frame);
    if (!chunk) return undefined;
    const decoded = this.fields.get(chunk.id);
    if (!decoded) return undefined;
    return { chunk: decoded, frame: chunk.frames ? chunk.frames.indexOf(frame) : frame - chunk.from };
  }

  part_now(what: string, frame: number): PartRows | undefined {
    const chunk = this.chunk_of(what, frame);
    if (!chunk) return undefined;
    return this.parts.get(chunk.id)?.[chunk.frames ? chunk.frames.indexOf(frame) : frame - chunk.from];
  }

  /** Decodes all that is left: geometry, motion and `first` before the rest. */
  async need_all(first: string[], progress: () => void): Promise<void> {
    for (let epoch = 0; epoch < this.head.epochs.length; epoch++) await this.need_geometry(epoch);
    const order = [...first, ...[...this.by_what.keys()].filter(what => !first.includes(what))];
    for (const what of order) {
      // Browsers undo zlib beside the page's own thread, so a few chunks are under way at once.
      const chunks = this.by_what.get(what) ?? [];
      for (let i = 0; i < chunks.length; i += AT_ONCE) {
        await Promise.all(chunks.slice(i, i + AT_ONCE).map(chunk => this.need_chunk(chunk)));
        progress();
      }
      await new Promise(resolve => setTimeout(resolve));
    }
  }
}
