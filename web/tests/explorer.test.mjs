// The page in a real browser, against the module in node.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import ts from 'typescript';
import { provide_table } from '../pkg/schlupf_wasm.js';
import { deflateRawSync } from 'node:zlib';
import {
  browse,
  CASES,
  catalogueInNode,
  inNode,
  now,
  opened,
  serve,
  shown,
  slide,
  solved,
} from './support.mjs';

const AXE = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const CREEPAGE = 'kinematics.creepage_x';

let server;
let browser;

before(async () => {
  server = await serve();
  browser = await browse();
});

after(async () => {
  await browser?.close();
  await server?.close();
});

/** Runs with a page of its own. */
async function withPage(options, hash, act) {
  const context = await browser.newContext({
    viewport: { width: 1440, height: 900 },
    locale: 'en',
    ...options,
  });
  try {
    const { page, errors } = await opened(context, server.address, hash);
    await act(page, errors, context);
  } finally {
    await context.close();
  }
}

/** Does something and waits for the solution after it. */
async function andSolved(page, act) {
  const moment = await now(page);
  await act();
  await solved(page, moment);
}

function force(answer) {
  return answer.tables().solution[0]['force.x'].values[0];
}

function near(actual, expected) {
  assert.ok(
    Math.abs(actual - expected) <= 1e-9 * Math.abs(expected),
    `${actual} is not ${expected}`,
  );
}

test('loads, shows the first result and logs no error', () =>
  withPage({}, '', async (page, errors) => {
    const milliseconds = await page.evaluate(() => Number(document.documentElement.dataset.solved));
    console.log(`first result ${milliseconds.toFixed(0)} ms after the start of the load`);
    assert.equal(await page.locator('.side .status.bad').count(), 0);
    const reference = await inNode('steel_wheel_driving');
    near(await shown(page, 'force.x'), force(reference.solve([], new Float64Array())));
    assert.deepEqual(errors, []);
  }));

test('a slider gives the force that the module gives', () =>
  withPage({}, '#case=steel_wheel_driving', async (page, errors) => {
    await andSolved(page, () => slide(page, CREEPAGE, 380));
    const text = await page
      .locator(`.panel [data-path="${CREEPAGE}"] input[type=text]`)
      .inputValue();
    const reference = await inNode('steel_wheel_driving');
    reference.solve([], new Float64Array());
    const expected = force(reference.solve([CREEPAGE], Float64Array.of(Number(text))));
    assert.notEqual(Number(text), -0.003);
    near(await shown(page, 'force.x'), expected);
    assert.deepEqual(errors, []);
  }));

test('the arrow keys move a slider', () =>
  withPage({}, '#case=steel_wheel_driving', async (page) => {
    const slider = page.locator(`.panel [data-path="${CREEPAGE}"] input[type=range]`);
    const before = await shown(page, 'force.x');
    await slider.focus();
    await andSolved(page, () => page.keyboard.press('ArrowLeft'));
    assert.notEqual(await shown(page, 'force.x'), before);
  }));

test('a bad file shows what is wrong, where and how its line reads', () =>
  withPage({}, '', async (page) => {
    const text = 'title = "bad"\n\n[normal]\nload = "80 kJ"\n';
    const file = { name: 'bad.toml', mimeType: 'application/toml', buffer: Buffer.from(text) };
    await page.setInputFiles('input[type=file]', file);
    const problems = page.locator('.problems');
    await problems.waitFor();
    const told = await problems.innerText();
    assert.match(told, /bad\.toml, line 4/);
    assert.match(told, /normal\.load must be a force/);
    assert.match(told, /load = "80 kJ"/);
  }));

test('a link restores case, changes and view', () =>
  withPage(
    { permissions: ['clipboard-read', 'clipboard-write'] },
    '',
    async (page, _errors, context) => {
      await andSolved(page, async () => {
        const load = page.locator('.panel [data-path="normal.load"] input[type=text]');
        await load.fill('100');
        await load.press('Enter');
      });
      await page.getByRole('tab', { name: 'Curve' }).click();
      await page.click('#share');
      await page.getByText('Copied').waitFor();
      const url = new URL(await page.evaluate(() => navigator.clipboard.readText()));
      const other = await opened(context, server.address, url.hash);
      assert.equal(await shown(other.page, 'force.x'), await shown(page, 'force.x'));
      const load = other.page.locator('.panel [data-path="normal.load"] input[type=text]');
      assert.equal(await load.inputValue(), '100');
      const chosen = other.page.getByRole('tab', { name: 'Curve' });
      assert.equal(await chosen.getAttribute('aria-selected'), 'true');
    },
  ));

