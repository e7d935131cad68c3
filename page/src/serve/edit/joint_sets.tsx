// Joint sets of a case: a form whose joints appear in the drawing at once.

import { useEffect, useRef, useState } from 'preact/hooks';
import * as api from '../api';
import * as state from '../state';
import { find, plain, type Value } from './case_text';
import { material_of, put_joints } from './edits';
import { loops_of, type Scene, scene_of } from './scene';
import {
  fault_of_set,
  type JointSet,
  named_rows,
  new_set,
  note_of,
  rounded_rows,
  set_in_unit,
  set_spec,
  sets_in,
  size_of,
  with_note,
  without_note,
} from './sets';
import { SetsForm } from './sets_form';

export function JointSets({
  text,
  latest,
  scene,
  change,
  close,
}: {
  text: string;
  /** Returns the text as it is now, also before it is shown. */
  latest: () => string;
  scene: Scene;
  change: (text: string, tag: string) => void;
  close: () => void;
}) {
  const base = useRef(text);
  /** True once something else than this form has changed the text. */
  const has_others = useRef(false);
  /** Last text of this form, and the number of joints that it holds for the form. */
  const last = useRef(text);
  const original = useRef<Value[]>([]);
  const mine = useRef(-1);
  if (mine.current < 0) {
    const rows = plain(find(scene.root, ['drawing', 'joints']));
    original.current = Array.isArray(rows) ? rows.slice(scene.boundary_count) : [];
    mine.current = original.current.length;
  }
  const [before] = useState(() => sets_in(text));
  const names = scene.joint_materials.length ? scene.joint_materials : ['joint 1'];
  const [sets, set_sets] = useState<JointSet[]>(
    () =>
      before?.sets.map(own => ({ ...own, name: names.includes(own.name) ? own.name : names[0] })) ?? [
        { ...new_set(1), dip: '35', name: names[0] },
        { ...new_set(2), dip: '118', name: names[Math.min(1, names.length - 1)] },
      ],
  );
  const [seed, set_seed] = useState(before?.seed ?? '1');
  const [replaces, set_replaces] = useState(true);
  const [words, set_words] = useState('');
  const asked = useRef(0);

  /** Puts rows in place of those that the form wrote before; other changes of the text stay. */
  const put = (rows: Value[], added: number) => {
    const now = latest();
    if (now !== last.current) has_others.current = true;
    const next = placed(now, rows, mine.current, added, note_of(sets, seed));
    mine.current = rows.length;
    last.current = next;
    change(next, 'sets');
  };

  const draw = async () => {
    const number = ++asked.current;
    let own: Scene;
    try {
      own = scene_of(latest());
    } catch {
      return set_words('The text has a fault: correct it first.');
    }
    const loops = loops_of(own);
    if (!loops.length) return set_words('Draw an outline first.');
    const in_case = sets.map(set => set_in_unit(set, own.length));
    const specs = in_case.map(set => set_spec(set, Math.max(0, names.indexOf(set.name)) + 1));
    const fault = in_case.map(set => fault_of_set(set, size_of(loops[0]), state.joint_schema.value)).find(Boolean);
    if (fault) return set_words(fault);
    let reply: api.JointRows;
    try {
      reply = await api.joints({ outline: loops[0], sets: specs, seed: Number(seed) || 0 });
    } catch (error) {
      return set_words((error as Error).message);
    }
    if (number !== asked.current) return;
    if (!reply.joints) return set_words(reply.errors?.[0]?.sentence ?? 'The joints cannot be drawn.');
    const rows = rounded_rows(reply.joints.slice(reply.boundary_count ?? 0));
    const values = named_rows(
      rows,
      own.joint_materials.map((_, i) => material_of(own.joint_materials, i, 'joint')),
    );
    set_words(`${rows.length} joints`);
    put(replaces ? values : [...original.current, ...values], values.length);
  };

  useEffect(state.read_schema, []);
  useEffect(() => {
    const timer = setTimeout(() => void draw(), 250);
    return () => clearTimeout(timer);
  }, [sets, seed, replaces]);

  return (
    <div class="group sets">
      <h2>Joint sets</h2>
      <SetsForm
        sets={sets}
        set_sets={set_sets}
        seed={seed}
        set_seed={set_seed}
        length={scene.length}
        has_strength={false}
        names={names}
      />
      <label class="edit-toggle">
        <input type="checkbox" checked={replaces} onChange={event => set_replaces(event.currentTarget.checked)} />
        Replace the joints that the drawing has
      </label>
      <p class="note" aria-live="polite">
        {words}
      </p>
      <div class="row wide">
        <span class="space" />
        <button
          type="button"
          class="small"
          onClick={() => {
            asked.current++;
            if (latest() === last.current && !has_others.current) change(base.current, 'sets');
            else put(original.current, 0);
            close();
          }}
        >
          Cancel
        </button>
        <button type="button" class="small strong" onClick={close}>
          Keep
        </button>
      </div>
    </div>
  );
}

/** Puts joints into a text; files with comments keep a note on the sets before the `added` last ones. */
function placed(text: string, rows: Value[], count: number, added: number, note: string): string {
  const has_comments = /^\s*\/\//m.test(text);
  const result = put_joints(without_note(text), rows, count);
  if (!has_comments || !added) return result;
  const own = scene_of(result);
  const first = find(own.root, ['drawing', 'joints', own.boundary_count + rows.length - added]);
  return first ? with_note(result, first.from, note) : result;
}
