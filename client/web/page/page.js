// The page of the player alone: makes the element out of the address.
//   ?server=wss://HOST[:PORT]   else the server that the page comes from
//   ?stream=NAME  ?face=NAME  ?show=6,12:80 (no server is asked)  #token=WORD
import './aucast-player.js';

const asked = new URLSearchParams(location.search);
const hash = new URLSearchParams(location.hash.slice(1));
const player = document.createElement('aucast-player');

// Whoever looks at the bar or the history must not read it.
if (hash.has('token')) {
  player.token = hash.get('token');
  history.replaceState(null, '', location.pathname + location.search);
}
for (const name of ['stream', 'face', 'show', 'layers', 'muted', 'captions']) {
  if (asked.has(name)) player.setAttribute(name, asked.get(name));
}
if (asked.has('server')) {
  player.setAttribute('server', asked.get('server'));
} else if (!asked.has('show')) {
  player.setAttribute('server', location.origin.replace(/^http/, 'ws'));
}
player.setAttribute('controls', '');
for (const news of ['state', 'stream']) {
  player.addEventListener(news, () => {
    const who = player.speaker || player.getAttribute('stream');
    document.title = who ? `${who} - AUcast` : 'AUcast';
  });
}
document.getElementById('stage').append(player);
