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

  test('a drawing without analysis says so, gets one, and runs', async () => {
    const folder = mkdtempSync(join(tmpdir(), 'keyblock-trial-'));
    copyFileSync(new URL('../../../docs/bench.dxf', import.meta.url), join(folder, 'bench.dxf'));
    await begin(folder);
    await act(page.getByRole('navigation').getByRole('link', { name: 'bench.dxf' }).first().click());
    await page.getByText('an analysis is missing').waitFor();
    expect(await page.getByText('No problem found').count()).toBe(0);
    expect(await page.getByRole('button', { name: 'Run', exact: true }).isDisabled()).toBe(true);
    await act(button('Add an analysis'));
    await expect.poll(() => page.locator('.edit-state').textContent(), { timeout: 30_000 }).toMatch(/\d+ blocks/);
    const own = page.getByRole('button', { name: 'Run', exact: true });
    await expect.poll(() => own.isEnabled(), { timeout: 30_000 }).toBe(true);
    const text = await page.locator('textarea').inputValue();
    expect(text.match(/"friction_angle_deg": 30/g)).toHaveLength(2);
    await page.context().close();
  });
});
