// What is being said, over the face. A screen reader is told of it only while the voice itself is not
// to be heard.

export class Captions {
  constructor(player) {
    this.player = player;
    this.shown = true;
    this.line = document.createElement('p');
    this.line.className = 'caption';
    this.line.hidden = true;
    player.foot.append(this.line);
  }

  get text() { return this.line.textContent; }

  show(shown) {
    this.shown = shown;
    this.line.hidden = !shown || this.text === '';
  }

  /// After each advance of the core.
  follow(engine, muted) {
    const live = engine.sounds && !muted ? 'off' : 'polite';
    if (this.line.getAttribute('aria-live') !== live) this.line.setAttribute('aria-live', live);
    const text = engine.caption;
    if (text === this.text) return;
    this.line.textContent = text;
    this.show(this.shown);
    this.player.dispatchEvent(new CustomEvent('caption', { detail: { text } }));
  }
}
