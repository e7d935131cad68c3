// Joint sets and the text of a new scene.

import { describe, expect, test } from 'vitest';
import { find, type Path, parse, plain } from '../../src/serve/edit/json_text';
import { loops_of, scene_of } from '../../src/serve/edit/scene';
import type { Schema } from '../../src/serve/edit/schema';
import {
  fault_of,
  first_form,
  form_in_metres,
  new_set,
  note_of,
  rounded_rows,
  scene_text,
  set_in_unit,
  sets_in,
  spec_of,
  with_note,
} from '../../src/serve/edit/sets';

const DRAWN = {
  boundary_count: 4,
  joints: [
    [0, 0, 10, 0, 1],
    [10, 0, 10, 5, 1],
    [10, 5, 0, 5, 1],
    [0, 5, 0, 0, 1],
    [0, 1e-16, 10, 5.000000000000001, 2],
  ] as [number, number, number, number, number][],
};
const SCHEMA: Schema = {
  properties: {
    slope: {
      required: ['height', 'angle'],
      properties: {
        height: { type: 'number', title: 'Height', exclusiveMinimum: 0, 'x-permitted': 'greater than 0' },
        angle: {
          type: 'number',
          title: 'Angle',
          exclusiveMinimum: 0,
          maximum: 90,
          'x-permitted': 'above 0 to 90 degrees',
        },
        base: { type: 'number', title: 'Base', exclusiveMinimum: 0, 'x-permitted': 'greater than 0' },
        benches: { type: 'integer', title: 'Lifts', minimum: 1, 'x-permitted': 'a whole number from 1 to 1000' },
      },
    },
    sets: {
      items: {
        required: ['dip', 'spacing'],
        properties: {
          dip: { type: 'number', title: 'Dip', minimum: -360, maximum: 360, 'x-permitted': '-360 to 360 degrees' },
          spacing: { type: 'number', title: 'Spacing', exclusiveMinimum: 0, 'x-permitted': 'greater than 0' },
          scatter: { type: 'number', title: 'Scatter', minimum: 0, maximum: 1, 'x-permitted': '0 to 1' },
          trace: { type: 'number', title: 'Trace length', exclusiveMinimum: 0, 'x-permitted': 'greater than 0' },
        },
      },
    },
  },
};
const read = (text: string, ...path: Path) => plain(find(parse(text), path));

