// Titles and units of entries that differ between two runs: from the schema, and from the record of a run.

import { show } from '../draw/numbers';
import { capital } from '../draw/words';
import type { Difference } from './api';
import type { Path } from './edit/case_text';
import { dimension_of, type Schema, schema_at, title_of, type Units, unit_in } from './edit/schema';

/** Titles of entries of run.json without a schema. */
const OF_RECORD: Record<string, string> = {
  profile_because: 'Reason for the profile',
  'outcome.end': 'End of the run',
  'outcome.steps': 'Steps',
  'outcome.time': 'Time',
  'outcome.doubts': 'Reasons for doubt',
  'outcome.ended_early': 'Reason for the early end',
  'outcome.motion.state': 'Motion at the end',
  'outcome.motion.sentences[1]': 'Motion in words',
  'outcome.motion.sentences[2]': 'Displacement in words',
  'outcome.motion.kinetic_share': 'Kinetic energy over the largest stored energy',
  'outcome.motion.fastest.speed': 'Greatest speed at the end',
  'outcome.motion.fastest.element': 'Fastest block at the end',
  'outcome.motion.fastest.x': 'Place of the fastest block, x',
  'outcome.motion.fastest.y': 'Place of the fastest block, y',
  'outcome.motion.farthest.element': 'Block moved farthest at the end',
  'outcome.motion.farthest.displacement': 'Greatest displacement at the end',
  'outcome.motion.farthest.x': 'Place of the block moved farthest, x',
  'outcome.motion.farthest.y': 'Place of the block moved farthest, y',
  'extremes.greatest_displacement.value': 'Greatest displacement',
  'extremes.greatest_displacement.element': 'Block of the greatest displacement',
  'extremes.least_principal_stress.value': 'Least principal stress',
  'extremes.least_principal_stress.element': 'Block of the least principal stress',
  'extremes.greatest_principal_stress.value': 'Greatest principal stress',
  'extremes.greatest_principal_stress.element': 'Block of the greatest principal stress',
  'extremes.least_area_share.value': 'Least share of area left',
  'extremes.least_area_share.element': 'Block of the least share of area left',
  'counts.greatest_penetration': 'Deepest overlap',
  'counts.greatest_residual': 'Largest force out of balance, over the load',
  'counts.least_dt': 'Shortest step',
  'counts.greatest_dt': 'Longest step',
  'counts.passes': 'Iterations',
  'counts.most_passes': 'Most iterations of a step',
  'counts.steps_by_passes[1].steps': 'Steps without iterations',
  'counts.steps_by_passes[2].steps': 'Steps of 1 to 3 iterations',
  'counts.steps_by_passes[3].steps': 'Steps of 4 to 10 iterations',
  'counts.steps_by_passes[4].steps': 'Steps of 11 to 40 iterations',
  'counts.steps_by_passes[5].steps': 'Steps of more than 40 iterations',
  'counts.redone_attempts': 'Attempts made again',
  'counts.fallback_solves': 'Solves by the fallback',
  'counts.unresolved_parts': 'Parts of steps short of their target',
  'counts.locked_overlaps': 'Overlaps left by impacts',
  'counts.greatest_displacement_ratio': 'Greatest displacement ratio of a step',
  'ledger.closure.energy': 'Error of the energy balance',
  'ledger.largest_energy': 'Largest energy',
  'requirements.unknowns': 'Unknowns',
  'requirements.basis': 'Basis of the unknowns',
  'start.misfit': 'Force out of balance at the start',
  'start.unsolved_steps': 'Settling steps without a solution',
  is_static: 'Static analysis',
  recorded_every: 'Steps between frames',
};

const in_words = (text: string) => text.replace(/_/g, ' ').trim();

/** Steps of a path: "a.b[2].c" has a, b, 1, c. */
const steps_of = (path: string): Path =>
  [...path.matchAll(/\[(\d+)\]|[^.[\]]+/g)].map(own => (own[1] ? Number(own[1]) - 1 : own[0]));

/** Title of a value of the case with those of the lists around it: "Joint materials 1: Friction angle". */
function of_case(path: string, schema: Schema): string {
  const steps = steps_of(path);
  const words: string[] = [];
  steps.forEach((step, i) => {
    const own = schema_at(schema, steps.slice(0, i + 1));
    if (typeof step === 'string') words.push(title_of(step, own));
    else if (own?.['x-key'] || own?.title) words.push(title_of(own['x-key'] ?? '', own));
    else words[words.length - 1] += ` ${step + 1}`;
  });
  return words.slice(words.length > 1 ? 1 : 0).join(': ');
}

/** Key of the settings and the number of the material that a value of one material has. */
function setting_of(path: string, schema: Schema | null): { own?: Schema; name: string; material: string } {
  const name = path.replace(/^settings\./, '');
  const all = schema ? schema_at(schema, ['run', 'set'])?.properties : undefined;
  const [, common, material] = /^(.*)\.(\d+)$/.exec(name) ?? [];
  if (all?.[name] || !common) return { own: all?.[name], name, material: '' };
  return { own: all?.[common], name: common, material: ` of material ${material}` };
}

/** Title of an entry of the records or of the input files of two runs. */
export function title_of_entry({ path }: Difference, schema: Schema | null): string {
  if (/ line \d+$/.test(path)) return path;
  const known = OF_RECORD[path];
  if (known) return known;
  if (path.startsWith('settings.')) {
    const { own, name, material } = setting_of(path, schema);
    return `Setting: ${title_of(name, own)}${material}`;
  }
  const [first] = steps_of(path);
  if (schema?.properties?.[String(first)] && first !== 'profile') return of_case(path, schema);
  const steps = steps_of(
    path
      .replace(/^(outcome|extremes|counts)\./, '')
      .replace(/^ledger\.(end\.)?/, 'energy_balance:.')
      .replace(/\.value$/, ''),
  );
  return capital(steps.map(own => (typeof own === 'number' ? String(own + 1) : in_words(own))).join(' '));
}

/** Keys of an object whose values speak for themselves. */
const WITHOUT_KEY = ['code', 'name', 'term', 'numbers'];

/** A value of a record in words: an object by its sentence, else key by key. */
export function words_of_value(value: unknown): string {
  if (value === undefined || value === null) return '–';
  if (typeof value === 'number') return show(value, 5);
  if (Array.isArray(value)) return value.map(words_of_value).join('; ') || 'none';
  if (typeof value !== 'object') return String(value);
  const { sentence, first } = value as Record<string, unknown>;
  if (typeof sentence === 'string' || typeof first === 'string') return String(sentence ?? first);
  return Object.entries(value)
    .map(([key, own]) =>
      WITHOUT_KEY.includes(key)
        ? words_of_value(typeof own === 'string' ? in_words(own) : own)
        : `${in_words(key)}: ${words_of_value(own)}`,
    )
    .join(', ');
}

/** Relative difference in words; none for numbers of bodies and for values in two units, of which it means nothing. */
export function relative_of_entry({ path, relative, units }: Difference): string {
  const has_none = relative === undefined || path.endsWith('.element') || (units && units[0] !== units[1]);
  return has_none ? '' : `${show(100 * relative, 3)} %`;
}

/** Units of both values: those of the record, else that of the schema in the units of the case. */
export function units_of_entry(own: Difference, schema: Schema | null, units: Units | null): [string, string] {
  if (own.units) return own.units;
  const found = schema && !own.path.includes(' ') ? schema_at(schema, steps_of(own.path)) : undefined;
  const unit = found ? unit_in(dimension_of(found), units ?? {}) : '';
  return [unit, unit];
}
