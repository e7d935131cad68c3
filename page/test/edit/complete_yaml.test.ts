// Completion at a place of a case in YAML.

import { describe, expect, test } from 'vitest';
import { parse, plain } from '../../src/serve/edit/case_text';
import { choices_at } from '../../src/serve/edit/complete';
import { in_yaml, place_in_yaml } from '../../src/serve/edit/complete_yaml';
import type { Schema } from '../../src/serve/edit/schema';

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
        step_count: { type: 'integer', description: 'number of time steps' },
        plane_strain: { type: 'boolean', default: false },
        rotation: { enum: ['first_order', 'exact'], default: 'first_order' },
        time_step: { type: ['number', 'string'], description: 'step size', examples: ['2 ms'] },
        block_materials: {
          type: 'array',
          items: {
            type: 'object',
            properties: { name: { type: 'string' }, density: { type: 'number' }, like: { enum: ['no', 'granite'] } },
          },
        },
      },
    },
  },
};
const NAMES = { block: ['rock'], joint: ['bedding', 'cross joint'] };

function at_mark(marked: string) {
  const at = marked.indexOf('|');
  const text = marked.replace('|', '');
  const place = place_in_yaml(text, at, SCHEMA);
  return { text, place, all: place ? in_yaml(choices_at(SCHEMA, place, NAMES), place) : [] };
}

/** Choices where the mark | stands. */
const choices = (marked: string) => at_mark(marked).all.map(own => own.label);

/** Text after the first choice at the mark is taken. */
function taken(marked: string): string {
  const { text, place, all } = at_mark(marked);
  return text.slice(0, place!.from) + all[0].text + text.slice(place!.to);
}

describe('completion in YAML', () => {
  test('keys by their column, without those that stand above or below', () => {
    expect(choices('|')).toEqual(['keyblock', 'drawing', 'analysis']);
    expect(choices('# A case.\nkeyblock: 2\n|\ndrawing:\n  joints: []\n')).toEqual(['analysis']);
    expect(choices('analysis:\n  ste|')).toEqual(['step_count', 'time_step']);
    expect(choices('analysis:\n  rotation: exact  # note\n  |\n  step_count: 5\n')).toEqual([
      'plane_strain',
      'time_step',
      'block_materials',
    ]);
    expect(choices('analysis:\n  |')).toHaveLength(5);
    expect(choices('analysis:\n  step_count: 5\nd|')).toEqual(['drawing']);
    expect(choices('analysis:\n  step_count: 5\n    |')).toEqual([]);
  });

  test('keys of the rows of a list, behind the dash and below it', () => {
    const head = 'analysis:\n  block_materials:\n';
    expect(choices(`${head}    - |`)).toEqual(['name', 'density', 'like']);
    expect(choices(`${head}    - name: rock\n      |`)).toEqual(['density', 'like']);
    expect(choices(`${head}    - name: rock\n      density: 2\n    - d|`)).toEqual(['density']);
    expect(choices(`${head}  - name: rock\n    d|`)).toEqual(['density']);
    expect(choices(`${head}  - name: rock\n  ste|`)).toEqual(['step_count', 'time_step']);
    expect(choices(`${head}    - name: rock\n      density: 2\n  ro|`)).toEqual(['rotation']);
  });

  test('keys and values within brackets', () => {
    expect(choices('analysis: {|}')).toHaveLength(5);
    expect(choices('analysis: {ro|, step_count: 5}')).toEqual(['rotation']);
    expect(choices('analysis: {rotation: |}')).toEqual(['first_order', 'exact']);
    expect(choices('analysis: {plane_strain: true, # {\n  rotation: e|}')).toEqual(['exact']);
    expect(choices('drawing:\n  joints:\n    - [1, 2]\n    - [3, |]')).toEqual(['bedding', 'cross joint']);
    expect(choices('drawing:\n  joints: [[1, 2], [3, cr|')).toEqual(['cross joint']);
    expect(choices('{"keyblock": 2, "analysis": {"ste|"}}')).toEqual(['step_count', 'time_step']);
  });

  test('values behind a colon, not directly at it', () => {
    expect(choices('keyblock: |')).toEqual(['1', '2']);
    expect(choices('analysis:\n  rotation: |')).toEqual(['first_order', 'exact']);
    expect(choices('analysis:\n  rotation: "e|"')).toEqual(['exact']);
    expect(choices("analysis:\n  rotation: 'e|'\n  step_count: 1")).toEqual(['exact']);
    expect(choices('analysis:\n  plane_strain: t|')).toEqual(['true']);
    expect(choices('analysis:\n  time_step: |  # of a step')).toEqual(['2 ms']);
    expect(choices('analysis:\n  rotation:|')).toEqual([]);
  });

  test('nothing in comments, behind values and in unknown keys', () => {
    expect(choices('# a comment |\n')).toEqual([]);
    expect(choices('analysis: # |\n')).toEqual([]);
    expect(choices('analysis:\n  step_count: 5 # ro|')).toEqual([]);
    expect(choices('other:\n  |')).toEqual([]);
    expect(choices('analysis: {rotation: "exact"|}')).toEqual([]);
  });

  test('what is taken reads back', () => {
    expect(taken('ana|')).toBe('analysis:\n  ');
    expect(taken('analysis:\n  bl|')).toBe('analysis:\n  block_materials: []');
    expect(taken('analysis: {ro|}')).toBe('analysis: {rotation: first_order}');
    expect(taken('analysis:\n  "ro|": exact')).toBe('analysis:\n  rotation: first_order: exact');
    expect(taken('analysis:\n  time_step: |')).toBe('analysis:\n  time_step: 2 ms');
    expect(taken('analysis:\n  block_materials: [{like: n|}]')).toContain('like: "no"');
    expect(taken('drawing:\n  joints:\n    - [3, cr|oss]')).toBe('drawing:\n  joints:\n    - [3, cross joint]');
    expect(plain(parse(taken('analysis:\n  rotation: |\n  step_count: 5\n')))).toEqual({
      analysis: { rotation: 'first_order', step_count: 5 },
    });
  });

  test('any text with any caret has a place or none, and ends', () => {
    const parts = [
      'a: ',
      '- ',
      '\n',
      '  ',
      '{',
      '}',
      '[',
      ']',
      ',',
      '"',
      "'",
      '#',
      ' #',
      ':',
      'analysis',
      'x',
      '---',
      '\t',
    ];
    let state = 7;
    const next = (n: number) => {
      state = (state * 1103515245 + 12345) % 2147483648;
      return Math.floor((state / 2147483648) * n);
    };
    for (let i = 0; i < 3000; i++) {
      const text = Array.from({ length: next(25) }, () => parts[next(parts.length)]).join('');
      const caret = next(text.length + 1);
      const place = place_in_yaml(text, caret, SCHEMA);
      if (!place) continue;
      expect(place.from).toBeLessThanOrEqual(caret);
      expect(place.to).toBeGreaterThanOrEqual(caret);
      expect(place.to).toBeLessThanOrEqual(text.length);
    }
  });
});
