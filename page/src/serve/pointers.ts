// Values of a case file that a sweep may change, by their pointers.

import { find, type Node, parse, plain, type Value } from './edit/case_text';

/** Number with a unit: "20 deg". */
const QUANTITY = /^[-+]?[0-9.]+(e[-+]?[0-9]+)? *[^0-9 ].*$/i;

/** Values that a list offers. */
const MOST = 500;

/** Pointers of the numbers in a case file, JSON or YAML, with their values: "/analysis/gravity". */
export function pointers_in(text: string): [string, number | string][] {
  let root: Node;
  try {
    root = parse(text);
  } catch {
    return [];
  }
  const found: [string, number | string][] = [];
  const walk = (own: Value, path: string) => {
    if (found.length >= MOST) return;
    if (typeof own === 'number' || (typeof own === 'string' && QUANTITY.test(own))) found.push([path, own]);
    else if (Array.isArray(own)) {
      // Lists of numbers are coordinates.
      if (!own.some(item => typeof item === 'number'))
        for (const [i, item] of own.entries()) walk(item, `${path}/${i}`);
    } else if (own && typeof own === 'object') {
      for (const [key, item] of Object.entries(own))
        walk(item, `${path}/${key.replace(/~/g, '~0').replace(/\//g, '~1')}`);
    }
  };
  for (const part of ['analysis', 'blocks', 'drawing', 'covers', 'stages']) {
    const own = plain(find(root, [part]));
    if (own !== undefined) walk(own, `/${part}`);
  }
  return found;
}
