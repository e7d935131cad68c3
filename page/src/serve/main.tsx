// The window of `keyblock serve`: cases and results of a folder, editing, runs, comparison.

import { computed, effect, signal } from '@preact/signals';
import { render } from 'preact';
import { useState } from 'preact/hooks';
import { Icon } from '../view/icons';
import * as api from './api';
import { CaseView } from './case';
import { type Case, folder_of, leaf_of, name_of_result, tables_of } from './cases';
import { NewScene } from './edit/new_scene';
import { CompareView, ResultView } from './result';
import { JobItem } from './runs';
import * as state from './state';
import { StudyView } from './study';
import '../view/style.css';
import './serve.css';

const dark_system = window.matchMedia('(prefers-color-scheme: dark)');
const theme = signal<'light' | 'dark'>(dark_system.matches ? 'dark' : 'light');
dark_system.addEventListener('change', event => {
  theme.value = event.matches ? 'dark' : 'light';
});
effect(() => {
  document.documentElement.dataset.theme = theme.value;
});

const route = computed(() => state.route_of(state.route.value));
const filter = signal('');

function App() {
  const now = route.value;
  return (
    <div class={`page window${now.kind === 'home' ? '' : ' in-view'}`}>
      <header>
        <a class="title" href="#/">
          <h1>Keyblock</h1>
          <p>{state.listing.value?.folder}</p>
        </a>
        {state.trouble.value && (
          <p class="trouble" role="alert">
            {state.trouble.value}
            <button
              type="button"
              class="link"
              onClick={() => {
                state.trouble.value = '';
              }}
            >
              Close
            </button>
          </p>
        )}
        <div class="actions">
          <RunningBadge />
          <button
            type="button"
            class="icon"
            aria-label={theme.value === 'dark' ? 'Light theme' : 'Dark theme'}
            onClick={() => {
              theme.value = theme.value === 'dark' ? 'light' : 'dark';
            }}
          >
            <Icon name={theme.value === 'dark' ? 'sun' : 'moon'} />
          </button>
        </div>
      </header>
      <div class="body">
        <Side />
        <main class="content">
          {now.kind === 'home' && <Home />}
          {now.kind === 'new' && <NewScene />}
          {now.kind === 'case' && <CaseView paths={now.paths} key={now.paths.join('\n')} />}
          {now.kind === 'result' && <ResultView path={now.path} key={now.path} />}
          {now.kind === 'study' && <StudyView study={now.study} paths={now.paths} key={state.route.value} />}
          {now.kind === 'compare' && <CompareView first={now.first} second={now.second} />}
        </main>
      </div>
    </div>
  );
}

function RunningBadge() {
  const open = state.jobs.value.filter(job => job.state === 'runs' || job.state === 'waits');
  if (!open.length) return null;
  const [job] = open;
  return (
    <a class="badge plain" href={state.link('result', job.result)}>
      <Icon name="play" size={12} />
      <span>
        {leaf_of(job.result)}
        {job.steps ? ` ${Math.round((100 * (job.step ?? 0)) / job.steps)} %` : ''}
        {open.length > 1 ? `, ${open.length - 1} more` : ''}
      </span>
    </a>
  );
}

function matches(name: string): boolean {
  return name.toLowerCase().includes(filter.value.trim().toLowerCase());
}

const state_of = (own: api.ResultEntry) => (own.is_broken ? 'record damaged' : own.is_finished ? '' : 'not finished');

function Side() {
  const now = route.value;
  const current = now.kind === 'case' ? now.paths[0] : now.kind === 'result' ? now.path : '';
  const results = state.listing.value?.results ?? [];
  const cases = state.cases.value.filter(own => matches(own.name));
  return (
    <nav aria-label="Folder">
      <input
        type="search"
        placeholder="Filter"
        aria-label="Filter cases and results"
        value={filter.value}
        onInput={event => {
          filter.value = event.currentTarget.value;
        }}
      />
      <h2>Cases</h2>
      <ul>
        {cases.map(own => (
          <li key={own.name}>
            <a
              href={state.link('case', ...own.paths)}
              aria-current={current === own.paths[0] ? 'page' : undefined}
              title={own.paths.join(', ')}
            >
              {leaf_of(own.name)}
              {folder_of(own.name) && <span>{folder_of(own.name)}</span>}
            </a>
          </li>
        ))}
      </ul>
      <h2>Results</h2>
      <ul>
        {results
          .filter(own => matches(own.path))
          .sort((a, b) => b.time - a.time)
          .map(own => (
            <li key={own.path}>
              <a href={state.link('result', own.path)} aria-current={current === own.path ? 'page' : undefined}>
                {name_of_result(own.path)}
                <span>
                  {folder_of(own.path)} {state_of(own)}
                </span>
              </a>
            </li>
          ))}
      </ul>
      {!results.length && <p class="note">No results yet.</p>}
    </nav>
  );
}

