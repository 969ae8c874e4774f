// What tests and screenshots share: a static server on loopback, Chromium, and the module in node.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import init, { Case, Files, catalogue } from '../pkg/schlupf_wasm.js';

const web = fileURLToPath(new URL('..', import.meta.url));

/** The built page. */
export const DIST = join(web, 'dist/explore');
/** The gallery. */
export const CASES = join(web, '..', 'cases');

const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
};

/** Serves the page: its address and a function that ends it. */
export async function serve() {
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
    const file = join(DIST, normalize(path === '/' ? '/index.html' : path));
    try {
      const body = await readFile(file);
      response.writeHead(200, {
        'content-type': TYPES[extname(file)] ?? 'application/octet-stream',
      });
      response.end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const close = () =>
    new Promise((resolve) => {
      server.close(resolve);
      server.closeAllConnections();
    });
  return { address: `http://127.0.0.1:${server.address().port}/`, close };
}

/** Starts Debian's Chromium. */
export function browse() {
  return chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
}

/** A page with the case of a hash, solved; errors of its console are collected. */
export async function opened(context, address, hash = '') {
  const page = await context.newPage();
  const errors = [];
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  page.on('pageerror', (error) => errors.push(String(error)));
  await page.goto(address + hash);
  await solved(page);
  return { page, errors };
}

/** Waits for a solution after a moment of the page's clock. */
export async function solved(page, since = 0, timeout = 60_000) {
  await page.waitForFunction(
    (moment) => Number(document.documentElement.dataset.solved ?? 0) > moment,
    since,
    { timeout },
  );
}

/** The moment of the page's clock. */
export function now(page) {
  return page.evaluate(() => performance.now());
}

/** A scalar that is shown, in SI. */
export function shown(page, quantity) {
  return page.locator(`[data-quantity="${quantity}"]`).getAttribute('data-value').then(Number);
}

/** Moves the slider of a field to a position, as one step. */
export function slide(page, field, position) {
  return page.locator(`.panel [data-path="${field}"] input[type=range]`).evaluate((slider, at) => {
    slider.value = String(at);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  }, position);
}

/** The module in node. */
async function initialised() {
  await init({ module_or_path: await readFile(join(web, 'pkg', 'schlupf_wasm_bg.wasm')) });
}

/** What there is, by the module in node. */
export async function catalogueInNode() {
  await initialised();
  return JSON.parse(catalogue());
}

/** A case of the gallery, by the module in node. */
export async function inNode(name, assignments = []) {
  await initialised();
  const text = await readFile(join(CASES, `${name}.toml`), 'utf8');
  return new Case(text, `${name}.toml`, assignments, new Files());
}
