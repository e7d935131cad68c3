// The figure that state and data make: ends of known crosses and contacts, and their scales.

import { beforeAll, describe, expect, test } from 'vitest';
import { Store } from '../../src/data/store';
import { contact_line, LIGHT, paint_over, screen_of } from '../../src/draw/paint';
import type { Line, Pen } from '../../src/draw/pen';
import { figure_now } from '../../src/view/figure';
import * as state from '../../src/view/state';
import { make_wall, type Wall } from '../scenes';

let wall: Wall;

beforeAll(async () => {
  wall = make_wall({ columns: 3, rows: 2, frames: 10, contacts: true, relaxes: true });
  const store = new Store(wall.head, id => wall.writer.chunks.find(c => c.id === id)?.text ?? null);
  await store.need_all([], () => {});
  state.start_state(wall.head, store, 0);
  state.size.value = { width: 800, height: 600 };
  state.camera.value = { x: 1.5, y: 0.5, scale: 100 };
  state.set_layer('crosses', true);
  state.set_layer('contacts', true);
});

/** Lines of one colour that a figure has over its bodies. */
function lines_of(colour: string): number[][] {
  const figure = figure_now()!;
  const found: number[][] = [];
  const segments = (ends: ArrayLike<number>, line: Line) => {
    if (line.colour !== colour) return;
    for (let i = 0; i < ends.length; i += 4) found.push(Array.from(ends).slice(i, i + 4));
  };
  const pen = new Proxy({}, { get: (_, name) => (name === 'segments' ? segments : () => {}) });
  paint_over(pen as Pen, figure, screen_of(figure, figure.pose.places));
  return found;
}

describe('crosses', () => {
  test('weight gives upright lines of compression, level with their blocks', () => {
    state.go_to(0);
    state.set_layer('contacts', false);
    const lines = lines_of(LIGHT.compression).filter(([x0, y0, x1, y1]) => Math.hypot(x1 - x0, y1 - y0) > 2);
    state.set_layer('contacts', true);
    expect(lines.length).toBeGreaterThan(2);
    for (const [x0, y0, x1, y1] of lines) {
      expect(Math.abs(x1 - x0)).toBeLessThan(1e-3);
      expect(Math.abs(y1 - y0)).toBeGreaterThan(2);
    }
  });

  test('a sheared block has the direction of its greatest stress', () => {
    state.go_to(5);
    const crosses = figure_now()!.crosses!;
    const row = 2;
    const [xx, yy, xy] = wall.stress[5][row];
    const radius = Math.hypot((xx - yy) / 2, xy);
    expect(Math.abs(crosses.angle[row] - Math.atan2(2 * xy, xx - yy) / 2)).toBeLessThan(2e-3);
    expect(Math.abs(crosses.least[row] / ((xx + yy) / 2 - radius) - 1)).toBeLessThan(2e-3);
  });

  test('the whole run scales them, also if its last frame has no stress', () => {
    state.go_to(9);
    expect(state.largest_cross_at(9)).toBe(0);
    const greatest = Math.max(...Array.from({ length: 10 }, (_, f) => state.largest_cross_at(f) ?? 0));
    expect(greatest).toBeGreaterThan(1e3);
    expect(figure_now()!.crosses!.largest).toBe(greatest);
    state.range_mode.value = 'frame';
    expect(figure_now()!.crosses!.largest).toBe(0);
    state.range_mode.value = 'run';
  });
});

test('a contact force has the direction of its normal and shear parts', () => {
  state.go_to(0);
  const figure = figure_now()!;
  const marks = figure.contacts!;
  const columns = state.store.part_now('contacts', 0)!.columns;
  for (const i of [0, 5]) {
    const [normal, shear] = [columns.normal_force[i], columns.shear_force[i]];
    expect(Math.abs(marks.force[2 * i] + shear)).toBeLessThan(1e-3 * normal);
    expect(Math.abs(marks.force[2 * i + 1] / normal - 1)).toBeLessThan(1e-3);
    const [x0, y0, x1, y1] = contact_line(figure, marks, i);
    expect(y1).toBeLessThan(y0);
    expect(Math.abs((x1 - x0) / (y0 - y1) + shear / normal)).toBeLessThan(1e-3);
  }
});

test('a load moves with its body', () => {
  state.go_to(5);
  const { pose } = figure_now()!;
  const row = 2;
  const { geometry } = pose;
  const at: [number, number] = [geometry.centroid[2 * row], geometry.centroid[2 * row + 1]];
  const before = state.head.still;
  state.head.still = [
    { kind: 'load', at, block: geometry.key[row] },
    { kind: 'load', at },
  ];
  const [moved, still] = figure_now()!.still;
  state.head.still = before;
  expect(still.at).toEqual(at);
  expect(Math.hypot(pose.centres[2 * row] - at[0], pose.centres[2 * row + 1] - at[1])).toBeGreaterThan(1e-9);
  expect(moved.at[0]).toBeCloseTo(pose.centres[2 * row], 5);
  expect(moved.at[1]).toBeCloseTo(pose.centres[2 * row + 1], 5);
});
