import { deflateSync } from 'node:zlib';
import { describe, expect, test } from 'vitest';
import { accept_head, NO_ROW, PageError, type Update } from '../../src/data/contract';
import {
  body_name,
  decode_field,
  decode_geometry,
  decode_part,
  from_base64,
  from_planes,
  type Geometry,
  inflate,
  word_for_bodies,
} from '../../src/data/decode';
import { offset_of, Store, value_at } from '../../src/data/store';
import { encode_field, encode_geometry, encode_part, PageWriter, round_bits, to_planes } from '../encode';
import { make_wall, noise, wall_bodies } from '../scenes';

const text_of = (chunks: { id: string; text: string }[]) => (id: string) => chunks.find(c => c.id === id)?.text ?? null;

test('elements of NMM bodies are not called blocks', () => {
  const of = (...kind: number[]) =>
    ({ bodies: kind.length, kind: Uint32Array.from(kind), number: Uint32Array.from([7, 9]) }) as Geometry;
  expect([body_name(of(0, 257), 0), body_name(of(0, 257), 1)]).toEqual(['block 7', 'element 9']);
  expect([of(0, 256), of(1, 1), of(0, 1)].map(word_for_bodies)).toEqual(['blocks', 'elements', 'blocks and elements']);
});

describe('coding', () => {
  test('base64 and zlib give the bytes back', async () => {
    const bytes = Uint8Array.from({ length: 5000 }, (_, i) => (i * i) & 255);
    const text = deflateSync(bytes).toString('base64');
    expect(await inflate(from_base64(text))).toEqual(bytes);
  });

  test('byte planes give the words back', () => {
    const words = Uint32Array.from([0, 1, 0xffffffff, 0x80000001, 0x12345678]);
    expect(from_planes(to_planes(words))).toEqual(words);
    expect(() => from_planes(new Uint8Array(5))).toThrow();
  });

  test.each([10, 14, 23])('a field comes back to %i bits', bits => {
    const random = noise(3);
    const values = Array.from({ length: 25 }, () =>
      Array.from({ length: 40 }, () => [random() * 1e-6, random() * 1e7, 0]),
    );
    const chunk = decode_field(encode_field(values, 3, bits), 3, 25, 40);
    let worst = 0;
    values.forEach((rows, frame) => {
      rows.forEach((row, r) => {
        row.forEach((value, part) => {
          const read = value_at({ chunk, frame }, part, r);
          worst = Math.max(worst, value === 0 ? Math.abs(read) : Math.abs(read / value - 1));
        });
      });
    });
    expect(worst).toBeLessThanOrEqual(2 ** -(bits + 1) * 1.001 + 2 ** -24);
  });

  test('numbers that are none, and infinite ones, survive rounding', () => {
    const values = [
      [[Number.NaN], [Number.POSITIVE_INFINITY]],
      [[1], [Number.NEGATIVE_INFINITY]],
    ];
    const chunk = decode_field(encode_field(values, 1, 10), 1, 2, 2);
    expect([...chunk.values]).toEqual([Number.NaN, Infinity, 1, -Infinity]);
    expect(round_bits(0x3f800000, 10)).toBe(0x3f800000);
  });

  test('a broken length is refused', () => {
    expect(() => decode_field(new Uint8Array(8), 1, 1, 3)).toThrow();
    expect(() => decode_geometry(new Uint8Array(12).fill(1))).toThrow();
  });

  test('rows of a table come back frame by frame', () => {
    const columns = [
      { name: 'place', parts: 2, type: 'f32' as const },
      { name: 'block', type: 'u32' as const },
    ];
    const frames = [
      [],
      [
        [[1, 2], [NO_ROW]],
        [[3, 4], [7]],
      ],
      [[[5, -6], [1]]],
    ];
    const rows = decode_part(encode_part(columns, frames), 3, columns);
    expect(rows.map(r => r.rows)).toEqual([0, 2, 1]);
    expect([...rows[1].columns.place]).toEqual([1, 2, 3, 4]);
    expect([...rows[1].columns.block]).toEqual([NO_ROW, 7]);
    expect([...rows[2].columns.place]).toEqual([5, -6]);
  });
});

describe('geometry', () => {
  test('loops, starts and fixed bodies', () => {
    const bodies = wall_bodies(3, 2);
    bodies[1].loops.push([
      [0.2, 0.1],
      [0.2, 0.2],
      [0.3, 0.2],
    ]);
    const geometry = decode_geometry(encode_geometry(bodies));
    expect(geometry.bodies).toBe(7);
    expect([...geometry.fixed]).toEqual([1, 0, 0, 0, 0, 0, 0]);
    expect([...geometry.body_loop]).toEqual([0, 1, 3, 4, 5, 6, 7, 8]);
    expect(geometry.loop_start[3] - geometry.loop_start[2]).toBe(3);
    expect(geometry.vertex_body[geometry.loop_start[2]]).toBe(1);
    expect(geometry.row_of_key.get(bodies[4].key)).toBe(4);
    const v = geometry.loop_start[4];
    expect(geometry.centroid[6] + geometry.place[2 * v]).toBeCloseTo(bodies[3].loops[0][0][0], 6);
  });
});