describe('joint sets', () => {
  test('a form becomes the specification of keyblock joints', () => {
    const form = first_form();
    form.sets[0] = { ...form.sets[0], trace: '5', gap: '1', scatter: '0.1', dip_scatter: '4' };
    form.sets[1].gap = '2';
    expect(spec_of(form)).toEqual({
      slope: { height: 20, angle: 60, toe: 8, crest: 18, base: 4, bench: 0, benches: 1 },
      sets: [
        { dip: 35, spacing: 3, trace: 5, gap: 1, scatter: 0.1, dip_scatter_deg: 4, joint: 1 },
        { dip: 118, spacing: 3, scatter: 0, dip_scatter_deg: 0, joint: 2 },
      ],
      seed: 1,
    });
    expect(spec_of({ ...form, kind: 'rectangle' })).toMatchObject({ rectangle: { width: 40, height: 20 } });
  });

  test('lengths may name their unit', () => {
    const form = first_form();
    form.height = '15000 mm';
    form.sets[0].spacing = '250 cm';
    expect(spec_of(form_in_metres(form))).toMatchObject({ slope: { height: 15 }, sets: [{ spacing: 2.5 }, {}] });
    expect(set_in_unit({ ...form.sets[0], trace: '4' }, 'mm')).toMatchObject({ spacing: '2500', trace: '4' });
    expect(fault_of(form_in_metres({ ...form, height: '3 kg' }), SCHEMA)).toBe('The height must be a number.');
  });

  test('wrong numbers are named', () => {
    const fault = (change: object, set = {}) => {
      const form = { ...first_form(), ...change };
      form.sets = form.sets.map((own, i) => (i ? own : { ...own, ...set }));
      return fault_of(form, SCHEMA);
    };
    expect(fault({})).toBe('');
    expect(fault({ base: '0' })).toBe('The base: expected greater than 0.');
    expect(fault({ benches: '1.5' })).toBe('The lifts: expected a whole number from 1 to 1000.');
    expect(fault({ toe: '' })).toBe('');
    expect(fault({}, { dip: '400' })).toBe('The dip of bedding: expected -360 to 360 degrees.');
    expect(fault({}, { trace: '0' })).toBe('');
    expect(fault({}, { trace: '-2' })).toContain('trace length of bedding');
    expect(fault({}, { spacing: 'x' })).toBe('The spacing of bedding must be a number.');
    expect(fault_of({ ...first_form(), height: '' }, null)).toBe('The height must be a number.');
    expect(fault_of({ ...first_form(), base: '' }, null)).toBe('');
    expect(fault({ height: '0' })).toContain('height');
    expect(fault({ angle: '91' })).toContain('angle');
    expect(fault({ kind: 'drawn' })).toContain('Draw the outline');
    expect(fault({ seed: '1.5' })).toContain('seed');
    expect(fault({}, { spacing: '-1' })).toContain('spacing of bedding');
    expect(fault({}, { spacing: '0.001' })).toContain('too small');
    expect(fault({}, { dip: '' })).toContain('dip of bedding');
    expect(fault({}, { scatter: '2' })).toContain('scatter of bedding');
    expect(fault({}, { name: 'cross joint' })).toContain('Two joint sets');
    expect(fault({}, { name: '3' })).toContain('begins with a letter');
  });

  test('the text of a scene is a case with supports, materials and a note on its sets', () => {
    const form = { ...first_form(), youngs_modulus: '5 GPa' };
    form.sets[1].cohesion = '20 kPa';
    const text = scene_text(form, DRAWN);
    const scene = scene_of(text);
    expect(loops_of(scene)).toHaveLength(1);
    expect(scene.items.map(own => own.kind)).toEqual([
      ...Array(4).fill('outline'),
      'joint',
      ...Array(3).fill('fixed_line'),
      'point',
    ]);
    expect(read(text, 'drawing', 'joints', 4)).toEqual([0, 0, 10, 5, 'cross joint']);
    expect(read(text, 'analysis', 'block_materials', 0)).toEqual({
      name: 'rock',
      like: 'limestone',
      youngs_modulus: '5 GPa',
    });
    expect(read(text, 'analysis', 'joint_materials', 1)).toEqual({
      name: 'cross joint',
      friction_angle_deg: 30,
      cohesion: '20 kPa',
    });
    expect(sets_in(text)!.sets.map(own => [own.name, own.dip, own.spacing])).toEqual([
      ['bedding', '35', '3'],
      ['cross joint', '118', '3'],
    ]);
    expect(read(scene_text({ ...form, is_fixed: false }, DRAWN), 'drawing', 'fixed_lines')).toEqual([]);
  });

  test('a note is read back, and one that is broken is not', () => {
    const set = { ...new_set(1), trace: '4', dip_scatter: '3' };
    const text = with_note('{\n [\n  [1, 2]\n ]}', 7, note_of([set], '7'));
    expect(text).toContain('[\n  // joint sets: {');
    expect(sets_in(text)).toEqual({ seed: '7', sets: [{ ...set, friction: '30' }] });
    expect(sets_in('// joint sets: {"sets": 3}\n')).toBe(null);
    expect(sets_in('// joint sets: {oops}\n')).toBe(null);
  });

  test('noise of the last digits goes', () => {
    expect(rounded_rows([[1e-16, 4.000000000000001, -7.123456789012345, 2, 3]])).toEqual([[0, 4, -7.123456789, 2, 3]]);
  });
});
