// Schema of a case file: limits of values, and what can be typed at a place.

import { execFileSync } from 'node:child_process';
import { describe, expect, test } from 'vitest';
import { choices_at, place_at } from '../../src/serve/edit/complete';
import {
  by_group,
  fault_in,
  limits_of,
  meaning_of,
  type Schema,
  schema_at,
  title_of,
  unit_in,
  words_of,
} from '../../src/serve/edit/schema';

const SCHEMA: Schema = {
  type: 'object',
  properties: {
    keyblock: { enum: [1, 2] },
    drawing: {
      type: 'object',
      properties: {
        joints: {
          type: 'array',
          items: {
            type: 'array',
            prefixItems: [
              { 'x-key': 'x1', type: 'number' },
              { 'x-key': 'joint_material', type: ['integer', 'string'] },
            ],
          },
        },
      },
    },
    analysis: {
      type: 'object',
      properties: {
        step_count: {
          type: 'integer',
          description: 'number of time steps. Permitted: a whole number from 1 to 100000000',
        },
        plane_strain: { type: 'boolean', default: false },
        rotation: { enum: ['first_order', 'exact'], default: 'first_order' },
        time_step: {
          type: ['number', 'string'],
          description: 'step size, T. Permitted: greater than 0',
          examples: ['2 ms'],
        },
      },
    },
  },
};
const NAMES = { block: ['rock'], joint: ['bedding', 'cross joint'] };

/** Choices where the mark | stands. */
function choices(marked: string): string[] {
  const at = marked.indexOf('|');
  const found = place_at(marked.replace('|', ''), at);
  return found ? choices_at(SCHEMA, found, NAMES).map(own => own.label) : [];
}

describe('completion', () => {
  test('keys of an object that it has not yet', () => {
    expect(choices('{|}')).toEqual(['keyblock', 'drawing', 'analysis']);
    expect(choices('{"keyblock": 2, "|": 1, "drawing": {}}')).toEqual(['analysis']);
    expect(choices('{"analysis": {"ste|')).toEqual(['step_count', 'time_step']);
    expect(choices('{"analysis": {"rotation": "exact", // note\n "ro|" }}')).toEqual([]);
    expect(choices('{ // a comment |\n}')).toEqual([]);
    expect(choices('| {}')).toEqual([]);
  });

  test('values: words, examples, names of materials', () => {
    expect(choices('{"analysis": {"rotation": |}}')).toEqual(['first_order', 'exact']);
    expect(choices('{"analysis": {"rotation": "e|"}}')).toEqual(['exact']);
    expect(choices('{"analysis": {"plane_strain": |')).toEqual(['true', 'false']);
    expect(choices('{"analysis": {"time_step": "|"}}')).toEqual(['2 ms']);
    expect(choices('{"drawing": {"joints": [[1, 2], [3, |]]}}')).toEqual(['bedding', 'cross joint']);
    expect(choices('{"keyblock": |')).toEqual(['1', '2']);
  });

  test('a choice replaces what is typed, with its quotation marks', () => {
    const text = '{"analysis": {"st"}}';
    const found = place_at(text, text.indexOf('st') + 2)!;
    expect(text.slice(found.from, found.to)).toBe('"st"');
    expect(choices_at(SCHEMA, found, NAMES)[0].text).toBe('"step_count": ');
    const open = '{"analysis": {"st}}';
    expect(place_at(open, 17)!.to).toBe(17);
    const before = '{"analysis": {"st"time_step": 1}}';
    expect(place_at(before, 17)!.to).toBe(17);
    const bare = place_at('{"keyblock": 2, ana', 19)!;
    expect([bare.kind, bare.from, bare.to, bare.typed]).toEqual(['key', 16, 19, 'ana']);
  });
});

