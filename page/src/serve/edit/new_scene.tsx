// A new scene from nothing: outline, joint sets, materials and supports, with the drawing beside it.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import * as api from '../api';
import { new_result, stem_of } from '../cases';
import { ChoiceField, TextField } from '../fields';
import * as state from '../state';
import { Canvas } from './canvas';
import type { Path } from './case_text';
import { PlaceBox } from './editor';
import type { Point, Polygon } from './scene';
import { scene_of } from './scene';
import { meaning_of, schema_at, title_of, with_titles } from './schema';
import { fault_of, first_form, form_in_metres, OUTLINE_KEYS, type SceneForm, scene_text, spec_of } from './sets';
import { SetsForm, words_at } from './sets_form';
import { tool_of } from './tools';

type Texts = { [K in keyof SceneForm]: SceneForm[K] extends string ? K : never }[keyof SceneForm];

const SHAPES: SceneForm['kind'][] = ['slope', 'rectangle', 'drawn'];

/** Scene of the form as text, with its blocks; drawn and checked anew after a pause. */
function useDrawn(form: SceneForm) {
  const schema = state.joint_schema.value;
  const fault = fault_of(form, schema);
  const [text, set_text] = useState('');
  const [blocks, set_blocks] = useState<Polygon[]>([]);
  const [status, set_status] = useState({ words: '', is_bad: false });
  const [drawn_for, set_drawn_for] = useState('');
  const [version, set_version] = useState(0);
  const key = JSON.stringify(form);
  const asked = useRef(0);
  const refuse = (words: string) =>
    set_status({ words: with_titles(words, [state.joint_schema.value, state.schema.value]), is_bad: true });
  useEffect(() => {
    const number = ++asked.current;
    if (fault) {
      refuse(fault);
      return;
    }
    const timer = setTimeout(async () => {
      try {
        const drawn = await api.joints(spec_of(form));
        if (number !== asked.current) return;
        if (!drawn.joints) return refuse(drawn.errors?.[0]?.sentence ?? 'The joints cannot be drawn.');
        const made = scene_text(form, drawn);
        set_text(made);
        set_version(before => before + 1);
        const [cut, report] = await Promise.all([
          api.blocks('scene.json', made),
          api.check(['scene.json'], '', {}, false, made),
        ]);
        if (number !== asked.current) return;
        set_blocks(cut.blocks ?? []);
        const error = report.errors[0] ?? cut.errors?.[0];
        if (error) return refuse(error.sentence);
        set_status({ words: `${cut.blocks?.length ?? 0} blocks`, is_bad: false });
        set_drawn_for(key);
      } catch (error) {
        refuse((error as Error).message);
      }
    }, 250);
    return () => clearTimeout(timer);
  }, [key, fault]);
  return { text, blocks, status, fault, is_ready: !fault && drawn_for === key, version };
}

