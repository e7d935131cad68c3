// Reads the schema of a case file: what stands at a path, with title, unit, limits and meaning.

import { capital, sentence } from '../../draw/words';
import type { Path, Step } from './case_text';

export interface Schema {
  type?: string | string[];
  title?: string;
  description?: string;
  default?: unknown;
  examples?: unknown[];
  enum?: unknown[];
  properties?: Record<string, Schema>;
  items?: Schema | boolean;
  prefixItems?: Schema[];
  anyOf?: Schema[];
  required?: string[];
  additionalProperties?: Schema | boolean;
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  exclusiveMaximum?: number;
  /** Key of a place in a row. */
  'x-key'?: string;
  /** Letters of the dimension, an angle, or "none". */
  'x-unit'?: string;
  /** True if the number is per unit of thickness. */
  'x-of-slice'?: boolean;
  /** Permitted values in words. */
  'x-permitted'?: string;
  /** Group among the keys of an object. */
  'x-group'?: string;
  /** Meanings of permitted words. */
  'x-words'?: Record<string, string>;
  /** Default that depends on other keys, in words. */
  'x-default'?: string;
  /** Sections of a form. */
  'x-sections'?: Section[];
}

/** Section of the form of a case; `row` is the noun for one row of a list. */
export interface Section {
  title: string;
  row: string;
  path: Path;
}

/** Returns the schema of the value at a path. */
export function schema_at(root: Schema, path: Path): Schema | undefined {
  let own: Schema | undefined = root;
  for (const step of path) {
    if (!own) return undefined;
    own = below(own, step);
  }
  return own;
}

function below(own: Schema, step: Step): Schema | undefined {
  if (typeof step === 'string') return own.properties?.[step];
  if (own.prefixItems && step < own.prefixItems.length) return own.prefixItems[step];
  return typeof own.items === 'object' ? own.items : undefined;
}

/** Title of a key for people: that of the schema, else the key in words. */
export function title_of(key: string, own: Schema | undefined): string {
  if (own?.title) return own.title;
  const words = key.replace(/_/g, ' ');
  return capital(words);
}

const titles = new WeakMap<Schema, Map<string, string>>();

/** Titles of all keys of a schema, by their keys. */
function titles_in(schema: Schema): Map<string, string> {
  let found = titles.get(schema);
  if (found) return found;
  found = new Map();
  const visit = (own: unknown): void => {
    if (typeof own !== 'object' || own === null) return;
    for (const [key, value] of Object.entries((own as Schema).properties ?? {}))
      if (value.title && !found.has(key)) found.set(key, value.title);
    Object.values(own).forEach(visit);
  };
  visit(schema);
  titles.set(schema, found);
  return found;
}

/** Replaces the keys in a sentence of the program by the titles that forms show. */
export function with_titles(sentence: string, schemas: (Schema | null)[]): string {
  return sentence.replace(/\b[a-z]+(_[a-z]+)+\b/g, key => {
    for (const schema of schemas) {
      const title = schema && titles_in(schema).get(key);
      if (title) return `“${title}”`;
    }
    return key;
  });
}

/** Units that a case declares, by the letters of a dimension; the program makes this table. */
export type Units = Record<string, string>;

/** Unit of a number in a case; empty without one, and for a dimension whose units the case does not declare. */
export function unit_in(own: Schema, units: Units): string {
  const letters = own['x-unit'] ?? 'none';
  if (letters === 'none') return '';
  return letters === 'deg' ? '°' : (units[own['x-of-slice'] ? `${letters} of a slice` : letters] ?? '');
}

/** Words of a description without its limits. */
export function meaning_of(own: Schema): string {
  const limits = own['x-permitted'];
  const text = (own.description ?? '').replace(limits ? `. Permitted: ${limits}` : '', '').trim();
  return sentence(text);
}

/** Words on the permitted values, or the empty text. */
export const limits_of = (own: Schema): string => own['x-permitted'] ?? '';

/** Meaning, limits and default in sentences. */
export function words_on(own: Schema): string {
  const limits = limits_of(own);
  const absent = own.default === undefined ? own['x-default'] : JSON.stringify(own.default);
  return `${meaning_of(own)}${limits ? ` Permitted: ${limits}.` : ''}${absent ? ` Default: ${absent}.` : ''}`.trim();
}

/** Title of a permitted word with its meaning: "free: centred on the bodies". */
export function words_of(own: Schema, word: unknown): string {
  const text = String(word).replace(/_/g, ' ');
  const meaning = own['x-words']?.[String(word)];
  return meaning ? `${text}: ${meaning}` : text;
}

/** Keys of an object by their groups, in the order of the schema. */
export function by_group<T extends { own: Schema }>(keys: T[]): [string, T[]][] {
  const groups = new Map<string, T[]>();
  for (const key of keys) {
    const name = key.own['x-group'] ?? 'General';
    groups.set(name, [...(groups.get(name) ?? []), key]);
  }
  return [...groups];
}

/** True if the value may be a number with a unit. */
export const takes_unit = (own: Schema) =>
  Array.isArray(own.type) && own.type.includes('string') && own.type.includes('number');

/** Returns what is wrong with a value, or the empty text. Values with units are left to the check of the program. */
export function fault_in(own: Schema, value: unknown): string {
  if (own.enum) return own.enum.includes(value) ? '' : `one of ${own.enum.join(', ')}`;
  const types = Array.isArray(own.type) ? own.type : own.type ? [own.type] : [];
  if (typeof value === 'string') {
    if (!types.length || types.includes('string')) return '';
    return types.includes('integer') ? 'a whole number' : types.includes('boolean') ? 'true or false' : 'a number';
  }
  if (typeof value !== 'number') return '';
  const limits = limits_of(own);
  if (types.includes('integer') && !Number.isInteger(value)) return limits || 'a whole number';
  return is_out_of(own, value) ? limits || 'another number' : '';
}

const is_out_of = (own: Schema, value: number): boolean =>
  value < (own.minimum ?? -Infinity) ||
  value > (own.maximum ?? Infinity) ||
  value <= (own.exclusiveMinimum ?? -Infinity) ||
  value >= (own.exclusiveMaximum ?? Infinity);
