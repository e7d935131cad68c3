// Draws curves with a pen: axes with round ticks, up to two units, a cursor.

import { raised, type Scaled, scaled_unit, show, ticks_of } from './numbers';
import type { Paint } from './paint';
import type { Pen } from './pen';

export interface Curve {
  label: string;
  unit: string;
  values: (number | null)[];
}

export interface ChartPlan {
  width: number;
  height: number;
  x: number[];
  x_label: string;
  curves: Curve[];
  colours: string[];
  paint: Paint;
  grid: string;
  cursor: number | null;
}

interface Axis {
  low: number;
  high: number;
  factor: number;
  unit: string;
  ticks: number[];
}

/** Room about the plot, in pixels. */
export function plot_box(plan: Pick<ChartPlan, 'width' | 'height' | 'curves'>) {
  const units = units_of(plan.curves);
  return { left: 54, right: plan.width - (units.length > 1 ? 54 : 12), top: 22, bottom: plan.height - 38 };
}

/** Units of the curves, two at most; curves of others are not drawn. */
export function units_of(curves: Curve[]): string[] {
  return [...new Set(curves.map(curve => curve.unit))].slice(0, 2);
}

/** Ticks of an axis, three at least where that is possible. */
function some_ticks(low: number, high: number, count: number): number[] {
  const ticks = ticks_of(low, high, count);
  return ticks.length < 3 ? ticks_of(low, high, 2 * count) : ticks;
}

/** Takes a power of ten into the unit if ticks would need it: they have few digits and one notation. */
function with_power({ factor, unit }: Scaled, size: number): Scaled {
  const power = size > 0 ? Math.floor(Math.log10(size / factor)) : 0;
  if (power > -3 && power < 5) return { factor, unit };
  return { factor: factor * 10 ** power, unit: `${unit ? '' : '×'}10${raised(power)} ${unit}`.trim() };
}

function axis_of(curves: Curve[]): Axis {
  let low = Infinity;
  let high = -Infinity;
  for (const curve of curves) {
    for (const value of curve.values) {
      if (value === null || !Number.isFinite(value)) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  if (!(high >= low)) [low, high] = [0, 1];
  const { factor, unit } = with_power(
    scaled_unit(curves[0]?.unit ?? '', Math.max(Math.abs(low), Math.abs(high))),
    Math.max(Math.abs(low), Math.abs(high)),
  );
  low /= factor;
  high /= factor;
  if (high === low) {
    const room = Math.abs(high) * 0.1 || 1;
    low -= room;
    high += room;
  } else {
    const room = (high - low) * 0.06;
    low -= room;
    high += room;
  }
  return { low, high, factor, unit, ticks: some_ticks(low, high, 4) };
}

/** Place on the x axis of a value, in pixels. */
export function x_place(plan: ChartPlan, value: number): number {
  const box = plot_box(plan);
  const first = plan.x[0] ?? 0;
  const last = plan.x[plan.x.length - 1] ?? 1;
  return box.left + ((value - first) / (last - first || 1)) * (box.right - box.left);
}

/** Value on the x axis of a place in pixels. */
export function x_value(plan: ChartPlan, place: number): number {
  const box = plot_box(plan);
  const first = plan.x[0] ?? 0;
  const last = plan.x[plan.x.length - 1] ?? 1;
  return first + ((place - box.left) / (box.right - box.left || 1)) * (last - first);
}

/** Index of the row nearest to a value on the x axis; the last of equal ones. */
export function nearest_row(x: number[], value: number): number {
  let best = 0;
  for (let i = 1; i < x.length; i++) if (Math.abs(x[i] - value) <= Math.abs(x[best] - value)) best = i;
  return best;
}

export function draw_chart(pen: Pen, plan: ChartPlan): void {
  const { paint, grid } = plan;
  const box = plot_box(plan);
  const units = units_of(plan.curves);
  const axes = units.map(unit => axis_of(plan.curves.filter(curve => curve.unit === unit)));
  const style = { size: 11, colour: paint.muted };
  const y_place = (axis: Axis, value: number) =>
    box.bottom - ((value / axis.factor - axis.low) / (axis.high - axis.low)) * (box.bottom - box.top);

  const first = plan.x[0] ?? 0;
  const last = plan.x[plan.x.length - 1] ?? 1;
  for (const tick of some_ticks(first, last, Math.max(2, Math.floor((box.right - box.left) / 70)))) {
    const at = x_place(plan, tick);
    pen.segments([at, box.top, at, box.bottom], { colour: grid, width: 1 });
    pen.text(at, box.bottom + 15, show(tick, 4), { ...style, anchor: 'middle' });
  }
  pen.text((box.left + box.right) / 2, plan.height - 6, plan.x_label, { ...style, anchor: 'middle' });
  axes.forEach((axis, side) => {
    const edge = side === 0 ? box.left : box.right;
    for (const tick of axis.ticks) {
      const at = y_place(axis, tick * axis.factor);
      if (side === 0) pen.segments([box.left, at, box.right, at], { colour: grid, width: 1 });
      const anchor = side === 0 ? 'end' : 'start';
      pen.text(edge + (side === 0 ? -6 : 6), at + 4, show(tick, 4), { ...style, anchor });
    }
    const name = axis.unit || (units.length > 1 ? 'no unit' : '');
    // The name is longer than the room at the edge: it begins or ends at the edge of the picture.
    const at = side === 0 ? 2 : plan.width - 2;
    if (name) pen.text(at, 12, name, { ...style, anchor: side === 0 ? 'start' : 'end', weight: 600 });
  });
  const zero = axes[0] && axes[0].low < 0 && axes[0].high > 0 ? y_place(axes[0], 0) : box.bottom;
  pen.segments([box.left, zero, box.right, zero], { colour: paint.muted, width: 1 });

  const row = plan.cursor === null ? -1 : nearest_row(plan.x, plan.cursor);
  if (plan.cursor !== null) {
    const at = Math.max(box.left, Math.min(box.right, x_place(plan, plan.cursor)));
    pen.segments([at, box.top, at, box.bottom], { colour: paint.stick, width: 1.5 });
  }
  plan.curves.forEach((curve, i) => {
    const side = units.indexOf(curve.unit);
    if (side < 0) return;
    const line = { colour: plan.colours[i % plan.colours.length], width: 1.7, dash: side === 1 ? [6, 4] : undefined };
    let run: number[] = [];
    const flush = () => {
      if (run.length === 2) pen.circle(run[0], run[1], 2, line.colour, null);
      else if (run.length) pen.polyline(run, line);
      run = [];
    };
    curve.values.forEach((value, r) => {
      if (value === null || !Number.isFinite(value)) flush();
      else run.push(x_place(plan, plan.x[r]), y_place(axes[side], value));
    });
    flush();
    const value = curve.values[row];
    if (row >= 0 && value !== null && value !== undefined && Number.isFinite(value)) {
      pen.circle(x_place(plan, plan.x[row]), y_place(axes[side], value), 4, line.colour, {
        colour: paint.surface,
        width: 1.5,
      });
    }
  });
}
