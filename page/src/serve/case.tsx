// A case: its text, its drawing, its problems and plan, and what can be started.

import { signal } from '@preact/signals';
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { capital, sentence } from '../draw/words';
import { Fact } from '../view/fact';
import * as api from './api';
import { index_at, leaf_of, new_result, stem_of } from './cases';
import { DiskNote, type Loaded, useDisk } from './disk';
import { JsonError, line_of, type Node } from './edit/case_text';
import { Editor } from './edit/editor';
import { add_analysis, material_of } from './edit/edits';
import { History } from './edit/history';
import { JointSets } from './edit/joint_sets';
import { SaveAs } from './edit/save_as';
import { type Polygon, type Scene, scene_of } from './edit/scene';
import { Tables } from './edit/tables';
import { TextArea } from './edit/text_area';
import { RunForm } from './runs';
import * as state from './state';
import { is_failure } from './verdicts';

type Mode = 'both' | 'drawing' | 'text' | 'tables';

const MODES: [Mode, string][] = [
  ['both', 'Both'],
  ['drawing', 'Drawing'],
  ['text', 'Text'],
  ['tables', 'Tables'],
];

const wide = window.matchMedia('(min-width: 900px)');
const mode = signal<Mode>(wide.matches ? 'both' : 'drawing');

