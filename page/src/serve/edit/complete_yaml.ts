// Finds what can be typed at a place of a case in YAML. The text may have faults elsewhere.

import type { Path } from './case_text';
import type { Choice, Place } from './complete';
import { type Schema, schema_at } from './schema';

/** Place in a block collection: `column` is that of its keys. Absent within brackets. */
export interface YamlPlace extends Place {
  column?: number;
}

interface Level {
  kind: 'map' | 'list';
  /** Column of keys or dashes; -1 within brackets. */
  column: number;
  path: Path;
  key: string | null;
  keys: string[];
  count: number;
  /** True if the value of the last key or dash has begun. */
  has_value: boolean;
}

const KEY = /("(?:[^"\\\n]|\\.)*"|'[^'\n]*'|[^\s#[\]{},&*!|>@`"'-][^\n#[\]{},:]*)[ \t]*:(?=[ \t\r\n]|$)/y;
const WORD = /^[\w.+-]*/;

const unquoted = (word: string) => word.trimEnd().replace(/^(["'])(.*)\1$/, '$2');

function path_of(levels: Level[], base: Path = []): Path {
  const top = levels.at(-1);
  return top ? [...top.path, top.kind === 'map' ? (top.key ?? '') : top.count] : base;
}

const level = (kind: Level['kind'], column: number, path: Path): Level => ({
  kind,
  column,
  path,
  key: null,
  keys: [],
  count: 0,
  has_value: false,
});

/** Walks through the text up to the caret. `found` is set once a place, or its absence, is known. */
class Walk {
  levels: Level[] = [];
  found: YamlPlace | null | undefined;

  constructor(
    readonly text: string,
    readonly caret: number,
    readonly is_object: (path: Path) => boolean,
  ) {}

  place(): YamlPlace | null {
    let at = 0;
    while (this.found === undefined) at = this.line(at);
    return this.found;
  }

  end_of_line(at: number): number {
    const end = this.text.indexOf('\n', at);
    return end < 0 ? this.text.length : end;
  }

  /** Begin of the next line; the search ends if the caret stands before it. */
  next_line(at: number): number {
    const end = this.end_of_line(at);
    if (this.caret <= end) this.found ??= null;
    return end + 1;
  }

  blanks(at: number): number {
    let own = at;
    while (own < this.caret && /[ \t\r\ufeff]/.test(this.text[own])) own++;
    return own;
  }

  is_dash(at: number): boolean {
    return this.text[at] === '-' && at < this.caret && /\s|^$/.test(this.text[at + 1] ?? '');
  }

  /** Reads a line outside of brackets; returns the begin of the next. */
  line(from: number): number {
    const { text, caret } = this;
    let at = this.blanks(from);
    if (text[at] === '#' || text[at] === '%' || text.startsWith('---', at)) return this.next_line(at);
    if (text[at] === '\n' && at < caret) return at + 1;
    let has_dash = false;
    while (this.is_dash(at)) {
      this.enter_list(at - from);
      has_dash = true;
      at = this.blanks(at + 1);
    }
    if (has_dash && at < caret && /[\n#]/.test(text[at])) return this.next_line(at);
    KEY.lastIndex = at;
    const key = at < caret ? KEY.exec(text) : null;
    if (key && KEY.lastIndex <= caret) {
      this.enter_key(at - from, unquoted(key[1]));
      return this.value(KEY.lastIndex);
    }
    if (at < caret && (has_dash || !this.levels.length) && /["'[{]/.test(text[at])) return this.value(at);
    if (caret <= this.end_of_line(at)) {
      this.found = this.unfinished(at, at - from, has_dash, key ? at + key[1].trimEnd().length : -1);
      return at;
    }
    return has_dash ? this.value(at) : this.next_line(at);
  }

  enter_list(column: number): void {
    const { levels } = this;
    while (levels.length && levels[levels.length - 1].column > column) levels.pop();
    const top = levels.at(-1);
    if (top?.kind === 'list' && top.column === column) {
      top.count++;
      top.has_value = false;
    } else this.push(level('list', column, path_of(levels)));
  }

  enter_key(column: number, name: string): void {
    const top = this.leave(column);
    if (top?.kind === 'map' && top.column === column) {
      top.key = name;
      top.keys.push(name);
      top.has_value = false;
    } else this.push({ ...level('map', column, path_of(this.levels)), key: name, keys: [name] });
  }

  push(own: Level): void {
    const top = this.levels.at(-1);
    if (top) top.has_value = true;
    this.levels.push(own);
  }

  /** Leaves the collections that a key in a column ends. */
  leave(column: number): Level | undefined {
    const { levels } = this;
    for (;;) {
      const top = levels.at(-1);
      if (!top || top.column < column || (top.column === column && top.kind === 'map')) return top;
      levels.pop();
    }
  }

  /** Reads the value behind a colon or a dash; returns the begin of the next line. */
  value(from: number): number {
    const { text, caret } = this;
    const at = this.blanks(from);
    if (at === caret) {
      this.found = at > from ? this.word(path_of(this.levels), 'value', at, []) : null;
      return at;
    }
    if (/[\n#]/.test(text[at])) return this.next_line(at);
    const top = this.levels.at(-1);
    if (top) top.has_value = true;
    if (text[at] === '[' || text[at] === '{') {
      const end = this.brackets(at);
      return this.found === undefined ? this.next_line(end) : end;
    }
    const end = this.end_of_scalar(at, /[ \t]#|\n|$/g);
    if (caret <= end) this.found = this.word(path_of(this.levels), 'value', at, []);
    return this.found === undefined ? this.next_line(end) : end;
  }

  /** End of a word or of a text in quotation marks. */
  end_of_scalar(at: number, stop: RegExp): number {
    const mark = this.text[at];
    if (mark === '"' || mark === "'") {
      const end = this.text.slice(at + 1, this.end_of_line(at)).search(new RegExp(`(?<!\\\\)${mark}`));
      return end < 0 ? this.end_of_line(at) : at + end + 2;
    }
    stop.lastIndex = at;
    const found = stop.exec(this.text);
    return found ? Math.max(found.index, at) : this.text.length;
  }

  /** Place whose replaced part begins at `from`. */
  word(path: Path, kind: Place['kind'], from: number, taken: string[], to = -1): YamlPlace | null {
    const { text, caret } = this;
    const mark = /["']/.test(text[from] ?? '') && from < caret ? text[from] : '';
    const typed = text.slice(from + mark.length, caret);
    if (mark && typed.includes(mark)) return null;
    let end = to >= 0 ? to : caret + WORD.exec(text.slice(caret))![0].length;
    if (mark && text[end] === mark) end++;
    return { path, kind, from, to: end, typed, taken };
  }

  /** Place of a word at the begin of a line, which may become a key or be a value. */
  unfinished(at: number, column: number, has_dash: boolean, key_end: number): YamlPlace | null {
    const top = has_dash ? this.levels.at(-1) : this.leave(column);
    const is_sibling = !has_dash && top?.kind === 'map' && top.column === column;
    if (!is_sibling && top && (top.has_value || (top.kind === 'map' && top.key === null))) return null;
    if (!top && column > 0 && this.text.slice(0, at).trim()) return null;
    const path = is_sibling ? top.path : path_of(this.levels);
    if (!is_sibling && !this.is_object(path)) return this.word(path, 'value', at, []);
    const taken = [...(is_sibling ? top.keys : []), ...this.keys_below(column)];
    const own = this.word(path, 'key', at, taken, key_end);
    return own && { ...own, column };
  }

  /** Keys of the same map on the lines below the caret. */
  keys_below(column: number): string[] {
    const keys: string[] = [];
    const lines = this.text.slice(this.end_of_line(this.caret) + 1).split('\n');
    for (const line of lines) {
      if (/^\s*(#.*)?$/.test(line)) continue;
      const own = line.search(/\S/);
      if (own < column || (own === column && /^-(\s|$)/.test(line.slice(own)))) break;
      KEY.lastIndex = own;
      const key = own === column ? KEY.exec(line) : null;
      if (key) keys.push(unquoted(key[1]));
    }
    return keys;
  }

  /** Reads lists and maps in brackets; returns the place behind them. */
  brackets(from: number): number {
    const { text, caret } = this;
    const base = path_of(this.levels);
    const stack: Level[] = [];
    let word: string | null = null;
    let at = from;
    while (at < caret) {
      const c = text[at];
      const top = stack.at(-1);
      if (c === '#' && /\s/.test(text[at - 1])) at = this.next_line(at);
      else if (c === '[' || c === '{') {
        stack.push(level(c === '{' ? 'map' : 'list', -1, path_of(stack, base)));
        word = null;
        at++;
      } else if (c === ']' || c === '}') {
        stack.pop();
        at++;
        if (!stack.length) return at;
      } else if (c === ':' || c === ',') {
        if (top && c === ',') {
          top.key = null;
          top.count++;
        } else if (top?.kind === 'map' && word !== null) {
          top.key = word;
          top.keys.push(word);
        }
        word = null;
        at++;
      } else if (/\s/.test(c)) at++;
      else {
        const end = this.end_of_scalar(at, /[,[\]{}\n]|:(?=\s|$)|[ \t]#|$/g);
        if (end > caret || (end === caret && !/["']/.test(text[end - 1]))) {
          this.found = this.in_brackets(stack, at);
          return at;
        }
        word = unquoted(text.slice(at, end));
        at = Math.max(end, at + 1);
      }
      if (this.found !== undefined) return at;
    }
    this.found = word === null ? this.in_brackets(stack, caret) : null;
    return at;
  }

  in_brackets(stack: Level[], from: number): YamlPlace | null {
    const top = stack.at(-1);
    if (!top) return null;
    if (top.kind === 'list' || top.key !== null) return this.word(path_of(stack), 'value', from, []);
    return this.word(top.path, 'key', from, [...top.keys, ...this.keys_behind()]);
  }

  /** Keys within the same brackets behind the caret. */
  keys_behind(): string[] {
    const keys: string[] = [];
    const parts = /"([^"\n]*)"|'([^'\n]*)'|#[^\n]*|[[{]|[\]}]|([A-Za-z_$][\w$.]*)/g;
    parts.lastIndex = this.caret;
    for (let depth = 0, own = parts.exec(this.text); own && depth >= 0; own = parts.exec(this.text)) {
      if (/^[[{]/.test(own[0])) depth++;
      else if (/^[\]}]/.test(own[0])) depth--;
      else if (depth === 0 && /^\s*:(\s|$)/.test(this.text.slice(parts.lastIndex, parts.lastIndex + 20)))
        keys.push(own[1] ?? own[2] ?? own[3] ?? '');
    }
    return keys;
  }
}

/** Returns the place at the caret. The schema decides whether a bare word becomes a key or a value. */
export function place_in_yaml(text: string, caret: number, schema: Schema): YamlPlace | null {
  return new Walk(text, caret, path => schema_at(schema, path)?.properties !== undefined).place();
}

/** Writes a word without quotation marks where YAML reads it as text. */
function written(json: string): string {
  if (!json.startsWith('"')) return json;
  const word: string = JSON.parse(json);
  const is_plain = /^[A-Za-z0-9_][^:#,[\]{}"'&*!|>%@`\n]*$/.test(word) && word.trim() === word;
  const is_other = /^(?:true|false|null|yes|no|on|off|~)$/i.test(word) || /^[-+]?\.?\d[\d._eE+-]*$/.test(word);
  return is_plain && !is_other ? word : json;
}

/** Writes choices of JSON as YAML. A section of a block map begins on a line of its own. */
export function in_yaml(choices: Choice[], place: YamlPlace): Choice[] {
  return choices.map(own => {
    if (place.kind === 'value') return { ...own, text: written(own.text) };
    const start = own.text.slice(own.label.length + 4);
    const is_below = start === '{}' && place.column !== undefined;
    const below = `\n${' '.repeat((place.column ?? 0) + 2)}`;
    return { ...own, text: `${own.label}:${is_below ? below : ` ${written(start)}`}` };
  });
}
