// Dialog that saves a case under another name, or as another format of the family.

import { useEffect, useRef, useState } from 'preact/hooks';
import * as api from '../api';
import { cases_of, leaf_of, stem_of } from '../cases';
import { ChoiceField, TextField } from '../fields';
import * as state from '../state';

/** Formats that a case can be written as: word of the program, name, ending. Pairs of files have no ending. */
const FORMATS: [string, string, string][] = [
  ['keyblock-case', 'Keyblock case', '.json'],
  ['dxf', 'DXF drawing', '.dxf'],
  ['ddaml', 'DDAML', '.xml'],
  ['berkeley', 'Berkeley DDA, two files', ''],
  ['shi', "Shi's DDA, two files", ''],
  ['manifold', "Shi's manifold program, two files", ''],
  ['vtk', 'VTK, for ParaView', '.vtu'],
];

export function SaveAs({
  paths,
  current,
  text,
  save,
  close,
}: {
  paths: string[];
  current: string;
  text: string;
  /** Saves the changed files but one. */
  save: (but?: string) => Promise<boolean>;
  close: () => void;
}) {
  const ending = current.slice(stem_of(current).length);
  const [format, set_format] = useState('');
  const [name, set_name] = useState(`${stem_of(current)}_new${ending}`);
  const [done, set_done] = useState<api.Converted | null>(null);
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => dialog.current?.showModal(), []);

  const choose = (own: string) => {
    set_format(own);
    const found = FORMATS.find(([word]) => word === own);
    set_name(stem_of(name) + (found ? found[2] : ending));
  };

  const write = async (event: Event) => {
    event.preventDefault();
    if (!(await save(format ? '' : current))) return close();
    if (!format) {
      const saved = await state.attempt(() => api.save(name, text));
      if (!saved) return close();
      await state.refresh();
      // The text is saved under its new name: this view may be left without a question.
      state.unsaved.value = [];
      close();
      return state.go(state.link('case', ...paths.map(own => (own === current ? saved.path : own))));
    }
    const written = await state.attempt(() => api.convert(paths, name, format));
    await state.refresh();
    if (!written) return close();
    set_done(written);
  };

  return (
    <dialog class="dialog" ref={dialog} onClose={close} aria-labelledby="save-as">
      <form onSubmit={write}>
        <h2 id="save-as">Save {leaf_of(current)} as</h2>
        <ChoiceField
          label="Format"
          value={format}
          set={choose}
          choices={[['', 'the same'], ...FORMATS.map(([word, label]): [string, string] => [word, label])]}
        />
        <TextField label="File" is_required value={name} set={set_name} />
        {format !== '' && <p class="note">Changes are saved first. The program lists what the format cannot hold.</p>}
        {done && <Written done={done} close={() => dialog.current?.close()} />}
        <div class="row wide">
          <span class="space" />
          <button type="button" class="small" onClick={() => dialog.current?.close()}>
            {done ? 'Close' : 'Cancel'}
          </button>
          <button type="submit" class="small strong">
            Save
          </button>
        </div>
      </form>
    </dialog>
  );
}

/** Names the written files, with a link to the case that they are, and says what they do not hold. */
function Written({ done, close }: { done: api.Converted; close: () => void }) {
  const inputs = new Set(cases_of(state.listing.value?.files ?? []).flatMap(own => own.paths));
  const words = [...done.changes, done.messages.trim()].filter(own => own).join('\n');
  return (
    <div role="status">
      {done.files.length > 0 && (
        <p>
          Written: {done.files.join(', ')}.{' '}
          {done.files.every(own => inputs.has(own)) && (
            <a href={state.link('case', ...done.files)} onClick={close}>
              Open
            </a>
          )}
        </p>
      )}
      {words && <pre class="messages">{words}</pre>}
    </div>
  );
}
