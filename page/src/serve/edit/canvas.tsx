// Canvas of a case: shows its drawing, and takes points, selections and moves from pointer and keys.

import { useEffect, useRef, useState } from 'preact/hooks';
import { type Camera, fit as fit_box, pan, type Size, to_world, zoom as zoom_at } from '../../draw/camera';
import { round_above } from '../../draw/numbers';
import { colours_of, Ground, type Picture } from './paint';
import { box_of, extent_of, type Item, is_within, type Point, type Polygon, type Scene } from './scene';
import { foot_of, type Snapped, segments_of, snap } from './snap';
import { points_of, type Tool } from './tools';

export interface CanvasProps {
  scene: Scene;
  blocks: Polygon[];
  tool: Tool;
  chosen: ReadonlySet<string>;
  choose: (keys: string[]) => void;
  draft: Point[];
  set_draft: (points: Point[]) => void;
  /** Takes the points of a tool once they are complete. */
  finish: (points: Point[]) => void;
  move_points: (moves: { item: Item; index: number; to: Point }[]) => void;
  move_items: (items: Item[], dx: number, dy: number) => void;
  material: (item: Item) => number;
  force: (item: Item) => Point | null;
  is_snapping: boolean;
  has_numbers: boolean;
  has_grid: boolean;
  /** Counts requests to fit the drawing into the canvas. */
  fit: number;
  /** `pointer` undefined: as before. */
  pointed: (pointer: Snapped | null | undefined, grid: number) => void;
  keys: (event: KeyboardEvent, grid: number) => void;
  label: string;
}

/** Pixels within which a pointer means a place, and an item. */
const REACH = 10;
const HIT = 7;

/** Room about a drawing that fits, and the box of an empty one. */
const MARGINS = { top: 35, right: 45, bottom: 35, left: 45 };
const EMPTY = { left: 0, bottom: 0, right: 20, top: 10 };

type Drag =
  | { kind: 'pan'; x: number; y: number; view: Camera }
  | { kind: 'handle'; item: Item; index: number; pressed: Point; is_moving: boolean }
  | { kind: 'items'; items: Item[]; from: Point; pressed: Point; is_moving: boolean }
  | { kind: 'box'; from: Point; adds: boolean };

