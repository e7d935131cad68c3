import { expect, test } from 'vitest';
import type { Job } from '../../src/serve/api';
import { has_news } from '../../src/serve/job_news';

const job = (state: Job['state'], step?: number, id = 1): Job => ({
  id,
  kind: 'both',
  title: 'slope.json',
  result: 'slope',
  state,
  is_stopping: false,
  step,
});

test('a folder is listed when a job comes, begins to step, begins its second profile, or ends', () => {
  expect(has_news([], [job('waits')])).toBe(true);
  expect(has_news([job('waits')], [job('runs', 0)])).toBe(true);
  expect(has_news([job('runs', 0)], [job('runs', 7)])).toBe(true);
  expect(has_news([job('runs', 300)], [job('runs', 2)])).toBe(true);
  expect(has_news([job('runs', 300)], [job('ended', 300)])).toBe(true);
  expect(has_news([job('ended', 300)], [job('waits', undefined, 2)])).toBe(true);
});

test('steps of a run list nothing', () => {
  expect(has_news([], [])).toBe(false);
  expect(has_news([job('runs', 7)], [job('runs', 8)])).toBe(false);
  expect(has_news([job('ended', 300)], [job('ended', 300)])).toBe(false);
});
