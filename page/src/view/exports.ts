// Saves what is shown: PNG, SVG, CSV, video.

import type { Geometry } from '../data/decode';
import { place_decimals } from '../draw/numbers';
import type { Figure } from '../draw/paint';
import { paint_all } from '../draw/paint';
import { CanvasPen, SvgPen } from '../draw/pen';
import { body_value, displacement_of, extent_of, part_at, values_of } from '../draw/scene';
import { material_name } from './chosen';
import { figure_now } from './figure';
import * as state from './state';

function save(blob: Blob, name: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 30_000);
}

/** Name of a file: title of the run, step, ending. */
export function file_name(ending: string, with_step = true): string {
  const title =
    state.head.title
      .replace(/\.\w+$/, '')
      .replace(/[^\w-]+/g, '_')
      .replace(/^_+|_+$/g, '') || 'run';
  return `${title}${with_step ? `_step${state.head.frames[state.frame.value].step}` : ''}.${ending}`;
}

function draw_on(canvas: HTMLCanvasElement, figure: Figure, ratio: number): void {
  const width = Math.round(figure.size.width * ratio);
  const height = Math.round(figure.size.height * ratio);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const c = canvas.getContext('2d')!;
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  c.fillStyle = figure.paint.background;
  c.fillRect(0, 0, figure.size.width, figure.size.height);
  paint_all(new CanvasPen(c), figure, true);
}

export async function save_png(): Promise<void> {
  const figure = figure_now();
  if (!figure) return;
  const canvas = document.createElement('canvas');
  draw_on(canvas, figure, 2);
  const blob = await new Promise<Blob | null>(done => canvas.toBlob(done, 'image/png'));
  if (!blob) throw new Error('the browser made no picture of this size.');
  save(blob, file_name('png'));
}

/** The drawing as SVG text. */
export function svg_text(): string | null {
  const figure = figure_now();
  if (!figure) return null;
  const pen = new SvgPen();
  paint_all(pen, figure, true);
  return pen.done(figure.size.width, figure.size.height, figure.paint.background, state.head.title);
}

export function save_svg(): void {
  const text = svg_text();
  if (text) save(new Blob([text], { type: 'image/svg+xml' }), file_name('svg'));
}