const is_json = (path: string) => /\.json$/i.test(path);
/** True for a case file, JSON or YAML. */
const is_case = (path: string, text: string) =>
  is_json(path) || (/\.ya?ml$/i.test(path) && /^keyblock\s*:/m.test(text));

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
  const [fit, set_fit] = useState(0);
  const [is_saving_as, set_saving_as] = useState(false);
  const [has_sets, set_has_sets] = useState(false);
  const area = useRef<HTMLTextAreaElement>(null);
  const histories = useRef(new Map<string, History>());
  const checks = useRef(0);
  const checked_draft = useRef<string | undefined>(undefined);

  const text = texts[current] ?? '';
  const file = files[current];
  const { scene, fault } = useScene(text, !!file && is_case(current, text));
  // A case that names other files is checked as it is saved: a draft would not find them.
  const is_whole = paths.length === 1 && !!scene && scene.geometry !== 'file' && !names_files(scene.root);
  const changed = paths.filter(path => files[path] && texts[path] !== files[path].text);
  /** Text to check instead of the saved files. */
  const draft = is_whole && changed.length ? text : undefined;
  const cut = useBlocks(paths[0], text, is_whole && scene.geometry !== 'cover' && !fault);

  const chosen_settings = () => Object.fromEntries(settings.filter(([name, value]) => name && value));

  const run_check = async (trial = false, unsaved?: string) => {
    const own = ++checks.current;
    checked_draft.current = unsaved;
    set_checking(true);
    const value = await state.attempt(() => api.check(paths, profile, chosen_settings(), trial, unsaved));
    if (own !== checks.current) return;
    if (value) {
      set_report(value);
      state.units.value = value.case?.unit_by_letters ?? {};
    }
    set_checking(false);
  };

  useEffect(() => {
    let is_old = false;
    set_files({});
    set_texts({});
    set_report(null);
    set_current(paths[0]);
    histories.current.clear();
    void (async () => {
      for (const path of paths) {
        const own = await state.attempt(() => api.read(path));
        if (!own || is_old) return;
        const loaded = own.text ?? '';
        histories.current.set(path, new History({ text: loaded, caret: null }));
        set_files(before => ({ ...before, [path]: { text: loaded, sha256: own.sha256, is_text: own.is_text } }));
        set_texts(before => ({ ...before, [path]: loaded }));
      }
      set_fit(before => before + 1);
      await run_check();
    })();
    return () => {
      is_old = true;
    };
  }, [key]);

  useEffect(state.read_schema, []);

  // A text that differs from the one checked last is checked after a pause, also if it is the saved one again.
  useEffect(() => {
    if (draft === checked_draft.current) return;
    const timer = setTimeout(() => void run_check(false, draft), 800);
    return () => clearTimeout(timer);
  }, [draft, report]);

  useEffect(() => {
    state.unsaved.value = changed;
    return () => {
      state.unsaved.value = [];
    };
  }, [changed.join('\n')]);

  const change = (next: string, tag = '', caret: [number, number] | null = null) => {
    histories.current.get(current)?.push(next, tag, caret);
    set_texts(before => ({ ...before, [current]: next }));
  };

  const go_back = (by: 'undo' | 'redo') => {
    const own = histories.current.get(current)?.[by]();
    if (!own) return;
    set_texts(before => ({ ...before, [current]: own.text }));
    const { caret } = own;
    if (caret && document.activeElement === area.current)
      setTimeout(() => area.current?.setSelectionRange(caret[0], caret[1]));
  };

  const disk = useDisk(paths, files, texts, (path, loaded, takes_text) => {
    set_files(before => ({ ...before, [path]: loaded }));
    if (!takes_text) return;
    histories.current.get(path)?.push(loaded.text);
    set_texts(before => ({ ...before, [path]: loaded.text }));
    void run_check();
  });

  /** State of the last picture of this view, for what goes on after a request. */
  const now = useRef({ files, texts, changed });
  now.current = { files, texts, changed };
  const latest = () => histories.current.get(current)?.text ?? text;

  /** Saves the changed files but one. */
  const save = async (but = '') => {
    await disk.look();
    for (const path of now.current.changed) {
      if (path === but) continue;
      const sent = now.current.texts[path];
      const saved = await state.attempt(() => api.save(path, sent, now.current.files[path].sha256));
      if (!saved) return false;
      set_files(before => ({ ...before, [path]: { text: sent, sha256: saved.sha256, is_text: true } }));
    }
    set_stamp(before => before + 1);
    await run_check();
    void state.refresh();
    return true;
  };

  const keys = (event: KeyboardEvent) => {
    if (!event.ctrlKey && !event.metaKey) return;
    const own = event.key.toLowerCase();
    // Fields of numbers keep their own undo until they are left.
    const is_field = event.target instanceof HTMLInputElement && event.target.type === 'text';
    if (own === 's') void save();
    else if (is_field) return;
    else if (own === 'z' && !event.shiftKey) go_back('undo');
    else if (own === 'y' || own === 'z') go_back('redo');
    else return;
    event.preventDefault();
  };

  const listen = useRef(keys);
  listen.current = keys;
  useEffect(() => {
    const own = (event: KeyboardEvent) => {
      if (!document.querySelector('dialog[open]')) listen.current(event);
    };
    window.addEventListener('keydown', own);
    return () => window.removeEventListener('keydown', own);
  }, []);

  const go_to = (problem: api.Problem) => {
    const path = paths.find(own => problem.file && (own === problem.file || leaf_of(own) === leaf_of(problem.file)));
    if (!path || !problem.line) return;
    set_current(path);
    if (mode.value !== 'text' && mode.value !== 'both') mode.value = wide.matches ? 'both' : 'text';
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

  const errors = report?.errors ?? [];
  const warnings = [...(report?.files ?? []).flatMap(own => own.warnings ?? []), ...(report?.case?.warnings ?? [])];
  const has_drawing = !!scene && scene.geometry !== 'file';
  const shown: Mode = scene && (has_drawing || mode.value === 'tables') ? mode.value : 'text';
  const own_history = histories.current.get(current);
  return (
    <div class="case">
      <section class="editor" aria-label="Case">
        <div class="bar">
          <h2>{leaf_of(current)}</h2>
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
          {scene && (
            <fieldset class="modes" aria-label="Show">
              {MODES.filter(([own]) => has_drawing || own === 'text' || own === 'tables').map(([own, label]) => (
                <label class={`${shown === own ? 'on' : ''} ${own}`} key={own}>
                  <input
                    type="radio"
                    name="mode"
                    checked={shown === own}
                    onChange={() => {
                      mode.value = own;
                    }}
                  />
                  {label}
                </label>
              ))}
            </fieldset>
          )}
          {!scene && !is_case(current, text) && (
            <button type="button" class="small" disabled={!file} onClick={() => void convert_to_case(paths)}>
              Convert to a case
            </button>
          )}
          <button type="button" class="small" disabled={!file?.is_text} onClick={() => set_saving_as(true)}>
            Save as…
          </button>
          <button type="button" class="small strong" disabled={!changed.length} onClick={() => save()}>
            Save
          </button>
        </div>
        <DiskNote disk={disk} />
        {file && !file.is_text ? (
          <p class="empty">This file is not text, so it cannot be edited here.</p>
        ) : (
          <div class={`panes show-${shown}`}>
            {scene && (shown === 'both' || shown === 'drawing') && (
              <Editor
                text={text}
                scene={scene}
                is_old={!!fault}
                blocks={cut.blocks}
                status={fault || cut.status}
                change={change}
                undo={() => go_back('undo')}
                redo={() => go_back('redo')}
                can_undo={own_history?.can_undo ?? false}
                can_redo={own_history?.can_redo ?? false}
                fit={fit}
                open_sets={() => set_has_sets(true)}
              />
            )}
            {scene && shown === 'tables' && (
              <Tables
                text={text}
                scene={scene}
                schema={state.schema.value}
                latest={latest}
                change={change}
                is_old={!!fault}
              />
            )}
            {(shown === 'both' || shown === 'text') && (
              <TextArea
                box={area}
                path={current}
                label={`Text of ${leaf_of(current)}`}
                value={text}
                is_ready={!!file}
                marks={[...errors, ...warnings]
                  .filter(own => own.line && own.file && leaf_of(own.file) === leaf_of(current))
                  .map(own => ({ line: own.line!, is_error: errors.includes(own) || own.level === 'error' }))}
                set={(next, caret) => change(next, 'typing', caret)}
                schema={scene ? state.schema.value : null}
                names={{
                  block: scene?.block_materials.map((_, i, all) => material_of(all, i, 'material')) ?? [],
                  joint: scene?.joint_materials.map((_, i, all) => material_of(all, i, 'joint')) ?? [],
                }}
              />
            )}
          </div>
        )}
      </section>
      <section class="plan" aria-label="Check and run">
        {has_sets && scene && (
          <JointSets text={text} latest={latest} scene={scene} change={change} close={() => set_has_sets(false)} />
        )}
        {!has_drawing && <Picture paths={paths} stamp={stamp} />}
        <Conversion path={paths[0]} />
        <RunForm
          paths={paths}
          report={report}
          profile={profile}
          set_profile={set_profile}
          settings={settings}
          set_settings={set_settings}
          checking={checking}
          check={trial => run_check(trial, draft)}
          before={async () =>
            changed.length === 0 ||
            (confirm(`Save the changes of ${changed.join(', ')} before the run?`) && (await save()))
          }
        />
        <Problems
          errors={errors}
          warnings={warnings}
          is_checked={!!report}
          go_to={go_to}
          lacks={report?.case?.lacks}
          complete={() => void complete(paths[0], latest, change)}
        />
        <Plan report={report} />
      </section>
      {is_saving_as && (
        <SaveAs
          paths={paths}
          current={current}
          text={text}
          save={async but => changed.every(path => path === but) || (await save(but))}
          close={() => set_saving_as(false)}
        />
      )}
    </div>
  );
}

