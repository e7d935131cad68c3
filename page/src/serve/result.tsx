// A result in its own page, and two results side by side with one slider, linked by time or by step.

import { useEffect, useRef, useState } from 'preact/hooks';
import { show_time, show_with } from '../draw/numbers';
import * as api from './api';
import { last_messages } from './cases';
import type { Units } from './edit/schema';
import { follow, type LivePage } from './follow';
import { Handouts } from './handouts';
import { frame_at, last_place } from './pair';
import { progress_of } from './runs';
import * as state from './state';
import { StrengthView } from './strength';
import { SweepView } from './study';
import { relative_of_entry, title_of_entry, units_of_entry, words_of_value } from './titles';
import { ending_words } from './verdicts';

export function ResultView({ path }: { path: string }) {
  const entry = state.listing.value?.results.find(own => own.path === path);
  const job = state.jobs.value.find(own => own.result === path && (own.state === 'runs' || own.state === 'waits'));
  const last = state.jobs.value.filter(own => own.result === path).pop();
  const failed = last?.kind === 'resume' && last.state === 'ended' && last.exit_code === 3 ? last : null;
  const is_strength = entry?.kind === 'fos';
  const others = (state.listing.value?.results ?? []).filter(own => own.path !== path && own.kind === 'run');
  const frame = useRef<HTMLIFrameElement>(null);
  // Without a frame of the run there is no page yet.
  const [tries, set_tries] = useState(0);
  const [told, set_told] = useState('');
  const loaded = () => {
    const page = (frame.current?.contentWindow as Page)?.keyblock_page as LivePage | undefined;
    if (page) void follow(path, page, ended.current.signal, set_told);
    else if (job) setTimeout(() => set_tries(before => before + 1), 1000);
  };
  const ended = useRef(new AbortController());
  useEffect(() => {
    ended.current = new AbortController();
    set_told('');
    return () => ended.current.abort();
  }, [path]);
  const source = api.address('/page', { result: path });
  if (is_strength) return <StrengthView path={path} />;
  if (entry?.kind === 'sweep') return <SweepView path={path} is_finished={entry.is_finished} />;
  if (entry?.is_broken)
    return (
      <p class="note pad" role="alert">
        The record of {path} is damaged: run.json holds no record of a run. Run the case again.
      </p>
    );
  // The listing holds the kind of a result; without it the frame would ask for a page that may not exist.
  if (!state.listing.value) return <p class="note pad">Reading the folder…</p>;
  if (!entry && !last)
    return (
      <p class="note pad" role="alert">
        There is no result {path} in this folder.
      </p>
    );
  return (
    <div class="result">
      <div class="bar">
        <h2>{path}</h2>
        {job && (
          <>
            <span class="note">{job.state === 'runs' ? progress_of(job) : job.state}</span>
            <button
              type="button"
              class="small"
              onClick={async () => {
                await state.attempt(() => api.stop(job.id));
                await state.refresh_jobs();
              }}
            >
              Pause
            </button>
          </>
        )}
        {!job && entry?.has_checkpoint && (
          <button
            type="button"
            class="small"
            onClick={async () => {
              await state.attempt(() => api.resume(path));
              await state.refresh_jobs();
            }}
          >
            Go on
          </button>
        )}
        <span class="note" role="status">
          {told}
        </span>
        {!job && failed && (
          <span class="note bad" role="alert">
            {last_messages(failed.messages ?? '') || `The run ${ending_words(failed.exit_code)}.`}
          </span>
        )}
        <span class="space" />
        {others.length > 0 && (
          <select
            aria-label="Compare with"
            value=""
            onChange={event => state.go(state.link('compare', path, event.currentTarget.value))}
          >
            <option value="">Compare with…</option>
            {others.map(own => (
              <option value={own.path} key={own.path}>
                {own.path}
              </option>
            ))}
          </select>
        )}
        <a class="button" href={source} target="_blank" rel="noreferrer">
          Own window
        </a>
        {!job && <Handouts path={path} />}
      </div>
      <iframe key={`${path} ${tries}`} ref={frame} title={`Page of ${path}`} src={source} onLoad={loaded} />
    </div>
  );
}

// biome-ignore lint/suspicious/noExplicitAny: the page of a run in a frame.
type Page = any;

/** The page in a frame once it has decoded its data. */
function page_in(frame: HTMLIFrameElement | null): Page | null {
  const own = (frame?.contentWindow as Page)?.keyblock_page;
  return own?.state?.measures?.length ? own : null;
}

