// Joint sets and outline of a scene: forms become the specification of `keyblock joints` and the text of a case.

import type { JointRows } from '../api';
import { support_lines } from './edits';
import { type Value, write } from './json_text';
import { box_of, type Point } from './scene';

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

export function set_spec(set: JointSet, material: number): Record<string, Value> {
  const trace = number(set.trace, 0);
  const gap = number(set.gap, 0);
  return {
    dip: number(set.dip),
    spacing: number(set.spacing),
    ...(trace > 0 ? { trace } : {}),
    ...(trace > 0 && gap > 0 ? { gap } : {}),
    scatter: number(set.scatter, 0),
    dip_scatter_deg: number(set.dip_scatter, 0),
    joint: material,
  };
}

const size_of = (corners: Point[]) => {
  const box = box_of(corners);
  return box ? Math.max(box[2] - box[0], box[3] - box[1]) : 0;
};

/** Joints of one set beyond which a drawing serves nobody. */
const MOST_JOINTS = 1000;

/** Wrong number of a joint set in an outline of a size, or the empty text. */
export function fault_of_set(set: JointSet, size: number): string {
  if (Number.isNaN(number(set.dip))) return `The dip of ${set.name} must be a number.`;
  if (!(number(set.spacing) > 0)) return `The spacing of ${set.name} must be a number above 0.`;
  if (size / number(set.spacing) > MOST_JOINTS) return `The spacing of ${set.name} is too small for this outline.`;
  if (!(number(set.scatter, 0) >= 0 && number(set.scatter, 0) <= 1))
    return `The scatter of ${set.name} must lie between 0 and 1.`;
  if (!(number(set.dip_scatter, 0) >= 0)) return `The scatter of the dip of ${set.name} must be 0 or more.`;
  return '';
}

/** Field of a form that is no number where one must stand, or the empty text. */
export function fault_of(form: SceneForm): string {
  const wrong = (text: string, least: number, may_be_empty = false) =>
    text.trim() === ''
      ? !may_be_empty
      : !(Number(text) > least) && !(least === 0 && may_be_empty && Number(text) === 0);
  if (form.kind === 'drawn' && form.corners.length < 3) return 'Draw the outline: click its corners.';
  if (form.kind !== 'drawn' && wrong(form.height, 0)) return 'The height must be a number above 0.';
  if (form.kind === 'rectangle' && wrong(form.width, 0)) return 'The width must be a number above 0.';
  if (form.kind === 'slope' && !(number(form.angle) > 0 && number(form.angle) <= 90))
    return 'The angle of the face must be above 0 and at most 90 degrees.';
  const size = form.kind === 'drawn' ? size_of(form.corners) : Math.max(number(form.height), number(form.width, 0));
  const names = form.sets.map(set => set.name.trim());
  for (const [i, set] of form.sets.entries()) {
    if (!names[i] || /^\d/.test(names[i])) return `Joint set ${i + 1} needs a name that begins with a letter.`;
    if (names.indexOf(names[i]) < i) return `Two joint sets have the name ${names[i]}.`;
    const fault = fault_of_set(set, size);
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
  const top = box && form.kind === 'slope' ? [crest_of(corners, box[3])] : [];
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
function crest_of(corners: Point[], top: number): Point {
  const [left] = corners.filter(own => own[1] > top - 1e-9).sort((a, b) => a[0] - b[0]);
  const box = box_of(corners)!;
  const step = (box[3] - box[1]) / 25;
  return [Number((left[0] + step).toPrecision(5)), Number((left[1] - step).toPrecision(5))];
}
