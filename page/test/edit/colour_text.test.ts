// Parts of a text by their kind: together they are the text, whatever it holds.

import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { coloured_lines, type Kind, type Syntax, syntax_of } from '../../src/serve/edit/colour_text';

const of_kind = (text: string, syntax: Syntax, kind: Kind) =>
  coloured_lines(text, syntax)
    .flat()
    .filter(([own]) => own === kind)
    .map(([, part]) => part);

const whole = (text: string, syntax: Syntax) =>
  coloured_lines(text, syntax)
    .map(line => line.map(([, part]) => part).join(''))
    .join('\n');

describe('colours of a text', () => {
  test('JSON with comments', () => {
    const text = '{"a": 1.5e-3, // "no": 2\n "b c": ["x\\"y", -2, true], /* 3\n 4 */ "d": null}';
    expect(of_kind(text, 'json', 'key')).toEqual(['"a"', '"b c"', '"d"']);
    expect(of_kind(text, 'json', 'text')).toEqual(['"x\\"y"']);
    expect(of_kind(text, 'json', 'number')).toEqual(['1.5e-3', '-2']);
    expect(of_kind(text, 'json', 'word')).toEqual(['true', 'null']);
    expect(of_kind(text, 'json', 'comment')).toEqual(['// "no": 2', '/* 3', ' 4 */']);
    expect(coloured_lines(text, 'json')).toHaveLength(3);
  });

  test('YAML', () => {
    const text =
      'keyblock: 2 # version\nanalysis:\n  time_step: 2 ms\n  plane_strain: true\n  m: {like: granite, n: "a # b"}\n';
    expect(of_kind(text, 'yaml', 'key')).toEqual([
      'keyblock',
      'analysis',
      'time_step',
      'plane_strain',
      'm',
      'like',
      'n',
    ]);
    expect(of_kind(text, 'yaml', 'comment')).toEqual(['# version']);
    expect(of_kind(text, 'yaml', 'number')).toEqual(['2', '2']);
    expect(of_kind(text, 'yaml', 'text')).toEqual(['"a # b"']);
  });

  test('parts make the text again, with faults in it too', () => {
    const file = readFileSync(new URL('../../../docs/tunnel_roof.json', import.meta.url), 'utf8');
    for (const text of [file, '{"a": "open\n "b": 1', '/* open', '"', '', '\n\n', "a: 'x\n- b: [1, 2"])
      for (const syntax of ['json', 'yaml'] as Syntax[]) expect(whole(text, syntax)).toBe(text);
    for (let cut = 1; cut < 400; cut += 7) expect(whole(file.slice(0, cut), 'json')).toBe(file.slice(0, cut));
  });

  test('a file is known by its name', () => {
    expect(['a.json', 'b.YML', 'c.yaml', 'd.geo'].map(syntax_of)).toEqual(['json', 'yaml', 'yaml', null]);
  });
});
