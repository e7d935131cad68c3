// Tab Show: colours, range, magnification, layers.

import { type MapName, SEQUENTIAL } from '../draw/colours';
import { show, show_range } from '../draw/numbers';
import { pose_of } from '../draw/scene';
import { shade_at } from './figure';
import * as state from './state';

const MAP_NAMES: Record<MapName, string> = {
  rising: 'White to red',
  viridis: 'Viridis',
  cividis: 'Cividis',
  grey: 'Grey',
};

export function Check({
  label,
  hint,
  on,
  set,
}: {
  label: string;
  hint?: string;
  on: boolean;
  set: (on: boolean) => void;
}) {
  return (
    <label class="check">
      <input type="checkbox" checked={on} onChange={event => set(event.currentTarget.checked)} />
      <span>{label}</span>
      {hint && <kbd aria-hidden="true">{hint}</kbd>}
    </label>
  );
}

function LayerCheck({ name, label, hint }: { name: state.Layer; label: string; hint?: string }) {
  return <Check label={label} hint={hint} on={state.layers.value[name]} set={on => state.set_layer(name, on)} />;
}

export function MeasureOptions({ only }: { only?: (id: string) => boolean }) {
  const groups = [...new Set(state.measures.map(m => m.group))];
  return (
    <>
      {groups.map(group => {
        const own = state.measures.filter(m => m.group === group && (!only || only(m.id)));
        if (!own.length) return null;
        return (
          <optgroup label={group} key={group}>
            {own.map(m => (
              <option value={m.id} key={m.id}>
                {m.label}
              </option>
            ))}
          </optgroup>
        );
      })}
    </>
  );
}

export function ShowTab() {
  const { head, store } = state;
  const own = state.measure.value;
  void state.decoded.value;
  void state.frame.value;
  const is_real = own?.kind === 'real';
  const pose = is_real ? pose_of(store, state.frame.value, 1) : undefined;
  const shade = pose ? shade_at(pose) : null;
  const has = (what: string) => store.has(what);
  const has_field = (name: string) => head.fields.some(f => f.name === name);
  const limit = (side: 'low' | 'high') => (
    <label>
      <span>{side === 'low' ? 'Low' : 'High'}</span>
      <input
        type="number"
        step="any"
        value={state.own_range.value[side]}
        onInput={event => {
          const value = event.currentTarget.valueAsNumber;
          if (!Number.isNaN(value)) state.own_range.value = { ...state.own_range.value, [side]: value };
        }}
      />
    </label>
  );
  return (
    <div class="stack">
      <section class="group" aria-labelledby="show-colour">
        <h2 id="show-colour">Colour</h2>
        <label class="field">
          <span>Colour by</span>
          <select
            value={state.measure_id.value}
            onChange={event => {
              state.measure_id.value = event.currentTarget.value;
            }}
          >
            <option value="">No colour</option>
            <MeasureOptions />
          </select>
        </label>
        {is_real && (
          <>
            <fieldset class="segments">
              <legend>Range</legend>
              {(
                [
                  ['run', 'Whole run'],
                  ['frame', 'This frame'],
                  ['own', 'Own limits'],
                ] as const
              ).map(([mode, label]) => (
                <label key={mode}>
                  <input
                    type="radio"
                    name="range"
                    checked={state.range_mode.value === mode}
                    onChange={() => {
                      if (mode === 'own' && shade) state.own_range.value = { low: shade.low, high: shade.high };
                      state.range_mode.value = mode;
                    }}
                  />
                  <span>{label}</span>
                </label>
              ))}
            </fieldset>
            {state.range_mode.value === 'own' ? (
              <div class="pair">
                {limit('low')}
                {limit('high')}
                {own.unit && <span class="unit">{own.unit}</span>}
              </div>
            ) : (
              shade && <p class="note">{show_range(shade.low, shade.high, own.unit, own.digits)}</p>
            )}
            {own.is_signed ? (
              <p class="note">Negative values are blue, positive ones red.</p>
            ) : (
              <label class="field">
                <span>Map</span>
                <select
                  value={state.map_name.value}
                  onChange={event => {
                    state.map_name.value = event.currentTarget.value as MapName;
                  }}
                >
                  {SEQUENTIAL.map(name => (
                    <option value={name} key={name}>
                      {MAP_NAMES[name]}
                    </option>
                  ))}
                </select>
              </label>
            )}
          </>
        )}
        {own?.group === 'Displacement' && own.on === 'body' && (
          <p class="note">Displacements are those of centroids. Corners may move farther.</p>
        )}
        {own && /stress/i.test(own.group) && <p class="note">Tension is positive, compression negative.</p>}
      </section>

      <section class="group" aria-labelledby="show-motion">
        <h2 id="show-motion">Displacements</h2>
        <Magnification />
        <LayerCheck name="undeformed" label="Undeformed outline" hint="u" />
        <label class="field">
          <span>Arrows</span>
          <select
            value={state.arrows.value}
            onChange={event => {
              state.arrows.value = event.currentTarget.value as typeof state.arrows.value;
            }}
          >
            <option value="none">None</option>
            <option value="displacement">Displacement</option>
            {has_field('velocity') && <option value="velocity">Velocity</option>}
          </select>
        </label>
        <label class="field">
          <span>Trails</span>
          <select
            value={state.trails.value}
            onChange={event => {
              state.trails.value = event.currentTarget.value as typeof state.trails.value;
            }}
          >
            <option value="none">None</option>
            <option value="chosen">Chosen block</option>
            <option value="all">All free blocks</option>
          </select>
        </label>
      </section>

      <section class="group" aria-labelledby="show-layers">
        <h2 id="show-layers">Layers</h2>
        <div class="checks">
          {has('contacts') && <LayerCheck name="contacts" label="Contact forces" hint="c" />}
          {has_field('stress') && <LayerCheck name="crosses" label="Principal stresses" hint="p" />}
          <LayerCheck name="numbers" label="Block numbers" hint="n" />
          <LayerCheck name="outlines" label="Outlines" hint="o" />
          {has('bolts') && <LayerCheck name="bolts" label="Bolts" />}
          {has('cracks') && <LayerCheck name="cracks" label="Cracks" />}
          {has('tips') && <LayerCheck name="tips" label="Crack tips" />}
          {has('points') && <LayerCheck name="points" label="Measured points" />}
          {!!head.still?.length && <LayerCheck name="still" label="Supports and loads" />}
          <LayerCheck name="legend" label="Legend" hint="l" />
        </div>
        {state.layers.value.contacts && head.joints.length > 1 && (
          <label class="field">
            <span>Contacts by</span>
            <select
              value={state.contact_colour.value}
              onChange={event => {
                state.contact_colour.value = event.currentTarget.value as 'state' | 'joint';
              }}
            >
              <option value="state">State</option>
              <option value="joint">Joint material</option>
            </select>
          </label>
        )}
        <StoredNote />
      </section>
    </div>
  );
}

