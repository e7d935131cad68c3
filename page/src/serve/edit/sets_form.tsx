// Form of joint sets, for a new scene and for a case.

import { ChoiceField, TextField } from '../fields';
import * as state from '../state';
import type { Path } from './case_text';
import { type Schema, schema_at, title_of, unit_in, words_on } from './schema';
import { type JointSet, new_set, SET_KEYS } from './sets';

/** Fields of a joint set with the path of each in a schema. */
const FIELDS = (Object.entries(SET_KEYS) as [keyof typeof SET_KEYS, string][]).map(
  ([own, key]): [keyof JointSet, Path] => [own, ['sets', 0, key]],
);
/** Fields of the joint material of a set, in the schema of a case. */
const STRENGTH: [keyof JointSet, Path][] = [
  ['friction', ['analysis', 'joint_materials', 0, 'friction_angle_deg']],
  ['cohesion', ['analysis', 'joint_materials', 0, 'cohesion']],
];

/** Label and explanation of a key of a schema. Forces and stresses are typed with their unit, so the label has none. */
export function words_at(schema: Schema | null, path: Path, length: string): { label: string; title: string } {
  const own = schema ? schema_at(schema, path) : undefined;
  const title = title_of(String(path.at(-1)), own);
  if (!own) return { label: title, title: '' };
  const unit = unit_in(own, { L: length });
  return { label: unit ? `${title} [${unit}]` : title, title: words_on(own) };
}

export function SetsForm({
  sets,
  set_sets,
  seed,
  set_seed,
  length,
  has_strength,
  names,
}: {
  sets: JointSet[];
  set_sets: (sets: JointSet[]) => void;
  seed: string;
  set_seed: (seed: string) => void;
  /** Unit of length. */
  length: string;
  has_strength: boolean;
  /** Joint materials to choose from; without them the sets name their own. */
  names?: string[];
}) {
  const put = (i: number, key: keyof JointSet, value: string) =>
    set_sets(sets.map((own, j) => (j === i ? { ...own, [key]: value } : own)));
  const seed_words = words_at(state.joint_schema.value, ['seed'], length);
  return (
    <>
      {sets.map((set, i) => (
        <fieldset class="set" key={i}>
          <legend>Joint set {i + 1}</legend>
          {names ? (
            <ChoiceField label="Joint material" value={set.name} set={own => put(i, 'name', own)} choices={names} />
          ) : (
            <TextField label="Name" value={set.name} set={own => put(i, 'name', own)} />
          )}
          <div class="pairs">
            {[...FIELDS, ...(has_strength ? STRENGTH : [])].map(([key, path]) => (
              <TextField
                key={key}
                is_small
                {...words_at(path[0] === 'sets' ? state.joint_schema.value : state.schema.value, path, length)}
                is_number={key !== 'cohesion'}
                value={set[key]}
                placeholder={key === 'trace' ? 'through' : key === 'gap' || key === 'cohesion' ? '0' : ''}
                set={own => put(i, key, own)}
              />
            ))}
          </div>
          <button
            type="button"
            class="small"
            aria-label={`Remove joint set ${i + 1}`}
            onClick={() => set_sets(sets.filter((_, j) => j !== i))}
          >
            Remove
          </button>
        </fieldset>
      ))}
      <div class="row wide">
        <button
          type="button"
          class="small"
          onClick={() => {
            const made = new_set(sets.length + 1);
            set_sets([
              ...sets,
              names?.length ? { ...made, name: names[Math.min(sets.length, names.length - 1)] } : made,
            ]);
          }}
        >
          Add a joint set
        </button>
        <span class="space" />
        <label class="edit-part" title={seed_words.title}>
          {seed_words.label}
          <input
            type="text"
            inputMode="numeric"
            size={5}
            value={seed}
            onInput={event => set_seed(event.currentTarget.value)}
          />
        </label>
        <button type="button" class="small" onClick={() => set_seed(String((Number(seed) || 0) + 1))}>
          Next
        </button>
      </div>
    </>
  );
}
