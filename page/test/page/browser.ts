// Opens built pages in headless Chromium.

import { type ChildProcess, spawn } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type Browser, type BrowserContextOptions, chromium, type Page } from 'playwright-core';

export const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';
export const has_browser = existsSync(CHROMIUM);

export const folder = mkdtempSync(join(tmpdir(), 'keyblock-page-'));
export const shots = process.env.SHOTS ?? '';
if (shots) mkdirSync(shots, { recursive: true });

export function built(): string {
  return readFileSync(new URL('../../built/run.html', import.meta.url), 'utf8');
}

/** Puts scripts into the built page; returns the path of the file. */
export function write_page(name: string, scripts: string): string {
  const path = join(folder, `${name}.html`);
  writeFileSync(
    path,
    built().replace('<!--keyblock-data-->', () => scripts),
  );
  return path;
}

/** Takes the data out of a page that the program wrote. */
export function data_of(path: string): string {
  const text = readFileSync(path, 'utf8');
  const from = text.indexOf('<script type="application/json" id="keyblock-head">');
  const last = text.lastIndexOf('<script type="text/plain"');
  return text.slice(from, text.indexOf('</script>', last) + 9);
}

/** Prints a figure of the acceptance table. */
export function figure(name: string, value: string | number): void {
  process.stdout.write(`figure: ${name}: ${value}\n`);
}

export function launch(): Promise<Browser> {
  return chromium.launch({ executablePath: CHROMIUM, args: ['--no-sandbox', '--hide-scrollbars'] });
}

export interface Opened {
  page: Page;
  requests: string[];
  errors: string[];
}

/** Collects the errors of a page. */
function listen(page: Page, errors: string[]): void {
  page.on('pageerror', error => errors.push(String(error)));
  page.on('console', text => {
    if (text.type() === 'error') errors.push(text.text());
  });
}

/** Opens a view of the window of a server; errors go to the list, and questions are answered by yes. */
export async function open_window(
  browser: Browser,
  address: string,
  errors: string[],
  options: BrowserContextOptions = {},
): Promise<Page> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  page.on('dialog', asked => asked.accept());
  listen(page, errors);
  await page.goto(address);
  await page.waitForSelector('nav', { state: 'attached' });
  return page;
}

/** Starts `keyblock serve` in a folder; the address is known when it answers. */
export function start_server(program: string, served: string): { server: ChildProcess; address: Promise<string> } {
  const server = spawn(program, ['serve', served]);
  const address = new Promise<string>((resolve, reject) => {
    let said = '';
    const read = (data: Buffer) => {
      said += data;
      const found = /http:\/\/\S+/.exec(said);
      if (found) resolve(found[0]);
    };
    server.stdout?.on('data', read);
    server.stderr?.on('data', read);
    server.on('exit', code => reject(new Error(`the server ended with ${code}: ${said}`)));
  });
  return { server, address };
}

/** Opens a file; counts requests besides the file itself, and errors. */
export async function open(
  browser: Browser,
  path: string,
  options: BrowserContextOptions = {},
  query = '',
): Promise<Opened> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  const requests: string[] = [];
  const errors: string[] = [];
  page.on('request', request => {
    if (!request.url().startsWith('file:') && !request.url().startsWith('data:') && !request.url().startsWith('blob:'))
      requests.push(request.url());
  });
  listen(page, errors);
  await page.goto(`file://${path}${query}`);
  await page.waitForFunction(() => 'keyblock_page' in window || document.querySelector('.refused'), null, {
    timeout: 60_000,
  });
  return { page, requests, errors };
}

export async function shot(page: Page, name: string): Promise<void> {
  if (shots) await page.screenshot({ path: join(shots, `${name}.png`) });
}
