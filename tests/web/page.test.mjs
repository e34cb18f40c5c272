// The page in real browsers, from au-transmitter --web. tests/web/run starts it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';

import { differing, facePlayer, launch, openTab, root, serve, untilState } from './support.mjs';

const DOWNLOAD_MAX = 1_100_000;
const streams = path.join(root, 'data/streams');
const expressions = path.join(streams, 'six_expressions.txt');
const talk = path.join(streams, 'talk.txt');
const folder = mkdtempSync(path.join(tmpdir(), 'aucast-web-'));
after(() => rmSync(folder, { recursive: true }));

/// The sets of a stream file without times, as they stand there.
function setsOf(file) {
  return readFileSync(file, 'utf8').split('\n')
      .filter(line => line && !line.startsWith('#') && !/^(Beg|End)_Stream/.test(line));
}

function nativePicture(aus, ...options) {
  const file = path.join(folder, 'native.png');
  facePlayer('pose', aus, '--size', '800x600', '--png', file, ...options);
  return readFileSync(file);
}

for (const name of ['chromium', 'firefox']) {
  describe(name, { timeout: 600_000 }, () => {
    let browser;
    let server;
    before(async () => {
      server = await serve([expressions, talk]);
      browser = await launch(name);
    });
    after(async () => {
      await browser?.close();
      await server?.kill();
    });

    test('what show() draws is the picture of face-player', async () => {
      const tab = await openTab(browser, server.at('http', '?show=6,12'));
      assert.equal(await differing(tab, nativePicture('6,12'), 800, 600), 0);
      assert.deepEqual(tab.faults, []);
      await tab.close();
    });

    test('plays the keyframes of a stream in their order', async () => {
      const tab = await openTab(browser, server.at('http', '?stream=six_expressions'),
                                { width: 160, height: 120 });
      await untilState(tab, 'ended');
      assert.deepEqual(await tab.evaluate(() => window.keyframes), setsOf(expressions));
      assert.deepEqual(tab.faults, []);
      await tab.close();
    });
  });
}

