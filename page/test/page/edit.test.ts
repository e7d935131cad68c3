// The editor of the window in headless Chromium, before a server that answers from memory.

import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { find, type Path, parse, plain } from '../../src/serve/edit/case_text';
import { violations } from './axe';
import { figure, has_browser, launch, open_window } from './browser';
import { type Folder, serve_folder } from './folder';

const CASE = `{
 // A box.
 "keyblock": 2,  // layout
 "units": {"length": "m", "mass": "kg", "time": "s"},
 "drawing": {
  "boundary_count": 4,
  "joints": [
   [0, 0, 10, 0, "bedding"],  // base
   [10, 0, 10, 6, "bedding"],
   [10, 6, 0, 6, "bedding"],
   [0, 6, 0, 0, "bedding"],
  ],
  "measured_points": [[5, 5]],
 },
 "analysis": {
  "step_count": 100,
  "block_materials": [{"name": "rock", "poissons_ratio": 0.25}],
  "joint_materials": [{"name": "bedding"}, {"name": "cross joint"}],
 },
}
`;

const YAML = `# A box.
keyblock: 2
units: {length: m, mass: kg, time: s}
blocks:
  blocks:
    - outer: [[0, 0, 1], [5, 0, 1], [5, 6, 1], [0, 6, 1]]  # left
    - outer: [[5, 0, 1], [10, 0, 1], [10, 6, 1], [5, 6, 1]]
covers:
  contact: ignored
`;

