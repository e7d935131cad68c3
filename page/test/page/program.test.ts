// The built files with the program itself: set KEYBLOCK to its path. Values on the screen equal those of run.json.

import { type ChildProcess, execFileSync, spawn } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { has_browser, launch, open } from './browser';

const program = process.env.KEYBLOCK ?? '';

// biome-ignore lint/suspicious/noExplicitAny: run.json, and what the page lays open for tests.
type Open = any;

describe.skipIf(!has_browser || !program)('program', () => {
  let browser: Browser;
  let server: ChildProcess | null = null;
  const folder = mkdtempSync(join(tmpdir(), 'keyblock-program-'));
  const run = (...words: string[]) =>
    execFileSync(program, words, { cwd: folder, stdio: ['ignore', 'pipe', 'ignore'] });

  beforeAll(async () => {
    browser = await launch();
    run('new', 'slope');
    run('run', 'slope.json', '-o', 'slope', '--set', 'steps=60');
  });
  afterAll(async () => {
    await browser?.close();
    server?.kill('SIGINT');
  });

  test('values on the screen equal the record of the run', async () => {
    run('view', 'slope', '-o', 'slope.html');
    const record: Open = JSON.parse(readFileSync(join(folder, 'slope/run.json'), 'utf8'));
    const { page, requests, errors } = await open(browser, join(folder, 'slope.html'));
    await page.waitForFunction(() => (window as Open).keyblock_page.state.all_decoded.value);
    await page.getByRole('tab', { name: 'Run' }).click();
    const { least_principal_stress: least } = record.extremes;
    await page
      .locator('tr', { hasText: 'Least principal stress' })
      .getByRole('button', { name: `block ${least.element}` })
      .click();
    const text = await page
      .locator('#panel-chosen tr', { hasText: 'least principal' })
      .first()
      .locator('td')
      .textContent();
    const kilopascals = Number(text!.replace('−', '-').replace(/[^\d.-]/g, ''));
    expect(Math.abs((1000 * kilopascals) / least.value - 1)).toBeLessThan(5e-3);

    const rows = readFileSync(join(folder, 'slope/history.csv'), 'utf8').trim().split('\n');
    const last = rows.at(-1)!.split(',').map(Number);
    const dy = last[rows[0].split(',').findIndex(name => name.startsWith('dy1'))];
    const shown = await page.evaluate(() => {
      const { state } = (window as Open).keyblock_page;
      const f = state.last_frame();
      const rows_now = state.store.part_now('points', f);
      return rows_now?.columns.displacement[1];
    });
    expect(Math.abs(shown / dy - 1)).toBeLessThan(1e-3);
    expect(requests).toEqual([]);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  test('a case is opened, changed, run, watched and compared in the window', async () => {
    const cases = join(folder, 'cases');
    mkdirSync(cases);
    copyFileSync(join(folder, 'slope.json'), join(cases, 'slope.json'));
    server = spawn(program, ['serve', cases]);
    const address = await new Promise<string>((resolve, reject) => {
      let said = '';
      const read = (data: Buffer) => {
        said += data;
        const found = /http:\/\/\S+/.exec(said);
        if (found) resolve(found[0]);
      };
      server!.stdout!.on('data', read);
      server!.stderr!.on('data', read);
      server!.on('exit', () => reject(new Error(said)));
    });
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
    const page = await context.newPage();
    page.on('dialog', asked => asked.accept());
    const errors: string[] = [];
    page.on('pageerror', error => errors.push(String(error)));
    await page.goto(address);
    await page.getByRole('navigation').getByRole('link', { name: 'slope.json' }).click();
    const text = page.locator('textarea');
    await expect.poll(() => text.inputValue()).toContain('"keyblock"');
    const before = await text.inputValue();
    await text.fill(before.replace('"keyblock"', '"keyblocks"'));
    await page.getByRole('button', { name: 'Save', exact: true }).click();
    await page.locator('.warnings li.error').first().waitFor();
    await text.fill(before.replace('"friction_angle_deg": "35 deg"', '"friction_angle_deg": "33 deg"'));
    await page.getByRole('button', { name: 'Save', exact: true }).click();
    await page.waitForFunction(() => document.body.textContent!.includes('Unknowns'));
    expect(readFileSync(join(cases, 'slope.json'), 'utf8')).toContain('33 deg');
    for (const steps of ['30', '40']) {
      if (steps === '30') await page.getByRole('button', { name: 'Add a setting' }).click();
      await page.getByLabel('Setting', { exact: true }).fill('steps');
      await page.getByLabel('Value of steps').fill(steps);
      await page.getByRole('button', { name: 'Run', exact: true }).click();
      await expect
        .poll(() => page.locator('.job', { hasText: 'finished' }).count(), { timeout: 60_000 })
        .toBe(steps === '30' ? 1 : 2);
    }
    await page.getByRole('link', { name: 'Open' }).first().click();
    await page.frameLocator('iframe').getByRole('slider', { name: 'Frame' }).waitFor();
    await page.getByLabel('Compare with').selectOption('slope_run');
    await page.waitForFunction(
      () => !(document.querySelector('.compare .strong') as HTMLButtonElement | null)?.disabled,
      null,
      { timeout: 60_000 },
    );
    expect(await page.locator('.compare table').last().textContent()).toContain('setting steps');
    expect(errors).toEqual([]);
    await context.close();
  });
});
