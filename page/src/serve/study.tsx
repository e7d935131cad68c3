// Studies of a case: sweeps of a parameter, element tests of a material, fits of a measured curve.

import { useEffect, useMemo, useState } from 'preact/hooks';
import { show } from '../draw/numbers';
import * as api from './api';
import { leaf_of, new_result, stem_of } from './cases';
import { ChoiceField, TextField } from './fields';
import { pointers_in } from './pointers';
import { JobItem, words_of } from './runs';
import * as state from './state';
import { number_in, numbers_in, parameter_rows, type TestRecord, value_rows } from './tested';
import { is_failure } from './verdicts';

export function StudyView({ study, paths }: { study: string; paths: string[] }) {
  if (study === 'sweep') return <SweepForm paths={paths} />;
  if (study === 'element') return <ElementForm paths={paths} />;
  if (study === 'fit') return <FitForm path={paths[0]} />;
  return <p class="note pad">There is no study of this name.</p>;
}

function CaseHead({ paths, title }: { paths: string[]; title: string }) {
  return (
    <div class="bar">
      <h2>
        {title}: <a href={state.link('case', ...paths)}>{leaf_of(paths[0])}</a>
      </h2>
    </div>
  );
}

const OUTPUTS = ['displacement', 'fos', 'speed', 'state', 'steps', 'time'];

function SweepForm({ paths }: { paths: string[] }) {
  const [text, set_text] = useState('');
  const [keys, set_keys] = useState<[string, string][]>([['', '']]);
  const [out, set_out] = useState('displacement');
  const [histories, set_histories] = useState('');
  const [result, set_result] = useState('');
  useEffect(() => {
    void state.attempt(() => api.read(paths[0])).then(file => set_text(file?.text ?? ''));
  }, [paths.join('\n')]);
  const pointers = useMemo(() => pointers_in(text), [text]);
  const now = new Map(pointers);
  const taken = (state.listing.value?.results ?? [])
    .map(own => own.path)
    .concat(state.jobs.value.map(own => own.result));
  const suggestion = new_result(`${stem_of(paths[0])}_sweep`, taken);
  const over = keys.filter(([key, values]) => key && values).map(([key, values]) => `${key}=${values}`);
  const start = async () => {
    const body: Record<string, unknown> = { over, out: words_of(out.replaceAll(',', ' ')) };
    if (words_of(histories).length) body.histories = words_of(histories);
    const started = await state.attempt(() => api.sweep(paths, result || suggestion, body));
    if (started) await state.refresh_jobs();
  };
  const own_jobs = state.jobs.value.filter(job => job.kind === 'sweep' && job.title === paths[0]);
  return (
    <div class="study">
      <CaseHead paths={paths} title="Sweep a parameter" />
      <div class="group">
        {keys.map(([key, values], i) => (
          <div class="setting" key={i}>
            <input
              type="text"
              list="pointers"
              aria-label="Parameter"
              placeholder="parameter"
              value={key}
              onInput={event => {
                const own = event.currentTarget.value;
                set_keys(keys.map((old, j) => (j === i ? [own, old[1]] : old)));
              }}
            />
            <input
              type="text"
              aria-label={`Values of ${key || 'the parameter'}`}
              placeholder={now.has(key) ? `now ${now.get(key)}; 20:40:5 or 20,30` : '20:40:5 or 20,30'}
              value={values}
              onInput={event => {
                const own = event.currentTarget.value;
                set_keys(keys.map((old, j) => (j === i ? [old[0], own] : old)));
              }}
            />
            <button
              type="button"
              class="small"
              aria-label="Remove the parameter"
              disabled={keys.length === 1}
              onClick={() => set_keys(keys.filter((_, j) => j !== i))}
            >
              ×
            </button>
          </div>
        ))}
        <datalist id="pointers">
          {pointers.map(([path, value]) => (
            <option value={path} label={String(value)} key={path} />
          ))}
        </datalist>
        <button type="button" class="small" onClick={() => set_keys([...keys, ['', '']])}>
          Add a parameter
        </button>
        <TextField label="Results" value={out} set={set_out} placeholder="displacement fos crest.dx" list="outputs" />
        <datalist id="outputs">
          {OUTPUTS.map(own => (
            <option value={own} key={own} />
          ))}
        </datalist>
        <TextField label="Histories" value={histories} set={set_histories} placeholder="crest=point:12,20" />
        <TextField label="Result folder" value={result} set={set_result} placeholder={suggestion} />
        <p class="note">
          20:40:5 is a range with both ends; 20,30 is a list. Several parameters give all combinations. A parameter is a
          value of the case file or a setting, such as time_step.
        </p>
        <button type="button" class="small strong" disabled={!over.length} onClick={start}>
          Start the sweep
        </button>
        {own_jobs.length > 0 && (
          <ul class="jobs">
            {own_jobs
              .slice(-5)
              .reverse()
              .map(job => (
                <JobItem job={job} key={job.id} />
              ))}
          </ul>
        )}
      </div>
    </div>
  );
}

