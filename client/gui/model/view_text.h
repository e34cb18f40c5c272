#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/face/au_blender.h"
#include "client/face/face.h"
#include "client/gui/model/gui_model.h"
#include "client/playback/keyframe_buffers.h"
#include "client/playback/keyframe_source.h"
#include "client/playback/playback.h"
#include "common/time.h"
#include "protocol/packet.h"

namespace aucast::gui {

// Turns the player's numbers into texts. Pure.

[[nodiscard]] Activity activity_of(playback::PlaybackState state,
                                   const playback::SourceStatus& status);

/// "playing", "paused" and so on; Buffering counts as "playing".
[[nodiscard]] std::string state_name(playback::PlaybackState state);

/// "connecting" or "reconnecting"; empty: neither.
[[nodiscard]] std::string connecting_in_words(playback::PlaybackState state,
                                              const playback::SourceStatus& status);

/// "connecting", "reconnecting", "buffering 42 %", "playing", "paused", "stalled", "ended",
/// "stopped" or "lost". The percentage is of what must be buffered before playing begins.
[[nodiscard]] std::string state_in_words(playback::PlaybackState state,
                                         const playback::SourceStatus& status,
                                         const playback::BufferOptions& buffers);

/// Whether something other than the server or the user has ended the stream.
[[nodiscard]] bool went_wrong(playback::EndReason end);

/// Whether the server was lost, and what it sent before is still being played.
[[nodiscard]] bool plays_the_rest(playback::PlaybackState state,
                                  const playback::SourceStatus& status);

/// "live"; for a recorded stream its length, "1:23", or "recorded" if the length is not known;
/// empty: the server does not say whether the stream is live.
[[nodiscard]] std::string stream_in_words(const protocol::ListedStream& stream);

/// "30 keyframes/s, gain 150 %": the settings that change how a table is read; empty: none does.
[[nodiscard]] std::string table_in_words(const TableSettings& settings);

/// "0 B", "999 B", "1.2 kB", "3.4 MB".
[[nodiscard]] std::string bytes_text(double bytes);

/// "320 bit/s", "1.2 kbit/s".
[[nodiscard]] std::string bit_rate_text(double bytes_a_second);

/// A place in a stream file: "1:05.25".
[[nodiscard]] std::string time_text(Duration time);

/// With two decimals and the decimal point of the language in use: "1.25".
[[nodiscard]] std::string seconds_text(double seconds);

/// "893 B, 1.2 kbit/s"; if `rate` is 0, with the mean since the beginning: "893 B, mean 310 bit/s".
/// `rate` and `mean` are in bytes a second.
[[nodiscard]] std::string traffic_text(std::uint64_t bytes, double rate, double mean);

/// The name of an AU as au_name() takes it: that of FACS, else the one that the user has saved it
/// with. Empty if it has neither.
[[nodiscard]] std::string saved_au_name(int number, const face::AuRecordings& recordings);
/// The name of an AU as the panels show it: in the language in use, or the user's own.
[[nodiscard]] std::string au_name_of(const GuiModel& model, int number);

/// What a rule read and what it changed: "51 100 % and 52 40 %: 51 60 %, 52 gone".
[[nodiscard]] std::string effect_in_words(const face::RuleExplained& one);

/// The AUs of a keyframe as they came and as the face shows them, ascending; if an AU's sides
/// differ, each has its own row. `rules`: those that changed something. An AU without a recording
/// is not shown by the face.
[[nodiscard]] std::vector<AuRow> au_rows(const AuFrame& received, const AuFrame& shown,
                                         std::span<const face::RuleExplained> rules,
                                         const face::AuRecordings& recordings);

}  // namespace aucast::gui
