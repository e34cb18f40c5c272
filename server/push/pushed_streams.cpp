#include "server/push/pushed_streams.h"

#include <algorithm>
#include <utility>

#include <asio/post.hpp>

#include "common/log.h"
#include "server/settings/limits.h"
#include "server/upstream/repeated.h"

namespace aucast::server {

/// A name, and the stream that publishers send under it.
struct PushedStreams::Slot {
  Slot(asio::io_context& io, Reception::Options options, Reception::Events events)
      : name(options.name), reception(io, std::move(options), std::move(events)) {}

  std::string name;
  std::string publisher;  ///< the ID of the present or last publisher; may be empty
  std::string said;       ///< what was last logged about its publishers
  Reception reception;
};

PushedStreams::PushedStreams(asio::io_context& io, Options options, Events events)
    : io_(io), options_(std::move(options)), events_(std::move(events)) {}

PushedStreams::~PushedStreams() = default;

void PushedStreams::stop() {
  for (const auto& slot : slots_) slot->reception.stop();
}

std::shared_ptr<PushedStreams::Slot> PushedStreams::find(const std::string& name) const {
  const auto found = std::find_if(slots_.begin(), slots_.end(),
                                  [&name](const auto& slot) { return slot->name == name; });
  return found == slots_.end() ? nullptr : *found;
}

std::optional<protocol::ErrorReply> PushedStreams::refusal(
    const protocol::HelloAsked& hello) const {
  if (const auto slot = find(hello.publish)) {
    const bool same = !hello.relay.empty() && hello.relay == slot->publisher;
    if (!slot->reception.connected() || same) return std::nullopt;
    return protocol::ErrorReply{protocol::kNameTaken,
                                "another publisher sends the stream '" + hello.publish + "'"};
  }
  const bool room = slots_.size() < kPushedStreamsMax ||
                    std::any_of(slots_.begin(), slots_.end(),
                                [](const auto& slot) { return !slot->reception.connected(); });
  if (room) return std::nullopt;
  return protocol::ErrorReply{protocol::kBusy,
                              "as many streams are brought here as there is room for"};
}

void PushedStreams::take(std::shared_ptr<link::Link> link, const protocol::HelloAsked& hello,
                         std::string peer) {
  if (!find(hello.publish)) add(hello.publish);
  const auto slot = find(hello.publish);
  slot->reception.drop();
  slot->publisher = hello.relay;
  slot->reception.take_over(std::move(link), std::move(peer));
}

void PushedStreams::add(const std::string& name) {
  make_room();
  Reception::Options options;
  options.name = name;
  options.id = options_.id;
  options.wait = options_.wait;
  options.classic_min = options_.classic_min;
  options.sender = "publisher";
  Reception::Events events;
  events.on_moment = events_.on_moment;
  events.on_first = [this, name] { find(name)->said.clear(); };
  events.on_over = [this, name](const Parent::Outcome& outcome) { on_over(*find(name), outcome); };
  events.on_given_up = [this, name] { forget_later(name); };
  slots_.push_back(std::make_shared<Slot>(io_, std::move(options), std::move(events)));
  slots_.back()->reception.start();
  events_.on_changed();
}

/// Removes the oldest stream that nobody sends, if there are too many.
void PushedStreams::make_room() {
  if (slots_.size() < kPushedStreamsMax) return;
  const auto idle = std::find_if(slots_.begin(), slots_.end(),
                                 [](const auto& slot) { return !slot->reception.connected(); });
  if (idle == slots_.end()) return;
  spdlog::info("{}: it is forgotten, for another stream needs its room", (*idle)->name);
  retire(*idle);
}

void PushedStreams::on_over(Slot& slot, const Parent::Outcome& outcome) {
  const auto stream = slot.reception.shared();
  const bool other = outcome.unfit && stream->known();
  if (other || !slot.reception.whole()) {
    spdlog::log(
        level_of(outcome.reason, slot.said), "{}: {}: {}", slot.name,
        other ? "its publisher brings another stream of this name" : "its publisher is gone",
        outcome.reason);
  }
  if (other) {
    slot.reception.begin_anew();
    events_.on_changed();
    events_.on_moment();
  } else if (slot.reception.given_up()) {
    forget_later(slot.name);
  }
}

/// Later, since the slot itself is calling.
void PushedStreams::forget_later(const std::string& name) {
  asio::post(io_, [this, name] {
    const auto slot = find(name);
    // Somebody may have come meanwhile.
    if (!slot || slot->reception.connected() || !slot->reception.given_up()) return;
    retire(slot);
    events_.on_changed();
  });
}

void PushedStreams::give_way(const std::string& name) {
  const auto slot = find(name);
  if (!slot) return;
  spdlog::warn("{}: this server has a stream of that name itself now, and takes none", name);
  retire(slot);
}

/// Stops a slot and destroys it later: events of it that are queued find it stopped, but still
/// there.
void PushedStreams::retire(std::shared_ptr<Slot> slot) {
  std::erase(slots_, slot);
  slot->reception.end();
  asio::post(io_, [held = std::move(slot)] { static_cast<void>(held); });
}

std::vector<protocol::ServedStream> PushedStreams::streams() const {
  std::vector<protocol::ServedStream> all;
  for (const auto& slot : slots_) all.push_back(slot->reception.served());
  return all;
}

std::vector<UpstreamStatus> PushedStreams::statuses() const {
  std::vector<UpstreamStatus> all;
  for (const auto& slot : slots_) all.push_back(slot->reception.status());
  return all;
}

}  // namespace aucast::server
