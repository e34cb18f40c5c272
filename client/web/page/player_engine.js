// The face of one canvas: what the WebAssembly cannot do by itself, which is fetching, WebSockets,
// timers and the browser's texts. aucast-player.js has everything that a person sees.
import createCore from './aucast_core.js';
import { unpackMesh } from './packed_mesh.js';
import { SoundOut } from './sound_out.js';
import { loadOpus, VoiceDecoders } from './voice_decoders.js';

const PORTION_MS = 10;
const here = new URL('.', import.meta.url);

/// Where a server's WebSocket is: `wss://host[:port]`, with the path /aucast unless it has another.
export function socketUrl(server) {
  let url = null;
  try {
    url = new URL(server.replace(/^http/i, 'ws'));
  } catch {
    // As any other that is none.
  }
  if (url?.protocol !== 'ws:' && url?.protocol !== 'wss:') {
    throw new Error(`'${server}' is no address of a server: wss://HOST[:PORT] or ws://HOST[:PORT]`);
  }
  if (url.pathname === '/') url.pathname = '/aucast';
  url.search = url.hash = '';
  return url;
}

/// The code of PROTOCOL.md.
const TOKEN_REFUSED = 401;

/// A token is shown to nobody on the way: only over TLS, or to this computer.
function mayShowToken(url) {
  return url.protocol === 'wss:' ||
      /^(localhost|127(\.\d+){3}|\[::1\])$/.test(url.hostname);
}

/// A line of aucast_streams().
function streamOf(line) {
  const [name, kind, length, title] = line.split('\t');
  return { name, live: kind ? kind === 'live' : undefined,
           duration: length ? Number(length) : undefined, title };
}

/// Other tasks first. A hidden page's timers ring once a second; its messages come at once.
function nextTask() {
  return new Promise(resolve => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(0);
  });
}

async function fetchBytes(name) {
  if (name.endsWith('.ply')) return unpackMesh(await fetchBytes(`${name}.packed`));
  const reply = await fetch(new URL(`data/${name}`, here));
  if (!reply.ok) throw new Error(`${name} is not there (${reply.status})`);
  return new Uint8Array(await reply.arrayBuffer());
}

/// What the page was built with.
async function fetchParts() {
  const reply = await fetch(new URL('data/parts.json', here));
  if (!reply.ok) throw new Error(`data/parts.json is not there (${reply.status})`);
  return reply.json();
}

async function fetchFace(face, { faces }) {
  if (!Object.hasOwn(faces, face)) {
    throw new Error(`there is no face '${face}': ${Object.keys(faces).join(', ')}`);
  }
  return Promise.all(faces[face].map(async name => [name, await fetchBytes(name)]));
}

/// The WebSockets and timers of the core, by its numbers for them; and its sound.
class BrowserSide {
  constructor() {
    this.core = null;  // as soon as it is there
    this.url = null;
    this.sockets = new Map();
    this.timers = new Map();
    this.sound = null;  // a SoundOut, once somebody may hear it
  }

  writeSound(samples) { this.sound?.write(samples); }
  unheard() { return this.sound ? this.sound.unheard() : 0; }

  open(id) {
    let socket;
    try {
      socket = new WebSocket(this.url);
    } catch {
      setTimeout(() => this.core._aucast_socket_closed(id));
      return;
    }
    this.sockets.set(id, socket);
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => this.core._aucast_socket_opened(id);
    socket.onmessage = ({ data }) => {
      const bytes = typeof data === 'string' ? new TextEncoder().encode(data) : new Uint8Array(data);
      const at = this.core._malloc(bytes.length);
      this.core.HEAPU8.set(bytes, at);
      this.core._aucast_socket_received(id, at, bytes.length);
      this.core._free(at);
    };
    socket.onclose = () => {
      this.sockets.delete(id);
      this.core._aucast_socket_closed(id);
    };
  }

