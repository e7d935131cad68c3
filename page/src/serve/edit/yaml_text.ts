// YAML as text: reads the part of it that case files need, with the place of every value, and changes one value at its
// place. Comments, order and layout of the rest stay. New values are written in one line, as in JSON.

import { find, inline, JsonError, type Node, type Path, type Value } from './json_text';

/** Node of a block collection: one entry per line, by indentation. */
export interface YamlNode extends Node {
  items: YamlNode[];
  is_block?: boolean;
  /** Column of the keys or dashes of a block collection. */
  column?: number;
}

/** True if a text is YAML: its first word is a key, not a brace. */
export function is_yaml(text: string): boolean {
  return /^\ufeff?(?:\s|#[^\n]*\n|%[^\n]*\n|---[^\n]*\n)*["']?[A-Za-z_$][\w$]*["']?\s*:(?:\s|$)/.test(text);
}

const scalar = (from: number, to: number, kind: Node['kind'], value: Node['value']): YamlNode => ({
  kind,
  from,
  to,
  value,
  items: [],
  keys: [],
});

class Reader {
  at = 0;
  constructor(readonly text: string) {}

  fail(words: string, at = this.at): never {
    throw new JsonError(words, at);
  }

  /** Goes to the next letter that is neither blank nor in a comment. */
  blanks(): void {
    const { text } = this;
    for (;;) {
      const c = text[this.at];
      if (c === ' ' || c === '\t' || c === '\n' || c === '\r' || c === '\ufeff') this.at++;
      else if (c === '#' && (this.at === 0 || /\s/.test(text[this.at - 1]))) this.end_of_line();
      else if (text.startsWith('---', this.at) && this.column() === 0 && /\s|^$/.test(text[this.at + 3] ?? ''))
        this.end_of_line();
      else return;
    }
  }

  end_of_line(): void {
    const end = this.text.indexOf('\n', this.at);
    this.at = end < 0 ? this.text.length : end;
  }

  column(at = this.at): number {
    return at - (this.text.lastIndexOf('\n', at - 1) + 1);
  }

  quoted(): YamlNode {
    const from = this.at;
    const mark = this.text[from];
    let at = from + 1;
    while (at < this.text.length && this.text[at] !== '\n') {
      if (mark === '"' && this.text[at] === '\\') at++;
      else if (this.text[at] === mark && mark === "'" && this.text[at + 1] === "'") at++;
      else if (this.text[at] === mark) break;
      at++;
    }
    if (this.text[at] !== mark) this.fail('a text has no closing quotation mark', from);
    const inner = this.text.slice(from + 1, at);
    this.at = at + 1;
    if (mark === "'") return scalar(from, this.at, 'string', inner.replace(/''/g, "'"));
    try {
      return scalar(from, this.at, 'string', JSON.parse(`"${inner}"`));
    } catch {
      return this.fail('a text has a wrong escape', from);
    }
  }

  /** Word without quotation marks: up to a comment, the end of the line, or within brackets a comma. */
  plain(is_flow: boolean): YamlNode {
    const from = this.at;
    const rest = is_flow ? /(?:(?!\s#|[,[\]{}\n]|:(?:\s|$)).)+/y : /(?:(?!\s#|\n).)+/y;
    rest.lastIndex = from;
    const found = rest.exec(this.text)?.[0].trimEnd() ?? '';
    if (/^[&*!|>@`]/.test(found)) this.fail('the window does not read anchors, tags and texts of several lines', from);
    this.at = from + found.length;
    if (/^(?:true|True|TRUE)$/.test(found)) return scalar(from, this.at, 'word', true);
    if (/^(?:false|False|FALSE)$/.test(found)) return scalar(from, this.at, 'word', false);
    if (/^(?:|~|null|Null|NULL)$/.test(found)) return scalar(from, this.at, 'word', null);
    if (/^[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?$/.test(found))
      return scalar(from, this.at, 'number', Number(found));
    return scalar(from, this.at, 'string', found);
  }

  flow(depth: number): YamlNode {
    const from = this.at;
    const open = this.text[from];
    if (open === '"' || open === "'") return this.quoted();
    if (open !== '[' && open !== '{') return this.plain(true);
    if (depth > 100) this.fail('the lists are nested too deeply');
    const close = open === '[' ? ']' : '}';
    const node: YamlNode = { kind: open === '[' ? 'array' : 'object', from, to: from, items: [], keys: [] };
    this.at++;
    this.blanks();
    while (this.text[this.at] !== close) {
      if (this.at >= this.text.length) this.fail('the text ends early');
      const item = this.flow(depth + 1);
      this.blanks();
      if (open === '{') {
        if (this.text[this.at] !== ':') this.fail('a colon was expected behind the key');
        node.keys.push({ name: String(item.value), from: item.from, to: item.to });
        this.at++;
        this.blanks();
        node.items.push(this.flow(depth + 1));
        this.blanks();
      } else node.items.push(item);
      if (this.text[this.at] === ',') {
        this.at++;
        this.blanks();
      } else if (this.text[this.at] !== close) this.fail(`a comma or ${close} was expected`);
    }
    node.to = ++this.at;
    return node;
  }

  /** Key of a block map at this place, with the place behind its colon; null if none stands here. */
  key(): { name: string; from: number; to: number; colon: number } | null {
    const pattern =
      /("(?:[^"\\\n]|\\.)*"|'[^'\n]*'|[^\s#[\]{},&*!|>@`"'-][^\n#[\]{},:]*|\$[\w]+)[ \t]*:(?=[ \t\r\n]|$)/y;
    pattern.lastIndex = this.at;
    const found = pattern.exec(this.text);
    if (!found) return null;
    const word = found[1].trimEnd();
    const name = /^["']/.test(word) ? word.slice(1, -1) : word;
    return { name, from: this.at, to: this.at + word.length, colon: this.at + found[0].length };
  }

  is_dash(): boolean {
    return this.text[this.at] === '-' && /[\s]|^$/.test(this.text[this.at + 1] ?? '');
  }

  /** Value behind a colon or a dash at `after`; it stands on the line, or deeper than `column` below. */
  value(after: number, column: number, takes_list: boolean, depth: number): YamlNode {
    if (depth > 100) this.fail('the lists are nested too deeply');
    this.at = after;
    const line_end = this.text.indexOf('\n', after);
    this.blanks();
    const own = this.column();
    const is_below = line_end >= 0 && this.at > line_end;
    const is_deep = own > column || (takes_list && own === column && this.is_dash());
    if (this.at >= this.text.length || (is_below && !is_deep)) {
      const end = this.at;
      this.at = after;
      const empty = scalar(after, after, 'word', null);
      this.at = end;
      return empty;
    }
    if (this.is_dash() && (is_below || !takes_list)) return this.list(own, depth);
    if (is_below || !takes_list) {
      const key = this.key();
      if (key) return this.map(own, depth);
    }
    const c = this.text[this.at];
    if (c === '[' || c === '{') return this.flow(depth);
    if (c === '"' || c === "'") return this.quoted();
    return this.plain(false);
  }

  map(column: number, depth: number): YamlNode {
    const node: YamlNode = { kind: 'object', from: this.at, to: this.at, items: [], keys: [], is_block: true, column };
    for (;;) {
      const key = this.at < this.text.length && this.column() === column ? this.key() : null;
      if (!key) break;
      const item = this.value(key.colon, column, true, depth + 1);
      node.keys.push({ name: key.name, from: key.from, to: key.colon });
      node.items.push(item);
      node.to = Math.max(key.colon, item.to);
      this.blanks();
    }
    return node;
  }

  list(column: number, depth: number): YamlNode {
    const node: YamlNode = { kind: 'array', from: this.at, to: this.at, items: [], keys: [], is_block: true, column };
    while (this.at < this.text.length && this.column() === column && this.is_dash()) {
      const dash = this.at;
      const item = this.value(dash + 1, column, false, depth + 1);
      node.keys.push({ name: '', from: dash, to: dash + 1 });
      node.items.push(item);
      node.to = Math.max(dash + 1, item.to);
      this.blanks();
    }
    return node;
  }

  read(): YamlNode {
    this.blanks();
    const node = this.map(this.column(), 0);
    if (this.at < this.text.length) this.fail('a key with a colon was expected');
    return node;
  }
}

/** Reads a whole text. Throws JsonError. */
export function parse(text: string): YamlNode {
  return new Reader(text).read();
}

/** Begin of an entry: its key, its dash, or the value itself. */
const starts = (node: YamlNode, i: number) => node.keys[i]?.from ?? node.items[i].from;

const line_start = (text: string, at: number) => text.lastIndexOf('\n', at - 1) + 1;

/** End of the line at a place, without its line break. */
function line_end(text: string, at: number): number {
  const end = text.indexOf('\n', at);
  return end < 0 ? text.length : end;
}

const end_of = (node: YamlNode, i: number) => Math.max(node.keys[i]?.to ?? 0, node.items[i].to);

const written_key = (key: string) => (/^[A-Za-z_$][\w$.]*$/.test(key) ? key : JSON.stringify(key));

/** Puts entries before the item `index`; the entries are text without dashes. */
function insert_text(text: string, node: YamlNode, index: number, entries: string[]): string {
  if (!entries.length) return text;
  const count = node.items.length;
  if (node.is_block) {
    const indent = ' '.repeat(node.column ?? 0);
    const rows = entries.map(own => (node.kind === 'array' ? `- ${own}` : own));
    if (index < count) {
      const at = starts(node, index);
      return text.slice(0, at) + rows.map(own => `${own}\n${indent}`).join('') + text.slice(at);
    }
    const end = line_end(text, end_of(node, count - 1));
    return `${text.slice(0, end)}\n${rows.map(own => indent + own).join('\n')}${text.slice(end)}`;
  }
  if (!count) return `${text.slice(0, node.from + 1)}${entries.join(', ')}${text.slice(node.to - 1)}`;
  const first = starts(node, Math.min(index, count - 1));
  const before = text.slice(line_start(text, first), first);
  const between = /^\s*$/.test(before) ? `,\n${before}` : ', ';
  if (index < count) return text.slice(0, first) + entries.join(between) + between + text.slice(first);
  const last = end_of(node, count - 1);
  // A comma and a comment behind the last item stay on its line.
  const rest = /^([ \t]*)(,?)([ \t]*#[^\n]*)?/.exec(text.slice(last))!;
  if (between === ', ') return `${text.slice(0, last)}${between}${entries.join(between)}${text.slice(last)}`;
  const after = last + rest[0].length;
  return `${text.slice(0, last)},${rest[3] ?? ''}${between.slice(1)}${entries.join(between)}${text.slice(after)}`;
}

/** Takes `count` items from `index` on out of a collection. */
function cut_text(text: string, node: YamlNode, index: number, count: number): string {
  if (count <= 0) return text;
  const last = index + count - 1;
  const from = starts(node, index);
  if (node.is_block) {
    if (count === node.items.length) {
      // An empty list or section is left.
      const empty = node.kind === 'array' ? '[]' : '{}';
      const own = text.slice(line_start(text, from), from);
      const before = text.slice(0, from).replace(/[ \t]*\n?[ \t]*$/, '');
      const is_below = /^\s*$/.test(own);
      return `${is_below ? `${before} ` : text.slice(0, from)}${empty}${text.slice(node.to)}`;
    }
    // The first entry of a list item stands behind a dash: the next takes its place.
    if (last + 1 < node.items.length) return text.slice(0, from) + text.slice(starts(node, last + 1));
    const end = line_end(text, end_of(node, last));
    return text.slice(0, Math.max(0, line_start(text, from) - 1)) + text.slice(end);
  }
  if (last + 1 < node.items.length) return text.slice(0, from) + text.slice(starts(node, last + 1));
  if (index > 0) return text.slice(0, end_of(node, index - 1)) + text.slice(end_of(node, last));
  return text.slice(0, from) + text.slice(end_of(node, last)).replace(/^\s*,?[ \t]*/, '');
}

/** Replaces a value. A block below its key becomes one line behind the colon. */
function replaced(text: string, parent: YamlNode | undefined, index: number, node: YamlNode, value: string): string {
  if (node.from === node.to) return `${text.slice(0, node.from)} ${value}${text.slice(node.to)}`;
  const colon = parent?.keys[index]?.to;
  if (node.is_block && colon !== undefined) return `${text.slice(0, colon)} ${value}${text.slice(node.to)}`;
  return text.slice(0, node.from) + value + text.slice(node.to);
}

/** Replaces or adds the value at a path; missing objects and lists on the way are made. */
export function set(text: string, path: Path, value: Value): string {
  let node = parse(text);
  let parent: YamlNode | undefined;
  let index = -1;
  for (let i = 0; i < path.length; i++) {
    const step = path[i];
    const next = find(node, [step]) as YamlNode | undefined;
    if (next) {
      index = node.items.indexOf(next);
      parent = node;
      node = next;
      continue;
    }
    let own = value;
    for (let k = path.length - 1; k > i; k--) own = typeof path[k] === 'number' ? [own] : { [path[k]]: own };
    // A key without a value gets one.
    if (node.kind === 'word' && node.value === null)
      return replaced(text, parent, index, node, inline(typeof step === 'number' ? [own] : { [step]: own }));
    if (typeof step === 'number') {
      if (node.kind !== 'array') throw new JsonError(`there is no list ${path.slice(0, i).join('.')}`, node.from);
      return insert_text(text, node, node.items.length, [inline(own)]);
    }
    if (node.kind !== 'object') throw new JsonError(`there is no object ${path.slice(0, i).join('.')}`, node.from);
    return insert_text(text, node, node.items.length, [`${written_key(step)}: ${inline(own)}`]);
  }
  return replaced(text, parent, index, node, inline(value));
}

/** Replaces items of a list by others: `count` from `index` on. */
export function splice(text: string, path: Path, index: number, count: number, values: Value[]): string {
  const node = find(parse(text), path) as YamlNode | undefined;
  if (node?.kind === 'word' && node.value === null) return set(text, path, values);
  if (node?.kind !== 'array') throw new JsonError(`there is no list ${path.join('.')}`, 0);
  let result = text;
  const shared = Math.min(count, values.length);
  if (count > shared) result = cut_text(result, node, index + shared, count - shared);
  else if (values.length > shared) result = insert_text(result, node, index + shared, values.slice(shared).map(inline));
  for (let i = shared - 1; i >= 0; i--) {
    const own = find(parse(result), path)! as YamlNode;
    result = replaced(result, own, index + i, own.items[index + i], inline(values[i]));
  }
  return result;
}

/** Removes the value at a path, if it exists. */
export function remove(text: string, path: Path): string {
  const parent = find(parse(text), path.slice(0, -1)) as YamlNode | undefined;
  const step = path.at(-1)!;
  if (!parent) return text;
  const index = typeof step === 'number' ? step : parent.keys.map(key => key.name).lastIndexOf(step);
  if (index < 0 || index >= parent.items.length) return text;
  return cut_text(text, parent, index, 1);
}
