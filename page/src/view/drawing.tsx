// The drawing: canvases, pointer, wheel and touch.

import { effect } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { body_name } from '../data/decode';
import { pan, to_world, zoom } from '../draw/camera';
import { type Cost, is_webgl_faster, is_worth_measuring, measure } from '../draw/choose';
import { show_place } from '../draw/numbers';
import { contact_line, type Figure, paint_bodies, paint_legend, paint_over, screen_of } from '../draw/paint';
import { CanvasPen } from '../draw/pen';
import { pick_body, pick_point, pick_segment } from '../draw/pick';
import { body_value, extent_of, unit_of_value } from '../draw/scene';
import { WebglBodies } from '../draw/webgl';
import { capital } from '../draw/words';
import { contacts_of, figure_now, ident_of, lines_of, nth_of, points_of } from './figure';
import { Icon } from './icons';
import * as state from './state';

/** The figure on the screen, for picks and exports. */
export let shown: Figure | null = null;

/** Times of drawing, for the tests of the page. */
export const timing = {
  frames: 0,
  first_picture: 0,
  last_draw: 0,
  renderer: '',
  cost: null as Cost | null,
  /** Called after each picture with the step that it shows. */
  on_drawn: null as ((step: number) => void) | null,
};

function draw_mode(): string {
  return new URLSearchParams(location.search).get('draw') ?? '';
}

