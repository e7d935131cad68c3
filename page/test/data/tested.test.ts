import { describe, expect, test } from 'vitest';
import { number_in, numbers_in, parameter_rows, value_rows } from '../../src/serve/tested';

describe('element tests and fits', () => {
  test('a field that holds no number is named', () => {
    expect(numbers_in('To strains', '-0.01, -2e-2 0')).toEqual([-0.01, -0.02, 0]);
    expect(() => numbers_in('To strains', 'abc')).toThrow('To strains: expected a number, found abc');
    expect(() => numbers_in('To strains', ' ')).toThrow('To strains: expected numbers, found none');
    expect(number_in('Pressure', ' ')).toBeUndefined();
    expect(() => number_in('Material', '0', true)).toThrow('Material: expected a whole number from 1, found 0');
  });

  test('parameters of a fit have titles and units', () => {
    const rows = parameter_rows({
      parameters: {
        cohesion: { value: 13.62541, standard_error: 0.5, interval: [12.5, null], unit: 'MPa' },
        friction_deg: { value: 40, standard_error: 1, interval: [39, 41], unit: 'degrees' },
        ratio: { value: 4.25, standard_error: null, interval: [4, 5], unit: '1' },
      },
    });
    expect(rows).toEqual([
      ['Cohesion', '13.625', '0.5', '12.5', '–', 'MPa'],
      ['Friction angle', '40', '1', '39', '41', '°'],
      ['Slope of s1 over s3', '4.25', '–', '4', '5', ''],
    ]);
  });

  test('values of an element test have units', () => {
    const rows = value_rows({
      points: 101,
      least_stress: -2e7,
      end: { strain: [0.003, -0.01, 0.002, 0], stress: [0, -2e7, 0, 0], kappa: 0.004, plastic_work: 6e4 },
      units: { stress: 'Pa' },
    });
    expect(rows).toContainEqual(['Least stress', '−20\u00a0MPa']);
    expect(rows).toContainEqual(['Strain 2xy at the end', '0.002']);
    expect(rows).toContainEqual(['Plastic work', '60\u00a0kPa']);
    expect(rows).not.toContainEqual(['Greatest stress', '–']);
  });
});
