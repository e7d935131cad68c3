// Tab Chosen: values and history of the chosen block, contact, bolt, crack, tip or point.

import { computed, signal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { type ColumnHead, NO_ROW } from '../data/contract';
import { body_name, type Geometry } from '../data/decode';
import { value_at } from '../data/store';
import type { Measure } from '../draw/measures';
import { show, show_place, show_with } from '../draw/numbers';
import { body_area, body_value, displacement_of, extent_of, part_at, unit_of_value, values_of } from '../draw/scene';
import { capital } from '../draw/words';
import { Chart, type Curve } from './chart';
import { Fact } from './fact';
import { ident_of, nth_of, row_of } from './figure';
import { MeasureOptions } from './show';
import * as state from './state';

const history_id = signal('displacement.size');
const part_column = signal('');

const SINGULAR: Record<string, string> = {
  contacts: 'Contact',
  bolts: 'Bolt',
  cracks: 'Crack',
  tips: 'Crack tip',
  points: 'Measured point',
};

function geometry_now(): Geometry | undefined {
  void state.decoded.value;
  return state.store.geometry_now(state.store.epoch_of(state.frame.value));
}

export function material_name(index: number): string {
  return state.head.materials[index] ?? String(index + 1);
}

function time_axis(): { x: number[]; label: string; of: (frame: number) => number } {
  const { head } = state;
  const is_static = state.is_static();
  const of = (f: number) => (is_static ? head.frames[f].step : head.frames[f].time);
  return { x: head.frames.map((_, f) => of(f)), label: is_static ? 'step' : axis_label('time', head.units?.time), of };
}

export function axis_label(name: string, unit?: string): string {
  return unit ? `${name} [${unit}]` : name;
}

/** Curve of a measure of one body over all frames. */
export function body_curve(measure: Measure, key: number): Curve {
  const values: (number | null)[] = [];
  const { head, store } = state;
  const scratch = new Map<number, Float32Array>();
  for (let f = 0; f < head.frames.length; f++) {
    const geometry = store.geometry_now(store.epoch_of(f));
    const row = geometry?.row_of_key.get(key);
    let value: number | null = null;
    if (geometry && row !== undefined) {
      const at = measure.field ? store.field_now(measure.field, f) : undefined;
      if (at || !measure.field || !store.covers(measure.field, f)) {
        // Only the rows of this body are of interest, so the whole frame is filled once per epoch's size.
        const n = measure.on === 'body' ? geometry.bodies : geometry.vertices;
        let out = scratch.get(n);
        if (!out) {
          out = new Float32Array(n);
          scratch.set(n, out);
        }
        measure.fill(out, at, geometry, f);
        value = body_value(measure, out, geometry, row);
        if (Number.isNaN(value)) value = null;
      }
    }
    values.push(value);
  }
  return { label: measure.label, unit: measure.unit, values };
}

function choose_body(key: number): void {
  state.chosen.value = { kind: 'body', key };
}

/** Angle of a body in degrees, anticlockwise, from the antisymmetric part of its gradient. */
function rotation_of(row: number): number | null {
  const motion = state.store.field_now('motion', state.frame.value);
  if (!motion) return null;
  const [g11, g12, g21, g22] = [2, 3, 4, 5].map(part => value_at(motion, part, row));
  return (Math.atan2(g21 - g12, 2 + g11 + g22) * 180) / Math.PI;
}

export function ChosenTab() {
  const chosen = state.chosen.value;
  const geometry = geometry_now();
  const live = state.playing.value ? 'off' : 'polite';
  if (!chosen || !geometry) {
    return (
      <div class="empty" aria-live="polite">
        <p>Nothing is chosen.</p>
        <p>Click a block in the drawing. Contacts, bolts, cracks and points can be clicked too.</p>
        <p>The tab Blocks lists all blocks.</p>
      </div>
    );
  }
  if (chosen.kind === 'body') return <BodyPanel key={chosen.key} body={chosen.key} geometry={geometry} live={live} />;
  return <PartPanel chosen={chosen} geometry={geometry} live={live} />;
}

function BodyPanel({ body, geometry, live }: { body: number; geometry: Geometry; live: 'off' | 'polite' }) {
  const row = geometry.row_of_key.get(body);
  const { head, store } = state;
  const frame = state.frame.value;
  if (row === undefined) {
    return (
      <div class="empty" aria-live="polite">
        <p>It is not part of the model at this frame.</p>
      </div>
    );
  }
  const length = head.units?.length ?? '';
  const moved = displacement_of(store, frame, row);
  const angle = rotation_of(row);
  const [ox, oy] = head.origin;
  const extent = extent_of(geometry);
  const cx = geometry.centroid[2 * row] + ox + (moved?.[0] ?? 0);
  const cy = geometry.centroid[2 * row + 1] + oy + (moved?.[1] ?? 0);
  const groups = new Map<string, [string, string][]>();
  for (const own of state.measures) {
    if (own.group === 'Model') continue;
    const values = values_of(store, own, frame);
    if (!values) continue;
    const value = body_value(own, values, geometry, row);
    if (Number.isNaN(value)) continue;
    const label = own.label.startsWith(`${own.group}, `) ? own.label.slice(own.group.length + 2) : own.label;
    const list = groups.get(own.group) ?? [];
    list.push([label, unit_of_value(own, value)]);
    groups.set(own.group, list);
  }
  return (
    <div class="stack">
      <section class="group" aria-label="Chosen block">
        <div class="chosen-head" aria-live={live}>
          <h2>{capital(body_name(geometry, row))}</h2>
          <p>
            {geometry.fixed[row] ? 'Fixed' : 'Free'}, material {material_name(geometry.material[row])}
            {moved && `, displacement ${show_with(Math.hypot(...moved), length, 4)}`}
          </p>
        </div>
        <table class="facts">
          <tbody>
            <Fact
              name="Centroid"
              value={`${show_place(cx, extent)}, ${show_place(cy, extent)}${length ? ` ${length}` : ''}`}
            />
            <Fact
              name="Area"
              value={`${show(body_area(geometry, geometry.place, row), 4)}${length ? ` ${length}²` : ''}`}
            />
            {angle !== null && <Fact name="Rotation" value={`${show(angle, 3)}°`} />}
          </tbody>
          {[...groups].map(([group, list]) => (
            <tbody key={group}>
              {list.length > 1 && (
                <tr class="sub">
                  <th colSpan={2} scope="rowgroup">
                    {group}
                  </th>
                </tr>
              )}
              {list.map(([label, value]) => (
                <Fact key={label} name={label} value={value} indent={list.length > 1} />
              ))}
            </tbody>
          ))}
        </table>
      </section>
      <History body={body} />
      <ContactsOf row={row} geometry={geometry} />
    </div>
  );
}

/** Changes when curves must be read again: at the end of decoding, and with each frame of a run that goes on. */
const settled = computed(() => `${state.all_decoded.value} ${state.count.value}`);

function History({ body }: { body: number }) {
  const stamp = settled.value;
  const axis = useMemo(time_axis, [stamp]);
  const own = state.measures.find(m => m.id === history_id.value) ?? state.measures[0];
  const curves = useMemo(() => [body_curve(own, body)], [own, body, stamp]);
  if (state.last_frame() < 1) return null;
  return (
    <section class="group" aria-labelledby="history-title">
      <h2 id="history-title">History</h2>
      <label class="field">
        <span>Quantity</span>
        <select
          value={own.id}
          onChange={event => {
            history_id.value = event.currentTarget.value;
          }}
        >
          <MeasureOptions only={id => !['material', 'fixed', 'single'].includes(id)} />
        </select>
      </label>
      <Chart
        label={`History of the chosen block: ${own.label}`}
        x={axis.x}
        x_label={axis.label}
        x_of={axis.of}
        curves={curves}
      />
    </section>
  );
}

const STATES = ['open', 'sticks', 'slides'];

/** Closed contacts of a block at this frame. */
function ContactsOf({ row, geometry }: { row: number; geometry: Geometry }) {
  const at = part_at(state.store, 'contacts', state.frame.value);
  if (!at) return null;
  const { block, other, normal_force, shear_force, state: states } = at.rows.columns;
  if (!block || !other || !normal_force) return null;
  const unit = part_unit('contacts', 'normal_force');
  const list: number[] = [];
  for (let i = 0; i < at.rows.rows; i++) if (block[i] === row || other[i] === row) list.push(i);
  const most = 40;
  const names = state.head.parts?.contacts?.columns.find(c => c.name === 'state')?.names ?? STATES;
  return (
    <section class="group" aria-labelledby="contacts-title">
      <h2 id="contacts-title">Contacts</h2>
      {list.length === 0 ? (
        <p class="note">No contact is closed at this frame.</p>
      ) : (
        <table class="list">
          <thead>
            <tr>
              <th scope="col">With</th>
              <th scope="col" class="number">
                Normal force
              </th>
              <th scope="col" class="number">
                Shear force
              </th>
              <th scope="col">State</th>
            </tr>
          </thead>
          <tbody>
            {list.slice(0, most).map(i => {
              const partner = block[i] === row ? other[i] : block[i];
              const has_partner = partner !== NO_ROW && partner < geometry.bodies;
              return (
                <tr key={i}>
                  <td>
                    {has_partner ? (
                      <button type="button" class="link" onClick={() => choose_body(geometry.key[partner])}>
                        {body_name(geometry, partner)}
                      </button>
                    ) : (
                      '–'
                    )}
                  </td>
                  <td class="number">
                    <button
                      type="button"
                      class="link"
                      title="Show this contact"
                      onClick={() => {
                        state.chosen.value = {
                          kind: 'part',
                          what: 'contacts',
                          ident: ident_of('contacts', at.rows, i, geometry),
                          nth: nth_of('contacts', at.rows, i, geometry),
                        };
                      }}
                    >
                      {show_with(normal_force[i], unit, 3)}
                    </button>
                  </td>
                  <td class="number">{shear_force ? show_with(shear_force[i], unit, 3) : '–'}</td>
                  <td>{states ? (names[states[i]] ?? states[i]) : ''}</td>
                </tr>
              );
            })}
          </tbody>
        </table>
      )}
      {list.length > most && <p class="note">{list.length - most} more contacts are not listed.</p>}
    </section>
  );
}

export function part_unit(what: string, column: string): string {
  return state.head.parts?.[what]?.columns.find(c => c.name === column)?.unit ?? '';
}

/** Names of a column's parts. */
const PART_NAMES: Record<number, string[]> = {
  1: [''],
  2: ['x', 'y'],
  3: ['xx', 'yy', 'xy'],
  4: ['xx', 'yy', 'xy', 'zz'],
};

const COLUMN_LABELS: Record<string, string> = {
  dt: 'Time step',
  passes: 'Open–close iterations',
  redos: 'Repeated attempts',
  fallbacks: 'Fallback solves',
};

/** The program follows bodies if a case has no measured points. */
export const has_points = (): boolean => state.head.run?.counts?.measured_points !== 0;

const word_for_places = () => (has_points() ? 'Point' : state.head.run?.counts.elements ? 'Element' : 'Block');

export function column_label(name: string): string {
  if (COLUMN_LABELS[name]) return COLUMN_LABELS[name];
  if (/^[KJ]_?[IVX]*$/.test(name)) return name.replace('_', ' ');
  const place = /^(d?)([xy])(\d+)$/.exec(name);
  if (place) return `${word_for_places()} ${place[3]}, ${place[1] && 'displacement '}${place[2]}`;
  return capital(name.replace(/_/g, ' ').replace(/^bolt(\d+)$/, 'bolt $1, force'));
}

function parts_of_column(column: ColumnHead): string[] {
  const n = column.parts ?? 1;
  if (n === 4 && column.name === 'displacement') return ['x 1', 'y 1', 'x 2', 'y 2'];
  return PART_NAMES[n] ?? Array.from({ length: n }, (_, i) => String(i + 1));
}

function value_text(column: ColumnHead, value: number, part: number, geometry: Geometry): string {
  const { name } = column;
  if (name === 'block' || name === 'other') {
    return value === NO_ROW || value >= geometry.bodies ? '–' : body_name(geometry, value);
  }
  if (column.names?.length) return column.names[value] ?? String(value);
  if (name === 'state') return STATES[value] ?? String(value);
  if (name === 'joint') return state.head.joints[value] ?? String(value);
  if (column.type === 'u32') return value === NO_ROW ? '–' : String(value);
  if (name === 'place' || name === 'from' || name === 'to') {
    return `${show_place(value + state.head.origin[part % 2], extent_of(geometry))}${column.unit ? ` ${column.unit}` : ''}`;
  }
  return show_with(value, column.unit ?? '', 4);
}

function PartPanel({
  chosen,
  geometry,
  live,
}: {
  chosen: Extract<state.Chosen, { kind: 'part' }>;
  geometry: Geometry;
  live: 'off' | 'polite';
}) {
  const { what } = chosen;
  const columns = state.head.parts?.[what]?.columns ?? [];
  const at = part_at(state.store, what, state.frame.value);
  const i = at ? row_of(what, chosen.ident, chosen.nth, at.rows, geometry) : null;
  const title = what === 'contacts' ? 'Contact' : `${SINGULAR[what] ?? column_label(what)} ${chosen.ident[0] ?? ''}`;
  if (!at || i === null) {
    return (
      <div class="empty" aria-live="polite">
        <p>{title} does not exist at this frame, or it is open.</p>
      </div>
    );
  }
  const own = at.rows.columns;
  const pair =
    what === 'contacts' && own.block && own.other
      ? [own.block[i], own.other[i]].filter(row => row !== NO_ROW && row < geometry.bodies)
      : [];
  return (
    <div class="stack">
      <section class="group" aria-label={title}>
        <div class="chosen-head" aria-live={live}>
          <h2>{title}</h2>
          {pair.length > 0 && (
            <p>
              between{' '}
              {pair.map((row, n) => (
                <span key={row}>
                  {n > 0 && ' and '}
                  <button type="button" class="link" onClick={() => choose_body(geometry.key[row])}>
                    {body_name(geometry, row)}
                  </button>
                </span>
              ))}
            </p>
          )}
        </div>
        <table class="facts">
          <tbody>
            {columns.flatMap(column => {
              const values = own[column.name];
              const names = parts_of_column(column);
              if (!values) return [];
              return names.map((part, p) => (
                <Fact
                  key={`${column.name}${part}`}
                  name={`${column_label(column.name)}${part ? `, ${part}` : ''}`}
                  value={value_text(column, values[names.length * i + p], p, geometry)}
                />
              ));
            })}
          </tbody>
        </table>
      </section>
      <PartHistory chosen={chosen} columns={columns} />
    </div>
  );
}

function PartHistory({ chosen, columns }: { chosen: Extract<state.Chosen, { kind: 'part' }>; columns: ColumnHead[] }) {
  const real = columns.filter(c => c.type !== 'u32' && !['place', 'normal', 'from', 'to'].includes(c.name));
  const options = real.flatMap(c =>
    parts_of_column(c).map((part, p) => ({
      id: `${c.name} ${p}`,
      column: c,
      part: p,
      label: `${column_label(c.name)}${part ? `, ${part}` : ''}`,
    })),
  );
  const own = options.find(o => o.id === part_column.value) ?? options[0];
  const stamp = settled.value;
  // Tables that are stored at every n-th frame have a curve over those frames alone.
  const axis = useMemo(() => {
    const frames = state.head.frames.map((_, f) => f).filter(f => state.store.covers(chosen.what, f));
    const { of, label } = time_axis();
    return { frames, x: frames.map(of), label, of };
  }, [chosen.what, stamp]);
  const curves = useMemo(() => {
    if (!own) return [];
    const values: (number | null)[] = [];
    const n = own.column.parts ?? 1;
    for (const f of axis.frames) {
      const rows = state.store.part_now(chosen.what, f);
      const geometry = state.store.geometry_now(state.store.epoch_of(f));
      const i = rows && geometry ? row_of(chosen.what, chosen.ident, chosen.nth, rows, geometry) : null;
      values.push(i === null || !rows ? null : rows.columns[own.column.name][n * i + own.part]);
    }
    return [{ label: own.label, unit: own.column.unit ?? '', values }];
  }, [own?.id, chosen, stamp]);
  if (!own || state.last_frame() < 1) return null;
  return (
    <section class="group" aria-labelledby="part-history">
      <h2 id="part-history">History</h2>
      <label class="field">
        <span>Quantity</span>
        <select
          value={own.id}
          onChange={event => {
            part_column.value = event.currentTarget.value;
          }}
        >
          {options.map(o => (
            <option value={o.id} key={o.id}>
              {o.label}
            </option>
          ))}
        </select>
      </label>
      <Chart label={`History: ${own.label}`} x={axis.x} x_label={axis.label} x_of={axis.of} curves={curves} />
      {curves[0]?.values.every(v => v === null) && <p class="note">No frame holds it.</p>}
    </section>
  );
}