test('the present point moves along the curve', () =>
  withPage({}, '#case=locomotive_layer&view=curve', async (page, errors) => {
    await page.locator('.curve-place .u-legend').waitFor();
    const handle = page.locator('.handle');
    const before = Number(await handle.getAttribute('aria-valuenow'));
    await handle.focus();
    await andSolved(page, () => page.keyboard.press('ArrowRight'));
    assert.ok(Number(await handle.getAttribute('aria-valuenow')) > before);
    assert.deepEqual(errors, []);
  }));

test('a wheel is moved sideways', () =>
  withPage({}, '#case=wheel_on_rail&view=wheel', async (page, errors) => {
    const before = await shown(page, 'force.y');
    await page.locator('#panel-wheel canvas[role=slider]').focus();
    await andSolved(page, () => page.keyboard.press('Shift+ArrowRight'));
    assert.notEqual(await shown(page, 'force.y'), before);
    assert.deepEqual(errors, []);
  }));

test('a transient has frames', () =>
  withPage({}, '#case=braking_from_rolling', async (page, errors) => {
    const scrub = page.locator('.player input');
    assert.ok(Number(await scrub.getAttribute('max')) > 10);
    await scrub.fill('3');
    assert.deepEqual(errors, []);
  }));

test('a result is pinned beside the next one', () =>
  withPage({}, '#case=half_space', async (page, errors) => {
    await page.getByRole('button', { name: 'Pin to compare' }).click();
    await andSolved(page, () => slide(page, CREEPAGE, 700));
    assert.equal(await page.locator('.maps .map:visible').count(), 2);
    const row = page.locator('.compared tr', { hasText: 'longitudinal force' }).first();
    const [present, pinned, change] = (await row.locator('td').allInnerTexts()).map((text) =>
      Number(text.replace('−', '-')),
    );
    assert.ok(Math.abs(present - pinned - change) < 0.01 * Math.abs(present));
    assert.deepEqual(errors, []);
  }));

/** Pixels of a chart that have the colour of a curve. */
function pixelsOf(chart, index) {
  return chart.locator('canvas').evaluate((canvas, at) => {
    const named = getComputedStyle(document.documentElement).getPropertyValue(`--curve-${at}`);
    const pen = Object.assign(document.createElement('canvas'), { width: 1, height: 1 });
    const context = pen.getContext('2d');
    context.fillStyle = named.trim();
    context.fillRect(0, 0, 1, 1);
    const wanted = context.getImageData(0, 0, 1, 1).data.join();
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let pixel = 0; pixel < data.length; pixel += 4) {
      if (data.slice(pixel, pixel + 4).join() === wanted) count += 1;
    }
    return count;
  }, index);
}

test('the section of a smaller pinned patch is drawn beside that of a larger one', () =>
  withPage({}, '#case=steel_wheel_driving', async (page, errors) => {
    await page.getByRole('button', { name: 'Pin to compare' }).click();
    await andSolved(page, () => give(page, 'normal.load', '120 kN'));
    const section = page.locator('#panel-patch .chart:visible');
    for (const colour of [0, 2]) assert.ok((await pixelsOf(section, colour)) > 50, `${colour}`);
    await andSolved(page, () => give(page, 'normal.load', '40 kN'));
    for (const colour of [0, 2]) assert.ok((await pixelsOf(section, colour)) > 50, `${colour}`);
    assert.deepEqual(errors, []);
  }));

/** Starts a solution that takes far longer than a test. */
async function solveLong(page) {
  await give(page, 'grid.cells_y', '210');
  await give(page, 'grid.cells_x', '620');
  await page.locator('.told .running:visible').waitFor();
}

test('pinning is no solution, and is off while the result is not that of the case', () =>
  withPage({}, '#case=half_space', async (page, errors) => {
    const pin = page.locator('.side header button');
    await solveLong(page);
    const moment = await page.evaluate(() => document.documentElement.dataset.solved);
    await pin.click();
    await page.locator('.compared').first().waitFor();
    assert.ok(await page.locator('.told .running').isVisible());
    assert.equal(await page.evaluate(() => document.documentElement.dataset.solved), moment);
    await page.locator('.told').getByRole('button', { name: 'Cancel' }).click();
    await page.locator('.results .status.bad').waitFor();
    assert.ok(await pin.isDisabled());
    for (const cells of ['grid.cells_x', 'grid.cells_y']) await give(page, cells, '');
    await page.waitForFunction(() => !document.querySelector('.results .status.bad'));
    assert.ok(await pin.isEnabled());
    assert.deepEqual(errors, []);
  }));

