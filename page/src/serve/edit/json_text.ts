// JSON with comments as text: reads it with the place of every value, and changes one value at its place.
// Comments, order and layout of the rest stay. Trailing commas are allowed.

export type Step = string | number;
export type Path = Step[];
export type Value = string | number | boolean | null | Value[] | { [key: string]: Value };

export interface Node {
  kind: 'object' | 'array' | 'string' | 'number' | 'word';
  from: number;
  to: number;
  /** Value of a string, number or word. */
  value?: string | number | boolean | null;
  /** Items of an array or object, in the order of the text. */
  items: Node[];
  /** Keys of an object, one per item. */
  keys: { name: string; from: number; to: number }[];
}

export class JsonError extends Error {
  constructor(
    message: string,
    readonly at: number,
  ) {
    super(message);
  }
}

/** Returns the index of the next character that is neither blank nor in a comment. */
export function after_blanks(text: string, at: number): number {
  for (;;) {
    const c = text[at];
    if (c === ' ' || c === '\t' || c === '\n' || c === '\r' || c === '\ufeff') at++;
    else if (c === '/' && text[at + 1] === '/') {
      const end = text.indexOf('\n', at);
      at = end < 0 ? text.length : end;
    } else if (c === '/' && text[at + 1] === '*') {
      const end = text.indexOf('*/', at + 2);
      if (end < 0) throw new JsonError('a comment has no end', at);
      at = end + 2;
    } else return at;
  }
}

function string_at(text: string, from: number): Node {
  let at = from + 1;
  while (at < text.length && text[at] !== '"' && text[at] !== '\n') at += text[at] === '\\' ? 2 : 1;
  if (text[at] !== '"') throw new JsonError('a text has no closing quotation mark', from);
  let value: string;
  try {
    value = JSON.parse(text.slice(from, at + 1));
  } catch {
    throw new JsonError('a text has a wrong escape', from);
  }
  return { kind: 'string', from, to: at + 1, value, items: [], keys: [] };
}

