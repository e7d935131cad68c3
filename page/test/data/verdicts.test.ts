import { describe, expect, test } from 'vitest';
import { bracket_words, ending_words, factor_words, is_failure } from '../../src/serve/verdicts';

describe('ends of jobs', () => {
  test('a failed check is a result, other codes are not', () => {
    expect([0, 1, 3, 4, 5, undefined].map(is_failure)).toEqual([false, false, true, true, true, true]);
    expect(ending_words(1)).toBe('finished, but a check failed');
    expect(ending_words(77)).toBe('ended with code 77');
  });
});

describe('factor of safety in words', () => {
  test('a lower estimate is called so', () => {
    const own = {
      factor_of_safety: 1.2345,
      lower_estimate: true,
      reduced: 'both',
      bracket: { stands: 1.2, falls: 1.3 },
    };
    expect(factor_words(own)).toEqual(['Factor of safety', '1.234 (a lower estimate)']);
    expect(bracket_words(own)).toBe(
      'The model is stable at 1.200, unstable at 1.300, with the strength of joints and rock divided by these factors.',
    );
  });

  test('one end of a bracket, or none, gives a whole sentence', () => {
    const own = { end: 'falls', factor_of_safety: null, reduced: 'joints', bracket: { stands: null, falls: 0.05498 } };
    expect(factor_words(own)).toEqual(['No factor of safety was found.', '']);
    expect(bracket_words(own)).toBe(
      'The model is unstable at 0.05498, with the strength of joints divided by these factors.',
    );
    expect(bracket_words({ ...own, bracket: { stands: null, falls: null } })).toBe('');
  });
});
