// The whole round of an old file in the window: open, edit, run, watch, pause, compare, save, reopen. Set KEYBLOCK to
// the path of the program.

import type { ChildProcess } from 'node:child_process';
import { copyFileSync, mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { has_browser, launch, open_window, shot, start_server } from './browser';

const program = process.env.KEYBLOCK ?? '';
const source = new URL('../../../legacy_cases/sliding_block/a30_p20/', import.meta.url);

describe.skipIf(!has_browser || !program)('round of an old file', () => {
  let browser: Browser;
  let server: ChildProcess;
  let address = '';
  let page: Page;
  const errors: string[] = [];
  const folder = mkdtempSync(join(tmpdir(), 'keyblock-round-'));
  const record = (result: string) => JSON.parse(readFileSync(join(folder, result, 'run.json'), 'utf8'));

  async function open(): Promise<Page> {
    const own = await open_window(browser, address, errors, { viewport: { width: 1280, height: 900 } });
    await own.getByRole('navigation').getByRole('link', { name: 'a30_p20' }).first().click();
    await own.getByLabel('File', { exact: true }).selectOption('a30_p20.ana');
    await expect.poll(() => own.locator('textarea').inputValue()).toContain('<Friction>');
    return own;
  }

  /** Changes the text of the analysis file and saves it. */
  async function change(from: string | RegExp, to: string): Promise<void> {
    const text = page.locator('textarea');
    await page.getByLabel('File', { exact: true }).selectOption('a30_p20.ana');
    await expect.poll(() => text.inputValue()).toContain('<Friction>');
    const before = await text.inputValue();
    await text.fill(before.replace(from, to));
    await page.getByRole('button', { name: 'Save', exact: true }).click();
    await expect.poll(() => readFileSync(join(folder, 'a30_p20.ana'), 'utf8')).toContain(to);
    await page.waitForFunction(() => document.body.textContent?.includes('Unknowns'));
  }

  async function run(result: string, button = 'Run'): Promise<void> {
    await page.getByLabel('Result folder').fill(result);
    await page.getByRole('button', { name: button, exact: true }).click();
    await page.locator('.job', { hasText: result }).first().waitFor();
  }

  const job = (result: string) => page.locator('.job').filter({ has: page.locator('b', { hasText: result }) });

  beforeAll(async () => {
    for (const name of ['a30_p20.geo', 'a30_p20.ana']) copyFileSync(new URL(name, source), join(folder, name));
    browser = await launch();
    const own = start_server(program, folder);
    server = own.server;
    address = await own.address;
  });
  afterAll(async () => {
    await browser?.close();
    server?.kill('SIGINT');
    expect(errors).toEqual([]);
  });

  test('it is opened, edited, run, watched, compared, saved and reopened', async () => {
    page = await open();
    await change('timesteps="1000"', 'timesteps="100"');
    await run('first');
    await job('first').getByText('finished').waitFor({ timeout: 60_000 });
    await change(/<Friction> *20 *</, '<Friction> 25 <');
    const saved = await page.locator('textarea').inputValue();
    await run('second');
    await job('second').getByText('finished').waitFor({ timeout: 60_000 });
    expect(record('second').extremes.greatest_displacement.value).toBeLessThan(
      record('first').extremes.greatest_displacement.value,
    );

    await job('second').getByRole('link', { name: 'Open' }).click();
    await page.frameLocator('iframe').getByRole('slider', { name: 'Frame' }).waitFor();
    await page.getByLabel('Compare with').selectOption('first');
    await page.getByRole('row', { name: 'a30_p20.ana line 28' }).waitFor({ timeout: 60_000 });
    expect(await page.getByRole('row', { name: 'a30_p20.ana line 28' }).textContent()).toContain('25');
    expect(await page.locator('.compare table').last().textContent()).toContain('Greatest displacement');
    await shot(page, 'round_compare');
    await page.context().close();

    page = await open();
    expect(await page.locator('textarea').inputValue()).toBe(saved);
    await run('again');
    await job('again').getByText('finished').waitFor({ timeout: 60_000 });
    for (const part of ['extremes', 'outcome', 'inputs', 'settings'])
      expect(record('again')[part]).toEqual(record('second')[part]);
  });

  test('both profiles run at one click and stand side by side', async () => {
    await run('both', 'Both profiles');
    await job('both').getByRole('link', { name: 'Compare' }).click({ timeout: 60_000 });
    await page.waitForFunction(
      () => !(document.querySelector('.compare .strong') as HTMLButtonElement | null)?.disabled,
      null,
      { timeout: 60_000 },
    );
    await page.getByText('The input files of both runs are equal.').waitFor({ timeout: 60_000 });
    await shot(page, 'round_both');
    await page.goBack();
    await page.waitForFunction(() => document.body.textContent?.includes('Unknowns'));
  });

  test('a run is paused, goes on, and stops at a criterion', async () => {
    await change('<Friction> 25 <', '<Friction> 45 <'); // the block stays, so that the run may be long
    await page.getByRole('button', { name: 'Add a setting' }).click();
    await page.getByLabel('Setting', { exact: true }).fill('steps');
    await page.getByLabel('Value of steps').fill('4000000');
    await run('long');
    await job('long').getByText('step ').waitFor({ timeout: 60_000 });
    await job('long').getByRole('button', { name: 'Pause' }).click();
    await job('long').getByText('paused').waitFor({ timeout: 60_000 });
    await job('long').getByRole('button', { name: 'Go on' }).click();
    await job('long').getByRole('button', { name: 'Pause' }).click({ timeout: 60_000 });
    await job('long').getByText('paused').waitFor({ timeout: 60_000 });
    await change('<Friction> 45 <', '<Friction> 25 <');
    await page.getByLabel('Value of steps').fill('1000');
    await page.getByText('Record and stop').click();
    await page.getByLabel('Histories').fill('block=block:2');
    await page.getByLabel('Stop when').fill('block.d>0.1');
    await run('limit');
    await job('limit').getByText('stopped after').waitFor({ timeout: 60_000 });
    const { outcome, extremes } = record('limit');
    expect(outcome.end).toBe('stopped');
    expect(outcome.steps).toBeLessThan(1000);
    expect(extremes.greatest_displacement.value).toBeGreaterThan(0.1);
    expect(extremes.greatest_displacement.value).toBeLessThan(0.11);
  });
});
