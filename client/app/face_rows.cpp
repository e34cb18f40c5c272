#include "client/app/face_rows.h"

#include <limits>

#include "client/app/read_number.h"
#include "client/playback/source_playback.h"
#include "common/number_of.h"
#include "common/text.h"

namespace aucast::app {
namespace {

using Kind = OptionValue::Kind;

constexpr int kSpeedMaxMs = playback::SourcePlayback::kSpeedMax.count();

/// SEED[:INTERVAL_MS[:CLOSING_MS]]
Complaint read_blink(const std::string& word, std::optional<playback::BlinkOptions>& out) {
  using Blink = playback::BlinkOptions;
  Blink blink;
  const auto parts = split(word, ':');
  constexpr auto kSeedMax = std::numeric_limits<std::uint64_t>::max();
  const bool good =
      parts.size() <= 3 && read_whole(parts[0], std::uint64_t{0}, kSeedMax, blink.seed) &&
      (parts.size() < 2 ||
       read_whole(parts[1], Blink::kIntervalMinMs, Blink::kIntervalMaxMs, blink.interval_ms)) &&
      (parts.size() < 3 ||
       read_whole(parts[2], Blink::kClosingMinMs, Blink::kClosingMaxMs, blink.closing_ms)) &&
      blink.closing_ms * 6 <= blink.interval_ms;
  if (!good) {
    return "is not SEED[:INTERVAL[:CLOSING]]: a number, then milliseconds, " +
           text_of_range(Blink::kIntervalMinMs, Blink::kIntervalMaxMs) +
           " from blink to blink and " + text_of_range(Blink::kClosingMinMs, Blink::kClosingMaxMs) +
           ", at most a sixth of that, to close the lids";
  }
  out = blink;
  return std::nullopt;
}

Complaint read_idle(const std::string& word, PlaybackOptions& playback) {
  playback.idle_seed = number_of<std::uint64_t>(word);
  if (!playback.idle_seed) return "is not a whole number";
  if (!playback.blink) playback.blink = playback::BlinkOptions{*playback.idle_seed};
  return std::nullopt;
}

}  // namespace

std::vector<OptionRow> face_rows(FaceOptions& face) {
  return {
      {.option = {"face", "NAME", "default"},
       .text = "name of a face (\"default\"), or the folder of one",
       .more = "The name of a face in data/faces, or the folder of any face.",
       .value = word(face.face),
       .heading = "Face"},
      {.option = {"mixer", "MIXER", "maximum"},
       .text = "for AUs sharing a muscle: maximum, average (maximum)",
       .more = "How contractions of one muscle by several AUs are combined: maximum or average.",
       .value = one_of<face::Mixer>(
           face.mixer, {{"maximum", face::Mixer::Maximum}, {"average", face::Mixer::Average}})},
  };
}

std::vector<OptionRow> rules_rows(FaceOptions& face) {
  return {
      {.option = {"rules", "RULES", "facs"},
       .text = "facs, kumar2010, none or FILE (facs)",
       .more = "The co-occurrence rules: facs, kumar2010 (as published), none, or a file.",
       .value = word(face.rules)},
      {.option = {"data", "DIR"},
       .text = "folder with faces, rules and streams",
       .more = "The folder with faces, rules and streams, if not the installed one.",
       .value = word(face.data)},
  };
}

std::vector<OptionRow> animation_rows(PlaybackOptions& playback) {
  using playback::Interpolation;
  return {
      {.option = {"speed", "MS"},
       .text = "how long keyframes without a time last (250)",
       .more = "How long keyframes without a time of their own last, 1 to 1000 ms. Without this "
               "option: 250 ms, or what the server says.",
       .value = whole(playback.speed, 1, kSpeedMaxMs),
       .heading = "Animation"},
      {.option = {"interpolation", "KIND", "linear"},
       .text = "linear or cosine (linear)",
       .more = "Between keyframes: linear or cosine.",
       .value = one_of<Interpolation>(playback.interpolation, {{"linear", Interpolation::Linear},
                                                               {"cosine", Interpolation::Cosine}})},
      {.option = {"blink", "SEED[:EVERY[:CLOSING]]"},
       .text = "random blinks (EVERY 4000 ms, CLOSING 100 ms)",
       .more = "Adds blinks: a seed for their random times, the mean interval (4000) and the time "
               "that the lids take to close (100), in ms.",
       .value = parsed(Kind::Word, read_blink, playback.blink)},
      {.option = {"idle", "SEED"},
       .text = "blinks, glances and breathing",
       .more = "Adds blinks (with this SEED, unless --blink is given), saccades and breathing.",
       .value = parsed(Kind::Number, read_idle, playback)},
  };
}

}  // namespace aucast::app
