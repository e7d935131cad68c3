// Player: buttons, slider with marks of stages, step and time, speed.

import { effect } from '@preact/signals';
import { Icon } from './icons';
import * as state from './state';

/** Frames a second at speed 1: the whole run in about ten seconds, within 4 and 30 frames a second. */
export function base_rate(frames: number): number {
  return Math.max(4, Math.min(30, frames / 10));
}

export function toggle_play(): void {
  const { playing, frame } = state;
  if (!playing.value && frame.value >= state.last_frame()) frame.value = 0;
  playing.value = !playing.value;
}

/** Advances frames while the run plays. Waits where a frame is not decoded. */
export function start_clock(): void {
  let before = 0;
  let due = 0;
  const tick = (now: number) => {
    if (!state.playing.value) return;
    due += ((now - before) / 1000) * base_rate(state.head.frames.length) * state.speed.value;
    before = now;
    const steps = Math.floor(due);
    if (steps > 0) {
      due -= steps;
      const next = state.frame.value + steps;
      const last = state.last_frame();
      if (next > last && state.repeat.value) {
        state.frame.value = 0;
      } else {
        state.frame.value = Math.min(last, next);
        if (next >= last && !state.repeat.value) state.playing.value = false;
      }
    }
    requestAnimationFrame(tick);
  };
  effect(() => {
    if (!state.playing.value) return;
    before = performance.now();
    due = 0;
    requestAnimationFrame(tick);
  });
}

export function Player() {
  void state.edition.value;
  const { head } = state;
  const frame = state.frame.value;
  const own = head.frames[frame];
  const last = state.last_frame();
  const marks = state.marks_of(head);
  const place = state.place_in_run(own);
  const playing = state.playing.value;
  const text = `step ${own.step}${place && `, ${place}`}${own.stage ? `, stage ${own.stage}` : ''}`;
  return (
    <section class="player" aria-label="Player">
      <div class="buttons">
        <Key
          kind={marks.length > 1 ? 'edge' : ''}
          name="first"
          label="First frame"
          hint="Home"
          run={() => state.go_to(0)}
        />
        {marks.length > 1 && <Key name="earlier" label="Stage before" hint="[" run={() => state.jump(-1)} />}
        <Key name="back" label="One frame back" hint="←" run={() => state.go_to(frame - 1)} />
        <button
          type="button"
          class="main"
          title={`${playing ? 'Pause' : 'Play'} (space)`}
          aria-label={playing ? 'Pause' : 'Play'}
          onClick={toggle_play}
        >
          <Icon name={playing ? 'pause' : 'play'} size={20} />
        </button>
        <Key name="forward" label="One frame on" hint="→" run={() => state.go_to(frame + 1)} />
        {marks.length > 1 && <Key name="later" label="Next stage" hint="]" run={() => state.jump(1)} />}
        <Key
          kind={marks.length > 1 ? 'edge' : ''}
          name="last"
          label="Last frame"
          hint="End"
          run={() => state.go_to(last)}
        />
        {state.is_running.value && (
          <button
            type="button"
            class="live"
            aria-pressed={frame === last}
            title="Show each new frame of the run (End)"
            onClick={() => state.go_to(last)}
          >
            Live
          </button>
        )}
      </div>
      <div class="track">
        <input
          type="range"
          min={0}
          max={last}
          step={1}
          value={frame}
          aria-label="Frame"
          aria-valuetext={text}
          style={{ '--share': last ? frame / last : 0 }}
          onInput={event => state.go_to(Number(event.currentTarget.value))}
        />
        {marks.length > 1 && (
          <div class="marks">
            {marks.map((mark, i) => {
              const next = marks[i + 1]?.frame ?? last;
              return (
                <button
                  type="button"
                  key={mark.frame}
                  class={frame >= mark.frame && (frame < next || i === marks.length - 1) ? 'on' : ''}
                  style={{
                    left: `${(100 * mark.frame) / (last || 1)}%`,
                    width: `${(100 * (next - mark.frame)) / (last || 1)}%`,
                  }}
                  title={mark.label}
                  aria-label={`Go to ${mark.label}`}
                  tabIndex={-1}
                  onClick={() => state.go_to(mark.frame)}
                >
                  <span>{mark.label}</span>
                </button>
              );
            })}
          </div>
        )}
      </div>
      <output class="time" aria-live="off">
        <b>{place.replace(/^time /, state.head.units?.time ? '' : 't = ')}</b>
        <span>
          step {own.step} <i>of {head.frames[last].step}</i>
        </span>
      </output>
      <div class="speed">
        <select
          aria-label="Speed"
          value={String(state.speed.value)}
          onChange={event => {
            state.speed.value = Number(event.currentTarget.value);
          }}
        >
          {[0.25, 0.5, 1, 2, 4, 8].map(own_speed => (
            <option value={String(own_speed)} key={own_speed}>
              {own_speed} ×
            </option>
          ))}
        </select>
        <button
          type="button"
          title="Repeat"
          aria-label="Repeat"
          aria-pressed={state.repeat.value}
          onClick={() => {
            state.repeat.value = !state.repeat.value;
          }}
        >
          <Icon name="repeat" />
        </button>
      </div>
    </section>
  );
}

function Key({
  kind = '',
  name,
  label,
  hint,
  run,
}: {
  kind?: string;
  name: string;
  label: string;
  hint: string;
  run: () => void;
}) {
  return (
    <button type="button" class={kind} title={`${label} (${hint})`} aria-label={label} onClick={run}>
      <Icon name={name} />
    </button>
  );
}
