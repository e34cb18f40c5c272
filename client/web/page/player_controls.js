// What one does with a player: which stream, pause, the AUs in words, a picture, the full screen.
// Everything is a control of HTML, so that keyboard and screen readers have it too.

import { TokenForm } from './player_token.js';

function button(label, act) {
  const made = document.createElement('button');
  made.type = 'button';
  made.textContent = label;
  made.addEventListener('click', act);
  return made;
}

/// "1:05", "1:02:03".
function clock(ms) {
  const all = Math.max(Math.round(ms / 1000), ms > 0 ? 1 : 0);
  const two = value => String(value).padStart(2, '0');
  const minutes = Math.floor(all / 60);
  const start = minutes < 60 ? minutes : `${Math.floor(minutes / 60)}:${two(minutes % 60)}`;
  return `${start}:${two(all % 60)}`;
}

/// "A lecture (live)"; a stream without a title by its name.
function words({ name, live, duration, title }) {
  const kind = live ? 'live' : duration !== undefined ? clock(duration) : '';
  return (title || name) + (kind && ` (${kind})`);
}

export class Controls {
  constructor(player) {
    this.player = player;
    this.bar = document.createElement('div');
    this.bar.className = 'bar';
    this.bar.setAttribute('role', 'group');
    this.bar.setAttribute('aria-label', 'Player');
    this.choice = document.createElement('select');
    this.choice.setAttribute('aria-label', 'Who is speaking');
    this.choice.hidden = true;
    this.choice.addEventListener('change', () => player.setAttribute('stream', this.choice.value));
    this.pause = button('Pause', () => this.press());
    this.pause.hidden = true;
    this.name = document.createElement('span');
    this.name.className = 'name';
    this.words = document.createElement('p');
    this.words.className = 'aus';
    this.words.hidden = true;
    this.words.setAttribute('aria-live', 'polite');
    this.text = button('AUs', () => this.showWords());
    this.text.setAttribute('aria-pressed', 'false');
    this.text.title = 'The Action Units in words';
    this.mute = button('Mute', () => { player.muted = !player.muted; });
    this.mute.setAttribute('aria-pressed', 'false');
    this.volume = document.createElement('input');
    this.volume.type = 'range';
    this.volume.max = '100';
    this.volume.setAttribute('aria-label', 'Volume');
    this.volume.addEventListener('input', () => this.setVolume());
    this.mute.hidden = this.volume.hidden = true;
    this.caption = button('Captions', () => this.toggleCaptions());
    this.caption.hidden = true;
    this.picture = button('Picture', () => this.keepPicture().catch(error => player.fail(error)));
    this.picture.title = 'Save a picture of the face';
    this.screen = button('Full screen', () => this.fullScreen().catch(error => player.fail(error)));
    this.bar.append(this.choice, this.name, this.pause, this.mute, this.volume, this.caption,
                    this.text, this.picture, this.screen);
    player.foot.append(this.words, this.bar);
    this.tokenForm = new TokenForm(player);
    if (!document.fullscreenEnabled) this.screen.hidden = true;
    player.addEventListener('state', event => this.follow(event.detail.state));
    player.addEventListener('sound', () => this.followSound());
    player.addEventListener('stream', () => this.followStream());
    player.addEventListener('keyframe', () => this.tellWords());
  }

  /// The server's streams, once it has answered the player: the question takes a place of its own, and
  /// the server may have only one left.
  async list() {
    const player = this.player;
    const { server } = player;
    if (!server || this.asking) return;
    this.asking = true;
    try {
      const streams = await player.list();
      if (player.server !== server) throw new Error('another server was chosen meanwhile');
      const chosen = player.getAttribute('stream') || streams[0]?.name;
      this.choice.replaceChildren(...streams.map(stream => {
        const option = document.createElement('option');
        option.value = stream.name;
        option.textContent = words(stream);
        option.selected = stream.name === chosen;
        return option;
      }));
      this.choice.hidden = streams.length < 2;
      this.only = streams.length < 2 ? chosen : '';
      this.listed = server;
      this.followStream();
    } catch {
      // The player says why there is no server; asked again when there is one.
      this.listed = '';
    }
    this.asking = false;
  }

  /// The streams of the server before are none of this one's.
  forget() {
    this.listed = '';
    this.only = '';
    this.choice.hidden = true;
  }

  follow(state) {
    const over = ['idle', 'ended', 'lost'].includes(state);
    this.pause.textContent = over ? 'Play again' : state === 'paused' ? 'Play' : 'Pause';
    this.tokenForm.follow(state);
    this.showPause();
    if (this.listed && this.listed !== this.player.server) this.forget();
    const refused = this.player.wantsToken;
    if (!this.listed && !refused && state !== 'connecting' && state !== 'idle') this.list();
    this.tellWords();
  }

  /// While a token is asked for, its form has the button that plays.
  showPause() { this.pause.hidden = this.player.state === 'idle' || this.tokenForm.shown; }

  /// Who is speaking; the title says it better than the name of the stream.
  followStream() {
    const { title, captions } = this.player.about;
    this.name.textContent = title || this.only || '';
    this.caption.hidden = !captions;
    this.caption.setAttribute('aria-pressed', String(this.player.captions.shown));
    this.followSound();
  }

  followSound() {
    const { player } = this;
    this.mute.hidden = this.volume.hidden = !player.about.voice;
    this.mute.setAttribute('aria-pressed', String(player.muted));
    this.volume.value = String(Math.round(100 * player.volume));
  }

  setVolume() {
    this.player.muted = false;
    this.player.volume = Number(this.volume.value) / 100;
  }

  toggleCaptions() {
    this.player.captions.show(!this.player.captions.shown);
    this.followStream();
  }

  press() {
    const player = this.player;
    if (this.pause.textContent === 'Play again') {
      player.playAgain().catch(error => player.fail(error));
    } else {
      player.setPaused(player.state !== 'paused');
    }
  }

  showWords() {
    this.words.hidden = !this.words.hidden;
    this.text.setAttribute('aria-pressed', String(!this.words.hidden));
    this.tellWords();
  }

  tellWords() {
    if (this.words.hidden || !this.player.engine) return;
    const words = this.player.engine.ausInWords;
    if (this.words.textContent !== words) this.words.textContent = words;
  }

  async keepPicture() {
    const url = URL.createObjectURL(await this.player.picture());
    const link = document.createElement('a');
    link.href = url;
    link.download = `face-${this.player.aus.replaceAll(/[^0-9A-Za-z]+/g, '_')}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
  }

  async fullScreen() {
    if (document.fullscreenElement) {
      await document.exitFullscreen();
    } else {
      await this.player.requestFullscreen();
    }
  }
}
