#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/au_numbers.h"
#include "protocol/stream_file.h"
#include "speaker/cues.h"
#include "speaker/performance.h"

namespace aucast::speaker {

/// Says the script's words one second apart, from 2 s on, without a sound that moves the lips.
inline Speech a_word_each_second(const Script& script) {
  Speech speech;
  const Characters text(script.text);
  Milliseconds begin{2000};
  for (std::size_t i = 0; i < text.count(); ++i) {
    if (text.part(i, 1) == " " || text.part(i, 1) == "\n") continue;
    std::size_t length = 1;
    while (text.part(i + length, 1) != " " && text.part(i + length, 1) != "\n") ++length;
    speech.words.push_back({begin, i, length});
    begin += Milliseconds(1000);
    i += length;
  }
  speech.samples.resize(static_cast<std::size_t>((begin.count() + 2000) * speech.rate / 1000));
  return speech;
}

class Performed {
 public:
  explicit Performed(const std::string& text, float amount = 0) {
    const Expressions expressions{{"brows", {{kOuterBrowRaiser, Side::Both, 80}}},
                                  {"smirk", {{kLipCornerPuller, Side::Left, 100}}},
                                  {"gape", {{kJawDrop, Side::Both, 100}}},
                                  {"neutral", {{0, Side::Both, 100}}}};
    auto script = parse_script(text, "t");
    EXPECT_TRUE(script);
    EXPECT_TRUE(check_cues(*script, expressions, "t"));
    const Speech speech = a_word_each_second(*script);
    length_ = speech.length();
    stream_ = perform(speech, *script, expressions, {.seed = 1, .amount = amount});
  }

  [[nodiscard]] const std::vector<protocol::Keyframe>& keyframes() const {
    return stream_.keyframes;
  }
  [[nodiscard]] Milliseconds length() const { return length_; }

  /// In percent, as a player shows it that draws straight lines.
  [[nodiscard]] double at(int ms, int au, Side side = Side::Both) const {
    double from = 0;
    std::uint32_t begin = 0;
    for (const protocol::Keyframe& keyframe : stream_.keyframes) {
      double to = 0;
      for (const AuTerm& term : keyframe.terms) {
        if (term.number == au && term.side == side) to = term.percent;
      }
      const std::uint32_t end = begin + *keyframe.time_ms;
      if (static_cast<std::uint32_t>(ms) <= end) {
        return from + (to - from) * (ms - static_cast<double>(begin)) / *keyframe.time_ms;
      }
      from = to;
      begin = end;
    }
    return from;
  }

 private:
  protocol::StreamFile stream_;
  Milliseconds length_{0};
};

}  // namespace aucast::speaker
