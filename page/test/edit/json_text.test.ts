// Text of a case: one value changes, everything else stays as it was.

import { execFileSync } from 'node:child_process';
import { describe, expect, test } from 'vitest';
import {
  find,
  type JsonError,
  type Path,
  parse,
  plain,
  remove,
  set,
  splice,
  type Value,
} from '../../src/serve/edit/json_text';

const CASE = `{
 // A slope.
 "keyblock": 2,  // layout
 "drawing": {
  "boundary_count": 3,
  "joints": [  // rows
   [0, 0, 30, 0, "bedding"],  // base
   [30, 0, 30, 14, "bedding"],
   /* face */ [30, 14, 0, 0, "bedding"],
   [6.25, -0, 30, 5, "cross"],
  ],
  "fixed_lines": [[-1, 0.01, 31, 0.01], [0.01, -1, 0.01, 5]],  // base and side
  "measured_points": [],
 },
 "analysis": {"step_count": 300, "time_step": "1 ms"}
}
`;

const read = (text: string, path: Path = []) => plain(find(parse(text), path));
const lines = (text: string) => text.split('\n');

/** Lines of the second text that the first has not, and the other way round. */
function changed(before: string, after: string): [string[], string[]] {
  const a = lines(before);
  const b = lines(after);
  return [a.filter(line => !b.includes(line)), b.filter(line => !a.includes(line))];
}

