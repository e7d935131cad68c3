// The built page in headless Chromium, from file://: what it shows, what it costs, whether all can use it.

import { readFileSync, statSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { make_wall } from '../scenes';
import { violations } from './axe';
import { built, figure, has_browser, launch, open, write_page } from './browser';

// biome-ignore lint/suspicious/noExplicitAny: what the page lays open for tests.
type Open = any;

async function decoded(page: Page): Promise<void> {
  await page.waitForFunction(() => (window as Open).keyblock_page.state.all_decoded.value, null, { timeout: 60_000 });
}

describe.skipIf(!has_browser)('page', () => {
  let browser: Browser;
  const wall = make_wall({ columns: 12, rows: 9, frames: 60, contacts: true, epochs: 2 });
  let path = '';
  beforeAll(async () => {
    browser = await launch();
    path = write_page('wall', wall.writer.scripts(wall.head));
  });
  afterAll(() => browser?.close());

  test('code is at most 60 kB when packed', () => {
    const size = gzipSync(built(), { level: 9 }).length;
    figure('code of the page, gzip', `${(size / 1000).toFixed(1)} kB`);
    expect(size).toBeLessThan(60_000);
  });

  test('opens at the last frame, plays, steps, jumps', async () => {
    const { page, requests, errors } = await open(browser, path);
    await decoded(page);
    expect(await page.title()).toBe('Wall of blocks – Keyblock');
    const slider = page.getByRole('slider', { name: 'Frame' });
    expect(await slider.inputValue()).toBe('59');
    await page.keyboard.press('Home');
    expect(await slider.inputValue()).toBe('0');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Shift+ArrowRight');
    expect(await slider.inputValue()).toBe('11');
    await page.keyboard.press(']');
    expect(await slider.inputValue()).toBe('30');
    expect(await slider.getAttribute('aria-valuetext')).toContain('stage excavated');
    await page.keyboard.press('[');
    expect(await slider.inputValue()).toBe('0');
    await page.getByRole('button', { name: 'Play' }).click();
    await page.waitForFunction(() => (window as Open).keyblock_page.state.frame.value > 3);
    await page.getByRole('button', { name: 'Pause' }).click();
    const stopped = await slider.inputValue();
    expect(Number(stopped)).toBeGreaterThan(3);
    await page.waitForTimeout(200);
    expect(await slider.inputValue()).toBe(stopped);
    expect(requests).toEqual([]);
    expect(errors).toEqual([]);
    figure('requests', requests.length);
    await page.context().close();
  });

  test('a click chooses a block and shows its values', async () => {
    const { page } = await open(browser, path);
    await decoded(page);
    const row = 40;
    const place = await page.evaluate(at => {
      const { state, figure: now } = (window as Open).keyblock_page;
      const { camera, size, pose } = now();
      const box = document.querySelector('.over')!.getBoundingClientRect();
      void state;
      return {
        x: box.left + size.width / 2 + (pose.centres[2 * at] - camera.x) * camera.scale,
        y: box.top + size.height / 2 - (pose.centres[2 * at + 1] - camera.y) * camera.scale,
      };
    }, row);
    await page.mouse.click(place.x, place.y);
    const panel = page.locator('#panel-chosen');
    await expect.poll(() => panel.locator('h2').first().textContent()).toBe(`Block ${wall.bodies[row].number}`);
    expect(await panel.locator('[aria-live=polite]').first().textContent()).toContain('granite <b>');
    const motion = wall.motion[59][row];
    const shown = await panel.locator('tr', { hasText: 'magnitude' }).first().locator('td').textContent();
    const millimetres = Number(shown!.replace(/[^\d.]/g, ''));
    expect(Math.abs(millimetres / (1000 * Math.hypot(motion[0], motion[1])) - 1)).toBeLessThan(1e-3);
    expect(await panel.locator('.list tbody tr').count()).toBeGreaterThan(3);
    await page.keyboard.press('Escape');
    await expect.poll(() => panel.textContent()).toContain('Nothing is chosen');
    const ms = await page.evaluate(() => {
      const { figure: now, pick } = (window as Open).keyblock_page;
      const { pose } = now();
      const start = performance.now();
      for (let i = 0; i < 20; i++) pick(pose, pose.centres[4] + i * 1e-4, pose.centres[5]);
      return (performance.now() - start) / 20;
    });
    figure('pick', `${ms.toFixed(3)} ms`);
    expect(ms).toBeLessThan(5);
    await page.context().close();
  });

  test('a verdict stands in the head with its reason', async () => {
    const verdict = { tone: 'bad' as const, words: 'failed', reason: 'step 1: no equilibrium: block <2> accelerates' };
    const failed = write_page(
      'failed',
      wall.writer.scripts({ ...wall.head, verdict, run: { counts: { blocks: 5 }, outcome: { steps: 0 } } }),
    );
    const { page } = await open(browser, failed);
    const head = page.locator('header');
    expect(await head.getByRole('button', { name: 'Failed' }).count()).toBe(1);
    expect(await head.locator('.reason').textContent()).toBe('Step 1: no equilibrium: block <2> accelerates.');
    await page.getByRole('tab', { name: 'Run' }).click();
    // A run without steps counts no overlap.
    await page.getByRole('row', { name: 'Blocks at the start 5' }).waitFor();
    expect(await page.getByText('Deepest overlap').count()).toBe(0);
    await page.context().close();
  });

  test('the history of a chosen block grows with the frames of a run that goes on', async () => {
    const { page } = await open(browser, path);
    await decoded(page);
    const values = () => page.evaluate(() => (window as Open).keyblock_page.chart_times.values);
    await page.evaluate(() => {
      const { state } = (window as Open).keyblock_page;
      state.chosen.value = { kind: 'body', key: 3 };
      state.tab.value = 'chosen';
    });
    const count = wall.head.frames.length;
    await expect.poll(values).toBe(count);
    await page.evaluate(() => {
      const { live, state } = (window as Open).keyblock_page;
      const last = state.head.frames.at(-1);
      const frames = [{ ...last, step: last.step + 3, time: last.time + 0.01, epoch: -1 }];
      return live.append({ frames, epochs: [], fields: [], parts: {}, chunks: [], bytes: {} });
    });
    await expect.poll(values).toBe(count + 1);
    await page.context().close();
  });

  test('data that cannot be decoded and saves that fail are told', async () => {
    const { writer, head } = make_wall({ columns: 4, rows: 3, frames: 60, contacts: true });
    const [first] = head.chunks.filter(chunk => chunk.what === 'motion');
    const script = new RegExp(`(<script[^>]*id="${first.id}"[^>]*>)[^<]*`);
    const { page } = await open(browser, write_page('cut', writer.scripts(head).replace(script, '$1AAAA')));
    await page.waitForSelector('.failure');
    expect(await page.locator('.refused').count()).toBe(0);
    await page.evaluate(() => {
      HTMLCanvasElement.prototype.toBlob = done => done(null);
    });
    await page.getByText('Save', { exact: true }).click();
    await page.getByRole('button', { name: 'Picture, PNG' }).click();
    await expect.poll(() => page.locator('.failure').textContent()).toContain('made no picture');
    await page.context().close();
  });

  test('chart cursors follow the slider', async () => {
    const { page } = await open(browser, path);
    await decoded(page);
    await page.getByRole('tab', { name: 'Curves' }).click();
    await page.waitForSelector('.chart');
    const times = () => page.evaluate(() => (window as Open).keyblock_page.chart_times);
    await page.evaluate(() => (window as Open).keyblock_page.state.go_to(30));
    await expect.poll(async () => (await times()).cursor).toBeCloseTo(0.3, 9);
    const { drawn } = await times();
    figure('chart with its cursor drawn', `${drawn.toFixed(2)} ms`);
    expect(drawn).toBeLessThan(30);
    const box = (await page.locator('.chart').boundingBox())!;
    await page.mouse.click(box.x + 60, box.y + 80);
    expect(await page.evaluate(() => (window as Open).keyblock_page.state.frame.value)).toBeLessThan(5);
    await page.context().close();
  });

  test('exports hold what is shown', async () => {
    const { page } = await open(browser, path, { acceptDownloads: true });
    await decoded(page);
    const save = async (label: string) => {
      await page.locator('.menu summary').click();
      const [download] = await Promise.all([
        page.waitForEvent('download'),
        page.getByRole('button', { name: label }).click(),
      ]);
      return { name: download.suggestedFilename(), path: await download.path() };
    };
    const svg = await save('Drawing, SVG');
    expect(svg.name).toBe('Wall_of_blocks_step177.svg');
    const text = readFileSync(svg.path, 'utf8');
    expect(text).toContain('Displacement, magnitude [m]');
    expect(text).not.toContain('NaN');
    const csv = readFileSync((await save('Blocks, CSV')).path, 'utf8')
      .trim()
      .split('\n');
    expect(csv.length).toBe(wall.bodies.length);
    expect(csv[0]).toContain('displacement.x [m]');
    const png = await save('Picture, PNG');
    expect(statSync(png.path).size).toBeGreaterThan(5000);
    const contacts = readFileSync((await save('Contacts, CSV')).path, 'utf8');
    expect(contacts).toContain('normal_force [N]');
    const video = await page.evaluate(async () => {
      const { record_video, video_kind } = (window as Open).keyblock_page;
      if (!video_kind()) return null;
      const blob = await record_video(60);
      return { size: blob.size, type: blob.type };
    });
    figure('video', video ? `${video.type}, ${(video.size / 1000).toFixed(0)} kB for 60 frames` : 'not recorded here');
    if (video) expect(video.size).toBeGreaterThan(5000);
    await page.context().close();
  });

  test('contacts by joint, arrows, trails and the undeformed outline follow the data', async () => {
    const { page, errors } = await open(browser, path);
    await decoded(page);
    const svg = () => page.evaluate(() => (window as Open).keyblock_page.svg_text());
    await page.getByLabel('Contact forces').check();
    const colours = await page.evaluate(() => (window as Open).keyblock_page.state.paint.value.classes.slice(0, 2));
    const lines_of = (text: string, colour: string) => text.split(`stroke="${colour}"`).length - 1;
    await page.getByLabel('Contacts by').selectOption('joint');
    const by_joint = await svg();
    for (const words of ['rough', 'smooth &lt;i&gt;']) expect(by_joint).toContain(words);
    for (const colour of colours) expect(lines_of(by_joint, colour)).toBeGreaterThan(0);
    await page.getByLabel('Contact forces').uncheck();

    // The trail of a block runs from its place in the first frame to that of the last one of its epoch.
    const row = 40;
    await page.evaluate(key => {
      const { state } = (window as Open).keyblock_page;
      state.chosen.value = { kind: 'body', key };
    }, wall.bodies[row].key);
    await page.getByRole('tab', { name: 'Show' }).click();
    await page.getByLabel('Trails').selectOption('chosen');
    const figure_of = () =>
      page.evaluate(at => {
        const { trails, arrows, pose, rest } = (window as Open).keyblock_page.figure();
        return {
          trails: trails.map((own: Float32Array) => [...own]),
          arrows: arrows && arrows.at.length / 2,
          centre: [...pose.centres.slice(2 * at, 2 * at + 2)],
          has_rest: rest !== null,
        };
      }, row);
    await expect.poll(async () => (await figure_of()).trails.length).toBe(1);
    const { trails, centre } = await figure_of();
    const trail = trails[0];
    const [first, last] = [wall.motion[0][row], wall.motion[59][row]];
    for (const axis of [0, 1]) {
      const moved = trail[trail.length - 2 + axis] - trail[axis];
      expect(Math.abs(moved - (last[axis] - first[axis]))).toBeLessThan(1e-4);
      expect(Math.abs(trail[trail.length - 2 + axis] - centre[axis])).toBeLessThan(1e-5);
    }
    await page.getByLabel('Trails').selectOption('all');
    await expect.poll(async () => (await figure_of()).trails.length).toBe(wall.bodies.length - 2);
    await page.getByLabel('Arrows').selectOption('velocity');
    await expect.poll(async () => (await figure_of()).arrows).toBeGreaterThan(50);
    await page.getByLabel('Undeformed outline').check();
    await expect.poll(async () => (await figure_of()).has_rest).toBe(true);
    expect(await svg()).toContain('stroke-dasharray');
    expect(errors).toEqual([]);
    await page.context().close();
  });

  test('where a browser records no MP4, the video is WebM', async () => {
    const { page, errors } = await open(browser, path);
    await decoded(page);
    const video = await page.evaluate(async () => {
      const is_supported = MediaRecorder.isTypeSupported.bind(MediaRecorder);
      MediaRecorder.isTypeSupported = kind => !kind.includes('mp4') && is_supported(kind);
      const { record_video, video_kind } = (window as Open).keyblock_page;
      const blob = video_kind() && (await record_video(60));
      return blob ? { type: blob.type, start: [...new Uint8Array(await blob.slice(0, 4).arrayBuffer())] } : null;
    });
    figure('video without MP4', video?.type ?? 'not recorded here');
    if (video) {
      expect(video.type).toContain('video/webm');
      expect(video.start).toEqual([0x1a, 0x45, 0xdf, 0xa3]);
    }
    expect(errors).toEqual([]);
    await page.context().close();
  });

  for (const scheme of ['light', 'dark'] as const) {
    for (const [width, height] of [
      [1280, 800],
      [400, 800],
    ]) {
      test(`no axe violations, ${scheme}, ${width} px; nothing wider than the screen`, async () => {
        const { page } = await open(browser, path, { viewport: { width, height }, colorScheme: scheme });
        await decoded(page);
        const found: string[] = [];
        for (const tab of ['Show', 'Chosen', 'Curves', 'Run', 'Blocks']) {
          await page.getByRole('tab', { name: tab }).click();
          if (tab === 'Chosen') {
            await page.evaluate(() => {
              const { state } = (window as Open).keyblock_page;
              state.chosen.value = { kind: 'body', key: 30 };
            });
            await page.waitForSelector('#panel-chosen .facts');
          }
          await page.waitForTimeout(50);
          found.push(...(await violations(page)));
          const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
          expect(wide).toBeLessThanOrEqual(0);
        }
        await page.keyboard.press('?');
        await page.waitForSelector('dialog[open]');
        found.push(...(await violations(page)));
        figure(`axe violations, ${scheme}, ${width} px`, found.length);
        expect(found).toEqual([]);
        await page.context().close();
      });
    }
  }

  test('an unknown version, no data and broken data are refused with a sentence', async () => {
    const version = { ...wall.head, version: 9 };
    for (const [scripts, sentence] of [
      [wall.writer.scripts(version), 'version 9'],
      ['', 'holds no results'],
      [wall.writer.scripts(wall.head).replace(/eJ[\w+/]{30}/g, 'eJAAAA'), 'damaged'],
    ]) {
      const { page } = await open(browser, write_page('refused', scripts));
      await page.waitForSelector('.refused');
      expect(await page.locator('.refused').textContent()).toContain(sentence);
      await page.context().close();
    }
  });

  test('prints the drawing and the record of the run', async () => {
    const { page } = await open(browser, path, { colorScheme: 'dark' });
    await decoded(page);
    const pdf = await page.pdf({ format: 'A4' });
    expect(pdf.length).toBeGreaterThan(10_000);
    await page.emulateMedia({ media: 'print' });
    expect(await page.locator('.caption').isVisible()).toBe(true);
    expect(await page.locator('#panel-run').isVisible()).toBe(true);
    expect(await page.locator('.player').isVisible()).toBe(false);
    await page.context().close();
  });

  // Figures are those of the acceptance table; bounds are wide enough for a machine that has other work.
  describe('speed', () => {
    const rate = async (page: Page, seconds = 4): Promise<number> =>
      page.evaluate(async length => {
        const { state, timing } = (window as Open).keyblock_page;
        state.frame.value = 0;
        const before = timing.frames;
        const start = performance.now();
        let f = 0;
        await new Promise<void>(resolve => {
          const next = (now: number) => {
            if (now - start > 1000 * length) return resolve();
            f = (f + 1) % (state.last_frame() + 1);
            state.frame.value = f;
            requestAnimationFrame(next);
          };
          requestAnimationFrame(next);
        });
        return ((timing.frames - before) / (performance.now() - start)) * 1000;
      }, seconds);

    for (const draw of ['canvas', 'webgl']) {
      test(`2,000 blocks play, ${draw}`, async () => {
        const big = make_wall({ columns: 50, rows: 40, frames: 50, contacts: true });
        const file = write_page('big', big.writer.scripts(big.head));
        const { page } = await open(browser, file, {}, `?draw=${draw}`);
        await decoded(page);
        const times = await page.evaluate(() => {
          const { timing, all_decoded_at } = (window as Open).keyblock_page;
          return { first: timing.first_picture, all: all_decoded_at(), renderer: timing.renderer };
        });
        const fps = await rate(page);
        const ms = await page.evaluate(() => (window as Open).keyblock_page.timing.last_draw);
        await page.evaluate(() => (window as Open).keyblock_page.state.set_layer('contacts', true));
        const with_contacts = await rate(page);
        figure(
          `2,000 blocks, ${times.renderer}`,
          `${fps.toFixed(0)} fps (${ms.toFixed(1)} ms of script to draw), with 8,000 contacts ${with_contacts.toFixed(0)} fps; first picture ` +
            `${(times.first / 1000).toFixed(2)} s, all decoded ${(times.all / 1000).toFixed(2)} s`,
        );
        expect(ms).toBeLessThan(500);
        expect(Math.min(fps, with_contacts)).toBeGreaterThan(0.5);
        expect(times.all).toBeLessThan(30_000);
        await page.context().close();
      });
    }

    test('the faster of WebGL2 and canvas is chosen by measurement, and named', async () => {
      const big = make_wall({ columns: 50, rows: 40, frames: 50 });
      const { page } = await open(browser, write_page('big', big.writer.scripts(big.head)), {}, '?draw=measure');
      await decoded(page);
      await page.evaluate(() => (window as Open).keyblock_page.state.go_to(3));
      await expect
        .poll(() => page.evaluate(() => (window as Open).keyblock_page.timing.cost?.webgl))
        .toBeGreaterThan(0);
      const { cost, renderer } = await page.evaluate(() => (window as Open).keyblock_page.timing);
      expect(renderer).toBe(cost.webgl <= 1.3 * cost.canvas ? 'WebGL2' : 'canvas');
      await page.keyboard.press('?');
      expect(await page.locator('.renderer').textContent()).toContain(
        `${renderer === 'WebGL2' ? 'WebGL2' : 'a canvas'} (WebGL2 takes ${cost.webgl.toFixed(0)} ms`,
      );
      await page.keyboard.press('Escape');
      // The same picture as that of a page which draws on a canvas from the start.
      if (renderer === 'canvas') expect(await page.locator('canvas.under').isHidden()).toBe(true);
      figure(
        'chosen by measurement',
        `${renderer}: WebGL2 ${cost.webgl.toFixed(1)} ms, canvas ${cost.canvas.toFixed(1)} ms for a picture; ${(await rate(page)).toFixed(0)} fps`,
      );
      await page.context().close();
    });

    test('2,000 blocks in 500 frames', async () => {
      const long = make_wall({ columns: 50, rows: 40, frames: 500 });
      const scripts = long.writer.scripts(long.head);
      const { page } = await open(browser, write_page('long', scripts));
      await decoded(page);
      const times = await page.evaluate(() => {
        const { timing, all_decoded_at } = (window as Open).keyblock_page;
        return { first: timing.first_picture, all: all_decoded_at() };
      });
      figure(
        '2,000 blocks × 500 frames',
        `${(scripts.length / 1e6).toFixed(1)} MB; first picture ${(times.first / 1000).toFixed(2)} s, ` +
          `all decoded ${(times.all / 1000).toFixed(2)} s; ${(await rate(page)).toFixed(0)} fps`,
      );
      expect(scripts.length).toBeLessThan(20e6);
      expect(times.first).toBeLessThan(30_000);
      await page.context().close();
    });

    test('20,000 polygons', async () => {
      const big = make_wall({ columns: 200, rows: 100, frames: 3 });
      const { page } = await open(browser, write_page('large', big.writer.scripts(big.head)));
      await decoded(page);
      const fps = await rate(page);
      figure('20,000 polygons', `${fps.toFixed(1)} fps`);
      expect(fps).toBeGreaterThan(0.1);
      await page.context().close();
    });
  });
});