describe('schema', () => {
  test('limits are enforced, and named in words', () => {
    const fault = (limits: Schema, value: unknown) => fault_in({ type: 'number', ...limits }, value);
    expect(fault({ exclusiveMinimum: 0, 'x-permitted': 'greater than 0' }, 0)).toBe('greater than 0');
    expect(fault({ exclusiveMinimum: 0 }, 1e-9)).toBe('');
    const share: Schema = { minimum: 0, maximum: 0.5, 'x-permitted': '0 to 0.5' };
    expect([fault(share, 0.5), fault(share, 0.51), fault(share, -1)]).toEqual(['', '0 to 0.5', '0 to 0.5']);
    const angle: Schema = { minimum: 0, exclusiveMaximum: 90, 'x-permitted': 'at least 0 and below 90 degrees' };
    expect([fault(angle, 90), fault(angle, 89.9)]).toEqual([angle['x-permitted'], '']);
    const whole: Schema = { type: 'integer', minimum: 1, 'x-permitted': 'a whole number, 1 or more' };
    expect([fault(whole, 0), fault(whole, 1.5), fault(whole, 2)]).toEqual([
      whole['x-permitted'],
      whole['x-permitted'],
      '',
    ]);
    expect(fault_in({ enum: ['a', 'b'] }, 'c')).toBe('one of a, b');
    expect(fault_in({ type: 'integer' }, 'ten')).toBe('a whole number');
    expect(fault_in({ type: ['number', 'string'], exclusiveMinimum: 0 }, '2 ms')).toBe('');
  });

  test('titles, dimensions, meanings, words and groups', () => {
    expect(title_of('youngs_modulus', { title: "Young's modulus" })).toBe("Young's modulus");
    expect(title_of('step_count', undefined)).toBe('Step count');
    const own: Schema = {
      description: 'mass per volume, M/L³. Permitted: greater than 0',
      'x-permitted': 'greater than 0',
      'x-unit': 'M/L³',
    };
    expect([own['x-unit'], meaning_of(own), limits_of(own)]).toEqual([
      'M/L³',
      'Mass per volume, M/L³.',
      'greater than 0',
    ]);
    const words: Schema = { enum: ['hoop_stress', 'b'], 'x-words': { hoop_stress: 'largest hoop stress' } };
    expect([words_of(words, 'hoop_stress'), words_of(words, 'b')]).toEqual(['hoop stress: largest hoop stress', 'b']);
    const keys = ['Loads', undefined, 'Loads'].map((group, i) => ({ key: i, own: { 'x-group': group } as Schema }));
    expect(by_group(keys).map(([group, all]) => [group, all.map(one => one.key)])).toEqual([
      ['Loads', [0, 2]],
      ['General', [1]],
    ]);
  });

  test('a unit is looked up by the letters of its dimension, apart for a slice', () => {
    const units = { L: 'm', 'F/L': 'N/m', 'F/L of a slice': 'N/m/m' };
    const of = (letters: string, is_of_slice?: boolean) =>
      unit_in({ 'x-unit': letters, 'x-of-slice': is_of_slice }, units);
    expect([of('L'), of('F/L'), of('F/L', true), of('deg')]).toEqual(['m', 'N/m', 'N/m/m', '°']);
    expect([of('F/L²'), of('none'), unit_in({}, units)]).toEqual(['', '', '']);
  });

  const program = process.env.KEYBLOCK ?? '';
  test.skipIf(!program)('the schema of the program is understood', () => {
    const schema: Schema = JSON.parse(execFileSync(program, ['formats', '--schema']).toString());
    const young = schema_at(schema, ['analysis', 'block_materials', 0, 'youngs_modulus'])!;
    expect([young['x-unit'], fault_in(young, 0), fault_in(young, 5e9)]).toEqual(['F/L²', 'greater than 0', '']);
    const stage = schema_at(schema, ['stages', 3, 'bolts', 0, 4])!;
    expect([stage['x-key'], stage.title, stage['x-unit']]).toEqual(['stiffness', 'Stiffness', 'F/L']);
    expect(schema['x-sections']?.every(one => schema_at(schema, one.path))).toBe(true);
    // No default of the schema breaks its own limits.
    const broken: string[] = [];
    const walk = (own: Schema, path: string) => {
      if (own.default !== undefined && fault_in(own, own.default)) broken.push(path);
      for (const [key, one] of Object.entries(own.properties ?? {})) walk(one, `${path}/${key}`);
      if (typeof own.items === 'object') walk(own.items, `${path}[]`);
    };
    walk(schema, '');
    expect(broken).toEqual([]);
  });
});
