// The page in real browsers, from au-transmitter --web. tests/web/run starts it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { once } from 'node:events';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { get } from 'node:http';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, afterEach, before, describe, test } from 'node:test';

import { afterFirstPicture, auTransmitter, differing, facePlayer, launch, openPage, openTab, root, serve,
         serveFiles, setsOf, touch, untilState, usable } from './support.mjs';

const DOWNLOAD_MAX = 1_100_000;
const MESH_MAX = 450_000;
const streams = path.join(root, 'data/streams');
const expressions = path.join(streams, 'six_expressions.txt');
const talk = path.join(streams, 'talk.txt');
const lecture = path.join(streams, 'lecture.txt');
const folder = mkdtempSync(path.join(tmpdir(), 'aucast-web-'));
after(() => rmSync(folder, { recursive: true }));

/// The texts of a WebVTT file, as they stand there.
function cuesOf(file) {
  return readFileSync(file, 'utf8').split('\n\n').slice(1)
      .map(cue => cue.trim().split('\n').slice(1).join('\n'));
}

function nativePicture(aus, ...options) {
  const file = path.join(folder, 'native.png');
  facePlayer('pose', aus, '--size', '800x600', '--png', file, ...options);
  return readFileSync(file);
}

/// The bytes that a server sends of something, as a browser takes it.
async function sentOf(address) {
  const [reply] = await once(get(address, { headers: { 'Accept-Encoding': 'gzip' } }), 'response');
  assert.equal(reply.statusCode, 200, address);
  assert.equal(reply.headers['content-encoding'], 'gzip', address);
  let bytes = 0;
  for await (const part of reply) bytes += part.length;
  return bytes;
}

test('the mesh of each face is small as the page loads it', async t => {
  const server = await serve([expressions]);
  try {
    const { faces } = await (await fetch(server.at('http', 'data/parts.json'))).json();
    assert.ok(Object.keys(faces).length >= 2);
    for (const [face, files] of Object.entries(faces)) {
      const mesh = files.find(file => file.endsWith('.ply'));
      const bytes = await sentOf(server.at('http', `data/${mesh}.packed`));
      t.diagnostic(`${face}: ${bytes} bytes`);
      assert.ok(bytes > MESH_MAX / 10 && bytes <= MESH_MAX, `${face}: ${bytes} bytes`);
    }
  } finally {
    await server.kill();
  }
});

