import { describe, expect, test } from 'vitest';
import { pointers_in } from '../../src/serve/pointers';

describe('parameters of a sweep', () => {
  const expected = [
    ['/analysis/gravity', 9.81],
    ['/analysis/joint_materials/0/friction_angle_deg', 30],
    ['/analysis/joint_materials/0/cohesion', '2 kPa'],
  ];

  test('come from JSON with comments and trailing commas', () => {
    const text = `{"keyblock": 2, // layout
 "analysis": {"gravity": 9.81, "joint_materials": [{"name": "bedding", "friction_angle_deg": 30, "cohesion": "2 kPa"},]},
 "drawing": {"joints": [[0, 0, 1, 0, 1]]}}`;
    expect(pointers_in(text)).toEqual(expected);
    expect(pointers_in('{"analysis": ')).toEqual([]);
  });

  test('come from YAML', () => {
    const text = `keyblock: 2
analysis:
  gravity: 9.81  # as usual
  joint_materials:
    - name: bedding
      friction_angle_deg: 30
      cohesion: 2 kPa
drawing:
  joints:
    - [0, 0, 1, 0, 1]
`;
    expect(pointers_in(text)).toEqual(expected);
  });
});
