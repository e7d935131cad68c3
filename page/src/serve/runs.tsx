// Form that starts runs and searches for factors of safety, and the list of jobs.

import { signal } from '@preact/signals';
import { useEffect, useState } from 'preact/hooks';
import { show } from '../draw/numbers';
import * as api from './api';
import { last_messages, leaf_of, new_result, stem_of } from './cases';
import { limits_of, meaning_of, type Schema, schema_at, unit_in } from './edit/schema';
import { ChoiceField, TextField, ValueBox } from './fields';
import * as state from './state';
import { bracket_words, ending_words, factor_words, is_failure, type StrengthResult } from './verdicts';

/** Histories that a run records beside its case, and the criterion at which it stops. They stay while the window is open. */
const histories = signal('');
const stop_when = signal('');

const reduce = signal('joints');

export function RunForm({
  paths,
  report,
  profile,
  set_profile,
  settings,
  set_settings,
  checking,
  check,
  before,
}: {
  paths: string[];
  report: api.Report | null;
  /** Units that the case declares. */
  profile: string;
  set_profile: (profile: string) => void;
  settings: [string, string][];
  set_settings: (settings: [string, string][]) => void;
  checking: boolean;
  check: (trial: boolean) => Promise<void>;
  before: () => Promise<boolean>;
}) {
  const base = stem_of(paths[0]);
  const taken = (state.listing.value?.results ?? [])
    .map(own => own.path)
    .concat(state.jobs.value.map(own => own.result));
  const [result, set_result] = useState('');
  const suggestion = new_result(`${base}_run`, taken);
  const schema = state.schema.value;
  const known = report?.case?.settings ?? {};
  const cost = report?.case?.cost;
  const can_run = report !== null && report.exit_code === 0 && !report.case?.lacks;
  const start = async (kind: 'run' | 'fos' | 'both') => {
    if (!(await before())) return;
    const ending = kind === 'run' ? 'run' : kind;
    const name = result || new_result(`${base}_${ending}`, taken);
    const chosen = Object.fromEntries(settings.filter(([own, value]) => own && value));
    const recorded = words_of(histories.value);
    const more: Record<string, unknown> = kind === 'fos' ? { reduce: reduce.value } : {};
    if (kind !== 'fos' && recorded.length) more.histories = recorded;
    if (kind === 'run' && stop_when.value.trim()) more.stop_when = stop_when.value.trim();
    if (kind === 'both') more.both = true;
    const started = await state.attempt(() =>
      api.run(kind === 'fos' ? 'fos' : 'run', paths, name, kind === 'both' ? '' : profile, chosen, more),
    );
    if (!started) return;
    set_result('');
    await state.refresh_jobs();
  };
  return (
    <div class="group">
      <h2>Run</h2>
      <TextField label="Result folder" value={result} placeholder={suggestion} set={set_result} />
      <ChoiceField
        label="Profile"
        value={profile}
        set={set_profile}
        choices={[
          ['', `of the case${report?.case?.profile ? ` (${report.case.profile})` : ''}`],
          ...profiles_in(schema),
        ]}
      />
      {settings.map(([name, value], i) => (
        <Setting
          key={i}
          schema={schema}
          name={name}
          value={value}
          standard={name in known ? String(known[name]) : 'value'}
          set={own => set_settings(settings.map((old, j) => (j === i ? own : old)))}
          remove={() => set_settings(settings.filter((_, j) => j !== i))}
        />
      ))}
      <datalist id="settings">
        {names_of(schema, known).map(name => (
          <option value={name} key={name}>
            {setting_in(schema, name)?.title}
          </option>
        ))}
      </datalist>
      <div class="row wide">
        <button type="button" class="small" onClick={() => set_settings([...settings, ['', '']])}>
          Add a setting
        </button>
        <button type="button" class="small" disabled={checking} onClick={() => check(false)}>
          Check
        </button>
        <button type="button" class="small" disabled={checking || !can_run} onClick={() => check(true)}>
          Estimate the time
        </button>
      </div>
      {cost?.seconds_in_all !== undefined && (
        <p class="note">The run takes about {duration(cost.seconds_in_all)} on this machine.</p>
      )}
      <details class="more">
        <summary>Record and stop</summary>
        <TextField
          label="Histories"
          value={histories.value}
          placeholder="crest=point:12,20 block:7"
          set={own => {
            histories.value = own;
          }}
        />
        <TextField
          label="Stop when"
          value={stop_when.value}
          placeholder="crest.d>0.05"
          set={own => {
            stop_when.value = own;
          }}
        />
        <p class="note">
          A history follows a point, block, contact, joint, line or bolt. A run stops behind the step in which a
          quantity of a history passes the limit: d, dx, dy, vx, vy.
        </p>
      </details>
      <div class="row wide">
        <button type="button" class="small strong" disabled={!can_run} onClick={() => start('run')}>
          Run
        </button>
        <button type="button" class="small" disabled={!can_run} onClick={() => start('both')}>
          Both profiles
        </button>
      </div>
      <div class="row wide">
        <select
          aria-label="Strength to reduce"
          value={reduce.value}
          onChange={event => {
            reduce.value = event.currentTarget.value;
          }}
        >
          <option value="joints">joints</option>
          <option value="rock">rock</option>
          <option value="both">joints and rock</option>
        </select>
        <button type="button" class="small" disabled={!can_run} onClick={() => start('fos')}>
          Factor of safety
        </button>
      </div>
      <p class="row wide">
        <a class="button" href={state.link('study', 'sweep', ...paths)}>
          Sweep a parameter…
        </a>
        <a class="button" href={state.link('study', 'element', ...paths)}>
          Element test…
        </a>
      </p>
      <CaseJobs paths={paths} />
    </div>
  );
}