for (const name of ['chromium', 'firefox']) {
  describe(name, { timeout: 600_000 }, () => {
    let browser;
    let server;
    before(async () => {
      server = await serve([expressions, talk, lecture]);
      browser = await launch(name);
    });
    afterEach(async () => {
      browser = await usable(browser, name);
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

    test('the voice of a lecture is heard to its end, and tells the face the time', async t => {
      const [, sent] = /voice .* in (\d+) packets/.exec(auTransmitter('--check', lecture));
      const tab = await openTab(browser, server.at('http', '?stream=lecture'),
                                { width: 160, height: 120 });
      await touch(tab);
      await tab.waitForFunction(() => document.querySelector('aucast-player').engine.sounds);
      const heard = await tab.evaluate(async () => {
        const player = document.querySelector('aucast-player');
        window.captions = [];
        player.addEventListener('caption', event => window.captions.push(event.detail.text));
        const { voice } = player.engine.core;
        const decode = voice.decode.bind(voice);
        const counts = { decoded: 0, failed: 0, moments: 0 };
        voice.decode = (id, packet) => {
          const sound = decode(id, packet);
          if (packet.length > 0) sound.length > 0 ? ++counts.decoded : ++counts.failed;
          return sound;
        };
        let before = 0;
        setInterval(() => {
          if (!player.engine.sounds) return;
          const now = player.engine.browser.sound.heardSeconds();
          if (now > before) ++counts.moments;
          before = now;
        }, 50);
        const earlier = player.engine.soundCounts.packets;
        await player.play();
        window.captions = [];
        await new Promise(resolve => player.addEventListener('state', event => {
          if (event.detail.state === 'ended') resolve();
        }));
        const sound = player.engine.soundCounts;
        return { ...counts, ...sound, packets: sound.packets - earlier, captions: window.captions };
      });
      t.diagnostic(`face before sound: ${heard.shiftMs} ms (5 %: ${heard.shiftLowMs}, 95 %: ` +
                   `${heard.shiftHighMs}) over ${heard.faces} pictures, ` +
                   `${heard.underruns} underruns`);
      assert.equal(heard.packets, Number(sent));
      assert.deepEqual([heard.decoded, heard.failed], [Number(sent), 0]);
      assert.ok(heard.moments > 100 && heard.faces > 20, JSON.stringify(heard));
      assert.deepEqual(heard.captions.filter(Boolean), cuesOf(lecture.replace('.txt', '.vtt')));
      assert.deepEqual(tab.faults, []);
      await tab.close();
    });
  });
}

for (const name of ['chromium', 'firefox']) {
  describe(`the page in ${name}`, { timeout: 900_000 }, () => {
    let browser;
    let server;
    const small = { width: 160, height: 120 };
    before(async () => {
      server = await serve([expressions, talk, lecture]);
      browser = await launch(name);
    });
    afterEach(async () => {
      browser = await usable(browser, name);
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

    test('a decoder that did not come is asked for again', async () => {
      const site = mkdtempSync(path.join(folder, 'decoder-'));
      symlinkSync(path.join(root, 'client/web/page/voice_decoders.js'), path.join(site, 'voice.js'));
      writeFileSync(path.join(site, 'page.html'), '<title>nothing</title>');
      const files = await serveFiles(site);
      try {
        const tab = await browser.newPage();
        await tab.goto(files.at('page.html'));
        const load = () => tab.evaluate(async () => (await import('/voice.js')).loadOpus(true));
        assert.equal(await load(), false);
        writeFileSync(path.join(site, 'opus-decoder.min.js'),
                      "globalThis['opus-decoder'] = { OpusDecoder: class { free() {} } };");
        assert.equal(await load(), true);
        await tab.close();
      } finally {
        files.close();
      }
    });

    test('a first visit downloads little, and gets all of it', async t => {
      const stranger = await browser.createBrowserContext();  // who has kept nothing
      const tab = await openTab(stranger, server.at('http', '?stream=lecture'), small);
      const bytes = await tab.evaluate(() =>
          performance.getEntriesByType('resource').concat(performance.getEntriesByType('navigation'))
              .reduce((sum, entry) => sum + entry.transferSize, 0));
      t.diagnostic(`${bytes} bytes`);
      assert.ok(bytes > 100_000 && bytes < DOWNLOAD_MAX, `${bytes} bytes`);
      const sum = await tab.evaluate(async () => {
        const { FS } = document.querySelector('aucast-player').engine.core;
        const mesh = FS.readFile('/data/faces/default/mesh.ply');
        const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', mesh));
        return [...digest].map(byte => byte.toString(16).padStart(2, '0')).join('');
      });
      const mesh = readFileSync(path.join(root, 'data/faces/default/mesh.ply'));
      assert.equal(sum, createHash('sha256').update(mesh).digest('hex'));
      await stranger.close();
    });

    test('while the face is made, the page does its other work', async () => {
      // Turns between the first picture, which needs little of the face, and the face that can move.
      const prepare = tab => afterFirstPicture(tab, () => {
        window.turns = 0;
        const turn = () => {
          ++window.turns;
          setTimeout(turn);
        };
        setTimeout(turn);
      });
      const tab = await openPage(browser, server.at('http', '?show=0'), { ...small, prepare });
      const turns = await tab.evaluate(
          () => document.querySelector('aucast-player').ready.then(() => window.turns));
      assert.ok(turns >= 5, `${turns} turns`);
      await tab.close();
    });

    test('a voice waits for a touch, and is muted and loud as one likes', async () => {
      const tab = await openTab(browser, server.at('http', '?stream=lecture'),
                                { ...small, untouched: true });
      await tab.waitForFunction(() => document.querySelector('aucast-player').needsTap);
      await tab.waitForFunction(() => window.keyframes.length > 20);  // it plays all the same
      const before = await tab.evaluate(() => {
        const player = document.querySelector('aucast-player');
        window.told = [];
        player.addEventListener('sound', event => window.told.push(event.detail));
        return player.engine.sounds;
      });
      assert.equal(before, false);
      const tap = await tab.waitForSelector('aucast-player >>> .tap:not([hidden])');
      await tap.click();
      await tab.waitForFunction(() => document.querySelector('aucast-player').engine.sounds);
      await tab.evaluate(() => {
        const { sound } = document.querySelector('aucast-player').engine.browser;
        const ear = sound.context.createAnalyser();
        sound.fade.connect(ear);
        const samples = new Float32Array(ear.fftSize);
        window.loudness = () => {
          ear.getFloatTimeDomainData(samples);
          return Math.max(...samples.map(Math.abs));
        };
      });
      await tab.waitForFunction(() => window.loudness() > 0.02, { polling: 20 });
      await tab.focus('aucast-player >>> canvas');
      await tab.keyboard.press('m');
      await tab.waitForFunction(() => window.loudness() === 0, { polling: 20 });
      for (const key of ['9', '9', '0']) await tab.keyboard.press(key);  // who turns it wants to hear it
      await tab.waitForFunction(() => window.loudness() > 0.02, { polling: 20 });
      await tab.evaluate(() => { document.querySelector('aucast-player').pause(); });
      await tab.waitForFunction(() => window.loudness() === 0, { polling: 20 });
      await tab.evaluate(() => { document.querySelector('aucast-player').resume(); });
      await tab.waitForFunction(() => window.loudness() > 0.02, { polling: 20 });
      const told = await tab.evaluate(() => window.told.map(
          ({ needsTap, muted, volume }) => [needsTap, muted, Math.round(100 * volume)]));
      assert.deepEqual(told, [[false, false, 100], [false, true, 100], [false, false, 98],
                              [false, false, 96], [false, false, 98]]);
      assert.deepEqual(tab.faults, []);
      await tab.close();
    });

    test('a face that could not be loaded is loaded when it is asked for again', async () => {
      let refused = 3;
      const prepare = async tab => {
        await tab.setRequestInterception(true);
        tab.on('request', request => {
          if (!request.url().endsWith('/data/parts.json') || refused-- <= 0) request.continue();
          else request.respond({ status: 503 });
        });
      };
      const tab = await openPage(browser, server.at('http', '?show=6,12'), { ...small, prepare });
      const outcomes = await tab.evaluate(async () => {
        const player = document.querySelector('aucast-player');
        const of = promise => promise.then(() => player.aus, error => error.message);
        const first = await of(player.ready);
        const called = await of(player.show('4'));
        player.setAttribute('show', '12');
        await Promise.resolve();
        const changed = await of(player.ready);
        return [first, called, changed, await of(player.show('26'))];
      });
      const refusal = 'data/parts.json is not there (503)';
      assert.deepEqual(outcomes, [refusal, refusal, refusal, '26']);
      await tab.close();
    });

    for (const how of ['was not built in', 'does not come', 'is broken']) {
      test(`a stream plays without its voice where the decoder ${how}`, async () => {
        let own = server;
        if (how === 'was not built in') {
          const data = path.join(folder, `without-${name}`);
          execFileSync('python3', [path.join(root, 'scripts/web_page.py'), path.join(root, 'build/web/bin'),
                                   path.join(data, 'no-decoder'), path.join(data, 'web')]);
          own = await serve([lecture], { data });
        }
        const answers = { 'does not come': { status: 404 }, 'is broken': { body: 'no script at all' } };
        const prepare = async tab => {
          await tab.setRequestInterception(true);
          tab.on('request', request => {
            const wanted = /\/opus-decoder\.min\.js(\?|$)/.test(request.url()) && answers[how];
            if (!wanted) request.continue();
            else request.respond({ contentType: 'text/javascript', ...wanted });
          });
        };
        const tab = await openTab(browser, own.at('http', '?stream=lecture'),
                                  { ...small, untouched: true, prepare });
        await tab.waitForSelector('aucast-player >>> .caption:not([hidden])');
        await tab.waitForFunction(() => window.keyframes.length > 20);
        const seen = await tab.evaluate(() => {
          const player = document.querySelector('aucast-player');
          const hidden = what => player.shadowRoot.querySelector(what).hidden;
          return { voice: player.about.voice, needsTap: player.needsTap, tap: hidden('.tap'),
                   volume: hidden('[type=range]'), state: player.state };
        });
        assert.deepEqual(seen, { voice: false, needsTap: false, tap: true, volume: true, state: 'playing' });
        assert.deepEqual(tab.faults.filter(fault => !/status of 404/.test(fault)), []);
        await tab.close();
        if (own !== server) await own.kill();
      });
    }

    test('captions and who is speaking', async () => {
      const tab = await openTab(browser, server.at('http', '?stream=lecture'),
                                { ...small, untouched: true });
      const line = await tab.waitForSelector('aucast-player >>> .caption:not([hidden])');
      const cues = cuesOf(lecture.replace('.txt', '.vtt'));
      assert.ok(cues.includes(await line.evaluate(p => p.textContent)));
      assert.equal(await line.evaluate(p => p.getAttribute('aria-live')), 'polite');
      assert.equal(await tab.title(), 'A face over a thin wire - AUcast');
      await tab.evaluate(() => {
        const { shadowRoot } = document.querySelector('aucast-player');
        [...shadowRoot.querySelectorAll('button')].find(b => b.textContent === 'Captions').click();
      });
      await tab.waitForFunction(() => document.querySelector('aucast-player').shadowRoot
          .querySelector('.caption').hidden);
      assert.ok(await tab.evaluate(() => document.querySelector('aucast-player').caption));
      await tab.close();
    });

    test('a set that is none is refused with the reason, and the face stays', async () => {
      const tab = await openTab(browser, server.at('http', '?show=6,12'), small);
      const why = await tab.evaluate(() =>
          document.querySelector('aucast-player').show('6,smile').catch(error => error.message));
      assert.match(why, /smile/);
      assert.equal(await tab.evaluate(() => document.querySelector('aucast-player').aus), '6,12');
      await tab.close();
    });

    test('what a page cannot draw is told by the event error', async () => {
      const tab = await openTab(browser, server.at('http', '?show=6,12'), small);
      const [layers, shown] = await tab.evaluate(async () => {
        const player = document.querySelector('aucast-player');
        await player.ready;
        window.error = () => new Promise(resolve => player.addEventListener('error', event =>
          resolve([event.detail.message, player.message.textContent]), { once: true }));
        const told = window.error();
        player.setAttribute('layers', 'textured,bones');
        return told;
      });
      assert.match(layers, /bones/);
      assert.equal(shown, layers);
      const renewed = await tab.evaluate(async () => {
        const player = document.querySelector('aucast-player');
        const told = window.error();
        player.engine.renew = async () => { throw new Error('there is no room for the face'); };
        const driver = player.canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
        const lost = new Promise(resolve => player.canvas.addEventListener('webglcontextlost', resolve));
        driver.loseContext();
        await lost;
        setTimeout(() => driver.restoreContext());
        return told;
      });
      assert.deepEqual(renewed, Array(2).fill('there is no room for the face'));
      assert.deepEqual(tab.faults, []);
      await tab.close();
    });

    test('a server that is killed is found again', async () => {
      const first = await serve([talk]);
      const tab = await openTab(browser, first.at('http'), small);
      await untilState(tab, 'playing');
      await first.kill('SIGKILL');
      await untilState(tab, 'connecting');
      await tab.evaluate(async () => {
        const { canvas } = document.querySelector('aucast-player');
        const driver = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
        const lost = new Promise(resolve => canvas.addEventListener('webglcontextlost', resolve));
        driver.loseContext();
        await lost;
        setTimeout(() => driver.restoreContext());
      });
      const said = await tab.waitForFunction(() => {
        const words = document.querySelector('aucast-player').message.textContent;
        return words.startsWith('The graphics driver') ? null : { words };
      }, { polling: 50 });
      assert.match((await said.jsonValue()).words, /^Connecting/, 'it is still said of the server');
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
      for (const none of ['here', 'ftp://here', 'ws://']) {
        const other = await openTab(browser, server.at('http', `?server=${none}`), small);
        await other.waitForFunction(address => document.querySelector('aucast-player').message
            .textContent.startsWith(`'${address}' is no address of a server`), { polling: 50 }, none);
        await other.close();
      }
    });

    test('the last place of a server is enough', async () => {
      const narrow = await serve([expressions, talk], { options: ['--max-clients', '1'] });
      const tab = await openTab(browser, narrow.at('http'), small);
      await untilState(tab, 'ended');
      await tab.waitForFunction(() => [...document.querySelector('aucast-player').shadowRoot
          .querySelectorAll('option')].map(({ value }) => value).join() === 'six_expressions,talk',
          { polling: 50 });
      assert.deepEqual(tab.faults, []);
      await tab.close();
      await narrow.kill();
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

    test('asks for a token, again after a wrong one, and keeps it to itself', async () => {
      const file = path.join(folder, `token-${name}`);
      execFileSync('sh', ['-c', `umask 077; echo a-token-of-some-length > "${file}"`]);
      const closed = await serve([talk], { options: ['--token-file', file, '--web-host', 'a.localhost'] });
      const axe = readFileSync(new URL(import.meta.resolve('axe-core')), 'utf8');
      const tab = await openTab(browser, closed.at('http'), { width: 360, height: 640 });
      const said = words => tab.waitForFunction(wanted => {
        const { message, shadowRoot } = document.querySelector('aucast-player');
        return message.textContent === wanted && shadowRoot.activeElement?.type === 'password';
      }, { polling: 50 }, words);
      await said('This stream needs a token. Ask the lecturer for it.');
      await tab.evaluate(axe);
      assert.deepEqual(await tab.evaluate(async () => (await window.axe.run()).violations
          .filter(v => ['serious', 'critical'].includes(v.impact)).map(v => v.id)), []);
      await tab.keyboard.press('Escape');
      assert.deepEqual(await tab.evaluate(() => {
        const { shadowRoot } = document.querySelector('aucast-player');
        return [shadowRoot.querySelector('.token').hidden, shadowRoot.activeElement.localName];
      }), [true, 'canvas']);
      await tab.click('aucast-player >>> .bar button');  // Play again
      await said('This stream needs a token. Ask the lecturer for it.');
      await tab.keyboard.type('another-token');
      await tab.keyboard.press('Enter');
      await said('This token is wrong. Ask the lecturer for the right one.');
      await tab.keyboard.type('a-token-of-some-length');
      await tab.keyboard.press('Enter');
      await untilState(tab, 'playing');
      assert.deepEqual(await tab.evaluate(() => {
        const form = document.querySelector('aucast-player').shadowRoot.querySelector('.token');
        return [form.hidden, form.querySelector('input').value, location.href, localStorage.length,
                sessionStorage.length, document.cookie];
      }), [true, '', closed.at('http'), 0, 0, '']);
      assert.deepEqual(tab.faults, []);
      assert.deepEqual(await tab.evaluate(() => {
        const player = document.querySelector('aucast-player');
        const { token } = player;
        player.setAttribute('server', 'ws://localhost:1');
        return [token, player.token];
      }), ['a-token-of-some-length', ''], 'another server is not shown it');
      await tab.close();
      const far = await openTab(browser, closed.at('http').replace('localhost', 'a.localhost'), small);
      await untilState(far, 'lost');
      assert.deepEqual(await far.evaluate(() => {
        const { message, shadowRoot } = document.querySelector('aucast-player');
        return [message.textContent, shadowRoot.querySelector('.token').hidden];
      }), ['This stream needs a token, and a token is sent only over wss:// or to localhost', true]);
      await far.close();
      await closed.kill();
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

    test('a page of somebody else plays from the server that it names', async () => {
      const site = path.join(folder, `site-${name}`);
      mkdirSync(site);
      symlinkSync(path.join(root, 'build/web/page'), path.join(site, 'aucast'));
      writeFileSync(path.join(site, 'course.html'), `<!doctype html><html lang="en"><title>A course</title>
        <link rel="icon" href="aucast/icon.svg">
        <script type="module" src="aucast/aucast-player.js"></script>
        <aucast-player server="${server.at('ws')}" stream="six_expressions"></aucast-player>`);
      const files = await serveFiles(site);
      const ours = `aucast/index.html?stream=six_expressions&server=${server.at('ws')}`;
      for (const page of ['course.html', ours]) {
        const tab = await openTab(browser, files.at(page), small);
        await untilState(tab, 'ended');
        assert.deepEqual(await tab.evaluate(() => window.keyframes), setsOf(expressions));
        assert.deepEqual(tab.faults, []);
        await tab.close();
      }
      files.close();
    });

    test('everything is reached by the keyboard, in the order in which it stands', async () => {
      const tab = await openTab(browser, server.at('http', '?stream=lecture&muted'), { untouched: true });
      await tab.waitForSelector('aucast-player >>> .caption:not([hidden])');
      await tab.waitForSelector('aucast-player >>> select:not([hidden])');  // the server's answer
      await tab.bringToFront();
      const tabbed = async () => {
        await tab.keyboard.press('Tab');
        return tab.evaluate(() => {
          const focused = document.activeElement?.shadowRoot?.activeElement;
          if (!focused) return null;
          const { outlineStyle, outlineWidth } = getComputedStyle(focused);
          return [focused.ariaLabel ?? focused.textContent, `${outlineStyle} ${outlineWidth}`];
        });
      };
      // Browsers drop keys until their window has come to the front and shows its first picture.
      let first = null;
      for (let key = 0; key < 20 && !first; ++key) first = await tabbed();
      const reached = [first];
      while (reached.length < 9) reached.push(await tabbed());
      assert.deepEqual(reached, ['A face', 'Who is speaking', 'Pause', 'Mute', 'Volume', 'Captions', 'AUs',
                                 'Picture', 'Full screen'].map(name => [name, 'solid 3px']));
      for (let key = 0; key < 6; ++key) {
        await tab.keyboard.down('Shift');
        await tab.keyboard.press('Tab');
        await tab.keyboard.up('Shift');
      }
      await tab.keyboard.press('Enter');
      await untilState(tab, 'paused');
      await tab.keyboard.press(' ');
      await untilState(tab, 'playing');
      await tab.close();
    });

    test('a face that is taken out of the page and put back goes on as it was', async () => {
      const tab = await openTab(browser, server.at('http', '?stream=talk'), small);
      await untilState(tab, 'playing');
      await tab.evaluate(() => {
        window.face = document.querySelector('aucast-player');
        window.stage = window.face.parentElement;
        window.face.remove();
      });
      await tab.waitForFunction(() => window.face.state === 'idle', { polling: 50 });
      await tab.evaluate(() => {
        window.stage.append(window.face);
        window.face.style.width = '80px';
      });
      await untilState(tab, 'playing');
      await tab.waitForFunction(() => window.face.canvas.width === 80, { polling: 50 });
      await tab.evaluate(() => window.face.show('6,12').then(() => {
        window.face.remove();
        return new Promise(resolve => setTimeout(resolve));
      }));
      await tab.evaluate(() => window.stage.append(window.face));
      assert.deepEqual(await tab.evaluate(() => [window.face.aus, window.face.state]), ['6,12', 'idle']);
      assert.deepEqual(tab.faults, []);
      await tab.close();
    });

    test('what a page asks for while the face loads goes before the attributes', async () => {
      const tab = await openTab(browser, server.at('http', '?show=1'), small);
      await tab.evaluate(address => {
        window.faces = ['play', 'show', 'stop'].map(() => {
          const face = document.createElement('aucast-player');
          face.setAttribute('server', address);
          face.setAttribute('stream', 'talk');
          document.body.append(face);
          return face;
        });
        const [played, shown, stopped] = window.faces;
        played.play('lecture');
        shown.show('12');
        stopped.stop();
      }, server.at('ws'));
      await tab.waitForFunction(() => window.faces[0].speaker === 'A face over a thin wire' &&
                                      window.faces.every(({ state }) => state), { polling: 50 });
      assert.deepEqual(await tab.evaluate(() => window.faces.slice(1).map(face => [face.aus, face.state])),
                       [['12', 'idle'], ['0', 'idle']]);
      assert.deepEqual(tab.faults, []);
      await tab.close();
    });

    test('a stream that has ended begins only when it is asked for again', async () => {
      const tab = await openTab(browser, server.at('http', '?stream=lecture'), small);
      await untilState(tab, 'playing');
      await tab.evaluate(() => {
        window.face = document.querySelector('aucast-player');
        return window.face.play('six_expressions');
      });
      await untilState(tab, 'ended');
      const states = await tab.evaluate(async () => {
        const { face } = window;
        const stage = face.parentElement;
        face.remove();
        await new Promise(resolve => setTimeout(resolve));
        const away = face.state;
        stage.append(face);
        window.keyframes = [];
        await new Promise(resolve => setTimeout(resolve, 500));  // in which it would have begun
        return [away, face.state];
      });
      assert.deepEqual(states, ['ended', 'ended']);
      await tab.evaluate(() => {
        const { shadowRoot } = window.face;
        [...shadowRoot.querySelectorAll('button')].find(b => b.textContent === 'Play again').click();
      });
      await tab.waitForFunction(() => window.keyframes.length > 2);
      assert.deepEqual(await tab.evaluate(() => window.keyframes.slice(0, 3)), setsOf(expressions).slice(0, 3));
      await tab.evaluate(() => window.face.setAttribute('stream', 'talk'));
      assert.equal(await tab.evaluate(() => window.face.asked), 'talk');
      assert.deepEqual(tab.faults, []);
      await tab.close();
    });

    test('a paused face that is put elsewhere is still paused', async () => {
      const tab = await openTab(browser, server.at('http', '?stream=talk'), small);
      await untilState(tab, 'playing');
      await tab.evaluate(() => {
        window.face = document.querySelector('aucast-player');
        return window.face.play('lecture');
      });
      await untilState(tab, 'playing');
      const states = await tab.evaluate(async () => {
        const { face } = window;
        face.pause();
        face.advance();
        const stage = face.parentElement;
        face.remove();
        await new Promise(resolve => setTimeout(resolve));
        const away = face.state;
        stage.append(face);
        return [away, await new Promise(resolve => face.addEventListener('state', event => {
          resolve(event.detail.state);
        }))];
      });
      assert.deepEqual(states, ['idle', 'paused']);
      await tab.waitForFunction(() => window.face.engine.connected, { polling: 50 });
      assert.equal(await tab.evaluate(() => window.face.state), 'paused');
      await tab.evaluate(() => window.face.resume());
      await untilState(tab, 'playing');
      assert.equal(await tab.evaluate(() => window.face.speaker), 'A face over a thin wire');
      assert.deepEqual(tab.faults, []);
      await tab.close();
    });

    test('a face without its server plays no more', async () => {
      const tab = await openTab(browser, server.at('http', '?stream=talk'), small);
      await untilState(tab, 'playing');
      await tab.evaluate(() => document.querySelector('aucast-player').removeAttribute('server'));
      await untilState(tab, 'idle');
      assert.deepEqual(tab.faults, []);
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
        // Firefox has one for all its tabs.
        const own = name === 'firefox' ? await launch(name, { scheme }) : browser;
        const tab = await openTab(own, server.at('http', '?stream=lecture'),
                                  { width: 360, height: 640, hasTouch: true, isMobile: true,
                                    untouched: true });
        if (own === browser) {
          await tab.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }]);
        }
        assert.ok(await tab.evaluate(it => matchMedia(`(prefers-color-scheme: ${it})`).matches, scheme));
        await untilState(tab, 'playing');
        await tab.waitForSelector('aucast-player >>> .tap:not([hidden])');
        await tab.evaluate(axe);
        const found = await tab.evaluate(async () => (await window.axe.run()).violations
            .filter(v => ['serious', 'critical'].includes(v.impact))
            .map(v => `${v.id}: ${v.nodes.map(n => n.html).join(' ')}`));
        assert.deepEqual(found, []);
        await tab.close();
        if (own !== browser) await own.close();
      }
    });
  });
}
