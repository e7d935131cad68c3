// Screenshots of the window before a server that answers from memory, in both themes, wide and narrow.

import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, test } from 'vitest';
import { has_browser, launch, shot } from '../page/browser';
import { type Folder, serve_folder } from '../page/folder';
import { make_wall } from '../scenes';

const VIEWS: Record<string, string> = {
  home: '',
  case: '#/case/slope.json',
  tables: '#/case/slope.json',
  yaml: '#/case/box.yaml',
  new: '#/new',
  result: '#/result/first',
  strength: '#/result/strength',
  compare: '#/compare/first/second',
  sweep: '#/study/sweep/slope.json',
  element: '#/study/element/slope.json',
  fit: '#/study/fit/tests.csv',
};

describe.skipIf(!has_browser)('window', () => {
  let browser: Browser;
  let folder: Folder;
  beforeAll(async () => {
    browser = await launch();
    const wall = make_wall({ columns: 8, rows: 5, frames: 20, contacts: true });
    folder = await serve_folder(
      {
        'slope.json':
          '{\n "keyblock": 2,\n "analysis": {"gravity": 9.81, "joint_materials": [{"friction_angle_deg": 35}]}\n}\n',
        'box.yaml':
          '# Two blocks.\nkeyblock: 2\nblocks:\n  blocks:\n    - outer: [[0, 0, 1], [5, 0, 1], [5, 6, 1]]\n' +
          '    - outer: [[5, 0, 1], [10, 0, 1], [10, 6, 1], [5, 6, 1]]\ncovers: {contact: ignored}\n',
        'old/tips.blk': '2 0\n',
        'old/tips.ana': '<DDA/>\n',
        'tests.csv': 'strain,stress\n0,0\n',
        'strength/fos.json': JSON.stringify({
          reduced: 'joints',
          factor_of_safety: 3.2872,
          bracket: { stands: 3.2842, falls: 3.29018 },
          trials: [{ factor: 1, verdict: 'stands', largest_displacement: 0.000773 }],
        }),
      },
      wall.writer.scripts(wall.head),
    );
  });
  afterAll(async () => {
    await browser?.close();
    folder?.server.close();
  });

  for (const scheme of ['light', 'dark'] as const) {
    for (const width of [1280, 400]) {
      test(`${scheme}, ${width} px`, async () => {
        const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme: scheme });
        const page = await context.newPage();
        for (const [name, hash] of Object.entries(VIEWS)) {
          await page.goto('about:blank');
          await page.goto(folder.address + hash);
          await page.waitForSelector('nav a', { state: 'attached' });
          if (name === 'tables') await page.locator('.modes label', { hasText: 'Tables' }).click();
          await page.waitForTimeout(900);
          await shot(page, `window_${name}_${scheme}_${width}`);
        }
        await context.close();
      });
    }
  }
});
