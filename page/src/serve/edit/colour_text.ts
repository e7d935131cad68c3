// Splits the text of a case into coloured parts: JSON with comments, or YAML.

export type Kind = 'comment' | 'key' | 'text' | 'number' | 'word' | '';
/** Part of a line and its kind. */
export type Part = [Kind, string];

export type Syntax = 'json' | 'yaml';

/** Syntax of a file by its name; others have none. */
export function syntax_of(path: string): Syntax | null {
  if (/\.(json|geojson)$/i.test(path)) return 'json';
  return /\.ya?ml$/i.test(path) ? 'yaml' : null;
}

const STRING = '"(?:[^"\\\\\\n]|\\\\.)*"?';
const NUMBER = '-?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?(?![\\w.])';

const PATTERNS: Record<Syntax, RegExp> = {
  json: new RegExp(
    `(?<comment>//[^\\n]*|/\\*[\\s\\S]*?(?:\\*/|$))|(?<key>${STRING}(?=\\s*:))|(?<text>${STRING})|` +
      `(?<number>${NUMBER})|(?<word>\\b(?:true|false|null)\\b)|(?<name>[\\w$]+)`,
    'g',
  ),
  yaml: new RegExp(
    `(?<comment>(?<=^|\\s)#[^\\n]*)|(?<key>(?:"[^"\\n]*"|'[^'\\n]*'|[\\w$][\\w$./-]*)(?=[ \\t]*:(?:\\s|$)))|` +
      `(?<text>${STRING}|'[^'\\n]*'?)|(?<number>${NUMBER})|(?<word>\\b(?:true|false|null|yes|no)\\b)|(?<name>[\\w$]+)`,
    'gm',
  ),
};

/** Returns the parts of each line; together they are the text. */
export function coloured_lines(text: string, syntax: Syntax): Part[][] {
  const lines: Part[][] = [[]];
  const put = (kind: Kind, part: string) => {
    const rows = part.split('\n');
    rows.forEach((row, i) => {
      if (i > 0) lines.push([]);
      if (row) lines[lines.length - 1].push([kind, row]);
    });
  };
  let at = 0;
  for (const found of text.matchAll(PATTERNS[syntax])) {
    // Names without a kind only keep numbers and words within them plain.
    const kind = Object.entries(found.groups ?? {}).find(([, part]) => part !== undefined)?.[0] ?? '';
    if (kind === 'name') continue;
    put('', text.slice(at, found.index));
    put(kind as Kind, found[0]);
    at = found.index + found[0].length;
  }
  put('', text.slice(at));
  return lines;
}
