// browser_test.mjs PROGRAM CHROMIUM: what a person sees and does in the reports, in a real browser without a network.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after, before, describe } from 'node:test';
import { chromium } from 'playwright-core';

const [program, executablePath] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'lineservo-report-'));
const flight = join(folder, 'flight/report.html'),
  comparison = join(folder, 'comparison/report.html');
const summary = () => JSON.parse(readFileSync(join(folder, 'flight/summary.json')));
const dataPlace = /(<script id="report-data" type="application\/json">)([^]*?)(<\/script>)/;
let browser;

function run(...words) {
  const { status, stderr } = spawnSync(program, words, { encoding: 'utf8' });
  assert.equal(status, 0, stderr);
}

before(async () => {
  run('fly', 'a13', '--out', join(folder, 'flight'));
  run(
    'compare',
    '--controllers',
    'ibvs,pid',
    '--instructions',
    'a03,a13',
    '--layout',
    'warehouse,tape-warehouse',
    '--runs',
    '1',
    '--tuning',
    'published',
    '--seed',
    '1',
    '--out',
    join(folder, 'comparison'),
  );
  browser = await chromium.launch({ executablePath, args: ['--no-sandbox'] });
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

/** Opens a report; what it complains of or asks of the network is in `faults`. */
async function open(file, { width = 1280, height = 900 } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, offline: true });
  const page = await context.newPage(),
    faults = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) faults.push(message.text());
  });
  page.on('pageerror', (error) => faults.push(error.stack));
  page.on('request', (request) => {
    if (!/^(data:|file:.*report.*\.html$)/.test(request.url())) faults.push(request.url());
  });
  await page.goto(`file://${file}`);
  await page.waitForSelector('html[data-ready=true]', { timeout: 10000 });
  return { page, faults };
}

/** The same report with other data. */
function changed(file, name, change) {
  const html = readFileSync(file, 'utf8'),
    data = JSON.parse(dataPlace.exec(html)[2]);
  change(data);
  const other = join(folder, name);
  writeFileSync(
    other,
    html.replace(dataPlace, (all, before, json, end) => before + JSON.stringify(data) + end),
  );
  return other;
}

/** For each chart its name, and how much of it is drawn: shapes beside the axes' texts, and the longest of them. */
const drawn = (page) =>
  page.$$eval('.chart', (charts) =>
    charts.map((chart) => {
      const shapes = [...chart.querySelectorAll('svg path, svg rect, svg circle, svg polyline')];
      return {
        id: chart.id,
        width: chart.querySelector('svg').getBoundingClientRect().width,
        shapes: shapes.length,
        texts: chart.querySelectorAll('svg text').length,
        longest: Math.max(...shapes.map((shape) => (shape.getAttribute('d') ?? '').length)),
      };
    }),
  );

const cursors = (page) =>
  page.$$eval('.cursor', (all) =>
    all
      .filter((one) => !one.parentElement.querySelector('.vehicle'))
      .map((one) => (one.hidden ? null : parseFloat(one.style.left))),
  );
const vehicles = (page) =>
  page.$$eval('.vehicle', (all) => all.map((one) => (one.hidden ? null : one.style.transform)));
const slideTo = (page, tick) =>
  page.$eval(
    '#time',
    (slider, value) => {
      slider.value = value;
      slider.dispatchEvent(new Event('input'));
    },
    tick,
  );
/** What the camera picture shows: paint has little blue, the floor has as much of all colours. */
const colours = (page) =>
  page.$eval('#camera', async (picture) => {
    await picture.decode();
    const size = [picture.naturalWidth, picture.naturalHeight];
    const canvas = new OffscreenCanvas(...size).getContext('2d', { willReadFrequently: true });
    canvas.drawImage(picture, 0, 0);
    const at = (x, y) => {
      const [red, , blue] = canvas.getImageData(x, y, 1, 1).data;
      return red - blue > 100 ? 'paint' : Math.abs(red - blue) < 30 ? 'floor' : 'else';
    };
    return { size, middle: at(size[0] / 2, size[1] / 2), corner: at(5, 5) };
  });