test('another case does not wait for a long solution', () =>
  withPage({}, '#case=half_space', async (page, errors) => {
    await solveLong(page);
    const moment = await now(page);
    await page.selectOption('#gallery', 'steel_wheel_driving');
    await solved(page, moment, 8000);
    assert.equal(await page.locator('.problems').count(), 0);
    assert.deepEqual(errors, []);
  }));

test('an input error is told during a long solution, and is gone with the next one', () =>
  withPage({}, '#case=half_space', async (page, errors) => {
    await solveLong(page);
    await give(page, 'kinematics.speed', '80 kJ');
    await page.locator('.told .problems').waitFor({ timeout: 8000 });
    assert.ok(!(await page.locator('.told .running').isVisible()));
    await give(page, 'kinematics.speed', '20 m/s');
    await page.locator('.told .running:visible').waitFor();
    assert.equal(await page.locator('.told .problems').count(), 0);
    assert.deepEqual(errors, []);
  }));

test('a wheel is pinned beside the next position, with its curves', () =>
  withPage({}, '#case=wheel_on_rail&view=wheel', async (page, errors) => {
    await page.click('[data-task=wheelset]');
    await page.locator('#panel-wheel .u-legend').first().waitFor();
    await page.getByRole('button', { name: 'Pin to compare' }).click();
    const canvas = page.locator('#panel-wheel canvas[role=slider]');
    await canvas.focus();
    await andSolved(page, () => page.keyboard.press('Shift+ArrowRight'));
    assert.equal(await page.locator('#panel-wheel .profiles canvas:visible').count(), 3);
    for (const [part, name] of [
      ['.contacts', 'radius of the wheel'],
      ['.contacts', 'lateral force'],
      ['.results', 'number of contacts'],
    ].map(([place, text]) => [page.locator(place), text])) {
      const row = part.locator('.compared tr', { hasText: name }).first();
      const cells = (await row.locator('td').allInnerTexts()).slice(0, 3);
      const [present, pinned, change] = cells.map((text) => Number(text.replace('−', '-')));
      assert.ok(Math.abs(present - pinned - change) <= 2e-3 * Math.abs(present), cells.join());
    }
    await page.locator('#panel-wheel .u-legend', { hasText: 'pinned' }).first().waitFor();
    assert.deepEqual(await seriousFlaws(page), []);
    assert.deepEqual(errors, []);
  }));