/** True if a value of the case names a file, such as a table of motion. */
function names_files(node: Node): boolean {
  return (
    node.keys.some((key, i) => key.name.endsWith('_file') && node.items[i].kind === 'string') ||
    node.items.some(own => own.items.length > 0 && own.kind !== 'number' && names_files(own))
  );
}

/** Scene of the text; while the text has a fault, the last one, and a sentence on the fault. */
function useScene(text: string, is_on: boolean): { scene: Scene | null; fault: string } {
  const last = useRef<Scene | null>(null);
  return useMemo(() => {
    if (!is_on) {
      last.current = null;
      return { scene: null, fault: '' };
    }
    try {
      last.current = scene_of(text);
      return { scene: last.current, fault: '' };
    } catch (error) {
      const at = error instanceof JsonError ? error.at : 0;
      const { line, column } = line_of(text, at);
      return { scene: last.current, fault: `Line ${line}, column ${column}: ${(error as Error).message}` };
    }
  }, [text, is_on]);
}

/** Blocks as the program cuts them, after a pause in the changes. */
function useBlocks(path: string, text: string, is_on: boolean): { blocks: Polygon[]; status: string } {
  const [own, set_own] = useState<{ blocks: Polygon[]; status: string }>({ blocks: [], status: '' });
  const asked = useRef(0);
  useEffect(() => {
    if (!is_on) {
      asked.current++;
      set_own({ blocks: [], status: '' });
      return;
    }
    const timer = setTimeout(async () => {
      const number = ++asked.current;
      try {
        const { blocks, errors } = await api.blocks(path, text);
        if (number !== asked.current) return;
        if (!blocks) set_own({ blocks: [], status: errors?.[0] ? placed(errors[0]) : 'No blocks.' });
        else set_own({ blocks, status: blocks.length === 1 ? '1 block' : `${blocks.length} blocks` });
      } catch {
        // The next change asks again; the check reports what is wrong.
      }
    }, 300);
    return () => clearTimeout(timer);
  }, [path, text, is_on]);
  return own;
}

