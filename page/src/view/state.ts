// State of the page as signals, and what follows from it.

import { batch, computed, signal } from '@preact/signals';
import { type FrameHead, type Head, PageError } from '../data/contract';
import type { Store } from '../data/store';
import { add_places, type Camera, empty_box, fit, type Size } from '../draw/camera';
import type { MapName } from '../draw/colours';
import { type Measure, measures_of } from '../draw/measures';
import { round_below, show, show_time } from '../draw/numbers';
import { DARK, LIGHT } from '../draw/paint';
import { extent_of, pose_of, type Range, range_of, values_of } from '../draw/scene';

export let head: Head;
export let store: Store;
export let measures: Measure[] = [];

/** Counts decoded chunks, so that all that waits for data looks again. */
export const decoded = signal(0);
export const all_decoded = signal(false);
/** Sentence on the last save or decoding that failed. */
export const failure = signal('');

/** Does what may fail; the page shows why it failed until something else succeeds. */
export async function attempt(work: () => void | Promise<void>): Promise<void> {
  try {
    await work();
    failure.value = '';
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    failure.value = error instanceof PageError ? reason : `This failed in the browser: ${reason}`;
  }
}

export const frame = signal(0);
/** Number of frames; it grows while a run goes on. */
export const count = signal(0);
/** True while the run of this page goes on. */
export const is_running = signal(false);
/** Counts heads and lists of measures: what reads them begins anew. */
export const edition = signal(0);
export const playing = signal(false);
export const speed = signal(1);
export const repeat = signal(false);
export const recording = signal(false);

export const size = signal<Size>({ width: 0, height: 0 });
export const camera = signal<Camera>({ x: 0, y: 0, scale: 1 });
/** True if the camera is still the one that fits, so that a new size fits again. */
export const fitted = signal(true);

export type Layer =
  | 'outlines'
  | 'undeformed'
  | 'numbers'
  | 'contacts'
  | 'crosses'
  | 'bolts'
  | 'cracks'
  | 'tips'
  | 'points'
  | 'still'
  | 'legend';

export const layers = signal<Record<Layer, boolean>>({
  outlines: true,
  undeformed: false,
  numbers: false,
  contacts: false,
  crosses: false,
  bolts: true,
  cracks: true,
  tips: true,
  points: true,
  still: true,
  legend: true,
});
/** Meaning of the colour of contact lines. */
export const contact_colour = signal<'state' | 'joint'>('state');
export const arrows = signal<'none' | 'displacement' | 'velocity'>('none');
export const trails = signal<'none' | 'chosen' | 'all'>('none');

export const measure_id = signal('displacement.size');
export const range_mode = signal<'run' | 'frame' | 'own'>('run');
export const own_range = signal<Range>({ low: 0, high: 1 });
export const map_name = signal<MapName>('rising');
export const magnification = signal(1);

export type Chosen = { kind: 'body'; key: number } | { kind: 'part'; what: string; ident: number[]; nth: number };
export const chosen = signal<Chosen | null>(null);

/** Place under the pointer, in the model's coordinates. */
export const pointer = signal<{ x: number; y: number; row: number | null } | null>(null);

export type Theme = 'auto' | 'light' | 'dark';
export const theme = signal<Theme>('auto');
export const system_dark = signal(false);
export const printing = signal(false);
export const is_dark = computed(
  () => !printing.value && (theme.value === 'dark' || (theme.value === 'auto' && system_dark.value)),
);
export const paint = computed(() => (is_dark.value ? DARK : LIGHT));

export type Tab = 'show' | 'chosen' | 'curves' | 'run' | 'blocks';
export const tab = signal<Tab>('show');
/** Name of the renderer of the bodies, and the reason for it. */
export const renderer = signal({ name: '', reason: '' });

export const help_open = signal(false);

export const measure = computed(() => {
  void edition.value;
  return measures.find(m => m.id === measure_id.value) ?? null;
});

/** Takes the data of a run, or takes them anew, at one of their frames. */
export function start_state(new_head: Head, new_store: Store, at: number): void {
  batch(() => {
    head = new_head;
    store = new_store;
    count.value = head.frames.length;
    frame.value = at;
    begin_edition();
  });
}

/** Looks again for measures, and for all that was taken from data. */
export function begin_edition(): void {
  measures = measures_of(head, store);
  if (!measures.some(m => m.id === measure_id.value)) measure_id.value = '';
  run_ranges.clear();
  forces = new Largest();
  crosses = new Largest();
  edition.value++;
  decoded.value++;
}

/** True if load, not time, goes on from frame to frame. Frames of a run without record say so. */
export function is_static(): boolean {
  if (head.run) return head.run.is_static === true;
  return head.frames.some(own => own.is_static);
}

/** Name of a frame's place in the run: its time, or its load factor. */
export function place_in_run(own: FrameHead): string {
  if (!is_static()) return `time ${show_time(own.time, head.units?.time)}`;
  return own.load_factor === null || own.load_factor === undefined ? '' : `load factor ${show(own.load_factor, 4)}`;
}

export function set_layer(layer: Layer, on: boolean): void {
  layers.value = { ...layers.value, [layer]: on };
}

