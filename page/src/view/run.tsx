// Tab Run: verdict, facts, warnings, stages, settings of run.json in plain words.

import { body_name, type Geometry } from '../data/decode';
import { show, show_time, show_with } from '../draw/numbers';
import { capital, sentence } from '../draw/words';
import { Fact } from './fact';
import { Icon } from './icons';
import * as state from './state';

function words(name: string): string {
  return capital(name.replace(/[_.]/g, ' '));
}

/** Message of a warning without its file and its code; both are shown elsewhere. */
export function message_of(first: string): { kind: string; text: string } {
  const match = /^(?:.*?:\s)?(error|warning|note):\s([\s\S]*?)(?:\s\[[\w]+\])?$/.exec(first);
  if (!match) return { kind: 'note', text: first };
  const text = match[2].trim();
  return { kind: match[1], text: capital(text) };
}

/** A sentence of the record, with powers of ten as people write them. */
export function record_sentence(text: unknown): string {
  return sentence(String(text).replace(/(\d(?:\.\d+)?e[+-]\d+)/g, value => show(Number(value), 3)));
}

/** The last frame whose model has a body of this number, the present one if it has. */
function find_body(number: number): { frame: number; geometry: Geometry; row: number } | null {
  const { store, frame } = state;
  for (const at of [frame.value, ...last_frames()]) {
    const geometry = store.geometry_now(store.epoch_of(at));
    const row = geometry?.number.indexOf(number) ?? -1;
    if (geometry && row >= 0) return { frame: at, geometry, row };
  }
  return null;
}

/** Last frames of all epochs, the newest first. */
function last_frames(): number[] {
  const { frames } = state.head;
  const last = frames.flatMap((own, i) => (own.epoch === frames[i + 1]?.epoch ? [] : [i]));
  return last.reverse();
}

function name_of_body(number: number): string {
  const found = find_body(number);
  return found ? body_name(found.geometry, found.row) : `block ${number}`;
}

function go_to_body(number: number): void {
  const found = find_body(number);
  if (!found) return;
  state.frame.value = found.frame;
  state.chosen.value = { kind: 'body', key: found.geometry.key[found.row] };
  state.tab.value = 'chosen';
}

