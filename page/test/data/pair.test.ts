import { describe, expect, test } from 'vitest';
import { frame_at, last_place } from '../../src/serve/pair';

describe('two runs side by side', () => {
  test('static runs are linked by step, others by time', () => {
    const frames = [0, 10, 20, 40].map((step, i) => ({ step, time: i / 3, epoch: 0 }));
    expect([last_place(frames, true), last_place(frames, false)]).toEqual([40, 1]);
    expect([frame_at(frames, true, 19), frame_at(frames, false, 0.3)]).toEqual([2, 1]);
    expect(frame_at(frames, true, 1000)).toBe(3);
  });
});
