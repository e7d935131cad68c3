// Data of the page: those that it was written with, and those of a run that goes on, which a window about it brings.

import { batch } from '@preact/signals';
import { accept_head, type Head, type Update } from '../data/contract';
import { Store } from '../data/store';
import * as state from './state';

/** Head and chunks in a document, or nothing if it is no page of a run. */
export function data_of(from: Document): { head: Head; store: Store } | null {
  const text_of = (id: string) => from.getElementById(id)?.textContent ?? null;
  const text = text_of('keyblock-head');
  if (text === null) return null;
  // Marks of direction in a name would turn the words around it.
  const head = accept_head(JSON.parse(text.replace(/[\u202a-\u202e\u2066-\u2069]/g, '')));
  return { head, store: new Store(head, text_of) };
}

/** Decodes all data, those of the picture first. */
export async function decode_all(): Promise<void> {
  const { store } = state;
  const field = state.measure.value?.field;
  let last = performance.now();
  const first = ['motion', 'vertex_motion', ...(field ? [field] : []), 'contacts'];
  await state.attempt(() =>
    store.need_all(first, () => {
      if (performance.now() - last < 120) return;
      last = performance.now();
      state.decoded.value++;
    }),
  );
  if (store !== state.store) return;
  state.all_decoded.value = true;
  state.decoded.value++;
}

/** Tables that the drawing shows beside bodies. */
const tables_shown = () =>
  ['bolts', 'cracks', ...(wants_contacts() ? ['contacts'] : [])].filter(what => state.store.has(what));

const wants_contacts = () => state.layers.value.contacts || state.chosen.value !== null;

/** Last frame, start of its epoch, and whether contacts are shown: what the server must know to send the next frame. */
export function shown(): { after: number; epoch: number; contacts: boolean } {
  const { frames } = state.head;
  const last = frames[frames.length - 1];
  const first = frames.find(own => own.epoch === last.epoch) ?? last;
  return { after: last.step, epoch: first.step, contacts: wants_contacts() };
}

/** Adds frames. Who looks at the last one goes on to the new one; who has scrubbed back stays. */
export async function append(update: Update): Promise<void> {
  const { store } = state;
  const has_new = store.append(update);
  const last = state.head.frames.length - 1;
  await store.need_frame(last, [state.measure.value?.field, ...tables_shown()]);
  if (store !== state.store) return;
  batch(() => {
    const is_live = state.frame.value === state.last_frame();
    state.count.value = last + 1;
    if (is_live) state.frame.value = last;
    if (has_new) state.begin_edition();
    else state.decoded.value++;
  });
  void state.attempt(() => store.need_frame(last, store.kinds()));
}

/** Takes the data of another page of the run in place of its own. All that the reader has chosen stays. */
export async function renew(page: string): Promise<void> {
  const data = data_of(new DOMParser().parseFromString(page, 'text/html'));
  if (!data) return;
  const { head, store } = data;
  const place = () => {
    if (state.frame.value === state.last_frame()) return head.frames.length - 1;
    const { step } = state.head.frames[state.frame.value];
    return Math.max(
      0,
      head.frames.findLastIndex(own => own.step <= step),
    );
  };
  await store.need_frame(place(), [state.measure.value?.field, 'bolts', 'cracks', 'contacts']);
  state.all_decoded.value = false;
  state.start_state(head, store, place());
  await decode_all();
}
