#include "client/gui/model/view_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "client/gui/texts/texts.h"
#include "common/text.h"

namespace aucast::gui {
namespace {

using playback::EndReason;
using playback::PlaybackState;

bool awaits_connection(PlaybackState state, const playback::SourceStatus& status) {
  return state == PlaybackState::Buffering && !status.connected &&
         status.end == EndReason::NotEnded;
}

/// With the point of the language in use, in a text in which nothing else is a point.
std::string in_its_writing(std::string text) {
  if (const std::size_t point = text.find('.'); point != std::string::npos) {
    text.replace(point, 1, tr("unit.point"));
  }
  return text;
}

/// For 1234 and "B": "1.2 kB".
std::string scaled(double value, const char* unit) {
  constexpr std::array kFactors = {"", "k", "M", "G"};
  std::size_t factor = 0;
  while (value >= 999.95 && factor + 1 < kFactors.size()) {
    value /= 1000;
    ++factor;
  }
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), factor == 0 ? "%.0f %s%s" : "%.1f %s%s", value,
                kFactors[factor], unit);
  return in_its_writing(text.data());
}

bool names(const std::vector<int>& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

std::string shares(const std::vector<face::AuShare>& all) {
  std::string text;
  for (const face::AuShare& one : all) {
    const std::string share = std::to_string(one.number) + " " + std::to_string(one.percent) + " %";
    text = text.empty() ? share : tr("rule.and", text, share);
  }
  return text;
}

std::string outcome(const std::vector<face::AuShare>& all) {
  std::string text;
  for (const face::AuShare& one : all) {
    text += (text.empty() ? "" : ", ") + std::to_string(one.number) + " ";
    text += one.percent > 0 ? std::to_string(one.percent) + " %" : std::string(tr("rule.gone"));
  }
  return text;
}

/// The rules that concern an AU on a side, each once: "opposition: 51 100 % and 52 40 %: 51 60 %,
/// 52 gone".
std::string reasons(int number, Side side, std::span<const face::RuleExplained> rules) {
  std::string text;
  for (const face::RuleExplained& one : rules) {
    const bool on_this_side = side == Side::Both || one.side == Side::Both || one.side == side;
    const bool about_it = names(one.rule->sources, number) || names(one.rule->targets, number);
    if (!on_this_side || !about_it) continue;
    const std::string why =
        tr("rule.what", data_word(std::string(face::name(one.rule->kind))), effect_in_words(one));
    if (text.find(why) != std::string::npos) continue;
    if (!text.empty()) text += "; ";
    text += why;
  }
  return text;
}

AuRow row_of(int number, Side side, float received, float shown,
             std::span<const face::RuleExplained> rules, const face::AuRecordings& recordings) {
  AuRow row;
  row.label = (side == Side::Left ? "L" : side == Side::Right ? "R" : "") + std::to_string(number);
  row.name = au_name(number, saved_au_name(number, recordings));
  row.received_percent = percent_of(received);
  row.shown_percent = percent_of(shown);
  if (row.received_percent != row.shown_percent) row.why = reasons(number, side, rules);
  return row;
}

}  // namespace

std::string saved_au_name(int number, const face::AuRecordings& recordings) {
  if (const auto name = facs_name(number)) return std::string(*name);
  const auto saved = recordings.find(number);
  return saved == recordings.end() ? std::string() : saved->second.note;
}

std::string au_name_of(const GuiModel& model, int number) {
  if (model.known_aus != nullptr) {
    for (const AuEntry& entry : *model.known_aus) {
      if (entry.number == number) return au_name(number, entry.name);
    }
  }
  return au_name(number);
}

std::string effect_in_words(const face::RuleExplained& one) {
  return tr("rule.effect", shares(one.before), outcome(one.after));
}

bool went_wrong(EndReason end) {
  return end != EndReason::NotEnded && end != EndReason::EndOfStream && end != EndReason::Stopped;
}

Activity activity_of(PlaybackState state, const playback::SourceStatus& status) {
  switch (state) {
    case PlaybackState::Buffering:
      return awaits_connection(state, status) ? Activity::Connecting : Activity::Playing;
    case PlaybackState::Playing:
    case PlaybackState::Stalled:
    case PlaybackState::Stale:
      return Activity::Playing;
    case PlaybackState::Paused:
      return Activity::Paused;
    case PlaybackState::Ended:
    case PlaybackState::Stopped:
    case PlaybackState::Lost:
      return Activity::Over;
  }
  return Activity::Over;
}