describe('text of a case', () => {
  test('values are read past comments and trailing commas', () => {
    expect(read(CASE, ['drawing', 'joints', 3])).toEqual([6.25, -0, 30, 5, 'cross']);
    expect(read(CASE, ['analysis'])).toEqual({ step_count: 300, time_step: '1 ms' });
    expect(read('[1, .5, -2e-3, "a\\"b", true, null]')).toEqual([1, 0.5, -0.002, 'a"b', true, null]);
    expect(read('{"a": 1, "a": 2}', ['a'])).toBe(2);
  });

  test('a fault is named at its place', () => {
    const fault = (text: string): [string, number] => {
      try {
        parse(text);
      } catch (error) {
        return [(error as Error).message, (error as JsonError).at];
      }
      return ['', -1];
    };
    expect(fault('{"a": 1 "b": 2}')).toEqual(['a comma or } was expected', 8]);
    expect(fault('{"a": "b}')).toEqual(['a text has no closing quotation mark', 6]);
    expect(fault('[1, 2')[0]).toBe('a comma or ] was expected');
    expect(fault('{} x')).toEqual(['something follows the end', 3]);
    expect(fault('/* open')[0]).toBe('a comment has no end');
    expect(fault('[tru]')).toEqual(['a value was expected, not tru', 1]);
    expect(fault('['.repeat(200))[0]).toBe('the lists are nested too deeply');
  });

  test('one number changes in place', () => {
    const after = set(CASE, ['drawing', 'joints', 0, 2], 31.5);
    expect(changed(CASE, after)).toEqual([
      ['   [0, 0, 30, 0, "bedding"],  // base'],
      ['   [0, 0, 31.5, 0, "bedding"],  // base'],
    ]);
    expect(set(CASE, ['keyblock'], 1)).toBe(CASE.replace('"keyblock": 2', '"keyblock": 1'));
  });

  test('a key is added behind the last one', () => {
    expect(set(CASE, ['analysis', 'gravity'], 9.81)).toBe(
      CASE.replace('"time_step": "1 ms"}', '"time_step": "1 ms", "gravity": 9.81}'),
    );
    const staged = set(CASE, ['stages'], [{ name: 'in situ' }]);
    expect(changed(CASE, staged)).toEqual([
      [' "analysis": {"step_count": 300, "time_step": "1 ms"}'],
      [' "analysis": {"step_count": 300, "time_step": "1 ms"},', ' "stages": [{"name": "in situ"}]'],
    ]);
    expect(read(set(CASE, ['run', 'set', 'steps'], '5'), ['run'])).toEqual({ set: { steps: '5' } });
    expect(read(set('{}', ['a', 'b', 0], 1))).toEqual({ a: { b: [1] } });
    const behind = set(CASE, ['drawing', 'hole_points'], [[1, 2]]);
    expect(lines(behind)[13]).toBe('  "hole_points": [[1, 2]],');
  });

  test('rows are added on lines of their own, or on the line', () => {
    const path: Path = ['drawing', 'joints'];
    const appended = splice(CASE, path, 4, 0, [[1, 2, 3, 4, 1]]);
    expect(changed(CASE, appended)).toEqual([[], ['   [1, 2, 3, 4, 1],']]);
    expect(lines(appended)[10]).toBe('   [1, 2, 3, 4, 1],');
    expect(splice(CASE, ['drawing', 'fixed_lines'], 2, 0, [[1, 2, 3, 4]])).toContain(
      '"fixed_lines": [[-1, 0.01, 31, 0.01], [0.01, -1, 0.01, 5], [1, 2, 3, 4]],  // base and side',
    );
    expect(splice(CASE, ['drawing', 'measured_points'], 0, 0, [[1, 2]])).toContain('"measured_points": [[1, 2]],');
  });

  test('rows go with their line; comments of others stay', () => {
    expect(changed(CASE, remove(CASE, ['drawing', 'joints', 3]))).toEqual([['   [6.25, -0, 30, 5, "cross"],'], []]);
    expect(changed(CASE, remove(CASE, ['drawing', 'joints', 0]))[0]).toEqual(['   [0, 0, 30, 0, "bedding"],  // base']);
    const without = remove(CASE, ['drawing', 'fixed_lines', 1]);
    expect(without).toContain('"fixed_lines": [[-1, 0.01, 31, 0.01]],  // base and side');
    expect(remove(CASE, ['drawing', 'fixed_lines', 0])).toContain('[[0.01, -1, 0.01, 5]],');
    const last = remove(CASE, ['analysis', 'time_step']);
    expect(last).toContain('"analysis": {"step_count": 300}');
    expect(remove(CASE, ['analysis', 'step_count'])).toContain('"analysis": {"time_step": "1 ms"}');
    const end = remove(CASE, ['analysis']);
    expect(read(end, ['drawing', 'boundary_count'])).toBe(3);
    expect(() => JSON.parse(end.replace(/\/\/.*|\/\*.*?\*\//g, '').replace(/,(\s*[\]}])/g, '$1'))).not.toThrow();
    expect(remove(CASE, ['none', 'such'])).toBe(CASE);
  });

  test('replaced rows keep the comments on their lines', () => {
    const after = splice(CASE, ['drawing', 'joints'], 0, 3, [
      [0, 0, 40, 0, 'bedding'],
      [40, 0, 40, 14, 'bedding'],
      [40, 14, 0, 4, 'bedding'],
      [0, 4, 0, 0, 'bedding'],
    ]);
    expect(after).toContain('   [0, 0, 40, 0, "bedding"],  // base\n');
    expect(after).toContain('   /* face */ [40, 14, 0, 4, "bedding"],\n   [0, 4, 0, 0, "bedding"],\n   [6.25, -0');
    const fewer = splice(CASE, ['drawing', 'joints'], 0, 3, [[1, 1, 1, 1, 1]]);
    expect(read(fewer, ['drawing', 'joints'])).toEqual([
      [1, 1, 1, 1, 1],
      [6.25, -0, 30, 5, 'cross'],
    ]);
  });

  test('no numbers of sixteen digits are written', () => {
    expect(set('[1]', [0], 0.1 + 0.2)).toBe('[0.3]');
    expect(set('[1]', [0], 1e-9)).toBe('[1e-9]');
  });

  test('any sequence of changes gives what the same changes of plain data give', () => {
    let seed = 7;
    const random = (n: number) => {
      seed = (seed * 1103515245 + 12345) % 2147483648;
      return seed % n;
    };
    let text = CASE;
    const model = read(CASE) as { drawing: { joints: Value[]; fixed_lines: Value[]; measured_points: Value[] } };
    for (let i = 0; i < 400; i++) {
      const name = (['joints', 'fixed_lines', 'measured_points'] as const)[random(3)];
      const list = model.drawing[name];
      const at = random(list.length + 1);
      const count = Math.min(list.length - at, random(3));
      const values = Array.from({ length: list.length > 12 ? 0 : random(3) }, () => [random(100), i, 'x']);
      list.splice(at, count, ...values);
      text = splice(text, ['drawing', name], at, count, values);
      expect(read(text), `change ${i}`).toEqual(model);
    }
    expect(text).toContain('// A slope.');
    expect(text).toContain('// layout');
  });

  const program = process.env.KEYBLOCK ?? '';
  test.skipIf(!program)('templates of the program are read and keep their text', () => {
    for (const kind of ['slope', 'arch', 'beam', 'tunnel', 'block']) {
      const file = `${process.env.TMPDIR ?? '/tmp'}/keyblock_template_${process.pid}.json`;
      execFileSync(program, ['new', kind, '-o', file, '--force'], { stdio: 'ignore' });
      const text = execFileSync('cat', [file]).toString();
      execFileSync('rm', [file]);
      const own = read(text, ['analysis', 'step_count']) as number;
      expect(set(text, ['analysis', 'step_count'], own)).toBe(text);
      expect(set(text, ['analysis', 'step_count'], own + 1).length).toBeLessThan(text.length + 2);
    }
  });
});