const setting_in = (schema: Schema | null, name: string): Schema | undefined => {
  const all = schema ? schema_at(schema, ['run', 'set']) : undefined;
  // A setting of one material has its number behind it.
  return all?.properties?.[name] ?? all?.properties?.[name.replace(/\.\d+$/, '')];
};

/** Profiles that the schema names. */
const profiles_in = (schema: Schema | null): string[] =>
  ((schema ? schema_at(schema, ['run', 'profile'])?.examples : null) ?? ['standard', 'legacy']).map(String);

/** Names of all settings. */
function names_of(schema: Schema | null, known: Record<string, unknown>): string[] {
  const all = schema ? schema_at(schema, ['run', 'set'])?.properties : undefined;
  return Object.keys(all ?? known);
}

/** One setting of a run: its name, its value, and what the table of settings says of it. */
function Setting({
  schema,
  name,
  value,
  standard,
  set,
  remove,
}: {
  schema: Schema | null;
  name: string;
  value: string;
  /** Value if nothing is set. */
  standard: string;
  set: (setting: [string, string]) => void;
  remove: () => void;
}) {
  const own = setting_in(schema, name);
  const unit = own ? unit_in(own, state.units.value) : '';
  return (
    <div class="setting">
      <input
        type="text"
        list="settings"
        aria-label="Setting"
        placeholder="setting"
        value={name}
        onInput={event => set([event.currentTarget.value, value])}
      />
      <ValueBox
        // Another setting has another box.
        key={own ? name : ''}
        label={`Value of ${name || 'the setting'}`}
        own={own ?? {}}
        value={value || undefined}
        placeholder={standard}
        put={typed => set([name, String(typed)])}
        clear={() => set([name, ''])}
      />
      <button type="button" class="small" aria-label="Remove the setting" onClick={remove}>
        ×
      </button>
      {own && (
        <p class="note">
          {unit && `[${unit}] `}
          {meaning_of(own)}
          {!own.enum && limits_of(own) && ` Permitted: ${limits_of(own)}.`}
        </p>
      )}
    </div>
  );
}

/** Words between spaces. */
export function words_of(text: string): string[] {
  return text.split(/\s+/).filter(Boolean);
}

export function duration(seconds: number): string {
  if (seconds < 90) return `${show(Math.max(0.1, seconds), 2)} s`;
  if (seconds < 5400) return `${Math.round(seconds / 60)} min`;
  return `${show(seconds / 3600, 2)} h`;
}

/** Jobs that this case started, newest first. */
function CaseJobs({ paths }: { paths: string[] }) {
  const own = state.jobs.value.filter(job => job.title === paths[0]);
  if (!own.length) return null;
  return (
    <ul class="jobs">
      {own
        .slice()
        .reverse()
        .slice(0, 5)
        .map(job => (
          <JobItem job={job} key={job.id} />
        ))}
    </ul>
  );
}

const KINDS = {
  run: 'Run',
  resume: 'Run, continued',
  fos: 'Factor of safety',
  both: 'Both profiles',
  sweep: 'Sweep',
};

