import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test } from 'vitest';
import { decode_geometry } from '../../src/data/decode';
import { Store, value_at } from '../../src/data/store';
import { fit, pan, to_screen, to_world, zoom } from '../../src/draw/camera';
import { draw_chart } from '../../src/draw/chart';
import { areas_of, class_table, css_of, index_of, lines_of, table_about_zero, table_of } from '../../src/draw/colours';
import { measures_of } from '../../src/draw/measures';
import {
  place_decimals,
  round_below,
  scaled_unit,
  show,
  show_place,
  show_range,
  show_with,
  ticks_of,
  UNITS,
} from '../../src/draw/numbers';
import { type Figure, LIGHT, paint_all } from '../../src/draw/paint';
import { type Pen, SvgPen } from '../../src/draw/pen';
import { pick_body, pick_point, pick_segment, typical_size } from '../../src/draw/pick';
import {
  body_fractions,
  carry_place,
  type Pose,
  pose_of,
  range_of,
  shown_range,
  table_for,
  values_of,
} from '../../src/draw/scene';
import { triangles_of } from '../../src/draw/triangles';
import { type Body, encode_geometry } from '../encode';
import { make_wall, type Wall } from '../scenes';

/** Linear RGB as eyes without one kind of cones see it (Machado, Oliveira and Fernandes 2009). */
const EYES = {
  normal: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  'no red cones': [0.1523, 1.0526, -0.2049, 0.1145, 0.7863, 0.0992, -0.0039, -0.0481, 1.052],
  'no green cones': [0.3673, 0.8606, -0.228, 0.2801, 0.6725, 0.0474, -0.0118, 0.0429, 0.9689],
  'no blue cones': [1.2555, -0.0767, -0.1788, -0.0784, 0.9308, 0.1476, 0.0047, 0.6914, 0.3039],
};
const TO_XYZ = [0.4339, 0.3762, 0.1899, 0.2127, 0.7152, 0.0722, 0.0178, 0.1095, 0.8727];

const times = (m: number[], v: number[]) => [0, 3, 6].map(i => m[i] * v[0] + m[i + 1] * v[1] + m[i + 2] * v[2]);

