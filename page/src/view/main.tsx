// Start of the page: reads the head, decodes what the first picture needs, then the rest.

import { effect } from '@preact/signals';
import { render } from 'preact';
import { PageError } from '../data/contract';
import { pick_body } from '../draw/pick';
import { part_at, shown_range } from '../draw/scene';
import { capital } from '../draw/words';
import { App } from './app';
import { chart_times } from './chart';
import { shown, timing } from './drawing';
import { record_video, svg_text, video_kind } from './exports';
import { ident_of, nth_of } from './figure';
import { on_key } from './keys';
import * as live from './live';
import { data_of, decode_all } from './live';
import { start_clock } from './player';
import * as state from './state';
import './style.css';

const root = document.getElementById('page')!;

function refuse(text: string): void {
  render(
    <div class="refused" role="alert">
      <h1>Keyblock</h1>
      <p>{text}</p>
    </div>,
    root,
  );
}

async function start(): Promise<void> {
  const data = data_of(document);
  if (data === null) throw new PageError('This page holds no results: write one with "keyblock view RESULT".');
  if (typeof DecompressionStream === 'undefined') {
    throw new PageError('This browser is too old for this page: it needs one of 2023 or newer.');
  }
  const { head, store } = data;
  document.title = `${head.title} – Keyblock`;

  const dark = window.matchMedia('(prefers-color-scheme: dark)');
  state.system_dark.value = dark.matches;
  dark.addEventListener('change', event => {
    state.system_dark.value = event.matches;
  });
  effect(() => {
    document.documentElement.dataset.theme = state.is_dark.value ? 'dark' : 'light';
  });
  window.addEventListener('beforeprint', () => {
    state.printing.value = true;
  });
  window.addEventListener('afterprint', () => {
    state.printing.value = false;
  });
  window.addEventListener('keydown', on_key);

  state.start_state(head, store, head.frames.length - 1);
  await store.need_frame(state.frame.value, [state.measure.value?.field]);
  state.decoded.value++;
  render(<App />, root);
  start_clock();

  // A frame that the player reaches before its turn is decoded at once.
  effect(() => {
    const f = state.frame.value;
    const own = state.measure.value?.field;
    const { store } = state;
    const wanted = ['motion', 'vertex_motion', ...(own ? [own] : [])].filter(what => store.covers(what, f));
    if (!wanted.some(what => !store.field_now(what, f))) return;
    void state.attempt(async () => {
      await Promise.all(wanted.map(what => store.need(what, f)));
      state.decoded.value++;
    });
  });
  await decode_all();
  all_decoded_at = performance.now();
}

let all_decoded_at = 0;

/** Chooses a row of a table in time at the present frame; false if the table has no rows. */
function choose(what: string, i: number): boolean {
  const { store, frame } = state;
  const at = part_at(store, what, frame.value);
  const geometry = store.geometry_now(store.epoch_of(frame.value));
  if (!at?.rows.rows || !geometry) return false;
  const row = Math.min(i, at.rows.rows - 1);
  const ident = ident_of(what, at.rows, row, geometry);
  state.chosen.value = { kind: 'part', what, ident, nth: nth_of(what, at.rows, row, geometry) };
  return true;
}

// For the tests of the page, and for a window that shows two pages side by side.
Object.assign(window, {
  keyblock_page: {
    state,
    live,
    timing,
    chart_times,
    figure: () => shown,
    all_decoded_at: () => all_decoded_at,
    pick: pick_body,
    record_video,
    svg_text,
    choose,
    measures: () => state.measures,
    verdict: () => capital(state.head.verdict.words),
    shown_range: (id: string) => {
      const own = state.measures.find(m => m.id === id);
      return own && own.kind === 'real' ? shown_range(state.run_range(own)) : null;
    },
    video_kind,
  },
});

start().catch(error => {
  if (error instanceof PageError) refuse(error.message);
  else {
    console.error(error);
    refuse('This page cannot be shown: its data are damaged. Write it again with "keyblock view".');
  }
});
