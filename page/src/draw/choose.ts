// Chooses between WebGL2 and a plain canvas for the bodies by the time that each takes for the same figure.

import { type Figure, paint_bodies, screen_of } from './paint';
import { CanvasPen } from './pen';
import type { WebglBodies } from './webgl';

/** Milliseconds of one picture. */
export interface Cost {
  webgl: number;
  canvas: number;
}

/** Bodies below which both are fast enough. */
const FEW = 300;

/** WebGL2 leaves the script free, so it may take somewhat longer. */
const LONGER = 1.3;

export const is_worth_measuring = (figure: Figure): boolean => figure.pose.geometry.bodies >= FEW;

export const is_webgl_faster = ({ webgl, canvas }: Cost): boolean => webgl <= LONGER * canvas;

/** Shortest of `count` times, after one picture that makes shaders and buffers. */
function shortest(count: number, work: () => void): number {
  work();
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < count; i++) {
    const start = performance.now();
    work();
    least = Math.min(least, performance.now() - start);
  }
  return least;
}

/** Draws a figure some times in both ways; reading one pixel waits until a picture is complete. */
export function measure(webgl: WebglBodies, figure: Figure, ratio: number): Cost {
  const canvas = document.createElement('canvas');
  canvas.width = Math.round(figure.size.width * ratio);
  canvas.height = Math.round(figure.size.height * ratio);
  const c = canvas.getContext('2d')!;
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  const pen = new CanvasPen(c);
  const screen = screen_of(figure, figure.pose.places);
  return {
    webgl: shortest(3, () => {
      webgl.draw(figure, ratio);
      webgl.wait();
    }),
    canvas: shortest(3, () => {
      paint_bodies(pen, figure, screen);
      c.getImageData(0, 0, 1, 1);
    }),
  };
}
