// Changes from the canvas: the text of a case changes where it must and nowhere else.

import { describe, expect, test } from 'vitest';
import { area_of } from '../../src/draw/rings';
import * as edits from '../../src/serve/edit/edits';
import { find, type Path, parse, plain } from '../../src/serve/edit/json_text';
import { extent_of, loops_of, type Point, scene_of, title_of } from '../../src/serve/edit/scene';

const CASE = `{
 "keyblock": 2,
 "units": {"length": "m", "mass": "kg", "time": "s"},
 "drawing": {
  "boundary_count": 4,
  "joints": [
   [0, 0, 10, 0, "bedding"],  // base
   [10, 0, 10, 6, "bedding"],
   [10, 6, 0, 6, "bedding"],
   [0, 6, 0, 0, "bedding"],
   ["50 cm", 0, 3, 6, 2],  // cross joint
  ],
  "loading_points": [[2, 3], [4, 3]],
  "measured_points": [[5, 5]],
 },
 "analysis": {
  "joint_materials": [{"name": "bedding"}, {}],
  "point_loads": [[[0, 1, 0]], [[0, 2, 0], [1, 3, 0]]],
 },
 "stages": [{"name": "dig", "excavations": [{"outline": [[1, 1], [2, 1], [2, 2]]}], "bolts": [[0, 1, 2, 3, 1, 0, 0, 1]]}],
}
`;
const BLOCKS = `{"keyblock": 2, "blocks": {
 "blocks": [{"outer": [[0, 0, 1], [2, 0, 1], [2, 2, 1], [0, 2, 1]]}, {"outer": [[2, 0, 1], [4, 0, 1], [4, 2, 1], [2, 2, 1]]}],
 "measured_points": [[1, 1, 1]]}}`;

const read = (text: string, ...path: Path) => plain(find(parse(text), path));
const item = (text: string, key: string) => scene_of(text).items.find(own => own.key === key)!;

