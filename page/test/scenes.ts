// Scenes for tests: a wall of blocks that slides and tilts, with contacts, stages and epochs.

import { type Head, NO_ROW } from '../src/data/contract';
import { type Body, centroid_of, encode_geometry, encode_part, PageWriter } from './encode';

export interface WallOptions {
  columns: number;
  rows: number;
  frames: number;
  contacts?: boolean;
  /** Splits the run into two epochs: from the middle on the last block is gone. */
  epochs?: 1 | 2;
  /** Rows whose stresses, velocities and states are no numbers. */
  missing?: number[];
  /** Elements on covers: displacements vertex by vertex. */
  on_vertices?: boolean;
  /** The last frame has no stress. */
  relaxes?: boolean;
}

export interface Wall {
  head: Head;
  writer: PageWriter;
  bodies: Body[];
  /** Motion [frame][row][6] as it was before rounding. */
  motion: number[][][];
  stress: number[][][];
}

/** Small numbers that look random and are the same every time. */
export function noise(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 4294967296 - 0.5;
  };
}

export function wall_bodies(columns: number, rows: number): Body[] {
  const bodies: Body[] = [
    {
      key: 0,
      number: 1,
      material: 1,
      kind: 256,
      loops: [
        [
          [-1, -1],
          [columns + 1, -1],
          [columns + 1, 0],
          [-1, 0],
        ],
      ],
    },
  ];
  const random = noise(7);
  for (let r = 0; r < rows; r++) {
    const shift = r % 2 ? 0.5 : 0;
    for (let c = 0; c < columns; c++) {
      const x = c + shift;
      const height = 0.5;
      const y = r * height;
      const cut = 0.06 * random();
      bodies.push({
        key: bodies.length * 3,
        number: bodies.length + 1,
        material: r % 3 === 2 ? 1 : 0,
        kind: 0,
        loops: [
          [
            [x, y],
            [x + 0.97, y],
            [x + 0.97, y + height - 0.01],
            [x + 0.5 + cut, y + height],
            [x, y + height - 0.01],
          ],
        ],
      });
    }
  }
  return bodies;
}

