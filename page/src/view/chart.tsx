// Chart of curves over time, its cursor linked with the player: a click or a drag goes to a time.

import { effect } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { type ChartPlan, type Curve, draw_chart, x_value } from '../draw/chart';
import { CanvasPen } from '../draw/pen';
import * as state from './state';

export type { Curve };

export interface ChartProps {
  label: string;
  x: number[];
  x_label: string;
  /** Value on the x axis of a frame. */
  x_of: (frame: number) => number;
  curves: Curve[];
  height?: number;
}

export function curve_colour(i: number): string {
  const { classes } = state.paint.value;
  return classes[i % classes.length];
}

/** Time of drawing, place of the cursor and number of values, for the tests of the page. */
export const chart_times = { drawn: 0, cursor: 0, values: 0 };

export function Chart({ label, x, x_label, x_of, curves, height = 200 }: ChartProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const plan = useRef<ChartPlan | null>(null);
  useEffect(() => {
    const element = canvas.current!;
    const c = element.getContext('2d')!;
    const pen = new CanvasPen(c);
    const draw = () => {
      const width = element.clientWidth;
      if (width < 50) return;
      const start = performance.now();
      const ratio = window.devicePixelRatio || 1;
      element.width = Math.round(width * ratio);
      element.height = Math.round(height * ratio);
      c.setTransform(ratio, 0, 0, ratio, 0, 0);
      const dark = state.is_dark.value;
      const own: ChartPlan = {
        width,
        height,
        x,
        x_label,
        curves,
        colours: state.paint.value.classes,
        paint: state.paint.value,
        grid: dark ? '#2c3541' : '#e3e7ec',
        cursor: x_of(state.frame.value),
      };
      plan.current = own;
      draw_chart(pen, own);
      chart_times.drawn = performance.now() - start;
      chart_times.cursor = own.cursor ?? 0;
      chart_times.values = x.length;
    };
    const stop = effect(draw);
    const watch = new ResizeObserver(draw);
    watch.observe(element);
    return () => {
      stop();
      watch.disconnect();
    };
  }, [x, curves, x_label, height]);

  const go = (event: PointerEvent) => {
    if (!plan.current || !(event.buttons & 1)) return;
    const rect = canvas.current!.getBoundingClientRect();
    const wanted = x_value(plan.current, event.clientX - rect.left);
    let best = 0;
    for (let f = 1; f <= state.last_frame(); f++) {
      if (Math.abs(x_of(f) - wanted) < Math.abs(x_of(best) - wanted)) best = f;
    }
    state.go_to(best);
  };
  return (
    <canvas
      class="chart"
      ref={canvas}
      style={{ height: `${height}px` }}
      role="img"
      aria-label={label}
      onPointerDown={event => {
        event.currentTarget.setPointerCapture(event.pointerId);
        go(event);
      }}
      onPointerMove={go}
    />
  );
}