  send(id, text) {
    const socket = this.sockets.get(id);
    if (socket?.readyState === WebSocket.OPEN) socket.send(text);
  }

  end(id) {
    this.sockets.get(id)?.close();
  }

  drop(id) {
    const socket = this.sockets.get(id);
    if (!socket) return;
    this.sockets.delete(id);
    socket.onopen = socket.onmessage = socket.onclose = null;
    socket.close();
  }

  timer(id, ms) {
    clearTimeout(this.timers.get(id));
    this.timers.delete(id);
    if (ms < 0) return;
    this.timers.set(id, setTimeout(() => {
      this.timers.delete(id);
      this.core._aucast_timer_rang(id);
    }, ms));
  }
}

export class PlayerEngine {
  /// Loads the face `face`; with what decodes a stream's voice. It can be drawn on `canvas` then, but
  /// rests until make() has ended.
  static async create(canvas, face, { voice = false } = {}) {
    const browser = new BrowserSide();
    const parts = await fetchParts();
    const [core, files] = await Promise.all([
      createCore({ browser, canvas, voice: new VoiceDecoders() }), fetchFace(face, parts),
      voice && loadOpus(parts.opus)]);
    browser.core = core;
    for (const [name, bytes] of files) {
      const path = `/data/${name}`;
      core.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
      core.FS.writeFile(path, bytes);
    }
    const engine = new PlayerEngine(core, browser, parts);
    engine.check(engine.call('aucast_create', [face]));
    return engine;
  }

  constructor(core, browser, parts) {
    this.core = core;
    this.browser = browser;
    this.parts = parts;
    this.decodes = false;      // there is a decoder for voice
    this.heardBefore = false;  // what the core was told
    this.question = null;      // of streams(), while there is no answer
  }

  call(name, texts = []) {
    return this.core.ccall(name, 'string', texts.map(() => 'string'), texts);
  }

  check(error) {
    if (error) throw new Error(error);
  }

  /// Makes what the face needs to move, in tasks that nobody notices.
  async make() {
    while (!this.makeSome()) await nextTask();
  }

  makeSome() {
    const end = performance.now() + PORTION_MS;
    do {
      if (this.core._aucast_make() !== 0) return true;
    } while (performance.now() < end);
    return false;
  }

  /// The face has these AUs from now on: `6,12:80`. Throws for anything else.
  show(aus) { this.check(this.call('aucast_show', [aus])); }
  setLayers(layers) { this.check(this.call('aucast_layers', [layers])); }

  address(server, token) {
    const url = socketUrl(server);
    if (token && !mayShowToken(url)) {
      throw new Error('a token is sent only over wss:// or to localhost');
    }
    return url;
  }

  /// Before play(), if a voice is to be heard.
  async loadVoice() { this.decodes = await loadOpus(this.parts.opus); }

  play(server, stream, token) {
    const url = this.address(server, token);
    this.browser.url = url.href;
    this.core.ccall('aucast_play', null, ['string', 'string', 'string', 'number'],
                    [url.host, stream, token, this.decodes ? 1 : 0]);
  }

  /// The server's streams, in its order. The core has one question: whoever asks the same gets the
  /// same answer, and what was asked of another server before fails.
  async streams(server, token) {
    const url = this.address(server, token);
    const asked = `${server}\n${token}`;
    if (this.question?.asked !== asked) {
      const question = { asked };
      this.question = question;
      question.answer = this.ask(url, token, question).finally(() => {
        if (this.question === question) this.question = null;
      });
    }
    return this.question.answer;
  }

  async ask(url, token, question) {
    // Of this question alone: the stream that plays is dialled again at its own address.
    const played = this.browser.url;
    this.browser.url = url.href;
    this.call('aucast_ask_streams', [url.host, token]);
    this.browser.url = played;
    for (;;) {
      await new Promise(resolve => setTimeout(resolve, 50));
      if (this.question !== question) {
        throw new Error('another server was asked for its streams meanwhile');
      }
      const answer = this.call('aucast_streams');
      if (answer.startsWith('!')) throw new Error(answer.slice(1));
      if (answer.startsWith('=')) return answer.slice(1).split('\n').filter(Boolean).map(streamOf);
    }
  }

