// Joint sets and outline of a scene: forms become the specification of `keyblock joints` and the text of a case.

import type { Box } from '../../draw/camera';
import type { JointRows } from '../api';
import { support_lines } from './edits';
import { type Path, type Value, write } from './json_text';
import { box_of, length_of, type Point, quantity_of } from './scene';
import { fault_in, type Schema, schema_at, title_of } from './schema';

export interface JointSet {
  name: string;
  dip: string;
  spacing: string;
  /** Length of a trace; empty: through the whole outline. */
  trace: string;
  gap: string;
  scatter: string;
  dip_scatter: string;
  friction: string;
  cohesion: string;
}

export interface SceneForm {
  kind: 'slope' | 'rectangle' | 'drawn';
  height: string;
  angle: string;
  toe: string;
  crest: string;
  base: string;
  bench: string;
  benches: string;
  width: string;
  corners: Point[];
  sets: JointSet[];
  seed: string;
  rock: string;
  youngs_modulus: string;
  gravity: string;
  is_fixed: boolean;
  steps: string;
  time_step: string;
}

export const new_set = (number: number): JointSet => ({
  name: `set ${number}`,
  dip: '90',
  spacing: '3',
  trace: '',
  gap: '',
  scatter: '0',
  dip_scatter: '0',
  friction: '30',
  cohesion: '',
});

export const first_form = (): SceneForm => ({
  kind: 'slope',
  height: '20',
  angle: '60',
  toe: '8',
  crest: '18',
  base: '4',
  bench: '0',
  benches: '1',
  width: '40',
  corners: [],
  sets: [
    { ...new_set(1), name: 'bedding', dip: '35', friction: '40' },
    { ...new_set(2), name: 'cross joint', dip: '118' },
  ],
  seed: '1',
  rock: 'limestone',
  youngs_modulus: '',
  gravity: '9.81 m/s2',
  is_fixed: true,
  steps: '300',
  time_step: '1 ms',
});

const number = (text: string, absent = Number.NaN) => (text.trim() === '' ? absent : Number(text));

/** Lengths of a joint set, and of an outline, in their forms. */
const LENGTHS_OF_SET = ['spacing', 'trace', 'gap'] as const;
const LENGTHS_OF_OUTLINE = ['height', 'width', 'toe', 'crest', 'base', 'bench'] as const;

/** Writes lengths that name a unit in the unit of the case: "15000 mm" becomes "15" in metres. */
function in_unit<T, K extends keyof T>(form: T, keys: readonly K[], unit: string): T {
  const changed = keys.flatMap(key => {
    const length = quantity_of(form[key])?.unit ? length_of(form[key], unit) : Number.NaN;
    return Number.isNaN(length) ? [] : [[key, String(Number(length.toPrecision(12)))]];
  });
  return { ...form, ...Object.fromEntries(changed) };
}

export const set_in_unit = (set: JointSet, unit: string): JointSet => in_unit(set, LENGTHS_OF_SET, unit);

export const form_in_metres = (form: SceneForm): SceneForm => ({
  ...in_unit(form, LENGTHS_OF_OUTLINE, 'm'),
  sets: form.sets.map(set => set_in_unit(set, 'm')),
});

export function set_spec(set: JointSet, material: number): Record<string, Value> {
  const trace = number(set.trace, 0);
  const gap = number(set.gap, 0);
  return {
    [SET_KEYS.dip]: number(set.dip),
    [SET_KEYS.spacing]: number(set.spacing),
    ...(trace > 0 ? { [SET_KEYS.trace]: trace } : {}),
    ...(trace > 0 && gap > 0 ? { [SET_KEYS.gap]: gap } : {}),
    [SET_KEYS.scatter]: number(set.scatter, 0),
    [SET_KEYS.dip_scatter]: number(set.dip_scatter, 0),
    joint: material,
  };
}

/** Larger one of width and height of an outline. */
export const size_of = (corners: Point[]) => {
  const box = box_of(corners);
  return box ? Math.max(box.right - box.left, box.top - box.bottom) : 0;
};

/** Joints of one set beyond which a drawing serves nobody. */
const MOST_JOINTS = 1000;

/** Keys of the numbers of a joint set in the specification, by those of the form. */
export const SET_KEYS = {
  dip: 'dip',
  dip_scatter: 'dip_scatter_deg',
  spacing: 'spacing',
  scatter: 'scatter',
  trace: 'trace',
  gap: 'gap',
} as const;