export function Canvas(props: CanvasProps) {
  const { scene, blocks, tool, chosen, draft } = props;
  const box = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const [size, set_size] = useState<Size>({ width: 0, height: 0 });
  const [view, set_view] = useState<Camera>({ x: 0, y: 0, scale: 0 });
  const [pointer, set_pointer] = useState<Snapped | null>(null);
  const [hovered, set_hovered] = useState('');
  const [drag, set_drag] = useState<Drag | null>(null);
  const [lasso, set_lasso] = useState<[Point, Point] | null>(null);
  const [moved, set_moved] = useState<Map<string, Point[]>>(new Map());
  const [theme, set_theme] = useState('');
  const before = useRef<Size>(size);
  const ground = useRef<Ground | null>(null);
  const space = useRef(false);
  const touches = useRef(new Map<number, Point>());
  const pinch = useRef<{ distance: number; middle: Point; view: Camera } | null>(null);

  const { width, height } = size;
  const grid = view.scale > 0 ? round_above(18 / view.scale) : 1;
  const count = points_of(tool, scene.geometry);

  useEffect(() => props.pointed(undefined, grid), [grid]);

  useEffect(() => {
    const watch = new ResizeObserver(() => {
      const own = box.current;
      if (!own) return;
      const old = before.current;
      const now = { width: own.clientWidth, height: own.clientHeight };
      before.current = now;
      set_size(now);
      // The drawing stays where it is, seen from the upper left corner.
      if (old.width && old.height)
        set_view(one => (one.scale > 0 ? pan(one, (old.width - now.width) / 2, (old.height - now.height) / 2) : one));
    });
    watch.observe(box.current!);
    const themes = new MutationObserver(() => set_theme(document.documentElement.dataset.theme ?? ''));
    themes.observe(document.documentElement, { attributes: true, attributeFilter: ['data-theme'] });
    return () => {
      watch.disconnect();
      themes.disconnect();
    };
  }, []);

  const fit = () => {
    if (width && height) set_view(fit_box(extent_of(scene, blocks) ?? EMPTY, size, MARGINS));
  };
  const is_empty = extent_of(scene, blocks) === null;
  useEffect(fit, [props.fit, width > 0 && height > 0, is_empty]);

  useEffect(() => {
    const own = canvas.current;
    if (!own || !width || !height || !(view.scale > 0)) return;
    const ratio = window.devicePixelRatio || 1;
    own.width = Math.round(width * ratio);
    own.height = Math.round(height * ratio);
    const c = own.getContext('2d');
    if (!c) return;
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    const picture: Picture = {
      scene,
      blocks,
      view,
      size,
      grid: props.has_grid ? grid : 0,
      chosen,
      hovered,
      material: props.material,
      force: props.force,
      moved,
      draft,
      is_draft_closed: count === 0,
      pointer: tool.name === 'select' && drag?.kind !== 'handle' ? null : pointer,
      box: lasso,
      has_numbers: props.has_numbers,
    };
    ground.current ??= new Ground();
    ground.current.paint(c, picture, colours_of(own));
  });

  const pixel = (x: number, y: number): Point => {
    const own = canvas.current!.getBoundingClientRect();
    return [x - own.left, y - own.top];
  };
  const place = (event: { clientX: number; clientY: number }): Point =>
    to_world(view, size, ...pixel(event.clientX, event.clientY));

  const snapped = (p: Point, left_out: ReadonlySet<string>, is_free: boolean): Snapped =>
    snap(
      p,
      segments_of(scene, left_out),
      scene.items.filter(own => own.points.length === 1 && !left_out.has(own.key)).map(own => own.points[0]),
      {
        reach: REACH / view.scale,
        grid: props.has_grid ? grid : 0,
        is_on: props.is_snapping && !is_free,
        pixel: 1 / view.scale,
        ends: draft,
      },
    );

  /** Item under the pointer: points first, then lines, then regions. */
  const hit = (p: Point): Item | null => {
    const reach = HIT / view.scale;
    let best: Item | null = null;
    let least = reach * 1.4;
    for (const item of scene.items) {
      const { points } = item;
      let own = Number.POSITIVE_INFINITY;
      if (points.length === 1) own = Math.hypot(points[0][0] - p[0], points[0][1] - p[1]) * 0.6;
      for (let i = 0; i + 1 < points.length + (item.is_closed ? 1 : 0); i++) {
        const foot = foot_of({ from: points[i], to: points[(i + 1) % points.length] }, p);
        own = Math.min(own, Math.hypot(foot[0] - p[0], foot[1] - p[1]));
      }
      if (own < least || (own === least && item.kind !== 'joint')) {
        least = own;
        best = item;
      }
    }
    return best ?? scene.items.find(own => own.is_closed && is_within([own.points], p)) ?? null;
  };

  /** Nearest end, corner or point of items within reach. Of several at one place it is the last that is no joint. */
  const end_at = (items: Item[], p: Point): { item: Item; index: number } | null => {
    let best: { item: Item; index: number } | null = null;
    let least = HIT / view.scale;
    for (const item of items)
      item.points.forEach((own, index) => {
        const distance = Math.hypot(own[0] - p[0], own[1] - p[1]);
        if (distance > least || (distance === least && item.kind === 'joint')) return;
        least = distance;
        best = { item, index };
      });
    return best;
  };

  /** Item that a press takes, and its end or corner there, or -1. A chosen item comes before others. */
  const grip = (p: Point): { item: Item; index: number } | null => {
    const mine = scene.items.filter(own => chosen.has(own.key) && own.points.length > 1);
    const end = chosen.size > 12 ? null : end_at(mine, p);
    const item = hit(p);
    const found =
      end ??
      (item && chosen.has(item.key)
        ? null
        : end_at(
            scene.items.filter(own => !chosen.has(own.key)),
            p,
          ));
    if (found) return found.item.points.length > 1 ? found : { item: found.item, index: -1 };
    return item && { item, index: -1 };
  };

  const zoom = (factor: number, about: Point = [width / 2, height / 2]) =>
    set_view(zoom_at(view, size, factor, ...about));

  /** Adds a point to the draft; the tool ends once it has all of them. */
  const add = (point: Point) => {
    if (count === 1) return props.finish([point]);
    const last = draft.at(-1);
    if (last && last[0] === point[0] && last[1] === point[1]) return;
    if (count === 0 && draft.length > 2 && point[0] === draft[0][0] && point[1] === draft[0][1])
      return props.finish(draft);
    const points = [...draft, point];
    if (count === 2 && points.length === 2) return props.finish(points);
    props.set_draft(points);
  };

  const down = (event: PointerEvent) => {
    canvas.current!.focus();
    canvas.current!.setPointerCapture(event.pointerId);
    const p = place(event);
    if (event.pointerType === 'touch') {
      touches.current.set(event.pointerId, [event.clientX, event.clientY]);
      if (touches.current.size === 2) {
        const [a, b] = [...touches.current.values()];
        pinch.current = {
          distance: Math.hypot(a[0] - b[0], a[1] - b[1]),
          middle: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2],
          view,
        };
        set_drag(null);
        return;
      }
    }
    if (event.button !== 0 || space.current) {
      set_drag({ kind: 'pan', x: event.clientX, y: event.clientY, view });
      return;
    }
    if (tool.name !== 'select') return;
    const grabbed = grip(p);
    if (grabbed && grabbed.index >= 0 && (chosen.has(grabbed.item.key) || !event.shiftKey)) {
      if (!chosen.has(grabbed.item.key)) props.choose([grabbed.item.key]);
      set_drag({ kind: 'handle', ...grabbed, pressed: p, is_moving: false });
    } else if (grabbed) {
      const { item } = grabbed;
      let keys = chosen;
      if (event.shiftKey) {
        const own = new Set(chosen);
        if (own.has(item.key)) own.delete(item.key);
        else own.add(item.key);
        keys = own;
      } else if (!chosen.has(item.key)) keys = new Set([item.key]);
      props.choose([...keys]);
      // A block that fills the place is chosen first, and moves with the next press.
      if (item.kind === 'block' && !chosen.has(item.key)) return;
      const from = snapped(p, new Set(), false).point;
      set_drag({
        kind: 'items',
        items: scene.items.filter(own => keys.has(own.key)),
        from,
        pressed: p,
        is_moving: false,
      });
    } else if (event.pointerType === 'touch') {
      props.choose([]);
      set_drag({ kind: 'pan', x: event.clientX, y: event.clientY, view });
    } else set_drag({ kind: 'box', from: p, adds: event.shiftKey });
  };

  const move = (event: PointerEvent) => {
    const p = place(event);
    if (touches.current.has(event.pointerId)) touches.current.set(event.pointerId, [event.clientX, event.clientY]);
    if (pinch.current && touches.current.size === 2) {
      const [a, b] = [...touches.current.values()];
      const { distance, middle, view: before } = pinch.current;
      const factor = Math.hypot(a[0] - b[0], a[1] - b[1]) / Math.max(1, distance);
      const [dx, dy] = [(a[0] + b[0]) / 2 - middle[0], (a[1] + b[1]) / 2 - middle[1]];
      set_view(pan(zoom_at(before, size, factor, ...pixel(...middle)), dx, dy));
      return;
    }
    if (!drag) {
      const found = snapped(p, new Set(), event.altKey);
      set_pointer(found);
      props.pointed(found, grid);
      if (tool.name === 'select') set_hovered(grip(p)?.item.key ?? '');
      return;
    }
    if (drag.kind === 'pan') set_view(pan(drag.view, event.clientX - drag.x, event.clientY - drag.y));
    else if (drag.kind === 'box') set_lasso([drag.from, p]);
    else if (!drag.is_moving && Math.hypot(p[0] - drag.pressed[0], p[1] - drag.pressed[1]) * view.scale < 4) return;
    else if (drag.kind === 'handle') {
      drag.is_moving = true;
      const found = snapped(p, new Set([drag.item.key]), event.altKey);
      set_pointer(found);
      props.pointed(found, grid);
      set_moved(new Map([[drag.item.key, drag.item.points.map((own, i) => (i === drag.index ? found.point : own))]]));
    } else {
      drag.is_moving = true;
      const keys = new Set(drag.items.map(own => own.key));
      const to = snapped(p, keys, event.altKey);
      props.pointed(to, grid);
      const [dx, dy] = [to.point[0] - drag.from[0], to.point[1] - drag.from[1]];
      set_moved(new Map(drag.items.map(own => [own.key, own.points.map(([x, y]) => [x + dx, y + dy] as Point)])));
    }
  };

  const up = (event: PointerEvent) => {
    touches.current.delete(event.pointerId);
    if (pinch.current) {
      if (!touches.current.size) pinch.current = null;
      return;
    }
    const p = place(event);
    const own = drag;
    set_drag(null);
    set_moved(new Map());
    set_lasso(null);
    if (!own) {
      if (event.button === 0 && tool.name !== 'select') add(snapped(p, new Set(), event.altKey).point);
      return;
    }
    if (own.kind === 'handle') {
      const to = moved.get(own.item.key)?.[own.index];
      if (to) props.move_points([{ item: own.item, index: own.index, to }]);
    } else if (own.kind === 'items' && own.is_moving) {
      const [item] = own.items;
      const to = moved.get(item.key)?.[0];
      if (to) props.move_items(own.items, to[0] - item.points[0][0], to[1] - item.points[0][1]);
    } else if (own.kind === 'box') {
      const around = box_of([own.from, p])!;
      const inside = scene.items.filter(item =>
        item.points.every(([x, y]) => x >= around.left && y >= around.bottom && x <= around.right && y <= around.top),
      );
      props.choose([...(own.adds ? chosen : []), ...inside.map(item => item.key)]);
    }
  };

  const cancel = () => {
    touches.current.clear();
    pinch.current = null;
    set_drag(null);
    set_moved(new Map());
    set_lasso(null);
  };

  const key = (event: KeyboardEvent) => {
    if (event.key === ' ') {
      space.current = true;
      event.preventDefault();
      return;
    }
    const plain = !event.ctrlKey && !event.metaKey && !event.altKey;
    const step = event.shiftKey ? 200 : 40;
    const shifts: Record<string, Point> = {
      ArrowLeft: [step, 0],
      ArrowRight: [-step, 0],
      ArrowUp: [0, step],
      ArrowDown: [0, -step],
    };
    if (plain && (event.key === '+' || event.key === '=')) zoom(1.25);
    else if (plain && event.key === '-') zoom(0.8);
    else if (plain && event.key === '0') fit();
    else if (plain && event.key === 'Enter' && count === 0 && draft.length > 2) props.finish(draft);
    else if (plain && event.key === 'Backspace' && draft.length) props.set_draft(draft.slice(0, -1));
    else if (plain && event.key in shifts && !chosen.size) set_view(pan(view, ...shifts[event.key]));
    else return props.keys(event, grid);
    event.preventDefault();
    event.stopPropagation();
  };

  // A wheel listener of a component cannot keep the page from scrolling.
  const wheel = useRef<(event: WheelEvent) => void>(() => {});
  wheel.current = event => {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), pixel(event.clientX, event.clientY));
  };
  useEffect(() => {
    const own = canvas.current!;
    const listen = (event: WheelEvent) => wheel.current(event);
    own.addEventListener('wheel', listen, { passive: false });
    return () => own.removeEventListener('wheel', listen);
  }, []);

  return (
    <div class="edit-canvas" ref={box} data-theme-now={theme}>
      {/* biome-ignore lint/a11y/noInteractiveElementToNoninteractiveRole: the canvas reads keys itself. */}
      <canvas
        ref={canvas}
        tabIndex={0}
        role="application"
        aria-label={props.label}
        aria-describedby="canvas-hint"
        data-view={view.scale > 0 ? [...to_world(view, size, 0, 0), view.scale].join(' ') : ''}
        class={tool.name === 'select' ? (drag?.kind === 'pan' ? 'grabs' : hovered ? 'points' : '') : 'draws'}
        onPointerDown={down}
        onPointerMove={move}
        onPointerUp={up}
        onPointerCancel={cancel}
        onPointerLeave={() => {
          if (drag) return;
          set_pointer(null);
          set_hovered('');
          props.pointed(null, grid);
        }}
        onContextMenu={event => event.preventDefault()}
        onDblClick={() => {
          if (count === 0 && draft.length > 2) props.finish(draft);
        }}
        onKeyDown={key}
        onKeyUp={event => {
          if (event.key === ' ') space.current = false;
        }}
        onBlur={() => {
          space.current = false;
        }}
      />
      <div class="edit-zoom" role="group" aria-label="View">
        <button type="button" class="icon" aria-label="Zoom in" onClick={() => zoom(1.4)}>
          +
        </button>
        <button type="button" class="icon" aria-label="Zoom out" onClick={() => zoom(1 / 1.4)}>
          −
        </button>
        <button type="button" class="icon" aria-label="Fit the drawing" title="Fit the drawing (0)" onClick={fit}>
          ⤢
        </button>
      </div>
    </div>
  );
}
