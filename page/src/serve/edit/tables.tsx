// Forms of a case beside its text: every section as tables and fields, with titles, units and limits of the schema.

import { useState } from 'preact/hooks';
import { append } from './edits';
import { find, type Node, type Path, parse, plain, remove, set, type Value } from './json_text';
import { type Scene, value_of } from './scene';
import {
  dimension_of,
  fault_in,
  limits_of,
  meaning_of,
  type Schema,
  schema_at,
  takes_unit,
  title_of_key,
  type Units,
  unit_in,
} from './schema';

/** Sections in the order of work; those of results are left out. */
const SECTIONS: [string, string, Path][] = [
  ['joints', 'Joint materials', ['analysis', 'joint_materials']],
  ['rocks', 'Block materials', ['analysis', 'block_materials']],
  ['analysis', 'Analysis', ['analysis']],
  ['run', 'Run', ['run']],
  ['units', 'Units', ['units']],
  ['stages', 'Stages', ['stages']],
  ['bolts', 'Bolt properties', ['analysis', 'bolt_properties']],
  ['covers', 'NMM bodies', ['covers']],
  ['outputs', 'Outputs', ['outputs']],
];

/** Keys that a new row begins with. */
const FIRST: Record<string, (scene: Scene) => Value> = {
  joints: scene => ({ name: `joint ${scene.joint_materials.length + 1}`, friction_angle_deg: 30 }),
  rocks: scene => ({
    name: `rock ${scene.block_materials.length + 1}`,
    ...(scene.length ? { like: 'limestone' } : { density: 2600, youngs_modulus: 5e9, poissons_ratio: 0.25 }),
  }),
  stages: scene => ({ name: `stage ${scene.stages.length + 1}`, steps: 400, equilibrium: 0.001 }),
};

export function Tables({
  text,
  scene,
  schema,
  change,
  is_old,
}: {
  text: string;
  scene: Scene;
  schema: Schema | null;
  change: (text: string) => void;
  is_old: boolean;
}) {
  if (!schema) return <p class="note pad">Reading the schema…</p>;
  const edit = (next: () => string) => {
    if (!is_old) change(next());
  };
  return (
    <div class="tables">
      {is_old && <p class="note bad">The text has a fault: correct it before you change the tables.</p>}
      {SECTIONS.map(([key, title, path]) => {
        const own = schema_at(schema, path);
        const node = find(scene.root, path);
        if (!own) return null;
        return (
          <section key={key} aria-labelledby={`table-${key}`}>
            <h2 id={`table-${key}`}>{title}</h2>
            {own.type === 'array' ? (
              <Rows
                title={title}
                path={path}
                node={node}
                schema={own}
                edit={edit}
                text={text}
                first={FIRST[key]?.(scene) ?? {}}
              />
            ) : (
              <Fields path={path} node={node} schema={own} edit={edit} text={text} />
            )}
          </section>
        );
      })}
    </div>
  );
}

interface Part {
  path: Path;
  node: Node | undefined;
  schema: Schema;
  text: string;
  edit: (next: () => string) => void;
}

/** Kinds of values that one box can hold. */
function is_simple(own: Schema): boolean {
  const types = Array.isArray(own.type) ? own.type : [own.type];
  return !types.includes('object') && !types.includes('array');
}

/** Keys of an object as fields; those that it lacks can be added. */
function Fields({ path, node, schema, text, edit }: Part) {
  // Objects without keys of their own, such as settings, hold values of any name.
  const of = (name: string): Schema | undefined => (schema.properties ? schema.properties[name] : {});
  const given = (node?.keys ?? []).filter(
    (key, i, all) => of(key.name) && all.findIndex(one => one.name === key.name) === i,
  );
  const simple = given.filter(key => is_simple(of(key.name)!));
  const nested = given.filter(
    key => !is_simple(of(key.name)!) && !SECTIONS.some(([, , own]) => same(own, [...path, key.name])),
  );
  return (
    <>
      {simple.length > 0 && (
        <div class="fields">
          {simple.map(key => (
            <Field
              key={key.name}
              name={key.name}
              path={[...path, key.name]}
              node={find(node, [key.name])}
              schema={of(key.name)!}
              text={text}
              edit={edit}
            />
          ))}
        </div>
      )}
      {nested.map(key => {
        const own = of(key.name)!;
        const below = find(node, [key.name]);
        const size = below?.items.length ?? 0;
        const is_rows = own.type === 'array';
        return (
          <details key={key.name}>
            <summary>
              {title_of_key(key.name)} {is_rows && <span class="note">{size === 1 ? '1 row' : `${size} rows`}</span>}
            </summary>
            <p class="note">{meaning_of(own)}</p>
            {is_rows ? (
              <Rows
                title={title_of_key(key.name)}
                path={[...path, key.name]}
                node={below}
                schema={own}
                text={text}
                edit={edit}
                first={{}}
              />
            ) : (
              <Fields path={[...path, key.name]} node={below} schema={own} text={text} edit={edit} />
            )}
          </details>
        );
      })}
      <AddKey path={path} node={node} schema={schema} text={text} edit={edit} />
    </>
  );
}