const overflows = (page) =>
  page.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth);

describe('the report of a flight', () => {
  test('loads without a complaint and without the network', async () => {
    const { page, faults } = await open(flight);
    assert.deepEqual(faults, []);
    assert.match(await page.title(), /^a13 · ibvs/);
    await page.context().close();
  });

  test('draws every plot', async () => {
    const { page } = await open(flight);
    const charts = await drawn(page);
    assert.deepEqual(
      charts.map((chart) => chart.id),
      ['map', 'end', 'error', 'codes', 'velocity', 'yaw-rate', 'height', 'tilt'],
    );
    for (const chart of charts) {
      assert.ok(chart.shapes > 10 && chart.texts > 3 && chart.width > 300, JSON.stringify(chart));
      if (chart.id !== 'codes') assert.ok(chart.longest > (chart.id === 'end' ? 300 : 1000), JSON.stringify(chart));
    }
    await page.context().close();
  });

  test('the slider moves map and plots to the tick', async () => {
    const { page } = await open(flight);
    const { t_s, x_m, y_m } = JSON.parse(await page.$eval('#report-data', (script) => script.textContent)).ticks;
    const seen = [];
    for (const share of [0.3, 0.6, 0.9]) {
      const tick = Math.round(share * (t_s.length - 1));
      await slideTo(page, tick);
      const at = await cursors(page);
      assert.equal(at.length, 6);
      assert.equal(new Set(at).size, 1, 'all plots show the same time');
      assert.ok((await page.textContent('#now')).startsWith(`${t_s[tick].toFixed(1)} s`));
      seen.push({ x_px: at[0], t_s: t_s[tick], vehicle: (await vehicles(page))[0], x_m: x_m[tick], y_m: y_m[tick] });
    }
    const [a, b, c] = seen;
    assert.ok(
      Math.abs((b.x_px - a.x_px) / (b.t_s - a.t_s) - (c.x_px - b.x_px) / (c.t_s - b.t_s)) < 0.02,
      'the cursor is linear in time',
    );
    const [pa, pc] = [a, c].map((one) =>
      one.vehicle
        .match(/translate\(([\d.]+)px, ([\d.]+)px\)/)
        .slice(1)
        .map(Number),
    );
    const scale = Math.hypot(pc[0] - pa[0], pc[1] - pa[1]) / Math.hypot(c.x_m - a.x_m, c.y_m - a.y_m);
    assert.ok(Math.abs(pc[0] - pa[0] - scale * (c.x_m - a.x_m)) < 1, 'a metre is as long on both axes');
    assert.ok(Math.abs(pa[1] - pc[1] - scale * (c.y_m - a.y_m)) < 1, 'and y is up');
    await page.context().close();
  });

  test('the keyboard moves the slider, and a click in a plot the time', async () => {
    const { page } = await open(flight);
    await page.focus('#time');
    const before = await page.inputValue('#time');
    await page.keyboard.press('ArrowRight');
    assert.equal(Number(await page.inputValue('#time')), Number(before) + 1);
    const box = await page.locator('#codes').boundingBox();
    await page.locator('#codes').click({ position: { x: box.width / 2, y: 20 } });
    assert.ok(Math.abs((await cursors(page))[1] - box.width / 2) < 3);
    await page.context().close();
  });

  test('the last tick is at the target in the zoom on the end', async () => {
    const { page } = await open(flight);
    assert.equal((await vehicles(page))[1], null, 'out of its view before');
    await slideTo(page, 1e9);
    const [x, y] = (await vehicles(page))[1]
      .match(/translate\(([\d.]+)px, ([\d.]+)px\)/)
      .slice(1)
      .map(Number);
    const box = await page.locator('#end').boundingBox();
    assert.ok(Math.abs(x - box.width / 2) < 60 && Math.abs(y - box.height / 2) < 60);
    await page.context().close();
  });

  test('a window of 5 s follows the slider', async () => {
    const { page } = await open(flight);
    await slideTo(page, 600);
    const label = () =>
      page.$$eval('#error svg text', (texts) =>
        texts.map((text) => text.textContent).filter((text) => /^\d+ s$/.test(text)),
      );
    const all = await label();
    await page.selectOption('.scrubber select', '5');
    await page.waitForTimeout(200);
    assert.notDeepEqual(await label(), all);
    const width = (await page.locator('#error').boundingBox()).width;
    for (const x of await cursors(page)) assert.ok(Math.abs(x - width / 2) < 60, `${x}`);
    await page.context().close();
  });

  test('zooming the map makes it larger about its middle', async () => {
    const { page } = await open(flight);
    await slideTo(page, 700);
    const before = (await vehicles(page))[0];
    await page.click('.map .zoom button');
    assert.notEqual((await vehicles(page))[0], before);
    await page.locator('.map .zoom button').nth(2).click();
    assert.equal((await vehicles(page))[0], before);
    await page.context().close();
  });

  test('stands beside the published figures', async () => {
    const { page } = await open(flight);
    const rows = await page.$$eval('table.figures tbody tr', (all) =>
      all.map((row) => [...row.cells].map((cell) => cell.innerText)),
    );
    const terminal = rows.find(([name]) => name === 'terminal error');
    assert.equal(terminal[1], `${(summary().terminal_error_m * 100).toFixed(1)} cm`);
    assert.equal(terminal[2], '16 cm');
    await page.context().close();
  });

  test("shows the camera picture of the slider's time", async () => {
    const { page, faults } = await open(flight);
    const { ticks, thumbnails } = JSON.parse(await page.$eval('#report-data', (script) => script.textContent));
    assert.ok(thumbnails.length > 100 && thumbnails.length <= 300, `${thumbnails.length}`);
    const seen = new Set();
    for (const share of [0.1, 0.35, 0.6, 1]) {
      const tick = Math.round(share * (ticks.t_s.length - 1));
      await slideTo(page, tick);
      const picture = await page.getAttribute('#camera', 'src');
      const at = thumbnails.findLast((one) => one.t_s <= ticks.t_s[tick]);
      assert.ok(picture === at.uri && ticks.t_s[tick] - at.t_s < 1, `${share}`);
      seen.add(picture);
    }
    assert.equal(seen.size, 4);
    assert.deepEqual(await colours(page), { size: [200, 150], middle: 'paint', corner: 'floor' }, 'over the cross at the end');
    assert.deepEqual(faults, []);
    await page.context().close();
  });

  test('a click makes the camera picture larger, on a phone too', async () => {
    for (const size of [{}, { width: 390, height: 844 }]) {
      const { page } = await open(flight, size);
      const width = async () => (await page.locator('#camera').boundingBox()).width;
      const small = await width();
      await page.click('.camera');
      assert.ok((await width()) > 2 * small);
      assert.equal(await overflows(page), false);
      assert.ok(await page.locator('#time').isVisible());
      await page.click('.camera');
      assert.equal(await width(), small);
      await page.context().close();
    }
  });

  test('says so where there are no camera pictures', async () => {
    const { page, faults } = await open(
      changed(flight, 'report-blind.html', (data) => {
        data.thumbnails = [];
      }),
    );
    assert.ok(await page.isHidden('#camera'));
    assert.match(await page.textContent('#no-camera'), /No camera pictures/);
    assert.deepEqual(faults, []);
    await page.context().close();
  });

  test('fits a phone and paper', async () => {
    const { page } = await open(flight, { width: 390, height: 844 });
    assert.equal(await overflows(page), false);
    await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
    for (const chart of await drawn(page)) assert.ok(chart.width <= 681 && chart.width > 200, JSON.stringify(chart));
    await page.evaluate(() => window.dispatchEvent(new Event('afterprint')));
    for (const chart of await drawn(page)) assert.ok(chart.width <= 390, JSON.stringify(chart));
    await page.context().close();
  });

  test('of a flight without a tick says what there is', async () => {
    const { page, faults } = await open(
      changed(flight, 'report-nothing.html', (data) => {
        for (const name of Object.keys(data.ticks)) data.ticks[name] = [];
        Object.assign(data.summary, {
          outcome: 'aborted',
          terminal_error_m: null,
          legs: [],
          arrival: { x_m: null, y_m: null, heading_rad: null },
        });
      }),
    );
    assert.deepEqual(faults, []);
    assert.match(await page.textContent('.badge'), /aborted/);
    await page.context().close();
  });
});

