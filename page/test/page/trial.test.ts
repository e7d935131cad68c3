// A new user's way through the window, with its actions counted: clicks, choices and fields. Set KEYBLOCK to the path of
// the program.

import type { ChildProcess } from 'node:child_process';
import { copyFileSync, mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { figure, has_browser, launch, open_window, start_server } from './browser';

const program = process.env.KEYBLOCK ?? '';
const source = new URL('../../../legacy_cases/sliding_block/a30_p20/', import.meta.url);

describe.skipIf(!has_browser || !program)('trial', () => {
  let browser: Browser;
  const servers: ChildProcess[] = [];
  const errors: string[] = [];
  let actions = 0;
  let page: Page;

  /** Counts one action; a question that the window asks counts as another. */
  async function act(action: Promise<unknown>): Promise<void> {
    actions++;
    await action;
  }

  async function begin(folder: string): Promise<void> {
    const own = start_server(program, folder);
    servers.push(own.server);
    actions = 0;
    page = await open_window(browser, await own.address, errors);
    page.on('dialog', () => actions++);
  }

  const button = (name: string) => page.getByRole('button', { name, exact: true }).click();
  const finished = (result: string) =>
    page.locator('.job').filter({ hasText: result }).getByText('finished').waitFor({ timeout: 60_000 });

  beforeAll(async () => {
    browser = await launch();
  });
  afterAll(async () => {
    await browser?.close();
    for (const own of servers) own.kill('SIGINT');
    expect(errors).toEqual([]);
  });

  test('an old file is opened, run, changed, run and compared; a figure follows', async () => {
    const folder = mkdtempSync(join(tmpdir(), 'keyblock-trial-'));
    for (const name of ['a30_p20.geo', 'a30_p20.ana']) copyFileSync(new URL(name, source), join(folder, name));
    await begin(folder);
    await act(page.getByRole('navigation').getByRole('link', { name: 'a30_p20' }).first().click());
    await act(button('Run'));
    await finished('a30_p20_run');
    await act(page.getByLabel('File', { exact: true }).selectOption('a30_p20.ana'));
    const text = page.locator('textarea');
    await expect.poll(() => text.inputValue()).toContain('<Friction>');
    await act(text.fill((await text.inputValue()).replace(/<Friction> *20 *</, '<Friction> 25 <')));
    await act(button('Run'));
    await finished('a30_p20_run_2');
    await act(page.locator('.job').filter({ hasText: 'a30_p20_run_2' }).getByRole('link', { name: 'Open' }).click());
    await act(page.getByLabel('Compare with').selectOption('a30_p20_run'));
    await page.getByText('<Friction> 25 </Friction>').waitFor();
    figure('actions: old file opened, changed, run, compared', `${actions}, at most 10`);
    expect(actions).toBeLessThanOrEqual(10);

    actions = 0;
    await act(page.locator('.compare').getByRole('link', { name: 'a30_p20_run_2' }).click());
    const frame = page.frameLocator('iframe');
    await act(frame.getByText('Save', { exact: true }).click());
    const saved = page.waitForEvent('download');
    await act(frame.getByText('Drawing, SVG').click());
    expect(readFileSync(await (await saved).path(), 'utf8')).toContain('<svg');
    figure('actions: figure for a paper', `${actions}, at most 3`);
    expect(actions).toBeLessThanOrEqual(3);
    await page.context().close();
  });

  test('a slope with two joint sets is drawn from nothing, to its factor and a page for the client', async () => {
    await begin(mkdtempSync(join(tmpdir(), 'keyblock-trial-')));
    await act(page.getByRole('link', { name: 'New scene' }).first().click());
    const outline: Record<string, string> = {
      'Height [m]': '20',
      'Angle [°]': '60',
      'Toe [m]': '8',
      'Crest [m]': '18',
      'Base [m]': '4',
    };
    for (const [label, value] of Object.entries(outline)) await act(page.getByLabel(label).fill(value));
    for (const [i, values] of [
      ['35', '3', '40'],
      ['118', '3', '30'],
    ].entries()) {
      const set = page.locator('fieldset.set').nth(i);
      for (const [j, label] of [/^Dip/, /^Spacing/, /^Friction angle/].entries())
        await act(set.getByLabel(label).fill(values[j]));
    }
    await page.getByText('94 blocks').waitFor();
    await act(button('Create the case'));
    await act(button('Factor of safety'));
    await page.getByText(/Factor of safety 1\.08/).waitFor({ timeout: 120_000 });
    await act(page.locator('.job').getByRole('link', { name: 'Open' }).click());
    const saved = page.waitForEvent('download');
    await act(page.getByRole('link', { name: 'Save a report' }).click());
    expect(readFileSync(await (await saved).path(), 'utf8')).toContain('Factor of safety 1.08');
    figure('actions: slope from nothing to factor and report', `${actions}, at most 30`);
    expect(actions).toBeLessThanOrEqual(30);
    await page.context().close();
  });
});
