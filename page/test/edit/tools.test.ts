import { expect, test } from 'vitest';
import { hint_of, tool_of } from '../../src/serve/edit/tools';

test('the hint of a tool names the clicks that it takes in a scene', () => {
  expect(hint_of(tool_of('fixed'), 'drawing')).toContain('start and end');
  expect(hint_of(tool_of('fixed'), 'blocks')).toBe('Click a place of a body. It is fixed there.');
  expect(hint_of(tool_of('fixed'), 'cover')).not.toContain('end of the');
});