export function JobItem({ job }: { job: api.Job }) {
  const is_open = job.state === 'runs' || job.state === 'waits';
  const share = job.steps ? (job.step ?? 0) / job.steps : 0;
  const has_code = job.state === 'ended' && job.exit_code !== 0;
  const failed = has_code && is_failure(job.exit_code);
  const entry = state.listing.value?.results.find(own => own.path === job.result);
  const answer = useAnswer(job);
  const words =
    is_open && job.is_stopping
      ? 'stopping'
      : job.state === 'waits'
        ? 'waits'
        : job.state === 'runs'
          ? progress_of(job)
          : job.state === 'stopped'
            ? entry?.has_checkpoint
              ? 'paused'
              : 'stopped'
            : has_code
              ? ending_words(job.exit_code)
              : `finished in ${duration(job.seconds ?? 0)}`;
  return (
    <li class={`job ${failed ? 'bad' : ''}`}>
      <div class="bar">
        <b>{leaf_of(job.result)}</b>
        <span class="note">{KINDS[job.kind]}</span>
        <span class="space" />
        {is_open && (
          <button
            type="button"
            class="small"
            disabled={job.is_stopping}
            onClick={async () => {
              await state.attempt(() => api.stop(job.id));
              await state.refresh_jobs();
            }}
          >
            {job.kind === 'run' || job.kind === 'resume' ? 'Pause' : 'Stop'}
          </button>
        )}
        {!is_open && entry?.has_checkpoint && (
          <button
            type="button"
            class="small"
            onClick={async () => {
              await state.attempt(() => api.resume(job.result));
              await state.refresh_jobs();
            }}
          >
            Go on
          </button>
        )}
        {entry && (
          <a class="button" href={state.link('result', job.result)}>
            {is_open ? 'Watch' : 'Open'}
          </a>
        )}
        {job.kind === 'both' && job.state === 'ended' && <BothLink result={job.result} />}
      </div>
      {is_open && <progress value={share} max={1} aria-label={`Progress of ${job.result}`} />}
      <p class="note" aria-live="polite">
        {answer || words}
      </p>
      {has_code && job.messages && <pre class="messages">{last_messages(job.messages)}</pre>}
    </li>
  );
}

/** Link to the results of both profiles, or to the only one: `legacy` cannot run every case. */
function BothLink({ result }: { result: string }) {
  const results = state.listing.value?.results ?? [];
  const there = ['standard', 'legacy']
    .map(profile => `${result}/${profile}`)
    .filter(path => results.some(own => own.path === path));
  if (!there.length) return null;
  return (
    <a class="button" href={state.link(there.length > 1 ? 'compare' : 'result', ...there)}>
      {there.length > 1 ? 'Compare' : `Open ${leaf_of(there[0])}`}
    </a>
  );
}

/** Sentence on how far a job has come that runs. */
export function progress_of(job: api.Job): string {
  const tried = [
    job.stands !== undefined && `stable at ${show(job.stands, 4)}`,
    job.falls !== undefined && `unstable at ${show(job.falls, 4)}`,
  ].filter(Boolean);
  const steps = job.steps ? `step ${job.step} of ${job.steps}` : tried.join(', ') || 'starting';
  return `${steps}${job.left ? `, ${job.left} left` : ''}`;
}

/** Record of a run or of a search, as far as a list of jobs shows it. */
interface Recorded extends StrengthResult {
  outcome?: { steps: number; ended_early?: string };
}

/** Sentence on the factor that an ended search found, or on the criterion at which an ended run stopped. */
function useAnswer(job: api.Job): string {
  const [answer, set_answer] = useState('');
  const has_record = ['ended', 'stopped'].includes(job.state) && ['run', 'resume', 'fos'].includes(job.kind);
  useEffect(() => {
    set_answer('');
    if (!has_record) return;
    let is_old = false;
    void api
      .record(job.result)
      .then(own => {
        if (!is_old) set_answer(answer_in(own as Recorded, job.state === 'stopped'));
      })
      .catch(() => {});
    return () => {
      is_old = true;
    };
  }, [job.id, has_record]);
  return answer;
}

function answer_in(record: Recorded, is_stopped: boolean): string {
  const { factor_of_safety, bracket, outcome } = record;
  if (typeof factor_of_safety === 'number') return factor_words(record).join(' ');
  if (bracket) return [factor_words(record)[0], bracket_words(record)].join(' ').trim();
  if (!outcome || !(is_stopped || outcome.ended_early)) return '';
  const steps = `${outcome.steps} ${outcome.steps === 1 ? 'step' : 'steps'}`;
  return is_stopped ? `paused after ${steps}` : `stopped after ${steps}: ${outcome.ended_early}`;
}
