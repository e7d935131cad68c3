// The page: header, drawing, player, tabs.

import { useEffect, useRef } from 'preact/hooks';
import { capital } from '../draw/words';
import { BlocksTab } from './blocks';
import { ChosenTab } from './chosen';
import { CurvesTab } from './curves';
import { Drawing } from './drawing';
import {
  cancel_video,
  save_blocks_csv,
  save_contacts_csv,
  save_png,
  save_svg,
  save_video,
  video_kind,
} from './exports';
import { caption_of } from './figure';
import { Icon } from './icons';
import { KEYS } from './keys';
import { base_rate, Player } from './player';
import { RunTab, record_sentence } from './run';
import { ShowTab } from './show';
import * as state from './state';

const TABS: [state.Tab, string][] = [
  ['show', 'Show'],
  ['chosen', 'Chosen'],
  ['curves', 'Curves'],
  ['run', 'Run'],
  ['blocks', 'Blocks'],
];

/** True if the page is one of two side by side: the window about it has the player and the options. */
export const is_bare = location.hash === '#bare';

export function App() {
  return (
    <div class={`page${is_bare ? ' bare' : ''}`}>
      <Header key={`header ${state.edition.value}`} />
      <main>
        <div class="stage">
          <Drawing />
          <p class="print-only caption">{caption_of(state.frame.value, state.magnification.value)}</p>
          <Player />
        </div>
        <Side key={`side ${state.edition.value}`} />
      </main>
      {state.help_open.value && <Help />}
      {state.recording.value && (
        <div class="recording" role="status">
          <span>
            Recording frame {state.frame.value + 1} of {state.last_frame() + 1}
          </span>
          <button type="button" class="small" onClick={cancel_video}>
            Stop
          </button>
        </div>
      )}
      {state.failure.value && (
        <p class="failure" role="alert">
          {state.failure.value}
        </p>
      )}
    </div>
  );
}

const RUNNING = { tone: 'plain', words: 'running', reason: '' };

function Header() {
  const { head } = state;
  const verdict = state.is_running.value ? RUNNING : head.verdict;
  const dark = state.is_dark.value;
  return (
    <header>
      <div class="title">
        <h1>{head.title}</h1>
        <p>{head.program}</p>
      </div>
      <button
        type="button"
        class={`badge ${verdict.tone}`}
        title="Show the result of the run"
        onClick={() => {
          state.tab.value = 'run';
        }}
      >
        <Icon name={verdict.tone === 'good' ? 'good' : verdict.tone === 'plain' ? 'fit' : 'warn'} size={15} />
        <span>{capital(verdict.words)}</span>
      </button>
      {verdict.reason && <p class="reason">{record_sentence(verdict.reason)}</p>}
      <div class="actions">
        <SaveMenu />
        <button
          type="button"
          class="icon"
          title={dark ? 'Light theme' : 'Dark theme'}
          aria-label={dark ? 'Light theme' : 'Dark theme'}
          onClick={() => {
            state.theme.value = dark ? 'light' : 'dark';
          }}
        >
          <Icon name={dark ? 'sun' : 'moon'} />
        </button>
        <button
          type="button"
          class="icon"
          title="Help (?)"
          aria-label="Help"
          onClick={() => {
            state.help_open.value = true;
          }}
        >
          <Icon name="help" />
        </button>
      </div>
    </header>
  );
}

