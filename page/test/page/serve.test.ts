// The window of `keyblock serve` in headless Chromium, before a server that answers from memory.

import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { make_wall } from '../scenes';
import { violations } from './axe';
import { figure, has_browser, launch, open_window } from './browser';
import { type Folder, serve_folder } from './folder';

describe.skipIf(!has_browser)('window', () => {
  let browser: Browser;
  let folder: Folder;
  const wall = make_wall({ columns: 8, rows: 5, frames: 20, contacts: true });
  const errors: string[] = [];

  async function open(hash = '', scheme: 'light' | 'dark' = 'light', width = 1280): Promise<Page> {
    const page = await open_window(browser, folder.address + hash, errors, {
      viewport: { width, height: 800 },
      colorScheme: scheme,
    });
    await page.waitForSelector('nav a', { state: 'attached' });
    return page;
  }

  beforeAll(async () => {
    browser = await launch();
    folder = await serve_folder(
      {
        'slope.json': '{\n "keyblock": 2\n}\n',
        'bad.json': '{\n "keyblock": 2,\n "wrong": 1\n}\n',
        'old/tips.blk': '2 0\n',
        'old/tips.ana': '<DDA/>\n',
        'old/curve.csv': 'a,b\n',
        'strength/fos.json': JSON.stringify({
          reduced: 'joints',
          factor_of_safety: 3.2872,
          bracket: { stands: 3.2842, falls: 3.29018 },
          trials: [{ factor: 1, verdict: 'stands', largest_displacement: 0.000773 }],
          units: { length: 'm' },
        }),
        'halted/fos.json': JSON.stringify({ end: 'stopped', factor_of_safety: null, bracket: { stands: 1, falls: 2 } }),
        '<img src=x onerror=alert(1)>.json': '{}\n',
      },
      wall.writer.scripts(wall.head),
    );
  });
  afterAll(async () => {
    await browser?.close();
    folder?.server.close();
    expect(errors).toEqual([]);
  });

  test('lists cases and results; a pair of old files is one case; names are text', async () => {
    const page = await open();
    const names = await page.locator('nav li a').allInnerTexts();
    expect(names.map(name => name.split('\n')[0])).toEqual([
      '<img src=x onerror=alert(1)>.json',
      'bad.json',
      'tips',
      'slope.json',
      'first',
      'second',
      'strength',
      'broken',
      'halted',
    ]);
    const broken = page.getByRole('navigation').getByRole('link', { name: 'broken' });
    expect(await broken.textContent()).toContain('record damaged');
    await broken.click();
    expect(await page.getByRole('alert').textContent()).toContain('The record of broken is damaged');
    expect(await page.locator('iframe').count()).toBe(0);
    expect(await page.locator('nav img').count()).toBe(0);
    await page.context().close();
  });

  test('a text that goes back to the saved one is checked again', async () => {
    const page = await open('#/case/slope.json');
    const run = page.getByRole('button', { name: 'Run', exact: true });
    await expect.poll(() => run.isEnabled()).toBe(true);
    await page.locator('textarea').fill('{\n "keyblock": 2, "wrong": 1\n}\n');
    await page.getByRole('button', { name: 'line 2' }).waitFor();
    expect(await run.isEnabled()).toBe(false);
    await page.locator('textarea').fill('{\n "keyblock": 2\n}\n');
    await page.getByText('No problem found.').waitFor({ timeout: 5000 });
    expect(await run.isEnabled()).toBe(true);
    await page.context().close();
  });

  test('who refuses to leave unsaved changes stays there, and is asked again', async () => {
    const page = await open();
    const asked: string[] = [];
    page.removeAllListeners('dialog');
    page.on('dialog', own => {
      asked.push(own.message());
      void own.dismiss();
    });
    for (const name of ['bad', 'slope']) {
      await page.getByRole('navigation').getByRole('link', { name }).click();
      await expect.poll(() => page.locator('textarea').inputValue()).toContain('keyblock');
    }
    const text = '{\n "keyblock": 2, "typed": 1\n}\n';
    await page.locator('textarea').fill(text);
    await page.getByText('not saved').waitFor();
    for (const count of [1, 2]) {
      await page.locator('header .title').click();
      await expect.poll(() => asked.length).toBe(count);
      await page.waitForTimeout(300);
      expect(asked.length).toBe(count);
      await expect.poll(() => new URL(page.url()).hash).toBe('#/case/slope.json');
      expect(await page.locator('textarea').inputValue()).toBe(text);
    }
    // Refusals leave no entry in the history: Back asks at once, and leads to the case before if it may.
    await page.evaluate(() => history.back());
    await expect.poll(() => asked.length).toBe(3);
    await expect.poll(() => new URL(page.url()).hash).toBe('#/case/slope.json');
    expect(await page.locator('textarea').inputValue()).toBe(text);
    page.removeAllListeners('dialog');
    page.on('dialog', own => own.accept());
    await page.evaluate(() => history.back());
    await expect.poll(() => new URL(page.url()).hash).toBe('#/case/bad.json');
    await expect.poll(() => page.locator('textarea').inputValue()).toContain('wrong');
    await page.context().close();
  });

  test('a problem leads to its line; a correction is saved and run', async () => {
    const page = await open('#/case/bad.json');
    await page.getByRole('button', { name: 'line 3' }).click();
    await page.waitForFunction(() => document.activeElement?.tagName === 'TEXTAREA');
    const selected = await page.evaluate(() => {
      const box = document.activeElement as HTMLTextAreaElement;
      return box.value.slice(box.selectionStart, box.selectionEnd);
    });
    expect(selected).toBe('"wrong": 1');
    expect(await page.getByRole('button', { name: 'Run', exact: true }).isDisabled()).toBe(true);
    expect(await page.locator('.warnings').textContent()).toContain('<b>of the case</b>');
    await page.locator('textarea').fill('{\n "keyblock": 2\n}\n');
    await page.locator('textarea').press('Control+s');
    await page.waitForFunction(() => document.body.textContent.includes('No problem found'));
    const saved = folder.asked.filter(own => own.path === '/api/save').at(-1)!.body;
    expect(String(saved.sha256)).toMatch(/^[0-9a-f]{64}$/);
    expect(folder.files.get('bad.json')).toBe('{\n "keyblock": 2\n}\n');
    await page.getByRole('button', { name: 'Add a setting' }).click();
    await page.getByLabel('Setting', { exact: true }).fill('steps');
    await page.getByLabel('Value of steps').fill('50');
    await page.getByRole('button', { name: 'Estimate the time' }).click();
    await page.waitForSelector('text=about 3.2 s');
    await page.getByRole('button', { name: 'Run', exact: true }).click();
    await page.getByRole('link', { name: 'Open' }).waitFor();
    const run = folder.asked.filter(own => own.path === '/api/run').at(-1)!.body;
    expect(run).toEqual({ paths: ['bad.json'], result: 'bad_run', set: { steps: '50' } });
    await page.getByRole('link', { name: 'Open' }).click();
    await page.frameLocator('iframe').locator('h1').waitFor();
    await page.context().close();
  });

  test('one file of a pair is saved under another name, and the other one in its place', async () => {
    const page = await open('#/case/old%2Ftips.blk/old%2Ftips.ana');
    await page.locator('textarea').fill('3 0\n');
    await page.getByLabel('File', { exact: true }).selectOption('old/tips.ana');
    expect(await page.getByRole('heading', { name: 'tips.ana' }).count()).toBe(1);
    await page.locator('textarea').fill('<DDA>\n');
    await page.getByRole('button', { name: 'Save as…' }).click();
    await page.getByRole('dialog').getByRole('button', { name: 'Save', exact: true }).click();
    await expect.poll(() => folder.files.get('old/tips_new.ana')).toBe('<DDA>\n');
    expect(folder.files.get('old/tips.blk')).toBe('3 0\n');
    expect(folder.files.get('old/tips.ana')).toBe('<DDA/>\n');
    await page.context().close();
  });

  test('a case converted from old files names the changed rules', async () => {
    const page = await open('#/case/old%2Ftips.blk/old%2Ftips.ana');
    await page.getByRole('button', { name: 'Convert to a case' }).click();
    await page.getByRole('heading', { name: 'tips.json' }).waitFor();
    expect(await page.getByRole('status').textContent()).toContain('[profile_changes]');
    await page.getByRole('link', { name: 'slope.json' }).first().click();
    await page.getByRole('heading', { name: 'slope.json' }).waitFor();
    expect(await page.getByText('profile_changes').count()).toBe(0);
    await page.context().close();
  });

  test('two results side by side follow one slider', async () => {
    const page = await open('#/compare/first/second');
    await page.waitForFunction(
      () => !(document.querySelector('.compare .strong') as HTMLButtonElement | null)?.disabled,
      null,
      { timeout: 30_000 },
    );
    await page.getByRole('slider').fill('0.1');
    for (const frame of page.frames().slice(1)) {
      await expect.poll(() => frame.evaluate('keyblock_page.state.frame.value'), { timeout: 5000 }).toBe(10);
      expect(await frame.locator('.player').isVisible()).toBe(false);
    }
    await expect
      .poll(() => page.locator('.compare table').first().textContent())
      .toContain('Joint materials 1: Friction angle35\u00a0°33\u00a0°');
    const results = await page.locator('.compare table').last().textContent();
    expect(results).toContain('Steps300100');
    expect(results).toContain('Setting: Steps300100');
    expect(results).toContain('Greatest displacement2\u00a0mm1\u00a0mm50 %');
    await page.context().close();
  });

  test('a run stops at a criterion, and both profiles run at one click', async () => {
    const page = await open('#/case/slope.json');
    await page.getByText('Record and stop').click();
    await page.getByLabel('Histories').fill('crest=point:18,13 block:7');
    await page.getByLabel('Stop when').fill('crest.d>0.05');
    const asked = () => folder.asked.filter(own => own.path === '/api/run').at(-1)?.body;
    await page.getByRole('button', { name: 'Run', exact: true }).click();
    await expect.poll(() => asked()?.stop_when).toBe('crest.d>0.05');
    expect(asked()?.histories).toEqual(['crest=point:18,13', 'block:7']);
    await page.getByRole('button', { name: 'Both profiles' }).click();
    await expect.poll(() => asked()?.both).toBe(true);
    expect(asked()).not.toHaveProperty('stop_when');
    expect(asked()?.result).toBe('slope_both');
    await page.context().close();
  });

  test('a parameter is swept, and its table is shown', async () => {
    const page = await open('#/case/slope.json');
    await page.getByRole('link', { name: 'Sweep a parameter' }).click();
    await page.getByLabel('Parameter', { exact: true }).fill('/analysis/joint_materials/0/friction_angle_deg');
    await page.getByLabel('Values of /analysis').fill('10:15:5');
    await page.getByRole('button', { name: 'Start the sweep' }).click();
    await page.getByRole('link', { name: 'Open' }).click();
    await page.getByRole('cell', { name: '1.7035' }).waitFor();
    expect(await page.getByRole('cell', { name: 'x, y' }).count()).toBe(1);
    expect(await page.getByRole('columnheader').allTextContents()).toEqual([
      'angle',
      'verdict',
      'largest displacement [m]',
    ]);
    const asked = folder.asked.filter(own => own.path === '/api/sweep').at(-1)?.body;
    expect(asked).toEqual({
      paths: ['slope.json'],
      result: 'slope_sweep',
      over: ['/analysis/joint_materials/0/friction_angle_deg=10:15:5'],
      out: ['displacement'],
    });
    await page.context().close();
  });

  test('a material is tested, and a curve is fitted', async () => {
    let page = await open('#/study/element/slope.json');
    await page.getByRole('textbox', { name: 'Pressure' }).fill('5 MPa');
    await page.getByRole('button', { name: 'Test the material' }).click();
    await page.getByText('Pressure: expected a number, found 5 MPa').waitFor();
    await page.getByRole('textbox', { name: 'Pressure' }).fill('5e6');
    await page.getByRole('button', { name: 'Test the material' }).click();
    await page.getByRole('row', { name: 'Least stress −5.25\u00a0MPa' }).waitFor();
    const element = folder.asked.filter(own => own.path === '/api/element').at(-1)?.body;
    expect(element).toEqual({ path: 'slope.json', kind: 'triaxial', to: [-0.02], confining: 5e6 });
    await page.context().close();
    page = await open();
    await page.getByRole('link', { name: 'Fit old/curve.csv' }).click();
    await page.getByRole('button', { name: 'Fit', exact: true }).click();
    await page.getByRole('row', { name: 'Cohesion 13.625 1 12 15 MPa' }).waitFor();
    expect(folder.asked.at(-1)?.body).toEqual({ path: 'old/curve.csv', kind: 'curve' });
    await page.context().close();
  });

  test('a factor of safety has a view of its own', async () => {
    const page = await open('#/result/strength');
    await page.waitForSelector('.factor');
    expect(await page.locator('.strength').textContent()).toContain(
      'stable at 3.284, unstable at 3.290, with the strength of joints divided by these factors.',
    );
    expect(await page.getByRole('columnheader', { name: 'Largest displacement [m]' }).count()).toBe(1);
    expect(await page.locator('iframe').count()).toBe(0);
    await page.evaluate(() => {
      location.hash = '#/result/halted';
    });
    await page.getByText('The search was stopped before it found a factor of safety.').waitFor();
    await page.context().close();
  });

  test('an answer of the server that refuses is shown', async () => {
    const page = await open('#/case/none.json');
    await page.waitForSelector('.trouble');
    expect(await page.locator('.trouble').textContent()).toContain('there is no file none.json');
    errors.length = 0;
    await page.context().close();
  });

  for (const scheme of ['light', 'dark'] as const) {
    for (const width of [1280, 400]) {
      test(`no axe violations, ${scheme}, ${width} px`, async () => {
        const found: string[] = [];
        for (const hash of [
          '',
          '#/case/slope.json',
          '#/result/first',
          '#/result/strength',
          '#/compare/first/second',
          '#/study/sweep/slope.json',
          '#/study/element/slope.json',
          '#/study/fit/old/curve.csv'.replace('old/', 'old%2F'),
        ]) {
          const page = await open(hash, scheme, width);
          await page.waitForTimeout(700);
          found.push(...(await violations(page)));
          const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
          expect(wide).toBeLessThanOrEqual(0);
          await page.context().close();
        }
        figure(`axe violations of the window, ${scheme}, ${width} px`, found.length);
        expect(found).toEqual([]);
      });
    }
  }
});
