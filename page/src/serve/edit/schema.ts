// Reads the schema of a case file: what stands at a path, with title, unit, limits and meaning.

import type { Path, Step } from './json_text';

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

const TITLES: Record<string, string> = {
  youngs_modulus: "Young's modulus",
  poissons_ratio: "Poisson's ratio",
  friction_angle_deg: 'Friction angle',
  friction_deg: 'Friction angle',
  dilation_deg: 'Dilation angle',
  dip_scatter_deg: 'Scatter of the dip',
  like: 'Library entry',
  xx: 'xx',
  yy: 'yy',
  xy: 'xy',
  x: 'x',
  y: 'y',
};

/** Title of a key for people. */
export function title_of_key(key: string): string {
  if (key in TITLES) return TITLES[key];
  const words = key.replace(/_deg$/, '').replace(/_/g, ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** Dimension or unit that a description names: "F/L²", "degrees". */
export function dimension_of(own: Schema): string {
  const text = own.description ?? '';
  if (/\bdegrees\b/.test(text) && !/^1\b/.test(text)) return '°';
  const found =
    /(?:^|, |\. )((?:[MLTF]|1)(?:[¹²³⁴]|\^[\d.]+)?(?:(?: |\/)(?:[MLT]|F)(?:[¹²³]|\^[\d.]+)?)*)(?=[,;.]|$)/.exec(text);
  return found && found[1] !== '1' ? found[1] : '';
}

/** Units of a case file by their keys. */
export type Units = Record<string, string>;

/** Writes a dimension in the units of the file: F/L² becomes N/m² with m, kg and s. */
export function unit_in(dimension: string, units: Units): string {
  if (!units.length) return dimension;
  const { length, time, mass } = units;
  const is_si = length === 'm' && mass === 'kg' && time === 's';
  const force = units.force ?? (is_si ? 'N' : '');
  if (dimension.includes('F') && !force) return dimension;
  if (dimension === 'F/L²' && is_si) return 'Pa';
  const own: Units = { L: length, T: time, M: mass ?? '', F: force };
  const text = dimension.replace(/[LTMF]/g, letter => own[letter] || letter);
  return /[LTMF]/.test(dimension) && Object.entries(own).some(([letter, word]) => !word && dimension.includes(letter))
    ? dimension
    : text;
}

/** Words of a description without its limits. */
export function meaning_of(own: Schema): string {
  const text = (own.description ?? '').replace(/\.? ?Permitted: [^;]*$/, '').trim();
  const sentence = text.charAt(0).toUpperCase() + text.slice(1);
  return sentence && !/[.!?]$/.test(sentence) ? `${sentence}.` : sentence;
}

/** Words on the permitted values, or the empty text. */
export function limits_of(own: Schema): string {
  return /Permitted: ([^;]*)$/.exec(own.description ?? '')?.[1].replace(/\.$/, '') ?? '';
}

/** True if the value may be a number with a unit. */
export const takes_unit = (own: Schema) =>
  Array.isArray(own.type) && own.type.includes('string') && own.type.includes('number');

const NUMBER = '(-?[\\d.]+(?:e-?\\d+)?)';

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
  if ((types.includes('integer') || /whole number/.test(limits)) && !Number.isInteger(value))
    return limits || 'a whole number';
  return is_out_of(limits, value) ? limits : '';
}

/** True if a number breaks limits such as "greater than 0", "0 to 0.5", "at least 0 and below 90 degrees", "0 or more". */
function is_out_of(limits: string, value: number): boolean {
  const after = (words: string) => {
    const found = new RegExp(`${words} ${NUMBER}`).exec(limits);
    return found ? Number(found[1]) : Number.NaN;
  };
  const range = new RegExp(`${NUMBER} to ${NUMBER}`).exec(limits);
  const or_more = new RegExp(`${NUMBER} or more`).exec(limits);
  return (
    (range !== null && (value < Number(range[1]) || value > Number(range[2]))) ||
    (or_more !== null && value < Number(or_more[1])) ||
    value <= after('greater than') ||
    value < after('at least') ||
    value >= after('below')
  );
}
