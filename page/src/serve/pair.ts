// Links the frames of two runs: by time, or by step if a run is static, whose times are those of load steps.

import type { FrameHead } from '../data/contract';

/** Place of a frame in its run. */
export const place_of = (frame: FrameHead, by_step: boolean): number => (by_step ? frame.step : frame.time);

/** Last place of a run. */
export const last_place = (frames: FrameHead[], by_step: boolean): number =>
  place_of(frames[frames.length - 1], by_step) || 1;

/** Frame of a run nearest to a place; the last of several. */
export function frame_at(frames: FrameHead[], by_step: boolean, place: number): number {
  const distance = (f: number) => Math.abs(place_of(frames[f], by_step) - place);
  let best = 0;
  for (let f = 1; f < frames.length; f++) if (distance(f) <= distance(best)) best = f;
  return best;
}
