import { describe, expect, test } from 'vitest';
import { with_titles } from '../../src/serve/edit/schema';
import { relative_of_entry, title_of_entry, words_of_value } from '../../src/serve/titles';

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
    expect(title_of_entry({ path: 'ledger.end.friction' }, null)).toBe('Energy balance: friction');
    const set = { properties: { motion: { title: 'Kind of steps' } } };
    expect(title_of_entry({ path: 'settings.motion' }, { properties: { run: { properties: { set } } } })).toBe(
      'Setting: Kind of steps',
    );
    const path = 'extremes.least_area_share.element';
    expect(title_of_entry({ path }, null)).toBe('Least area share element');
    const title = 'Block of the least share of area left';
    expect(title_of_entry({ path, title }, null)).toBe(title);
    expect(relative_of_entry({ path, first: 1, second: 2, relative: 0.5 })).toBe('');
    expect(relative_of_entry({ path: 'outcome.steps', relative: 0.5 })).toBe('50 %');
    expect(relative_of_entry({ path: 'counts.greatest_penetration', relative: 0.999, units: ['mm', 'm'] })).toBe('');
  });

  test('values of a record are words, not JSON', () => {
    const cause = { code: 'no_equilibrium', numbers: { largest_force: 1234567, step: 3 }, blocks: [2, 5] };
    expect(words_of_value(cause)).toBe('no equilibrium, largest force: 1.2346·10⁶, step: 3, blocks: 2; 5');
    expect(words_of_value([{ name: 'slivers', count: 2, first: 'warning: 2 slivers' }, 'dt=1e-4'])).toBe(
      'warning: 2 slivers; dt=1e-4',
    );
    expect([words_of_value([]), words_of_value(null), words_of_value(true)]).toEqual(['none', '–', 'true']);
  });
});
