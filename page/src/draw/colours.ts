// Colours of materials, lines and values, from the palette that the program draws with, too.

import palette from './palette.json';

/**
 * Maps of amounts. Viridis: van der Walt and Smith; cividis: Nunez, Anderton and Renslow; both are dedicated to the
 * public domain. The rising map is OrRd, the one about zero RdBu, of ColorBrewer (Brewer 2003).
 */
export const SEQUENTIAL = ['rising', 'viridis', 'cividis', 'grey'] as const;
export type MapName = (typeof SEQUENTIAL)[number];

const channels = (hex: string): number[] => [1, 3, 5].map(i => Number.parseInt(hex.slice(i, i + 2), 16));

const made = new Map<string, Uint8Array>();

/** RGB of 256 steps of the part of a map between two shares of it. */
export function table_of(name: MapName | 'about_zero', from = 0, to = 1): Uint8Array {
  const key = `${name} ${from} ${to}`;
  let table = made.get(key);
  if (!table) {
    const stops = palette[name].map(channels);
    table = new Uint8Array(768);
    for (let i = 0; i < 256; i++) {
      const at = (from + (i / 255) * (to - from)) * (stops.length - 1);
      const low = Math.min(Math.floor(at), stops.length - 2);
      for (let c = 0; c < 3; c++) {
        table[3 * i + c] = Math.round(stops[low][c] + (at - low) * (stops[low + 1][c] - stops[low][c]));
      }
    }
    made.set(key, table);
  }
  return table;
}

/** Share of the map about zero from white to the palest colour of values that are all far from 0. */
const PALEST = 0.08;

/** Table of values from `low` to `high`: white at 0, as strong on either side; from pale to strong where 0 is beyond. */
export function table_about_zero(low: number, high: number): Uint8Array {
  if (high < 0) return table_of('about_zero', 0, 0.5 - PALEST);
  if (low > 0) return table_of('about_zero', 0.5 + PALEST, 1);
  const most = Math.max(-low, high) || 1;
  return table_of('about_zero', 0.5 + low / most / 2, 0.5 + high / most / 2);
}

/** Colours of areas by material or state, and of lines by joint material or curve, of which there are any number. */
export const areas_of = (is_dark: boolean): string[] => (is_dark ? palette.areas_on_dark : palette.areas);
export const lines_of = (is_dark: boolean): string[] => (is_dark ? palette.lines_on_dark : palette.lines);

/** Colour of pressure and of tension on a light ground: the ends of the map about zero. */
export const [COMPRESSION, TENSION] = [palette.about_zero[0], palette.about_zero[4]];

/** Table of 256 in which entry i is the colour of class i, with repeats. */
export function class_table(colours: string[]): Uint8Array {
  const table = new Uint8Array(768);
  for (let i = 0; i < 256; i++) table.set(channels(colours[i % colours.length]), 3 * i);
  return table;
}

/** Index of a value in a table of 256. */
export function index_of(t: number): number {
  return t <= 0 ? 0 : t >= 1 ? 255 : Math.round(t * 255);
}

export function css_of(table: Uint8Array, index: number): string {
  return `rgb(${table[3 * index]},${table[3 * index + 1]},${table[3 * index + 2]})`;
}