const NUMBER = /[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/y;
const WORD = /[A-Za-z_]+/y;

function scalar_at(text: string, at: number): Node {
  NUMBER.lastIndex = at;
  const number = NUMBER.exec(text);
  if (number)
    return { kind: 'number', from: at, to: at + number[0].length, value: Number(number[0]), items: [], keys: [] };
  WORD.lastIndex = at;
  const word = WORD.exec(text)?.[0];
  if (word === 'true' || word === 'false' || word === 'null')
    return { kind: 'word', from: at, to: at + word.length, value: JSON.parse(word), items: [], keys: [] };
  throw new JsonError(at < text.length ? `a value was expected, not ${word ?? text[at]}` : 'the text ends early', at);
}

function value_at(text: string, start: number, depth: number): Node {
  const from = after_blanks(text, start);
  const open = text[from];
  if (open === '"') return string_at(text, from);
  if (open !== '{' && open !== '[') return scalar_at(text, from);
  if (depth > 100) throw new JsonError('the lists are nested too deeply', from);
  const close = open === '{' ? '}' : ']';
  const node: Node = { kind: open === '{' ? 'object' : 'array', from, to: from, items: [], keys: [] };
  let at = after_blanks(text, from + 1);
  while (text[at] !== close) {
    if (open === '{') {
      if (text[at] !== '"') throw new JsonError('a key in quotation marks was expected', at);
      const key = string_at(text, at);
      node.keys.push({ name: String(key.value), from: key.from, to: key.to });
      at = after_blanks(text, key.to);
      if (text[at] !== ':') throw new JsonError('a colon was expected behind the key', at);
      at++;
    }
    const item = value_at(text, at, depth + 1);
    node.items.push(item);
    at = after_blanks(text, item.to);
    if (text[at] === ',') at = after_blanks(text, at + 1);
    else if (text[at] !== close) throw new JsonError(`a comma or ${close} was expected`, at);
  }
  node.to = at + 1;
  return node;
}

/** Reads a whole text. Throws JsonError. */
export function parse(text: string): Node {
  const node = value_at(text, 0, 0);
  const end = after_blanks(text, node.to);
  if (end < text.length) throw new JsonError('something follows the end', end);
  return node;
}

/** Returns a value below a node; of keys that are given twice the last. */
export function find(node: Node | undefined, path: Path): Node | undefined {
  let own = node;
  for (const step of path) {
    if (!own) return undefined;
    if (typeof step === 'number') own = own.kind === 'array' ? own.items[step] : undefined;
    else {
      const keys: Node['keys'] = own.kind === 'object' ? own.keys : [];
      const index = keys.map(key => key.name).lastIndexOf(step);
      own = index < 0 ? undefined : own.items[index];
    }
  }
  return own;
}

/** Returns the plain value of a node. */
export function plain(node: Node | undefined): Value | undefined {
  if (!node) return undefined;
  if (node.kind === 'array') return node.items.map(item => plain(item)!);
  if (node.kind === 'object') return Object.fromEntries(node.keys.map((key, i) => [key.name, plain(node.items[i])!]));
  return node.value;
}

/** Returns a number without noise of the last digits. */
export function tidy(value: number): number {
  return Number(value.toPrecision(12));
}

const INLINE = 100;

export function inline(value: Value): string {
  if (Array.isArray(value)) return `[${value.map(inline).join(', ')}]`;
  if (value !== null && typeof value === 'object')
    return `{${Object.entries(value)
      .map(([key, own]) => `${JSON.stringify(key)}: ${inline(own)}`)
      .join(', ')}}`;
  return JSON.stringify(typeof value === 'number' ? tidy(value) : value);
}

/** Writes a value; lists and objects that are short stand on one line. `indent` is that of the line it stands on. */
export function write(value: Value, indent = '', unit = ' '): string {
  const short = inline(value);
  const is_flat = value === null || typeof value !== 'object';
  if (is_flat || short.length + indent.length <= INLINE || !Object.keys(value as object).length) return short;
  const inner = indent + unit;
  const list = Array.isArray(value);
  const rows = list
    ? value.map(own => inner + write(own, inner, unit))
    : Object.entries(value as object).map(
        ([key, own]) => `${inner}${JSON.stringify(key)}: ${write(own as Value, inner, unit)}`,
      );
  return `${list ? '[' : '{'}\n${rows.join(',\n')}\n${indent}${list ? ']' : '}'}`;
}

function indent_at(text: string, at: number): string {
  const line = text.lastIndexOf('\n', at - 1) + 1;
  return /^[ \t]*/.exec(text.slice(line, at))![0];
}

/** Returns the step of indentation that the text uses. */
export function unit_of(text: string): string {
  return /\n([ \t]+)\S/.exec(text)?.[1] ?? ' ';
}

function is_first_on_line(text: string, at: number): boolean {
  return /(^|\n)[ \t]*$/.test(text.slice(Math.max(0, text.lastIndexOf('\n', at - 1)), at));
}

function is_spread(text: string, node: Node): boolean {
  const first = node.keys[0]?.from ?? node.items[0]?.from;
  return first !== undefined && text.slice(node.from, first).includes('\n');
}

const starts = (node: Node, i: number) => node.keys[i]?.from ?? node.items[i].from;

/** Puts entries before the item `index` of a list or object; the entries are text. */
function insert_text(text: string, node: Node, index: number, entries: string[]): string {
  if (!entries.length) return text;
  const unit = unit_of(text);
  const close = node.to - 1;
  if (!node.items.length) {
    const indent = indent_at(text, node.from);
    const inner = text.slice(node.from + 1, close);
    const line = entries.join(', ');
    if (
      entries.length === 1 &&
      !inner.includes('\n') &&
      line.length + (node.from - text.lastIndexOf('\n', node.from)) <= INLINE &&
      node.kind === 'array' &&
      !entries[0].includes('\n')
    )
      return `${text.slice(0, node.from + 1)}${line}${text.slice(close)}`;
    // An empty list can only hold comments: they stay.
    const kept = inner.replace(/\s+$/, '');
    return `${text.slice(0, node.from + 1)}${kept}\n${entries.map(own => indent + unit + own).join(',\n')}\n${indent}${text.slice(close)}`;
  }
  const spread = is_spread(text, node);
  const sibling = Math.min(index, node.items.length - 1);
  // Rows that stand several to a line keep to the line.
  const own_lines = spread && is_first_on_line(text, starts(node, sibling));
  const indent = indent_at(text, starts(node, sibling));
  const between = own_lines ? `,\n${indent}` : ', ';
  if (index < node.items.length) {
    const at = starts(node, index);
    return text.slice(0, at) + entries.join(between) + between + text.slice(at);
  }
  const last = node.items.at(-1)!;
  const after = after_blanks(text, last.to);
  if (text[after] === ',') {
    // The comma exists already. A comment on its line belongs to the last item.
    if (!own_lines) return `${text.slice(0, after + 1)} ${entries.join(between)}${text.slice(after + 1)}`;
    const rest = /^[ \t]*(\/\/[^\n]*|\/\*[^\n]*?\*\/)?/.exec(text.slice(after + 1))![0];
    const at = after + 1 + rest.replace(/\s+$/, '').length;
    return `${text.slice(0, at)}\n${indent}${entries.join(between)},${text.slice(at)}`;
  }
  if (!own_lines) return text.slice(0, last.to) + between + entries.join(between) + text.slice(last.to);
  const rest = /^[ \t]*(\/\/[^\n]*|\/\*[^\n]*?\*\/)?/.exec(text.slice(last.to))![0].replace(/\s+$/, '');
  const at = last.to + rest.length;
  return `${text.slice(0, last.to)},${rest}\n${indent}${entries.join(between)}${text.slice(at)}`;
}

/** Takes `count` items from `index` on out of a list or object, with their commas and the comments on their lines. */
function cut_text(text: string, node: Node, index: number, count: number): string {
  if (count <= 0) return text;
  const last = index + count - 1;
  let from = starts(node, index);
  let to = node.items[last].to;
  const comma = after_blanks(text, to);
  const has_comma = text[comma] === ',';
  if (has_comma) to = comma + 1;
  const rest = /^[ \t]*(\/\/[^\n]*|\/\*[^\n]*?\*\/[ \t]*)?(?=\n|$)/.exec(text.slice(to));
  if (is_first_on_line(text, from) && rest && to + rest[0].length < text.length) {
    // Whole lines.
    from = text.lastIndexOf('\n', from - 1) + 1;
    to += rest[0].length + 1;
    let result = text.slice(0, from) + text.slice(to);
    if (!has_comma && index > 0) result = without_comma(result, node.items[index - 1].to);
    return result;
  }
  if (last + 1 < node.items.length) return text.slice(0, from) + text.slice(starts(node, last + 1));
  if (index > 0) return text.slice(0, node.items[index - 1].to) + text.slice(to);
  return text.slice(0, from) + text.slice(to).replace(/^[ \t]+(?=[\]}])/, '');
}