const same = (a: Path, b: Path) => a.length === b.length && a.every((step, i) => step === b[i]);

/** Begin of a value that is added. */
function start_of(own: Schema): Value {
  const type = Array.isArray(own.type) ? own.type[0] : own.type;
  if (own.default !== undefined) return own.default as Value;
  if (own.enum?.length) return own.enum[0] as Value;
  if (type === 'object') return {};
  if (type === 'array') return (own.prefixItems ?? []).map(() => 0);
  if (type === 'boolean') return true;
  if (type === 'string') return (own.examples?.[0] as string) ?? '';
  return (takes_unit(own) && (own.examples?.[0] as Value)) || 1;
}

function AddKey({ path, node, schema, text, edit }: Part) {
  const lacking = Object.entries(schema.properties ?? {}).filter(
    ([key]) => !node?.keys.some(one => one.name === key) && !SECTIONS.some(([, , own]) => same(own, [...path, key])),
  );
  if (!lacking.length) return null;
  return (
    <label class="edit-part add">
      Add
      <select
        aria-label={`Add a value to ${path.join(' ').replace(/_/g, ' ')}`}
        value=""
        onChange={event => {
          const key = event.currentTarget.value;
          event.currentTarget.value = '';
          const own = schema.properties?.[key];
          if (own) edit(() => set(text, [...path, key], start_of(own)));
        }}
      >
        <option value="">choose a value…</option>
        {lacking.map(([key, own]) => (
          <option value={key} key={key} title={meaning_of(own)}>
            {title_of_key(key)}
          </option>
        ))}
      </select>
    </label>
  );
}

/** One value with its title, unit and meaning. */
function Field({ name, path, node, schema, text, edit }: Part & { name: string }) {
  const unit = unit_in(dimension_of(schema), units_of(text));
  const limits = limits_of(schema);
  const id = path.join('-');
  return (
    <div class="one">
      <label for={id}>
        {title_of_key(name)} {unit && <span class="note">[{unit}]</span>}
      </label>
      <Box id={id} path={path} node={node} schema={schema} text={text} edit={edit} label="" />
      <button
        type="button"
        class="small"
        aria-label={`Remove ${title_of_key(name)}`}
        title="Remove: the default counts"
        onClick={() => edit(() => remove(text, path))}
      >
        ×
      </button>
      <p class="note">
        {meaning_of(schema)}
        {limits && ` Permitted: ${limits}.`}
        {schema.default !== undefined && ` Default: ${String(schema.default)}.`}
      </p>
    </div>
  );
}

/** Box for a value: choices for words, a tick for true and false, text for all else. */
function Box({ id, label, path, node, schema, text, edit }: Part & { id?: string; label: string }) {
  const [fault, set_fault] = useState('');
  const value = plain(node);
  const types = Array.isArray(schema.type) ? schema.type : [schema.type];
  const put = (own: Value) => edit(() => set(text, path, own));
  const name = label || undefined;
  if (schema.enum)
    return (
      <select
        id={id}
        aria-label={name}
        value={value === undefined ? '' : String(value)}
        onChange={event => {
          const own = schema.enum!.find(one => String(one) === event.currentTarget.value);
          if (own === undefined) edit(() => remove(text, path));
          else put(own as Value);
        }}
      >
        {value === undefined && <option value="" />}
        {value !== undefined && !schema.enum.includes(value) && <option value={String(value)}>{String(value)}</option>}
        {schema.enum.map(own => (
          <option value={String(own)} key={String(own)}>
            {String(own).replace(/_/g, ' ')}
          </option>
        ))}
      </select>
    );
  if (types.includes('boolean'))
    return (
      <input
        id={id}
        aria-label={name}
        type="checkbox"
        checked={value === true}
        onChange={event => put(event.currentTarget.checked)}
      />
    );
  return (
    <>
      <input
        id={id}
        aria-label={name}
        type="text"
        value={value === undefined ? '' : typeof value === 'object' ? '' : String(value)}
        placeholder={schema.default === undefined ? '' : String(schema.default)}
        title={[meaning_of(schema), limits_of(schema) && `Permitted: ${limits_of(schema)}.`].filter(Boolean).join(' ')}
        aria-invalid={fault !== ''}
        onChange={event => {
          const typed = event.currentTarget.value.trim();
          if (!typed) {
            set_fault('');
            if (typeof path.at(-1) === 'string' && value !== undefined) edit(() => remove(text, path));
            return;
          }
          const own = types.length === 1 && types[0] === 'string' ? typed : value_of(typed);
          const wrong = fault_in(schema, own);
          set_fault(wrong);
          if (!wrong && own !== value) put(own);
        }}
      />
      {fault && <span class="fault">Expected: {fault}.</span>}
    </>
  );
}

