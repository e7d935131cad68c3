// Numbers of the items that are chosen on the canvas.

import { useId } from 'preact/hooks';
import { TypedInput } from '../fields';
import * as state from '../state';
import { find, type Path, set } from './case_text';
import * as edits from './edits';
import { coordinates_of, type Item, length_of, type Scene, title_of, value_of } from './scene';
import { schema_at, title_of as title_of_key, words_of } from './schema';

/** More corners stand in the text alone. */
const MOST_CORNERS = 8;

/** Cells of a row behind its coordinates: index and name. */
const CELLS: Partial<Record<Item['kind'], [number, string][]>> = {
  outline: [[4, 'Joint material']],
  joint: [[4, 'Joint material']],
  cut: [[4, 'Joint material']],
  material_line: [[4, 'Block material']],
  force: [
    [2, 'Force x'],
    [3, 'Force y'],
  ],
};

function cells_of(item: Item): [number, string][] {
  if (item.kind !== 'bolt') return CELLS[item.kind] ?? [];
  const first = item.path[0] === 'blocks' ? 6 : 4;
  return [
    [first, 'Stiffness'],
    [first + 1, 'Strength'],
    [first + 2, 'Pretension'],
  ];
}

export function Chosen({
  text,
  scene,
  items,
  choose,
  change,
  remove,
  is_old,
}: {
  text: string;
  scene: Scene;
  items: Item[];
  choose: (keys: string[]) => void;
  change: (text: string) => void;
  remove: () => void;
  is_old: boolean;
}) {
  const [item] = items;
  const list = (
    <select
      aria-label="Item"
      value={items.length === 1 ? item.key : ''}
      onChange={event => choose(event.currentTarget.value ? [event.currentTarget.value] : [])}
    >
      <option value="">{items.length > 1 ? `${items.length} items` : 'Choose an item'}</option>
      {scene.items.map(own => (
        <option value={own.key} key={own.key}>
          {title_of(own)}
        </option>
      ))}
    </select>
  );
  const button = items.some(own => own.kind !== 'block') && (
    <button type="button" class="small" disabled={is_old} onClick={remove} title="Delete (Del)">
      Delete
    </button>
  );
  if (items.length !== 1)
    return (
      <>
        {list}
        {button}
      </>
    );
  const place = (index: number, axis: 0 | 1, value: string) => {
    const number = length_of(value_of(value), scene.length);
    if (Number.isNaN(number)) return;
    const to = [...item.points[index]] as [number, number];
    to[axis] = number;
    change(edits.move_points(text, scene, [{ item, index, to }]));
  };
  const force = item.kind === 'load' ? edits.force_of(scene, Number(item.path.at(-1))) : null;
  return (
    <>
      {list}
      {item.points.length > MOST_CORNERS && (
        <span class="note">{item.points.length} corners: drag them, or see the text</span>
      )}
      {(item.points.length > MOST_CORNERS ? [] : item.points).map((point, index) =>
        ([0, 1] as const).map(axis => (
          <Cell
            key={`${item.key}${index}${axis}`}
            label={item.points.length === 1 ? 'xy'[axis] : `${'xy'[axis]}${index + 1}`}
            value={String(find(scene.root, coordinates_of(item, index)[axis])?.value ?? point[axis])}
            is_off={is_old}
            set={value => place(index, axis, value)}
          />
        )),
      )}
      {cells_of(item).map(([index, label]) => {
        const path: Path = [...item.path, index];
        const value = find(scene.root, path)?.value;
        if (value === undefined) return null;
        if (label.endsWith('material'))
          return (
            <Material
              key={item.key + label}
              label={label}
              names={label.startsWith('Joint') ? scene.joint_materials : scene.block_materials}
              noun={label.startsWith('Joint') ? 'joint' : 'material'}
              value={value as string | number}
              set={own => change(set(text, path, own))}
            />
          );
        return (
          <Cell
            key={item.key + label}
            label={label}
            value={String(value)}
            is_off={is_old}
            set={own => change(set(text, path, value_of(own)))}
          />
        );
      })}
      {item.kind === 'support' && (
        <Held
          value={String(find(scene.root, [...item.path.slice(0, -1), 'held'])?.value ?? 'both')}
          is_off={is_old}
          set={own => change(set(text, [...item.path.slice(0, -1), 'held'], own))}
        />
      )}
      {item.kind === 'traction' &&
        ['x', 'y', 'pressure'].map(name => {
          const path: Path = [...item.path.slice(0, -1), name];
          return (
            <Cell
              key={item.key + name}
              label={name === 'pressure' ? 'Pressure' : `Traction ${name}`}
              value={String(find(scene.root, path)?.value ?? 0)}
              is_off={is_old}
              set={own => change(set(text, path, value_of(own)))}
            />
          );
        })}
      {force &&
        (force.rows > 1 ? (
          <span class="note">force in time: {force.rows} rows, see the text</span>
        ) : (
          ([0, 1] as const).map(axis => (
            <Cell
              key={`${item.key}force${axis}`}
              label={`Force ${'xy'[axis]}`}
              value={String(force.force[axis])}
              is_off={is_old}
              set={own => {
                const next = [...force.force] as typeof force.force;
                next[axis] = value_of(own);
                change(edits.set_force(text, Number(item.path.at(-1)), next));
              }}
            />
          ))
        ))}
      {button}
    </>
  );
}

/** Components that a support prescribes, with the meanings of the schema. */
export function Held({ value, is_off, set }: { value: string; is_off: boolean; set: (value: string) => void }) {
  const path = ['covers', 'displacements', 0, 'held'];
  const own = state.schema.value ? schema_at(state.schema.value, path) : undefined;
  const words = (own?.enum ?? [value]).map(String);
  return (
    <label class="edit-part">
      {title_of_key('held', own)}
      <select value={value} disabled={is_off} onChange={event => set(event.currentTarget.value)}>
        {words.map(word => (
          <option value={word} key={word}>
            {own ? words_of(own, word) : word}
          </option>
        ))}
      </select>
    </label>
  );
}

function Cell({
  label,
  value,
  is_off,
  set,
}: {
  label: string;
  value: string;
  is_off: boolean;
  set: (value: string) => void;
}) {
  const id = useId();
  return (
    <span class="edit-part">
      <label for={id}>{label}</label>
      <TypedInput
        id={id}
        size={Math.max(5, Math.min(11, value.length + 1))}
        value={value}
        is_off={is_off}
        take={typed => {
          if (typed !== value) set(typed);
          return true;
        }}
      />
    </span>
  );
}

function Material({
  label,
  names,
  noun,
  value,
  set,
}: {
  label: string;
  names: string[];
  noun: string;
  value: string | number;
  set: (value: string | number) => void;
}) {
  const index = typeof value === 'number' ? value - 1 : names.indexOf(value);
  const words = names.length ? names : [`${noun} 1`];
  return (
    <label class="edit-part">
      {label}
      <select value={index} onChange={event => set(edits.material_of(names, Number(event.currentTarget.value), noun))}>
        {index < 0 || index >= words.length ? <option value={index}>{String(value)}</option> : null}
        {words.map((own, i) => (
          <option value={i} key={own}>
            {own}
          </option>
        ))}
      </select>
    </label>
  );
}