/** CIE L*a*b* of a colour as eyes of a kind see it. */
function lab_seen(hex: string, eye: number[]): number[] {
  const linear = [1, 3, 5].map(i => (Number.parseInt(hex.slice(i, i + 2), 16) / 255) ** 2.2);
  const seen = times(eye, linear).map(v => Math.min(1, Math.max(0, v)));
  const [x, y, z] = times(TO_XYZ, seen).map(v => (v > 0.008856 ? Math.cbrt(v) : 7.787 * v + 16 / 116));
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

let wall: Wall;
let store: Store;
let pose: Pose;

async function store_of(own: Wall): Promise<Store> {
  const made = new Store(own.head, id => own.writer.chunks.find(c => c.id === id)?.text ?? null);
  await made.need_all([], () => {});
  return made;
}

beforeAll(async () => {
  wall = make_wall({ columns: 6, rows: 5, frames: 30, contacts: true, epochs: 2 });
  store = await store_of(wall);
  pose = pose_of(store, 29, 1)!;
});

describe('pose', () => {
  test('a vertex moves by s (u + G X)', () => {
    for (const s of [0, 1, 50]) {
      const own = pose_of(store, 10, s)!;
      const g = own.geometry;
      const row = 20;
      const [ux, , g11, g12] = wall.motion[10][row];
      const v = g.loop_start[g.body_loop[row]] + 2;
      const [X, Y] = [g.place[2 * v], g.place[2 * v + 1]];
      const expected = g.centroid[2 * row] + X + s * (ux + g11 * X + g12 * Y);
      expect(own.places[2 * v]).toBeCloseTo(expected, 4);
    }
  });

  test('displacements of vertices rule where they are there', async () => {
    const covers = make_wall({ columns: 3, rows: 2, frames: 4, on_vertices: true });
    const own = await store_of(covers);
    const at = own.field_now('vertex_motion', 3)!;
    const now = pose_of(own, 3, 10)!;
    const g = now.geometry;
    const v = 12;
    const b = g.vertex_body[v];
    expect(now.places[2 * v]).toBeCloseTo(g.centroid[2 * b] + g.place[2 * v] + 10 * value_at(at, 0, v), 4);
    const size = measures_of(covers.head, own).find(m => m.id === 'displacement.size')!;
    expect(size.on).toBe('vertex');
    expect(values_of(own, size, 3)!.length).toBe(g.vertices);
  });

  test('a contact stays on its body under magnification', () => {
    const contacts = store.part_now('contacts', 10)!.columns;
    const i = 60;
    const row = contacts.block[i];
    const [x, y] = [contacts.place[2 * i], contacts.place[2 * i + 1]];
    const same = carry_place(store, 10, pose_of(store, 10, 1)!, row, x, y);
    expect(same).toEqual([x, y]);
    const rest = carry_place(store, 10, pose_of(store, 10, 0)!, row, x, y);
    const g = pose.geometry;
    expect(Math.abs(rest[1] - g.centroid[2 * row + 1] + 0.247)).toBeLessThan(1e-4);
    const back = carry_place(store, 10, pose_of(store, 10, 2)!, row, x, y);
    expect(back[0] - x).toBeCloseTo(x - rest[0], 4);
  });
});

describe('measures', () => {
  test('principal stresses', () => {
    const measures = measures_of(wall.head, store);
    const value = (id: string) => values_of(store, measures.find(m => m.id === id)!, 29)![8];
    const [xx, yy, xy] = wall.stress[29][8];
    const radius = Math.hypot((xx - yy) / 2, xy);
    // A difference of rounded parts has the precision of the largest.
    expect(Math.abs(value('stress.greatest') - (xx + yy) / 2 - radius)).toBeLessThan(2e-3 * Math.abs(yy));
    expect(value('stress.least') / ((xx + yy) / 2 - radius)).toBeCloseTo(1, 2);
    expect(value('stress.shear') / radius).toBeCloseTo(1, 2);
    expect(value('material')).toBe(wall.bodies[8].material);
    expect(new Set(measures.map(m => m.id)).size).toBe(measures.length);
  });

  test('ranges reach to zero unless all values are far from it', () => {
    expect(shown_range({ low: -3, high: 1 })).toEqual({ low: -3, high: 1 });
    expect(shown_range({ low: -3, high: -1 })).toEqual({ low: -3, high: 0 });
    expect(shown_range({ low: -3, high: -2 })).toEqual({ low: -3, high: -2 });
    expect(shown_range({ low: 1, high: 3 })).toEqual({ low: 0, high: 3 });
    expect(shown_range({ low: 0, high: 0 })).toEqual({ low: 0, high: 1 });
    expect(shown_range({ low: Infinity, high: -Infinity })).toEqual({ low: 0, high: 1 });
    expect(range_of([1, Number.NaN, -2])).toEqual({ low: -2, high: 1 });
  });
});

describe('pick', () => {
  test('finds each body at its centre, and none outside', () => {
    const flat = pose_of(store, 0, 1)!;
    for (let b = 0; b < flat.geometry.bodies; b++) {
      expect(pick_body(flat, flat.centres[2 * b], flat.centres[2 * b + 1])).toBe(b);
    }
    expect(pick_body(flat, 100, 100)).toBeNull();
    expect(pick_point([0, 0, 5, 5], 4.5, 5, 1)).toBe(1);
    expect(pick_segment([0, 0, 10, 0, 0, 5, 10, 5], 3, 4.5, 1)).toBe(1);
    expect(pick_segment([0, 0, 10, 0], 3, 4.5, 1)).toBeNull();
  });
});

describe('camera', () => {
  test('pan moves the drawing by pixels, right and down', () => {
    const size = { width: 800, height: 600 };
    const before = { x: 3, y: 2, scale: 50 };
    const [x, y] = to_world(before, size, 100, 200);
    expect(to_screen(pan(before, 30, -20), size, x, y)).toEqual([130, 180]);
  });

  test('zoom keeps the place under the pointer', () => {
    const size = { width: 800, height: 600 };
    const first = fit({ left: 0, bottom: 0, right: 10, top: 5 }, size, { top: 10, right: 10, bottom: 50, left: 10 });
    const before = to_world(first, size, 200, 333);
    const second = zoom(first, size, 2.5, 200, 333);
    const after = to_world(second, size, 200, 333);
    expect(after[0]).toBeCloseTo(before[0], 9);
    expect(after[1]).toBeCloseTo(before[1], 9);
    expect(to_screen(first, size, 0, 0)[0]).toBeCloseTo(10);
    expect(to_screen(first, size, 10, 0)[0]).toBeCloseTo(790);
  });
});

describe('triangles', () => {
  const area = (places: Float32Array, index: Uint32Array) => {
    let sum = 0;
    for (let i = 0; i < index.length; i += 3) {
      const [a, b, c] = [index[i], index[i + 1], index[i + 2]];
      sum += Math.abs(
        (places[2 * b] - places[2 * a]) * (places[2 * c + 1] - places[2 * a + 1]) -
          (places[2 * c] - places[2 * a]) * (places[2 * b + 1] - places[2 * a + 1]),
      );
    }
    return sum / 2;
  };
  const body = (loops: [number, number][][]): Body => ({ key: 0, number: 1, material: 0, kind: 0, loops });

  test.each([
    [
      'convex',
      [
        [
          [0, 0],
          [2, 0],
          [2, 1],
          [0, 1],
        ],
      ],
      2,
    ],
    [
      'clockwise',
      [
        [
          [0, 1],
          [2, 1],
          [2, 0],
          [0, 0],
        ],
      ],
      2,
    ],
    [
      'notched',
      [
        [
          [0, 0],
          [3, 0],
          [3, 3],
          [1.5, 1],
          [0, 3],
        ],
      ],
      6,
    ],
    [
      'star',
      [
        [
          [0, 0],
          [2, 1],
          [4, 0],
          [3, 2],
          [4, 4],
          [2, 3],
          [0, 4],
          [1, 2],
        ],
      ],
      8,
    ],
    [
      'hole',
      [
        [
          [0, 0],
          [4, 0],
          [4, 4],
          [0, 4],
        ],
        [
          [1, 1],
          [2, 1],
          [2, 2],
          [1, 2],
        ],
      ],
      15,
    ],
    [
      'two holes',
      [
        [
          [0, 0],
          [6, 0],
          [6, 4],
          [0, 4],
        ],
        [
          [1, 1],
          [2, 1],
          [2, 3],
          [1, 3],
        ],
        [
          [4, 1],
          [5, 1],
          [5, 2],
          [4, 2],
        ],
      ],
      21,
    ],
    [
      'straight corner',
      [
        [
          [0, 0],
          [1, 0],
          [2, 0],
          [2, 2],
          [1, 1],
          [0, 2],
        ],
      ],
      3,
    ],
  ] as [string, [number, number][][], number][])('%s body keeps its area', (_, loops, expected) => {
    const geometry = decode_geometry(encode_geometry([body(loops)]));
    expect(area(geometry.place, triangles_of(geometry))).toBeCloseTo(expected, 4);
  });
});

describe('numbers', () => {
  test('digits, minus signs and powers', () => {
    expect(show(0.000775007)).toBe('0.000775');
    expect(show(-269530.9, 3)).toBe('−270000');
    expect(show(1.5e-9, 3)).toBe('1.5·10⁻⁹');
    expect(show(Number.NaN)).toBe('–');
    expect(show(100, 2)).toBe('100');
    expect(show_with(0.000775, 'm')).toBe('0.775\u00a0mm');
    expect(show_with(0.000000775, 'm')).toBe('0.775\u00a0µm');
    expect(show_with(-269530, 'Pa', 3)).toBe('−270\u00a0kPa');
    // Places far from the origin keep what tells them apart.
    expect(show_place(432104.38, 10)).toBe('432104.38');
    expect(show_place(5650003.82, 10)).toBe('5650003.82');
    expect([show_place(-0.00001, 10), show_place(-12.5, 900), show_place(120, 9e6)]).toEqual(['0', '−12.5', '120']);
    expect([place_decimals(10, 2 ** 18), place_decimals(0, 1e5)]).toEqual([5, 4]);
    expect(show_with(3, 'kJ')).toBe('3\u00a0kJ');
    expect(show_with(0.5, 'm')).toBe('0.5\u00a0m');
    expect(show_with(12500, 'N·m/m')).toBe('12.5\u00a0kJ/m');
    expect(show_with(2500, 'mm')).toBe('2.5\u00a0m');
    expect(show_range(0, 0.0565, 'm')).toBe('0 to 56.5\u00a0mm');
    expect(scaled_unit('', 1e-6)).toEqual({ factor: 1, unit: '' });
  });
  test('ticks and round numbers', () => {
    expect(ticks_of(0, 1, 5)).toEqual([0, 0.2, 0.4, 0.6000000000000001, 0.8, 1]);
    expect(ticks_of(3, 3)).toEqual([3]);
    expect(ticks_of(1e150, 1e150 * (1 + 2.3e-16))).toEqual([]);
    expect(ticks_of(-1e307, 1e307).length).toBeGreaterThan(1);
    expect(round_below(37)).toBe(20);
    expect(round_below(0.0051)).toBeCloseTo(0.005);
  });
});

test('the program has the same table of units', () => {
  const text = readFileSync(new URL('../../../src/problem/units/readable.cpp', import.meta.url), 'utf8');
  const rows = [...text.matchAll(/\{"([^"]+)", ([\de.-]+), ([\d.]+)\}/g)];
  expect(rows.map(([, name, size, least]) => [name, Number(size), Number(least)])).toEqual(UNITS);
});

describe('colours', () => {
  test('zero is white, and of one sign only the own side of the map is used', () => {
    const at = (low: number, high: number, value: number) =>
      css_of(table_about_zero(low, high), index_of((value - low) / (high - low)));
    for (const [low, high] of [
      [-1, 1],
      [-4, 1],
      [0, 3],
      [-3, 0],
    ])
      expect(Math.min(...at(low, high, 0).match(/\d+/g)!.map(Number)), `${low} to ${high}`).toBeGreaterThan(240);
    expect(at(-1, 1, -1)).toBe('rgb(33,102,172)');
    expect(at(-1, 3, 3)).toBe('rgb(178,24,43)');
    expect(at(-10, -9, -10)).toBe('rgb(33,102,172)');
    expect(at(-10, -9, -9)).not.toBe('rgb(247,247,247)');
  });

  test.each([
    ['areas', areas_of(false)],
    ['areas on dark', areas_of(true)],
    ['lines', lines_of(false)],
    ['lines on dark', lines_of(true)],
  ])('%s differ for eyes of all kinds', (_, colours) => {
    for (const [kind, matrix] of Object.entries(EYES)) {
      const seen = colours.map(colour => lab_seen(colour, matrix));
      seen.forEach((a, i) => {
        for (let j = 0; j < i; j++)
          expect(Math.hypot(...a.map((v, c) => v - seen[j][c])), `${kind}: ${j + 1}, ${i + 1}`).toBeGreaterThan(12);
      });
    }
  });

  test('viridis runs from dark to light', () => {
    const table = table_of('viridis');
    expect(css_of(table, 0)).toBe('rgb(68,1,84)');
    expect(css_of(table, 255)).toBe('rgb(253,231,37)');
    let before = -1;
    for (let i = 0; i < 256; i += 5) {
      const light = 0.2126 * table[3 * i] + 0.7152 * table[3 * i + 1] + 0.0722 * table[3 * i + 2];
      expect(light).toBeGreaterThan(before);
      before = light;
    }
    expect([index_of(-1), index_of(0.5), index_of(7)]).toEqual([0, 128, 255]);
    const classes = class_table(areas_of(false));
    expect(css_of(classes, 8)).toBe(css_of(classes, 0));
  });
});

describe('svg', () => {
  test('holds every body, the legend and escaped names', () => {
    const measures = measures_of(wall.head, store);
    const measure = measures.find(m => m.id === 'material')!;
    const values = values_of(store, measure, 29)!;
    const shade = {
      measure,
      values,
      low: 0,
      high: 255,
      table: table_for(measure, { low: 0, high: 255 }, 'viridis', false),
    };
    const figure: Figure = {
      size: { width: 800, height: 600 },
      camera: { x: 3, y: 1, scale: 60 },
      paint: LIGHT,
      pose,
      rest: null,
      shade,
      fractions: body_fractions(shade, pose.geometry),
      chosen: 3,
      numbers: true,
      outlines: true,
      contacts: null,
      lines: [],
      points: [],
      arrows: null,
      crosses: null,
      trails: [],
      still: wall.head.still ?? [],
      typical: typical_size(pose),
      length_unit: 'm',
      legend: true,
      caption: 'Step 87',
    };
    const pen = new SvgPen();
    paint_all(pen, figure, true);
    const text = pen.done(800, 600, '#ffffff', 'A <b> & "c"');
    expect(text.match(/fill-rule="evenodd"\/>/g)!.length).toBe(pose.geometry.bodies);
    expect(text).toContain('granite &lt;b&gt;');
    expect(text).toContain('<title>A &lt;b&gt; &amp; &quot;c&quot;</title>');
    expect(text).not.toContain('NaN');
  });
});

test('labels of an axis have one notation and few digits', () => {
  const labels = (unit: string, values: number[]) => {
    const texts: string[] = [];
    const pen = new Proxy(
      {},
      { get: (_, name) => (x: number, y: number, text: string) => name === 'text' && y && x && texts.push(text) },
    );
    draw_chart(pen as Pen, {
      width: 300,
      height: 200,
      x: [0, 1],
      x_label: 'time',
      curves: [{ label: 'a', unit, values }],
      colours: ['#000'],
      paint: LIGHT,
      grid: '#ccc',
      cursor: null,
    });
    return texts.slice(texts.indexOf('time') + 1);
  };
  expect(labels('', [0.00009, 0.000115])).toEqual(['0.9', '1', '1.1', '×10⁻⁴']);
  expect(labels('1/s', [2e6, 4e6]).at(-1)).toBe('10⁶ 1/s');
  expect(labels('m', [0.001, 0.002]).at(-1)).toBe('mm');
});
