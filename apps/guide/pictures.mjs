// node apps/guide/pictures.mjs [BUILD]: makes the pictures of README and of these pages anew, with the program in BUILD
// (build/release), headless Chromium and playwright-core, which the tests of the reports use too.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const guide = dirname(fileURLToPath(import.meta.url)),
  pictures = join(guide, '../../data/pictures'),
  build = resolve(process.argv[2] ?? join(guide, '../../build/release')),
  work = mkdtempSync(join(tmpdir(), 'lineservo-pictures-'));
const { chromium } = createRequire(join(build, 'report/'))('playwright-core');
const names = ['chromium-headless-shell', 'chromium', 'google-chrome'];
const executablePath = names.map((name) => spawnSync('which', [name], { encoding: 'utf8' }).stdout.trim()).find(Boolean);

function lineservo(...words) {
  const { status, stderr } = spawnSync(join(build, 'apps/lineservo'), words, { encoding: 'utf8' });
  if (status !== 0 && status !== 1) throw new Error(stderr);
}

const browser = await chromium.launch({ executablePath, args: ['--no-sandbox'] });
const open = (width, height) => browser.newPage({ viewport: { width, height } });

/** The report that a command writes with --out. */
async function reportOf(name, words, { width = 1180, height = 900 } = {}) {
  lineservo(...words, '--out', join(work, name));
  const page = await open(width, height);
  await page.goto(`file://${join(work, name, 'report.html')}`);
  await page.waitForSelector('html[data-ready=true]');
  return page;
}

/** The whole of these elements, and a little margin. */
async function boxAbout(page, selectors) {
  const boxes = await Promise.all(selectors.map((one) => page.locator(one).boundingBox()));
  const x = Math.min(...boxes.map((box) => box.x)),
    y = Math.min(...boxes.map((box) => box.y));
  return {
    x: x - 12,
    y: y - 4,
    width: Math.max(...boxes.map((box) => box.x + box.width)) - x + 24,
    height: Math.max(...boxes.map((box) => box.y + box.height)) - y + 8,
  };
}

async function flight() {
  const page = await reportOf('flight', ['fly', 'a13'], { height: 1190 });
  await page.$eval('#time', (slider) => {
    slider.value = 700;
    slider.dispatchEvent(new Event('input'));
  });
  await page.waitForTimeout(200);
  await page.screenshot({ path: join(pictures, 'report.jpg'), quality: 80 });
}

async function comparison() {
  const page = await reportOf('laws', ['compare', '--controllers', 'ibvs,pid,lfpf', '--instructions', 'a03,a13', '--runs', '5']);
  const clip = await boxAbout(page, ['section:has(#boxes)', 'section:has(#distribution)']);
  await page.screenshot({ path: join(pictures, 'comparison.png'), clip, fullPage: true });
}

async function layout() {
  const page = await reportOf('loft', ['fly', 'a11', '--layout', join(guide, 'loft.yaml')], { width: 900 });
  await page.$eval('.scrubber', (bar) => bar.remove());
  await page.locator('.pair').screenshot({ path: join(pictures, 'layout.png') });
}

/** Moments of flights, in seconds, with what was seen in them: pictures out of the videos, read back without loss. */
const moments = [
  ['warehouse, a T to the left', 42, ['a13']],
  ['50 mm tape', 42.1, ['a13', '--layout', 'tape-warehouse']],
  ['a corner of 45°', 23, ['c03']],
  ['harsh: worn and dirty paint, uneven light', 12, ['a13', '--conditions', 'harsh']],
];

async function frames() {
  const figures = moments.map(([caption, time_s, words], k) => {
    const out = join(work, `video-${k}`),
      kept = join(work, `frames-${k}`);
    lineservo('fly', ...words, '--set', `time_limit_s=${time_s + 1}`, '--video', '--out', out);
    lineservo('watch', join(out, 'flight.mp4'), '--set', 'camera.width_px=854', '--record', kept);
    const rate_hz = Number(/frame_rate_hz: ([\d.]+)/.exec(readFileSync(join(out, 'config.yaml'), 'utf8'))[1]);
    const number = String(Math.round(time_s * rate_hz)).padStart(6, '0');
    const png = readFileSync(join(kept, 'frames', `${number}.png`), 'base64');
    return `<figure><img src="data:image/png;base64,${png}"><figcaption>${caption}</figcaption></figure>`;
  });
  const page = await open(1180, 710);
  await page.setContent(`<style>
    body { margin: 0; display: grid; grid-template-columns: 1fr 1fr; gap: 6px 8px; font: 15px system-ui, sans-serif; }
    figure { margin: 0 } img { width: 100%; display: block } figcaption { padding: 2px 4px }</style>${figures.join('')}`);
  await page.locator('body').screenshot({ path: join(pictures, 'frames.jpg'), quality: 80 });
}

try {
  for (const make of [flight, comparison, layout, frames]) await make();
} finally {
  await browser.close();
  rmSync(work, { recursive: true });
}
