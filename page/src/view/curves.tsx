// Tab Curves: columns of the run's tables over time.

import { signal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import type { CurveColumn, CurveTable } from '../data/contract';
import { nearest_row } from '../draw/chart';
import { show_with } from '../draw/numbers';
import { Chart, curve_colour } from './chart';
import { axis_label, column_label, has_points } from './chosen';
import * as state from './state';

const table_name = signal('');
const picked = signal<Record<string, string[]>>({});

/** Column on the x axis: time, or step where nothing moves in time. */
export function x_column(table: CurveTable): CurveColumn {
  const named = (name: string) => table.columns.find(c => c.name === name);
  const is_static = state.is_static();
  const order = is_static ? ['step', 'load_factor', 'time'] : ['time', 'step'];
  for (const name of order) {
    const own = named(name);
    if (own) return own;
  }
  return table.columns[0];
}

/** Title of a table; that of measured points holds bodies if there are none. */
function title_of(table: CurveTable): string {
  const title = table.title || table.name;
  return has_points() ? title : title.replace('Measured points', 'Bodies');
}

/** Columns drawn at first: those of the first unit, four at most. */
function first_columns(columns: CurveColumn[]): string[] {
  const moving = columns.filter(c => c.values.some(v => v !== null && v !== 0));
  const liked = moving.find(c => /^d|displacement|kinetic|force|K_/.test(c.name)) ?? moving[0] ?? columns[0];
  return (moving.length ? moving : columns)
    .filter(c => c.unit === liked?.unit && /^[xy]\d*$/.test(c.name) === /^[xy]\d*$/.test(liked?.name ?? ''))
    .slice(0, 4)
    .map(c => c.name);
}

export function CurvesTab() {
  const { tables } = state.head;
  if (!tables.length) {
    return (
      <div class="empty">
        <p>
          {state.is_running.value
            ? 'The run goes on. Its curves come at the end, or when it is stopped.'
            : 'This run recorded no tables.'}
        </p>
      </div>
    );
  }
  const table = tables.find(t => t.name === table_name.value) ?? tables[0];
  const x = x_column(table);
  const others = table.columns.filter(c => c !== x && !['step', 'time'].includes(c.name));
  const names = picked.value[table.name] ?? first_columns(others);
  const chosen = others.filter(c => names.includes(c.name));
  const units = [...new Set(chosen.map(c => c.unit ?? ''))];
  const x_of = (f: number) => {
    const own = state.head.frames[f];
    if (x.name === 'step') return own.step;
    if (x.name === 'load_factor') return own.load_factor ?? 0;
    return own.time;
  };
  const xs = useMemo(() => x.values.map(v => v ?? 0), [x]);
  const curves = useMemo(
    () => chosen.map(c => ({ label: c.name, unit: c.unit ?? '', values: c.values })),
    [table, names.join('|')],
  );
  const now = x_of(state.frame.value);
  const at = nearest_row(xs, now);
  const toggle = (name: string) => {
    const next = names.includes(name) ? names.filter(n => n !== name) : [...names, name];
    picked.value = { ...picked.value, [table.name]: next };
  };
  return (
    <div class="stack">
      <section class="group" aria-label="Curves">
        <label class="field">
          <span>Table</span>
          <select
            value={table.name}
            onChange={event => {
              table_name.value = event.currentTarget.value;
            }}
          >
            {tables.map(t => (
              <option value={t.name} key={t.name}>
                {title_of(t)}
              </option>
            ))}
          </select>
        </label>
        {chosen.length > 0 && (
          <Chart
            label={`Curves of ${title_of(table)}`}
            x={xs}
            x_label={axis_label(column_label(x.name).toLowerCase(), x.unit)}
            x_of={x_of}
            curves={curves}
            height={260}
          />
        )}
        {units.length > 2 && <p class="note">A chart shows two units at most. Clear some columns to see the others.</p>}
        <p class="note">Values at the frame of the player. Click a chart to go to a time.</p>
        <ul class="columns">
          {others.map(c => {
            const index = chosen.indexOf(c);
            const value = c.values[at];
            return (
              <li key={c.name}>
                <label class="check">
                  <input type="checkbox" checked={index >= 0} onChange={() => toggle(c.name)} />
                  <i style={{ background: index >= 0 ? curve_colour(index) : 'transparent' }} />
                  <span>{column_label(c.name)}</span>
                  <output>{value === null || value === undefined ? '–' : show_with(value, c.unit ?? '', 4)}</output>
                </label>
              </li>
            );
          })}
        </ul>
      </section>
    </div>
  );
}
