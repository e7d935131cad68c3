// Drawing of a case: tools, canvas, numbers of what is chosen. Every change becomes a change of the text.

import { type Signal, useSignal } from '@preact/signals';
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { hint_of as hint_of_value } from '../fields';
import * as state from '../state';
import { Canvas } from './canvas';
import { find, type Value } from './case_text';
import { Chosen, Held } from './chosen';
import * as edits from './edits';
import { type Item, loops_of, type Point, type Polygon, quantity_of, type Scene, title_of, value_of } from './scene';
import { fault_in, schema_at } from './schema';
import { type Snapped, typed_point } from './snap';
import { hint_of, is_for, points_of, TOOLS, type Tool, type ToolName, tool_of } from './tools';

export interface EditorProps {
  text: string;
  scene: Scene;
  /** True if the drawing shown is older than the text, which has a fault. */
  is_old: boolean;
  blocks: Polygon[];
  /** Sentence on the blocks: their number, or why there are none. */
  status: string;
  change: (text: string) => void;
  undo: () => void;
  redo: () => void;
  can_undo: boolean;
  can_redo: boolean;
  fit: number;
  open_sets: () => void;
}

const SNAPS = { end: '(end)', crossing: '(crossing)', line: '(on a line)', grid: '(grid)', free: '' };

interface Pointed {
  own: Snapped | null;
  grid: number;
}

/** Place of the pointer. It changes often, so that nothing else is drawn with it. */
function Where({ pointed, length }: { pointed: Signal<Pointed>; length: string }) {
  const { own, grid } = pointed.value;
  const unit = length ? ` ${length}` : '';
  const shown = (x: number) => String(Number(x.toPrecision(8)));
  return (
    <span class="edit-where">
      {own ? `${shown(own.point[0])}, ${shown(own.point[1])}${unit} ${SNAPS[own.kind]}` : `grid ${shown(grid)}${unit}`}
    </span>
  );
}

