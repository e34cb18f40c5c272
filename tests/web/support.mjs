// The real programs and browsers, for the tests.
import { spawn, execFileSync } from 'node:child_process';
import { readFile, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createInterface } from 'node:readline';
import path from 'node:path';
import puppeteer from 'puppeteer-core';

export const root = path.resolve(import.meta.dirname, '../..');
export const bin = process.env.AUCAST_BIN ?? path.join(root, 'build/release/bin');
/// Software draws, on a busy machine. Several tests that wait so long in vain, and their second try,
/// have to fit into what .ci/run gives the page.
const PATIENCE_MS = 60_000;

/// au-transmitter --web, ready. `ports`: those of one that was there before.
/// `data`: the folder in place of its own, with web/ in it.
export async function serve(streams, { ports = [0, 0], options = [], data } = {}) {
  const child = spawn(path.join(bin, 'au-transmitter'),
      ['--port', String(ports[0]), '--web', `127.0.0.1:${ports[1]}`, ...options, ...streams],
      { stdio: ['ignore', 'pipe', 'pipe'], env: data ? { ...process.env, AUCAST_DATA: data } : process.env });
  let complaints = '';
  child.stderr.on('data', text => { complaints += text; });
  const gone = new Promise(resolve => child.on('exit', resolve));
  const found = {};
  for await (const line of createInterface({ input: child.stdout })) {
    const told = /^(listening|web) on .*:(\d+)$/.exec(line);
    if (told) found[told[1]] = Number(told[2]);
    if (found.web) break;
  }
  if (!found.web) throw new Error(`au-transmitter --web did not begin: ${complaints}`);
  child.stdout.resume();
  return {
    ports: [found.listening, found.web],
    at: (scheme, rest = '') => `${scheme}://localhost:${found.web}/${rest}`,
    async kill(signal = 'SIGKILL') {
      child.kill(signal);
      await gone;
    },
  };
}

/// Some file server that knows nothing of AUcast. A page of its own has a clock of 5 us, for it lets
/// none of others in.
export async function serveFiles(folder) {
  const kinds = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css',
                  '.wasm': 'application/wasm', '.svg': 'image/svg+xml', '.json': 'application/json' };
  const server = createServer((request, reply) => {
    const file = path.join(folder, path.normalize(new URL(request.url, 'http://a').pathname));
    readFile(file, (error, bytes) => {
      reply.writeHead(error ? 404 : 200, {
        'Content-Type': kinds[path.extname(file)] ?? 'application/octet-stream',
        'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Embedder-Policy': 'require-corp' });
      reply.end(error ? '' : bytes);
    });
  });
  await new Promise(resolve => server.listen(0, '127.0.0.1', resolve));
  return {
    at: rest => `http://localhost:${server.address().port}/${rest}`,
    close() {
      server.close();
      server.closeAllConnections();
    },
  };
}

export function facePlayer(...options) {
  execFileSync(path.join(bin, 'face-player'), options, { stdio: 'pipe' });
}

export function auTransmitter(...options) {
  return execFileSync(path.join(bin, 'au-transmitter'), options, { encoding: 'utf8' });
}

/// The sets of a stream file without times, as they stand there.
export function setsOf(file) {
  return readFileSync(file, 'utf8').split('\n')
      .filter(line => line && !line.startsWith('#') && !/^(Beg|End)_Stream/.test(line));
}

/// Somebody touches the face: browsers let a page be heard from then on.
export async function touch(tab) {
  await tab.mouse.click(20, 20);
}

const SCHEME_PREFERENCE = 'layout.css.prefers-color-scheme.content-override';

const LAUNCH = {
  // What Mesa draws for the native program it draws for the browser too: the same pictures.
  chromium: {
    executablePath: '/usr/bin/chromium',
    headless: false,
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=gl', '--ignore-gpu-blocklist',
           '--ignore-certificate-errors', '--no-first-run', '--force-color-profile=srgb'],
  },
  firefox: {
    browser: 'firefox',
    executablePath: '/usr/bin/firefox-esr',
    headless: false,
    acceptInsecureCerts: true,
    extraPrefsFirefox: { 'webgl.force-enabled': true },
  },
};

/// `scheme`: 'dark' or 'light' for all tabs, in Firefox.
export function launch(name, { scheme } = {}) {
  const options = { ...LAUNCH[name], protocolTimeout: PATIENCE_MS };
  if (scheme) {
    options.extraPrefsFirefox = { ...options.extraPrefsFirefox,
                                  [SCHEME_PREFERENCE]: scheme === 'dark' ? 0 : 1 };
  }
  return puppeteer.launch(options);
}