describe('the report of a comparison', () => {
  test('loads without a complaint and draws every plot', async () => {
    const { page, faults } = await open(comparison);
    assert.deepEqual(faults, []);
    const charts = await drawn(page);
    assert.deepEqual(
      charts.map((chart) => chart.id),
      ['boxes', 'distribution', 'map', 'end', 'deviation', 'windows', 'differences'],
    );
    for (const chart of charts)
      assert.ok(chart.shapes > (chart.id === 'differences' ? 4 : 10) && chart.texts > 2, JSON.stringify(chart));
    await page.context().close();
  });

  test('the table has the numbers of comparison.json', async () => {
    const { page } = await open(comparison);
    const { controllers } = JSON.parse(readFileSync(join(folder, 'comparison/comparison.json')));
    const rows = await page.$$eval('section:first-of-type tbody tr', (all) =>
      all.map((row) => [...row.cells].map((cell) => cell.innerText.split('\n')[0])),
    );
    assert.equal(rows.length, controllers.length);
    controllers.forEach((row, k) => {
      assert.equal(rows[k][1], `${row.arrived} of ${row.runs}`);
      assert.equal(rows[k][2], `${(row.rmse_m * 100).toFixed(row.rmse_m < 0.0995 ? 1 : 0)} cm`);
    });
    await page.context().close();
  });

  test('a row can be hidden in all plots, a figure and a flight chosen', async () => {
    const { page, faults } = await open(comparison);
    const inColourOf = async (button, id) => {
      const colour = await button.locator('.line').evaluate((line) => getComputedStyle(line).borderTopColor);
      return page.$$eval(
        `#${id} svg *`,
        (all, wanted) => all.filter((one) => getComputedStyle(one).stroke === wanted).length,
        colour,
      );
    };
    const pid = page.locator('.chips button').nth(1);
    for (const id of ['boxes', 'distribution', 'deviation']) assert.ok((await inColourOf(pid, id)) > 0, id);
    await pid.click();
    for (const id of ['boxes', 'distribution', 'deviation']) assert.equal(await inColourOf(pid, id), 0, id);
    assert.equal(await page.locator('.chips button[aria-pressed=false]').count(), 3);
    await page.selectOption('section:has(#boxes) select', 'max_m');
    assert.match(await page.textContent('#boxes'), /largest error/);
    await page.selectOption('section:has(#map) select', 'a13');
    await page.selectOption('section:has(#deviation) .choices:has(+ .plot #deviation) select', '20');
    assert.match(await page.textContent('#deviation'), /-20/);
    assert.ok((await drawn(page)).find((chart) => chart.id === 'windows').shapes > 10);
    await page.locator('.chips button[aria-pressed=true]').first().click();
    assert.deepEqual(faults, [], 'with every row hidden, too');
    await page.context().close();
  });

  test('shows the rows of one floor at a time', async () => {
    const { page, faults } = await open(comparison);
    const widest_px = () =>
      page.$$eval('#map svg [stroke-width]', (all) =>
        Math.max(...all.map((one) => Number(one.getAttribute('stroke-width')))),
      );
    const wide = await widest_px();
    await page.selectOption('.choices.group select', { index: 1 });
    assert.ok((await widest_px()) < wide / 3, 'tape is narrower than paint');
    assert.equal(await page.locator('.chips').first().locator('button').count(), 2);
    assert.match(await page.textContent('#differences'), /pid − ibvs/);
    assert.deepEqual(faults, []);
    await page.context().close();
  });

  test('fits a phone', async () => {
    const { page } = await open(comparison, { width: 390, height: 844 });
    assert.equal(await overflows(page), false);
    await page.context().close();
  });
});
