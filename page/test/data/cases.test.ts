import { describe, expect, test } from 'vitest';
import {
  cases_of,
  folder_of,
  index_at,
  last_messages,
  leaf_of,
  name_of_result,
  new_result,
  stem_of,
  tables_of,
} from '../../src/serve/cases';
import { link, route_of } from '../../src/serve/routes';

describe('cases', () => {
  test('old files with one name are one case, geometry first', () => {
    const file = (path: string) => ({ path, bytes: 1, time: 1 });
    const cases = cases_of(
      ['b.json', 'a/x.ana', 'a/x.blk', 'a/y.ana', 'a/expected.csv', 'c.dxf', 'z/fos.json'].map(file),
    );
    expect(cases.map(own => own.paths)).toEqual([['a/x.blk', 'a/x.ana'], ['a/y.ana'], ['b.json'], ['c.dxf']]);
  });
  test('old files that differ in their beginning or ending are one case', () => {
    const file = (path: string) => ({ path, bytes: 1, time: 1 });
    const cases = cases_of(['mf15', 'cv15', 'cv16', 'a/c15.mf', 'a/c15.cv', 'a/df01', 'a/dc01'].map(file));
    expect(cases.map(own => own.paths)).toEqual([
      ['a/c15.cv', 'a/c15.mf'],
      ['a/dc01', 'a/df01'],
      ['cv15', 'mf15'],
      ['cv16'],
    ]);
  });
  test('expected values of a verification case are no table to fit', () => {
    const files = ['expected.csv', 'a/expected.csv', 'a/tests.CSV', 'b.json'].map(path => ({
      path,
      bytes: 1,
      time: 1,
    }));
    expect(tables_of(files).map(own => own.path)).toEqual(['a/tests.CSV']);
  });
  test('parts of paths', () => {
    expect([stem_of('a.b/c.json'), stem_of('a.b/c'), folder_of('a/b/c'), folder_of('c'), leaf_of('a/b')]).toEqual([
      'a.b/c',
      'a.b/c',
      'a/b',
      '',
      'b',
    ]);
    expect(new_result('run', ['run', 'run_2'])).toBe('run_3');
    expect(index_at('ab\ncd\nef', 2, 2)).toBe(4);
    expect(index_at('ab', 9, 1)).toBe(2);
  });
  test('a failed job shows its error, not the files that it has written', () => {
    const ran = 'step 3 of 9\nopen a.svg, b.svg\ndata c.csv\n';
    expect(last_messages(`${ran}x.json:2:3: error: expected y\n  help: z\n`)).toBe(
      'x.json:2:3: error: expected y\n  help: z',
    );
    expect(last_messages(ran)).toBe('open a.svg, b.svg\ndata c.csv');
  });
  test('routes come back', () => {
    const path = 'a b/ü#?%.json';
    expect(route_of(link('case', path, 'x'))).toEqual({ kind: 'case', paths: [path, 'x'] });
    expect(route_of(link('compare', 'a', 'b/c'))).toEqual({ kind: 'compare', first: 'a', second: 'b/c' });
    expect(route_of('#/compare/a')).toEqual({ kind: 'home' });
    expect(route_of('')).toEqual({ kind: 'home' });
    expect(route_of('#/case/%E0%A4%A')).toEqual({ kind: 'home' });
  });
});

test('results of both profiles have the name of their folder', () => {
  const names = ['slope/standard', 'a/slope/legacy', 'standard', 'a/slope'].map(name_of_result);
  expect(names).toEqual(['slope, standard', 'slope, legacy', 'standard', 'slope']);
});
