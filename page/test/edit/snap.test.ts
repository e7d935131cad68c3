// Places that a pointer means, and places that are typed.

import { describe, expect, test } from 'vitest';
import { round_above } from '../../src/draw/numbers';
import { crossing_of, rounded, type Segment, snap, typed_point } from '../../src/serve/edit/snap';

const CROSS: Segment[] = [
  { from: [0, 0], to: [10, 0] },
  { from: [3, -5], to: [3, 5] },
];
const options = { reach: 0.5, grid: 1, is_on: true, pixel: 0.05 };

describe('snapping', () => {
  test('ends come before crossings, crossings before the grid, the grid before lines', () => {
    expect(snap([9.8, 0.2], CROSS, [], options)).toEqual({ point: [10, 0], kind: 'end' });
    expect(snap([3.2, 0.1], CROSS, [], options)).toEqual({ point: [3, 0], kind: 'crossing' });
    expect(snap([7.1, 0.1], CROSS, [], options)).toEqual({ point: [7, 0], kind: 'grid' });
    expect(snap([7.5, 0.2], CROSS, [], options)).toEqual({ point: [7.5, 0], kind: 'line' });
    expect(snap([6.2, 3.1], [], [], options)).toEqual({ point: [6, 3], kind: 'grid' });
    expect(snap([6.2, 3.1], [], [[6.3, 3.2]], options)).toEqual({ point: [6.3, 3.2], kind: 'end' });
  });

  test('off, a place is rounded to what a pixel shows', () => {
    expect(snap([9.83751, 0.21], CROSS, [], { ...options, is_on: false })).toEqual({
      point: [9.84, 0.21],
      kind: 'free',
    });
    expect(snap([6.51, 3.49], [], [], { ...options, grid: 0 })).toEqual({ point: [6.51, 3.49], kind: 'free' });
    expect(rounded([123.456, -0.004], 0.2)).toEqual([123.5, 0]);
  });

  test('lines that do not cross have no crossing', () => {
    expect(crossing_of(CROSS[0], { from: [0, 1], to: [10, 1] })).toBe(null);
    expect(crossing_of(CROSS[0], { from: [5, 1], to: [5, 2] })).toBe(null);
    expect(crossing_of(CROSS[0], { from: [0, 0], to: [5, 0] })).toBe(null);
    expect(crossing_of(CROSS[0], { from: [5, 1], to: [5, 0] })).toEqual([5, 0]);
  });

  test('steps of the grid are 1, 2 and 5 times powers of ten', () => {
    expect([0.03, 0.1, 0.3, 1.2, 6, 20, 51].map(round_above)).toEqual([0.05, 0.1, 0.5, 2, 10, 20, 100]);
  });

  test('typed places are absolute, relative, or length and angle', () => {
    expect(typed_point('3, -4.5', [1, 1])).toEqual([3, -4.5]);
    expect(typed_point('3 4', null)).toEqual([3, 4]);
    expect(typed_point('@1,2', [1, 1])).toEqual([2, 3]);
    expect(typed_point('2<90', [1, 1])).toEqual([1, 3]);
    expect(typed_point('@10 < -30', [0, 0])).toEqual([8.660254038, -5]);
    for (const wrong of ['', '3', 'a, b', '1, 2, 3', '1 <']) expect(typed_point(wrong, null)).toBe(null);
  });
});
