// Chart of curves over time, its cursor linked with the player.

import { effect } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { scaled_unit, show } from '../draw/numbers';
import * as state from './state';

export interface Curve {
  label: string;
  unit: string;
  values: (number | null)[];
}

export interface ChartProps {
  label: string;
  x: number[];
  x_label: string;
  /** Value on the x axis of a frame. */
  x_of: (frame: number) => number;
  curves: Curve[];
  height?: number;
}

// Okabe and Ito's colours, darker in the light theme where they would be faint on white.
const LIGHT = ['#0b5fa5', '#c04a00', '#0a7a55', '#a03a78', '#7a6a00', '#3a7fa8', '#5b3fa0', '#555555'];
const DARK = ['#63b3ff', '#ff9146', '#4fd1a0', '#ee8fc4', '#e6d24a', '#8fd3ff', '#b79cff', '#c0c0c0'];

export function curve_colour(i: number): string {
  return (state.is_dark.value ? DARK : LIGHT)[i % LIGHT.length];
}

/** Largest size of values that are numbers. */
function size_of(curves: Curve[]): number {
  let size = 0;
  for (const curve of curves) {
    for (const value of curve.values) {
      if (value !== null && Number.isFinite(value)) size = Math.max(size, Math.abs(value));
    }
  }
  return size;
}

export const chart_times = { made: 0, cursor: 0 };

export function Chart({ label, x, x_label, x_of, curves, height = 190 }: ChartProps) {
  const box = useRef<HTMLDivElement>(null);
  const dark = state.is_dark.value;
  useEffect(() => {
    const start = performance.now();
    const element = box.current!;
    const ink = dark ? '#c3ccd8' : '#3d4756';
    const grid = { stroke: dark ? '#2e3743' : '#e3e7ec', width: 1 };
    const units = [...new Set(curves.map(c => c.unit))].slice(0, 2);
    const shown = curves.filter(c => units.includes(c.unit));
    const scaled = units.map(unit => scaled_unit(unit, size_of(shown.filter(c => c.unit === unit))));
    const font = '11px system-ui, sans-serif';
    const plot = new uPlot(
      {
        width: Math.max(200, element.clientWidth),
        height,
        legend: { show: false },
        cursor: { drag: { x: false, y: false }, points: { size: 6 } },
        scales: { x: { time: false }, ...Object.fromEntries(units.map((_, i) => [`y${i}`, { auto: true }])) },
        axes: [
          { stroke: ink, grid, ticks: grid, font, labelFont: font, label: x_label, labelSize: 18, size: 30 },
          ...units.map((_, i) => ({
            scale: `y${i}`,
            side: i === 0 ? 3 : 1,
            stroke: ink,
            grid: i === 0 ? grid : { show: false },
            ticks: grid,
            font,
            labelFont: font,
            label: scaled[i].unit || undefined,
            labelSize: scaled[i].unit ? 18 : 0,
            size: 50,
            values: (_: uPlot, splits: number[]) => splits.map(v => show(v, 4)),
          })),
        ],
        series: [
          {},
          ...shown.map((c, i) => ({
            label: c.label,
            scale: `y${units.indexOf(c.unit)}`,
            stroke: curve_colour(i),
            width: 1.6,
            dash: units.indexOf(c.unit) === 1 ? [6, 4] : undefined,
            points: { show: x.length < 3 },
          })),
        ],
      },
      [
        x,
        ...shown.map(c => {
          const { factor } = scaled[units.indexOf(c.unit)];
          return factor === 1 ? c.values : c.values.map(v => (v === null ? null : v / factor));
        }),
      ] as uPlot.AlignedData,
      element,
    );
    const stop = effect(() => {
      const at = performance.now();
      const place = x_of(state.frame.value);
      plot.setCursor({ left: plot.valToPos(place, 'x'), top: 0 }, false);
      chart_times.cursor = performance.now() - at;
    });
    // A click goes to the frame nearest in time.
    const click = (event: MouseEvent) => {
      const rect = plot.over.getBoundingClientRect();
      const wanted = plot.posToVal(event.clientX - rect.left, 'x');
      let best = 0;
      for (let f = 1; f <= state.last_frame(); f++) {
        if (Math.abs(x_of(f) - wanted) < Math.abs(x_of(best) - wanted)) best = f;
      }
      state.go_to(best);
    };
    plot.over.addEventListener('click', click);
    const leave = () => plot.setCursor({ left: plot.valToPos(x_of(state.frame.value), 'x'), top: 0 }, false);
    plot.over.addEventListener('mouseleave', leave);
    const watch = new ResizeObserver(() => {
      if (element.clientWidth > 50) plot.setSize({ width: element.clientWidth, height });
      leave();
    });
    watch.observe(element);
    chart_times.made = performance.now() - start;
    return () => {
      stop();
      watch.disconnect();
      plot.destroy();
    };
  }, [x, curves, dark, height]);
  return <div class="chart" ref={box} role="img" aria-label={label} />;
}