export function Editor(props: EditorProps) {
  const { text, scene, blocks, change } = props;
  const [name, set_name] = useState<ToolName>('select');
  const [chosen, set_chosen] = useState<ReadonlySet<string>>(new Set());
  const [draft, set_draft] = useState<Point[]>([]);
  const [last, set_last] = useState<Point | null>(null);
  const [is_snapping, set_snapping] = useState(true);
  const [has_grid, set_grid] = useState(true);
  const [has_numbers, set_numbers] = useState(false);
  const pointed = useSignal<Pointed>({ own: null, grid: 1 });
  const [said, set_said] = useState('');
  const options = useOptions(scene);
  const typed = useRef<HTMLInputElement>(null);

  const tool = tool_of(name);
  const is_usable = (own: Tool) => is_for(own, scene) && (own.name === 'select' || !props.is_old);
  const items = useMemo(() => new Map(scene.items.map(own => [own.key, own])), [scene]);
  const selected = [...chosen].map(key => items.get(key)).filter(own => own !== undefined);

  useEffect(() => {
    if (!is_usable(tool)) set_name('select');
  }, [scene.geometry, props.is_old]);

  const take = (own: ToolName) => {
    if (!is_usable(tool_of(own))) return;
    set_name(own);
    set_draft([]);
    if (own !== 'select') set_chosen(new Set());
  };

  /** Changes the text; with words, they are read to those who do not see the canvas. */
  const apply = (next: string, words: string) => {
    change(next);
    set_said(words);
  };

  const finish = (points: Point[]) => {
    set_draft([]);
    set_last(points.at(-1) ?? null);
    const done = draw(tool, text, scene, points, options);
    if (done.text) apply(done.text, done.words);
    else set_said(done.words);
    if (tool.name === 'outline' && done.text) set_name('select');
  };

  const remove = () => {
    if (!selected.length || props.is_old) return;
    apply(edits.remove_items(text, scene, selected), `${selected.length} deleted`);
    set_chosen(new Set());
  };

  const keys = (event: KeyboardEvent, grid: number) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrows: Record<string, Point> = {
      ArrowLeft: [-grid, 0],
      ArrowRight: [grid, 0],
      ArrowUp: [0, grid],
      ArrowDown: [0, -grid],
    };
    const lower = event.key.toLowerCase();
    const found = TOOLS.find(own => own.key === lower);
    if (event.key === 'Escape') {
      if (draft.length) set_draft([]);
      else if (name !== 'select') take('select');
      else set_chosen(new Set());
    } else if (event.key === 'Delete' || event.key === 'Backspace') remove();
    else if (event.key in arrows && selected.length && !props.is_old) {
      const [dx, dy] = arrows[event.key];
      const factor = event.shiftKey ? 0.1 : 1;
      change(edits.move_items(text, scene, selected, dx * factor, dy * factor));
    } else if (lower === 'n') step(event.shiftKey ? -1 : 1);
    else if (lower === 's') set_snapping(!is_snapping);
    else if (lower === 'g') set_grid(!has_grid);
    else if (event.key === ',' || event.key === '.') typed.current?.focus();
    else if (found && !event.shiftKey) take(found.name);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  const step = (by: number) => {
    if (!scene.items.length) return;
    const at = scene.items.findIndex(own => chosen.has(own.key));
    const next = scene.items[(at + by + scene.items.length) % scene.items.length];
    set_chosen(new Set([next.key]));
    set_said(title_of(next));
  };

  const add = (point: Point) => {
    const count = points_of(tool, scene.geometry);
    const points = [...draft, point];
    if (count === 1 || (count === 2 && points.length === 2)) return finish(points);
    set_last(point);
    set_draft(points);
  };

  return (
    <div class="edit-draw">
      <div class="edit-tools" role="toolbar" aria-label="Drawing tools">
        {TOOLS.filter(one => is_for(one, scene)).map(one => (
          <button
            type="button"
            key={one.name}
            class="edit-tool"
            aria-pressed={one.name === name}
            disabled={!is_usable(one)}
            title={`${one.label} (${one.key.toUpperCase()})`}
            onClick={() => take(one.name)}
          >
            <svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true">
              <path d={one.icon} />
            </svg>
            {one.label}
          </button>
        ))}
        <span class="edit-split" />
        <button type="button" class="edit-tool" disabled={!props.can_undo} title="Undo (Ctrl+Z)" onClick={props.undo}>
          <svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true">
            <path d="M8 4L4 8l4 4M4 8h8a4 4 0 0 1 0 8H8" />
          </svg>
          Undo
        </button>
        <button type="button" class="edit-tool" disabled={!props.can_redo} title="Redo (Ctrl+Y)" onClick={props.redo}>
          <svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true">
            <path d="M12 4l4 4-4 4M16 8H8a4 4 0 0 0 0 8h4" />
          </svg>
          Redo
        </button>
      </div>
      <Canvas
        scene={scene}
        blocks={blocks}
        tool={tool}
        chosen={chosen}
        choose={list => set_chosen(new Set(list))}
        draft={draft}
        set_draft={set_draft}
        finish={finish}
        move_points={moves => {
          if (!props.is_old) apply(edits.move_points(text, scene, moves), 'moved');
        }}
        move_items={(list, dx, dy) => {
          if (!props.is_old) apply(edits.move_items(text, scene, list, dx, dy), 'moved');
        }}
        material={item => joint_number(scene, item)}
        force={item => direction_of(scene, item)}
        is_snapping={is_snapping}
        has_grid={has_grid}
        has_numbers={has_numbers}
        fit={props.fit}
        pointed={(own, grid) => {
          pointed.value = { own: own === undefined ? pointed.peek().own : own, grid };
        }}
        keys={keys}
        label="Drawing of the case"
      />
      <div class="edit-strip">
        <p class="edit-hint" id="canvas-hint">
          {hint_of(tool, scene.geometry)}
        </p>
        <Options tool={tool} scene={scene} options={options} />
        {tool.name === 'fixed' && scene.geometry === 'drawing' && loops_of(scene).length > 0 && (
          <button
            type="button"
            class="small"
            onClick={() => apply(edits.fix_base_and_sides(text), 'Base and sides are fixed.')}
          >
            Fix base and sides
          </button>
        )}
        {(tool.name === 'joint' || tool.name === 'outline') && loops_of(scene).length > 0 && (
          <button type="button" class="small" onClick={props.open_sets}>
            Joint sets…
          </button>
        )}
        {tool.name !== 'select' && (
          <PlaceBox
            box={typed}
            last={draft.at(-1) ?? last}
            add={add}
            close={() => {
              if (points_of(tool, scene.geometry) === 0 && draft.length > 2) finish(draft);
            }}
            cancel={() => {
              if (draft.length) set_draft([]);
              else take('select');
            }}
          />
        )}
        {tool.name === 'select' && (
          <Chosen
            text={text}
            scene={scene}
            items={selected}
            choose={list => set_chosen(new Set(list))}
            change={change}
            remove={remove}
            is_old={props.is_old}
          />
        )}
      </div>
      <div class="edit-state">
        <Where pointed={pointed} length={scene.length} />
        <span class={props.is_old ? 'bad' : ''} aria-live="polite">
          {props.status}
        </span>
        <span class="space" />
        <Toggle
          label="Snap"
          title="Snap to ends, crossings, lines and grid (S); Alt switches it off for a moment"
          is_on={is_snapping}
          set={set_snapping}
        />
        <Toggle label="Grid" title="Grid (G)" is_on={has_grid} set={set_grid} />
        <Toggle label="Numbers" title="Numbers of blocks" is_on={has_numbers} set={set_numbers} />
        <span class="hidden" aria-live="polite">
          {said}
        </span>
      </div>
    </div>
  );
}