export function Drawing() {
  const box = useRef<HTMLDivElement>(null);
  const under = useRef<HTMLCanvasElement>(null);
  const over = useRef<HTMLCanvasElement>(null);

  useEffect(() => {
    const element = box.current!;
    const canvas = over.current!;
    const pen = new CanvasPen(canvas.getContext('2d')!);
    const mode = draw_mode();
    let webgl: WebglBodies | null = null;
    const is_forced = mode === 'webgl' || mode === 'measure';
    if (mode !== 'canvas') {
      // A canvas keeps the first kind of context it gave, so a spare one shows if a card is there.
      const is_fit = is_forced || WebglBodies.make(document.createElement('canvas'), false) !== null;
      if (is_fit) webgl = WebglBodies.make(under.current!, is_forced);
    }
    const use = (own: WebglBodies | null, reason: string) => {
      webgl = own;
      timing.renderer = own ? 'WebGL2' : 'canvas';
      under.current!.hidden = !own;
      state.renderer.value = { name: own ? 'WebGL2' : 'a canvas', reason };
    };
    use(webgl, webgl ? '' : mode === 'canvas' ? 'as the address requires' : 'no graphics card was found');
    let is_measured = mode === 'webgl' || !webgl;

    /** Takes the canvas if it draws a large figure faster than WebGL2. */
    const choose = (own: WebglBodies, figure: Figure, ratio: number) => {
      is_measured = true;
      const cost = measure(own, figure, ratio);
      timing.cost = cost;
      const times = `WebGL2 takes ${cost.webgl.toFixed(0)} ms for a picture, a canvas ${cost.canvas.toFixed(0)} ms`;
      use(is_webgl_faster(cost) ? own : null, times);
    };

    let request = 0;
    const draw = () => {
      request = 0;
      const figure = shown;
      if (!figure?.size.width) return;
      const start = performance.now();
      const ratio = Math.min(3, window.devicePixelRatio || 1);
      const width = Math.round(figure.size.width * ratio);
      const height = Math.round(figure.size.height * ratio);
      for (const own of webgl ? [canvas, under.current!] : [canvas]) {
        if (own.width !== width || own.height !== height) {
          own.width = width;
          own.height = height;
        }
      }
      const c = canvas.getContext('2d')!;
      c.setTransform(ratio, 0, 0, ratio, 0, 0);
      const screen = screen_of(figure, figure.pose.places);
      // The first picture comes at once; the measurement follows it.
      if (webgl && !is_measured && timing.first_picture && is_worth_measuring(figure)) choose(webgl, figure, ratio);
      if (webgl) {
        webgl.draw(figure, ratio);
        c.clearRect(0, 0, figure.size.width, figure.size.height);
      } else {
        c.fillStyle = figure.paint.background;
        c.fillRect(0, 0, figure.size.width, figure.size.height);
        paint_bodies(pen, figure, screen);
      }
      paint_over(pen, figure, screen);
      if (figure.legend) paint_legend(pen, figure);
      timing.frames++;
      timing.last_draw = performance.now() - start;
      if (!timing.first_picture) timing.first_picture = performance.now();
      timing.on_drawn?.(state.head.frames[figure.pose.frame].step);
    };
    const stop = effect(() => {
      const figure = figure_now();
      // While a frame is being decoded the last picture stays.
      if (!figure) return;
      shown = figure;
      if (!request) request = requestAnimationFrame(draw);
    });

    const resized = () => {
      const { width, height } = element.getBoundingClientRect();
      if (width < 2 || height < 2) return;
      state.size.value = { width: Math.round(width), height: Math.round(height) };
      if (state.fitted.value) state.fit_view();
      // A new size empties the canvas, so it is drawn at once.
      if (shown) {
        cancelAnimationFrame(request);
        shown = figure_now() ?? shown;
        draw();
      }
    };
    const watch = new ResizeObserver(resized);
    watch.observe(element);
    resized();
    const wheel = (event: WheelEvent) => {
      event.preventDefault();
      const { x, y } = local(event);
      const pixels = event.deltaMode === 1 ? event.deltaY * 16 : event.deltaY;
      zoom_at(Math.exp(-Math.max(-300, Math.min(300, pixels)) * 0.0016), x, y);
    };
    element.addEventListener('wheel', wheel, { passive: false });
    return () => {
      stop();
      watch.disconnect();
      element.removeEventListener('wheel', wheel);
    };
  }, []);

  const local = (event: { clientX: number; clientY: number }) => {
    const rect = box.current!.getBoundingClientRect();
    return { x: event.clientX - rect.left, y: event.clientY - rect.top };
  };

  const held = useRef(new Map<number, { x: number; y: number }>());
  const moved = useRef(0);

  const down = (event: PointerEvent) => {
    if (event.button > 1) return;
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    held.current.set(event.pointerId, local(event));
    if (held.current.size === 1) moved.current = 0;
  };
  const move = (event: PointerEvent) => {
    const now = local(event);
    const before = held.current.get(event.pointerId);
    if (!before) {
      hover(now.x, now.y);
      return;
    }
    if (held.current.size === 1) {
      const dx = now.x - before.x;
      const dy = now.y - before.y;
      moved.current += Math.abs(dx) + Math.abs(dy);
      if (moved.current > 4) {
        pan_by(dx, dy);
      } else {
        return;
      }
    } else if (held.current.size === 2) {
      moved.current = 100;
      const other = [...held.current].find(([id]) => id !== event.pointerId)![1];
      const old_distance = Math.hypot(before.x - other.x, before.y - other.y) || 1;
      const distance = Math.hypot(now.x - other.x, now.y - other.y) || 1;
      zoom_at(distance / old_distance, (now.x + other.x) / 2, (now.y + other.y) / 2);
    }
    held.current.set(event.pointerId, now);
  };
  const up = (event: PointerEvent) => {
    const was_held = held.current.delete(event.pointerId);
    if (was_held && moved.current <= 4 && held.current.size === 0 && event.button === 0) {
      const { x, y } = local(event);
      pick_at(x, y, event.pointerType === 'touch' ? 14 : 7);
    }
  };

  return (
    <div class="drawing" ref={box}>
      <canvas class="under" ref={under} aria-hidden="true" />
      <canvas
        class="over"
        ref={over}
        role="img"
        aria-label={`Drawing of the model. ${description()}`}
        onPointerDown={down}
        onPointerMove={move}
        onPointerUp={up}
        onPointerCancel={up}
        onPointerLeave={() => {
          state.pointer.value = null;
        }}
        onDblClick={event => {
          const { x, y } = local(event);
          zoom_at(1.8, x, y);
        }}
      />
      <Hover />
      <div class="tools" role="group" aria-label="View">
        <button type="button" title="Zoom in (+)" aria-label="Zoom in" onClick={() => zoom_at(1.4)}>
          <Icon name="plus" />
        </button>
        <button type="button" title="Zoom out (−)" aria-label="Zoom out" onClick={() => zoom_at(1 / 1.4)}>
          <Icon name="minus" />
        </button>
        <button type="button" title="Fit the model (f)" aria-label="Fit the model" onClick={state.fit_view}>
          <Icon name="fit" />
        </button>
      </div>
    </div>
  );
}