/** A cell of CSV: quoted where it must be. */
function cell(value: string | number | null): string {
  if (value === null || (typeof value === 'number' && Number.isNaN(value))) return '';
  const text = String(value);
  return /[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
}

function number(value: number, digits: number): number {
  return Number(value.toPrecision(digits));
}

/** A place with the precision of the 18 bits that places have in the file. */
function place(value: number, geometry: Geometry): number {
  return Number(value.toFixed(place_decimals(extent_of(geometry), 2 ** 18)));
}

/** Blocks of the present frame with all their values. */
export function blocks_csv(): string | null {
  const { store, head, frame } = state;
  const at = frame.value;
  const geometry = store.geometry_now(store.epoch_of(at));
  if (!geometry) return null;
  const length = head.units?.length;
  const unit = (name: string, own?: string) => (own ? `${name} [${own}]` : name);
  const measures = state.measures
    .filter(own => own.group !== 'Model')
    .map(own => ({ own, values: values_of(store, own, at) }))
    .filter(entry => entry.values);
  const lines = [
    [
      'block',
      'material',
      'support',
      unit('x', length),
      unit('y', length),
      ...measures.map(({ own }) => unit(own.id, own.unit)),
    ],
  ] as (string | number | null)[][];
  for (let row = 0; row < geometry.bodies; row++) {
    const moved = displacement_of(store, at, row) ?? [0, 0];
    lines.push([
      geometry.number[row],
      material_name(geometry.material[row]),
      geometry.fixed[row] ? 'fixed' : 'free',
      place(geometry.centroid[2 * row] + head.origin[0] + moved[0], geometry),
      place(geometry.centroid[2 * row + 1] + head.origin[1] + moved[1], geometry),
      ...measures.map(({ own, values }) => {
        const value = body_value(own, values!, geometry, row);
        return own.kind === 'state' ? (own.names?.[Math.round(value)] ?? value) : number(value, own.digits + 1);
      }),
    ]);
  }
  return `${lines.map(line => line.map(cell).join(',')).join('\n')}\n`;
}

export function save_blocks_csv(): void {
  const text = blocks_csv();
  if (text) save(new Blob([text], { type: 'text/csv' }), file_name('csv'));
}

/** Columns of contacts that contacts.csv of a run calls otherwise. */
const AS_IN_TABLES: Record<string, string> = { joint: 'joint_material', joint_line: 'joint' };

/** Closed contacts of the present frame. */
export function contacts_csv(): string | null {
  const { store, head } = state;
  const at = part_at(store, 'contacts', state.frame.value);
  const geometry = store.geometry_now(store.epoch_of(state.frame.value));
  const columns = head.parts?.contacts?.columns;
  if (!at || !columns || !geometry) return null;
  const names = columns.flatMap(c => {
    const unit = c.unit ? ` [${c.unit}]` : '';
    const name = AS_IN_TABLES[c.name] ?? c.name;
    return (c.parts ?? 1) === 2 ? [`${name}_x${unit}`, `${name}_y${unit}`] : [`${name}${unit}`];
  });
  const lines: (string | number | null)[][] = [['step', ...names]];
  for (let i = 0; i < at.rows.rows; i++) {
    const line: (string | number | null)[] = [head.frames[at.frame].step];
    for (const c of columns) {
      const n = c.parts ?? 1;
      for (let p = 0; p < n; p++) {
        const value = at.rows.columns[c.name][n * i + p];
        if (c.name === 'block' || c.name === 'other') {
          line.push(value < geometry.bodies ? geometry.number[value] : null);
        } else if (c.names?.length) line.push(c.names[value] ?? value);
        else if (c.name === 'joint') line.push(value + 1);
        else if (c.name === 'place') line.push(place(value + head.origin[p], geometry));
        else line.push(c.type === 'u32' ? value : number(value, 6));
      }
    }
    lines.push(line);
  }
  return `${lines.map(line => line.map(cell).join(',')).join('\n')}\n`;
}

export function save_contacts_csv(): void {
  const text = contacts_csv();
  if (text) save(new Blob([text], { type: 'text/csv' }), file_name('csv').replace('_step', '_contacts_step'));
}

const KINDS = ['video/mp4;codecs=avc1.42E01F', 'video/mp4', 'video/webm;codecs=vp9', 'video/webm'];

/** Kind of video that this browser records, or nothing. */
export function video_kind(): string | null {
  if (typeof MediaRecorder === 'undefined') return null;
  return KINDS.find(kind => MediaRecorder.isTypeSupported(kind)) ?? null;
}

let stop_video = false;

export function cancel_video(): void {
  stop_video = true;
}

/** Draws all frames on a canvas at a rate, each once it is decoded with all that the drawing shows. */
async function film(rate: number, draw: () => void, track: { requestFrame(): void }): Promise<void> {
  const { store } = state;
  let due = performance.now();
  for (let f = 0; f <= state.last_frame() && !stop_video; f++) {
    await store.need_frame(f, store.kinds());
    state.frame.value = f;
    draw();
    track.requestFrame();
    due += 1000 / rate;
    await new Promise(resolve => setTimeout(resolve, Math.max(0, due - performance.now())));
  }
  track.requestFrame();
  await new Promise(resolve => setTimeout(resolve, 100));
}

/** Plays all frames once at the player's speed and records the drawing. Returns the video. */
export async function record_video(rate: number): Promise<Blob | null> {
  const kind = video_kind();
  const first = figure_now();
  if (!kind || !first) return null;
  state.playing.value = false;
  state.recording.value = true;
  stop_video = false;
  const before = state.frame.value;
  const canvas = document.createElement('canvas');
  // Coders of video want even sizes.
  const even = (n: number) => n - (n % 2);
  const size = { width: even(first.size.width), height: even(first.size.height) };
  const ratio = size.width < 1400 ? 1.5 : 1;
  const scale = ratio === 1.5 && (size.width * 1.5) % 2 === 0 && (size.height * 1.5) % 2 === 0 ? 1.5 : 1;
  const draw = () => {
    const figure = figure_now();
    if (figure) draw_on(canvas, { ...figure, size }, scale);
  };
  const parts: Blob[] = [];
  let stream: MediaStream | null = null;
  try {
    draw();
    stream = canvas.captureStream(0);
    const recorder = new MediaRecorder(stream, { mimeType: kind, videoBitsPerSecond: 8_000_000 });
    recorder.ondataavailable = event => parts.push(event.data);
    const done = new Promise<void>(resolve => {
      recorder.onstop = () => resolve();
    });
    recorder.start();
    await film(rate, draw, stream.getVideoTracks()[0] as MediaStreamTrack & { requestFrame(): void });
    recorder.stop();
    await done;
  } finally {
    for (const own of stream?.getTracks() ?? []) own.stop();
    state.recording.value = false;
    state.frame.value = before;
  }
  return stop_video ? null : new Blob(parts, { type: kind.split(';')[0] });
}

export async function save_video(rate: number): Promise<void> {
  const blob = await record_video(rate);
  if (blob) save(blob, file_name(blob.type === 'video/mp4' ? 'mp4' : 'webm', false));
}
