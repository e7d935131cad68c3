// Areas and insides of rings: vertices are x, y in turn, and loop l has those from starts[l] to starts[l + 1].

/** Area of a ring of vertices, positive if they go anticlockwise. */
export function area_of(places: ArrayLike<number>, from: number, to: number): number {
  let sum = 0;
  for (let v = from, before = to - 1; v < to; before = v++) {
    sum += places[2 * before] * places[2 * v + 1] - places[2 * v] * places[2 * before + 1];
  }
  return sum / 2;
}

/** True if a place lies inside loops, by even and odd crossings. */
export function is_inside(
  places: ArrayLike<number>,
  starts: ArrayLike<number>,
  from: number,
  to: number,
  x: number,
  y: number,
): boolean {
  let inside = false;
  for (let l = from; l < to; l++) {
    for (let v = starts[l], before = starts[l + 1] - 1; v < starts[l + 1]; before = v++) {
      const y0 = places[2 * before + 1];
      const y1 = places[2 * v + 1];
      if (y0 > y === y1 > y) continue;
      const x0 = places[2 * before];
      if (x < x0 + ((y - y0) / (y1 - y0)) * (places[2 * v] - x0)) inside = !inside;
    }
  }
  return inside;
}
