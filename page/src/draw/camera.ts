// Camera: the place at the middle of the drawing and the pixels per unit of length.

export interface Camera {
  x: number;
  y: number;
  scale: number;
}

export interface Size {
  width: number;
  height: number;
}

export interface Box {
  left: number;
  bottom: number;
  right: number;
  top: number;
}

export function empty_box(): Box {
  return { left: Infinity, bottom: Infinity, right: -Infinity, top: -Infinity };
}

/** Adds places, x, y in turn. */
export function add_places(box: Box, places: ArrayLike<number>): void {
  for (let i = 0; i < places.length; i += 2) {
    const x = places[i];
    const y = places[i + 1];
    if (x < box.left) box.left = x;
    if (x > box.right) box.right = x;
    if (y < box.bottom) box.bottom = y;
    if (y > box.top) box.top = y;
  }
}

/** Room kept free at the edges of the drawing, in pixels: tools on top, legend and scale bar below. */
export interface Margins {
  top: number;
  right: number;
  bottom: number;
  left: number;
}

export function fit(box: Box, size: Size, margins: Margins): Camera {
  const width = Math.max(20, size.width - margins.left - margins.right);
  const height = Math.max(20, size.height - margins.top - margins.bottom);
  const wide = box.right - box.left || 1;
  const high = box.top - box.bottom || 1;
  const scale = Math.min(width / wide, height / high);
  const x = (box.left + box.right) / 2 + (margins.right - margins.left) / 2 / scale;
  const y = (box.bottom + box.top) / 2 + (margins.top - margins.bottom) / 2 / scale;
  return { x, y, scale };
}

export function to_screen(camera: Camera, size: Size, x: number, y: number): [number, number] {
  return [size.width / 2 + (x - camera.x) * camera.scale, size.height / 2 - (y - camera.y) * camera.scale];
}

export function to_world(camera: Camera, size: Size, sx: number, sy: number): [number, number] {
  return [camera.x + (sx - size.width / 2) / camera.scale, camera.y - (sy - size.height / 2) / camera.scale];
}

/** Moves the drawing by pixels, right and down. */
export function pan(camera: Camera, dx: number, dy: number): Camera {
  return { ...camera, x: camera.x - dx / camera.scale, y: camera.y + dy / camera.scale };
}

/** Zooms by a factor, within limits, and keeps the place under a pixel where it is. */
export function zoom(camera: Camera, size: Size, factor: number, sx: number, sy: number): Camera {
  const [x, y] = to_world(camera, size, sx, sy);
  const scale = Math.min(1e12, Math.max(1e-9, camera.scale * factor));
  return { scale, x: x - (sx - size.width / 2) / scale, y: y + (sy - size.height / 2) / scale };
}