test('what has a defining equation shows it', () =>
  withPage({}, '#case=steel_wheel_driving', async (page) => {
    const titled = (part) => page.locator(`[title*="${part}"]`).first();
    await titled('P = ∫ q dA').waitFor();
    await titled('ξ = cos α − ω R/v0').waitFor();
    await page.selectOption('#quantity', 'friction_power');
    assert.match(await page.locator('#quantity').getAttribute('title'), /q = −\(t_x s_x/);
  }));

test('a profile is read as that of the wheel', () =>
  withPage({}, '#case=wheel_on_rail', async (page, errors) => {
    const points = Array.from({ length: 41 }, (_, index) => index - 20);
    const text = `y [mm],z [mm]\n${points.map((y) => `${y},${0.05 * y}`).join('\n')}\n`;
    await page.setInputFiles('input[type=file]', {
      name: 'cone.csv',
      mimeType: 'text/csv',
      buffer: Buffer.from(text),
    });
    await page.getByRole('button', { name: 'wheel', exact: true }).click();
    const profile = page.locator('.panel [data-path="wheel.profile"] input');
    await page.waitForFunction(
      (field) => field?.value === 'cone.csv',
      await profile.elementHandle(),
    );
    assert.deepEqual(errors, []);
  }));

test('a field that rules out another can be taken out', () =>
  withPage({}, '#case=steel_wheel_braking&view=curve', async (page) => {
    await page.locator('.curve-place .u-legend').waitFor();
    await page.locator('.handle').focus();
    await page.keyboard.press('ArrowLeft');
    const remedy = page.getByRole('button', { name: /Take out kinematics.angular_velocity/ });
    await andSolved(page, () => remedy.click());
    assert.equal(await page.locator('.problems').count(), 0);
  }));

/** A module of the page that imports nothing but types. */
async function pageModule(path) {
  const source = await readFile(new URL(`../src/${path}`, import.meta.url), 'utf8');
  const options = { module: ts.ModuleKind.ESNext, target: ts.ScriptTarget.ES2022 };
  const { outputText } = ts.transpileModule(source, { compilerOptions: options });
  return import(`data:text/javascript,${encodeURIComponent(outputText)}`);
}

/** The distance of a place from a line, in m. */
function distance({ y, z }, [py, pz]) {
  const parts = y.slice(1).map((end, index) => {
    const [dy, dz] = [end - y[index], z[index + 1] - z[index]];
    const along = ((py - y[index]) * dy + (pz - z[index]) * dz) / (dy * dy + dz * dz);
    const at = Math.max(0, Math.min(1, along));
    return Math.hypot(y[index] + at * dy - py, z[index] + at * dz - pz);
  });
  return Math.min(...parts);
}

test('the wheel is drawn where it touches the rail', async () => {
  const { placedWheel } = await pageModule('views/pose.ts');
  const wheel = await inNode('wheel_on_rail');
  const outlines = JSON.parse(wheel.outlines());
  // A small load: the undeformed profiles overlap by what is flattened.
  const moved = ['wheelset.lateral_position', 'normal.load'];
  const tables = wheel.solve(moved, Float64Array.of(-7e-3, 2e3)).tables();
  const of = (table, name) => table[name].values[0];
  const [pose] = tables.wheel;
  const drawn = placedWheel(outlines, {
    lateral: -7e-3,
    outlined: 5e-3,
    height: of(pose, 'wheelset.height'),
    roll: of(pose, 'wheelset.roll_angle'),
  });
  for (const contact of tables.contact) {
    const place = [of(contact, 'position.y'), of(contact, 'position.z')];
    for (const line of [drawn, outlines.rail]) assert.ok(distance(line, place) < 1e-4);
  }
});

test('a dragged wheel stays under the pointer, within its range', () =>
  withPage({}, '#case=wheel_on_rail&view=wheel', async (page) => {
    const canvas = page.locator('#panel-wheel canvas[role=slider]');
    const { x, y, width, height } = await canvas.boundingBox();
    const axis = { x: x + 60, y: y + height - 30, width: width - 80, height: 25 };
    const before = await page.screenshot({ clip: axis });
    await page.mouse.move(x + width / 2, y + 80);
    await page.mouse.down();
    await andSolved(page, () => page.mouse.move(x + width / 2 + 40, y + 80));
    assert.deepEqual(await page.screenshot({ clip: axis }), before);
    await page.mouse.move(x + width - 5, y + 80, { steps: 3 });
    await page.waitForTimeout(500);
    assert.equal((await canvas.boundingBox()).y, y);
    const [low, value] = await Promise.all(
      ['aria-valuemin', 'aria-valuenow'].map((name) => canvas.getAttribute(name).then(Number)),
    );
    assert.ok(low <= value && value < 5, `${value} mm`);
    await page.mouse.up();
  }));

test('the standard table is fetched for the method that needs it', () =>
  withPage({}, '#case=steel_wheel_driving', async (page, errors) => {
    await page.getByPlaceholder('Find a field').fill('solver.method');
    const method = page.locator('.panel [data-path="solver.method"] select');
    await andSolved(page, () => method.selectOption('table'));
    provide_table(await readFile(new URL('../public/standard.npz', import.meta.url)));
    const reference = await inNode('steel_wheel_driving', ['solver.method="table"']);
    near(await shown(page, 'force.x'), force(reference.solve([], new Float64Array())));
    assert.deepEqual(errors, []);
  }));

test('the contact shown is compared with the same contact', () =>
  withPage({}, '#case=crossing_nose', async (page) => {
    await page.selectOption('#contact', '1');
    await page.getByRole('button', { name: 'Pin to compare' }).click();
    const changes = await page.locator('.compared td:nth-child(4)').allInnerTexts();
    assert.ok(changes.length > 5 && changes.every((text) => text === '0'), changes.join());
  }));

test('an end of a curve that is no number is refused', () =>
  withPage({}, '#case=steel_wheel_driving&view=curve', async (page) => {
    await page.fill('#range-end', 'abc');
    await page.press('#range-end', 'Enter');
    await page.getByText('is not a number').waitFor();
    await page.fill('#range-end', '-0,02');
    await page.press('#range-end', 'Enter');
    await page.locator('.curve-place .u-legend').waitFor();
    assert.equal(await page.getByText('is not a number').count(), 0);
  }));

test('a transient has no curves, and results of its end', () =>
  withPage({}, '#case=braking_from_rolling&view=curve', async (page) => {
    await page.getByText('Curves are for steady rolling').waitFor();
    await page.getByText('At the end of the time').waitFor();
    assert.equal(await page.locator('#panel-curve .problems').count(), 0);
  }));

test('a long task tells its time and can be cancelled', () =>
  withPage({}, '#case=wheel_on_rail', async (page, errors) => {
    await page.click('[data-task=subsurface]');
    const running = page.locator('.inquiry', { has: page.getByRole('timer') });
    await running
      .getByRole('timer')
      .filter({ hasText: /\d\.\d s/ })
      .waitFor();
    await running.getByRole('button', { name: 'Cancel' }).click();
    assert.equal(await page.getByRole('timer').count(), 0);
    assert.deepEqual(errors, []);
  }));

/** Gives a field a value that is typed. */
async function give(page, path, text) {
  await page.getByPlaceholder('Find a field').fill(path);
  const input = page.locator(`.panel [data-path="${path}"] input[type=text]`);
  await input.fill(text);
  await input.press('Enter');
}

for (const [name, counted] of [
  ['half_space', /Newton steps \d+/],
  ['braking_from_rolling', /time steps \d+/],
]) {
  test(`a long solution tells how far it is and can be cancelled, ${name}`, () =>
    withPage({}, `#case=${name}`, async (page, errors) => {
      const before = await shown(page, 'force.x');
      await give(page, 'grid.cells_y', '100');
      await give(page, 'grid.cells_x', '600');
      const running = page.locator('.told .running');
      await running.filter({ hasText: counted }).waitFor();
      assert.deepEqual(await seriousFlaws(page), []);
      await running.getByRole('button', { name: 'Cancel' }).click();
      await page.getByText('Cancelled.').waitFor();
      await page.locator('.results .status.bad').waitFor();
      for (const cells of ['grid.cells_x', 'grid.cells_y']) {
        await andSolved(page, () => give(page, cells, ''));
      }
      assert.equal(await shown(page, 'force.x'), before);
      assert.ok(!(await running.isVisible()));
      assert.deepEqual(errors, []);
    }));
}

test('a long curve tells how far it is and can be cancelled', () =>
  withPage({}, '#case=half_space&view=curve', async (page, errors) => {
    for (const cells of ['grid.cells_x', 'grid.cells_y']) await give(page, cells, '60');
    const bounds = ['min', 'max'].map((name) => page.getAttribute('#curve-points', name));
    assert.deepEqual(await Promise.all(bounds), ['2', '10000']);
    await page.fill('#curve-points', '201');
    await page.press('#curve-points', 'Enter');
    const running = page.locator('#panel-curve .inquiry').first();
    await running.getByText(/points \d+\/201/).waitFor();
    await running.getByRole('button', { name: 'Cancel' }).click();
    assert.equal(await page.getByRole('timer').count(), 0);
    await page.fill('#curve-points', '5');
    await page.press('#curve-points', 'Enter');
    await page.locator('.curve-place .u-legend').waitFor();
    assert.deepEqual(errors, []);
  }));

test('speaks German and Chinese', async () => {
  for (const [locale, ...texts] of [
    ['de', 'Kontaktfläche', 'Bohrschlupf', 'positiv beim Bremsen', 'Reibleistung, P (W)'],
    ['zh-CN', '接触斑', '自旋蠕滑率', '制动时为正', '摩擦功率, P (W)'],
  ]) {
    await withPage({ locale }, '', async (page) => {
      const [tab, field, meaning, quantity] = texts;
      assert.equal(await page.getByRole('tab').first().innerText(), tab);
      await page.locator('.panel label', { hasText: field }).first().waitFor();
      assert.ok((await page.locator(`.panel label[title*="${meaning}"]`).count()) > 0);
      assert.equal(await page.locator(`.side tr[title^="${quantity}"]`).count(), 1);
    });
  }
});

test('German and Chinese have words for the same', async () => {
  const [german, chinese] = await Promise.all(
    ['de', 'zh'].map(async (name) => (await pageModule(`languages/${name}.ts`)).default),
  );
  for (const part of ['sections', 'names']) {
    const keys = (words) => Object.entries(words[part]).map(([key, word]) => [key, word.length]);
    assert.deepEqual(keys(chinese), keys(german));
  }
  const { sections } = await catalogueInNode();
  const named = new Set(sections.map(({ name }) => name || 'general'));
  const paths = new Set(sections.flatMap(({ fields }) => fields.map(({ path }) => path)));
  // Names of results have dots, too.
  const isOfSection = (name) => named.has(name.split('.').slice(0, -1).join('.'));
  const isKnown = (name) => paths.has(name) || !isOfSection(name);
  assert.deepEqual(Object.keys(german.sections).filter((name) => !named.has(name)), []);
  assert.deepEqual(Object.keys(german.names).filter((name) => !isKnown(name)), []);
});

test('every case of the gallery is solved', () =>
  withPage({}, '', async (page, errors) => {
    const options = page.locator('#gallery optgroup option');
    const names = await options.evaluateAll((all) => all.map(({ value }) => value));
    assert.ok(names.length > 25);
    for (const name of names) {
      await andSolved(page, () => page.selectOption('#gallery', name));
      assert.deepEqual(await page.locator('.problems').allInnerTexts(), [], name);
    }
    assert.deepEqual(errors, []);
  }));

/** What axe finds that is serious. */
async function seriousFlaws(page) {
  await page.evaluate(AXE);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document));
  const serious = violations.filter(({ impact }) => ['serious', 'critical'].includes(impact));
  return serious.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join('\n  ')}`);
}

test('axe finds nothing serious in dialogs and where a case is wrong', () =>
  withPage({ viewport: { width: 820, height: 1180 } }, '', async (page) => {
    for (const name of ['Edit case', 'The same by command and in Python']) {
      await page.getByRole('button', { name }).click();
      assert.deepEqual(await seriousFlaws(page), [], name);
      await page.keyboard.press('Escape');
    }
    const load = page.locator('.panel [data-path="normal.load"] input[type=text]');
    await load.fill('80 kJ');
    await load.press('Enter');
    await page.locator('.problems').waitFor();
    assert.deepEqual(await seriousFlaws(page), []);
  }));

test('axe finds nothing serious in any view, light or dark', async () => {
  const views = [
    '#case=wheel_on_rail&view=patch',
    '#case=locomotive_layer&view=curve',
    '#case=wheel_on_rail&view=wheel',
  ];
  for (const colorScheme of ['light', 'dark']) {
    for (const hash of views) {
      await withPage({ colorScheme }, hash, async (page) => {
        if (hash.includes('curve')) await page.locator('.curve-place .u-legend').waitFor();
        assert.deepEqual(await seriousFlaws(page), [], `${colorScheme} ${hash}`);
      });
    }
  }
});

/** A link with a state, as text or as an object. */
function linkOf(state) {
  const text = typeof state === 'string' ? state : JSON.stringify(state);
  return `#state=${deflateRawSync(text).toString('base64url')}`;
}

