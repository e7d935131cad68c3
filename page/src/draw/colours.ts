// Colour maps that people with any colour vision can read, as tables of 256 colours.

/** Stops of a map from low to high, as hexadecimal RGB. */
const STOPS: Record<string, string> = {
  // Viridis (van der Walt and Smith, dedicated to the public domain).
  viridis: '440154 482475 414487 355f8d 2a788e 21918c 22a884 44bf70 7ad151 bddf26 fde725',
  // Cividis (Nunez, Anderton and Renslow), made for colour-vision deficiency; dedicated to the public domain.
  cividis: '00224e 123570 3b496c 575d6d 707173 8a8678 a59c74 c3b369 e1cc55 fee838',
  grey: 'f2f2f2 d0d0d0 a8a8a8 808080 585858 303030',
  // Blue through near white to orange: its ends differ in hue that all see and in side alone.
  signed: '08396b 1f66a8 5b9bce a5c8e4 f4f4f2 f6c08a e88a3a bd5a12 7a3503',
};

export const SEQUENTIAL = ['viridis', 'cividis', 'grey'] as const;
export type MapName = keyof typeof STOPS;

const made = new Map<string, Uint8Array>();

/** RGB of 256 steps of a map. */
export function table_of(name: string): Uint8Array {
  let table = made.get(name);
  if (!table) {
    const stops = (STOPS[name] ?? STOPS.viridis)
      .split(' ')
      .map(hex => [0, 2, 4].map(i => Number.parseInt(hex.slice(i, i + 2), 16)));
    table = new Uint8Array(768);
    for (let i = 0; i < 256; i++) {
      const at = (i / 255) * (stops.length - 1);
      const low = Math.min(Math.floor(at), stops.length - 2);
      for (let c = 0; c < 3; c++) {
        table[3 * i + c] = Math.round(stops[low][c] + (at - low) * (stops[low + 1][c] - stops[low][c]));
      }
    }
    made.set(name, table);
  }
  return table;
}

/** Colours of states and materials: Okabe and Ito's set, lightened for areas, then repeats of it in other shades. */
export const CLASSES = ['#8fb8de', '#e9b872', '#7fc4a8', '#d998bb', '#e8dc7a', '#c98f6b', '#a3a8e0', '#b5b5b5'];

/** Table of 256 in which entry i is the colour of class i, with repeats. */
export function class_table(colours: string[] = CLASSES): Uint8Array {
  const table = new Uint8Array(768);
  for (let i = 0; i < 256; i++) {
    const hex = colours[i % colours.length];
    for (let c = 0; c < 3; c++) table[3 * i + c] = Number.parseInt(hex.slice(1 + 2 * c, 3 + 2 * c), 16);
  }
  return table;
}

/** Index of a value in a table of 256. */
export function index_of(t: number): number {
  return t <= 0 ? 0 : t >= 1 ? 255 : Math.round(t * 255);
}

export function css_of(table: Uint8Array, index: number): string {
  return `rgb(${table[3 * index]},${table[3 * index + 1]},${table[3 * index + 2]})`;
}