std::string state_name(PlaybackState state) {
  switch (state) {
    case PlaybackState::Buffering:
    case PlaybackState::Playing:
      return tr("state.playing");
    case PlaybackState::Paused:
      return tr("state.paused");
    case PlaybackState::Stalled:
      return tr("state.stalled");
    case PlaybackState::Stale:
      return tr("state.stale");
    case PlaybackState::Ended:
      return tr("state.ended");
    case PlaybackState::Stopped:
      return tr("state.stopped");
    case PlaybackState::Lost:
      return tr("state.lost");
  }
  return {};
}

std::string connecting_in_words(PlaybackState state, const playback::SourceStatus& status) {
  if (awaits_connection(state, status)) {
    return tr(status.reconnects > 0 ? TextKey("state.reconnecting") : TextKey("state.connecting"));
  }
  const bool waits = state == PlaybackState::Stalled || state == PlaybackState::Stale;
  if (waits && !status.connected && status.reconnects > 0 && status.end == EndReason::NotEnded) {
    return tr("state.reconnecting");
  }
  return {};
}

std::string state_in_words(PlaybackState state, const playback::SourceStatus& status,
                           const playback::BufferOptions& buffers) {
  if (std::string connecting = connecting_in_words(state, status); !connecting.empty()) {
    return connecting;
  }
  const bool came = status.keyframes_received > 0;
  const bool refused = status.end == EndReason::Unreachable || status.end == EndReason::Refused;
  if (state == PlaybackState::Lost && refused && !came) return tr("state.none");
  if (state == PlaybackState::Buffering) {
    const std::size_t threshold = playback::threshold_of(buffers);
    const std::size_t there = std::min(threshold, status.receiver_fill + status.playout_fill);
    return tr("state.buffering", there * 100 / threshold);
  }
  return state_name(state);
}

bool plays_the_rest(PlaybackState state, const playback::SourceStatus& status) {
  const bool tried_again = !status.connected && status.reconnects > 0;
  return state == PlaybackState::Playing && (went_wrong(status.end) || tried_again);
}

std::string stream_in_words(const protocol::ListedStream& stream) {
  if (stream.live.value_or(false)) return tr("play.is_live");
  if (stream.duration_ms) return length_text(Milliseconds(*stream.duration_ms));
  return stream.live ? tr("play.is_recorded") : "";
}

std::string table_in_words(const TableSettings& settings) {
  std::string text;
  const auto add = [&](int value, const std::string& words) {
    if (value != 0) text += (text.empty() ? "" : ", ") + words;
  };
  add(settings.fps, tr("file.fps_is", settings.fps));
  add(settings.rate, tr("file.rate_is", settings.rate));
  add(settings.gain_percent, tr("file.gain_is", settings.gain_percent));
  add(settings.neutral_s, tr("file.neutral_is", settings.neutral_s));
  return text;
}

std::string bytes_text(double bytes) {
  return scaled(bytes, tr("unit.bytes"));
}

std::string bit_rate_text(double bytes_a_second) {
  return scaled(8 * bytes_a_second, tr("unit.bit_rate"));
}

std::string time_text(Duration time) {
  // Rounded before it is split, or a moment before a minute would be "0:60.00".
  const long long hundredths = std::llround(100 * seconds(time));
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%lld:%02lld.%02lld", hundredths / 6000,
                hundredths / 100 % 60, hundredths % 100);
  return text.data();
}

std::string seconds_text(double seconds) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.2f", seconds);
  return in_its_writing(text.data());
}

std::string traffic_text(std::uint64_t bytes, double rate, double mean) {
  const std::string text = bytes_text(static_cast<double>(bytes));
  if (rate > 0) return tr("state.rate", text, bit_rate_text(rate));
  if (mean > 0) return tr("state.mean", text, bit_rate_text(mean));
  return text;
}

std::vector<AuRow> au_rows(const AuFrame& received, const AuFrame& shown,
                           std::span<const face::RuleExplained> rules,
                           const face::AuRecordings& recordings) {
  std::vector<AuRow> rows;
  // Asked at every tick of the window: of most AUs there is nothing to say, so no row is made.
  const auto add = [&](int number, Side side, float before, float after) {
    if (percent_of(before) + percent_of(after) == 0) return;
    AuRow row = row_of(number, side, before, after, rules, recordings);
    if (!recordings.contains(number)) {
      row.shown_percent = 0;
      row.why = tr("state.no_au", number);
    }
    rows.push_back(std::move(row));
  };
  for (std::size_t i = 1; i < kAuCount; ++i) {
    const int number = static_cast<int>(i);
    const bool alike = received.left[i] == received.right[i] && shown.left[i] == shown.right[i];
    if (alike) {
      add(number, Side::Both, received.left[i], shown.left[i]);
      continue;
    }
    add(number, Side::Left, received.left[i], shown.left[i]);
    add(number, Side::Right, received.right[i], shown.right[i]);
  }
  return rows;
}

}  // namespace aucast::gui
