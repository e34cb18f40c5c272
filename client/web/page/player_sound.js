// When the face may be heard, and how loud. Browsers are silent until somebody touches the page;
// until then the face plays by the steady clock, and a button says what to do.

const STEP = 0.02;  // of 9 and 0, as in face-player
/// The core is advanced at most so often for its sound alone.
const SOUND_EVERY_MS = 10;

export class PlayerSound {
  /// `beat` advances the core.
  constructor(player, beat) {
    this.player = player;
    this.beat = beat;
    this.advanced = 0;
    this.level = 1;
    this.silent = false;
    this.told = '';
    this.tap = document.createElement('button');
    this.tap.type = 'button';
    this.tap.className = 'tap';
    this.tap.textContent = 'Tap to hear';
    this.tap.hidden = true;
    this.tap.addEventListener('click', () => this.allow());
    player.message.after(this.tap);
  }

  get engine() { return this.player.engine; }
  get volume() { return this.level; }
  set volume(volume) {
    if (!(volume >= 0 && volume <= 1)) throw new RangeError(`volume ${volume}: it is from 0 to 1`);
    this.level = volume;
    this.apply();
  }
  get muted() { return this.silent; }
  set muted(muted) {
    this.silent = Boolean(muted);
    this.apply();
  }
  /// A voice comes that nobody hears before the page has been touched.
  get needsTap() {
    return Boolean(this.engine?.voice) && !this.engine.heard && !this.silent;
  }

  /// Louder or softer by steps, as by 9 and 0; whoever does that wants to hear it.
  step(by) {
    this.silent = false;
    this.volume = Math.min(Math.max(this.level + by * STEP, 0), 1);
  }

  apply() {
    this.engine?.setVolume(this.level, this.silent);
    this.tell();
  }

  /// Somebody touches the page, or has before.
  async allow() {
    if (!this.engine || this.engine.heard || !(this.engine.voice || this.player.server)) return;
    try {
      await this.engine.allowSound(() => this.played(), () => this.tell());
    } catch (error) {
      console.info('without sound:', error.message);
    }
    this.tell();
  }

  /// A portion of sound has been played.
  played() {
    const now = performance.now();
    if (now - this.advanced >= SOUND_EVERY_MS) this.beat();
  }

  /// After each advance of the core.
  follow() {
    this.advanced = performance.now();
    if (this.engine.takeLoss()) this.close();
    if (this.needsTap && navigator.userActivation?.hasBeenActive && !this.tried) {
      this.tried = true;  // once: the browser may have taken it back since
      this.allow();
    }
    this.tell();
  }

  /// The event, and the button.
  tell() {
    const detail = { voice: Boolean(this.engine?.voice), needsTap: this.needsTap,
                     muted: this.silent, volume: this.level };
    const text = JSON.stringify(detail);
    if (text === this.told) return;
    this.told = text;
    this.tap.hidden = !detail.needsTap;
    this.player.dispatchEvent(new CustomEvent('sound', { detail }));
  }

  /// The browser's sound is let go; the next time it is asked for anew.
  close() {
    this.engine.dropSound();
    this.tried = false;
  }
}
