// The page in a real browser, against the module in node.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { browse, inNode, now, opened, serve, shown, slide, solved } from './support.mjs';

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
    assert.equal(await page.locator('.status.bad').count(), 0);
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
    const row = page.locator('.compared tr', { hasText: 'force x' }).first();
    const [present, pinned, change] = (await row.locator('td').allInnerTexts()).map((text) =>
      Number(text.replace('−', '-')),
    );
    assert.ok(Math.abs(present - pinned - change) < 0.01 * Math.abs(present));
    assert.deepEqual(errors, []);
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

test('speaks German and Chinese', async () => {
  for (const [locale, text] of [
    ['de', 'Kontaktfläche'],
    ['zh-CN', '接触斑'],
  ]) {
    await withPage({ locale }, '', async (page) => {
      assert.equal(await page.getByRole('tab').first().innerText(), text);
    });
  }
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

test('works offline after it was loaded', () =>
  withPage({}, '', async (page, _errors, context) => {
    await page.evaluate(() => navigator.serviceWorker.ready.then(() => true));
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    await context.setOffline(true);
    await page.reload();
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