export function RunTab() {
  const { head } = state;
  const run = head.run;
  if (!run) {
    return (
      <div class="stack">
        <section class="group">
          <h2>Record of the run</h2>
          <p>
            {state.is_running.value
              ? 'The run goes on. It writes its record and its tables at the end, or when it is stopped.'
              : 'The run was stopped before it wrote its record. Frames and tables up to there are shown.'}
          </p>
          <p class="note">{head.precision}</p>
        </section>
      </div>
    );
  }
  const { verdict } = head;
  const sentences: string[] = run.outcome?.motion?.sentences ?? [];
  const doubts: unknown[] = run.outcome?.doubts ?? [];
  const warnings: { name: string; count: number; first: string }[] = run.warnings ?? [];
  const counts = run.counts ?? {};
  const at_start = head.epochs.length > 1 ? ' at the start' : '';
  const units = head.units;
  const seconds = run.seconds ? Object.values(run.seconds as Record<string, number>).reduce((a, b) => a + b, 0) : null;
  const extremes = Object.entries((run.extremes ?? {}) as Record<string, { value: number; element?: number }>).filter(
    ([name, own]) => name !== 'least_area_share' || own.value < 0.999,
  );
  const stages: { name: string; steps: [number, number]; end_time?: number; balanced?: boolean }[] = run.stages ?? [];
  const closure = run.ledger?.closure?.energy;
  return (
    <div class="stack">
      <section class="group" aria-labelledby="run-verdict">
        <h2 id="run-verdict">Result</h2>
        <p class={`verdict ${verdict.tone}`}>
          <Icon name={verdict.tone === 'good' ? 'good' : verdict.tone === 'plain' ? 'fit' : 'warn'} />
          {capital(verdict.words)}
        </p>
        {sentences.map(text => (
          <p key={text}>{record_sentence(text)}</p>
        ))}
        {run.outcome?.reason && <p class="doubt">{record_sentence(run.outcome.reason)}</p>}
        {run.outcome?.ended_early && <p>{record_sentence(run.outcome.ended_early)}</p>}
        {run.outcome?.try?.length > 0 && (
          <p>
            Settings to try:{' '}
            {run.outcome.try.map((own: string, i: number) => (
              <span key={own}>
                {i > 0 && ', '}
                <code>{own}</code>
              </span>
            ))}
          </p>
        )}
        {doubts.map(text => (
          <p class="doubt" key={String(text)}>
            {record_sentence(text)}
          </p>
        ))}
      </section>

      {extremes.length > 0 && (
        <section class="group" aria-labelledby="run-extremes">
          <h2 id="run-extremes">Extremes</h2>
          <table class="facts">
            <tbody>
              {extremes.map(([name, own]) => {
                const unit = run.unit_of?.[`extremes.${name}.value`] ?? '';
                return (
                  <tr key={name}>
                    <th scope="row">{head.titles[name] || words(name)}</th>
                    <td>
                      {show_with(own.value, unit, name === 'least_area_share' ? 6 : 4)}
                      {own.element !== undefined && (
                        <button type="button" class="link" onClick={() => go_to_body(own.element!)}>
                          {name_of_body(own.element!)}
                        </button>
                      )}
                    </td>
                  </tr>
                );
              })}
            </tbody>
          </table>
        </section>
      )}

      <section class="group" aria-labelledby="run-facts">
        <h2 id="run-facts">Facts</h2>
        <table class="facts">
          <tbody>
            <Fact
              name="Analysis"
              value={run.is_static ? 'static' : run.is_of_motion ? 'dynamic' : words(run.settings?.motion ?? '')}
            />
            <Fact name="Profile" value={run.profile && `${run.profile} (${run.profile_because})`} />
            <Fact name="Steps" value={run.outcome?.steps} />
            {!run.is_static && run.outcome?.time !== undefined && (
              <Fact name="Time" value={show_time(run.outcome.time, units?.time)} />
            )}
            <Fact name="Frames on this page" value={head.frames.length} />
            <Fact name={`Blocks${at_start}`} value={counts.blocks} />
            <Fact name={`Elements${at_start}`} value={counts.elements} />
            <Fact name="Covers" value={counts.covers} />
            <Fact name="Unknowns" value={counts.unknowns} />
            <Fact name="Most contacts" value={counts.most_contacts} />
            <Fact
              name="Deepest overlap"
              value={
                typeof counts.greatest_penetration === 'number'
                  ? show_with(counts.greatest_penetration, units?.length ?? '', 3)
                  : ''
              }
            />
            {run.plastic?.yielded_fraction !== undefined && (
              <Fact name="Yielded share of area" value={`${show(100 * run.plastic.yielded_fraction, 3)} %`} />
            )}
            {closure !== undefined && <Fact name="Error of energy balance" value={show(closure, 2)} />}
            {seconds !== null && <Fact name="Computing time" value={`${show(seconds, 3)} s`} />}
            <Fact name="Program" value={head.program} />
          </tbody>
        </table>
        <p class="note">{head.precision}</p>
        {!units && <p class="note">The case declares no units. Numbers are in the units of its input.</p>}
      </section>

      {stages.length > 0 && (
        <section class="group" aria-labelledby="run-stages">
          <h2 id="run-stages">Stages</h2>
          <table class="list">
            <thead>
              <tr>
                <th scope="col">Stage</th>
                <th scope="col" class="number">
                  Steps
                </th>
              </tr>
            </thead>
            <tbody>
              {stages.map(stage => (
                <tr key={stage.name}>
                  <td>
                    <button
                      type="button"
                      class="link"
                      onClick={() => {
                        const first = head.frames.findIndex(f => f.step >= stage.steps[0]);
                        state.go_to(first < 0 ? state.last_frame() : first);
                      }}
                    >
                      {stage.name}
                    </button>
                  </td>
                  <td class="number">
                    {stage.steps[0]} to {stage.steps[1]}
                  </td>
                </tr>
              ))}
            </tbody>
          </table>
        </section>
      )}

      <section class="group" aria-labelledby="run-warnings">
        <h2 id="run-warnings">Warnings and notes</h2>
        {warnings.length === 0 && <p class="note">None.</p>}
        <ul class="warnings">
          {warnings.map(own => {
            const { kind, text } = message_of(own.first);
            return (
              <li key={own.name} class={kind}>
                <b>{kind === 'note' ? 'Note' : kind === 'error' ? 'Error' : 'Warning'}</b> <code>{own.name}</code>
                {own.count > 1 && <span class="note"> {own.count} times</span>}
                <p>{record_sentence(text)}</p>
              </li>
            );
          })}
        </ul>
      </section>

      <section class="group" aria-labelledby="run-files">
        <h2 id="run-files">Input files</h2>
        <ul class="files">
          {(run.inputs ?? []).map((input: { file: string; sha256?: string; format?: string }) => (
            <li key={input.file}>
              <b>{input.file.split('/').pop()}</b> {input.format && <span class="note">{input.format}</span>}
              {input.sha256 && (
                <code class="sum" title="SHA-256 checksum">
                  {input.sha256}
                </code>
              )}
            </li>
          ))}
        </ul>
      </section>

      {run.settings && (
        <details class="group">
          <summary>Settings</summary>
          <table class="facts">
            <tbody>
              {Object.entries(run.settings as Record<string, unknown>).map(([name, value]) => (
                <tr key={name}>
                  <th scope="row">{name.replace(/_/g, ' ')}</th>
                  <td>{value === '' ? '–' : typeof value === 'number' ? show(value, 6) : String(value)}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </details>
      )}

      {run.requirements?.terms && (
        <details class="group">
          <summary>Terms of the equations</summary>
          <table class="facts">
            <tbody>
              {run.requirements.terms.map((own: { term: string; reason: string }) => (
                <tr key={own.term}>
                  <th scope="row">{words(own.term)}</th>
                  <td class="left">{own.reason}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </details>
      )}
    </div>
  );
}
