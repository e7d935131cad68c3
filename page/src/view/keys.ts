// Keyboard of the page.

import { pan_by, zoom_at } from './drawing';
import { toggle_play } from './player';
import * as state from './state';

export const KEYS: [string, string][] = [
  ['Space', 'play or pause'],
  ['← →', 'one frame back or on'],
  ['Shift ← →', 'ten frames back or on'],
  ['Home End', 'first or last frame'],
  ['[ ]', 'stage before or next stage'],
  ['+ −', 'zoom in or out'],
  ['W A S D', 'move the view'],
  ['f', 'fit the model'],
  ['c', 'contact forces'],
  ['p', 'principal stresses'],
  ['v', 'arrows: none, displacement, velocity'],
  ['t', 'trails: none, chosen, all'],
  ['u', 'undeformed outline'],
  ['n', 'block numbers'],
  ['o', 'outlines'],
  ['l', 'legend'],
  ['Esc', 'choose nothing'],
  ['?', 'this help'],
];

function toggle(layer: state.Layer): void {
  state.set_layer(layer, !state.layers.value[layer]);
}

export function on_key(event: KeyboardEvent): void {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const target = event.target as HTMLElement;
  const tag = target.tagName;
  const is_slider = tag === 'INPUT' && (target as HTMLInputElement).type === 'range';
  if (event.key === 'Escape') {
    if (state.help_open.value) state.help_open.value = false;
    else state.chosen.value = null;
    return;
  }
  if (tag === 'SELECT' || tag === 'TEXTAREA') return;
  if (tag === 'INPUT' && !is_slider && !['checkbox', 'radio'].includes((target as HTMLInputElement).type)) return;
  // Controls keep the keys that they use themselves.
  if (is_slider && /^(Arrow|Home|End|Page)/.test(event.key)) return;
  if (tag === 'INPUT' && /^Arrow/.test(event.key) && !is_slider) return;
  if (event.key === ' ' && (tag === 'BUTTON' || tag === 'SUMMARY' || (tag === 'INPUT' && !is_slider))) return;
  if (target.getAttribute('role') === 'tab' && /^(Arrow|Home|End)/.test(event.key)) return;
  const steps = event.shiftKey ? 10 : 1;
  const actions: Record<string, () => void> = {
    ' ': toggle_play,
    ArrowLeft: () => state.go_to(state.frame.value - steps),
    ArrowRight: () => state.go_to(state.frame.value + steps),
    Home: () => state.go_to(0),
    End: () => state.go_to(state.last_frame()),
    '[': () => state.jump(-1),
    ']': () => state.jump(1),
    '+': () => zoom_at(1.3),
    '=': () => zoom_at(1.3),
    '-': () => zoom_at(1 / 1.3),
    w: () => pan_by(0, 60),
    s: () => pan_by(0, -60),
    a: () => pan_by(60, 0),
    d: () => pan_by(-60, 0),
    f: state.fit_view,
    c: () => toggle('contacts'),
    p: () => toggle('crosses'),
    u: () => toggle('undeformed'),
    n: () => toggle('numbers'),
    o: () => toggle('outlines'),
    l: () => toggle('legend'),
    v: () => {
      const kinds = ['none', 'displacement', 'velocity'] as const;
      const allowed = kinds.filter(kind => kind !== 'velocity' || state.head.fields.some(f => f.name === 'velocity'));
      state.arrows.value = allowed[(allowed.indexOf(state.arrows.value) + 1) % allowed.length];
    },
    t: () => {
      const kinds = ['none', 'chosen', 'all'] as const;
      state.trails.value = kinds[(kinds.indexOf(state.trails.value) + 1) % 3];
    },
    '?': () => {
      state.help_open.value = !state.help_open.value;
    },
  };
  const action = actions[event.key] ?? actions[event.key.toLowerCase()];
  if (!action) return;
  event.preventDefault();
  action();
}
