// Pages and window with names, results and folders that nobody would choose: set KEYBLOCK to the program.

import { type ChildProcess, execFileSync, spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { make_wall } from '../scenes';
import { violations } from './axe';
import { figure, has_browser, launch, open, open_window, start_server, write_page } from './browser';

const program = process.env.KEYBLOCK ?? '';

// biome-ignore lint/suspicious/noExplicitAny: what the page lays open for tests.
type Open = any;

const SCRIPT = '</script><script>window.hit = 1</script><!--';
const LONG = `${'Ä'.repeat(300)} "x"`;
const FILE = "evil <b>‮&'ü.json";

const CASE = {
  keyblock: 2,
  units: { length: 'm', mass: 'kg', time: 's' },
  drawing: {
    boundary_count: 4,
    joints: [
      [0, 0, 10, 0, 1],
      [10, 0, 10, 6, 1],
      [10, 6, 0, 6, 1],
      [0, 6, 0, 0, 1],
      [0, 3, 10, 3, SCRIPT],
      [5, 0, 5, 6, LONG],
    ],
    fixed_lines: [[0, 0, 10, 0]],
    measured_points: [[2.5, 5]],
  },
  analysis: {
    step_count: 20,
    time_step: 0.001,
    gravity: 9.81,
    joint_materials: [
      { name: `"quoted" & 'q' <b>`, friction_angle_deg: 30 },
      { name: SCRIPT, friction_angle_deg: 20 },
      { name: LONG, friction_angle_deg: 20 },
    ],
    block_materials: [
      {
        name: '岩石 ‮ עברית 🪨 <img src=x onerror="window.hit=2">',
        density: 2500,
        youngs_modulus: 5e9,
        poissons_ratio: 0.25,
      },
    ],
  },
  stages: [
    { name: SCRIPT, steps: 10 },
    {
      name: LONG,
      steps: 10,
      excavations: [
        {
          outline: [
            [0, 3],
            [5, 3],
            [5, 6],
            [0, 6],
          ],
        },
      ],
    },
  ],
};

describe.skipIf(!has_browser || !program)('hostile inputs', () => {
  let browser: Browser;
  const servers: ChildProcess[] = [];
  const folder = mkdtempSync(join(tmpdir(), 'keyblock-hostile-'));
  const run = (...words: string[]) =>
    execFileSync(program, words, { cwd: folder, stdio: ['ignore', 'pipe', 'ignore'] }).toString();
  const decoded = (page: Page) =>
    page.waitForFunction(() => (window as Open).keyblock_page.state.all_decoded.value, null, { timeout: 60_000 });

  beforeAll(async () => {
    browser = await launch();
    writeFileSync(join(folder, FILE), JSON.stringify(CASE, null, 1));
    run('run', FILE, '-o', 'out', '--page');
  });
  afterAll(async () => {
    await browser?.close();
    for (const own of servers) own.kill('SIGINT');
  });

  /** Opens every tab of a page; returns its text. */
  async function read_all(page: Page): Promise<string> {
    let text = '';
    for (const tab of ['Show', 'Chosen', 'Curves', 'Run', 'Blocks']) {
      await page.getByRole('tab', { name: tab }).click();
      await page.waitForTimeout(60);
      for (const more of await page.locator('[role=tabpanel] details:not([open]) > summary').all())
        if (await more.isVisible()) await more.click();
      // biome-ignore lint/performance/useDomNodeTextContent: the text that is shown, without that of scripts.
      text += await page.locator('#page').innerText();
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      expect(wide, tab).toBeLessThanOrEqual(0);
    }
    return text;
  }

  for (const width of [1280, 400])
    test(`names with tags, quotes, other scripts and 300 letters, ${width} px`, async () => {
      const { page, requests, errors } = await open(browser, join(folder, 'out/page.html'), {
        viewport: { width, height: 800 },
      });
      await decoded(page);
      await page.evaluate(() => {
        const { state } = (window as Open).keyblock_page;
        state.chosen.value = { kind: 'body', key: 3 };
        state.set_layer('contacts', true);
      });
      const text = await read_all(page);
      expect(text).toContain('</script><script>');
      expect(text).toContain('岩石');
      expect(text).toContain('🪨');
      expect(await page.title()).toBe("evil <b>&'ü, profile standard – Keyblock");
      expect(await violations(page)).toEqual([]);
      const svg = await page.evaluate(() => {
        const own = (window as Open).keyblock_page.svg_text();
        return new DOMParser().parseFromString(own, 'image/svg+xml').querySelector('parsererror')?.textContent ?? '';
      });
      expect(svg).toBe('');
      // The legend shortens names.
      await page.evaluate(() => {
        (window as Open).keyblock_page.state.contact_colour.value = 'joint';
      });
      await expect
        .poll(() => page.evaluate(() => (window as Open).keyblock_page.svg_text()))
        .toContain(`${'Ä'.repeat(43)}…<`);
      expect(await page.evaluate(() => (window as Open).hit ?? 0)).toBe(0);
      expect(requests).toEqual([]);
      expect(errors).toEqual([]);
      await page.context().close();
    });

  test('the report and the window show the same names as text', async () => {
    run('report', 'out', '-o', 'report.html');
    const { server, address } = start_server(program, folder);
    servers.push(server);
    const errors: string[] = [];
    const window_ = await open_window(browser, await address, errors);
    await window_.getByText(FILE).first().waitFor();
    for (const hash of [`#/case/${encodeURIComponent(FILE)}`, '#/result/out', '#/compare/out/out']) {
      await window_.evaluate(to => {
        location.hash = to;
      }, hash);
      await window_.waitForTimeout(700);
      expect(await window_.evaluate(() => (window as Open).hit ?? 0)).toBe(0);
      const wide = await window_.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      expect(wide, hash).toBeLessThanOrEqual(0);
    }
    await window_.evaluate(
      to => {
        location.hash = to;
      },
      `#/case/${encodeURIComponent(FILE)}`,
    );
    await window_.locator('.modes label', { hasText: 'Tables' }).click();
    await window_.waitForTimeout(300);
    expect(await window_.evaluate(() => document.documentElement.scrollWidth - window.innerWidth)).toBeLessThanOrEqual(
      0,
    );
    await window_.context().close();
    const context = await browser.newContext({ viewport: { width: 400, height: 800 } });
    const page = await context.newPage();
    await page.goto(`file://${join(folder, 'report.html')}`);
    // biome-ignore lint/performance/useDomNodeTextContent: the text that is shown, without that of scripts.
    expect(await page.locator('body').innerText()).toContain('</script><script>');
    expect(await page.evaluate(() => (window as Open).hit ?? 0)).toBe(0);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth)).toBeLessThanOrEqual(0);
    await context.close();
    expect(errors).toEqual([]);
  });

  test('results without frames and without a sound record are refused; one frame, or no record, is shown', async () => {
    const copy = (name: string) => {
      cpSync(join(folder, 'out'), join(folder, name), { recursive: true });
      return join(folder, name);
    };
    const view = (name: string) => spawnSync(program, ['view', name, '-o', `${name}.html`], { cwd: folder });
    rmSync(join(copy('none'), 'frames'), { recursive: true });
    writeFileSync(join(copy('damaged'), 'run.json'), '{"time": NaN}');
    for (const name of ['none', 'damaged']) {
      const done = view(name);
      expect(done.status).toBe(3);
      expect(done.stderr.toString()).toMatch(/error: expected/);
    }
    const single = join(copy('single'), 'frames');
    for (const own of readdirSync(single)) if (!own.includes('00000020')) rmSync(join(single, own));
    rmSync(join(copy('unknown'), 'run.json'));
    for (const name of ['single', 'unknown']) {
      expect(view(name).status, 'frames that are gone are a fault').toBe(name === 'single' ? 1 : 0);
      const { page, errors } = await open(browser, join(folder, `${name}.html`));
      await decoded(page);
      expect(await read_all(page)).not.toMatch(/NaN|undefined|\[object/);
      for (const key of ['Home', 'End', 'ArrowRight', ' ']) await page.keyboard.press(key);
      expect(await page.evaluate(() => (window as Open).keyblock_page.state.frame.value)).toBe(
        name === 'single' ? 0 : 20,
      );
      expect(errors).toEqual([]);
      await page.context().close();
    }
  });

  test('a run that failed says so, with its one frame', async () => {
    const free = {
      ...CASE,
      drawing: undefined,
      stages: undefined,
      blocks: {
        blocks: [
          {
            outer: [
              [0, 0, 1],
              [1, 0, 1],
              [1, 1, 1],
              [0, 1, 1],
            ],
          },
        ],
      },
    };
    writeFileSync(join(folder, 'free.json'), JSON.stringify(free));
    const done = spawnSync(program, ['run', 'free.json', '--set', 'motion=static', '-o', 'free', '--page'], {
      cwd: folder,
    });
    expect(done.status).toBe(4);
    const { page, errors } = await open(browser, join(folder, 'free/page.html'));
    await decoded(page);
    const text = await read_all(page);
    expect(text).toContain('no equilibrium');
    expect(text).not.toMatch(/NaN|undefined|\[object/);
    expect(errors).toEqual([]);
    await page.context().close();
  });

  test('values that are no numbers are shown as missing, and leave ranges and other blocks alone', async () => {
    const wall = make_wall({ columns: 4, rows: 3, frames: 5, contacts: true, missing: [2] });
    const { page, errors } = await open(browser, write_page('missing', wall.writer.scripts(wall.head)));
    await decoded(page);
    for (const id of await page.evaluate(() =>
      (window as Open).keyblock_page.measures().map((own: { id: string }) => own.id),
    )) {
      await page.evaluate(own => {
        (window as Open).keyblock_page.state.measure_id.value = own;
      }, id);
      await page.waitForTimeout(30);
      const range = await page.evaluate(own => (window as Open).keyblock_page.shown_range(own), id);
      if (range) expect([range.low, range.high].every(Number.isFinite), id).toBe(true);
    }
    await page.evaluate(() => {
      (window as Open).keyblock_page.state.chosen.value = { kind: 'body', key: 2 };
    });
    expect(await read_all(page)).not.toMatch(/NaN|undefined|Infinity/);
    expect(await page.evaluate(() => (window as Open).keyblock_page.svg_text())).not.toContain('NaN');
    expect(errors).toEqual([]);
    await page.context().close();
  });

  test('a folder with 500 results is listed and stays usable', async () => {
    const many = join(folder, 'many');
    mkdirSync(many);
    for (let i = 0; i < 500; i++)
      cpSync(join(folder, 'out'), join(many, `result ${i}`), {
        recursive: true,
        filter: path => !/frames\/.*(?<!0000|0020)\.vt/.test(path),
      });
    const { server, address } = start_server(program, many);
    servers.push(server);
    const errors: string[] = [];
    const from = Date.now();
    const page = await open_window(browser, await address, errors);
    await page.getByText('result 499').first().waitFor({ timeout: 20_000 });
    const listed = Date.now() - from;
    await page.waitForTimeout(1000);
    const asked = await page.evaluate(() => performance.getEntriesByType('resource').length);
    const slowest = await page.evaluate(async () => {
      const start = performance.now();
      await fetch('/api/list');
      return performance.now() - start;
    });
    figure(
      '500 results',
      `listed in ${(listed / 1000).toFixed(1)} s, ${asked} requests for the first screen; list again ${slowest.toFixed(0)} ms`,
    );
    expect(listed).toBeLessThan(10_000);
    expect(asked).toBeLessThan(120);
    await page.getByText('result 499').first().click();
    await page.locator('iframe').first().waitFor();
    expect(errors).toEqual([]);
    await page.context().close();
  });

  test('a drawing with coordinates of 1e60 and more is refused in words, and the window stays usable', async () => {
    const far = join(folder, 'far');
    mkdirSync(far);
    for (const power of [60, 150, 307]) {
      const corner = Number(`1e${power}`);
      const joints = [...CASE.drawing.joints, [corner, 0, corner, 1, 1]];
      writeFileSync(join(far, `far${power}.json`), JSON.stringify({ ...CASE, drawing: { ...CASE.drawing, joints } }));
    }
    const { server, address } = start_server(program, far);
    servers.push(server);
    const errors: string[] = [];
    const page = await open_window(browser, await address, errors);
    for (const power of [60, 150, 307]) {
      await page.evaluate(name => {
        location.hash = `#/case/${name}`;
      }, `far${power}.json`);
      await page.getByText('from -1e+50 to 1e+50').first().waitFor({ timeout: 20_000 });
      await page.locator('.modes label', { hasText: /^Text$/ }).click();
      await expect.poll(() => page.locator('textarea').inputValue()).toContain(`e+${power}`);
      await page.locator('.modes label', { hasText: /^Drawing$/ }).click();
    }
    // The browser notes that the server refused the case, 422.
    expect(errors.filter(words => !words.includes('422'))).toEqual([]);
    await page.context().close();
  });

  test('two browsers on one server: a file that one saved is not overwritten by the other, nor is one edited on disk', async () => {
    const shared = join(folder, 'shared');
    mkdirSync(shared);
    const path = join(shared, 'box.json');
    writeFileSync(path, JSON.stringify({ ...CASE, stages: undefined }, null, 1));
    const { server, address } = start_server(program, shared);
    servers.push(server);
    const errors: string[] = [];
    const start = await address;
    const first = await open_window(browser, start, errors);
    // The token of the address serves once per browser; the second one has its own cookie.
    const second = await open_window(browser, start, errors);
    for (const page of [first, second]) {
      await page.evaluate(() => {
        location.hash = '#/case/box.json';
      });
      await page.locator('.modes label', { hasText: /^Text$/ }).click();
      await expect.poll(() => page.locator('textarea').inputValue()).toContain('"step_count": 20');
    }
    // A window without changes of its own follows the disk, so both have theirs before the other is saved.
    const type = async (page: Page, steps: number) => {
      const box = page.locator('textarea');
      await box.fill((await box.inputValue()).replace(/"step_count": \d+/, `"step_count": ${steps}`));
    };
    const save = (page: Page) => page.locator('textarea').press('Control+s');
    const refused = (page: Page) => page.locator('.conflict', { hasText: 'has changed on the disk' }).waitFor();
    await type(second, 22);
    await type(first, 21);
    await save(first);
    await expect.poll(() => readFileSync(path, 'utf8')).toContain('"step_count": 21');
    await save(second);
    await refused(second);
    expect(readFileSync(path, 'utf8')).toContain('"step_count": 21');
    expect(await second.locator('textarea').inputValue()).toContain('"step_count": 22');
    await type(first, 23);
    writeFileSync(path, readFileSync(path, 'utf8').replace('"step_count": 21', '"step_count": 30'));
    await save(first);
    await refused(first);
    expect(readFileSync(path, 'utf8')).toContain('"step_count": 30');
    // The user chooses; a window without changes of its own follows the disk.
    await first.getByRole('button', { name: 'Read it anew' }).click();
    await expect.poll(() => first.locator('textarea').inputValue()).toContain('"step_count": 30');
    writeFileSync(path, readFileSync(path, 'utf8').replace('"step_count": 30', '"step_count": 31'));
    await expect.poll(() => first.locator('textarea').inputValue(), { timeout: 10_000 }).toContain('"step_count": 31');
    // The server refuses a save if the disk has changed once more, so the choice may come twice.
    await expect
      .poll(
        async () => {
          await second
            .getByRole('button', { name: 'Keep this text' })
            .click({ timeout: 500 })
            .catch(() => {});
          await save(second);
          await second.waitForTimeout(300);
          return readFileSync(path, 'utf8');
        },
        { timeout: 20_000 },
      )
      .toContain('"step_count": 22');
    for (const page of [first, second]) await page.context().close();
    expect(errors.filter(own => !own.includes('409'))).toEqual([]);
  });
});