/** A state with a text of a case. */
function stateOf(changes) {
  const text = '[normal]\nload = "80 kN"\n';
  return { name: 'own.toml', text, gallery: null, assignments: [], files: [], ...changes };
}

test('a link puts nothing but words into the command', () => {
  const name = 'case.toml; touch /tmp/x #';
  const title = `"it's $(touch /tmp/y) \\"z\\""`;
  const assignments = [
    ['title', title, null],
    ['x; touch /tmp/z', '1', null],
  ];
  return withPage({}, linkOf(stateOf({ name, assignments })), async (page, errors) => {
    await page.getByRole('button', { name: 'The same by command and in Python' }).click();
    const [command, python] = await page.locator('dialog pre').allInnerTexts();
    const script = `schlupf() { printf '%s\\n' "$@"; }\n${command}`;
    const words = execFileSync('sh', ['-c', script], { encoding: 'utf8' }).trimEnd().split('\n');
    assert.deepEqual(words, ['solve', name, '--set', `title=${title}`]);
    assert.ok(python.includes(`from_file("${name}")`) && python.includes(`title=${title},`));
    assert.deepEqual(errors, []);
  });
});

test('a damaged link is told, and the first case is shown', async () => {
  const states = ['{', stateOf({ files: [['a.csv', 3]] })];
  for (const hash of ['#state=%%%', '#state=AAAA', ...states.map(linkOf)]) {
    await withPage({}, hash, async (page, errors) => {
      await page.getByText('The case of this link cannot be read.').waitFor();
      assert.equal(await page.locator('#gallery').inputValue(), 'steel_wheel_driving');
      assert.deepEqual(errors, []);
    });
  }
});

