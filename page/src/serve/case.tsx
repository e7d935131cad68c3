// A case: its text, its drawing, its problems and plan, and what can be started.

import { useEffect, useRef, useState } from 'preact/hooks';
import * as api from './api';
import { index_at, leaf_of, stem_of } from './cases';
import { RunForm } from './runs';
import * as state from './state';

interface Loaded {
  text: string;
  sha256: string;
  is_text: boolean;
}

export function CaseView({ paths }: { paths: string[] }) {
  const key = paths.join('\n');
  const [files, set_files] = useState<Record<string, Loaded>>({});
  const [texts, set_texts] = useState<Record<string, string>>({});
  const [current, set_current] = useState(paths[0]);
  const [report, set_report] = useState<api.Report | null>(null);
  const [checking, set_checking] = useState(false);
  const [stamp, set_stamp] = useState(0);
  const [profile, set_profile] = useState('');
  const [settings, set_settings] = useState<[string, string][]>([]);
  const area = useRef<HTMLTextAreaElement>(null);

  const chosen_settings = () => Object.fromEntries(settings.filter(([name, value]) => name && value));

  const run_check = async (trial = false) => {
    set_checking(true);
    const value = await state.attempt(() => api.check(paths, profile, chosen_settings(), trial));
    if (value) set_report(value);
    set_checking(false);
  };

  useEffect(() => {
    let is_old = false;
    set_files({});
    set_texts({});
    set_report(null);
    set_current(paths[0]);
    void (async () => {
      for (const path of paths) {
        const own = await state.attempt(() => api.read(path));
        if (!own || is_old) return;
        set_files(before => ({
          ...before,
          [path]: { text: own.text ?? '', sha256: own.sha256, is_text: own.is_text },
        }));
        set_texts(before => ({ ...before, [path]: own.text ?? '' }));
      }
      await run_check();
    })();
    return () => {
      is_old = true;
    };
  }, [key]);

  const changed = paths.filter(path => files[path] && texts[path] !== files[path].text);
  useEffect(() => {
    state.unsaved.value = Object.fromEntries(changed.map(path => [path, true]));
    return () => {
      state.unsaved.value = {};
    };
  }, [changed.join('\n')]);

  const save = async () => {
    for (const path of changed) {
      const sent = texts[path];
      const saved = await state.attempt(() => api.save(path, sent, { overwrite: true, sha256: files[path].sha256 }));
      if (!saved) return false;
      set_files(before => ({ ...before, [path]: { text: sent, sha256: saved.sha256, is_text: true } }));
    }
    set_stamp(before => before + 1);
    await run_check();
    void state.refresh();
    return true;
  };

  const save_as = async () => {
    const path = window.prompt(
      'New file, in this folder:',
      `${stem_of(current)}_new${current.slice(stem_of(current).length)}`,
    );
    if (!path) return;
    const saved = await state.attempt(() => api.save(path, texts[current]));
    if (!saved) return;
    await state.refresh();
    state.go(state.link('case', ...paths.map(own => (own === current ? saved.path : own))));
  };

  const go_to = (problem: api.Problem) => {
    const path = paths.find(own => problem.file && (own === problem.file || leaf_of(own) === leaf_of(problem.file)));
    if (!path || !problem.line) return;
    set_current(path);
    setTimeout(() => {
      const box = area.current;
      if (!box) return;
      const from = index_at(box.value, problem.line!, problem.column || 1);
      const line_end = box.value.indexOf('\n', from);
      box.focus();
      box.setSelectionRange(from, Math.max(from, line_end < 0 ? box.value.length : line_end));
      const height = Number.parseFloat(getComputedStyle(box).lineHeight);
      box.scrollTop = Math.max(0, (problem.line! - 4) * height);
    });
  };

  const file = files[current];
  const errors = report?.errors ?? [];
  const warnings = [...(report?.files ?? []).flatMap(own => own.warnings ?? []), ...(report?.case?.warnings ?? [])];
  return (
    <div class="case">
      <section class="editor" aria-label="Text">
        <div class="bar">
          <h2>{leaf_of(paths[0])}</h2>
          {paths.length > 1 && (
            <select
              aria-label="File"
              value={current}
              onChange={event => {
                set_current(event.currentTarget.value);
              }}
            >
              {paths.map(path => (
                <option value={path} key={path}>
                  {leaf_of(path)}
                </option>
              ))}
            </select>
          )}
          {changed.length > 0 && <span class="note">not saved</span>}
          <span class="space" />
          <button type="button" class="small" disabled={!file?.is_text} onClick={save_as}>
            Save as…
          </button>
          <button type="button" class="small strong" disabled={!changed.length} onClick={save}>
            Save
          </button>
        </div>
        {file && !file.is_text ? (
          <p class="empty">This file is not text, so it cannot be edited here.</p>
        ) : (
          <TextArea
            box={area}
            label={`Text of ${leaf_of(current)}`}
            value={texts[current] ?? ''}
            is_ready={!!file}
            marks={[...errors, ...warnings]
              .filter(own => own.line && own.file && leaf_of(own.file) === leaf_of(current))
              .map(own => ({ line: own.line!, is_error: errors.includes(own) || own.level === 'error' }))}
            set={text => set_texts(before => ({ ...before, [current]: text }))}
            save={save}
          />
        )}
      </section>
      <section class="plan" aria-label="Check and run">
        <Picture paths={paths} stamp={stamp} />
        <RunForm
          paths={paths}
          report={report}
          profile={profile}
          set_profile={set_profile}
          settings={settings}
          set_settings={set_settings}
          checking={checking}
          check={run_check}
          before={async () =>
            changed.length === 0 ||
            (confirm(`Save the changes of ${changed.join(', ')} before the run?`) && (await save()))
          }
        />
        <Problems errors={errors} warnings={warnings} is_checked={!!report} go_to={go_to} />
        <Plan report={report} />
      </section>
    </div>
  );
}

