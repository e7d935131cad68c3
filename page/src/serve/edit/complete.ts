// Finds what can be typed at a place of a case's text: keys, words and examples of the schema.

import type { Path } from './case_text';
import { type Schema, schema_at, words_on } from './schema';

export interface Place {
  /** Path of the object or list around the place, or of the key whose value stands here. */
  path: Path;
  kind: 'key' | 'value';
  /** Part of the text that a choice replaces. */
  from: number;
  to: number;
  /** Letters typed so far, without quotation marks. */
  typed: string;
  /** Keys that the object has already. */
  taken: string[];
}

interface Level {
  is_object: boolean;
  path: Path;
  keys: string[];
  /** Key whose value is being read. */
  key: string | null;
  count: number;
}

/** Reads the text up to a place; the text may have faults elsewhere. */
export function place_at(text: string, caret: number): Place | null {
  const levels: Level[] = [];
  let key: string | null = null;
  let at = 0;
  while (at < caret) {
    const c = text[at];
    const top = levels.at(-1);
    if (c === '/' && text[at + 1] === '/') {
      const end = text.indexOf('\n', at);
      if (end < 0 || end >= caret) return null;
      at = end;
    } else if (c === '/' && text[at + 1] === '*') {
      const end = text.indexOf('*/', at + 2);
      if (end < 0 || end + 2 > caret) return null;
      at = end + 2;
    } else if (c === '"') {
      const end = end_of_string(text, at);
      if (end > caret || (end === caret && text[end - 1] !== '"') || caret === at + 1)
        return in_string(text, levels, at, caret);
      const word = text.slice(at + 1, end - 1);
      if (top?.is_object && top.key === null) key = word;
      at = end;
    } else if (c === '{' || c === '[') {
      levels.push({ is_object: c === '{', path: path_of(levels), keys: [], key: null, count: 0 });
      key = null;
      at++;
    } else if (c === '}' || c === ']') {
      levels.pop();
      at++;
    } else if (c === ':') {
      if (top && key !== null) {
        top.key = key;
        top.keys.push(key);
      }
      at++;
    } else if (c === ',') {
      if (top) {
        top.key = null;
        top.count++;
      }
      key = null;
      at++;
    } else at++;
  }
  const top = levels.at(-1);
  if (!top) return null;
  const start = caret - /[\w.+-]*$/.exec(text.slice(0, caret))![0].length;
  return place(text, levels, start, caret + /^[\w.+-]*/.exec(text.slice(caret))![0].length, text.slice(start, caret));
}

function end_of_string(text: string, from: number): number {
  let at = from + 1;
  while (at < text.length && text[at] !== '"' && text[at] !== '\n') at += text[at] === '\\' ? 2 : 1;
  return text[at] === '"' ? at + 1 : at;
}

function path_of(levels: Level[]): Path {
  const top = levels.at(-1);
  if (!top) return [];
  return [...top.path, top.is_object ? (top.key ?? '') : top.count];
}

function in_string(text: string, levels: Level[], from: number, caret: number): Place | null {
  const end = end_of_string(text, from);
  // A text that is being typed has no end yet: a quotation mark further on the line opens the next text.
  const is_closed =
    text[end - 1] === '"' &&
    end > from + 1 &&
    !/[,:{}[\]]/.test(text.slice(from + 1, end - 1)) &&
    !/\w/.test(text[end] ?? '');
  const word = /^[\w.+-]*/.exec(text.slice(caret))![0].length;
  return place(text, levels, from, is_closed ? end : caret + word, text.slice(from + 1, caret));
}

function place(text: string, levels: Level[], from: number, to: number, typed: string): Place | null {
  const top = levels.at(-1);
  if (!top) return null;
  const is_key = top.is_object && top.key === null;
  // Keys behind the place count as taken, too.
  const taken = is_key ? [...top.keys, ...keys_behind(text, to)] : [];
  return { path: is_key ? top.path : path_of(levels), kind: is_key ? 'key' : 'value', from, to, typed, taken };
}

/** Keys of the object that stand behind a place. */
function keys_behind(text: string, from: number): string[] {
  const keys: string[] = [];
  let depth = 0;
  let at = from;
  while (at < text.length && depth >= 0) {
    const c = text[at];
    if (c === '"') {
      const end = end_of_string(text, at);
      if (depth === 0 && /^\s*:/.test(text.slice(end, end + 20))) keys.push(text.slice(at + 1, end - 1));
      at = end;
      continue;
    }
    if (c === '/' && text[at + 1] === '/') {
      const end = text.indexOf('\n', at);
      at = end < 0 ? text.length : end;
      continue;
    }
    if (c === '{' || c === '[') depth++;
    if (c === '}' || c === ']') depth--;
    at++;
  }
  return keys;
}

/** Names of materials; numbers of those without a name. */
export interface Names {
  block: (string | number)[];
  joint: (string | number)[];
}

export interface Choice {
  /** Text to write. */
  text: string;
  label: string;
  meaning: string;
}

/** Choices at a place, those that begin as typed first. */
export function choices_at(schema: Schema, place: Place, names: Names): Choice[] {
  const own = schema_at(schema, place.path);
  if (!own) return [];
  const found = place.kind === 'key' ? keys_of(own, place.taken) : values_of(own, place.path, names);
  const typed = place.typed.toLowerCase();
  // A letter or two must begin a word of the label.
  const rank = (label: string) => {
    const own = label.toLowerCase();
    if (own.startsWith(typed)) return 0;
    const is_word = own.split(/[_ ]/).some(word => word.startsWith(typed));
    return is_word || (typed.length > 2 && own.includes(typed)) ? 1 : 2;
  };
  return found.filter(one => rank(one.label) < 2).sort((a, b) => rank(a.label) - rank(b.label));
}

function keys_of(own: Schema, taken: string[]): Choice[] {
  return Object.entries(own.properties ?? {})
    .filter(([key]) => !taken.includes(key))
    .map(([key, schema]) => ({ text: `"${key}": ${start_of(schema)}`, label: key, meaning: words_on(schema) }));
}

/** Begin of a value of a kind. */
function start_of(own: Schema): string {
  const type = Array.isArray(own.type) ? own.type[0] : own.type;
  if (type === 'object') return '{}';
  if (type === 'array') return '[]';
  return own.default === undefined ? '' : JSON.stringify(own.default);
}

function values_of(own: Schema, path: Path, names: Names): Choice[] {
  const meaning = words_on(own);
  const choice = (value: unknown): Choice => {
    const word = own['x-words']?.[String(value)];
    return { text: JSON.stringify(value), label: String(value), meaning: word ? `${word}. ${meaning}` : meaning };
  };
  const words = [...(own.enum ?? []), ...(own.anyOf ?? []).flatMap(one => one.enum ?? [])];
  const is_joint = own['x-key'] === 'joint_material' || path.at(-1) === 'joint_material';
  const is_block = own['x-key'] === 'block_material' || path.at(-1) === 'block_material';
  const known = is_joint ? names.joint : is_block ? names.block : [];
  const type = Array.isArray(own.type) ? own.type : [own.type];
  return [
    ...words,
    ...known,
    ...(type.includes('boolean') ? [true, false] : []),
    ...(words.length ? [] : (own.examples ?? [])),
    ...(own.default !== undefined && !words.includes(own.default) && !type.includes('boolean') ? [own.default] : []),
  ].map(choice);
}
