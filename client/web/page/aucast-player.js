// <aucast-player>: a face in a page. What a page loads to have it:
//   <script type="module" src="aucast-player.js"></script>
// client/web/GUIDE.md has its attributes, events and methods.
import { Captions } from './player_captions.js';
import { Controls } from './player_controls.js';
import { PlayerEngine } from './player_engine.js';
import { PlayerSound } from './player_sound.js';
import { playerStyle } from './player_style.js';

const PIXELS_PER_PIXEL_MAX = 2;  // more is not seen, and a phone has better uses for its battery
const HIDDEN_BEAT_MS = 500;

/// What the states are called, for people.
const WORDS = {
  idle: '',
  connecting: 'Connecting',
  buffering: 'Buffering',
  playing: 'Playing',
  stalled: 'Waiting for the sender',
  stale: 'Waiting for the sender',
  paused: 'Paused',
  ended: 'The stream has ended',
  lost: 'Lost',
};

const OVER = ['idle', 'ended', 'lost'];

class AucastPlayer extends HTMLElement {
  static observedAttributes = ['face', 'stream', 'server', 'show', 'layers', 'muted', 'volume',
                               'captions'];

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    root.adoptedStyleSheets = [playerStyle];
    this.canvas = document.createElement('canvas');
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', 'A face');
    this.message = document.createElement('p');
    this.message.className = this.message.id = 'message';
    this.message.setAttribute('role', 'status');
    this.foot = document.createElement('div');
    this.foot.className = 'foot';
    const head = document.createElement('div');
    head.className = 'head';
    head.append(this.message);
    root.append(this.canvas, head, this.foot);
    this.captions = new Captions(this);
    this.sound = new PlayerSound(this, () => this.advance());
    this.engine = null;
    this.told = { state: '', words: '' };
    this.about = { title: '', voice: false, captions: false };
    this.wishes = 0;
    this.token = '';
    this.wished = false;  // by a method, before the face was there: the attributes come second
    this.asked = null;  // the stream that was to be played last; null: that of the attribute
    this.wantsDraw = true;
    this.resumes = '';  // when it comes back to the page: 'playing', 'paused' or nothing
    this.failed = false;  // to load the face
    this.expectFace();
    this.listenToContext();
  }

  // === What a page calls.

  /// Shows a set of AUs, `6,12:80`; needs no server. Throws for anything else.
  async show(aus) {
    this.wish();
    await this.load();
    this.showNow(aus);
  }

  /// Plays a stream of `server`; without a name its first one.
  async play(stream = this.getAttribute('stream') ?? '') { await this.begin(stream); }

  async stop() {
    this.wish();
    await this.load();
    this.engine.stop();
    this.tell();
  }

  pause() { this.setPaused(true); }
  resume() { this.setPaused(false); }

  /// The stream that was asked for last, from its beginning.
  playAgain() { return this.play(this.asked ?? undefined); }

  /// The names of the server's streams.
  async streams() { return (await this.list()).map(({ name }) => name); }

  /// What the server says of its streams: `{name, live, duration, title}`. `duration` is in ms; what
  /// it does not say is undefined, an unknown title empty.
  async list() {
    await this.load();
    return this.engine.streams(this.server, this.token);
  }

  /// A PNG of the face, as large as it is here, as a Blob.
  async picture(width = this.canvas.width, height = this.canvas.height) {
    await this.load();
    const canvas = document.createElement('canvas');
    canvas.width = width;
    canvas.height = height;
    canvas.getContext('2d').putImageData(this.engine.picture(width, height), 0, 0);
    return new Promise(resolve => { canvas.toBlob(resolve, 'image/png'); });
  }

  /// As those of a media element: from 0 to 1.
  get volume() { return this.sound.volume; }
  set volume(volume) { this.sound.volume = volume; }
  get muted() { return this.sound.muted; }
  set muted(muted) { this.sound.muted = muted; }
  /// A voice waits to be heard until somebody touches the page.
  get needsTap() { return this.sound.needsTap; }
  /// What is being said; empty: nothing, or there are no captions.
  get caption() { return this.captions.text; }
  /// Who is speaking; empty: the stream does not say.
  get speaker() { return this.about.title; }

  get state() { return this.told.state; }
  get aus() { return this.engine ? this.engine.aus : '0'; }
  get server() { return this.getAttribute('server') ?? ''; }
  /// The server has refused for want of the right token.
  get wantsToken() { return this.state === 'lost' && this.engine.tokenRefused; }

  // === The life of the element.

  connectedCallback() {
    if (this.sizes) return;  // moved within the page
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(this);
    this.onVisibility = () => this.beat();
    document.addEventListener('visibilitychange', this.onVisibility);
    if (this.hasAttribute('controls')) this.controls ??= new Controls(this);
    this.listenToPointer();
    if (!this.engine) {
      if (!this.starting) this.start();
    } else if (this.resumes) {
      const paused = this.resumes === 'paused';
      this.begin(this.asked, { paused }).catch(error => this.fail(error));
    } else {
      this.beat();
    }
  }

  disconnectedCallback() {
    // Moved within the page it comes back at once.
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.sizes?.disconnect();
      this.sizes = null;
      document.removeEventListener('visibilitychange', this.onVisibility);
      if (!this.engine) return;
      const { state } = this.engine;
      if (!OVER.includes(state)) {
        this.resumes = state === 'paused' ? 'paused' : 'playing';
        this.engine.stop();
      }
      this.sound.close();
      this.tell();
    });
  }

  attributeChangedCallback(name, before, now) {
    if (before === now) return;
    if (name === 'server' || name === 'stream') this.asked = null;
    // A server's token is for nobody else. The first server is that of a token set before.
    if (name === 'server' && before !== null) this.token = '';
    if (name === 'muted') {
      this.muted = now !== null;
    } else if (name === 'volume') {
      this.setVolumeText(now);
    } else if (name === 'captions') {
      this.captions.show(now !== 'off');
    } else if (!this.engine) {
      // start() reads them all, those that are changed together with this one too.
      queueMicrotask(() => this.load());
    } else if (name === 'face') {
      return;
    } else if (name === 'layers') {
      this.setLayersText(now);
    } else if (name === 'show') {
      if (now !== null) this.show(now).catch(error => this.fail(error));
    } else if (this.server) {
      this.play().catch(error => this.fail(error));
    } else if (name === 'server') {
      this.stop().catch(error => this.fail(error));
    }
  }

  setLayersText(text) {
    try {
      this.engine.setLayers(text || 'textured');
      this.draw();
    } catch (error) {
      this.fail(error);
    }
  }

  setVolumeText(text) {
    try {
      this.volume = Number(text ?? 1);
    } catch (error) {
      this.fail(error);
    }
  }

  expectFace() {
    this.ready = new Promise((resolve, reject) => { this.settle = { resolve, reject }; });
    this.ready.catch(() => {});  // told in words and by the event 'error'
  }

  /// The promise of the face, which is tried anew if it could not be loaded.
  load() {
    if (this.failed && this.isConnected) this.start();
    return this.ready;
  }

  /// Loads the face, and does what the attributes say unless a method says something else.
  async start() {
    if (this.failed) this.expectFace();
    this.failed = false;
    this.starting = true;
    try {
      await this.loadFace();
      this.settle.resolve();
    } catch (error) {
      this.engine = null;
      this.failed = true;
      this.wished = false;
      this.settle.reject(error);
      this.fail(error);
    }
    this.starting = false;
    if (this.failed || this.wished) return;
    try {
      if (this.hasAttribute('show')) this.showNow(this.getAttribute('show'));
      if (this.server) await this.play();
    } catch (error) {
      this.fail(error);
    }
  }

  /// Somebody says what the face is to do, and nothing else from now on. Returns its number.
  wish() {
    this.wished = true;
    this.resumes = '';
    return ++this.wishes;
  }

  showNow(aus) {
    this.engine.show(String(aus));
    this.engine.advance();
    this.tell();
    this.draw();
  }

  /// Plays a stream once the face is there, and in the page.
  async begin(stream, { paused = false } = {}) {
    const wish = this.wish();
    await this.load();
    await this.engine.loadVoice();
    if (wish !== this.wishes) return;  // something else was asked for since
    this.asked = stream;
    if (!this.isConnected) {
      this.resumes = paused ? 'paused' : 'playing';
      return;
    }
    this.engine.play(this.server, stream, this.token);
    if (paused) this.engine.pause(true);
    this.tell();
    this.beat();
  }

  async loadFace() {
    this.say('Loading the face');
    this.engine = await PlayerEngine.create(this.canvas, this.getAttribute('face') ?? 'default',
                                            { voice: this.server !== '' });
    this.sound.apply();
    const layers = this.getAttribute('layers');
    if (layers) this.engine.setLayers(layers);
    this.resize();
    this.say('');
    await this.engine.make();
    this.draw();
  }

  fail(error) {
    this.say(error.message);
    this.dispatchEvent(new CustomEvent('error', { detail: { message: error.message } }));
  }

  say(words) {
    if (this.message.textContent !== words) this.message.textContent = words;
  }

  // === Time. A hidden page listens on and draws nothing.

  beat() {
    cancelAnimationFrame(this.nextFrame);
    clearTimeout(this.nextBeat);
    if (!this.engine) return;
    this.advance();
    if (this.engine.state === 'idle' || !this.isConnected) {
      this.draw();
    } else if (document.hidden) {
      this.nextBeat = setTimeout(() => this.beat(), HIDDEN_BEAT_MS);
    } else {
      if (this.wantsDraw) {
        this.draw();
        this.engine.faceShown();
      }
      this.nextFrame = requestAnimationFrame(() => this.beat());
    }
  }

  advance() {
    if (this.engine.advance()) this.wantsDraw = true;
    this.sound.follow();
    this.captions.follow(this.engine, this.muted);
    this.tell();
  }

  draw() {
    if (!this.engine || document.hidden || this.canvas.width === 0) {
      this.wantsDraw = true;
      return;
    }
    this.wantsDraw = false;
    this.engine.draw(this.canvas.width, this.canvas.height);
  }

  resize() {
    const scale = Math.min(devicePixelRatio || 1, PIXELS_PER_PIXEL_MAX);
    const box = this.getBoundingClientRect();
    const width = Math.round(box.width * scale);
    const height = Math.round(box.height * scale);
    if (width > 0 && height > 0 && (width !== this.canvas.width || height !== this.canvas.height)) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    this.draw();
  }

  setPaused(paused) {
    if (!this.engine) return;
    this.engine.pause(paused);
    this.beat();
  }

  /// The events, and the words for people.
  tell() {
    const engine = this.engine;
    for (const keyframe of engine.takeBegun()) {
      this.dispatchEvent(new CustomEvent('keyframe', { detail: keyframe }));
    }
    const about = { title: engine.title, voice: engine.voice, captions: engine.captions };
    if (JSON.stringify(about) !== JSON.stringify(this.about)) {
      this.about = about;
      this.dispatchEvent(new CustomEvent('stream', { detail: about }));
    }
    let state = engine.state;
    // The core holds and tries again; a person wants to know that the line is cut.
    if (!engine.connected && ['buffering', 'stalled', 'stale'].includes(state)) state = 'connecting';
    const detail = state === 'ended' ? '' : engine.detail;
    const words = state === 'connecting' && engine.reconnects > 0 ? 'Connecting again' : WORDS[state];
    const sentence = engine.tokenRefused ? this.tokenSentence()
        : detail ? `${words}: ${detail}` : words;
    if (state === this.told.state && sentence === this.told.words) return;
    this.told = { state, words: sentence };
    this.sayState();
    this.dispatchEvent(new CustomEvent('state', { detail: { state, words: sentence } }));
  }

  /// A face that plays, or plays nothing, speaks for itself.
  sayState() {
    const { state, words } = this.told;
    this.say(state === 'playing' || state === 'idle' ? '' : words);
  }

  tokenSentence() {
    if (this.token) return 'This token is wrong. Ask the lecturer for the right one.';
    return this.engine.maySendToken ? 'This stream needs a token. Ask the lecturer for it.'
        : 'This stream needs a token, and a token is sent only over wss:// or to localhost';
  }

  // === Input on the face itself.

  listenToPointer() {
    if (this.listens) return;
    this.listens = true;
    const pointers = new Map();
    const canvas = this.canvas;
    // A browser counts the end of a touch as somebody's will, and not its beginning.
    this.addEventListener('pointerup', () => this.sound.allow());
    this.addEventListener('keydown', () => this.sound.allow());
    canvas.addEventListener('pointerdown', event => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, event);
    });
    canvas.addEventListener('pointermove', event => {
      const before = pointers.get(event.pointerId);
      if (!before || !this.engine) return;
      if (pointers.size === 1) {
        this.engine.orbit(event.clientX - before.clientX, event.clientY - before.clientY,
                          canvas.clientHeight);
      } else {
        const other = [...pointers.values()].find(p => p.pointerId !== event.pointerId);
        const span = p => Math.hypot(p.clientX - other.clientX, p.clientY - other.clientY) + 1;
        this.engine.zoom(Math.log(span(event) / span(before)) * 10);
      }
      pointers.set(event.pointerId, event);
      this.draw();
    });
    for (const end of ['pointerup', 'pointercancel']) {
      canvas.addEventListener(end, event => pointers.delete(event.pointerId));
    }
    canvas.addEventListener('wheel', event => {
      // In somebody's page the wheel is the page's, unless the face has been chosen.
      if (!this.engine || this.shadowRoot.activeElement !== canvas) return;
      event.preventDefault();
      this.engine.zoom(-Math.sign(event.deltaY));
      this.draw();
    }, { passive: false });
    canvas.addEventListener('keydown', event => this.onKey(event));
  }

  onKey(event) {
    if (!this.engine || event.ctrlKey || event.altKey || event.metaKey) return;
    const step = this.canvas.clientHeight / 18;  // ten degrees
    const turns = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step],
                    ArrowDown: [0, step] };
    if (event.key in turns) {
      this.engine.orbit(...turns[event.key], this.canvas.clientHeight);
    } else if (event.key === '+' || event.key === '-') {
      this.engine.zoom(event.key === '+' ? 1 : -1);
    } else if (event.key === 'Home') {
      this.engine.faceFront();
    } else if (event.key === 'm') {
      this.muted = !this.muted;
    } else if (event.key === '9' || event.key === '0') {
      this.sound.step(event.key === '0' ? 1 : -1);
    } else if (event.key === ' ') {
      this.setPaused(this.state !== 'paused');
    } else {
      return;
    }
    event.preventDefault();
    this.draw();
  }

  /// A browser may take the graphics memory away and give it back.
  listenToContext() {
    this.canvas.addEventListener('webglcontextlost', event => {
      event.preventDefault();
      this.say('The graphics driver has gone; waiting for it');
    });
    this.canvas.addEventListener('webglcontextrestored', async () => {
      try {
        await this.engine?.renew();
        this.sayState();
        this.draw();
      } catch (error) {
        this.fail(error);
      }
    });
  }
}

customElements.define('aucast-player', AucastPlayer);