export const last_frame = () => count.value - 1;

export function go_to(next: number): void {
  frame.value = Math.max(0, Math.min(last_frame(), Math.round(next)));
}

/** Starts of stages and epochs, where the page jumps to. */
export interface Mark {
  frame: number;
  label: string;
}

export function marks_of(from: Head): Mark[] {
  const marks: Mark[] = [];
  from.frames.forEach((own, i) => {
    const before = from.frames[i - 1];
    if (!own.stage && own.epoch === (before?.epoch ?? own.epoch)) return;
    if (before && own.stage === before.stage && own.epoch === before.epoch) return;
    const is_stage = own.stage && (!before || own.stage !== before.stage);
    // Geometry changes without a new stage where cracks grow or blocks are cut.
    marks.push({ frame: i, label: is_stage ? String(own.stage) : `step ${own.step}` });
  });
  return marks;
}

export function jump(direction: 1 | -1): void {
  const marks = marks_of(head).map(m => m.frame);
  const stops = [0, ...marks, last_frame()];
  const next =
    direction > 0
      ? stops.find(f => f > frame.value)
      : stops
          .slice()
          .reverse()
          .find(f => f < frame.value);
  if (next !== undefined) go_to(next);
}

// Ranges over the run: grown as chunks are decoded.
const run_ranges = new Map<string, { range: Range; frames: Set<number> }>();

/** Range of a measure over the frames decoded so far. */
export function run_range(own: Measure): Range {
  void decoded.value;
  let entry = run_ranges.get(own.id);
  if (!entry) {
    entry = { range: { low: Infinity, high: -Infinity }, frames: new Set() };
    run_ranges.set(own.id, entry);
  }
  if (entry.frames.size < head.frames.length) {
    for (let f = 0; f < head.frames.length; f++) {
      if (entry.frames.has(f)) continue;
      const values = values_of(store, own, f);
      if (!values) continue;
      entry.frames.add(f);
      range_of(values, entry.range);
    }
  }
  return entry.range;
}

/** Greatest value over the run of what each frame has one of, as far as decoded. */
class Largest {
  private readonly frames = new Set<number>();
  private value = 0;

  /** `at` returns the value of a frame, or null while it is not decoded. */
  over_run(at: (frame: number) => number | null): number {
    void decoded.value;
    for (let f = 0; f < head.frames.length; f++) {
      if (this.frames.has(f)) continue;
      const own = at(f);
      if (own === null) continue;
      this.frames.add(f);
      this.value = Math.max(this.value, own);
    }
    return this.value;
  }
}

let forces = new Largest();
let crosses = new Largest();

function largest_force_at(frame: number): number | null {
  const columns = store.part_now('contacts', frame)?.columns;
  if (!columns?.normal_force) return null;
  const { normal_force, shear_force } = columns;
  let largest = 0;
  for (let i = 0; i < normal_force.length; i++)
    largest = Math.max(largest, Math.hypot(normal_force[i], shear_force?.[i] ?? 0));
  return largest;
}

/** Stress of the longest cross: what 97 % of the bodies do not exceed at a frame, so that a peak does not hide all. */
export function largest_cross_at(frame: number): number | null {
  const sizes: number[] = [];
  for (const id of ['stress.greatest', 'stress.least']) {
    const own = measures.find(m => m.id === id);
    const values = own && values_of(store, own, frame);
    if (!values) return null;
    for (const value of values) if (!Number.isNaN(value)) sizes.push(Math.abs(value));
  }
  sizes.sort((a, b) => a - b);
  // Each body counts twice, and its smaller stress never decides: 97 % of bodies are 98.5 % of the list.
  return sizes[Math.floor(0.985 * (sizes.length - 1))] ?? 0;
}

/** Largest contact force over the run, as far as decoded. */
export const largest_force = () => forces.over_run(largest_force_at);

/** Stress of the longest cross over the run, as far as decoded. */
export const largest_cross = () => crosses.over_run(largest_cross_at);

/** Extent of the undeformed model and of its last places. */
export function fit_view(): void {
  const box = empty_box();
  const now = pose_of(store, frame.value, magnification.value);
  const rest = pose_of(store, frame.value, 0);
  if (rest) add_places(box, rest.places);
  if (now) add_places(box, now.places);
  if (!(box.right >= box.left)) return;
  const room = size.value;
  if (!room.width) return;
  batch(() => {
    camera.value = fit(box, room, margins_of(room));
    fitted.value = true;
  });
}

/** Room that tools, legend and scale bar take. */
export function margins_of(room: Size) {
  const narrow = room.width < 640;
  return { top: narrow ? 56 : 44, right: narrow ? 14 : 56, bottom: narrow ? 92 : 102, left: 18 };
}

/** Magnification at which the largest displacement of the run is 5 % of the model's width. */
export function suited_magnification(): number {
  const own = measures.find(m => m.id === 'displacement.size');
  const geometry = store.geometry_now(store.epoch_of(frame.value));
  if (!own || !geometry) return 1;
  const largest = run_range(own).high;
  if (!(largest > 0)) return 1;
  const raw = (0.05 * extent_of(geometry)) / largest;
  return raw <= 1 ? 1 : round_below(raw);
}
