// The command and the module of the page give the same; the command serves the page.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import init, { Case, Files } from '../pkg/schlupf_wasm.js';
import { CASES as CASE_FOLDER } from './support.mjs';

const command = process.env.SCHLUPF_COMMAND;
const skip = command ? false : 'SCHLUPF_COMMAND names no command';
const module = new URL('../pkg/schlupf_wasm_bg.wasm', import.meta.url);

const WHEEL = readFileSync(join(CASE_FOLDER, 'wheel_on_rail.toml'), 'utf8');

/** Cases: a text and assignments of fields. */
const CASES = [
  ['', ['kinematics.creepage_x=0.002']],
  ['grid = { cells_x = 24, cells_y = 24 }', ['kinematics.spin="0.6 1/m"', 'normal.load="60 kN"']],
  ['solver.method = "polach"', ['kinematics.creepage_y=0.01', 'friction.model="constant"']],
  [WHEEL, []],
  [WHEEL, ['wheelset.lateral_position="-7 mm"', 'normal.load="60 kN"']],
];

/** Forces, of a wheel with those at its contacts and where these are; each a vector. */
function forces({ force, wheel_force: whole, contacts = [] }) {
  const each = contacts.flatMap((one) => [one.force, { z: one.normal.load }, one.position]);
  return [force, ...(whole ? [whole] : []), ...each];
}

test('the module gives the forces of the command', { skip }, async () => {
  await init({ module_or_path: readFileSync(module) });
  for (const [text, assignments] of CASES) {
    const set = assignments.flatMap((assignment) => ['--set', assignment]);
    const printed = execFileSync(command, ['solve', '-', '--json', '-', '--quiet', ...set], {
      input: text,
      stdio: ['pipe', 'pipe', 'ignore'],
    });
    const expected = forces(JSON.parse(printed));
    const solved = new Case(text, 'case', assignments, new Files()).ask('solve', '{}');
    const found = forces(JSON.parse(solved.json()));
    assert.equal(found.length, expected.length);
    assert.ok(text !== WHEEL || expected.length >= 5);
    expected.forEach((vector, index) => {
      const axes = ['x', 'y', 'z'].filter((axis) => axis in vector);
      const size = Math.hypot(...axes.map((axis) => vector[axis]));
      for (const axis of axes) {
        const difference = Math.abs(found[index][axis] - vector[axis]);
        assert.ok(difference <= 1e-9 * size, `${assignments}: ${index}, ${axis} ${difference}`);
      }
    });
  }
});

test('schlupf explore serves the page, and ends', { skip }, async () => {
  const server = spawn(command, ['explore', '--no-browser']);
  try {
    const said = await new Promise((resolve, reject) => {
      server.stdout.once('data', (data) => resolve(String(data)));
      server.stderr.once('data', (data) => reject(new Error(String(data))));
    });
    const address = /http:\/\/127\.0\.0\.1:\d+\//.exec(said)?.[0];
    assert.ok(address, said);
    const page = await fetch(address);
    assert.match(page.headers.get('content-type'), /text\/html/);
    const text = await page.text();
    const script = /src="\.\/(assets\/[^"]+\.js)"/.exec(text)?.[1];
    assert.ok(script, text);
    assert.equal((await fetch(address + script)).status, 200);
    assert.equal((await fetch(`${address}package.json`)).status, 404);
  } finally {
    server.kill('SIGINT');
  }
  const code = await new Promise((resolve) => server.once('exit', resolve));
  assert.equal(code, 130);
});