/** Numbers of an outline in the specification. */
export const OUTLINE_KEYS = {
  slope: ['height', 'angle', 'toe', 'crest', 'base', 'bench', 'benches'],
  rectangle: ['width', 'height'],
  drawn: [],
} as const;

/** Fault of a number of the specification, or the empty text. Numbers with a default may be absent. */
function fault_of_number(schema: Schema | null, path: Path, text: string, of: string): string {
  const own = schema ? schema_at(schema, path) : undefined;
  const key = String(path.at(-1));
  const is_required = !schema || schema_at(schema, path.slice(0, -1))?.required?.includes(key);
  if (text.trim() === '') return is_required ? `The ${words(key, own)}${of} must be a number.` : '';
  const value = Number(text);
  if (Number.isNaN(value)) return `The ${words(key, own)}${of} must be a number.`;
  const wrong = own ? fault_in(own, value) : '';
  return wrong && `The ${words(key, own)}${of}: expected ${wrong}.`;
}

const words = (key: string, own: Schema | undefined) => {
  const title = title_of(key, own);
  return title.charAt(0).toLowerCase() + title.slice(1);
};

/** Wrong number of a joint set in an outline of a size, or the empty text. */
export function fault_of_set(set: JointSet, size: number, schema: Schema | null): string {
  for (const [own, key] of Object.entries(SET_KEYS) as [keyof typeof SET_KEYS, string][]) {
    // A trace of length 0 goes through the whole outline.
    if (own === 'trace' && number(set[own], 0) === 0) continue;
    const fault = fault_of_number(schema, ['sets', 0, key], set[own], ` of ${set.name}`);
    if (fault && (schema || own === 'dip' || own === 'spacing')) return fault;
  }
  return size / number(set.spacing) > MOST_JOINTS ? `The spacing of ${set.name} is too small for this outline.` : '';
}

/** Field of a form that is no number where one must stand, or the empty text. */
export function fault_of(form: SceneForm, schema: Schema | null): string {
  if (form.kind === 'drawn' && form.corners.length < 3) return 'Draw the outline: click its corners.';
  for (const key of OUTLINE_KEYS[form.kind]) {
    const fault = fault_of_number(schema, [form.kind, key], form[key], '');
    if (fault && (schema || key === 'height' || key === 'width' || key === 'angle')) return fault;
  }
  const size = form.kind === 'drawn' ? size_of(form.corners) : Math.max(number(form.height), number(form.width, 0));
  const names = form.sets.map(set => set.name.trim());
  for (const [i, set] of form.sets.entries()) {
    if (!names[i] || /^\d/.test(names[i])) return `Joint set ${i + 1} needs a name that begins with a letter.`;
    if (names.indexOf(names[i]) < i) return `Two joint sets have the name ${names[i]}.`;
    const fault = fault_of_set(set, size, schema);
    if (fault) return fault;
  }
  if (!/^\d+$/.test(form.seed.trim())) return 'The seed must be a whole number.';
  return '';
}

/** Specification of `keyblock joints`. */
export function spec_of(form: SceneForm): Record<string, Value> {
  const outline: Record<string, Value> =
    form.kind === 'slope'
      ? {
          slope: {
            height: number(form.height),
            angle: number(form.angle),
            toe: number(form.toe, 0),
            crest: number(form.crest, 0),
            base: number(form.base, 1),
            bench: number(form.bench, 0),
            benches: number(form.benches, 1),
          },
        }
      : form.kind === 'rectangle'
        ? { rectangle: { width: number(form.width), height: number(form.height) } }
        : { outline: form.corners };
  return { ...outline, sets: form.sets.map((set, i) => set_spec(set, i + 1)), seed: number(form.seed, 1) };
}

/** Rows without the noise of the last digits. */
export function rounded_rows(rows: number[][]): number[][] {
  return rows.map(row => row.map((x, i) => (i < 4 ? Number((Math.abs(x) < 1e-12 ? 0 : x).toPrecision(11)) + 0 : x)));
}

/** Names the joint material of a row if it has a name. */
export function named_rows(rows: number[][], names: Value[]): Value[] {
  return rows.map(row => [...row.slice(0, 4), names[row[4] - 1] ?? row[4]]);
}

const NOTE = '// joint sets: ';

