// Text of a case, with numbers of lines beside it.

import { useRef } from 'preact/hooks';

/** Text with numbers of lines beside it. */
export function TextArea({
  box,
  label,
  value,
  is_ready,
  marks,
  set,
}: {
  box: { current: HTMLTextAreaElement | null };
  label: string;
  value: string;
  is_ready: boolean;
  marks: { line: number; is_error: boolean }[];
  set: (text: string, caret: [number, number]) => void;
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
        onInput={event => {
          const own = event.currentTarget;
          set(own.value, [own.selectionStart, own.selectionEnd]);
        }}
        onScroll={event => {
          if (gutter.current) gutter.current.scrollTop = event.currentTarget.scrollTop;
        }}
      />
    </div>
  );
}