export function CompareView({ first, second }: { first: string; second: string }) {
  const frames = [useRef<HTMLIFrameElement>(null), useRef<HTMLIFrameElement>(null)];
  const [differences, set_differences] = useState<{ inputs?: api.Difference[]; differences: api.Difference[] } | null>(
    null,
  );
  const [is_refused, set_refused] = useState(false);
  const [pages, set_pages] = useState<Page[]>([]);
  const [place, set_place] = useState(0);
  // Times of a static run are those of load steps.
  const by_step = pages.some(page => page.state.is_static());
  const [measure, set_measure] = useState('displacement.size');
  const [same, set_same] = useState(true);
  const [playing, set_playing] = useState(false);

  useEffect(() => {
    let is_old = false;
    set_pages([]);
    set_differences(null);
    set_refused(false);
    void state
      .attempt(() => api.compare(first, second))
      .then(value => {
        if (is_old) return;
        set_differences(value);
        set_refused(!value);
      });
    const timer = setInterval(() => {
      const now = frames.map(frame => page_in(frame.current));
      if (!now.every(page => page?.state.all_decoded.value)) return;
      clearInterval(timer);
      if (is_old) return;
      set_pages(now);
      set_place(Infinity);
    }, 200);
    return () => {
      is_old = true;
      clearInterval(timer);
    };
  }, [first, second]);

  const last = pages.length ? Math.max(...pages.map(page => last_place(page.state.head.frames, by_step))) : 1;
  const shown = Math.min(place, last);
  useEffect(() => {
    for (const page of pages) page.state.frame.value = frame_at(page.state.head.frames, by_step, shown);
  }, [pages, shown]);
  useEffect(() => {
    for (const page of pages) page.state.measure_id.value = measure;
    if (!pages.length) return;
    // One range for both, or each its own, as with values in two units.
    const ranges = pages.map(page => page.shown_range(measure)).filter(Boolean);
    const [one, other] = pages.map(page => page.state.measures.find((own: Page) => own.id === measure)?.unit);
    for (const page of pages) {
      if (same && ranges.length === 2 && one === other) {
        page.state.own_range.value = {
          low: Math.min(...ranges.map(r => r.low)),
          high: Math.max(...ranges.map(r => r.high)),
        };
        page.state.range_mode.value = 'own';
      } else {
        page.state.range_mode.value = 'run';
      }
    }
  }, [pages, measure, same]);
  useEffect(() => {
    if (!playing || !pages.length) return;
    let request = 0;
    let before = performance.now();
    let now = shown >= last ? 0 : shown;
    const tick = (at: number) => {
      now += ((at - before) / 10_000) * last;
      before = at;
      set_place(Math.min(last, now));
      if (now >= last) set_playing(false);
      else request = requestAnimationFrame(tick);
    };
    request = requestAnimationFrame(tick);
    return () => cancelAnimationFrame(request);
  }, [playing, pages]);

  const shared: { id: string; label: string }[] = pages.length
    ? pages[0].state.measures.filter((m: Page) => pages[1].state.measures.some((n: Page) => n.id === m.id))
    : [];
  const unit = pages[0]?.state.head.units?.time ?? '';
  const words = by_step ? `step ${Math.round(shown)}` : show_time(shown, unit);
  const [one, other] = pages.map(page => page.state.head.unit_by_letters as Units | undefined);
  const units = one && JSON.stringify(one) === JSON.stringify(other) ? one : null;
  return (
    <div class="compare">
      <div class="pair-pages">
        {[first, second].map((path, i) => (
          <figure key={path}>
            <figcaption>
              <a href={state.link('result', path)}>{path}</a>
              {pages[i] && <span class="note">{verdict(pages[i])}</span>}
            </figcaption>
            <iframe ref={frames[i]} title={`Page of ${path}`} src={`${api.address('/page', { result: path })}#bare`} />
          </figure>
        ))}
      </div>
      <div class="bar">
        <button type="button" class="small strong" disabled={!pages.length} onClick={() => set_playing(!playing)}>
          {playing ? 'Pause' : 'Play'}
        </button>
        <input
          type="range"
          min={0}
          max={last}
          step={by_step ? 1 : last / 1000}
          value={shown}
          style={{ '--share': shown / last }}
          aria-label={by_step ? 'Step of both runs' : 'Time of both runs'}
          aria-valuetext={words}
          onInput={event => {
            set_playing(false);
            set_place(Number(event.currentTarget.value));
          }}
        />
        <output class="note">{words}</output>
        <select aria-label="Colour by" value={measure} onChange={event => set_measure(event.currentTarget.value)}>
          {shared.map(own => (
            <option value={own.id} key={own.id}>
              {own.label}
            </option>
          ))}
        </select>
        <label class="check">
          <input type="checkbox" checked={same} onChange={event => set_same(event.currentTarget.checked)} />
          <span>Same range</span>
        </label>
      </div>
      {!differences && <p class="note pad">{is_refused ? 'These two results cannot be compared.' : 'Comparing…'}</p>}
      {differences && (
        <>
          <Differences
            what="inputs"
            list={differences.inputs ?? []}
            none="The input files of both runs are equal."
            units={units}
          />
          <Differences
            what="results"
            list={differences.differences}
            none="The records of both runs are equal."
            units={units}
          />
        </>
      )}
    </div>
  );
}

function verdict(page: Page): string {
  return page.verdict?.() ?? '';
}

function text_of(value: unknown, unit: string): string {
  if (typeof value === 'number') return show_with(value, unit, 5);
  const text = words_of_value(value);
  return text.length > 200 ? `${text.slice(0, 200)}…` : text;
}

function Differences({
  what,
  list,
  none,
  units,
}: {
  what: string;
  list: api.Difference[];
  none: string;
  /** Units that both cases declare. */
  units: Units | null;
}) {
  useEffect(() => state.read_schema(), []);
  if (!list.length) return <p class="note pad">{none}</p>;
  const schema = state.schema.value;
  return (
    <div class="pad">
      <table class="list">
        <caption>
          {list.length} {list.length === 1 ? 'difference' : 'differences'} of {what}
        </caption>
        <thead>
          <tr>
            <th scope="col">Entry</th>
            <th scope="col">First</th>
            <th scope="col">Second</th>
            <th scope="col" class="number">
              Relative
            </th>
          </tr>
        </thead>
        <tbody>
          {list.slice(0, 200).map(own => {
            const [one, other] = units_of_entry(own, schema, units);
            return (
              <tr key={own.path}>
                <th scope="row" title={own.path}>
                  {title_of_entry(own, schema)}
                </th>
                <td>{text_of(own.first, one)}</td>
                <td>{text_of(own.second, other)}</td>
                <td class="number">{relative_of_entry(own)}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
      {list.length > 200 && <p class="note">{list.length - 200} more are not listed.</p>}
    </div>
  );
}
