// Numbers and units as the page shows them.

const MINUS = '\u2212';

/** A number with `digits` significant digits, a true minus sign, and powers of ten beyond 10^6 and 10^-4. */
export function show(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : `${MINUS}∞`;
  if (value === 0) return '0';
  const size = Math.abs(value);
  let text: string;
  if (size >= 1e6 || size < 1e-4) {
    const [mantissa, power] = size.toExponential(digits - 1).split('e');
    text = `${mantissa.includes('.') ? mantissa.replace(/\.?0+$/, '') : mantissa}·10${raised(Number(power))}`;
  } else {
    text = size.toPrecision(digits);
    if (text.includes('e')) text = String(Number(text));
    if (text.includes('.')) text = text.replace(/\.?0+$/, '');
  }
  return value < 0 ? MINUS + text : text;
}

/** A power as raised digits: ⁻⁴. */
export function raised(power: number): string {
  const digits = '⁰¹²³⁴⁵⁶⁷⁸⁹';
  return (power < 0 ? '⁻' : '') + [...String(Math.abs(power))].map(d => digits[Number(d)]).join('');
}

export interface Scaled {
  factor: number;
  unit: string;
}

/**
 * Units that differ by a prefix alone: name, size, and the least number that is written in it; 0 for the smallest of its
 * kind, which comes last. src/problem/units/readable.cpp has the same table, so that pictures agree with the page.
 */
export const UNITS: [string, number, number][] = [
  ['m', 1, 0.1],
  ['mm', 1e-3, 0.01],
  ['µm', 1e-6, 0],
  ['m/s', 1, 0.1],
  ['mm/s', 1e-3, 0.01],
  ['µm/s', 1e-6, 0],
  ['s', 1, 0.1],
  ['ms', 1e-3, 0],
  ['GPa', 1e9, 1],
  ['MPa', 1e6, 1],
  ['kPa', 1e3, 1],
  ['Pa', 1, 0],
  ['MN', 1e6, 1],
  ['kN', 1e3, 1],
  ['N', 1, 0],
  ['MN/m', 1e6, 1],
  ['kN/m', 1e3, 1],
  ['N/m', 1, 0],
  ['MJ/m', 1e6, 1],
  ['kJ/m', 1e3, 1],
  ['J/m', 1, 0],
];

/** Unit in which values up to `size` are short; factor times the new unit's value is the old one's. */
export function scaled_unit(unit: string, size: number): Scaled {
  // An energy is spelt as force times length, and its prefixes are those of J.
  const own_name = unit.replace('N·m/', 'J/');
  let best = UNITS.findIndex(([name]) => name === own_name);
  if (best < 0 || !(size > 0)) return { factor: 1, unit };
  const own = UNITS[best][1];
  while (best > 0 && UNITS[best - 1][2] > 0) best--;
  while (size * own < UNITS[best][2] * UNITS[best][1]) best++;
  return { factor: UNITS[best][1] / own, unit: UNITS[best][0] };
}

/** A value with a unit of its own. */
export function show_with(value: number, unit: string, digits = 4): string {
  if (Number.isNaN(value)) return '–';
  const { factor, unit: name } = scaled_unit(unit, Math.abs(value));
  return `${show(value / factor, digits)}${name ? `\u00a0${name}` : ''}`;
}

/** Decimals that tell places apart by one part in `parts` of the extent of a model. */
export function place_decimals(extent: number, parts: number): number {
  return extent > 0 ? Math.max(0, Math.min(20, Math.ceil(Math.log10(parts / extent)))) : 4;
}

/** A place to a hundred-thousandth of the extent of the model, wherever its origin is. */
export function show_place(value: number, extent: number): string {
  if (!Number.isFinite(value)) return show(value);
  const digits = Math.abs(value).toFixed(place_decimals(extent, 1e5));
  const text = digits.includes('.') ? digits.replace(/\.?0+$/, '') : digits;
  return value < 0 && text !== '0' ? MINUS + text : text;
}

/** Two ends of a range with one unit. */
export function show_range(low: number, high: number, unit: string, digits = 4): string {
  const { factor, unit: name } = scaled_unit(unit, Math.max(Math.abs(low), Math.abs(high)));
  return `${show(low / factor, digits)} to ${show(high / factor, digits)}${name ? `\u00a0${name}` : ''}`;
}

/** A time, always in the unit of the case. */
export function show_time(time: number, unit?: string): string {
  return `${show(time, 4)}${unit ? `\u00a0${unit}` : ''}`;
}

/** A round number (1, 2 or 5 times a power of ten) at or below a size. */
export function round_below(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size));
  const lead = size / power;
  return (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
}

/** A round number at or above a size. */
export function round_above(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size));
  const lead = (size / power) * (1 - 1e-9);
  return Number(((lead > 5 ? 10 : lead > 2 ? 5 : lead > 1 ? 2 : 1) * power).toPrecision(6));
}

/** Whole numbers i with i * step in a range; none where they are over a thousand, or too large to tell apart. */
export function multiples(step: number, low: number, high: number): number[] {
  const [first, last] = [Math.ceil(low / step), Math.floor(high / step)];
  if (!Number.isSafeInteger(first) || !Number.isSafeInteger(last) || last - first >= 1000) return [];
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, k) => first + k);
}

/** Round ticks within a range, about `count` of them. */
export function ticks_of(low: number, high: number, count = 5): number[] {
  if (!(high > low)) return [low];
  const step = round_above((high - low) / Math.max(1, count));
  return multiples(step, low - step * 1e-9, high + step * 1e-9).map(i => (i === 0 ? 0 : i * step));
}