/** Box for a typed place; Enter in the empty box closes a chain. */
export function PlaceBox({
  box,
  last,
  add,
  close,
  cancel,
}: {
  box?: { current: HTMLInputElement | null };
  last: Point | null;
  add: (point: Point) => void;
  close: () => void;
  cancel: () => void;
}) {
  return (
    <input
      ref={box}
      type="text"
      class="edit-place"
      aria-label="Place: x, y or @dx, dy or length<angle"
      placeholder="x, y"
      title="x, y from the origin; @dx, dy or length<angle from the last point"
      onKeyDown={event => {
        const own = event.currentTarget;
        if (event.key === 'Escape') return cancel();
        if (event.key !== 'Enter') return;
        event.preventDefault();
        if (!own.value.trim()) return close();
        const point = typed_point(own.value, last);
        own.setAttribute('aria-invalid', String(!point));
        if (!point) return;
        own.value = '';
        add(point);
      }}
    />
  );
}

function Toggle({
  label,
  title,
  is_on,
  set,
}: {
  label: string;
  title: string;
  is_on: boolean;
  set: (own: boolean) => void;
}) {
  return (
    <label class="edit-toggle" title={title}>
      <input type="checkbox" checked={is_on} onChange={event => set(event.currentTarget.checked)} />
      {label}
    </label>
  );
}

/** Number of the joint material of a line, by number or name. */
function joint_number(scene: Scene, item: Item): number {
  const value = find(scene.root, [...item.path, 4])?.value;
  if (typeof value === 'number') return value;
  return scene.joint_materials.indexOf(String(value)) + 1 || 1;
}

function direction_of(scene: Scene, item: Item): Point | null {
  const own = (value: unknown) => quantity_of(value)?.number ?? 0;
  if (item.kind === 'load') {
    const { force } = edits.force_of(scene, Number(item.path.at(-1)));
    return [own(force[0]), own(force[1])];
  }
  if (item.kind === 'force')
    return [own(find(scene.root, [...item.path, 2])?.value), own(find(scene.root, [...item.path, 3])?.value)];
  return null;
}

interface Choices {
  joint: number;
  block: number;
  stage: number;
  force: string;
  held: string;
  pressure: string;
  stiffness: string;
  strength: string;
  pretension: string;
}

interface ToolOptions extends Choices {
  set: (change: Partial<Choices>) => void;
}

/** Values of new items; they begin with units if the case declares them. */
function useOptions(scene: Scene): ToolOptions {
  const has_units = scene.length !== '';
  const [own, set_own] = useState<Choices>({
    joint: 0,
    block: 0,
    stage: -1,
    force: has_units ? '10 kN/m' : '1e4',
    held: 'both',
    pressure: has_units ? '100 kPa' : '1e5',
    stiffness: has_units ? '20 MN/m/m' : '2e7',
    strength: '0',
    pretension: has_units ? '50 kN/m' : '5e4',
  });
  return { ...own, set: change => set_own(before => ({ ...before, ...change })) };
}

/** A force of the given size in a direction. */
function force_along(from: Point, to: Point, size: string): [Value, Value] {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const own = quantity_of(value_of(size)) ?? { number: 1, unit: '' };
  return [0, 1].map(axis => {
    const part = Number(((own.number * (to[axis] - from[axis])) / length).toPrecision(6)) + 0;
    return own.unit && part ? `${part} ${own.unit}` : part;
  }) as [Value, Value];
}