function description(): string {
  const own = state.measure.value;
  const bodies = state.head.epochs[state.head.frames[state.frame.value].epoch].bodies;
  return `${bodies} ${bodies === 1 ? 'block or element' : 'blocks or elements'}${own ? `, coloured by ${own.label.toLowerCase()}` : ''}. The tab Blocks lists them.`;
}

export function zoom_at(factor: number, x = state.size.value.width / 2, y = state.size.value.height / 2): void {
  state.fitted.value = false;
  state.camera.value = zoom(state.camera.value, state.size.value, factor, x, y);
}

export function pan_by(dx: number, dy: number): void {
  state.fitted.value = false;
  state.camera.value = pan(state.camera.value, dx, dy);
}

function hover(x: number, y: number): void {
  if (!shown) return;
  const [wx, wy] = to_world(state.camera.value, state.size.value, x, y);
  state.pointer.value = { x: wx, y: wy, row: pick_body(shown.pose, wx, wy) };
}

/** Chooses what stands at a pixel: marks first, then contacts that are shown, then bodies. */
export function pick_at(x: number, y: number, reach: number): void {
  const figure = shown;
  if (!figure || pick_mark(figure, x, y, reach)) return;
  const { pose } = figure;
  const [wx, wy] = to_world(state.camera.value, state.size.value, x, y);
  const row = pick_body(pose, wx, wy);
  if (row === null) {
    state.chosen.value = null;
    return;
  }
  state.chosen.value = { kind: 'body', key: pose.geometry.key[row] };
  if (window.innerWidth >= 900) state.tab.value = 'chosen';
}

/** Chooses a point, contact, bolt or crack at a pixel, if one is there. */
function pick_mark(figure: Figure, x: number, y: number, reach: number): boolean {
  const { pose } = figure;
  const { geometry } = pose;
  const choose = (what: string, rows: Parameters<typeof ident_of>[1], i: number) => {
    const ident = ident_of(what, rows, i, geometry);
    state.chosen.value = { kind: 'part', what, ident, nth: nth_of(what, rows, i, geometry) };
    state.tab.value = 'chosen';
    return true;
  };
  for (const { marks, at } of points_of(pose)) {
    const i = pick_point(screen_of(figure, marks.at), x, y, reach);
    if (i !== null) return choose(marks.name, at.rows, i);
  }
  if (state.layers.value.contacts) {
    const own = contacts_of(pose);
    if (own) {
      const ends = new Float32Array(4 * own.marks.state.length);
      for (let i = 0; i < own.marks.state.length; i++) ends.set(contact_line(figure, own.marks, i).slice(0, 4), 4 * i);
      const i = pick_segment(ends, x, y, reach * 0.8);
      if (i !== null) return choose('contacts', own.at.rows, i);
    }
  }
  for (const { marks, at } of lines_of(pose)) {
    const i = pick_segment(screen_of(figure, marks.ends), x, y, reach);
    if (i !== null) return choose(marks.name, at.rows, i);
  }
  return false;
}

/** Line at the top left: block and value under the pointer, and its place. */
function Hover() {
  const at = state.pointer.value;
  void state.frame.value;
  if (!at || !shown) return null;
  const { pose, shade } = shown;
  const [ox, oy] = state.head.origin;
  const unit = state.head.units?.length ?? '';
  const extent = extent_of(pose.geometry);
  const place = `x ${show_place(at.x + ox, extent)}, y ${show_place(at.y + oy, extent)}${unit ? ` ${unit}` : ''}`;
  let block = '';
  if (at.row !== null && at.row < pose.geometry.bodies) {
    block = capital(body_name(pose.geometry, at.row));
    if (shade)
      block += `: ${unit_of_value(shade.measure, body_value(shade.measure, shade.values, pose.geometry, at.row))}`;
  }
  return (
    <div class="hover" aria-hidden="true">
      {block && <b>{block}</b>}
      <span>{place}</span>
    </div>
  );
}