describe('edits', () => {
  test('items of a case have kinds, places and names', () => {
    const scene = scene_of(CASE);
    expect(scene.items.map(own => own.kind)).toEqual([
      'outline',
      'outline',
      'outline',
      'outline',
      'joint',
      'load',
      'load',
      'point',
      'excavation',
      'bolt',
    ]);
    expect(item(CASE, 'drawing/joints/4').points[0]).toEqual([0.5, 0]);
    expect(title_of(item(CASE, 'stages/0/bolts/0'))).toBe('Bolt 1 of stage 1');
    expect(scene.joint_materials).toEqual(['bedding', 'joint 2']);
    expect(loops_of(scene)).toHaveLength(1);
    expect(area_of(loops_of(scene)[0].flat(), 0, 4)).toBe(60);
    expect(extent_of(scene, [])).toEqual({ left: 0, bottom: 0, right: 10, top: 6 });
  });

  test('a corner of the outline moves with both of its sides', () => {
    const scene = scene_of(CASE);
    const after = edits.move_points(CASE, scene, [{ item: scene.items[0], index: 1, to: [12, -1] }]);
    expect(after).toContain('   [0, 0, 12, -1, "bedding"],  // base\n   [12, -1, 10, 6, "bedding"],');
    expect(after.replace('0, 0, 12, -1', '0, 0, 10, 0').replace('[12, -1, 10', '[10, 0, 10')).toBe(CASE);
  });

  test('a length keeps its unit', () => {
    const scene = scene_of(CASE);
    const after = edits.move_items(CASE, scene, [item(CASE, 'drawing/joints/4')], 0.25, 1);
    expect(after).toContain('   ["75 cm", 1, 3.25, 7, 2],  // cross joint');
  });

  test('deleted loads take their forces along; deleted sides count', () => {
    const scene = scene_of(CASE);
    const chosen = [
      'drawing/loading_points/0',
      'drawing/joints/1',
      'drawing/joints/4',
      'stages/0/excavations/0/outline',
    ];
    const after = edits.remove_items(
      CASE,
      scene,
      chosen.map(key => item(CASE, key)),
    );
    expect(read(after, 'drawing', 'loading_points')).toEqual([[4, 3]]);
    expect(read(after, 'analysis', 'point_loads')).toEqual([
      [
        [0, 2, 0],
        [1, 3, 0],
      ],
    ]);
    expect(read(after, 'drawing', 'boundary_count')).toBe(3);
    expect((read(after, 'drawing', 'joints') as unknown[]).length).toBe(3);
    expect(read(after, 'stages', 0, 'excavations')).toEqual([]);
    expect(after).toContain('// base');
  });

  test('a new outline replaces the old one; an opening has a hole point', () => {
    const square: Point[] = [
      [0, 0],
      [20, 0],
      [20, 9],
      [10, 12],
      [0, 9],
    ];
    const after = edits.set_outline(CASE, scene_of(CASE), square, 'bedding');
    expect(loops_of(scene_of(after))).toEqual([square]);
    expect(scene_of(after).items.filter(own => own.kind === 'joint')).toHaveLength(1);
    const opened = edits.add_opening(
      after,
      scene_of(after),
      square.map(([x, y]) => [x / 4 + 4, y / 4 + 2]) as Point[],
      1,
    );
    expect(loops_of(scene_of(opened))).toHaveLength(2);
    expect(read(opened, 'drawing', 'hole_points')).toEqual([[6.5, 3.125]]);
    const fresh = edits.set_outline('{"keyblock": 2}', scene_of('{"keyblock": 2}'), square, 1);
    expect(loops_of(scene_of(fresh))).toEqual([square]);
  });

  test('a point in a notched outline lies inside it', () => {
    const [x, y] = edits.inner_point([
      [0, 0],
      [10, 0],
      [10, 10],
      [9, 10],
      [5, 1],
      [1, 10],
      [0, 10],
    ]);
    expect(y).toBe(5.5);
    expect(x).toBe(1.5);
  });

  test('marks of blocks name the block that carries them', () => {
    const scene = scene_of(BLOCKS);
    expect(read(edits.add_fixed_point(BLOCKS, scene, [3, 1]), 'blocks', 'fixed_points')).toEqual([[3, 1, 2]]);
    const moved = edits.move_items(BLOCKS, scene, [item(BLOCKS, 'blocks/measured_points/0')], 2, 0);
    expect(read(moved, 'blocks', 'measured_points')).toEqual([[3, 1, 2]]);
    const bolted = edits.add_bolt(BLOCKS, scene, [1, 1], [3, 1], { stiffness: 1e7, strength: 0, pretension: 0 }, -1);
    expect(read(bolted, 'blocks', 'bolts')).toEqual([[1, 1, 3, 1, 1, 2, 1e7, 0, 0]]);
  });

  test('loads, bolts, stages and excavations are added where they belong', () => {
    const loaded = edits.add_load(CASE, scene_of(CASE), [6, 3], ['10 kN/m', 0]);
    expect(read(loaded, 'analysis', 'point_loads', 2)).toEqual([[0, '10 kN/m', 0]]);
    expect(edits.force_of(scene_of(loaded), 1)).toEqual({ rows: 2, force: [2, 0] });
    const { text, index } = edits.add_stage(CASE, 'bench 2');
    expect(index).toBe(1);
    const dug = edits.add_excavation(
      text,
      index,
      [
        [1, 1],
        [3, 1],
        [3, 3],
      ] as Point[],
      1,
    );
    expect(read(dug, 'stages', 1)).toEqual({
      name: 'bench 2',
      steps: 400,
      equilibrium: 0.001,
      excavations: [
        {
          outline: [
            [1, 1],
            [3, 1],
            [3, 3],
          ],
          joint_material: 1,
        },
      ],
    });
    expect(edits.add_stage('{"keyblock": 2}', 'bench').index).toBe(1);
  });

  test('base and upright sides are fixed by lines that end outside', () => {
    const slope: Point[] = [
      [0, 0],
      [30, 0],
      [30, 14],
      [18, 14],
      [8, 4],
      [0, 4],
    ];
    const lines = edits.support_lines(slope);
    expect(lines).toEqual([
      [
        [-1, 0.01],
        [31, 0.01],
      ],
      [
        [0.01, -1],
        [0.01, 5],
      ],
      [
        [29.99, -1],
        [29.99, 15],
      ],
    ]);
    expect(read(edits.fix_base_and_sides(CASE), 'drawing', 'fixed_lines')).toHaveLength(3);
  });

  test('joint sets replace the joints and leave the outline', () => {
    const after = edits.put_joints(CASE, [[1, 1, 2, 2, 1]], 1);
    expect(read(after, 'drawing', 'joints', 4)).toEqual([1, 1, 2, 2, 1]);
    expect((read(edits.put_joints(CASE, [[1, 1, 2, 2, 1]], 0), 'drawing', 'joints') as unknown[]).length).toBe(6);
  });

  test('a corner of blocks moves in all blocks that share it; a whole block moves alone', () => {
    const text = `{"keyblock": 2, "blocks": {
 "blocks": [
  {"outer": [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]},  // left
  {"material": 2, "outer": [[1, 0, 1], ["200 cm", 0, 1], [2, 1, 1], [1, 1, 1]],
   "holes": [[[1.2, 0.2, 1], [1.2, 0.4, 1], [1.4, 0.2, 1]]]}
 ],
 "measured_points": [[0.5, 0.5, 1]]}, "units": {"length": "m", "mass": "kg", "time": "s"}}`;
    const scene = scene_of(text);
    const blocks = scene.items.filter(own => own.kind === 'block');
    expect(blocks.map(title_of)).toEqual(['Block 1', 'Block 2', 'Hole 1 of block 2']);
    const moved = edits.move_points(text, scene, [{ item: blocks[0], index: 2, to: [1.5, 1.25] }]);
    expect(read(moved, 'blocks', 'blocks', 0, 'outer', 2)).toEqual([1.5, 1.25, 1]);
    expect(read(moved, 'blocks', 'blocks', 1, 'outer', 3)).toEqual([1.5, 1.25, 1]);
    expect(moved).toContain('// left');
    const whole = edits.move_items(text, scene, [blocks[1]], 1, 0);
    expect(read(whole, 'blocks', 'blocks', 1, 'outer')).toEqual([
      [2, 0, 1],
      ['300 cm', 0, 1],
      [3, 1, 1],
      [2, 1, 1],
    ]);
    expect(read(whole, 'blocks', 'blocks', 0, 'outer', 1)).toEqual([1, 0, 1]);
    expect(edits.remove_items(text, scene, blocks)).toBe(text);
  });

  test('a geometry gets an analysis with the materials that it names', () => {
    const drawing =
      '{"keyblock": 1, "units": {"length": "mm"}, "drawing": {"joints": [[0, 0, 1, 0, 1], [0, 0, 1, 1, 3]]}}';
    const after = edits.add_analysis(drawing, 'granite');
    expect([read(after, 'keyblock'), read(after, 'units')]).toEqual([2, { length: 'mm', mass: 'kg', time: 's' }]);
    expect(read(after, 'analysis', 'joint_materials')).toHaveLength(3);
    expect(read(after, 'analysis', 'block_materials')).toEqual([{ name: 'rock 1', like: 'granite' }]);
    for (const units of [
      { length: 'm', mass: 't', time: 's' },
      { length: 'mm', stress: 'MPa', time: 'ms' },
    ])
      expect(read(edits.add_analysis(JSON.stringify({ keyblock: 2, units, drawing: {} }), 'granite'), 'units')).toEqual(
        units,
      );
    const blocks = edits.add_analysis(BLOCKS.replace('[2, 0, 1]', '[2, 0, 2]'), 'granite');
    expect(read(blocks, 'analysis', 'joint_materials')).toHaveLength(2);
  });

  test('supports and tractions of NMM bodies are added and moved; elements carry points', () => {
    const text = '{"keyblock": 2, "blocks": {"blocks": [{"outer": [[0, 0, 1], [2, 0, 1], [2, 1, 1]]}]}, "covers": {}}';
    const held = edits.add_chain(text, 'displacements', [0, 0], [2, 0], { held: 'normal' });
    expect(read(held, 'covers', 'displacements')).toEqual([
      {
        along: [
          [0, 0],
          [2, 0],
        ],
        held: 'normal',
      },
    ]);
    const scene = scene_of(held);
    expect(scene.has_covers).toBe(true);
    const [crack] = scene_of('{"covers": {"cracks": [{"along": [[0, 1], [2, 1]]}]}}').items;
    expect([crack.kind, crack.is_closed, crack.points.length]).toEqual(['crack', false, 2]);
    const [support] = scene.items.filter(own => own.kind === 'support');
    const moved = edits.move_points(held, scene, [{ item: support, index: 1, to: [1, 0] }]);
    expect(read(moved, 'covers', 'displacements', 0, 'along', 1)).toEqual([1, 0]);
    expect(read(edits.remove_items(held, scene, [support]), 'covers', 'displacements')).toEqual([]);

    const cover = `{"keyblock": 2, "cover": {"elements": [[1, 3, 1, 1, 2, 3], [5, 3, 2, 1, 2, 3]],
 "vertices": [[0, 0], [1, 0], [0, 1], [0, 0], [1, 0], [1, 1], [0, 1], [1, 0]]}}`;
    const own = scene_of(cover);
    expect(own.polygons.map(one => [one.material, one.loops[0].length])).toEqual([
      [1, 3],
      [2, 3],
    ]);
    expect(read(edits.add_fixed_point(cover, own, [0.8, 0.8]), 'cover', 'fixed_points')).toEqual([[0.8, 0.8, 2]]);
  });
});