/** Adds an analysis to a geometry: to the case file itself, or to a new one beside files of another format. */
async function complete(path: string, latest: () => string, change: (text: string) => void): Promise<void> {
  const rock = (await state.attempt(api.materials))?.block_materials[0]?.like ?? 'limestone';
  if (is_case(path, latest())) return change(add_analysis(latest(), String(rock)));
  await convert_to_case([path], own => add_analysis(own, String(rock)));
}

/** Writes the files of a case as one case file beside them, and opens it. */
async function convert_to_case(paths: string[], more?: (text: string) => string): Promise<void> {
  const taken = (state.listing.value?.files ?? []).filter(own => is_json(own.path)).map(own => stem_of(own.path));
  const target = `${new_result(stem_of(paths[0]), taken)}.json`;
  const done = await state.attempt(() => api.convert(paths, target, 'keyblock-case'));
  if (!done) return;
  if (is_failure(done.exit_code)) {
    state.trouble.value = done.messages;
    return;
  }
  if (more) {
    const own = await state.attempt(() => api.read(target));
    if (!own) return;
    const text = more(own.text ?? '');
    if (!(await state.attempt(() => api.save(target, text, own.sha256)))) return;
  }
  state.converted.value = { path: target, messages: done.messages.trim() };
  await state.refresh();
  state.go(state.link('case', target));
}

/** Words of the program on the conversion that wrote this case: changed rules, lost comments. */
function Conversion({ path }: { path: string }) {
  const { converted } = state;
  if (converted.value.path !== path || !converted.value.messages) return null;
  return (
    <div class="group">
      <h2>Conversion</h2>
      <pre class="messages" role="status">
        {converted.value.messages}
      </pre>
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
  lacks,
  complete,
}: {
  errors: api.Problem[];
  warnings: api.Problem[];
  is_checked: boolean;
  go_to: (problem: api.Problem) => void;
  lacks?: 'analysis' | 'geometry';
  complete: () => void;
}) {
  const shown = warnings
    .filter(own => own.level !== 'silent')
    .sort((a, b) => ORDER.indexOf(level_of(a)) - ORDER.indexOf(level_of(b)));
  const item = (problem: api.Problem, kind: 'error' | 'warning' | 'note', i: number) => (
    <li class={kind} key={`${kind}${i}`}>
      <b>{capital(kind)}</b> {problem.name && <code>{problem.name}</code>}{' '}
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
      {lacks === 'analysis' && (
        <div class="lacks">
          <p>
            <b>To run it, an analysis is missing:</b> steps, gravity and materials.
          </p>
          <button type="button" class="small strong" onClick={complete}>
            Add an analysis
          </button>
        </div>
      )}
      {lacks === 'geometry' && (
        <p class="lacks">
          <b>To run it, a geometry is missing:</b> a drawing, blocks or a cover in the same case.
        </p>
      )}
      {is_checked && !lacks && !errors.length && !shown.length && <p class="note">No problem found.</p>}
      <ul class="warnings">
        {errors.map((own, i) => item(own, 'error', i))}
        {shown.map((own, i) => item(own, level_of(own), i))}
      </ul>
    </div>
  );
}

/** Sentence on a problem behind its place in the text. */
function placed({ line, column, sentence: own }: api.Problem): string {
  return line ? `Line ${line}${column ? `, column ${column}` : ''}: ${own}` : sentence(own);
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
