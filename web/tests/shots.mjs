// Screenshots of all views, light and dark, on a desktop and a tablet: `npm run shots FOLDER`.
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { browse, opened, serve } from './support.mjs';

const folder = process.argv[2];
if (!folder) throw new Error('name a folder');
await mkdir(folder, { recursive: true });

const SIZES = { desktop: { width: 1440, height: 900 }, tablet: { width: 820, height: 1180 } };

/** Views: their hash and what is done before the picture. */
const VIEWS = {
  patch: [
    '#case=neuhaus_sextro_2014_combined&view=patch',
    async (page) => {
      await page.selectOption('#quantity', 'traction');
    },
  ],
  curve: [
    '#case=falling_adhesion&view=curve',
    async (page) => {
      await page.waitForSelector('.curve-place .u-legend', { timeout: 60_000 });
      await page.click('[data-task=map]');
      await page.waitForSelector('#panel-curve .map:not([hidden])', { timeout: 120_000 });
    },
  ],
  wheel: [
    '#case=wheel_on_rail&view=wheel',
    async (page) => {
      await page.click('[data-task=wheelset]');
      await page.waitForSelector('#panel-wheel .u-legend', { timeout: 200_000 });
      await page.evaluate(() => scrollTo(0, 0));
    },
  ],
  contact: [
    '#case=wheel_on_rail&view=wheel',
    async (page) => {
      await page.check('#panel-wheel input[type=checkbox]');
    },
  ],
  below: [
    '#case=stresses_below&view=patch',
    async (page) => {
      await page.click('[data-task=subsurface]');
      await page.waitForSelector('.drawing', { timeout: 60_000 });
      await page
        .locator('.task')
        .first()
        .evaluate((task) => task.scrollIntoView());
    },
  ],
  transient: [
    '#case=braking_from_rolling&view=patch',
    async (page) => {
      await page.selectOption('#quantity', 'traction_x');
      await page.locator('.player input').fill('20');
    },
  ],
  compare: [
    '#case=methods&view=patch',
    async (page) => {
      await page.selectOption('#quantity', 'traction');
      await page.click('.side > header button');
      await page.locator('[data-path="kinematics.creepage_x"] input[type=text]').fill('0.0035');
      await page.keyboard.press('Enter');
      await page.waitForTimeout(1500);
    },
  ],
  problem: [
    '#case=steel_wheel_driving&view=patch',
    async (page) => {
      await page.locator('[data-path="normal.load"] input[type=text]').fill('80 kJ');
      await page.keyboard.press('Enter');
      await page.waitForSelector('.problems');
    },
  ],
};

const wanted = process.argv.slice(3);
const { address, close } = await serve();
const browser = await browse();
for (const [size, viewport] of Object.entries(SIZES)) {
  for (const colorScheme of ['light', 'dark']) {
    const context = await browser.newContext({ viewport, colorScheme, locale: 'en' });
    for (const [name, [hash, prepare]] of Object.entries(VIEWS)) {
      const title = `${name}_${size}_${colorScheme}`;
      if (wanted.length > 0 && !wanted.some((part) => title.includes(part))) continue;
      const { page, errors } = await opened(context, address, hash);
      await prepare(page);
      await page.waitForTimeout(400);
      await page.screenshot({ path: join(folder, `${title}.png`) });
      if (errors.length > 0) console.log(title, errors);
      await page.close();
    }
    await context.close();
  }
}
await browser.close();
await close();
