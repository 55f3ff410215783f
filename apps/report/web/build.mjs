// build.mjs SOURCE: makes page.html in this folder, beside node_modules, from the page, style and script in SOURCE.
import { build } from 'esbuild';
import { readFile, writeFile, rename } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const source = process.argv[2],
  target = fileURLToPath(new URL('.', import.meta.url));
const bundled = await build({
  entryPoints: [join(source, 'src/main.js')],
  nodePaths: [join(target, 'node_modules')],
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2020',
  charset: 'utf8',
  legalComments: 'eof',
  write: false,
});

// What is handed on with every report.
const licences = ['echarts/LICENSE', 'echarts/NOTICE', 'zrender/LICENSE', 'tslib/LICENSE.txt'];
const texts = licences.map(async (name) => `${name}\n\n${await readFile(join(target, 'node_modules', name), 'utf8')}`);

const parts = {
  '@STYLE@': await readFile(join(source, 'style.css'), 'utf8'),
  '@SCRIPT@': bundled.outputFiles[0].text,
  '@LICENCES@': (await Promise.all(texts)).join('\n\n'),
};
let page = await readFile(join(source, 'page.html'), 'utf8');
for (const [place, text] of Object.entries(parts)) page = page.replace(place, () => text);
await writeFile(join(target, 'page.html.part'), page);
await rename(join(target, 'page.html.part'), join(target, 'page.html'));