export function NewScene() {
  const [form, set_form] = useState<SceneForm>(first_form);
  const [draft, set_draft] = useState<Point[]>([]);
  const [name, set_name] = useState('');
  const [library, set_library] = useState<string[]>(['limestone']);
  const { text, blocks, status, fault, is_ready, version } = useDrawn(form_in_metres(form));
  const is_drawn = form.kind === 'drawn';
  // An outline by hand begins on an empty sheet.
  const shown = is_drawn && form.corners.length < 3 ? '' : text;
  const scene = useMemo(() => scene_of(shown || '{}'), [shown]);

  useEffect(() => {
    state.read_schema();
    void state.attempt(api.materials).then(own => {
      if (own) set_library(own.block_materials.map(rock => String(rock.like)));
    });
  }, []);

  const taken = (state.listing.value?.files ?? []).map(own => stem_of(own.path));
  const suggestion = `${new_result('scene', taken)}.json`;
  const put = (change: Partial<SceneForm>) => set_form(before => ({ ...before, ...change }));
  const of_outline = (key: Texts) => {
    const { label, title } = words_at(state.joint_schema.value, [form.kind, key], 'm');
    return field(key, label, title);
  };
  const field = (key: Texts, label: string, title: string, is_number = true) => (
    <TextField
      key={key}
      is_small
      label={label}
      title={title}
      is_number={is_number}
      value={form[key]}
      placeholder={key === 'youngs_modulus' ? 'of the library' : ''}
      set={own => put({ [key]: own })}
    />
  );
  // Title and meaning of a value of the case that the scene becomes.
  const of_case = (key: Texts, path: Path, words: string, is_number = false) => {
    const own = state.schema.value ? schema_at(state.schema.value, path) : undefined;
    return field(key, title_of(String(path.at(-1)), own), own ? `${meaning_of(own)} ${words}` : words, is_number);
  };

  const create = async (event: Event) => {
    event.preventDefault();
    if (!is_ready) return;
    const path = name.trim() || suggestion;
    const saved = await state.attempt(() => api.save(/\.json$/i.test(path) ? path : `${path}.json`, text));
    if (!saved) return;
    await state.refresh();
    state.go(state.link('case', saved.path));
  };

  return (
    <div class="case">
      <section class="editor new" aria-label="Drawing">
        <div class="bar">
          <h2>New scene</h2>
        </div>
        <div class="edit-draw">
          <div class="edit-strip">
            <p class="edit-hint" id="canvas-hint">
              {is_drawn ? tool_of('outline').hint : 'The drawing follows the form. Corners can be changed later.'}
            </p>
            {is_drawn && (
              <PlaceBox
                last={draft.at(-1) ?? null}
                add={point => set_draft([...draft, point])}
                close={() => {
                  if (draft.length > 2) put({ corners: draft });
                  set_draft([]);
                }}
                cancel={() => set_draft([])}
              />
            )}
          </div>
          <Canvas
            scene={scene}
            blocks={fault ? [] : blocks}
            tool={is_drawn ? tool_of('outline') : tool_of('select')}
            chosen={NOTHING}
            choose={() => {}}
            draft={draft}
            set_draft={set_draft}
            finish={corners => {
              set_draft([]);
              put({ corners });
            }}
            move_points={() => {}}
            move_items={() => {}}
            material={item => scene.joint_materials.indexOf(String(row_material(scene, item.path))) + 1 || 1}
            force={() => null}
            is_snapping={true}
            has_grid={true}
            has_numbers={false}
            fit={is_drawn ? 0 : version}
            pointed={() => {}}
            keys={event => {
              if (event.key === 'Escape') set_draft([]);
            }}
            label="Drawing of the scene"
          />
          <div class="edit-state">
            <span class={status.is_bad ? 'bad' : ''} aria-live="polite">
              {status.words}
            </span>
          </div>
        </div>
      </section>
      <form class="plan" aria-label="Scene" onSubmit={create}>
        <div class="group">
          <h2>Outline</h2>
          <fieldset class="modes" aria-label="Shape">
            {SHAPES.map(kind => (
              <label class={form.kind === kind ? 'on' : ''} key={kind}>
                <input type="radio" name="shape" checked={form.kind === kind} onChange={() => put({ kind })} />
                {kind === 'drawn' ? 'Drawn by hand' : words_at(state.joint_schema.value, [kind], 'm').label}
              </label>
            ))}
          </fieldset>
          {OUTLINE_KEYS[form.kind].length > 0 && <div class="pairs">{OUTLINE_KEYS[form.kind].map(of_outline)}</div>}
          <label class="edit-toggle">
            <input
              type="checkbox"
              checked={form.is_fixed}
              onChange={event => put({ is_fixed: event.currentTarget.checked })}
            />
            Fix base and sides
          </label>
        </div>
        <div class="group sets">
          <h2>Joints</h2>
          <SetsForm
            sets={form.sets}
            set_sets={sets => put({ sets })}
            seed={form.seed}
            set_seed={seed => put({ seed })}
            length="m"
            has_strength={true}
          />
        </div>
        <div class="group">
          <h2>Rock and run</h2>
          <div class="pairs">
            <ChoiceField
              is_small
              label="Rock"
              title="Entry of the library of materials"
              value={form.rock}
              set={rock => put({ rock })}
              choices={library}
            />
            {of_case(
              'youngs_modulus',
              ['analysis', 'block_materials', 0, 'youngs_modulus'],
              'With its unit, such as 5 GPa; empty: of the library.',
            )}
            {of_case('gravity', ['analysis', 'gravity'], 'With its unit.')}
            {of_case('steps', ['analysis', 'step_count'], '', true)}
            {of_case('time_step', ['analysis', 'time_step'], 'With its unit, such as 1 ms.')}
          </div>
        </div>
        <div class="group">
          <TextField label="File" value={name} placeholder={suggestion} set={set_name} />
          <div class="row wide">
            <span class="space" />
            <button type="submit" class="small strong" disabled={!is_ready}>
              Create the case
            </button>
          </div>
        </div>
      </form>
    </div>
  );
}

const NOTHING: ReadonlySet<string> = new Set();

function row_material(scene: ReturnType<typeof scene_of>, path: (string | number)[]): unknown {
  const index = Number(path.at(-1));
  const row = scene.root.items[scene.root.keys.findIndex(key => key.name === 'drawing')];
  const joints = row?.items[row.keys.findIndex(key => key.name === 'joints')];
  return joints?.items[index]?.items[4]?.value;
}
