// A face in an experiment: the pages in experiments/, with jsPsych and lab.js as npm has them, from a
// file server that knows nothing of AUcast. tests/web/run starts it.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, symlinkSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, afterEach, before, describe, test } from 'node:test';

import { differing, facePlayer, launch, openPage, root, serve, serveFiles, setsOf,
         usable } from './support.mjs';

const here = import.meta.dirname;
const expressions = path.join(root, 'data/streams/six_expressions.txt');
const folder = mkdtempSync(path.join(tmpdir(), 'aucast-experiments-'));
before(makeSite);
after(() => rmSync(folder, { recursive: true }));

/// The experiments with all that they load.
function makeSite() {
  const parts = {
    aucast: path.join(root, 'build/web/page'),
    jspsych: path.join(here, 'node_modules/jspsych'),
    'plugin-html-keyboard-response': path.join(here, 'node_modules/@jspsych/plugin-html-keyboard-response'),
    'lab.js': path.join(here, 'node_modules/lab.js'),
  };
  for (const [name, from] of Object.entries(parts)) symlinkSync(from, path.join(folder, name));
  for (const name of ['jspsych.html', 'jspsych.js', 'lab.html', 'lab_study.js', 'experiment.css']) {
    symlinkSync(path.join(here, 'experiments', name), path.join(folder, name));
  }
}

function nativePicture(aus) {
  const file = path.join(folder, 'native.png');
  facePlayer('pose', aus, '--size', '640x480', '--png', file);
  return readFileSync(file);
}

const TRIALS = [['12', 'n'], ['6,12:80', 'j'], ['0', 'n']];

/// Answers the trials as somebody does who sees the face and reads the question.
async function answer(tab) {
  for (const [aus, key] of TRIALS) {
    await tab.waitForFunction(wanted => document.querySelector('aucast-player')?.aus === wanted &&
                                        document.querySelector('kbd'), { polling: 50 }, aus);
    assert.equal(await differing(tab, nativePicture(aus), 640, 480), 0);
    await tab.keyboard.press(key);
  }
  await tab.waitForFunction(() => window.results, { polling: 50 });
  return tab.evaluate(() => window.results);
}

for (const name of ['chromium', 'firefox']) {
  describe(`an experiment in ${name}`, { timeout: 300_000 }, () => {
    let browser;
    let files;
    let server;
    before(async () => {
      files = await serveFiles(folder);
      server = await serve([expressions]);
      browser = await launch(name);
    });
    afterEach(async () => {
      browser = await usable(browser, name);
    });
    after(async () => {
      await browser?.close();
      await server?.kill();
      files?.close();
    });

    test('jsPsych shows sets and a stream, and knows when each of them was on', async () => {
      const tab = await openPage(browser, files.at(`jspsych.html?server=${server.at('ws')}`));
      const results = await answer(tab);
      const answers = results.filter(({ aus }) => aus !== undefined);
      assert.deepEqual(answers.map(({ aus, response }) => [aus, response]), TRIALS);
      for (const { onset, rt } of answers) assert.ok(onset > 0 && rt > 0, `${onset}, ${rt}`);
      const { onsets } = results.at(-1);
      assert.deepEqual(onsets.map(({ aus }) => aus), setsOf(expressions));
      assert.ok(onsets.every(({ onset }, i) => i === 0 || onset > onsets[i - 1].onset));
      assert.deepEqual(tab.faults, []);
      await tab.close();
    });

    test('lab.js waits for the face before it takes the time', async () => {
      const tab = await openPage(browser, files.at('lab.html'));
      const answers = (await answer(tab)).filter(({ aus }) => aus !== undefined);
      assert.deepEqual(answers.map(({ aus, response }) => [aus, response]),
                       TRIALS.map(([aus, key]) => [aus, key === 'j' ? 'yes' : 'no']));
      for (const { duration } of answers) assert.ok(duration > 0, String(duration));
      assert.deepEqual(tab.faults, []);
      await tab.close();
    });

    // More than 16 faces at once a browser does not draw: those of earlier trials must be let go.
    test('a face made anew for each of many trials is as good', { skip: name === 'firefox' }, async () => {
      const tab = await openPage(browser, files.at('lab.html'));
      const shown = await tab.evaluate(async () => {
        const seen = [];
        for (let trial = 0; trial < 20; ++trial) {
          document.body.innerHTML = '<aucast-player show="6,12"></aucast-player>';
          const face = document.querySelector('aucast-player');
          await face.ready;
          await face.show('12');
          seen.push(face.aus);
        }
        return seen;
      });
      assert.deepEqual(shown, new Array(20).fill('12'));
      assert.equal(await differing(tab, nativePicture('12'), 640, 480), 0);
      assert.deepEqual(tab.faults, []);
      await tab.close();
    });
  });
}