test('a first case that is bad shows no controls', async () => {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(server.address + linkOf(stateOf({ text: '[normal]\nload = "80 kJ"\n' })));
  await page.getByText('normal.load must be a force').first().waitFor();
  for (const part of ['.controls', '.side']) assert.ok(!(await page.locator(part).isVisible()));
  await context.close();
});

test('a profile dropped on a case without profiles opens a wheel on a rail', () =>
  withPage({}, '', async (page, errors) => {
    const points = Array.from({ length: 41 }, (_, index) => index - 20);
    const text = `y [mm],z [mm]\n${points.map((y) => `${y},${0.05 * y}`).join('\n')}\n`;
    const file = { name: 'cone.csv', mimeType: 'text/csv', buffer: Buffer.from(text) };
    await page.setInputFiles('input[type=file]', file);
    await andSolved(page, () => page.getByRole('button', { name: 'wheel', exact: true }).click());
    const profile = page.locator('.panel [data-path="wheel.profile"] input');
    assert.equal(await profile.inputValue(), 'cone.csv');
    assert.equal(await page.locator('.problems').count(), 0);
    assert.deepEqual(errors, []);
  }));

test('what is no case is refused: other text, a picture, a name of none', () =>
  withPage({}, '#case=half_space', async (page, errors) => {
    const dialog = page.locator('dialog[open]');
    for (const [name, text, told] of [
      ['own.toml', 'title = "a"\n# caf\xe9\n', /UTF-8, but is not in line 2/],
      ['profile.png', '\x89PNG', /profile\.png: neither a case nor/],
      ['profile.pdf', '%PDF', /profile\.pdf: neither a case nor/],
    ]) {
      const mimeType = name.endsWith('png') ? 'image/png' : 'application/pdf';
      const buffer = Buffer.from(text, 'latin1');
      const type = name.endsWith('toml') ? 'application/toml' : mimeType;
      await page.setInputFiles('input[type=file]', { name, mimeType: type, buffer });
      assert.match(await dialog.innerText(), told);
      await page.keyboard.press('Escape');
      await dialog.waitFor({ state: 'detached' });
    }
    await page.evaluate(() => {
      location.hash = '#case=nonexistent';
    });
    await page.getByText('The case of this link cannot be read.').waitFor();
    assert.equal(await page.locator('#gallery').inputValue(), 'half_space');
    await page.waitForTimeout(600);
    assert.ok(await page.getByText('The case of this link cannot be read.').isVisible());
    assert.deepEqual(errors, []);
  }));

