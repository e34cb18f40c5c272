// Writes the pictures of the page's documents: node pictures.mjs FOLDER. Look at them before
// committing. scripts/update_web_pictures.sh starts it.
import path from 'node:path';

import { launch, openTab, root, serve, untilState } from './support.mjs';

const out = process.argv[2];
const server = await serve([path.join(root, 'data/streams/lecture.txt')]);
const browser = await launch('chromium');
const SHOTS = [
  { name: 'page', rest: '', device: { width: 1280, height: 800 } },
  { name: 'phone', rest: '',
    device: { width: 360, height: 640, deviceScaleFactor: 2, hasTouch: true, isMobile: true,
              untouched: true } },
  { name: 'example', rest: 'example.html', device: { width: 800, height: 860 } },
];
for (const { name, rest, device } of SHOTS) {
  const tab = await openTab(browser, server.at('http', rest), device);
  if (name === 'example') {
    await tab.evaluate(async () => {
      document.querySelector('[data-aus="6,12"]').click();
      await document.getElementById('face').show('6,12');
    });
  } else {
    await untilState(tab, 'playing');
    await tab.waitForFunction(() => window.keyframes.length > 20);
  }
  await tab.screenshot({ path: path.join(out, `${name}.png`) });
  await tab.close();
}
await browser.close();
await server.kill();