/// Between two tests: one that failed left its tab open, and perhaps a browser that answers no more.
/// The next test gets a new one.
export async function usable(browser, name) {
  if ((await browser.pages()).length <= 1) return browser;
  process.kill(-browser.process().pid, 'SIGKILL');  // with its children
  return launch(name);
}

/// Calls `then` in the page as soon as it has drawn its first picture. Call this before the page is
/// opened.
export const afterFirstPicture = (tab, then) => tab.evaluateOnNewDocument(`{
  const gl = WebGL2RenderingContext.prototype;
  const draw = gl.drawElements;
  gl.drawElements = function (...what) {
    draw.apply(this, what);
    gl.drawElements = draw;
    (${then})();
  };
}`);

/// A tab that keeps what goes wrong in it in `faults`.
/// Nobody has touched it, if `untouched`: puppeteer's own calls count as touches. `prepare(tab)` comes
/// before the page.
export async function openPage(browser, url, { width = 800, height = 600, untouched = false,
                                               prepare = () => {}, ...device } = {}) {
  const tab = await browser.newPage();
  if (untouched) {
    await tab.evaluateOnNewDocument(() => {
      Object.defineProperty(navigator, 'userActivation', { value: { hasBeenActive: false } });
    });
  }
  tab.setDefaultTimeout(PATIENCE_MS);
  await tab.setViewport({ width, height, ...device });
  tab.faults = [];
  tab.on('console', line => {
    if (['error', 'warn'].includes(line.type())) tab.faults.push(line.text());
  });
  tab.on('pageerror', error => tab.faults.push(error.message));
  await prepare(tab);
  await tab.goto(url);
  return tab;
}

/// Likewise with a player in it, whose face is there, and whose keyframes are kept in `keyframes`.
export async function openTab(browser, url, options) {
  const tab = await openPage(browser, url, options);
  await tab.evaluate(() => {
    const player = document.querySelector('aucast-player');
    window.keyframes = [];
    player.addEventListener('keyframe', event => window.keyframes.push(event.detail.aus));
    return player.ready;
  });
  return tab;
}

export const untilState = (tab, state) => tab.waitForFunction(
    wanted => document.querySelector('aucast-player').state === wanted, { polling: 50 }, state);

/// The share of pixels in which a channel of the element's picture differs from a PNG by more than 1 %.
export function differing(tab, png, width, height) {
  return tab.evaluate(async (base64, w, h) => {
    const pixels = async blob => {
      const canvas = new OffscreenCanvas(w, h);
      const context = canvas.getContext('2d');
      context.drawImage(await createImageBitmap(blob), 0, 0);
      return context.getImageData(0, 0, w, h).data;
    };
    const bytes = Uint8Array.from(atob(base64), letter => letter.charCodeAt(0));
    const wanted = await pixels(new Blob([bytes], { type: 'image/png' }));
    const player = document.querySelector('aucast-player');
    const drawn = await pixels(await player.picture(w, h));
    let count = 0;
    for (let at = 0; at < wanted.length; at += 4) {
      if ([0, 1, 2].some(c => Math.abs(wanted[at + c] - drawn[at + c]) > 2.55)) ++count;
    }
    return count / (w * h);
  }, png.toString('base64'), width, height);
}

/// What the page's own thread did from the mark `from` to the mark `to` of a trace: the longest task, in
/// ms of the processor's time. So waiting does not count: for others on a busy machine, or for the
/// graphics driver, which draws in another process. `between(a, b)`: the time between two marks.
export function ownTime(trace) {
  const { traceEvents } = JSON.parse(Buffer.from(trace).toString());
  const mark = name => {
    const found = traceEvents.find(e => e.name === name && e.cat.includes('blink.user_timing'));
    if (!found) throw new Error(`the trace has no mark '${name}'`);
    return found;
  };
  return {
    between: (from, to) => (mark(to).tts - mark(from).tts) / 1000,
    longestTask(from, to) {
      const [begin, end] = [mark(from), mark(to)];
      const tasks = traceEvents.filter(e => e.ph === 'X' && e.pid === begin.pid && e.tid === begin.tid &&
                                            e.tdur && e.ts + e.dur > begin.ts && e.ts + e.dur < end.ts);
      // Of the task that made the first mark its rest.
      const times = tasks.map(e => Math.min(e.tdur, e.tts + e.tdur - begin.tts) / 1000);
      return { count: times.length, ms: times.reduce((longest, ms) => Math.max(longest, ms), 0) };
    },
  };
}
