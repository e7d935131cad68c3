import { describe, expect, test } from 'vitest';
import { title_of_entry } from '../../src/serve/titles';

describe('titles', () => {
  test('entries of a record have titles in words', () => {
    expect(title_of_entry({ path: 'counts.steps_by_passes[2].steps' }, null)).toBe('Steps of 1 to 3 iterations');
    expect(title_of_entry({ path: 'ledger.end.friction' }, null)).toBe('Energy balance: friction');
  });
});
