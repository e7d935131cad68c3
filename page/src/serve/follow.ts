// Brings new frames of a run into its page, and tells what becomes of the run.

import type { Update } from '../data/contract';
import * as api from './api';

/** Page of a run in a frame of the window; see view/live.ts. */
export interface LivePage {
  state: { is_running: { value: boolean }; head: { run: unknown } };
  live: {
    shown(): { after: number; epoch: number; contacts: boolean };
    append(update: Update): Promise<void>;
    renew(page: string): Promise<void>;
  };
  verdict(): string;
}

const PAUSE = 1000;

const pause = () => new Promise(resolve => setTimeout(resolve, PAUSE));

/** Hidden windows ask for nothing: a browser has six connections for all of them. */
function seen(): Promise<void> {
  return new Promise(resolve => {
    if (!document.hidden) return resolve();
    document.addEventListener('visibilitychange', () => resolve(), { once: true });
  });
}

/** Follows a result until `end` is aborted or the result is gone; `tell` gets sentences for the reader. */
export async function follow(
  path: string,
  page: LivePage,
  end: AbortSignal,
  tell: (sentence: string) => void,
): Promise<void> {
  let stamp = '';
  let was_running: boolean | null = null;
  while (!end.aborted) {
    await seen();
    if (end.aborted) return;
    try {
      const { after, epoch, contacts } = page.live.shown();
      const asked = {
        after: String(after),
        epoch: String(epoch),
        stamp,
        running: was_running ? '1' : '0',
        contacts: contacts ? '1' : '0',
      };
      const news = await api.live(path, asked, end);
      if (end.aborted) return;
      if (news.frames) await page.live.append(news as Update);
      stamp = news.stamp ?? stamp;
      const is_running = news.is_running;
      const has_ended = !is_running && (was_running ?? page.state.head.run === null);
      if (news.is_anew || has_ended) {
        await page.live.renew(await api.page(path));
        stamp = '';
      }
      if (is_running === was_running) continue;
      page.state.is_running.value = is_running;
      if (is_running) tell(was_running === false ? 'The run goes on.' : '');
      else if (was_running) tell(`The run has ended: ${page.verdict().toLowerCase()}.`);
      was_running = is_running;
    } catch (error) {
      if (error instanceof api.RequestError && error.status === 404) {
        page.state.is_running.value = false;
        return tell('The result was removed.');
      }
      await pause();
    }
  }
}