function SaveMenu() {
  const menu = useRef<HTMLDetailsElement>(null);
  useEffect(() => {
    const close = (event: Event) => {
      if (menu.current?.open && !menu.current.contains(event.target as Node)) menu.current.open = false;
    };
    const on_escape = (event: KeyboardEvent) => {
      if (event.key === 'Escape' && menu.current) menu.current.open = false;
    };
    document.addEventListener('pointerdown', close);
    document.addEventListener('keydown', on_escape);
    return () => {
      document.removeEventListener('pointerdown', close);
      document.removeEventListener('keydown', on_escape);
    };
  }, []);
  const item = (label: string, note: string, run: () => void | Promise<void>) => (
    <button
      type="button"
      onClick={() => {
        if (menu.current) menu.current.open = false;
        void state.attempt(async () => {
          // A file must not lack what is not decoded yet.
          await state.store.need_frame(state.frame.value, state.store.kinds());
          await run();
        });
      }}
    >
      <b>{label}</b>
      <span>{note}</span>
    </button>
  );
  const kind = video_kind();
  return (
    <details class="menu" ref={menu}>
      <summary title="Save">
        <Icon name="save" />
        <span>Save</span>
      </summary>
      <div class="menu-list">
        {item('Picture, PNG', 'as drawn, twice the resolution', save_png)}
        {item('Drawing, SVG', 'as drawn, for papers', save_svg)}
        {item('Blocks, CSV', 'all values of this frame', save_blocks_csv)}
        {state.store.has('contacts') && item('Contacts, CSV', 'closed contacts of this frame', save_contacts_csv)}
        {kind &&
          item(`Video, ${kind.includes('mp4') ? 'MP4' : 'WebM'}`, 'all frames at the speed of the player', () =>
            save_video(base_rate(state.head.frames.length) * state.speed.value),
          )}
        {item('Print', 'drawing and record of the run', () => window.print())}
      </div>
    </details>
  );
}

function Side() {
  const current = state.tab.value;
  const move = (event: KeyboardEvent) => {
    const index = TABS.findIndex(([id]) => id === current);
    const next =
      event.key === 'ArrowRight'
        ? (index + 1) % TABS.length
        : event.key === 'ArrowLeft'
          ? (index + TABS.length - 1) % TABS.length
          : event.key === 'Home'
            ? 0
            : event.key === 'End'
              ? TABS.length - 1
              : -1;
    if (next < 0) return;
    event.preventDefault();
    state.tab.value = TABS[next][0];
    document.getElementById(`tab-${TABS[next][0]}`)?.focus();
  };
  return (
    <aside aria-label="Options and results">
      <div class="tabs" role="tablist" aria-label="Panels" onKeyDown={move}>
        {TABS.map(([id, label]) => (
          <button
            type="button"
            role="tab"
            key={id}
            id={`tab-${id}`}
            aria-selected={current === id}
            aria-controls={`panel-${id}`}
            tabIndex={current === id ? 0 : -1}
            onClick={() => {
              state.tab.value = id;
            }}
          >
            {label}
          </button>
        ))}
      </div>
      {TABS.map(([id]) => (
        <div
          class={`panel panel-${id}`}
          role="tabpanel"
          key={id}
          id={`panel-${id}`}
          aria-labelledby={`tab-${id}`}
          hidden={current !== id}
          tabIndex={0}
        >
          {id === 'show' && <ShowTab />}
          {id === 'chosen' && current === 'chosen' && <ChosenTab />}
          {id === 'curves' && current === 'curves' && <CurvesTab />}
          {id === 'run' && <RunTab />}
          {id === 'blocks' && current === 'blocks' && <BlocksTab />}
        </div>
      ))}
    </aside>
  );
}

function Help() {
  const box = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    box.current?.showModal();
  }, []);
  const close = () => {
    state.help_open.value = false;
  };
  return (
    <dialog ref={box} class="help" aria-labelledby="help-title" onClose={close}>
      <div class="help-head">
        <h2 id="help-title">Help</h2>
        <button type="button" class="icon" aria-label="Close" onClick={close}>
          <Icon name="close" />
        </button>
      </div>
      <p>
        Drag to move the view. Turn the wheel, or pinch, to zoom. Click a block, contact, bolt, crack or point to see
        its values and history.
      </p>
      <p>Hatched blocks are fixed. Stresses are positive in tension.</p>
      <h3>Keys</h3>
      <dl>
        {KEYS.map(([keys, text]) => (
          <div key={keys}>
            <dt>
              {keys.split(' ').map(key => (
                <kbd key={key}>{key}</kbd>
              ))}
            </dt>
            <dd>{text}</dd>
          </div>
        ))}
      </dl>
      <p class="note">{state.head.precision}</p>
      <p class="note renderer">
        Bodies are drawn by {state.renderer.value.name}
        {state.renderer.value.reason && ` (${state.renderer.value.reason})`}.
      </p>
      <p class="note">This page makes no request: all data are in this file.</p>
    </dialog>
  );
}
