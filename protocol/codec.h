#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "common/result.h"
#include "protocol/packet.h"

namespace aucast::protocol {

// === Encoding. Canonical output: no spaces, numbers ascending, equal sides joined, 100 omitted.

/// {1,6,12,14}: what a level-1 peer reads. AUs whose larger side is below `percent_min` are left
/// out, sides, intensities and timing are dropped; {0} when nothing is left. Not for changes-only
/// keyframes.
[[nodiscard]] std::string encode_classic(const Keyframe& keyframe, int percent_min);

/// {1:30,R12:80;40@73400}: everything the keyframe holds, in canonical form.
[[nodiscard]] std::string encode(const Keyframe& keyframe);
[[nodiscard]] std::string encode(const End&);
[[nodiscard]] std::string encode(const HelloAsked& hello);
[[nodiscard]] std::string encode(const HelloGranted& hello);
[[nodiscard]] std::string encode(const ErrorReply& error);
/// With all that is known of the streams, if that fits into one packet with all of them; else
/// without the titles; else, as where nothing is known, the names alone, as many as fit. Streams
/// whose name is none are left out.
[[nodiscard]] std::string encode(const StreamList& list);
[[nodiscard]] std::string encode(const StreamsAsked& asked);
[[nodiscard]] std::string encode(const VoiceData& voice);
/// {t@PLACE DATA}, or {t@PLACE} of an empty one. The text must be a caption (is_caption()).
[[nodiscard]] std::string encode(const CaptionData& caption);
[[nodiscard]] std::string encode(Code code);

/// The percent of every AU on each side.
struct AuPercents {
  std::array<std::uint8_t, kAuCount> left{};
  std::array<std::uint8_t, kAuCount> right{};
};

/// A keyframe in every form that is sent.
struct EncodedKeyframe {
  std::string classic;
  std::string full;     ///< level 2
  std::string changes;  ///< level 2, for a client that got the previous one; full where that is due
                        ///< or shorter
  bool plain = false;   ///< numbers only: classic leaves out none but those below its minimum
};

/// Encodes the keyframes of one stream in their order, none of them changes-only. `changes` is full
/// for the first one, and for those after which more than kFullKeyframeEvery would have passed
/// since the last full one.
class KeyframeEncoder {
 public:
  /// Untimed keyframes count as `keyframe_ms`; `classic_min` as in encode_classic().
  KeyframeEncoder(std::uint32_t keyframe_ms, int classic_min)
      : keyframe_ms_(keyframe_ms), classic_min_(classic_min) {}

  [[nodiscard]] EncodedKeyframe next(const Keyframe& keyframe);

 private:
  std::uint32_t keyframe_ms_;
  int classic_min_;
  std::optional<AuPercents> last_;
  std::uint64_t since_full_ms_ = 0;  ///< from the beginning of the last full one to now
};

// === Text forms shared by stream files and command lines.

/// What a text form allows beyond the wire's form.
enum class TermSyntax : std::uint8_t {
  Wire,  ///< as in a packet: terms joined by ','
  Text,  ///< stream files, command lines: '+' too, FACS letters without colon (1C+4B+L12D), blanks
};

/// A refused text: what is wrong, and the 0-based position of the byte where it stands.
struct TextError {
  std::size_t position = 0;
  std::string reason;
  friend bool operator==(const TextError&, const TextError&) = default;
};

/// Reads the inside of a packet, without braces: `1,6,12` or `L12:80,4C;40@120`. On success the
/// keyframe is in `out` and nothing is returned.
[[nodiscard]] std::optional<TextError> parse_keyframe(std::string_view text, TermSyntax syntax,
                                                      Keyframe& out);

/// An AU set from a command line: `1,6,12`, `12:80,R14:50`, `{4C+9}`; FACS names may stand for
/// numbers: `Lip Corner Puller:80`. Usage error with the column. Timing and the changes-only form
/// are refused.
[[nodiscard]] Result<AuFrame> parse_au_set(std::string_view typed);

/// `1,6,R12:80`: canonical terms joined by commas, as `face-player rules` prints them.
[[nodiscard]] std::string format_au_set(const AuFrame& frame);

/// True for 1-64 letters, digits, '.', '_' or '-'.
[[nodiscard]] bool is_stream_name(std::string_view name);

}  // namespace aucast::protocol