  stop() { this.core._aucast_stop(); }
  pause(paused) { this.core._aucast_pause(paused ? 1 : 0); }
  /// True when there is another face to draw.
  advance() { return this.core._aucast_advance() !== 0; }
  draw(width, height) { this.core._aucast_draw(width, height); }
  /// After webglcontextrestored.
  renew() {
    this.check(this.call('aucast_renew'));
    return this.make();
  }
  orbit(right, down, height) { this.core._aucast_orbit(right, down, height); }
  zoom(steps) { this.core._aucast_zoom(steps); }
  faceFront() { this.core._aucast_face_front(); }

  // === Sound. It is the clock of playback as long as the browser lets it be heard.

  /// Asks the browser for it: while somebody touches the page, or after that. `onPlayed` is called
  /// when time has come to advance().
  async allowSound(onPlayed, onChange) {
    this.browser.sound ??= new SoundOut(onPlayed, () => {
      this.followSound();
      onChange();
    });
    await this.browser.sound.allow();
    this.followSound();
  }

  followSound() {
    if (this.heard === this.heardBefore) return;
    this.heardBefore = this.heard;
    this.core._aucast_sound(this.heard ? 1 : 0);
  }

  /// The browser lets the page be heard.
  get heard() { return this.browser.sound?.running ?? false; }
  /// The core has given up a sound that did not go on.
  takeLoss() { return this.core._aucast_sound_lost() !== 0; }

  dropSound() {
    this.browser.sound?.close();
    this.browser.sound = null;
    this.followSound();
  }

  /// `volume` from 0 to 1.
  setVolume(volume, muted) {
    this.core._aucast_volume(Math.round(100 * volume));
    this.core._aucast_mute(muted ? 1 : 0);
  }

  /// The face that advance() came to has been drawn.
  faceShown() { this.core._aucast_face_shown(); }
  get sounds() { return this.core._aucast_sounds() !== 0; }
  get soundCounts() { return JSON.parse(this.call('aucast_sound_counts')); }

  /// An ImageData, as `face-player pose --png` draws it.
  picture(width, height) {
    const at = this.core._aucast_picture(width, height);
    if (!at) throw new Error(`no room for a picture of ${width}x${height}`);
    // A copy: the memory may move.
    const bytes = this.core.HEAPU8.slice(at, at + 4 * width * height);
    return new ImageData(new Uint8ClampedArray(bytes.buffer), width, height);
  }

  get state() { return this.call('aucast_state'); }
  get detail() { return this.call('aucast_detail'); }
  /// The server wants a token, and the one it was shown, if any, is wrong.
  get tokenRefused() { return this.core._aucast_refusal() === TOKEN_REFUSED; }
  /// To the server that was played last.
  get maySendToken() { return mayShowToken(new URL(this.browser.url)); }
  get connected() { return this.core._aucast_connected() !== 0; }
  get reconnects() { return this.core._aucast_reconnects(); }
  /// Of the stream: whether a voice and captions come with it, and its title.
  get voice() { return this.core._aucast_voice() !== 0; }
  get captions() { return this.core._aucast_captions() !== 0; }
  get title() { return this.call('aucast_title'); }
  /// What is being said.
  get caption() { return this.call('aucast_caption'); }
  get aus() { return this.call('aucast_aus'); }
  get ausInWords() { return this.call('aucast_aus_in_words'); }
  /// The keyframes that began since the last call.
  takeBegun() {
    return this.call('aucast_begun').split('\n').filter(Boolean).map(line => {
      const [aus, time] = line.split(';');
      return { aus, time: Number(time) };
    });
  }
}