/** Says which frame contacts belong to, if they are stored at every n-th frame only. */
function StoredNote() {
  if (!state.layers.value.contacts) return null;
  const stored = state.store.stored_frame('contacts', state.frame.value);
  if (stored === null) return <p class="note">This frame has no contact forces.</p>;
  if (stored === state.frame.value) return null;
  return <p class="note">Contact forces are those of step {state.head.frames[stored].step}, the last one stored.</p>;
}

function Magnification() {
  const s = state.magnification.value;
  const set = (value: number) => {
    if (value >= 0 && Number.isFinite(value)) state.magnification.value = value;
  };
  return (
    <div class="field wide">
      <span id="magnification-label">Magnification</span>
      <div class="magnify">
        <input
          type="range"
          min={0}
          max={5}
          step={0.01}
          value={Math.log10(Math.max(1, s))}
          style={{ '--share': Math.log10(Math.max(1, s)) / 5 }}
          aria-label="Magnification of displacements, slider"
          aria-valuetext={`${show(s, 3)} times`}
          onInput={event => {
            const power = Number(event.currentTarget.value);
            set(Number((10 ** power).toPrecision(2)));
          }}
        />
        <input
          type="number"
          min={0}
          step="any"
          value={s}
          aria-label="Magnification of displacements"
          onChange={event => set(event.currentTarget.valueAsNumber)}
        />
      </div>
      <div class="row">
        <button type="button" class="small" aria-pressed={s === 1} onClick={() => set(1)}>
          True scale
        </button>
        <button type="button" class="small" onClick={() => set(state.suited_magnification())}>
          Suited to the view
        </button>
      </div>
    </div>
  );
}