function Home() {
  const { listing } = state;
  if (!listing.value) return <p class="note pad">Reading the folder…</p>;
  const results = listing.value.results.slice().sort((a, b) => b.time - a.time);
  const jobs = state.jobs.value.slice().reverse();
  const tables = tables_of(listing.value.files).filter(own => matches(own.path));
  return (
    <div class="home">
      {jobs.length > 0 && (
        <section aria-labelledby="home-jobs">
          <h2 id="home-jobs">Runs of this session</h2>
          <ul class="jobs wide-jobs">
            {jobs.slice(0, 8).map(job => (
              <JobItem job={job} key={job.id} />
            ))}
          </ul>
        </section>
      )}
      <section aria-labelledby="home-cases">
        <div class="bar">
          <h2 id="home-cases">Cases</h2>
          <span class="space" />
          <a class="button" href="#/new">
            New scene
          </a>
          <label class="button">
            Add files…
            <input
              type="file"
              multiple
              onChange={event => {
                void add_files(event.currentTarget.files);
                event.currentTarget.value = '';
              }}
            />
          </label>
        </div>
        {!!listing.value.unreadable && (
          <p class="note">
            {listing.value.unreadable} {listing.value.unreadable === 1 ? 'name' : 'names'} of files or folders are not
            UTF-8, and not listed: rename them.
          </p>
        )}
        {!state.cases.value.length && (
          <p class="note">This folder holds no cases. Draw a new scene, or drop files on this window.</p>
        )}
        <ul class="cards">
          {state.cases.value
            .filter(own => matches(own.name))
            .slice(0, MOST_CARDS)
            .map(own => (
              <CaseCard own={own} key={own.name} />
            ))}
        </ul>
        <More count={state.cases.value.filter(own => matches(own.name)).length} what="cases" />
      </section>
      <section aria-labelledby="home-results">
        <h2 id="home-results">Results</h2>
        {!results.length && <p class="note">This folder holds no results. Open a case and run it.</p>}
        <ul class="cards">
          {results
            .filter(own => matches(own.path))
            .slice(0, MOST_CARDS)
            .map(own => (
              <li key={own.path}>
                <a class="card" href={state.link('result', own.path)}>
                  <Thumb
                    source={api.address('/api/picture', {
                      result: own.path,
                      ...(own.kind === 'sweep' && { name: 'sweep.svg' }),
                    })}
                  />
                  <b>{name_of_result(own.path)}</b>
                  <span>{[state_of(own), state.when(own.time)].filter(Boolean).join(', ')}</span>
                </a>
              </li>
            ))}
        </ul>
        <More count={results.filter(own => matches(own.path)).length} what="results" />
      </section>
      {tables.length > 0 && (
        <section aria-labelledby="home-tables">
          <h2 id="home-tables">Tables of tests</h2>
          <ul class="links">
            {tables.slice(0, 60).map(own => (
              <li key={own.path}>
                <a href={state.link('study', 'fit', own.path)}>Fit {own.path}</a>
              </li>
            ))}
          </ul>
        </section>
      )}
    </div>
  );
}

function CaseCard({ own }: { own: Case }) {
  return (
    <li>
      <a class="card" href={state.link('case', ...own.paths)}>
        <Thumb
          source={api.address('/api/thumbnail', { path: own.paths[0] })}
          second={api.address('/api/drawing', { path: own.paths[0] })}
        />
        <b>{leaf_of(own.name)}</b>
        <span>
          {folder_of(own.name) ? `${folder_of(own.name)}, ` : ''}
          {state.when(own.time)}
        </span>
      </a>
    </li>
  );
}

/** Cards beyond which a list names the number of the others. */
const MOST_CARDS = 120;

function More({ count, what }: { count: number; what: string }) {
  if (count <= MOST_CARDS) return null;
  return (
    <p class="note">
      {MOST_CARDS} of {count} {what} are shown. The list at the side has all of them, and its filter finds one.
    </p>
  );
}

/** Small picture; the second address serves if the first has none. */
function Thumb({ source, second }: { source: string; second?: string }) {
  const [tries, set_tries] = useState(0);
  const address = [source, second][tries];
  return (
    <span class="thumb">
      {address ? <img alt="" loading="lazy" src={address} onError={() => set_tries(tries + 1)} /> : <em>no drawing</em>}
    </span>
  );
}

/** Saves files into the folder; none is replaced. The first new one is opened. */
async function add_files(files: FileList | null | undefined): Promise<void> {
  const added: string[] = [];
  const all = [...(files ?? [])]; // the list of an input empties when its value does
  for (const file of all) {
    const text = await file.text();
    const saved = await state.attempt(() => api.save(file.name, text));
    if (!saved) break;
    added.push(saved.path);
  }
  await state.refresh();
  const opened = state.cases.value.find(own => own.paths.some(path => added.includes(path)));
  if (opened) state.go(state.link('case', ...opened.paths));
}

function drop(event: DragEvent): void {
  if (!event.dataTransfer?.files.length) return;
  event.preventDefault();
  void add_files(event.dataTransfer.files);
}

window.addEventListener('dragover', event => event.preventDefault());
window.addEventListener('drop', drop);
/** Number of the entry of the history that is shown. New entries have none yet: they follow the one shown. */
let entry: number = history.state?.entry ?? 0;
history.replaceState({ entry }, '');
window.addEventListener('hashchange', () => {
  if (location.hash === state.route.value) return;
  const next: number = history.state?.entry ?? entry + 1;
  const is_unsaved = state.unsaved.value.length > 0;
  if (is_unsaved && !window.confirm('Changes of this case are not saved. Leave it all the same?')) {
    // Returns whence the reader came, forward or back. This raises the event again, with the route shown.
    history.go(entry - next);
    return;
  }
  entry = next;
  history.replaceState({ entry }, '');
  state.route.value = location.hash;
  state.trouble.value = '';
});
window.addEventListener('beforeunload', event => {
  if (state.unsaved.value.length) event.preventDefault();
});

render(<App />, document.getElementById('page')!);
void state.refresh();
state.start_clock();
