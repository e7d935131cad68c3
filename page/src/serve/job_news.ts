// Decides from two lists of jobs whether the folder has changed.

import type { Job } from './api';

/** True if the results may be others: a job came, ended, or began to step. Both profiles of a job begin at step 1. */
export function has_news(before: Job[], now: Job[]): boolean {
  if (before.length !== now.length) return true;
  return now.some(job => {
    const old = before.find(own => own.id === job.id);
    if (!old || old.state !== job.state) return true;
    const [from, to] = [old.step ?? 0, job.step ?? 0];
    return to < from || (from === 0 && to > 0);
  });
}