describe('page', { timeout: 900_000 }, () => {
  let browser;
  let server;
  const small = { width: 160, height: 120 };
  before(async () => {
    server = await serve([expressions, talk]);
    browser = await launch('chromium');
  });
  after(async () => {
    await browser?.close();
    await server?.kill();
  });

  for (const layers of ['textured,transparent', 'polygons', 'muscles', 'textured,jaw-tags']) {
    test(`the layers ${layers} are drawn as face-player draws them`, async () => {
      const tab = await openTab(browser, server.at('http', `?show=1,26&layers=${layers}`));
      assert.ok(await differing(tab, nativePicture('1,26', '--show', layers), 800, 600) < 0.001);
      assert.deepEqual(tab.faults, []);
      await tab.close();
    });
  }

  test('a first visit downloads little', async () => {
    const stranger = await browser.createBrowserContext();  // who has kept nothing
    const tab = await openTab(stranger, server.at('http', '?show=0'), small);
    const bytes = await tab.evaluate(() =>
        performance.getEntriesByType('resource').concat(performance.getEntriesByType('navigation'))
            .reduce((sum, entry) => sum + entry.transferSize, 0));
    assert.ok(bytes > 100_000 && bytes < DOWNLOAD_MAX, `${bytes} bytes`);
    await stranger.close();
  });

  test('a set that is none is refused with the reason, and the face stays', async () => {
    const tab = await openTab(browser, server.at('http', '?show=6,12'), small);
    const why = await tab.evaluate(() =>
        document.querySelector('aucast-player').show('6,smile').catch(error => error.message));
    assert.match(why, /smile/);
    assert.equal(await tab.evaluate(() => document.querySelector('aucast-player').aus), '6,12');
    await tab.close();
  });

  test('a server that is killed is found again', async () => {
    const first = await serve([talk]);
    const tab = await openTab(browser, first.at('http'), small);
    await untilState(tab, 'playing');
    await first.kill('SIGKILL');
    await untilState(tab, 'connecting');
    const before = await tab.evaluate(() => window.keyframes.length);
    const again = await serve([talk], { ports: first.ports });
    await untilState(tab, 'playing');
    await tab.waitForFunction(count => window.keyframes.length > count, {}, before);
    await again.kill();
    await tab.close();
  });

  test('says why it cannot play', async () => {
    const gone = await serve([talk]);
    await gone.kill();
    const tab = await openTab(browser, server.at('http', `?server=${gone.at('ws')}`), small);
    await tab.waitForFunction(() => /cannot reach localhost:\d+/.test(
        document.querySelector('aucast-player').shadowRoot.querySelector('[role=status]')
            .textContent));
    await tab.close();
  });

  test('plays over TLS with a token, which leaves the address', async () => {
    const [cert, key, token] = ['cert.pem', 'key.pem', 'token'].map(n => path.join(folder, n));
    execFileSync('openssl', ['req', '-x509', '-newkey', 'ec', '-pkeyopt', 'ec_paramgen_curve:P-256',
                             '-nodes', '-days', '2', '-subj', '/CN=localhost', '-addext',
                             'subjectAltName=DNS:localhost', '-keyout', key, '-out', cert],
                 { stdio: 'pipe' });
    execFileSync('sh', ['-c', `umask 077; echo a-token-of-some-length > "${token}"`]);
    const safe = await serve([expressions], {
      options: ['--web-cert', cert, '--web-key', key, '--token-file', token],
    });
    const tab = await openTab(browser, safe.at('https', '#token=a-token-of-some-length'), small);
    await untilState(tab, 'ended');
    assert.equal(await tab.evaluate(() => location.href), safe.at('https'));
    const stranger = await openTab(browser, safe.at('https'), small);
    await untilState(stranger, 'lost');
    await Promise.all([tab.close(), stranger.close()]);
    await safe.kill();
  });

  test('a hidden page listens on and draws nothing', async () => {
    const tab = await openTab(browser, server.at('http', '?stream=talk'), small);
    await untilState(tab, 'playing');
    await tab.evaluate(() => {
      const { engine } = document.querySelector('aucast-player');
      window.drawn = 0;
      const draw = engine.draw.bind(engine);
      engine.draw = (...size) => { ++window.drawn; draw(...size); };
      Object.defineProperty(document, 'hidden', { configurable: true, get: () => true });
      document.dispatchEvent(new Event('visibilitychange'));
      window.before = window.keyframes.length;
    });
    await tab.waitForFunction(() => window.keyframes.length > window.before + 2, { polling: 100 });
    assert.equal(await tab.evaluate(() => window.drawn), 0);
    await tab.evaluate(() => {
      delete document.hidden;
      document.dispatchEvent(new Event('visibilitychange'));
    });
    await tab.waitForFunction(() => window.drawn > 0, { polling: 100 });
    await tab.close();
  });

  test('two faces in a page are two', async () => {
    const tab = await openTab(browser, server.at('http', 'example.html'), { width: 600, height: 900 });
    const [first, second] = await tab.evaluate(async () => {
      const other = document.createElement('aucast-player');
      other.setAttribute('show', '1,2');
      document.querySelector('main').append(other);
      await other.ready;
      document.querySelector('[data-aus="6,12"]').click();
      await document.getElementById('face').show('6,12');
      return [document.getElementById('face').aus, other.aus];
    });
    assert.deepEqual([first, second], ['6,12', '1,2']);
    assert.deepEqual(tab.faults, []);
    await tab.close();
  });

  test('axe finds nothing serious, in the dark and in the light', async () => {
    const axe = readFileSync(new URL(import.meta.resolve('axe-core')), 'utf8');
    for (const scheme of ['dark', 'light']) {
      const tab = await openTab(browser, server.at('http', '?stream=talk'),
                                { width: 360, height: 640, hasTouch: true, isMobile: true });
      await tab.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }]);
      await untilState(tab, 'playing');
      await tab.evaluate(axe);
      const found = await tab.evaluate(async () => (await window.axe.run()).violations
          .filter(v => ['serious', 'critical'].includes(v.impact))
          .map(v => `${v.id}: ${v.nodes.map(n => n.html).join(' ')}`));
      assert.deepEqual(found, []);
      await tab.close();
    }
  });
});