/** Carries out a tool. Returns the new text, or words on why there is none. */
function draw(
  tool: Tool,
  text: string,
  scene: Scene,
  points: Point[],
  options: ToolOptions,
): { text?: string; words: string } {
  const joint = edits.material_of(scene.joint_materials, options.joint, 'joint');
  const [from, to] = points;
  switch (tool.name) {
    case 'outline':
      return { text: edits.set_outline(text, scene, points, joint), words: `Outline of ${points.length} corners` };
    case 'opening':
      return { text: edits.add_opening(text, scene, points, joint), words: 'Opening added' };
    case 'joint':
      return { text: edits.add_line(text, 'joints', from, to, joint), words: 'Joint added' };
    case 'material':
      return {
        text: edits.add_line(
          text,
          'material_lines',
          from,
          to,
          edits.material_of(scene.block_materials, options.block, 'material'),
        ),
        words: 'Material line added',
      };
    case 'fixed':
      return scene.geometry !== 'drawing'
        ? { text: edits.add_fixed_point(text, scene, from), words: 'Fixed point added' }
        : { text: edits.add_line(text, 'fixed_lines', from, to), words: 'Fixed line added' };
    case 'support':
      return { text: edits.add_chain(text, 'displacements', from, to, { held: options.held }), words: 'Support added' };
    case 'traction':
      return {
        text: edits.add_chain(text, 'tractions', from, to, { pressure: value_of(options.pressure) }),
        words: 'Traction added',
      };
    case 'point':
      return { text: edits.add_point(text, scene, from), words: 'Measured point added' };
    case 'hole':
      return { text: edits.add_hole(text, scene, from), words: 'Hole point added' };
    case 'load':
      return { text: edits.add_load(text, scene, from, force_along(from, to, options.force)), words: 'Load added' };
    case 'bolt': {
      const { stiffness, strength, pretension } = options;
      const values = {
        stiffness: value_of(stiffness),
        strength: value_of(strength),
        pretension: value_of(pretension),
      };
      return { text: edits.add_bolt(text, scene, from, to, values, options.stage), words: 'Bolt added' };
    }
    case 'excavation': {
      let [next, stage] = [text, options.stage];
      if (stage < 0) {
        const made = edits.add_stage(text, `excavation ${Math.max(1, scene.stages.length)}`);
        next = made.text;
        stage = made.index;
        options.set({ stage });
      }
      return {
        text: edits.add_excavation(next, stage, points, joint),
        words: `Excavation added to stage ${stage + 1}`,
      };
    }
    default:
      return { words: '' };
  }
}

/** Places of the values of new items in the schema. */
const PLACES = {
  force: ['analysis', 'point_loads', 0, 0, 1],
  pressure: ['covers', 'tractions', 0, 'pressure'],
  stiffness: ['drawing', 'bolts', 0, 4],
  strength: ['drawing', 'bolts', 0, 5],
  pretension: ['drawing', 'bolts', 0, 6],
};

/** Choices for the items that a tool makes. */
function Options({ tool, scene, options }: { tool: Tool; scene: Scene; options: ToolOptions }) {
  const { set } = options;
  const field = (name: keyof typeof PLACES, label: string) => {
    const own = state.schema.value ? schema_at(state.schema.value, PLACES[name]) : undefined;
    return (
      <label class="edit-part" title={own && hint_of_value(own)}>
        {label}
        <input
          type="text"
          size={9}
          value={options[name]}
          aria-invalid={(own && fault_in(own, value_of(options[name])) !== '') || undefined}
          onInput={event => set({ [name]: event.currentTarget.value })}
        />
      </label>
    );
  };
  const pick = (name: 'joint' | 'block' | 'stage', label: string, words: string[], none?: string) => (
    <label class="edit-part">
      {label}
      <select value={options[name]} onChange={event => set({ [name]: Number(event.currentTarget.value) })}>
        {none && <option value={-1}>{none}</option>}
        {words.map((own, i) => (
          <option value={i} key={own}>
            {own}
          </option>
        ))}
      </select>
    </label>
  );
  const joints = scene.joint_materials.length ? scene.joint_materials : ['joint 1'];
  const rocks = scene.block_materials.length ? scene.block_materials : ['material 1'];
  switch (tool.name) {
    case 'outline':
    case 'opening':
    case 'joint':
      return pick('joint', 'Joint material', joints);
    case 'material':
      return pick('block', 'Block material', rocks);
    case 'support':
      return <Held value={options.held} is_off={false} set={held => set({ held })} />;
    case 'traction':
      return field('pressure', 'Pressure');
    case 'load':
      return field('force', 'Force');
    case 'bolt':
      return (
        <>
          {field('stiffness', 'Stiffness')}
          {field('pretension', 'Pretension')}
          {field('strength', 'Strength (0: none)')}
          {scene.stages.length > 0 && pick('stage', 'From', scene.stages, 'the start')}
        </>
      );
    case 'excavation':
      return (
        <>
          {pick('stage', 'Stage', scene.stages, 'a new stage')}
          {pick('joint', 'Joint material of its faces', joints)}
        </>
      );
    default:
      return null;
  }
}
