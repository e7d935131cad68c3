import { describe, expect, test } from 'vitest';
import { with_titles } from '../../src/serve/edit/schema';
import { relative_of_entry, title_of_entry } from '../../src/serve/titles';

const CASE = {
  properties: {
    analysis: {
      properties: {
        joint_materials: { items: { properties: { friction_angle_deg: { title: 'Friction angle' } } } },
      },
    },
  },
};

describe('titles', () => {
  test('a sentence of the program names fields as forms do', () => {
    const sentence = 'expected friction_angle_deg of at least 0, found step_ratio';
    expect(with_titles(sentence, [null, CASE])).toBe('expected “Friction angle” of at least 0, found step_ratio');
  });

  test('entries of a record have titles in words', () => {
    expect(title_of_entry({ path: 'counts.steps_by_passes[2].steps' }, null)).toBe('Steps of 1 to 3 iterations');
    expect(title_of_entry({ path: 'ledger.end.friction' }, null)).toBe('Energy balance: friction');
    const path = 'extremes.least_area_share.element';
    expect(title_of_entry({ path }, null)).toBe('Block of the least share of area left');
    expect(relative_of_entry({ path, first: 1, second: 2, relative: 0.5 })).toBe('');
    expect(relative_of_entry({ path: 'outcome.steps', relative: 0.5 })).toBe('50 %');
  });
});
