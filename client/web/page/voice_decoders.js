// Opus packets to sound: npm's opus-decoder, for the core (common/voice/voice_decoder_js.cpp).
// scripts/build_web.sh puts it here if it can; a page without it plays without voice.

const MONO_48K = { channels: 1, sampleRate: 48_000 };
const NOTHING = new Float32Array(0);

let opus;  // a promise of its class, or of nothing; one for all faces of the page
let failures = 0;

async function load() {
  // An address that has failed is never asked again by Firefox.
  await import(`./opus-decoder.min.js${failures > 0 ? `?${failures}` : ''}`);
  const { OpusDecoder } = globalThis['opus-decoder'];
  const first = new OpusDecoder(MONO_48K);  // compiles it, which takes longest
  await first.ready;
  first.free();
  return OpusDecoder;
}

/// Whether voice can be decoded. `there`: the page was built with the decoder. After a failure the
/// next call tries again.
export async function loadOpus(there) {
  opus ??= there ? load().catch(error => {
    opus = undefined;
    ++failures;
    throw error;
  }) : Promise.resolve(null);
  try {
    return await opus !== null;
  } catch (error) {
    console.info('without voice:', error.message);
    return false;
  }
}

export class VoiceDecoders {
  constructor() {
    this.decoders = new Map();
    this.last = 0;
  }

  open() {
    const id = ++this.last;
    const entry = { decoder: null };
    this.decoders.set(id, entry);
    opus?.then(async OpusDecoder => {
      const decoder = OpusDecoder && new OpusDecoder(MONO_48K);
      await decoder?.ready;
      // A voice comes over a network, and so later than this.
      if (this.decoders.has(id)) entry.decoder = decoder;
      else decoder?.free();
    }).catch(() => {});
    return id;
  }

  close(id) {
    this.decoders.get(id)?.decoder?.free();
    this.decoders.delete(id);
  }

  /// The samples of a packet; of an empty one, what the sound could have gone on like. Empty when it
  /// is no Opus packet.
  decode(id, packet) {
    try {
      return this.decoders.get(id)?.decoder?.decodeFrame(packet).channelData[0] ?? NOTHING;
    } catch {
      return NOTHING;  // larger than any packet
    }
  }
}