test('values stay while another is wrong', () =>
  withPage({}, '#case=steel_wheel_driving', async (page) => {
    const input = (path) => page.locator(`.panel [data-path="${path}"] input[type=text]`);
    await input('normal.load').fill('80 kJ');
    await input('normal.load').press('Enter');
    await page.locator('.problems').waitFor();
    await slide(page, CREEPAGE, 380);
    const moved = await input(CREEPAGE).inputValue();
    await input('kinematics.speed').fill('33');
    await input('kinematics.speed').press('Enter');
    await page.waitForTimeout(600);
    assert.equal(await input(CREEPAGE).inputValue(), moved);
    assert.equal(await input('kinematics.speed').inputValue(), '33');
    await page.selectOption('#gallery', 'half_space');
    await page.waitForFunction(() => !document.querySelector('.problems'));
    await andSolved(page, () => slide(page, CREEPAGE, 1000));
    assert.ok(Number(await input(CREEPAGE).inputValue()) < 1);
  }));

test('a link has a file of its own, whatever its name, unless it is large', () =>
  withPage(
    { permissions: ['clipboard-read', 'clipboard-write'] },
    '#case=two_point_contact',
    async (page, errors, context) => {
      const present = await shown(page, 'force.x');
      const original = await readFile(join(CASES, 'two_point_contact.csv'), 'utf8');
      const own = original.replace(/^(-?[\d.]+),([\d.]+)$/gm, (_, y, z) => `${y},${2 * z}`);
      const give = (name, text) =>
        page.setInputFiles('input[type=file]', {
          name,
          mimeType: 'text/csv',
          buffer: Buffer.from(text),
        });
      await andSolved(page, () => give('two_point_contact.csv', own));
      const changed = await shown(page, 'force.x');
      assert.notEqual(changed, present);
      await page.click('#share');
      await page.getByText('Copied').waitFor();
      const url = new URL(await page.evaluate(() => navigator.clipboard.readText()));
      const other = await opened(context, server.address, url.hash);
      assert.equal(await shown(other.page, 'force.x'), changed);
      await give('two_point_contact.csv', `${own}${'\n'.repeat(2e5)}`);
      await page.click('#share');
      await page.getByText('too large for a link: two_point_contact.csv').waitFor();
      assert.deepEqual(errors, []);
    },
  ));