/** Text with numbers of lines beside it. */
function TextArea({
  box,
  label,
  value,
  is_ready,
  marks,
  set,
  save,
}: {
  box: { current: HTMLTextAreaElement | null };
  label: string;
  value: string;
  is_ready: boolean;
  marks: { line: number; is_error: boolean }[];
  set: (text: string) => void;
  save: () => void;
}) {
  const gutter = useRef<HTMLPreElement>(null);
  const lines = value.split('\n').length;
  const numbers = [];
  for (let l = 1; l <= lines; l++) {
    const mark = marks.find(own => own.line === l && own.is_error) ?? marks.find(own => own.line === l);
    numbers.push(mark ? <b class={mark.is_error ? 'bad' : 'warn'}>{`${l}\n`}</b> : `${l}\n`);
  }
  return (
    <div class="text">
      <pre ref={gutter} aria-hidden="true">
        {numbers}
      </pre>
      <textarea
        ref={box}
        aria-label={label}
        spellcheck={false}
        autocomplete="off"
        wrap="off"
        value={value}
        readOnly={!is_ready}
        onInput={event => set(event.currentTarget.value)}
        onScroll={event => {
          if (gutter.current) gutter.current.scrollTop = event.currentTarget.scrollTop;
        }}
        onKeyDown={event => {
          if ((event.ctrlKey || event.metaKey) && event.key === 's') {
            event.preventDefault();
            save();
          }
        }}
      />
    </div>
  );
}

/** Drawing of the case's geometry, once it can be read. */
function Picture({ paths, stamp }: { paths: string[]; stamp: number }) {
  const [is_bad, set_bad] = useState(false);
  const source = `${api.address('/api/drawing', { path: paths[0] })}&${stamp}`;
  useEffect(() => set_bad(false), [source]);
  if (is_bad) return <p class="no-picture">No drawing: the program cannot read the geometry yet.</p>;
  return <img class="picture" alt={`Drawing of ${paths[0]}`} src={source} onError={() => set_bad(true)} />;
}

const ORDER = ['error', 'warning', 'note'];

function level_of(problem: api.Problem): 'error' | 'warning' | 'note' {
  return problem.level === 'error' || problem.level === 'warning' ? problem.level : 'note';
}

function Problems({
  errors,
  warnings,
  is_checked,
  go_to,
}: {
  errors: api.Problem[];
  warnings: api.Problem[];
  is_checked: boolean;
  go_to: (problem: api.Problem) => void;
}) {
  const shown = warnings
    .filter(own => own.level !== 'silent')
    .sort((a, b) => ORDER.indexOf(level_of(a)) - ORDER.indexOf(level_of(b)));
  const item = (problem: api.Problem, kind: 'error' | 'warning' | 'note', i: number) => (
    <li class={kind} key={`${kind}${i}`}>
      <b>{kind.charAt(0).toUpperCase() + kind.slice(1)}</b> {problem.name && <code>{problem.name}</code>}{' '}
      {problem.line ? (
        <button type="button" class="link" onClick={() => go_to(problem)}>
          line {problem.line}
        </button>
      ) : null}
      <p>{sentence(problem.sentence)}</p>
      {problem.remedy && <p class="note">{sentence(problem.remedy)}</p>}
    </li>
  );
  return (
    <div class="group" aria-live="polite">
      <h2>Check</h2>
      {!is_checked && <p class="note">Checking…</p>}
      {is_checked && !errors.length && !shown.length && <p class="note">No problem found.</p>}
      <ul class="warnings">
        {errors.map((own, i) => item(own, 'error', i))}
        {shown.map((own, i) => item(own, level_of(own), i))}
      </ul>
    </div>
  );
}

function sentence(text: string): string {
  const own = text.charAt(0).toUpperCase() + text.slice(1);
  return /[.!?]$/.test(own) ? own : `${own}.`;
}

function Plan({ report }: { report: api.Report | null }) {
  const own = report?.case;
  if (!own?.requires) return null;
  return (
    <div class="group">
      <h2>Plan</h2>
      <table class="facts">
        <tbody>
          <Fact name="Profile" value={own.profile && `${own.profile} (${own.profile_because})`} />
          <Fact name="Size" value={own.size} />
          <Fact name="Unknowns" value={own.requires.unknowns} />
          <Fact name="Unknowns of" value={own.requires.basis} />
          <Fact name="Smallest block" value={own.smallest_block?.replace(/^smallest block: /, '')} />
        </tbody>
      </table>
      <details>
        <summary>Terms of the equations</summary>
        <table class="facts">
          <tbody>
            {own.requires.terms.map(term => (
              <tr key={term.term}>
                <th scope="row">{term.term.replace(/_/g, ' ')}</th>
                <td class="left">{term.reason}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </details>
    </div>
  );
}

function Fact({ name, value }: { name: string; value: unknown }) {
  if (value === undefined || value === null || value === '') return null;
  return (
    <tr>
      <th scope="row">{name}</th>
      <td>{String(value)}</td>
    </tr>
  );
}
