// Titles and units of entries that differ between two runs: from the schema, and from the record of a run.

import { show } from '../draw/numbers';
import { capital } from '../draw/words';
import type { Difference } from './api';
import type { Path } from './edit/case_text';
import { type Schema, schema_at, title_of, type Units, unit_in } from './edit/schema';

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
export function title_of_entry({ path, title }: Difference, schema: Schema | null): string {
  if (/ line \d+$/.test(path)) return path;
  if (title) return title;
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
  const unit = found ? unit_in(found, units ?? {}) : '';
  return [unit, unit];
}