let units_read = { text: '', units: {} as Units };

/** Units that the case declares; read once per text. */
function units_of(text: string): Units {
  if (units_read.text !== text) {
    let units: Units = {};
    try {
      units = (plain(find(parse(text), ['units'])) ?? {}) as Units;
    } catch {
      // A text with a fault has no units for now.
    }
    units_read = { text, units };
  }
  return units_read.units;
}

function Unit({ own, units }: { own: Schema; units: Units }) {
  const unit = unit_in(dimension_of(own), units);
  return unit ? <span class="note">[{unit}]</span> : null;
}

const MOST_ROWS = 60;

/** A list: objects by their keys, rows by their columns, others as text. */
function Rows({ title, path, node, schema, text, edit, first }: Part & { title: string; first: Value }) {
  const item = typeof schema.items === 'object' ? schema.items : undefined;
  const rows = node?.items ?? [];
  const add = (value: Value) =>
    edit(() => (find(parse(text), path) ? append(text, path, value) : set(text, path, [value])));
  if (!item) return null;
  const is_rows = !!item.prefixItems;
  const keys = is_rows
    ? []
    : Object.keys(item.properties ?? {}).filter(
        key => is_simple(item.properties![key]) && rows.some(row => row.keys.some(one => one.name === key)),
      );
  const columns: [string, Schema, (i: number) => Path][] = is_rows
    ? item.prefixItems!.map((own, c) => [own.title ?? String(c + 1), own, i => [...path, i, c]])
    : keys.map(key => [key, item.properties![key], i => [...path, i, key]]);
  const units = units_of(text);
  const noun = title.toLowerCase().replace(/ies$/, 'y').replace(/s$/, '');
  return (
    <>
      {rows.length > 0 && columns.length > 0 && (
        <div class="scrolls" tabIndex={0} role="group" aria-label={`Table of ${title.toLowerCase()}`}>
          <table class="list">
            <thead>
              <tr>
                <th scope="col">#</th>
                {columns.map(([key, own]) => (
                  <th scope="col" key={key} title={meaning_of(own)}>
                    {title_of_key(key)} <Unit own={own} units={units} />
                  </th>
                ))}
                <th scope="col">
                  <span class="hidden">Remove</span>
                </th>
              </tr>
            </thead>
            <tbody>
              {rows.slice(0, MOST_ROWS).map((row, i) => (
                <tr key={i}>
                  <th scope="row">{i + 1}</th>
                  {columns.map(([key, own, at], c) => (
                    <td key={key}>
                      {is_rows && row.items[c] === undefined ? null : (
                        <Box
                          path={at(i)}
                          node={find(row, [is_rows ? c : key])}
                          schema={own}
                          text={text}
                          edit={edit}
                          label={`${title_of_key(key)} of ${noun} ${i + 1}`}
                        />
                      )}
                    </td>
                  ))}
                  <td>
                    <button
                      type="button"
                      class="small"
                      aria-label={`Remove ${noun} ${i + 1}`}
                      onClick={() => edit(() => remove(text, [...path, i]))}
                    >
                      ×
                    </button>
                  </td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
      {rows.length > MOST_ROWS && <p class="note">{rows.length - MOST_ROWS} more rows stand in the text.</p>}
      {!is_rows &&
        rows.slice(0, MOST_ROWS).map((row, i) => (
          <details key={i}>
            <summary>
              {String(find(row, ['name'])?.value ?? `${title_of_key(noun.replace(/ /g, '_'))} ${i + 1}`)}{' '}
              <span class="note">all values</span>
            </summary>
            <Fields path={[...path, i]} node={row} schema={item} text={text} edit={edit} />
          </details>
        ))}
      <div class="row wide">
        <button
          type="button"
          class="small"
          onClick={() => add(is_rows ? item.prefixItems!.slice(0, 20).map(start_of) : first)}
        >
          Add a {noun}
        </button>
      </div>
    </>
  );
}
