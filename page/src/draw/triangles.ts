// Cuts bodies into triangles: a fan for convex ones, ears for others, holes joined to their outline by bridges.

import type { Geometry } from '../data/decode';
import { area_of } from './rings';

/** Twice the area of a triangle, positive if anticlockwise. */
function turn(p: Float32Array, a: number, b: number, c: number): number {
  return (p[2 * b] - p[2 * a]) * (p[2 * c + 1] - p[2 * a + 1]) - (p[2 * c] - p[2 * a]) * (p[2 * b + 1] - p[2 * a + 1]);
}

function crosses(p: Float32Array, a: number, b: number, c: number, d: number): boolean {
  if (a === c || a === d || b === c || b === d) return false;
  return turn(p, a, b, c) > 0 !== turn(p, a, b, d) > 0 && turn(p, c, d, a) > 0 !== turn(p, c, d, b) > 0;
}

/** Joins a hole to the outline where the shortest bridge crosses nothing. */
function bridge(p: Float32Array, outline: number[], hole: number[], others: number[][]): number[] {
  let best: [number, number] | null = null;
  let least = Infinity;
  const rings = [outline, hole, ...others];
  for (let i = 0; i < outline.length; i++) {
    for (let j = 0; j < hole.length; j++) {
      const [a, b] = [outline[i], hole[j]];
      const distance = (p[2 * a] - p[2 * b]) ** 2 + (p[2 * a + 1] - p[2 * b + 1]) ** 2;
      if (distance >= least) continue;
      const blocked = rings.some(ring => ring.some((c, k) => crosses(p, a, b, c, ring[(k + 1) % ring.length])));
      if (blocked) continue;
      best = [i, j];
      least = distance;
    }
  }
  if (!best) return outline;
  const [i, j] = best;
  return [...outline.slice(0, i + 1), ...hole.slice(j), ...hole.slice(0, j + 1), ...outline.slice(i)];
}

function ears(p: Float32Array, ring: number[], out: number[]): void {
  const left = ring.slice();
  let tries = 0;
  let i = 0;
  while (left.length > 3 && tries < left.length) {
    const n = left.length;
    const [a, b, c] = [left[(i + n - 1) % n], left[i % n], left[(i + 1) % n]];
    let is_ear = turn(p, a, b, c) > 0;
    if (is_ear) {
      for (const d of left) {
        if (d === a || d === b || d === c) continue;
        if (turn(p, a, b, d) >= 0 && turn(p, b, c, d) >= 0 && turn(p, c, a, d) >= 0) {
          // Ends of bridges stand twice in the ring: a copy of a corner does not block it.
          const is_copy = [a, b, c].some(e => p[2 * e] === p[2 * d] && p[2 * e + 1] === p[2 * d + 1]);
          if (!is_copy) {
            is_ear = false;
            break;
          }
        }
      }
    } else if (turn(p, a, b, c) === 0) {
      // A straight corner holds no area.
      left.splice(i % n, 1);
      tries = 0;
      i = left.length ? i % left.length : 0;
      continue;
    }
    if (is_ear) {
      out.push(a, b, c);
      left.splice(i % n, 1);
      tries = 0;
      i %= left.length;
    } else {
      i = (i + 1) % n;
      tries++;
    }
  }
  // The rest of a ring that crosses itself is filled as a fan.
  for (let k = 2; k < left.length; k++) out.push(left[0], left[k - 1], left[k]);
}

/** Indices of vertices, three a triangle, in the undeformed places; and the body of each triangle. */
export function triangles_of(geometry: Geometry): Uint32Array {
  const { place, body_loop, loop_start } = geometry;
  const out: number[] = [];
  for (let b = 0; b < geometry.bodies; b++) {
    // The outline goes anticlockwise, holes clockwise.
    const rings: number[][] = [];
    for (let l = body_loop[b]; l < body_loop[b + 1]; l++) {
      const [from, to] = [loop_start[l], loop_start[l + 1]];
      if (to - from < 3) continue;
      const ring = Array.from({ length: to - from }, (_, i) => from + i);
      const area = area_of(place, from, to);
      if (rings.length ? area > 0 : area < 0) ring.reverse();
      rings.push(ring);
    }
    if (!rings.length) continue;
    const [outline, ...holes] = rings;
    if (!holes.length) {
      let is_convex = true;
      const n = outline.length;
      for (let i = 0; i < n && is_convex; i++) {
        is_convex = turn(place, outline[i], outline[(i + 1) % n], outline[(i + 2) % n]) >= 0;
      }
      if (is_convex) {
        for (let i = 2; i < n; i++) out.push(outline[0], outline[i - 1], outline[i]);
      } else {
        ears(place, outline, out);
      }
      continue;
    }
    let ring = outline;
    holes.forEach((hole, i) => {
      ring = bridge(place, ring, hole, holes.slice(i + 1));
    });
    ears(place, ring, out);
  }
  return Uint32Array.from(out);
}