function without_comma(text: string, at: number): string {
  const comma = after_blanks(text, at);
  return text[comma] === ',' ? text.slice(0, comma) + text.slice(comma + 1) : text;
}

/** Replaces items of a list by others: `count` from `index` on. */
export function splice(text: string, path: Path, index: number, count: number, values: Value[]): string {
  const node = find(parse(text), path);
  if (node?.kind !== 'array') throw new JsonError(`there is no list ${path.join('.')}`, 0);
  const unit = unit_of(text);
  const entries = (indent: string) => values.map(own => write(own, indent, unit));
  if (count === 0) {
    const indent = node.items.length ? indent_at(text, node.items[0].from) : indent_at(text, node.from) + unit;
    return insert_text(text, node, index, entries(indent));
  }
  if (!values.length) return cut_text(text, node, index, count);
  // The first rows are replaced one by one, so that their comments stay.
  const shared = Math.min(count, values.length);
  let result = text;
  if (count > shared) result = cut_text(result, node, index + shared, count - shared);
  if (values.length > shared) {
    const indent = indent_at(text, node.items[0].from);
    result = insert_text(result, node, index + shared, entries(indent).slice(shared));
  }
  for (let i = shared - 1; i >= 0; i--) {
    const old = node.items[index + i];
    if (inline(plain(old)!) === inline(values[i])) continue;
    result = result.slice(0, old.from) + write(values[i], indent_at(text, old.from), unit) + result.slice(old.to);
  }
  return result;
}

/** Replaces or adds the value at a path; missing objects and lists on the way are made. */
export function set(text: string, path: Path, value: Value): string {
  const root = parse(text);
  const unit = unit_of(text);
  let node = root;
  for (let i = 0; i < path.length; i++) {
    const step = path[i];
    const next = find(node, [step]);
    if (next) {
      node = next;
      continue;
    }
    // The rest of the path becomes one value.
    let own = value;
    for (let k = path.length - 1; k > i; k--) own = typeof path[k] === 'number' ? [own] : { [path[k]]: own };
    const indent = node.items.length ? indent_at(text, starts(node, 0)) : indent_at(text, node.from) + unit;
    if (typeof step === 'number') {
      if (node.kind !== 'array') throw new JsonError(`there is no list ${path.slice(0, i).join('.')}`, node.from);
      return insert_text(text, node, node.items.length, [write(own, indent, unit)]);
    }
    if (node.kind !== 'object') throw new JsonError(`there is no object ${path.slice(0, i).join('.')}`, node.from);
    return insert_text(text, node, node.items.length, [`${JSON.stringify(step)}: ${write(own, indent, unit)}`]);
  }
  return text.slice(0, node.from) + write(value, indent_at(text, node.from), unit) + text.slice(node.to);
}

/** Removes the value at a path, if it exists. */
export function remove(text: string, path: Path): string {
  const parent = find(parse(text), path.slice(0, -1));
  const step = path.at(-1)!;
  if (!parent) return text;
  const index = typeof step === 'number' ? step : parent.keys.map(key => key.name).lastIndexOf(step);
  if (index < 0 || index >= parent.items.length) return text;
  return cut_text(text, parent, index, 1);
}

/** Returns line and column of a place, both from 1. */
export function line_of(text: string, at: number): { line: number; column: number } {
  const before = text.slice(0, at);
  const line = before.split('\n').length;
  return { line, column: at - before.lastIndexOf('\n') };
}
