// The face of one canvas: what the WebAssembly cannot do by itself, which is fetching, WebSockets,
// timers and the browser's texts. aucast-player.js has everything that a person sees.
import createCore from './aucast_core.js';

const here = new URL('.', import.meta.url);

/// Where a server's WebSocket is: `wss://host[:port]`, with the path /aucast unless it has another.
export function socketUrl(server) {
  const url = new URL(server);
  if (url.protocol === 'http:') url.protocol = 'ws:';
  if (url.protocol === 'https:') url.protocol = 'wss:';
  if (url.protocol !== 'ws:' && url.protocol !== 'wss:') {
    throw new Error(`${server}: an address begins with wss:// or ws://`);
  }
  if (url.pathname === '/') url.pathname = '/aucast';
  url.search = url.hash = '';
  return url;
}

/// A token is shown to nobody on the way: only over TLS, or to this computer.
function mayShowToken(url) {
  return url.protocol === 'wss:' ||
      /^(localhost|127(\.\d+){3}|\[::1\])$/.test(url.hostname);
}

async function fetchBytes(name) {
  const reply = await fetch(new URL(`data/${name}`, here));
  if (!reply.ok) throw new Error(`${name} is not there (${reply.status})`);
  return new Uint8Array(await reply.arrayBuffer());
}

async function fetchFace(face) {
  const reply = await fetch(new URL('data/faces.json', here));
  if (!reply.ok) throw new Error(`data/faces.json is not there (${reply.status})`);
  const faces = await reply.json();
  if (!Object.hasOwn(faces, face)) {
    throw new Error(`there is no face '${face}': ${Object.keys(faces).join(', ')}`);
  }
  return Promise.all(faces[face].map(async name => [name, await fetchBytes(name)]));
}

/// The WebSockets and timers of the core, by its numbers for them.
class BrowserSide {
  constructor() {
    this.core = null;  // as soon as it is there
    this.url = null;
    this.sockets = new Map();
    this.timers = new Map();
  }

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

  /// Everything goes silent.
  end_all() {
    for (const id of [...this.sockets.keys()]) this.drop(id);
    for (const timer of this.timers.values()) clearTimeout(timer);
    this.timers.clear();
  }
}

export class PlayerEngine {
  /// Loads the face `face` and draws it on `canvas`.
  static async create(canvas, face) {
    const browser = new BrowserSide();
    const [core, files] = await Promise.all([createCore({ browser, canvas }), fetchFace(face)]);
    browser.core = core;
    for (const [name, bytes] of files) {
      const path = `/data/${name}`;
      core.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
      core.FS.writeFile(path, bytes);
    }
    const engine = new PlayerEngine(core, browser);
    engine.check(engine.call('aucast_create', [face]));
    return engine;
  }

  constructor(core, browser) {
    this.core = core;
    this.browser = browser;
  }

  call(name, texts = []) {
    return this.core.ccall(name, 'string', texts.map(() => 'string'), texts);
  }

  check(error) {
    if (error) throw new Error(error);
  }

  /// The face has these AUs from now on: `6,12:80`. Throws for anything else.
  show(aus) { this.check(this.call('aucast_show', [aus])); }
  setLayers(layers) { this.check(this.call('aucast_layers', [layers])); }

  server(server, token) {
    const url = socketUrl(server);
    if (token && !mayShowToken(url)) {
      throw new Error('a token is sent only over wss:// or to localhost');
    }
    this.browser.url = url.href;
    return url.host;
  }

  play(server, stream, token) {
    this.call('aucast_play', [this.server(server, token), stream, token]);
  }

  /// The names of the server's streams.
  async streams(server, token) {
    this.call('aucast_ask_streams', [this.server(server, token), token]);
    for (;;) {
      await new Promise(resolve => setTimeout(resolve, 50));
      const answer = this.call('aucast_streams');
      if (answer.startsWith('!')) throw new Error(answer.slice(1));
      if (answer.startsWith('=')) return answer.slice(1).split(' ').filter(Boolean);
    }
  }

  stop() { this.core._aucast_stop(); }
  pause(paused) { this.core._aucast_pause(paused ? 1 : 0); }
  /// True when there is another face to draw.
  advance() { return this.core._aucast_advance() !== 0; }
  draw(width, height) { this.core._aucast_draw(width, height); }
  /// After webglcontextrestored.
  renew() { this.check(this.call('aucast_renew')); }
  orbit(right, down, height) { this.core._aucast_orbit(right, down, height); }
  zoom(steps) { this.core._aucast_zoom(steps); }
  faceFront() { this.core._aucast_face_front(); }

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
  get connected() { return this.core._aucast_connected() !== 0; }
  get live() { return this.core._aucast_live() !== 0; }
  get reconnects() { return this.core._aucast_reconnects(); }
  get keyframesPlayed() { return this.core._aucast_keyframes_played(); }
  get aus() { return this.call('aucast_aus'); }
  get ausInWords() { return this.call('aucast_aus_in_words'); }
  /// The keyframes that began since the last call.
  takeBegun() {
    return this.call('aucast_begun').split('\n').filter(Boolean).map(line => {
      const [aus, duration] = line.split(';');
      return { aus, duration: Number(duration) };
    });
  }

  close() {
    this.stop();
    this.browser.end_all();
  }
}
