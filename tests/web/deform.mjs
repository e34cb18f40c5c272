// What a frame costs the page in Chromium beside face-player's own, as ratios: the same program
// (bench_deformer --frames) native and as WebAssembly, in turns. The best of the rounds counts.
//   scripts/build.sh release bench_deformer; scripts/build.sh web bench_deformer
//   tests/web/run --deform
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import path from 'node:path';

import { bin, launch, root, serveFiles } from './support.mjs';

const ROUNDS = 5;
const FACE = 'faces/default';

/// Microseconds by what moves.
function timesIn(lines) {
  return new Map(lines.map(line => /^ *(\S.*?) +([\d.]+) us$/.exec(line)).filter(Boolean)
      .map(([, title, time]) => [title, Number(time)]));
}

const native = () => timesIn(execFileSync(path.join(bin, 'bench_deformer'), ['--frames'],
                                          { encoding: 'utf8' }).split('\n'));

const inBrowser = async tab => timesIn(await tab.evaluate(async (face, names) => {
  const { default: create } = await import('/build/web/bin/bench_deformer.js');
  const lines = [];
  const program = await create({ print: line => lines.push(line), printErr: line => lines.push(line) });
  for (const name of names) {
    const at = `/data/${name}`;
    program.FS.mkdirTree(at.slice(0, at.lastIndexOf('/')));
    program.FS.writeFile(at, new Uint8Array(await (await fetch(at)).arrayBuffer()));
  }
  const code = program.callMain(['--frames', `/data/${face}`, '/data']);
  if (code !== 0) throw new Error(`bench_deformer ended with ${code}: ${lines.join('\n')}`);
  return lines;
}, FACE, JSON.parse(readFileSync(path.join(root, 'build/web/page/data/parts.json'))).faces.default));

const server = await serveFiles(root);
const browser = await launch('chromium');
const best = { native: new Map(), browser: new Map() };
const keepBest = (kept, times) => {
  for (const [title, time] of times) kept.set(title, Math.min(time, kept.get(title) ?? Infinity));
};
for (let round = 0; round < ROUNDS; ++round) {
  keepBest(best.native, native());
  const tab = await browser.newPage();
  await tab.goto(server.at('client/web/page/page.css'));
  keepBest(best.browser, await inBrowser(tab));
  await tab.close();
}
await browser.close();
server.close();
console.log(`${'a frame of'.padEnd(30)}  native us  Chromium us  ratio`);
for (const [title, time] of best.native) {
  const there = best.browser.get(title);
  console.log(`${title.padEnd(30)} ${time.toFixed(2).padStart(10)} ${there.toFixed(2).padStart(12)} ` +
              (there / time).toFixed(2).padStart(6));
}