export function make_wall(options: WallOptions): Wall {
  const { frames } = options;
  const all = wall_bodies(options.columns, options.rows);
  const halves = options.epochs === 2 ? [all, all.slice(0, -1)] : [all];
  const writer = new PageWriter();
  const epoch_of = (f: number) => (halves.length === 2 && f >= frames / 2 ? 1 : 0);
  const head: Head = {
    format: 'keyblock-page',
    version: 1,
    program: 'keyblock 0.2.0',
    title: 'Wall of blocks',
    verdict: { tone: 'plain', words: 'run not finished', reason: '' },
    run: null,
    origin: [100, 50],
    precision: 'Displacements are rounded to 3·10⁻⁵ of their value, stresses to 5·10⁻⁴.',
    units: { length: 'm', mass: 'kg', time: 's', force: 'N', stress: 'Pa' },
    unit_by_letters: { L: 'm', T: 's' },
    titles: {},
    frames: Array.from({ length: frames }, (_, f) => ({
      step: 3 * f,
      time: 0.01 * f,
      load_factor: null,
      epoch: epoch_of(f),
      stage: halves.length === 2 ? ['in situ', 'excavated'][epoch_of(f)] : '',
    })),
    epochs: halves.map(bodies => ({
      bodies: bodies.length,
      loops: bodies.length,
      vertices: bodies.reduce((sum, body) => sum + body.loops[0].length, 0),
      geometry: writer.add(encode_geometry(bodies)),
    })),
    fields: [
      {
        name: 'stress',
        label: 'Stress',
        unit: 'Pa',
        on: 'body',
        parts: 4,
        components: ['xx', 'yy', 'xy', 'zz'],
        bits: 10,
      },
      { name: 'velocity', label: 'Velocity', unit: 'm/s', on: 'body', parts: 2, components: ['x', 'y'], bits: 10 },
      {
        name: 'yield_state',
        label: 'Yield state',
        unit: '',
        on: 'body',
        parts: 1,
        bits: 23,
        kind: 'state',
        names: ['elastic', 'yields now', 'has yielded'],
      },
    ],
    chunks: [],
    materials: ['granite <b>', 'marl'],
    joints: ['rough', 'smooth <i>'],
    tables: [
      {
        name: 'history.csv',
        title: 'Histories',
        columns: [
          { name: 'step', unit: '', values: Array.from({ length: frames }, (_, f) => 3 * f) },
          { name: 'time', unit: 's', values: Array.from({ length: frames }, (_, f) => 0.01 * f) },
          { name: 'displacement x', unit: 'm', values: Array.from({ length: frames }, (_, f) => 1e-5 * f * f) },
          { name: 'force', unit: 'N', values: Array.from({ length: frames }, (_, f) => 1e4 * Math.sin(f / 7)) },
        ],
      },
    ],
    still: [{ kind: 'fixed_point', at: [0.5, -0.5] }],
  };
  const top = options.rows * 0.5;
  const motion: number[][][] = [];
  const stress: number[][][] = [];
  const velocity: number[][][] = [];
  const yields: number[][][] = [];
  for (let f = 0; f < frames; f++) {
    const bodies = halves[epoch_of(f)];
    const t = f / Math.max(1, frames - 1);
    const random = noise(100 + f);
    motion.push(
      bodies.map(body => {
        if (body.kind & 256) return [0, 0, 0, 0, 0, 0];
        const [x, y] = centroid_of(body.loops);
        const share = (y / top) ** 2;
        const angle = 0.12 * t * t * share * Math.sin(x);
        return [
          0.5 * t * t * share,
          -0.08 * t * t * share + 1e-5 * random(),
          Math.cos(angle) - 1,
          -Math.sin(angle),
          Math.sin(angle),
          Math.cos(angle) - 1,
        ];
      }),
    );
    stress.push(
      bodies.map(body => {
        const [x, y] = centroid_of(body.loops);
        if (options.relaxes && f === frames - 1) return [0, 0, 0, 0];
        return [2e3 * Math.sin(x) * t, -2.5e4 * (top - y), 3e3 * Math.cos(x + y) * t, -6e3 * (top - y)];
      }),
    );
    velocity.push(
      bodies.map((body, row) => {
        if (body.kind & 256) return [0, 0];
        return [motion[f][row][0] * 2, motion[f][row][1] * 2];
      }),
    );
    yields.push(bodies.map((_, row) => [row % 7 === 0 ? (t > 0.5 ? 2 : 1) : 0]));
  }
  if (options.on_vertices) {
    const field = { name: 'vertex_motion', parts: 2, bits: 14 };
    writer.field(
      head,
      field,
      motion.map((rows, f) =>
        halves[epoch_of(f)].flatMap((body, row) => {
          const [cx, cy] = centroid_of(body.loops);
          const [ux, uy, a, b, c, d] = rows[row];
          return body.loops[0].map(([x, y]) => [
            ux + a * (x - cx) + b * (y - cy) + 0.002 * Math.sin(9 * x),
            uy + c * (x - cx) + d * (y - cy),
          ]);
        }),
      ),
    );
  }
  for (const own of [stress, velocity, yields])
    for (const rows of own) for (const row of options.missing ?? []) rows[row].fill(Number.NaN);
  writer.field(head, { name: 'motion', parts: 6, bits: 14 }, motion);
  writer.field(head, { name: 'stress', parts: 4, bits: 10 }, stress);
  writer.field(head, { name: 'velocity', parts: 2, bits: 10 }, velocity);
  writer.field(head, { name: 'yield_state', parts: 1, bits: 23 }, yields);
  if (options.contacts) {
    const columns = [
      { name: 'place', unit: 'm', parts: 2, type: 'f32' as const },
      { name: 'normal', unit: '', parts: 2, type: 'f32' as const },
      { name: 'normal_force', unit: 'N', parts: 1, type: 'f32' as const },
      { name: 'shear_force', unit: 'N', parts: 1, type: 'f32' as const },
      { name: 'gap', unit: 'm', parts: 1, type: 'f32' as const },
      { name: 'state', unit: '', parts: 1, type: 'u32' as const, names: ['open', 'sticks', 'slides'] },
      { name: 'block', unit: '', parts: 1, type: 'u32' as const },
      { name: 'other', unit: '', parts: 1, type: 'u32' as const },
      { name: 'joint', unit: '', parts: 1, type: 'u32' as const },
    ];
    head.parts = { contacts: { columns } };
    let from = 0;
    while (from < frames) {
      let to = from;
      while (to + 1 < frames && to - from < 24 && epoch_of(to + 1) === epoch_of(from)) to++;
      const series = [];
      for (let f = from; f <= to; f++) {
        const bodies = halves[epoch_of(f)];
        series.push(
          bodies.flatMap((body, row) => {
            if (body.kind & 256) return [];
            const [cx, cy] = centroid_of(body.loops);
            const [ux, uy, a, b, c, d] = motion[f][row];
            const level = Math.round((cy - 0.25) / 0.5);
            const below = level === 0 ? 0 : Math.max(0, row - options.columns);
            return [-0.4, -0.14, 0.14, 0.4].map(dx => {
              const X = dx;
              const Y = -0.247;
              const force = 5e3 * (options.rows - level) * (1 + 0.4 * Math.sin(3 * cx + dx));
              return [
                [cx + X + ux + a * X + b * Y, cy + Y + uy + c * X + d * Y],
                [0, 1],
                [force],
                [force * 0.3 * Math.sin(cx)],
                [-1e-6],
                [(row + Math.round(dx * 10)) % 5 === 0 ? 2 : 1],
                [row],
                [level === 0 ? (row === 1 ? NO_ROW : 0) : below],
                [level % 2],
              ];
            });
          }),
        );
      }
      const id = writer.add(encode_part(columns, series));
      head.chunks.push({ id, what: 'contacts', from, to, epoch: epoch_of(from) });
      from = to + 1;
    }
  }
  return { head, writer, bodies: all, motion, stress };
}