describe.skipIf(!has_browser)('editor', () => {
  let browser: Browser;
  let folder: Folder;
  const errors: string[] = [];

  async function open(hash: string, scheme: 'light' | 'dark' = 'light', width = 1280): Promise<Page> {
    const page = await open_window(browser, folder.address + hash, errors, {
      viewport: { width, height: 800 },
      colorScheme: scheme,
    });
    await page.waitForSelector('canvas');
    await expect.poll(() => page.locator('canvas').getAttribute('data-view')).not.toBe('');
    return page;
  }

  /** Place on the screen of a point of the drawing. */
  async function at(page: Page, x: number, y: number): Promise<[number, number]> {
    const canvas = page.locator('canvas');
    const [left, top, scale] = (await canvas.getAttribute('data-view'))!.split(' ').map(Number);
    const box = (await canvas.boundingBox())!;
    return [box.x + (x - left) * scale, box.y + (top - y) * scale];
  }
  const click = async (page: Page, x: number, y: number) => page.mouse.click(...(await at(page, x, y)));
  const drag = async (page: Page, from: [number, number], to: [number, number]) => {
    await page.mouse.move(...(await at(page, ...from)));
    await page.mouse.down();
    const [x, y] = await at(page, ...to);
    await page.mouse.move(x - 9, y - 9);
    await page.mouse.move(x, y);
    await page.mouse.up();
  };
  const text = (page: Page) => page.locator('textarea').inputValue();
  const read = async (page: Page, ...path: Path) => plain(find(parse(await text(page)), path));
  const tool = (page: Page, name: string) =>
    page.getByRole('toolbar').getByRole('button', { name, exact: true }).click();

  beforeAll(async () => {
    browser = await launch();
    folder = await serve_folder(
      { 'box.json': CASE, 'box.yaml': YAML, 'empty.json': '{"keyblock": 2}\n', 'a.dxf': '0\nEOF\n' },
      '',
    );
  });
  afterAll(async () => {
    await browser?.close();
    folder?.server.close();
    expect(errors).toEqual([]);
  });

  test('joints are drawn by clicks that snap; comments stay; each step is undone and redone', async () => {
    const page = await open('#/case/box.json');
    await tool(page, 'Joint');
    await page.getByLabel('Joint material').selectOption('cross joint');
    await click(page, 0.1, 6.1);
    await click(page, 9.9, 0.1);
    expect(await read(page, 'drawing', 'joints', 4)).toEqual([0, 6, 10, 0, 'cross joint']);
    // The second joint begins where the first crosses the grid, and ends at a place that is typed.
    await click(page, 5, 3);
    await page.getByLabel('Place: x, y').fill('@2<90');
    await page.getByLabel('Place: x, y').press('Enter');
    expect(await read(page, 'drawing', 'joints', 5)).toEqual([5, 3, 5, 5, 'cross joint']);
    const after = await text(page);
    expect(after).toContain(' // A box.\n "keyblock": 2,  // layout\n');
    expect(after).toContain('[0, 0, 10, 0, "bedding"],  // base\n');
    await page.locator('canvas').focus();
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    expect(await text(page)).toBe(CASE);
    await page.keyboard.press('Control+y');
    await page.keyboard.press('Control+y');
    expect(await text(page)).toBe(after);
    await page.keyboard.press('Control+s');
    await expect.poll(() => folder.files.get('box.json')).toBe(after);
    await expect.poll(() => page.locator('.edit-state').textContent()).toContain('1 block');
    folder.files.set('box.json', CASE);
    await page.context().close();
  });

  test('a corner is dragged, an item moved by keys and numbers, and deleted', async () => {
    const page = await open('#/case/box.json');
    await click(page, 5, 6);
    await drag(page, [10, 6], [8, 4]);
    expect(await read(page, 'drawing', 'joints', 1)).toEqual([10, 0, 8, 4, 'bedding']);
    expect(await read(page, 'drawing', 'joints', 2)).toEqual([8, 4, 0, 6, 'bedding']);
    await page.getByLabel('Item').selectOption('Measured point 1');
    await page.getByLabel('x', { exact: true }).fill('2.5');
    await page.getByLabel('x', { exact: true }).press('Enter');
    await expect.poll(() => read(page, 'drawing', 'measured_points')).toEqual([[2.5, 5]]);
    await page.locator('canvas').focus();
    await page.keyboard.press('ArrowDown');
    await expect.poll(() => read(page, 'drawing', 'measured_points', 0, 1)).toBeLessThan(5);
    await page.keyboard.press('Delete');
    await expect.poll(() => read(page, 'drawing', 'measured_points')).toEqual([]);
    expect(await text(page)).toContain('// A box.');
    await page.context().close();
  });

  test('an end or corner of what is not chosen moves alone; a press without a move changes nothing', async () => {
    const page = await open('#/case/box.json');
    await tool(page, 'Bolt');
    await click(page, 2, 2);
    await click(page, 4, 5);
    await tool(page, 'Select');
    await page.keyboard.press('Escape');
    const before = await text(page);
    const [x, y] = await at(page, 4, 5);
    await page.mouse.move(x + 2, y);
    await page.mouse.down();
    await page.mouse.move(x, y + 2);
    await page.mouse.up();
    expect(await text(page)).toBe(before);
    await page.keyboard.press('Escape');
    expect(await page.getByLabel('Item').inputValue()).toBe('');
    await drag(page, [4, 5], [7, 3]);
    expect(((await read(page, 'drawing', 'bolts', 0)) as number[]).slice(0, 4)).toEqual([2, 2, 7, 3]);
    await page.keyboard.press('Escape');
    await drag(page, [10, 6], [8, 4]);
    expect(await read(page, 'drawing', 'joints', 1)).toEqual([10, 0, 8, 4, 'bedding']);
    expect(await read(page, 'drawing', 'joints', 2)).toEqual([8, 4, 0, 6, 'bedding']);
    await page.context().close();
  });

  test('an excavation makes its stage; loads and bolts have their numbers', async () => {
    const page = await open('#/case/box.json');
    await tool(page, 'Excavation');
    for (const [x, y] of [
      [2, 1],
      [4, 1],
      [4, 2],
      [2, 1],
    ])
      await click(page, x, y);
    expect(await read(page, 'stages', 1, 'excavations', 0, 'outline')).toEqual([
      [2, 1],
      [4, 1],
      [4, 2],
    ]);
    await tool(page, 'Load');
    await page.getByLabel('Force').fill('20 kN/m');
    await click(page, 6, 3);
    await click(page, 6, 1);
    expect(await read(page, 'analysis', 'point_loads')).toEqual([[[0, 0, '-20 kN/m']]]);
    await tool(page, 'Bolt');
    await page.getByLabel('From').selectOption('excavation 1');
    await click(page, 3, 2);
    await click(page, 3, 5);
    expect(await read(page, 'stages', 1, 'bolts')).toEqual([[3, 2, 3, 5, '20 MN/m/m', 0, '50 kN/m', 1]]);
    await page.context().close();
  });

  test('places of the drawing stay put in the frame in which a tool changes the height of the canvas', async () => {
    const page = await open('#/case/box.json');
    // Script of the page sees the new layout before the canvas measures itself.
    const seen = await page.evaluate(async () => {
      const canvas = document.querySelector('canvas')!;
      const look = () => {
        const box = canvas.getBoundingClientRect();
        const [left, top, scale] = canvas.dataset.view!.split(' ').map(Number);
        return { height: box.height, x: box.x - left * scale, y: box.y + top * scale };
      };
      const before = look();
      [...document.querySelectorAll<HTMLButtonElement>('.edit-tool')]
        .find(own => own.textContent?.trim() === 'Excavation')!
        .click();
      for (let i = 0; i < 20; i++) await Promise.resolve();
      const at_once = look();
      await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 50))));
      return { before, at_once, after: look() };
    });
    expect(seen.at_once.height).toBeLessThan(seen.before.height - 15);
    for (const own of [seen.at_once, seen.after]) {
      expect(Math.abs(own.x - seen.before.x)).toBeLessThan(0.6);
      expect(Math.abs(own.y - seen.before.y)).toBeLessThan(0.6);
    }
    await page.context().close();
  });

  test('an outline is drawn by keys alone; base and sides are fixed in one click', async () => {
    const page = await open('#/case/empty.json');
    await page.locator('canvas').focus();
    await page.keyboard.press('o');
    const place = page.getByLabel('Place: x, y');
    for (const typed of ['0, 0', '20, 0', '@0, 5', '@-20, 0']) {
      await place.fill(typed);
      await place.press('Enter');
    }
    await place.press('Enter');
    expect(await read(page, 'drawing', 'boundary_count')).toBe(4);
    expect(await read(page, 'drawing', 'joints', 3)).toEqual([0, 5, 0, 0, 1]);
    await tool(page, 'Fixed');
    await page.getByRole('button', { name: 'Fix base and sides' }).click();
    expect(((await read(page, 'drawing', 'fixed_lines')) as unknown[]).length).toBe(3);
    await page.context().close();
  });

  test('a case in YAML: a corner of two blocks is dragged, a support is drawn, and colours follow', async () => {
    const page = await open('#/case/box.yaml');
    expect(await page.locator('.colours .c-comment').allTextContents()).toEqual(['# A box.', '# left']);
    await page.getByLabel('Item').selectOption('Block 1');
    await drag(page, [5, 6], [6, 4]);
    expect(await read(page, 'blocks', 'blocks', 0, 'outer', 2)).toEqual([6, 4, 1]);
    expect(await read(page, 'blocks', 'blocks', 1, 'outer', 3)).toEqual([6, 4, 1]);
    await tool(page, 'Support');
    await page.getByLabel(/Held|Prescribed/).waitFor();
    await click(page, 0, 0);
    await click(page, 10, 0);
    expect(await text(page)).toMatch(
      / {2}contact: ignored\n {2}displacements: \[\{"along": \[\[0, 0\], \[10, 0\]\], "held": "both"\}\]\n$/,
    );
    expect(await text(page)).toContain('# left\n');
    await page.context().close();
  });

  test('a fault in the text stops the drawing and is named; a correction frees it', async () => {
    const page = await open('#/case/box.json');
    await page.locator('textarea').fill(CASE.replace('"keyblock": 2,', '"keyblock": 2'));
    await expect.poll(() => page.locator('.edit-state').textContent()).toContain('Line 4, column 2: a comma or }');
    expect(await page.getByRole('toolbar').getByRole('button', { name: 'Joint' }).isDisabled()).toBe(true);
    await page.locator('textarea').fill(CASE.replace('"keyblock": 2', '"keyblock": 1'));
    await expect.poll(() => page.getByRole('toolbar').getByRole('button', { name: 'Joint' }).isDisabled()).toBe(false);
    await page.context().close();
  });

  test('tables change the text and refuse values beyond their limits', async () => {
    const page = await open('#/case/box.json');
    await page.locator('.modes label', { hasText: 'Tables' }).click();
    const ratio = page.getByLabel("Poisson's ratio of block material 1");
    await ratio.fill('0.7');
    await ratio.press('Enter');
    await page.waitForSelector('text=Expected: 0 to 0.5.');
    expect(await ratio.inputValue()).toBe('0.7');
    await ratio.fill('0.3');
    await ratio.press('Enter');
    await page.getByLabel('Step count', { exact: true }).fill('250');
    // The check of the first change draws the window anew; what is typed stays.
    await page.waitForTimeout(1200);
    await page.getByLabel('Step count', { exact: true }).press('Enter');
    await page.getByRole('button', { name: 'Add a block material' }).click();
    await page.locator('.modes label', { hasText: /^Text$/ }).click();
    expect(await read(page, 'analysis', 'block_materials', 0, 'poissons_ratio')).toBe(0.3);
    expect(await read(page, 'analysis', 'block_materials', 1, 'name')).toBe('rock 2');
    expect(await read(page, 'analysis', 'step_count')).toBe(250);
    expect(await text(page)).toContain('// base');
    await page.context().close();
  });

  test('keys and words are completed', async () => {
    const page = await open('#/case/box.json');
    const box = page.locator('textarea');
    await box.fill('{"keyblock": 2, "analysis": {}}');
    await box.evaluate((own: HTMLTextAreaElement) => own.setSelectionRange(29, 29));
    await box.pressSequentially('"ro');
    await page.getByRole('option', { name: 'rotation' }).waitFor();
    expect(await page.locator('.choices p').textContent()).toContain('Formula for rotation');
    await box.press('Enter');
    await expect.poll(() => text(page)).toBe('{"keyblock": 2, "analysis": {"rotation": "first_order"}}');
    await box.evaluate((own: HTMLTextAreaElement) => own.setSelectionRange(45, 45));
    await box.press('Control+Space');
    await box.press('ArrowDown');
    await box.press('Tab');
    await expect.poll(() => text(page)).toBe('{"keyblock": 2, "analysis": {"rotation": "exact"}}');
    await page.context().close();
  });

  test('keys, sections and words of YAML are completed', async () => {
    const page = await open('#/case/box.yaml');
    const box = page.locator('textarea');
    await box.fill('keyblock: 2\n');
    await box.evaluate((own: HTMLTextAreaElement) => own.setSelectionRange(12, 12));
    await box.pressSequentially('ana');
    await page.getByRole('option', { name: 'analysis' }).waitFor();
    await box.press('Enter');
    await expect.poll(() => text(page)).toBe('keyblock: 2\nanalysis:\n  ');
    await box.pressSequentially('ro');
    await page.getByRole('option', { name: 'rotation' }).waitFor();
    expect(await page.locator('.choices p').textContent()).toContain('Formula for rotation');
    await box.press('Tab');
    await expect.poll(() => text(page)).toBe('keyblock: 2\nanalysis:\n  rotation: first_order');
    await box.pressSequentially('\n  ');
    await box.press('Control+Space');
    await expect
      .poll(() => page.locator('.choices [role=option]').allTextContents())
      .toEqual(['step_count', 'joint_materials', 'block_materials']);
    await page.context().close();
  });

  test('a new scene is saved as a case', async () => {
    const page = await open('#/new');
    await page.getByText('Drawn by hand').click();
    for (const typed of ['0, 0', '9, 0', '9, 9', '']) {
      await page.getByLabel('Place: x, y').fill(typed);
      await page.getByLabel('Place: x, y').press('Enter');
    }
    await expect
      .poll(() => folder.asked.filter(own => own.path === '/api/joints').at(-1)?.body.spec)
      .toMatchObject({
        outline: [
          [0, 0],
          [9, 0],
          [9, 9],
        ],
      });
    await page.locator('.modes label', { hasText: 'Slope' }).click();
    await page.getByLabel('Height [m]').fill('12');
    await expect.poll(() => page.locator('.edit-state').textContent()).toContain('1 block');
    await page.getByLabel('Dip [°]').first().fill('x');
    await expect
      .poll(() => page.locator('.edit-state').textContent())
      .toContain('The dip of bedding must be a number.');
    await page.getByLabel('Dip [°]').first().fill('30');
    const spacing = page.getByLabel('Spacing [m]').first();
    expect(await page.locator('label', { has: spacing }).first().getAttribute('title')).toBe(
      'Mean distance between rows of joints. Permitted: greater than 0.',
    );
    await spacing.fill('-1');
    await expect
      .poll(() => page.locator('.edit-state').textContent())
      .toContain('The spacing of bedding: expected greater than 0.');
    await spacing.fill('3');
    await page.getByLabel('File').fill('own.json');
    await expect.poll(() => page.locator('.edit-state').textContent()).toContain('1 block');
    const create = page.getByRole('button', { name: 'Create the case' });
    await expect.poll(() => create.isDisabled()).toBe(false);
    const friction = page.getByLabel('Friction angle [°]').first();
    await friction.fill('95');
    // The program refuses the angle.
    await expect.poll(() => page.locator('.edit-state').textContent()).toContain('of the case');
    expect(await page.locator('.edit-state .bad').count()).toBe(1);
    expect(await create.isDisabled()).toBe(true);
    await friction.fill('40');
    await expect.poll(() => create.isDisabled()).toBe(false);
    await page.getByRole('button', { name: 'Create the case' }).click();
    await expect.poll(() => page.url()).toContain('#/case/own.json');
    const saved = folder.files.get('own.json')!;
    expect(plain(find(parse(saved), ['drawing', 'boundary_count']))).toBe(4);
    const spec = folder.asked.filter(own => own.path === '/api/joints').at(-1)!.body.spec;
    expect(spec).toMatchObject({
      slope: { height: 12, angle: 60 },
      sets: [{ dip: 30, spacing: 3 }, { dip: 118 }],
      seed: 1,
    });
    await page.context().close();
  });

  test('joint sets follow their form; other changes made meanwhile stay; cancel restores the joints', async () => {
    const page = await open('#/case/box.json');
    await tool(page, 'Joint');
    await click(page, 2, 0);
    await click(page, 2, 6);
    const before = await text(page);
    await page.getByRole('button', { name: 'Joint sets…' }).click();
    await expect.poll(() => read(page, 'drawing', 'joints', 4)).toEqual([1, 0, 1, 10, 'bedding']);
    expect(await text(page)).toContain('// joint sets: {"seed":"1"');
    await page.getByLabel('Replace the joints').uncheck();
    await expect.poll(() => read(page, 'drawing', 'joints', 4)).toEqual([2, 0, 2, 6, 'bedding']);
    expect(await read(page, 'drawing', 'joints', 5)).toEqual([1, 0, 1, 10, 'bedding']);
    await page.getByRole('button', { name: 'Cancel' }).click();
    await expect.poll(() => text(page)).toBe(before);
    await page.getByRole('button', { name: 'Joint sets…' }).click();
    await expect.poll(() => read(page, 'drawing', 'joints', 4)).toEqual([1, 0, 1, 10, 'bedding']);
    await tool(page, 'Point');
    await click(page, 4, 4);
    await page.getByLabel('Spacing [m]').first().fill('2');
    await page.waitForTimeout(600);
    await page.getByRole('button', { name: 'Cancel' }).click();
    await expect.poll(() => read(page, 'drawing', 'joints', 4)).toEqual([2, 0, 2, 6, 'bedding']);
    expect(await read(page, 'drawing', 'measured_points', 1)).toEqual([4, 4]);
    expect(await text(page)).not.toContain('joint sets:');
    await page.context().close();
  });

  for (const scheme of ['light', 'dark'] as const)
    for (const width of [1280, 400])
      test(`no axe violations, ${scheme}, ${width} px`, async () => {
        const found: string[] = [];
        for (const show of ['Drawing', 'Text', 'Tables', 'sets', 'save', 'new']) {
          const page = await open(show === 'new' ? '#/new' : '#/case/box.json', scheme, width);
          if (['Drawing', 'Text', 'Tables'].includes(show))
            await page.locator('.modes label', { hasText: new RegExp(`^${show}$`) }).click();
          if (show === 'sets') {
            await tool(page, 'Joint');
            await page.getByRole('button', { name: 'Joint sets…' }).click();
          }
          if (show === 'save') await page.getByRole('button', { name: 'Save as…' }).click();
          if (show === 'Drawing')
            await page
              .getByLabel('Item')
              .selectOption('Joint 1', { timeout: 500 })
              .catch(() => {});
          await page.waitForTimeout(500);
          found.push(...(await violations(page)).map(own => `${show}: ${own}`));
          const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
          expect(wide, show).toBeLessThanOrEqual(0);
          await page.context().close();
        }
        figure(`axe violations of the editor, ${scheme}, ${width} px`, found.length);
        expect(found).toEqual([]);
      });
});