/** Rows of a table (CSV), the first one with the headings. */
export function rows_of(text: string): string[][] {
  const cell = /("(?:[^"]|"")*"|[^,]*)(,|$)/y;
  return text
    .split(/\r?\n/)
    .filter(Boolean)
    .map(line => {
      const cells: string[] = [];
      cell.lastIndex = 0;
      for (let found = cell.exec(line); found; found = found[2] ? cell.exec(line) : null)
        cells.push(found[1].startsWith('"') ? found[1].slice(1, -1).replace(/""/g, '"') : found[1]);
      return cells;
    });
}

/** Columns of the table of a sweep that the window shows: its index, its heading, and whether it holds numbers. */
export function columns_of(table: string[][], described: string[][]): [number, string, boolean][] {
  const [head = [], ...body] = table;
  return head.flatMap((name, i): [number, string, boolean][] => {
    const cells = body.map(row => row[i] ?? '').filter(Boolean);
    // The folder of each run is for programs; a column may be empty.
    if (name === 'job' || !cells.length) return [];
    const [, unit, meaning] = described.find(own => own[0] === name) ?? [];
    const words = meaning || name.replace(/^.*\//, '').replace(/_/g, ' ');
    return [[i, unit ? `${words} [${unit}]` : words, cells.every(own => Number.isFinite(Number(own)))]];
  });
}

export function SweepView({ path, is_finished }: { path: string; is_finished: boolean }) {
  const [[rows, described], set_tables] = useState<[string[][], string[][]]>([[], []]);
  const job = state.jobs.value.find(own => own.result === path && own.state === 'runs');
  useEffect(() => {
    if (!is_finished) return;
    const read = (name: string) => api.read(`${path}/${name}`).then(file => rows_of(file.text ?? ''));
    // Sweeps of earlier versions describe no columns.
    const both = async () => set_tables([await read('table.csv'), await read('columns.csv').catch(() => [])]);
    void state.attempt(both);
  }, [path, is_finished, job?.id]);
  const columns = columns_of(rows, described);
  const body = rows.slice(1);
  return (
    <div class="strength">
      <h2>{path}</h2>
      {!is_finished && <p class="note">{job ? 'The sweep runs.' : 'The sweep was stopped before its end.'}</p>}
      {is_finished && (
        <img
          class="picture"
          alt={`Results of the sweep ${path}`}
          src={api.address('/api/picture', { result: path, name: 'sweep.svg' })}
          onError={event => {
            event.currentTarget.hidden = true;
          }}
        />
      )}
      {columns.length > 0 && (
        <div class="scroll">
          <table class="list sweep">
            <caption>{body.length === 1 ? '1 run' : `${body.length} runs`}</caption>
            <thead>
              <tr>
                {columns.map(([i, heading, is_number]) => (
                  <th scope="col" class={is_number ? 'number' : undefined} key={i}>
                    {heading}
                  </th>
                ))}
              </tr>
            </thead>
            <tbody>
              {body.map((row, at) => (
                <tr key={at}>
                  {columns.map(([i, , is_number]) => (
                    <td class={is_number ? 'number' : undefined} key={i}>
                      {is_number && row[i] ? show(Number(row[i]), 5) : row[i]}
                    </td>
                  ))}
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
    </div>
  );
}

const PATHS: [string, string][] = [
  ['uniaxial', 'uniaxial: strain yy driven, sides free'],
  ['triaxial', 'triaxial: sides under a pressure'],
  ['biaxial', 'biaxial: one side under a pressure'],
  ['oedometer', 'oedometer: sides fixed'],
  ['shear', 'shear: shear strain driven'],
  ['cyclic', 'cyclic: triaxial between strains'],
];

function ElementForm({ paths }: { paths: string[] }) {
  // An analysis file holds the materials of an old case; it stands last.
  const path = paths.at(-1) ?? '';
  const [kind, set_kind] = useState('triaxial');
  const [to, set_to] = useState('-0.02');
  const [confining, set_confining] = useState('');
  const [material, set_material] = useState('');
  const [cycles, set_cycles] = useState('');
  const [tested, set_tested] = useState<api.Tested | null>(null);
  const [busy, set_busy] = useState(false);
  const has_pressure = ['triaxial', 'biaxial', 'cyclic'].includes(kind);
  const start = async () => {
    set_busy(true);
    const body = () => ({
      path,
      kind,
      to: numbers_in('To strains', to),
      confining: has_pressure ? number_in('Pressure', confining) : undefined,
      cycles: kind === 'cyclic' ? number_in('Cycles', cycles, true) : undefined,
      material: number_in('Material', material, true),
    });
    set_tested(await state.attempt(() => api.element(body())));
    set_busy(false);
  };
  return (
    <div class="study">
      <CaseHead paths={paths} title="Element test" />
      <div class="group">
        <ChoiceField label="Path" value={kind} set={set_kind} choices={PATHS} />
        <TextField label="To strains" value={to} set={set_to} placeholder="-0.01 -0.02" />
        {has_pressure && (
          <TextField
            label="Pressure"
            value={confining}
            set={set_confining}
            placeholder="0, in the unit of stress of the case"
          />
        )}
        {kind === 'cyclic' && <TextField label="Cycles" value={cycles} set={set_cycles} placeholder="1" />}
        <TextField label="Material" value={material} set={set_material} placeholder="1, its number" />
        <button type="button" class="small strong" disabled={busy} onClick={start}>
          {busy ? 'Testing…' : 'Test the material'}
        </button>
      </div>
      <TestedView tested={tested} name={`element test of ${leaf_of(path)}`} />
    </div>
  );
}

const FITS: [string, string][] = [
  ['curve', 'stress over strain of a uniaxial test'],
  ['triaxial', 'stresses at failure of triaxial tests'],
  ['chevron_bend', 'toughness: bent core with a chevron notch'],
  ['notched_disc', 'toughness: disc with a chevron notch'],
  ['semicircular_bend', 'toughness: bent half disc'],
];

function FitForm({ path }: { path: string }) {
  const [kind, set_kind] = useState('curve');
  const [friction, set_friction] = useState('');
  const [tested, set_tested] = useState<api.Tested | null>(null);
  const [busy, set_busy] = useState(false);
  const start = async () => {
    set_busy(true);
    const body = () => ({
      path,
      kind,
      friction: kind === 'curve' ? number_in('Friction angle', friction) : undefined,
    });
    set_tested(await state.attempt(() => api.fit(body())));
    set_busy(false);
  };
  return (
    <div class="study">
      <div class="bar">
        <h2>Fit parameters: {leaf_of(path)}</h2>
      </div>
      <div class="group">
        <ChoiceField label="Table holds" value={kind} set={set_kind} choices={FITS} />
        {kind === 'curve' && (
          <TextField
            label="Friction angle"
            value={friction}
            set={set_friction}
            placeholder="from other tests, degrees"
          />
        )}
        <button type="button" class="small strong" disabled={busy} onClick={start}>
          {busy ? 'Fitting…' : 'Fit'}
        </button>
      </div>
      <TestedView tested={tested} name={`fit of ${leaf_of(path)}`} />
    </div>
  );
}

function TestedView({ tested, name }: { tested: api.Tested | null; name: string }) {
  if (!tested) return null;
  const is_bad = is_failure(tested.exit_code);
  return (
    <div class="tested" aria-live="polite">
      {tested.errors.map(own => (
        <p class="trouble" key={own.sentence}>
          {own.sentence}
        </p>
      ))}
      {is_bad && !tested.errors.length && <pre class="messages">{tested.messages}</pre>}
      {tested.svg && (
        <img class="picture" alt={`Curves: ${name}`} src={`data:image/svg+xml,${encodeURIComponent(tested.svg)}`} />
      )}
      {tested.table && (
        <a
          class="button"
          download={`${name.replace(/[^a-z0-9]+/gi, '_')}.csv`}
          href={`data:text/csv,${encodeURIComponent(tested.table)}`}
        >
          Save the curve (CSV)
        </a>
      )}
      {tested.record && <Values record={tested.record} />}
    </div>
  );
}

function Values({ record }: { record: TestRecord }) {
  const parameters = parameter_rows(record);
  return (
    <>
      {(record.warnings ?? []).map(own => (
        <p class="note" key={own.sentence}>
          {own.sentence}
        </p>
      ))}
      {parameters.length > 0 && (
        <div class="scroll">
          <table class="list">
            <caption>Parameters</caption>
            <thead>
              <tr>
                {['Parameter', 'Value', 'Standard error', '95 % from', 'to', 'Unit'].map((own, i) => (
                  <th scope="col" class={i > 0 && i < 5 ? 'number' : undefined} key={own}>
                    {own}
                  </th>
                ))}
              </tr>
            </thead>
            <tbody>
              {parameters.map(([title, ...cells]) => (
                <tr key={title}>
                  <th scope="row">{title}</th>
                  {cells.map((own, i) => (
                    <td class={i < 4 ? 'number' : undefined} key={i}>
                      {own}
                    </td>
                  ))}
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
      <table class="list">
        <caption>Values</caption>
        <tbody>
          {value_rows(record).map(([title, value]) => (
            <tr key={title}>
              <th scope="row">{title}</th>
              <td class="number">{value}</td>
            </tr>
          ))}
        </tbody>
      </table>
      {record.material && (
        <details>
          <summary>Keys of a block material</summary>
          <pre class="messages">{JSON.stringify(record.material, null, 2)}</pre>
        </details>
      )}
    </>
  );
}
