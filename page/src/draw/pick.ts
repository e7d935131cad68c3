// Finds the body, contact or mark under the pointer.

import { is_inside } from './rings';
import { body_area, type Pose } from './scene';

/** Row of the body that contains a place, by even-odd; the last one drawn if several do. */
export function pick_body(pose: Pose, x: number, y: number): number | null {
  for (let row = pose.geometry.bodies - 1; row >= 0; row--) if (contains(pose, row, x, y)) return row;
  return null;
}

function contains({ geometry, places }: Pose, row: number, x: number, y: number): boolean {
  return is_inside(places, geometry.loop_start, geometry.body_loop[row], geometry.body_loop[row + 1], x, y);
}

/** Index of the point nearest to a place within a distance. */
export function pick_point(points: ArrayLike<number>, x: number, y: number, reach: number): number | null {
  let best: number | null = null;
  let least = reach * reach;
  for (let i = 0; i < points.length; i += 2) {
    const dx = points[i] - x;
    const dy = points[i + 1] - y;
    const distance = dx * dx + dy * dy;
    if (distance <= least) {
      least = distance;
      best = i >> 1;
    }
  }
  return best;
}

/** Index of the segment (x1, y1, x2, y2 in turn) nearest to a place within a distance. */
export function pick_segment(ends: ArrayLike<number>, x: number, y: number, reach: number): number | null {
  let best: number | null = null;
  let least = reach * reach;
  for (let i = 0; i < ends.length; i += 4) {
    const dx = ends[i + 2] - ends[i];
    const dy = ends[i + 3] - ends[i + 1];
    const length = dx * dx + dy * dy || 1;
    const t = Math.max(0, Math.min(1, ((x - ends[i]) * dx + (y - ends[i + 1]) * dy) / length));
    const px = ends[i] + t * dx - x;
    const py = ends[i + 1] + t * dy - y;
    const distance = px * px + py * py;
    if (distance <= least) {
      least = distance;
      best = i >> 2;
    }
  }
  return best;
}

/** Width of a typical body: the square root of its share of all area. */
export function typical_size(pose: Pose): number {
  const { geometry, places } = pose;
  let area = 0;
  for (let row = 0; row < geometry.bodies; row++) area += body_area(geometry, places, row);
  return Math.sqrt(area / Math.max(1, geometry.bodies)) || 1;
}
