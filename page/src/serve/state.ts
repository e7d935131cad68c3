// State of the window: folder, jobs, route.

import { computed, signal } from '@preact/signals';
import * as api from './api';
import { cases_of } from './cases';
import type { Schema, Units } from './edit/schema';
import { has_news } from './job_news';

export { link, type Route, route_of } from './routes';

export const listing = signal<api.Listing | null>(null);
export const jobs = signal<api.Job[]>([]);
export const trouble = signal('');
export const route = signal(location.hash);
/** Case file that a conversion wrote last, and the words of the program on it. */
export const converted = signal({ path: '', messages: '' });
/** Files with changes that are not saved; only the view of the case sets them. */
export const unsaved = signal<string[]>([]);

/** Units of the case that was checked last, by the letters of their dimensions. */
export const units = signal<Units>({});

/** Schema of a case file and of the settings. Without it there are no tables and no completion. */
export const schema = signal<Schema | null>(null);

/** Schema of joint sets and outlines. Without it their forms have the keys as labels. */
export const joint_schema = signal<Schema | null>(null);

/** Reads both schemas once. */
export function read_schema(): void {
  const read = (own: typeof schema, ask: () => Promise<Record<string, unknown>>) => {
    if (own.value) return;
    void ask()
      .then(reply => {
        own.value = reply as Schema;
      })
      .catch(() => {});
  };
  read(schema, api.schema);
  read(joint_schema, api.joint_schema);
}

export const cases = computed(() => cases_of(listing.value?.files ?? []));

export function go(hash: string): void {
  location.hash = hash;
}

/** Does something with the server; what it refuses is shown until something else succeeds or the route changes. */
export async function attempt<T>(work: () => Promise<T>): Promise<T | null> {
  try {
    const value = await work();
    trouble.value = '';
    return value;
  } catch (error) {
    report(error);
    return null;
  }
}

/** Shows why a request failed. */
function report(error: unknown): void {
  trouble.value = error instanceof Error ? error.message : String(error);
}

/** Lists the folder. Its success leaves what another request has reported. */
export async function refresh(): Promise<void> {
  try {
    listing.value = await api.list();
  } catch (error) {
    report(error);
  }
}

let busy = false;

/** Asks for jobs; lists the folder anew if they may have changed it. */
export async function refresh_jobs(): Promise<void> {
  if (busy) return;
  busy = true;
  try {
    const now = await api.jobs();
    const has_changed = has_news(jobs.value, now);
    jobs.value = now;
    if (trouble.value.startsWith('The server does not answer')) trouble.value = '';
    if (has_changed) await refresh();
  } catch (error) {
    report(error);
  } finally {
    busy = false;
  }
}

export function start_clock(): void {
  const tick = async () => {
    if (!document.hidden) await refresh_jobs();
    const is_busy = jobs.value.some(job => job.state === 'runs' || job.state === 'waits');
    setTimeout(tick, is_busy ? 700 : 4000);
  };
  void tick();
  document.addEventListener('visibilitychange', () => {
    if (!document.hidden) void refresh();
  });
}

export function when(time: number): string {
  return new Date(time * 1000).toLocaleString('en-GB', {
    day: 'numeric',
    month: 'short',
    year: 'numeric',
    hour: '2-digit',
    minute: '2-digit',
  });
}
