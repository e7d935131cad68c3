// Undo and redo.

import { expect, test } from 'vitest';
import { History } from '../../src/serve/edit/history';

test('changes are undone and redone, one by one', () => {
  const history = new History({ text: 'a', caret: null });
  history.push('ab', '', [2, 2]);
  history.push('abc');
  expect(history.undo()).toEqual({ text: 'ab', caret: [2, 2] });
  expect(history.undo().text).toBe('a');
  expect(history.undo().text).toBe('a');
  expect(history.can_undo).toBe(false);
  expect(history.redo().text).toBe('ab');
  history.push('abd');
  expect(history.can_redo).toBe(false);
  expect(history.redo().text).toBe('abd');
});

test('letters typed together are one step; a pause or another change begins a new one', () => {
  const history = new History({ text: '', caret: null });
  history.push('a', 'typing', null, 0);
  history.push('ab', 'typing', null, 100);
  history.push('abc', 'typing', null, 3000);
  history.push('abX', '', null, 3100);
  history.push('abXd', 'typing', null, 3200);
  const seen = [];
  while (history.can_undo) seen.push(history.undo().text);
  expect(seen).toEqual(['abX', 'abc', 'ab', '']);
});

test('an equal text is no step', () => {
  const history = new History({ text: 'a', caret: null });
  history.push('a');
  expect(history.can_undo).toBe(false);
});