/** Comment that keeps the specification of joint sets in a case. */
export function note_of(sets: JointSet[], seed: string): string {
  const brief = sets.map(({ dip, spacing, trace, gap, scatter, dip_scatter, name }) =>
    Object.fromEntries(
      Object.entries({ name, dip, spacing, trace, gap, scatter, dip_scatter }).filter(
        ([, own]) => own !== '' && own !== '0',
      ),
    ),
  );
  return NOTE + JSON.stringify({ seed, sets: brief });
}

/** Reads the comment back. */
export function sets_in(text: string): { sets: JointSet[]; seed: string } | null {
  const found = /^[ \t]*\/\/ joint sets: (\{.*\})[ \t]*$/m.exec(text);
  if (!found) return null;
  try {
    const { seed, sets } = JSON.parse(found[1]);
    if (!Array.isArray(sets)) return null;
    return {
      seed: String(seed ?? '1'),
      sets: sets.map((own, i) => {
        const set = new_set(i + 1);
        for (const key of Object.keys(set) as (keyof JointSet)[])
          if (typeof own?.[key] === 'string') set[key] = own[key];
        return set;
      }),
    };
  } catch {
    return null;
  }
}

export const without_note = (text: string) => text.replace(/^[ \t]*\/\/ joint sets: .*\n/m, '');

/** Puts the comment on a line before the row of a list that begins at `at`. */
export function with_note(text: string, at: number, note: string): string {
  const line = text.lastIndexOf('\n', at - 1) + 1;
  const indent = text.slice(line, at);
  return /^[ \t]*$/.test(indent) ? `${text.slice(0, line)}${indent}${note}\n${text.slice(line)}` : text;
}

/** Text of the case of a form and the joints drawn for it. */
export function scene_text(form: SceneForm, drawn: JointRows): string {
  const rows = drawn.joints ?? [];
  const count = drawn.boundary_count ?? 0;
  const corners = rows.slice(0, count).map(row => [row[0], row[1]] as Point);
  const box = box_of(corners);
  const short = rounded_rows(rows);
  const names = form.sets.map(set => set.name.trim());
  const named = named_rows(short, names);
  const cells = (list: Value[]) => list.map(row => `   ${write(row)},`).join('\n');
  const fixed = form.is_fixed && corners.length ? support_lines(corners) : [];
  const top = box && form.kind === 'slope' ? [crest_of(corners, box)] : [];
  const quantity = (text: string): Value =>
    text.trim() !== '' && Number.isFinite(Number(text)) ? Number(text) : text.trim();
  const rock: Value = {
    name: 'rock',
    like: form.rock,
    ...(form.youngs_modulus.trim() ? { youngs_modulus: quantity(form.youngs_modulus) } : {}),
  };
  const joints = (form.sets.length ? form.sets : [new_set(1)]).map(set => ({
    name: set.name.trim(),
    friction_angle_deg: quantity(set.friction || '30'),
    ...(set.cohesion.trim() && set.cohesion.trim() !== '0' ? { cohesion: quantity(set.cohesion) } : {}),
  }));
  return `{
 // Drawn in the window of Keyblock.
 "keyblock": 2,
 "units": {"length": "m", "mass": "kg", "time": "s"},
 "drawing": {
  "edge_node_ratio": 0.001,
  "boundary_count": ${count},  // the first rows are the outline
  "joints": [  // x1, y1, x2, y2, joint material
${cells(named.slice(0, count))}
${rows.length > count ? `   ${note_of(form.sets, form.seed)}\n${cells(named.slice(count))}\n` : ''}  ],
  "fixed_lines": ${write(fixed.map(line => line.flat()))},  // they fix blocks where they cross edges
  "measured_points": ${write(top)},
 },
 "analysis": {
  "step_count": ${write(quantity(form.steps))},
  "time_step": ${write(quantity(form.time_step))},
  "gravity": ${write(quantity(form.gravity))},
  "block_materials": [
   ${write(rock)},
  ],
  "joint_materials": [
${joints.map(own => `   ${write(own)},`).join('\n')}
  ],
 },
}
`;
}

/** A point just inside the left end of the highest ground. */
function crest_of(corners: Point[], { top, bottom }: Box): Point {
  const [left] = corners.filter(own => own[1] > top - 1e-9).sort((a, b) => a[0] - b[0]);
  const step = (top - bottom) / 25;
  return [Number((left[0] + step).toPrecision(5)), Number((left[1] - step).toPrecision(5))];
}
