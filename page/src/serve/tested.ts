// Element tests and fits: numbers of their forms, and their records as rows with titles and units.

import { show, show_with } from '../draw/numbers';

/** Number in a field of a form; undefined if the field is empty. Throws a sentence with the label of the field. */
export function number_in(label: string, text: string, is_whole = false): number | undefined {
  if (!text.trim()) return undefined;
  const value = Number(text);
  if (is_whole ? !(Number.isSafeInteger(value) && value > 0) : !Number.isFinite(value))
    throw new Error(`${label}: expected ${is_whole ? 'a whole number from 1' : 'a number'}, found ${text.trim()}`);
  return value;
}

/** Numbers in a field, between blanks or commas. Throws a sentence if there is none, or anything else. */
export function numbers_in(label: string, text: string): number[] {
  const words = text.split(/[\s,]+/).filter(Boolean);
  if (!words.length) throw new Error(`${label}: expected numbers, found none`);
  return words.map(word => number_in(label, word)!);
}

/** Record of an element test or of a fit, as far as the window shows it. */
export interface TestRecord {
  points?: number;
  /** Parameters of a fit. */
  parameters?: Record<string, Parameter>;
  residual?: { rms: number; largest: number; r_squared: number | null };
  warnings?: { sentence?: string }[];
  material?: Record<string, unknown>;
  /** Stresses of an element test. */
  least_stress?: number;
  greatest_stress?: number;
  end?: { strain: number[]; stress: number[]; kappa: number; plastic_work: number };
  units?: { stress: string };
}

export interface Parameter {
  value: number;
  standard_error: number | null;
  interval: [number | null, number | null];
  unit: string;
}

const PARAMETERS: Record<string, string> = {
  youngs_modulus: "Young's modulus",
  initial_modulus: 'Initial modulus',
  closure_strain: 'Closure strain of cracks',
  strength: 'Strength',
  cohesion: 'Cohesion',
  friction_deg: 'Friction angle',
  ratio: 'Slope of s1 over s3',
  compressive_strength: 'Uniaxial compressive strength',
  toughness: 'Toughness',
};

/** Units as the window writes them: a plain number has none. */
const UNITS: Record<string, string> = { '1': '', degrees: '°' };

/** Cells of the fitted parameters: title, value, standard error, ends of the interval of 95 %, unit. */
export function parameter_rows(record: TestRecord): string[][] {
  return Object.entries(record.parameters ?? {}).map(([name, own]) => [
    PARAMETERS[name] ?? name.replace(/_/g, ' '),
    show(own.value, 5),
    show(own.standard_error, 3),
    ...own.interval.map(end => show(end, 5)),
    UNITS[own.unit] ?? own.unit,
  ]);
}

const COMPONENTS = ['xx', 'yy', 'xy', 'zz'];

/** Other values: titles, and values with units. */
export function value_rows(record: TestRecord): [string, string][] {
  const unit = record.units?.stress ?? Object.values(record.parameters ?? {})[0]?.unit ?? '';
  const with_unit = (value: number) => show_with(value, unit, 5);
  const rows: [string, string | undefined][] = [
    ['Points', record.points?.toString()],
    ['Residual, root mean square', record.residual && with_unit(record.residual.rms)],
    ['Largest residual', record.residual && with_unit(record.residual.largest)],
    ['R²', typeof record.residual?.r_squared === 'number' ? show(record.residual.r_squared, 7) : undefined],
    ['Least stress', record.least_stress === undefined ? undefined : with_unit(record.least_stress)],
    ['Greatest stress', record.greatest_stress === undefined ? undefined : with_unit(record.greatest_stress)],
  ];
  const { end } = record;
  if (end) {
    // The third strain is the engineering shear strain.
    for (const [i, name] of COMPONENTS.entries()) {
      rows.push([`Strain ${i === 2 ? '2' : ''}${name} at the end`, show(end.strain[i], 5)]);
      rows.push([`Stress ${name} at the end`, with_unit(end.stress[i])]);
    }
    rows.push(['Hardening variable κ at the end', show(end.kappa, 5)], ['Plastic work', with_unit(end.plastic_work)]);
  }
  return rows.filter((row): row is [string, string] => row[1] !== undefined);
}
