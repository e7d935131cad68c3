// Numbers of the items that are chosen on the canvas.

import { useId } from 'preact/hooks';
import { TypedInput, ValueBox } from '../fields';
import * as state from '../state';
import { find, type Path, type Step, set, type Value } from './case_text';
import * as edits from './edits';
import { coordinates_of, type Item, length_of, type Scene, title_of, value_of } from './scene';
import { schema_at, title_of as title_of_key, unit_in, words_of } from './schema';

/** More corners stand in the text alone. */
const MOST_CORNERS = 8;

/** Kinds of lines with a material behind their coordinates. */
const MATERIALS: Partial<Record<Item['kind'], string>> = {
  outline: 'Joint material',
  joint: 'Joint material',
  cut: 'Joint material',
  material_line: 'Block material',
};

/** Value of an item besides its places: path in the text, key, and a word before its title. */
interface Own {
  path: Path;
  key: string;
  before?: string;
  /** Value if the text has none. */
  absent?: Value;
}

function values_of(item: Item): Own[] {
  const at = (step: Step, key: string): Own => ({ path: [...item.path, step], key });
  if (item.kind === 'force') return ['x', 'y'].map((key, i) => ({ ...at(2 + i, key), before: 'Force' }));
  if (item.kind === 'bolt') {
    const first = item.path[0] === 'blocks' ? 6 : 4;
    return ['stiffness', 'strength', 'pretension'].map((key, i) => at(first + i, key));
  }
  if (item.kind !== 'traction') return [];
  const path = item.path.slice(0, -1);
  const own = (key: string, before?: string): Own => ({ path: [...path, key], key, before, absent: 0 });
  return [own('x', 'Traction'), own('y', 'Traction'), own('pressure')];
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
      {MATERIALS[item.kind] && (
        <Material
          key={`${item.key}material`}
          label={MATERIALS[item.kind]!}
          scene={scene}
          value={(find(scene.root, [...item.path, 4])?.value ?? 1) as string | number}
          is_off={is_old}
          set={own => change(set(text, [...item.path, 4], own))}
        />
      )}
      {values_of(item).map(own => {
        const value = find(scene.root, own.path)?.value ?? own.absent;
        if (value === undefined) return null;
        return (
          <ValueCell
            key={`${item.key}${own.path.join()}`}
            own={own}
            value={value}
            is_off={is_old}
            set={next => change(set(text, own.path, next))}
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
      {force &&
        (force.rows > 1 ? (
          <span class="note">force in time: {force.rows} rows, see the text</span>
        ) : (
          ([0, 1] as const).map(axis => (
            <ValueCell
              key={`${item.key}force${axis}`}
              own={{ path: ['analysis', 'point_loads', 0, 0, 1 + axis], key: 'xy'[axis], before: 'Force' }}
              value={force.force[axis]}
              is_off={is_old}
              set={own => {
                const next = [...force.force] as typeof force.force;
                next[axis] = own;
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

/** Box of a value with title, unit, limits and words of the schema. */
function ValueCell({
  own: { path, key, before },
  value,
  is_off,
  set,
}: {
  own: Own;
  value: Value;
  is_off: boolean;
  set: (value: Value) => void;
}) {
  const id = useId();
  const own = state.schema.value ? schema_at(state.schema.value, path) : undefined;
  const title = title_of_key(key, own);
  const unit = own ? unit_in(own, state.units.value) : '';
  const size = Math.max(5, Math.min(11, String(value).length + 1));
  return (
    <span class="edit-part">
      <label for={id}>
        {before ? `${before} ${title.toLowerCase()}` : title}
        {unit && ` [${unit}]`}
      </label>
      <ValueBox id={id} own={own ?? {}} value={value} put={set} clear={() => {}} size={size} is_off={is_off} />
    </span>
  );
}

/** Box of a coordinate. */
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
  scene,
  value,
  is_off,
  set,
}: {
  label: string;
  scene: Scene;
  value: string | number;
  is_off: boolean;
  set: (value: string | number) => void;
}) {
  const is_joint = label.startsWith('Joint');
  const names = is_joint ? scene.joint_materials : scene.block_materials;
  const noun = is_joint ? 'joint' : 'material';
  const index = typeof value === 'number' ? value - 1 : names.indexOf(value);
  const words = names.length ? names : [`${noun} 1`];
  return (
    <label class="edit-part">
      {label}
      <select
        value={index}
        disabled={is_off}
        onChange={event => set(edits.material_of(names, Number(event.currentTarget.value), noun))}
      >
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
