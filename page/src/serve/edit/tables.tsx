// Forms of a case beside its text: every section as tables and fields, with titles, units and limits of the schema.

import { ValueBox } from '../fields';
import * as state from '../state';
import { find, type Node, type Path, parse, plain, remove, set, type Value } from './case_text';
import { append } from './edits';
import type { Scene } from './scene';
import {
  by_group,
  limits_of,
  meaning_of,
  type Schema,
  type Section,
  schema_at,
  takes_unit,
  title_of,
  unit_in,
} from './schema';

/** Keys that a new row begins with. */
const FIRST: Record<string, (scene: Scene) => Value> = {
  joint_materials: scene => ({ name: `joint ${scene.joint_materials.length + 1}`, friction_angle_deg: 30 }),
  block_materials: scene => ({
    name: `rock ${scene.block_materials.length + 1}`,
    ...(scene.length ? { like: 'limestone' } : { density: 2600, youngs_modulus: 5e9, poissons_ratio: 0.25 }),
  }),
  stages: scene => ({ name: `stage ${scene.stages.length + 1}`, steps: 400, equilibrium: 0.001 }),
};

export function Tables({
  text,
  scene,
  schema,
  latest,
  change,
  is_old,
}: {
  text: string;
  scene: Scene;
  schema: Schema | null;
  latest: () => string;
  change: (text: string) => void;
  is_old: boolean;
}) {
  if (!schema) return <p class="note pad">Reading the schema…</p>;
  const sections = schema['x-sections'] ?? [];
  const edit = (next: (text: string) => string) => {
    if (!is_old) change(next(latest()));
  };
  return (
    <div class="tables">
      {is_old && <p class="note bad">The text has a fault: correct it before you change the tables.</p>}
      {sections.map(({ title, row, path }) => {
        const key = String(path.at(-1));
        const own = schema_at(schema, path);
        const node = find(scene.root, path);
        if (!own) return null;
        return (
          <section key={key} aria-labelledby={`table-${key}`}>
            <h2 id={`table-${key}`}>{title}</h2>
            {own.type === 'array' ? (
              <Rows
                title={title}
                noun={row}
                path={path}
                node={node}
                schema={own}
                edit={edit}
                text={text}
                sections={sections}
                first={FIRST[key]?.(scene) ?? {}}
              />
            ) : (
              <Fields path={path} node={node} schema={own} edit={edit} text={text} sections={sections} />
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
  /** Changes the text as it is by then: another field may have changed it since it was drawn. */
  edit: (next: (text: string) => string) => void;
  /** Sections of the form: what they hold is left out elsewhere. */
  sections: Section[];
}

/** Kinds of values that one box can hold. */
function is_simple(own: Schema): boolean {
  const types = Array.isArray(own.type) ? own.type : [own.type];
  return !types.includes('object') && !types.includes('array');
}

/** Keys of an object as fields; those that it lacks can be added. */
function Fields({ path, node, schema, text, edit, sections }: Part) {
  // Objects without keys of their own, such as settings, hold values of any name.
  const of = (name: string): Schema | undefined =>
    (schema.properties ? schema.properties[name] : {}) ?? others_of(schema);
  const given = (node?.keys ?? []).filter(
    (key, i, all) => of(key.name) && all.findIndex(one => one.name === key.name) === i,
  );
  const simple = given.filter(key => is_simple(of(key.name)!));
  const nested = given.filter(
    key => !is_simple(of(key.name)!) && !sections.some(own => same(own.path, [...path, key.name])),
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
              sections={sections}
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
              {title_of(key.name, own)} {is_rows && <span class="note">{size === 1 ? '1 row' : `${size} rows`}</span>}
            </summary>
            <p class="note">{meaning_of(own)}</p>
            {is_rows ? (
              <Rows
                title={title_of(key.name, own)}
                noun={noun_of(title_of(key.name, own))}
                path={[...path, key.name]}
                node={below}
                schema={own}
                text={text}
                edit={edit}
                sections={sections}
                first={{}}
              />
            ) : (
              <Fields
                path={[...path, key.name]}
                node={below}
                schema={own}
                text={text}
                edit={edit}
                sections={sections}
              />
            )}
          </details>
        );
      })}
      <AddKey path={path} node={node} schema={schema} text={text} edit={edit} sections={sections} />
    </>
  );
}

/** Noun for one row of a list. */
const noun_of = (title: string) => title.toLowerCase().replace(/ies$/, 'y').replace(/s$/, '');

/** Schema of keys that the schema does not name. */
const others_of = (schema: Schema): Schema | undefined =>
  typeof schema.additionalProperties === 'object' ? schema.additionalProperties : undefined;

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

function AddKey({ path, node, schema, edit, sections }: Part) {
  const lacking = Object.entries(schema.properties ?? {}).filter(
    ([key]) => !node?.keys.some(one => one.name === key) && !sections.some(own => same(own.path, [...path, key])),
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
          if (own) edit(text => set(text, [...path, key], start_of(own)));
        }}
      >
        <option value="">choose a value…</option>
        {by_group(lacking.map(([key, own]) => ({ key, own }))).map(([group, keys]) => (
          <optgroup label={group} key={group}>
            {keys.map(({ key, own }) => (
              <option value={key} key={key} title={meaning_of(own)}>
                {title_of(key, own)}
              </option>
            ))}
          </optgroup>
        ))}
      </select>
    </label>
  );
}

/** One value with its title, unit and meaning. */
function Field({ name, path, node, schema, text, edit, sections }: Part & { name: string }) {
  const unit = unit_in(schema, state.units.value);
  const limits = limits_of(schema);
  const id = path.join('-');
  return (
    <div class="one">
      <label for={id}>
        {title_of(name, schema)} {unit && <span class="note">[{unit}]</span>}
      </label>
      <Box id={id} path={path} node={node} schema={schema} text={text} edit={edit} sections={sections} label="" />
      <button
        type="button"
        class="small"
        aria-label={`Remove ${title_of(name, schema)}`}
        title="Remove: the default counts"
        onClick={() => edit(text => remove(text, path))}
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

/** Box for the value at a path of the text. */
function Box({ id, label, path, node, schema, edit }: Part & { id?: string; label: string }) {
  return (
    <ValueBox
      id={id}
      label={label}
      own={schema}
      value={plain(node)}
      put={own => edit(text => set(text, path, own))}
      clear={() => {
        // Places of a row stay.
        if (typeof path.at(-1) === 'string') edit(text => remove(text, path));
      }}
    />
  );
}

function Unit({ own }: { own: Schema }) {
  const unit = unit_in(own, state.units.value);
  return unit ? <span class="note">[{unit}]</span> : null;
}

const MOST_ROWS = 60;

/** A list: objects by their keys, rows by their columns, others as text. */
function Rows({
  title,
  noun,
  path,
  node,
  schema,
  text,
  edit,
  sections,
  first,
}: Part & { title: string; noun: string; first: Value }) {
  const item = typeof schema.items === 'object' ? schema.items : undefined;
  const rows = node?.items ?? [];
  const add = (value: Value) =>
    edit(text => (find(parse(text), path) ? append(text, path, value) : set(text, path, [value])));
  if (!item) return null;
  const is_rows = !!item.prefixItems;
  const keys = is_rows
    ? []
    : Object.keys(item.properties ?? {}).filter(
        key => is_simple(item.properties![key]) && rows.some(row => row.keys.some(one => one.name === key)),
      );
  const columns: [string, Schema, (i: number) => Path][] = is_rows
    ? item.prefixItems!.map((own, c) => [own['x-key'] ?? String(c + 1), own, i => [...path, i, c]])
    : keys.map(key => [key, item.properties![key], i => [...path, i, key]]);
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
                    {title_of(key, own)} <Unit own={own} />
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
                          sections={sections}
                          label={`${title_of(key, own)} of ${noun} ${i + 1}`}
                        />
                      )}
                    </td>
                  ))}
                  <td>
                    <button
                      type="button"
                      class="small"
                      aria-label={`Remove ${noun} ${i + 1}`}
                      onClick={() => edit(text => remove(text, [...path, i]))}
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
              {String(find(row, ['name'])?.value ?? `${title_of(noun, undefined)} ${i + 1}`)}{' '}
              <span class="note">all values</span>
            </summary>
            <Fields path={[...path, i]} node={row} schema={item} text={text} edit={edit} sections={sections} />
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
