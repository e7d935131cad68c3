// Text of a case, with numbers of lines beside it and completion from the schema.

import { useEffect, useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import { coloured_lines, type Syntax, syntax_of } from './colour_text';
import { type Choice, choices_at, type Names, type Place, place_at } from './complete';
import { in_yaml, place_in_yaml } from './complete_yaml';
import type { Schema } from './schema';

interface Popup {
  place: Place;
  choices: Choice[];
  at: number;
  x: number;
  y: number;
}

const MOST = 80;

/** Longer texts stay plain. */
const MOST_COLOURED = 1_000_000;

export function TextArea({
  box,
  path,
  label,
  value,
  is_ready,
  marks,
  set,
  schema,
  names,
}: {
  box: { current: HTMLTextAreaElement | null };
  /** Name of the file, which tells its syntax. */
  path: string;
  label: string;
  value: string;
  is_ready: boolean;
  marks: { line: number; is_error: boolean }[];
  set: (text: string, caret: [number, number]) => void;
  schema: Schema | null;
  names: Names;
}) {
  const gutter = useRef<HTMLPreElement>(null);
  const list = useRef<HTMLDivElement>(null);
  const caret = useRef<number | null>(null);
  const [popup, set_popup] = useState<Popup | null>(null);

  useLayoutEffect(() => {
    if (caret.current === null || !box.current) return;
    box.current.setSelectionRange(caret.current, caret.current);
    caret.current = null;
  }, [value]);
  useEffect(() => {
    list.current?.querySelector('[aria-selected="true"]')?.scrollIntoView({ block: 'nearest' });
  }, [popup?.at]);

  /** Shows what can stand at the caret. */
  const offer = (own: HTMLTextAreaElement, is_asked = false) => {
    if (!schema) return;
    const is_yaml = syntax_of(path) === 'yaml';
    const place = is_yaml
      ? place_in_yaml(own.value, own.selectionStart, schema)
      : place_at(own.value, own.selectionStart);
    const at = (one: Place) => {
      const found = choices_at(schema, one, names).slice(0, MOST);
      return is_yaml ? in_yaml(found, one) : found;
    };
    let choices = place ? at(place) : [];
    // Within a whole word, all others are offered on request.
    if (is_asked && place && choices.length < 2) choices = at({ ...place, typed: '' });
    if (!place || !choices.length || (choices.length === 1 && choices[0].label === place.typed)) return set_popup(null);
    set_popup({ place, choices, at: 0, ...corner_of(own, place.from) });
  };

  const take = (choice: Choice) => {
    const own = box.current;
    if (!own || !popup) return;
    const { from, to, kind } = popup.place;
    const has_colon = kind === 'key' && /^\s*:/.test(own.value.slice(to));
    const text = has_colon ? choice.text.slice(0, choice.text.indexOf(':')) : choice.text;
    const inside = /(\{\}|\[\])$/.test(text) ? 1 : 0;
    caret.current = from + text.length - inside;
    set_popup(null);
    set(own.value.slice(0, from) + text + own.value.slice(to), [caret.current, caret.current]);
    own.focus();
  };

  const key = (event: KeyboardEvent) => {
    const own = event.currentTarget as HTMLTextAreaElement;
    if (event.key === ' ' && event.ctrlKey) {
      event.preventDefault();
      return offer(own, true);
    }
    if (!popup) return;
    const { choices, at } = popup;
    const move = (to: number) => set_popup({ ...popup, at: (to + choices.length) % choices.length });
    if (event.key === 'ArrowDown') move(at + 1);
    else if (event.key === 'ArrowUp') move(at - 1);
    else if (event.key === 'Enter' || event.key === 'Tab') take(choices[at]);
    else if (event.key === 'Escape') set_popup(null);
    else {
      if (/^(Arrow|Home|End|Page)/.test(event.key)) set_popup(null);
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  };

  const lines = value.split('\n').length;
  const kinds = new Map<number, boolean>();
  for (const mark of marks) kinds.set(mark.line, mark.is_error || kinds.get(mark.line) === true);
  const numbers = [];
  for (let l = 1; l <= lines; l++) {
    const mark = kinds.get(l);
    numbers.push(mark === undefined ? `${l}\n` : <b class={mark ? 'bad' : 'warn'}>{`${l}\n`}</b>);
  }
  const syntax = value.length > MOST_COLOURED ? null : syntax_of(path);
  return (
    <div class={syntax ? 'text coloured' : 'text'}>
      <pre class="lines" ref={gutter} aria-hidden="true">
        {numbers}
      </pre>
      {syntax && <Colours box={box} value={value} syntax={syntax} />}
      <textarea
        ref={box}
        aria-label={label}
        aria-autocomplete="list"
        aria-controls={popup ? 'choices' : undefined}
        aria-activedescendant={popup ? `choice-${popup.at}` : undefined}
        spellcheck={false}
        autocomplete="off"
        wrap="off"
        value={value}
        readOnly={!is_ready}
        onInput={event => {
          const own = event.currentTarget;
          set(own.value, [own.selectionStart, own.selectionEnd]);
          const typed = (event as InputEvent).data ?? '';
          if (popup || /^[\w"]$/.test(typed)) offer(own);
        }}
        onKeyDown={key}
        onBlur={() => set_popup(null)}
        onClick={() => set_popup(null)}
        onScroll={event => {
          if (gutter.current) gutter.current.scrollTop = event.currentTarget.scrollTop;
          if (popup) set_popup(null);
        }}
      />
      {popup && (
        <div class="choices" style={{ left: `${popup.x}px`, top: `${popup.y}px` }}>
          <div id="choices" role="listbox" aria-label="Choices" ref={list}>
            {popup.choices.map((one, i) => (
              // biome-ignore lint/a11y/useFocusableInteractive: the text keeps the focus and names the active choice.
              // biome-ignore lint/a11y/useKeyWithClickEvents: keys are read by the text.
              <div
                role="option"
                id={`choice-${i}`}
                key={one.label}
                aria-selected={i === popup.at}
                onMouseDown={event => event.preventDefault()}
                onClick={() => take(one)}
              >
                {one.label}
              </div>
            ))}
          </div>
          {popup.choices[popup.at].meaning && <p>{popup.choices[popup.at].meaning}</p>}
        </div>
      )}
    </div>
  );
}

/** Coloured copy of the lines in view, behind the text. */
function Colours({
  box,
  value,
  syntax,
}: {
  box: { current: HTMLTextAreaElement | null };
  value: string;
  syntax: Syntax;
}) {
  const [view, set_view] = useState({ top: 0, left: 0, height: 900, line: 20 });
  const lines = useMemo(() => coloured_lines(value, syntax), [value, syntax]);
  useEffect(() => {
    const own = box.current;
    if (!own) return;
    const look = () =>
      set_view({
        top: own.scrollTop,
        left: own.scrollLeft,
        height: own.clientHeight,
        line: Number.parseFloat(getComputedStyle(own).lineHeight) || 20,
      });
    look();
    own.addEventListener('scroll', look);
    const sizes = new ResizeObserver(look);
    sizes.observe(own);
    return () => {
      own.removeEventListener('scroll', look);
      sizes.disconnect();
    };
  }, []);
  const first = Math.max(0, Math.floor(view.top / view.line) - 1);
  const last = first + Math.ceil(view.height / view.line) + 3;
  return (
    <div class="colours" aria-hidden="true">
      <pre style={{ transform: `translate(${-view.left}px, ${first * view.line - view.top}px)` }}>
        {lines.slice(first, last).map((line, i) => (
          <div key={first + i}>
            {line.length === 0
              ? '\n'
              : line.map(([kind, part], j) =>
                  kind ? (
                    <i class={`c-${kind}`} key={j}>
                      {part}
                    </i>
                  ) : (
                    part
                  ),
                )}
          </div>
        ))}
      </pre>
    </div>
  );
}

/** Place below a letter of the text, within the box around it. */
function corner_of(own: HTMLTextAreaElement, at: number): { x: number; y: number } {
  const style = getComputedStyle(own);
  const c = document.createElement('canvas').getContext('2d')!;
  c.font = `${style.fontSize} ${style.fontFamily}`;
  const before = own.value.slice(0, at);
  const line = before.slice(before.lastIndexOf('\n') + 1).replace(/\t/g, '  ');
  const row = before.split('\n').length;
  const height = Number.parseFloat(style.lineHeight);
  const box = own.parentElement!;
  const x = own.offsetLeft + Number.parseFloat(style.paddingLeft) + c.measureText(line).width - own.scrollLeft;
  const y = own.offsetTop + Number.parseFloat(style.paddingTop) + row * height - own.scrollTop;
  const is_low = y + 190 > box.clientHeight && y > box.clientHeight / 2;
  return {
    x: Math.max(4, Math.min(x, box.clientWidth - 340)),
    y: is_low ? Math.max(0, y - height - 190) : y,
  };
}
