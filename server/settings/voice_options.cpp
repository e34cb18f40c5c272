#include "server/settings/voice_options.h"

namespace aucast::server {
namespace {

using Kind = OptionValue::Kind;

constexpr std::int64_t kDelayMsMax = 10'000;

Complaint read_rate(const std::string& word, int& bits_per_second) {
  const int kbits = number_of<int>(word).value_or(0);
  if (kbits != 8 && kbits != 10 && kbits != 12 && kbits != 16 && kbits != 24) {
    return "is not one of 8, 10, 12, 16 and 24";
  }
  bits_per_second = kbits * 1000;
  return std::nullopt;
}

Complaint read_frame(const std::string& word, Milliseconds& frame) {
  const int ms = number_of<int>(word).value_or(0);
  if (ms != 20 && ms != 40 && ms != 60) return "is not one of 20, 40 and 60";
  frame = Milliseconds(ms);
  return std::nullopt;
}

}  // namespace

std::vector<OptionRow> voice_rows(VoiceOptions& options) {
  return {
      {.option = {"voice", "FILE"},
       .text = "the first source's sound (NAME.wav... beside it)",
       .more = "A sound file (WAV, FLAC, Ogg Opus, Ogg Vorbis, MP3) beside a source, with the same "
               "name but .wav, .flac, .opus, .ogg or .mp3, is its voice, which clients that ask "
               "for it get with the face. A .vtt file there has the captions. This option names "
               "another sound file for the first source. For a live source it is - (stdin) or a "
               "FIFO with raw sound: 16-bit signed little-endian, 16000 Hz, mono, as arecord -f "
               "S16_LE -r 16000 -c 1 -t raw writes it.",
       .value = word(options.file),
       .heading = "Voice"},
      {.option = {"no-voice"},
       .text = "serve no sound",
       .more = "Sound files beside the sources are left alone.",
       .value = flag(options.none)},
      {.option = {"voice-delay", "MS", "0"},
       .text = "delay the sound by MS (0)",
       .more = "How much later than the face the sound is played: -10000 to 10000 milliseconds. It "
               "is for a recogniser whose results come later than the sound from the microphone; a "
               "negative number makes the sound come earlier, for a microphone that is later than "
               "the recogniser.",
       .value = whole(options.delay, -kDelayMsMax, kDelayMsMax)},
      {.option = {"voice-rate", "KBITS", "10"},
       .text = "kbit/s of the voice: 8, 10, 12, 16 or 24 (10)",
       .more =
           "Kilobits of speech a second: 8, 10, 12, 16 or 24. On the wire it takes a third more.",
       .value = parsed(Kind::Number, read_rate, options.encoder.bits_per_second)},
      {.option = {"voice-frame", "MS", "60"},
       .text = "ms of speech in a packet: 20, 40 or 60 (60)",
       .more = "Milliseconds of speech in one packet: 20, 40 or 60. Short ones arrive sooner and "
               "take more of the link.",
       .value = parsed(Kind::Number, read_frame, options.encoder.frame)},
  };
}

}  // namespace aucast::server