describe('head', () => {
  test('an unknown version is refused with a sentence', () => {
    const { head } = make_wall({ columns: 2, rows: 2, frames: 2 });
    expect(() => accept_head({ ...head, version: 2 })).toThrow(/version 2.*version 1 only/);
    expect(() => accept_head({})).toThrow(PageError);
    expect(() => accept_head({ ...head, frames: [] })).toThrow(PageError);
    expect(accept_head(head).title).toBe('Wall of blocks');
  });

  test('scripts hold no raw <', () => {
    const { head, writer } = make_wall({ columns: 2, rows: 2, frames: 2 });
    const json = writer.scripts(head).match(/keyblock-head">(.*?)<\/script>/)![1];
    expect(json).not.toContain('<');
    expect(JSON.parse(json).materials[0]).toBe('granite <b>');
  });
});

describe('store', () => {
  test('chunks never span epochs, and frames are found in them', async () => {
    const wall = make_wall({ columns: 4, rows: 3, frames: 60, epochs: 2, contacts: true });
    const store = new Store(wall.head, text_of(wall.writer.chunks));
    await store.need_all(['motion'], () => {});
    for (const f of [0, 24, 25, 29, 30, 54, 55, 59]) {
      const at = store.field_now('motion', f)!;
      const rows = store.geometry_now(store.epoch_of(f))!.bodies;
      expect(at.chunk.rows).toBe(rows);
      expect(rows).toBe(f < 30 ? 13 : 12);
      for (let row = 0; row < rows; row++) {
        const value = wall.motion[f][row][0];
        expect(Math.abs(value_at(at, 0, row) - value)).toBeLessThanOrEqual(Math.abs(value) * 3.1e-5);
      }
      expect(offset_of(at, 1)).toBe((at.chunk.frames + at.frame) * rows);
      expect(store.part_now('contacts', f)!.rows).toBe(4 * (rows - 1));
    }
    expect(store.field_now('nothing', 3)).toBeUndefined();
    expect(store.covers('motion', 59)).toBe(true);
    expect(store.covers('nothing', 59)).toBe(false);
  });

  test('frames of a run that goes on are added, with their bodies if those change', async () => {
    const wall = make_wall({ columns: 4, rows: 3, frames: 2 });
    const whole = make_wall({ columns: 4, rows: 3, frames: 3 });
    const other = make_wall({ columns: 2, rows: 2, frames: 1 });
    const store = new Store(wall.head, text_of(wall.writer.chunks));
    /** The only frame of a scene, or its last one, as the server sends it. */
    const update = async (scene: typeof wall, epoch: number): Promise<Update> => {
      const f = scene.head.frames.length - 1;
      const writer = new PageWriter();
      const geometry = scene.writer.chunks.find(own => own.id === scene.head.epochs[0].geometry)!;
      const motion = writer.add(encode_field(scene.motion.slice(f), 6, 14));
      return {
        frames: [{ ...scene.head.frames[f], epoch }],
        epochs: epoch < 0 ? [] : [{ ...scene.head.epochs[0], geometry: 'g' }],
        fields: [],
        parts: {},
        chunks: [{ id: motion, what: 'motion', from: 0, to: 0, epoch }],
        bytes: {
          g: await inflate(from_base64(geometry.text)),
          [motion]: await inflate(from_base64(writer.chunks[0].text)),
        },
      };
    };
    expect(store.append(await update(whole, -1))).toBe(false);
    expect(store.append(await update(other, 0))).toBe(false);
    expect(store.head.frames.map(own => own.epoch)).toEqual([0, 0, 0, 1]);
    for (const [f, motion] of [
      [2, whole.motion[2]],
      [3, other.motion[0]],
    ] as const) {
      await store.need_frame(f, []);
      const at = store.field_now('motion', f)!;
      expect(store.geometry_now(store.epoch_of(f))!.bodies).toBe(motion.length);
      motion.forEach(([value], row) => {
        expect(Math.abs(value_at(at, 0, row) - value)).toBeLessThanOrEqual(Math.abs(value) * 3.1e-5);
      });
    }
  });

  test('tables stored at some frames only', () => {
    const wall = make_wall({ columns: 2, rows: 2, frames: 10, contacts: true });
    const chunk = wall.head.chunks.find(c => c.what === 'contacts')!;
    chunk.frames = [0, 4, 8];
    const store = new Store(wall.head, text_of(wall.writer.chunks));
    expect(store.stored_frame('contacts', 3)).toBe(0);
    expect(store.stored_frame('contacts', 4)).toBe(4);
    expect(store.stored_frame('contacts', 9)).toBe(8);
    expect(store.stored_frame('bolts', 9)).toBeNull();
    expect(store.covers('contacts', 3)).toBe(false);
  });
});
