// Form of joint sets, for a new scene and for a case.

import { ChoiceField, TextField } from '../fields';
import { type JointSet, new_set } from './sets';

/** Name and unit of a field, and a sentence on it. */
const FIELDS: [keyof JointSet, string, string, string][] = [
  ['dip', 'Dip', '°', 'Angle from the x axis, counter-clockwise, 0 to 180'],
  ['dip_scatter', 'Scatter of the dip', '°', 'Standard deviation of the dip'],
  ['spacing', 'Spacing', 'L', 'Mean distance between joints of the set'],
  ['scatter', 'Scatter', '', 'Standard deviation over mean of spacing and trace, 0 to 1'],
  ['trace', 'Trace length', 'L', 'Mean length of a joint; empty: through the whole outline'],
  ['gap', 'Gap', 'L', 'Mean length of rock between two traces of a row'],
];
const STRENGTH: typeof FIELDS = [
  ['friction', 'Friction angle', '°', 'Friction angle of the joints'],
  ['cohesion', 'Cohesion', '', 'Cohesion with its unit, such as 20 kPa; empty: none'],
];

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
            {[...FIELDS, ...(has_strength ? STRENGTH : [])].map(([key, label, unit, title]) => (
              <TextField
                key={key}
                is_small
                label={`${label}${unit && ` [${unit === 'L' ? length || 'L' : unit}]`}`}
                title={title}
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
        <label class="edit-part" title="Another seed draws the joints at other places">
          Seed
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
