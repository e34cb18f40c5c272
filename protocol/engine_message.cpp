#include "protocol/engine_message.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "common/check.h"
#include "common/number_of.h"
#include "common/text.h"
#include "protocol/server_chain.h"

namespace aucast::protocol {
namespace {

constexpr std::string_view kJoinWord = "join";
constexpr std::array<std::pair<std::string_view, EngineMessage::Kind>, 3> kKinds{{
    {"batch", EngineMessage::Kind::Batch},
    {"state", EngineMessage::Kind::State},
    {"since", EngineMessage::Kind::Since},
}};

/// Numbers of batches and places stay exact in every language that reads them.
constexpr std::uint64_t kNumberMax = (std::uint64_t{1} << 53U) - 1;

Error broken(std::string what) {
  return {ErrorKind::BadData, std::move(what)};
}

/// A line of words: the first alone, then `key=value`. Unknown keys are ignored.
class Line {
 public:
  explicit Line(std::string_view text) {
    const auto words = split_words(text);
    if (words.empty()) return;
    word_ = words.front();
    for (auto word = words.begin() + 1; word != words.end(); ++word) {
      const std::size_t equals = word->find('=');
      if (equals == std::string_view::npos) continue;
      values_.emplace(word->substr(0, equals), word->substr(equals + 1));
    }
  }

  [[nodiscard]] std::string_view word() const { return word_; }
  [[nodiscard]] bool has(std::string_view key) const { return values_.count(key) > 0; }
  [[nodiscard]] Result<std::uint64_t> number(std::string_view key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) return broken("its line has no " + std::string(key) + "=");
    const auto number = number_of<std::uint64_t>(found->second);
    if (!number || *number > kNumberMax) {
      return broken("its " + std::string(key) + "= is no number from 0 to 2^53-1");
    }
    return *number;
  }
  [[nodiscard]] Result<std::string> id(std::string_view key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) return broken("its line has no " + std::string(key) + "=");
    if (!is_server_id(found->second)) {
      return broken("its " + std::string(key) + "= is no ID of a server");
    }
    return std::string(found->second);
  }

 private:
  std::string_view word_;
  std::map<std::string_view, std::string_view> values_;
};

/// The line at the beginning of `bytes`, from which it is removed.
Result<std::string_view> take_line(std::string_view& bytes) {
  if (bytes.size() > kEngineBytesMax) {
    return broken("it has " + std::to_string(bytes.size()) + " bytes, and at most " +
                  std::to_string(kEngineBytesMax) + " are read");
  }
  const std::string_view text = bytes.substr(0, bytes.find('\n'));
  if (text.size() > kEngineLineBytesMax) return broken("it does not begin with a short line");
  bytes.remove_prefix(std::min(text.size() + 1, bytes.size()));
  return text;
}

/// The digits of the place in {a@PLACE ...} or {t@PLACE ...}.
struct PlaceField {
  std::uint64_t ms = 0;
  std::size_t length = 0;  ///< of its digits
};

constexpr std::size_t kPlaceBegin = 3;  ///< of its digits, after `{a@`

bool is_spoken(std::string_view packet) {
  return packet.starts_with("{a") || packet.starts_with("{t");
}

/// nullopt: it is another packet, or the place is invalid.
std::optional<PlaceField> place_of(std::string_view packet) {
  if (packet.size() <= kPlaceBegin || packet[2] != '@') return std::nullopt;
  const std::size_t end = std::min(packet.find_first_of(" }", kPlaceBegin), packet.size());
  const auto ms = number_of<std::uint64_t>(packet.substr(kPlaceBegin, end - kPlaceBegin));
  if (!ms) return std::nullopt;
  return PlaceField{*ms, end - kPlaceBegin};
}

}  // namespace

std::string encode(const EngineMessage& message) {
  AUCAST_CHECK(is_server_id(message.origin));
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                 [&](const auto& one) { return one.second == message.kind; });
  std::string text(kind->first);
  text += " origin=" + message.origin + " seq=" + std::to_string(message.seq) +
          " place=" + std::to_string(message.place_ms);
  if (message.kind == EngineMessage::Kind::Since) text += " after=" + std::to_string(message.after);
  return text + '\n' + message.packets;
}

std::string encode(const EngineJoin& join) {
  AUCAST_CHECK(join.origin.empty() || is_server_id(join.origin));
  std::string text(kJoinWord);
  if (!join.origin.empty()) text += " origin=" + join.origin;
  if (join.after) text += " after=" + std::to_string(*join.after);
  return text;
}

Result<EngineMessage> parse_engine_message(std::string_view bytes) {
  const auto text = take_line(bytes);
  if (!text) return text.error();
  const Line line(*text);
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                 [&line](const auto& one) { return one.first == line.word(); });
  if (kind == kKinds.end()) return broken("it begins with none of batch, state and since");
  EngineMessage message;
  message.kind = kind->second;
  auto origin = line.id("origin");
  if (!origin) return origin.error();
  message.origin = *std::move(origin);
  const auto seq = line.number("seq");
  if (!seq) return seq.error();
  message.seq = *seq;
  const auto place = line.number("place");
  if (!place) return place.error();
  message.place_ms = *place;
  if (message.kind == EngineMessage::Kind::Since) {
    const auto after = line.number("after");
    if (!after) return after.error();
    if (*after > message.seq) return broken("its after= is greater than its seq=");
    message.after = *after;
  }
  const bool whole = bytes.empty() || (bytes.front() == '{' && bytes.back() == '}');
  if (!whole) return broken("what follows its line are no whole packets");
  if (message.kind == EngineMessage::Kind::State && !bytes.starts_with("{hello ")) {
    return broken("it is a state without a hello");
  }
  message.packets = bytes;
  return message;
}

Result<EngineJoin> parse_engine_join(std::string_view bytes) {
  const auto text = take_line(bytes);
  if (!text) return text.error();
  const Line line(*text);
  if (line.word() != kJoinWord) return broken("it does not begin with join");
  EngineJoin join;
  if (line.has("origin")) {
    auto origin = line.id("origin");
    if (!origin) return origin.error();
    join.origin = *std::move(origin);
  }
  if (line.has("after")) {
    const auto after = line.number("after");
    if (!after) return after.error();
    join.after = *after;
  }
  return join;
}

std::string_view first_packet(std::string_view packets) {
  return packets.substr(0, std::min(packets.find('}'), packets.size() - 1) + 1);
}

std::string with_places_earlier(std::string_view packets, std::uint64_t by_ms) {
  std::string moved;
  moved.reserve(packets.size());
  while (!packets.empty()) {
    const std::string_view packet = first_packet(packets);
    packets.remove_prefix(packet.size());
    if (!is_spoken(packet)) {
      moved += packet;
      continue;
    }
    const auto place = place_of(packet);
    const bool caption = packet[1] == 't';
    if (!place || (place->ms < by_ms && !caption)) continue;
    moved.append(packet.substr(0, kPlaceBegin))
        .append(std::to_string(place->ms - std::min(place->ms, by_ms)))
        .append(packet.substr(kPlaceBegin + place->length));
  }
  return moved;
}

}  // namespace aucast::protocol
