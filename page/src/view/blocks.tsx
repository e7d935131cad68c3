// Tab Blocks: a table of all blocks at the present frame, for readers who cannot see the drawing and for look-ups.

import { computed, signal } from '@preact/signals';
import { body_name, word_for_bodies } from '../data/decode';
import { scaled_unit, show } from '../draw/numbers';
import { body_value, unit_of_value, values_of } from '../draw/scene';
import { material_name } from './chosen';
import * as state from './state';

const PAGE = 50;
const page = signal(0);
const filter = signal('');
const order = signal<'number' | 'value'>('number');
const free_only = signal(false);

const rows = computed(() => {
  void state.decoded.value;
  const frame = state.frame.value;
  const geometry = state.store.geometry_now(state.store.epoch_of(frame));
  if (!geometry) return null;
  const own = state.measure.value ?? state.measures[0];
  const values = values_of(state.store, own, frame);
  const list = [];
  const wanted = filter.value.trim();
  for (let row = 0; row < geometry.bodies; row++) {
    if (wanted && String(geometry.number[row]) !== wanted) continue;
    if (free_only.value && geometry.fixed[row]) continue;
    list.push({ row, value: values ? body_value(own, values, geometry, row) : Number.NaN });
  }
  if (order.value === 'value') list.sort((a, b) => (b.value || 0) - (a.value || 0));
  else list.sort((a, b) => geometry.number[a.row] - geometry.number[b.row]);
  let size = 0;
  for (const { value } of list) if (Math.abs(value) > size) size = Math.abs(value);
  return { geometry, own, list, scaled: scaled_unit(own.unit, size) };
});

export function BlocksTab() {
  const now = rows.value;
  if (!now) return null;
  const { geometry, own, list, scaled } = now;
  const word = word_for_bodies(geometry);
  const pages = Math.max(1, Math.ceil(list.length / PAGE));
  const at = Math.min(page.value, pages - 1);
  const chosen = state.chosen.value;
  return (
    <div class="stack">
      <section class="group" aria-label="Blocks">
        <div class="row">
          <label class="field">
            <span>Number</span>
            <input
              type="search"
              inputMode="numeric"
              placeholder="all"
              value={filter.value}
              onInput={event => {
                filter.value = event.currentTarget.value;
                page.value = 0;
              }}
            />
          </label>
          <label class="field">
            <span>Order</span>
            <select
              value={order.value}
              onChange={event => {
                order.value = event.currentTarget.value as 'number' | 'value';
              }}
            >
              <option value="number">by number</option>
              <option value="value">largest value first</option>
            </select>
          </label>
        </div>
        <label class="check">
          <input
            type="checkbox"
            checked={free_only.value}
            onChange={event => {
              free_only.value = event.currentTarget.checked;
              page.value = 0;
            }}
          />
          <span>Free {word} only</span>
        </label>
        <table class="list">
          <caption>
            {list.length === 1 ? body_name(geometry, list[0].row) : `${list.length} ${word}`}, {own.label.toLowerCase()}
          </caption>
          <thead>
            <tr>
              <th scope="col">Number</th>
              <th scope="col">Material</th>
              <th scope="col">Support</th>
              <th scope="col" class="number">
                {own.label}
                {own.kind === 'real' && scaled.unit && ` [${scaled.unit}]`}
              </th>
            </tr>
          </thead>
          <tbody>
            {list.slice(at * PAGE, (at + 1) * PAGE).map(({ row, value }) => {
              const is_chosen = chosen?.kind === 'body' && chosen.key === geometry.key[row];
              return (
                <tr key={geometry.key[row]} class={is_chosen ? 'on' : ''}>
                  <td>
                    <button
                      type="button"
                      class="link"
                      aria-pressed={is_chosen}
                      onClick={() => {
                        state.chosen.value = { kind: 'body', key: geometry.key[row] };
                      }}
                    >
                      {geometry.number[row]}
                    </button>
                  </td>
                  <td>{material_name(geometry.material[row])}</td>
                  <td>{geometry.fixed[row] ? 'fixed' : 'free'}</td>
                  <td class="number">
                    {own.kind === 'state' ? unit_of_value(own, value) : show(value / scaled.factor, own.digits)}
                  </td>
                </tr>
              );
            })}
          </tbody>
        </table>
        {pages > 1 && (
          <div class="row pages">
            <button type="button" class="small" disabled={at === 0} onClick={() => (page.value = at - 1)}>
              Back
            </button>
            <span>
              Page {at + 1} of {pages}
            </span>
            <button type="button" class="small" disabled={at === pages - 1} onClick={() => (page.value = at + 1)}>
              Next
            </button>
          </div>
        )}
      </section>
    </div>
  );
}
