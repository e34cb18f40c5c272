#include "server/engine/outgoing_batches.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "protocol/codec.h"
#include "protocol/packet.h"

namespace aucast::server {
namespace {

using protocol::EngineMessage;

/// A voice packet with its place, so that an edge can begin with any batch.
std::string placed(const protocol::EncodedVoice& voice) {
  constexpr std::string_view kOpening = "{a";
  std::string packet(kOpening);
  packet += '@' + std::to_string(std::max(voice.begin, Milliseconds(0)).count());
  return packet + voice.continued.substr(kOpening.size());
}

}  // namespace

void OutgoingBatches::collect(const protocol::LiveChannel& channel) {
  for (const protocol::LiveMoment& moment : channel.latest()) {
    if (last_moment_ && moment.number <= *last_moment_) continue;
    const bool follows = last_moment_ && moment.number == *last_moment_ + 1 && !ended_;
    collect_spoken(channel);
    waiting_ += follows && channel.has_changes() ? moment.changes : moment.full;
    last_moment_ = moment.number;
    full_ = moment.full;
    full_begin_ = moment.begin;
    end_ = moment.begin + moment.time;
    ended_ = false;
  }
  if (last_moment_) collect_spoken(channel);
}

void OutgoingBatches::collect_spoken(const protocol::LiveChannel& channel) {
  next_caption_ = std::max(next_caption_, channel.captions().first_number());
  while (const protocol::CaptionData* const caption = channel.captions().find(next_caption_)) {
    caption_ = encode(*caption);
    waiting_ += caption_;
    ++next_caption_;
  }
  next_voice_ = std::max(next_voice_, channel.voice().first_number());
  while (const protocol::EncodedVoice* const voice = channel.voice().find(next_voice_)) {
    waiting_ += placed(*voice);
    ++next_voice_;
  }
}

void OutgoingBatches::collect_end() {
  if (!running()) return;
  waiting_ += encode(protocol::End{});
  ended_ = true;
}

std::string OutgoingBatches::next_batch() {
  Kept batch{++seq_, waiting_place_, std::exchange(waiting_, {})};
  waiting_place_ = end_;
  sent_ = {full_, full_begin_, caption_};
  const auto place = static_cast<std::uint64_t>(batch.place.count());
  std::string bytes = encode(
      EngineMessage{EngineMessage::Kind::Batch, origin_, batch.seq, place, 0, batch.packets});
  keep(std::move(batch));
  return bytes;
}

void OutgoingBatches::keep(Kept batch) {
  kept_bytes_ += batch.packets.size();
  kept_.push_back(std::move(batch));
  const auto past = [this] {
    return kept_.front().place < end_ - kKept || kept_bytes_ > kKeptBytesMax ||
           kept_.size() > kKeptMax;
  };
  while (!kept_.empty() && past()) {
    kept_bytes_ -= kept_.front().packets.size();
    kept_.pop_front();
  }
}

/// What the batches after that one held, if all of them are still there.
std::optional<std::string> OutgoingBatches::since(std::uint64_t after) const {
  if (after > seq_ || (after < seq_ && (kept_.empty() || kept_.front().seq > after + 1))) {
    return std::nullopt;
  }
  EngineMessage message{EngineMessage::Kind::Since, origin_, seq_, 0, after, {}};
  message.place_ms = static_cast<std::uint64_t>(waiting_place_.count());
  for (auto batch = kept_.rbegin(); batch != kept_.rend() && batch->seq > after; ++batch) {
    message.packets.insert(0, batch->packets);
    message.place_ms = static_cast<std::uint64_t>(batch->place.count());
  }
  return encode(message);
}

std::optional<std::string> OutgoingBatches::answer(const protocol::EngineJoin& join,
                                                   const protocol::HelloGranted& hello) const {
  if (!join.origin.empty() && join.origin != origin_) return std::nullopt;
  if (join.after && !join.origin.empty()) {
    if (auto missed = since(*join.after)) return missed;
  }
  if (sent_.full.empty() || ended_) return std::nullopt;
  const auto place = static_cast<std::uint64_t>(sent_.begin.count());
  return encode(EngineMessage{EngineMessage::Kind::State, origin_, seq_, place, 0,
                              encode(hello) + sent_.caption + sent_.full});
}

}  // namespace aucast::server
