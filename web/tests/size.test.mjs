// How much a person loads.
import assert from 'node:assert/strict';
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { DIST } from './support.mjs';

/** Largest size, in bytes when compressed. Optimised for size the module has 100 kB less and takes
 * twice as long. */
const MOST = 1.5e6;

test('page and module are small', async () => {
  const names = await readdir(DIST, { recursive: true });
  const sizes = new Map();
  // Words of other languages are loaded where they are chosen.
  const isLoaded = (name) => /\.(html|js|css|svg|wasm)$/.test(name) && !/\/(de|zh)-/.test(name);
  for (const name of names.filter(isLoaded)) {
    sizes.set(name, gzipSync(await readFile(join(DIST, name)), { level: 9 }).length);
  }
  const module = [...sizes].filter(([name]) => name.endsWith('.wasm'));
  const wasm = module.reduce((sum, [, size]) => sum + size, 0);
  const page = [...sizes.values()].reduce((sum, size) => sum + size, 0) - wasm;
  console.log(`gzipped: page ${(page / 1e3).toFixed(1)} kB, module ${(wasm / 1e3).toFixed(1)} kB`);
  assert.equal(module.length, 1);
  assert.ok(page + wasm <= MOST, `page and module have ${page + wasm} bytes`);
});
