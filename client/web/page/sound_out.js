// Where the core's samples go to be heard: an AudioContext, in which every portion is a buffer that
// begins where the one before ends. It is a clock, too: unheard() follows what the listener hears.

const RATE = 48_000;
const FADE_S = 0.003;
/// Sound cannot begin at once: the browser mixes in blocks.
const SOONEST_S = 0.01;

export class SoundOut {
  /// `onPlayed` is called whenever a portion has been played: the browser calls it in a hidden page,
  /// too, where timers ring once a second. `onChange`: running is another one than before.
  constructor(onPlayed, onChange) {
    this.context = new AudioContext({ sampleRate: RATE });
    this.fade = this.context.createGain();
    this.fade.connect(this.context.destination);
    this.onPlayed = onPlayed;
    this.context.onstatechange = onChange;
    this.written = [];  // the portions that may not have been heard to their ends: {at, end}
    this.end = 0;       // of the last one, in the context's samples
    this.fadeFrom = 0;  // there its end begins to fade out, in seconds
  }

  /// Browsers let a page be heard after somebody has touched it, and may take that back.
  get running() { return this.context.state === 'running'; }

  /// To be called while somebody touches the page.
  async allow() {
    await this.context.resume();
  }

  close() {
    this.context.onstatechange = null;
    this.context.close();
  }

  write(samples) {
    if (!this.running) return;
    const gain = this.fade.gain;
    const soonest = this.context.currentTime + SOONEST_S;
    let full = 0;
    // The sound never breaks off: its end fades out, and if it goes on in time that is taken back.
    if (soonest < this.fadeFrom) {
      gain.cancelScheduledValues(this.fadeFrom - 0.5 / RATE);
    } else {
      this.end = Math.max(Math.ceil(soonest * RATE), this.end, Math.ceil((this.fadeFrom + FADE_S) * RATE));
      full = this.end / RATE + FADE_S;
      gain.setValueAtTime(0, this.end / RATE);
      gain.linearRampToValueAtTime(1, full);
    }
    const buffer = this.context.createBuffer(1, samples.length, RATE);
    buffer.copyToChannel(samples, 0);
    const source = this.context.createBufferSource();
    source.buffer = buffer;
    source.connect(this.fade);
    source.onended = this.onPlayed;
    source.start(this.end / RATE);
    const at = this.end;
    this.end += samples.length;
    this.written.push({ at, end: this.end });
    this.fadeFrom = Math.max(this.end / RATE - FADE_S, full + 1 / RATE);
    gain.setValueAtTime(1, this.fadeFrom);
    gain.linearRampToValueAtTime(0, this.fadeFrom + FADE_S);
  }

  /// Samples written that have not been heard yet.
  unheard() {
    const heard = this.heardSeconds() * RATE;
    while (this.written.length > 0 && this.written[0].end <= heard) this.written.shift();
    return this.written.reduce((sum, { at, end }) => sum + end - Math.max(at, Math.min(heard, end)), 0);
  }

  /// The moment of the context that is being heard.
  heardSeconds() {
    const context = this.context;
    const { contextTime, performanceTime } = context.getOutputTimestamp?.() ?? {};
    if (!(performanceTime > 0)) {
      return context.currentTime - (context.outputLatency || context.baseLatency || 0);
    }
    return Math.min(contextTime + (performance.now() - performanceTime) / 1000, context.currentTime);
  }
}
