// Changes of a case in YAML: the text changes where it must, and the rest stays.

import { execFileSync } from 'node:child_process';
import { rmSync, writeFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import {
  find,
  JsonError,
  type Path,
  parse,
  plain,
  remove,
  set,
  splice,
  type Value,
} from '../../src/serve/edit/case_text';
import * as edits from '../../src/serve/edit/edits';
import { scene_of } from '../../src/serve/edit/scene';
import { is_yaml } from '../../src/serve/edit/yaml_text';

const CASE = `# A box.
keyblock: 2  # layout
units: {length: m, mass: kg, time: s}
drawing:
  boundary_count: 4
  joints:
    - [0, 0, 10, 0, bedding]  # base
    - [10, 0, 10, 6, bedding]
    - [10, 6, 0, 6, bedding]
    - [0, 6, 0, 0, "bedding"]
    - - 50 cm
      - 0
      - 3
      - 6
      - 2
  fixed_lines: [[-1, 0.01, 31, 0.01],  # base
                [0.01, -1, 0.01, 5]]
  measured_points:
  - [5, 5]
analysis:
  step_count: 100
  time_step: 2 ms
  joint_materials:
    - name: bedding
      friction_angle_deg: 30
    - name: 'cross joint'
  gravity:
`;

const read = (text: string, path: Path = []) => plain(find(parse(text), path));

/** Lines that differ, before and after. */
function changed(before: string, after: string): [string[], string[]] {
  const [a, b] = [before.split('\n'), after.split('\n')];
  return [a.filter(own => !b.includes(own)), b.filter(own => !a.includes(own))];
}

describe('YAML', () => {
  test('is told from JSON, and read with the places of its values', () => {
    expect([is_yaml(CASE), is_yaml('{"keyblock": 2}'), is_yaml('// a\n{"a": 1}'), is_yaml('')]).toEqual([
      true,
      false,
      false,
      false,
    ]);
    expect(read(CASE, ['drawing', 'joints', 4])).toEqual(['50 cm', 0, 3, 6, 2]);
    expect(read(CASE, ['analysis'])).toEqual({
      step_count: 100,
      time_step: '2 ms',
      joint_materials: [{ name: 'bedding', friction_angle_deg: 30 }, { name: 'cross joint' }],
      gravity: null,
    });
    const node = find(parse(CASE), ['drawing', 'joints', 0, 2])!;
    expect(CASE.slice(node.from, node.to)).toBe('10');
    expect(() => parse('a: 1\n  b: 2\n')).toThrow(JsonError);
    expect(() => parse('a: [1, 2\n')).toThrow(JsonError);
    expect(() => parse('a: &x 1\n')).toThrow(JsonError);
  });

  test('values change at their place', () => {
    expect(changed(CASE, set(CASE, ['analysis', 'step_count'], 250))).toEqual([
      ['  step_count: 100'],
      ['  step_count: 250'],
    ]);
    expect(set(CASE, ['analysis', 'gravity'], 9.81)).toContain('\n  gravity: 9.81\n');
    expect(set(CASE, ['keyblock'], 1)).toContain('keyblock: 1  # layout\n');
    expect(set(CASE, ['analysis', 'plane_strain'], true)).toMatch(/gravity:\n {2}plane_strain: true\n$/);
    expect(read(set(CASE, ['run', 'set'], { steps: 5 }), ['run'])).toEqual({ set: { steps: 5 } });
    expect(read(set(CASE, ['analysis'], { step_count: 1 }), ['analysis'])).toEqual({ step_count: 1 });
    expect(
      read(set(CASE, ['analysis', 'joint_materials', 0, 'cohesion'], '2 kPa'), ['analysis', 'joint_materials', 0]),
    ).toEqual({ name: 'bedding', friction_angle_deg: 30, cohesion: '2 kPa' });
  });

  test('entries go with their lines; comments stay', () => {
    expect(changed(CASE, remove(CASE, ['drawing', 'joints', 1]))).toEqual([['    - [10, 0, 10, 6, bedding]'], []]);
    expect(remove(CASE, ['drawing', 'joints', 1])).toContain('# base');
    const first = remove(CASE, ['analysis', 'joint_materials', 0, 'name']);
    expect(read(first, ['analysis', 'joint_materials', 0])).toEqual({ friction_angle_deg: 30 });
    const none = remove(CASE, ['drawing', 'measured_points', 0]);
    expect(read(none, ['drawing', 'measured_points'])).toEqual([]);
    expect(read(splice(none, ['drawing', 'measured_points'], 0, 0, [[1, 2]]), ['drawing', 'measured_points'])).toEqual([
      [1, 2],
    ]);
    const more = splice(CASE, ['drawing', 'fixed_lines'], 2, 0, [[1, 2, 3, 4]]);
    expect(more).toContain('[0.01, -1, 0.01, 5],\n                [1, 2, 3, 4]]\n');
  });

  test('changes of the canvas', () => {
    const scene = scene_of(CASE);
    expect([scene.geometry, scene.items.length, scene.length]).toEqual(['drawing', 8, 'm']);
    const corner = edits.move_points(CASE, scene, [{ item: scene.items[0], index: 1, to: [9, 1] }]);
    expect(corner).toContain('    - [0, 0, 9, 1, bedding]  # base\n    - [9, 1, 10, 6, bedding]\n');
    const joint = edits.move_points(CASE, scene, [{ item: scene.items[4], index: 0, to: [1, 0] }]);
    expect(read(joint, ['drawing', 'joints', 4, 0])).toBe('100 cm');
    const added = edits.add_line(CASE, 'joints', [1, 1], [2, 2], 'cross joint');
    expect(added).toContain('      - 2\n    - [1, 1, 2, 2, "cross joint"]\n');
    const stage = edits.add_stage(CASE, 'dig');
    const dug = edits.add_excavation(
      stage.text,
      stage.index,
      [
        [1, 1],
        [2, 1],
        [2, 2],
      ],
      'bedding',
    );
    expect(read(dug, ['stages', 1, 'excavations', 0, 'joint_material'])).toBe('bedding');
    expect(dug.startsWith(CASE)).toBe(true);
  });

  test('any sequence of changes gives what the same changes of plain data give', () => {
    let seed = 11;
    const random = (n: number) => {
      seed = (seed * 1103515245 + 12345) % 2147483648;
      return (seed >> 8) % n;
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
    expect(text).toContain('# A box.');
  });

  const program = process.env.KEYBLOCK ?? '';
  test.skipIf(!program)('the program reads what the window writes', () => {
    const file = `${process.env.TMPDIR ?? '/tmp'}/keyblock_yaml_${process.pid}`;
    const whole = set(CASE.replace('  gravity:\n', ''), ['analysis', 'block_materials'], [{ like: 'granite' }]);
    const text = edits.add_line(whole, 'joints', [1, 1], [9, 5], 'cross joint');
    writeFileSync(`${file}.yaml`, text);
    try {
      const said = execFileSync(program, ['check', '--json', `${file}.yaml`], { stdio: ['ignore', 'pipe', 'ignore'] });
      expect(JSON.parse(said.toString()).case.size).toBe('10 m by 6 m');
    } finally {
      rmSync(`${file}.yaml`, { force: true });
    }
  });
});