test('a new surface is offered where it is generated', () =>
  withPage({}, '#case=measured_surface', async (page) => {
    const button = page.getByRole('button', { name: 'New surface' });
    assert.ok(await page.getByRole('button', { name: 'Spots and k_c' }).isVisible());
    assert.ok(!(await button.isVisible()));
    await page.click('[data-task=roughness]');
    await page.locator('.task .map canvas[aria-label^="normal pressure"]').waitFor();
    assert.equal(await page.locator('.task .drawing').count(), 3);
    // k_c in closed form: there is no surface at all.
    await andSolved(page, () => page.selectOption('#gallery', 'rough_surfaces'));
    assert.ok(!(await button.isVisible()));
    assert.ok(!(await page.locator('[data-task=roughness]').isVisible()));
  }));

test('a new surface is solved, and its spots are found when asked for', () => {
  const text = `${stateOf({}).text}
[kinematics]
creepage_x = 0.001

[contact_law.roughness]
rms_height = "1 um"
hurst = 0.8
longest_wavelength = "40 um"
shortest_wavelength = "10 um"
cells = 128
`;
  return withPage({}, linkOf(stateOf({ text })), async (page, errors) => {
    const before = await shown(page, 'force.x');
    await andSolved(page, () => page.getByRole('button', { name: 'New surface' }).click());
    assert.notEqual(await shown(page, 'force.x'), before);
    assert.equal(await page.locator('.inquiry .running:visible').count(), 0);
    await page.click('[data-task=roughness]');
    await page.locator('.task .map canvas[aria-label^="normal pressure"]').waitFor();
    assert.deepEqual(errors, []);
  });
});

test('a task is gone with its case and marked when the case changes', () =>
  withPage({}, '#case=stresses_below', async (page) => {
    const task = page.locator('.task').first();
    await page.click('[data-task=subsurface]');
    await task.locator('.drawing').first().waitFor();
    await andSolved(page, () => slide(page, CREEPAGE, 380));
    await task.getByText('The case has changed since.').waitFor();
    await andSolved(page, () => page.selectOption('#gallery', 'half_space'));
    assert.equal(await task.locator('.drawing').count(), 0);
    assert.ok(!(await task.getByText('The case has changed since.').isVisible()));
  }));

test('works offline after it was loaded', () =>
  withPage({}, '', async (page, _errors, context) => {
    await page.evaluate(() => navigator.serviceWorker.ready.then(() => true));
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    await context.setOffline(true);
    await page.goto(`${server.address}index.html`);
    await solved(page);
    await andSolved(page, () => page.selectOption('#gallery', 'two_point_contact'));
    assert.equal(await page.locator('.problems').count(), 0);
  }));

for (const [name, field] of [
  ['steel_wheel_driving', CREEPAGE],
  ['wheel_on_rail', 'wheelset.lateral_position'],
]) {
  test(`time from slider to paint, ${name}`, () =>
    withPage({}, `#case=${name}`, async (page) => {
      const times = [];
      for (let step = 0; step < 20; step += 1) {
        times.push(
          await page.evaluate(
            async ([path, position]) => {
              const slider = document.querySelector(
                `.panel [data-path="${path}"] input[type=range]`,
              );
              const start = performance.now();
              slider.value = String(position);
              slider.dispatchEvent(new Event('input', { bubbles: true }));
              while (Number(document.documentElement.dataset.solved) < start) {
                await new Promise((resolve) => requestAnimationFrame(resolve));
              }
              return performance.now() - start;
            },
            [field, 380 + step],
          ),
        );
        await page.waitForTimeout(30);
      }
      times.sort((one, other) => one - other);
      console.log(`${name}: slider to paint, median of 20: ${times[10].toFixed(0)} ms`);
    }));
}
