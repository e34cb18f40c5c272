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

// === Encoding. Canonical output: no spaces, AUs ascending, equal sides joined, no `:100`.

/// {1,6,12,14}: the form for a level-1 peer, without sides, intensities and timing. AUs whose
/// stronger side is below `percent_min` are left out; {0} when nothing is left. Not for
/// changes-only keyframes.
[[nodiscard]] std::string encode_classic(const Keyframe& keyframe, int percent_min);

/// {1:30,R12:80;40@73400}: the whole keyframe, in canonical form.
[[nodiscard]] std::string encode(const Keyframe& keyframe);
[[nodiscard]] std::string encode(const End&);
[[nodiscard]] std::string encode(const HelloAsked& hello);
[[nodiscard]] std::string encode(const HelloGranted& hello);
[[nodiscard]] std::string encode(const ErrorReply& error);
/// Lists all streams with their details if that fits into one packet; else with their details but
/// without titles. If that does not fit either, or no details are known, lists as many bare names
/// as fit. Streams without a valid name are left out.
[[nodiscard]] std::string encode(const StreamList& list);
[[nodiscard]] std::string encode(const StreamsAsked& asked);
[[nodiscard]] std::string encode(const VoiceData& voice);
/// {t@PLACE DATA}, or {t@PLACE} for an empty text. The text must be that of a caption; it fits into
/// a packet with every place if is_caption() says so.
[[nodiscard]] std::string encode(const CaptionData& caption);
[[nodiscard]] std::string encode(Code code);

/// The percent of every AU on each side.
struct AuPercents {
  std::array<std::uint8_t, kAuCount> left{};
  std::array<std::uint8_t, kAuCount> right{};
};

/// A keyframe in every form in which it is sent.
struct EncodedKeyframe {
  std::string classic;
  std::string full;     ///< level 2
  std::string changes;  ///< level 2, for a client that got the previous keyframe: the changes-only
                        ///< form, or `full` where a full keyframe is due or that form saves nothing
  bool plain = false;   ///< AU numbers only: `classic` leaves out nothing but AUs below the minimum
};

/// Encodes the keyframes of one stream in their order; none of them may be changes-only. `changes`
/// equals `full` for the first keyframe, and whenever the times since the last full keyframe, those
/// of both ends included, would otherwise add up to more than kFullKeyframeEvery.
class KeyframeEncoder {
 public:
  /// An untimed keyframe takes `keyframe_ms`. `classic_min` is the `percent_min` of
  /// encode_classic().
  KeyframeEncoder(std::uint32_t keyframe_ms, int classic_min)
      : keyframe_ms_(keyframe_ms), classic_min_(classic_min) {}

  [[nodiscard]] EncodedKeyframe next(const Keyframe& keyframe);

 private:
  std::uint32_t keyframe_ms_;
  int classic_min_;
  std::optional<AuPercents> last_;
  std::uint64_t since_full_ms_ = 0;  ///< keyframe time since the last full one began
};

// === Text forms shared by stream files and command lines.

/// The form in which terms are written.
enum class TermSyntax : std::uint8_t {
  Wire,  ///< as in a packet: terms joined by ','
  Text,  ///< of stream files and command lines: also '+', blanks, and FACS letters without a colon
         ///< (1C+4B+L12D)
};

/// Why a text was refused, and the position of the wrong byte, counted from 0.
struct TextError {
  std::size_t position = 0;
  std::string reason;
  friend bool operator==(const TextError&, const TextError&) = default;
};

/// Reads the inside of a packet, without braces: `1,6,12` or `L12:80,4C;40@120`. Returns nullopt on
/// success, with the keyframe in `out`.
[[nodiscard]] std::optional<TextError> parse_keyframe(std::string_view text, TermSyntax syntax,
                                                      Keyframe& out);

/// Reads a set from a command line: `1,6,12`, `12:80,R14:50`, `{4C+9}`; FACS names may replace
/// numbers: `Lip Corner Puller:80`. Fails with a Usage error that names the column; timing and the
/// changes-only form are errors too.
[[nodiscard]] Result<AuFrame> parse_au_set(std::string_view typed);

/// The set as `1,6,R12:80`: canonical terms joined by commas, as `face-player rules` prints them.
[[nodiscard]] std::string format_au_set(const AuFrame& frame);

/// What is_stream_name() wants, for messages.
inline constexpr const char* kStreamNameRule = "1 to 64 letters, digits, '.', '_' or '-'";
/// Whether the text keeps kStreamNameRule.
[[nodiscard]] bool is_stream_name(std::string_view name);

}  // namespace aucast::protocol
