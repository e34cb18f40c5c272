#include "server/engine/engine_origin.h"

#include <chrono>
#include <utility>

#include "common/log.h"
#include "common/random_digits.h"
#include "common/text.h"
#include "protocol/limits.h"
#include "protocol/server_chain.h"
#include "protocol/stream_choice.h"
#include "server/settings/limits.h"

namespace aucast::server {

using std::chrono::steady_clock;

namespace {

/// Of the ID by which edges tell one run from another.
constexpr std::size_t kRunIdDigits = 12;
static_assert(kRunIdDigits <= protocol::kServerIdBytesMax);

}  // namespace

EngineOrigin::EngineOrigin(asio::io_context& io, Options options, Catalogue catalogue)
    : options_(std::move(options)),
      catalogue_(std::move(catalogue)),
      batch_timer_(io),
      beat_timer_(io) {}

Result<void> EngineOrigin::start(const OpenBus& open) {
  auto bus =
      open({[this](const Bus::Message& message) { on_message(message); },
            [this](const std::string& server) {
              connected_ = true;
              spdlog::info("{}: published over NATS at {}", options_.stream, escaped(server));
            },
            [this] {
              connected_ = false;
              spdlog::warn("{}: the connection to NATS is lost; another server is tried",
                           options_.stream);
            }});
  if (!bus) return bus.error();
  bus_ = *std::move(bus);
  bus_->subscribe(join_subject(options_.stream));
  await_beat();
  return {};
}

void EngineOrigin::stop() {
  end();
  stopped_ = true;
  batch_timer_.cancel();
  beat_timer_.cancel();
  bus_.reset();
}

/// What a client that asks for no name would get, if it is live.
std::shared_ptr<const protocol::LiveChannel> EngineOrigin::channel() {
  protocol::HelloAsked asked;
  // Asked as a relay, so that the servers which it comes through are told on.
  asked.relay = "nats";
  const auto catalogue = catalogue_();
  auto choice = protocol::choose_stream(*catalogue, asked);
  if (choice.state == protocol::StreamChoice::State::Refused) say_why_not(choice.refusal.text);
  if (choice.state != protocol::StreamChoice::State::Ready) return nullptr;
  const protocol::ServedStream& stream = choice.stream;
  const auto& live = stream.live();
  if (!live) {
    say_why_not("it is recorded where it comes from (--live there)");
    return nullptr;
  }
  if (live != channel_) {
    hello_ = {};
    hello_.delta = live->has_changes();
    hello_.stream = options_.stream;
    hello_.live = true;
    hello_.duration_ms = live->duration_ms();
    hello_.keyframe_ms =
        stream.upstream() != nullptr ? stream.upstream()->keyframe_ms : catalogue->keyframe_ms;
    if (live->has_voice()) hello_.voice = protocol::kVoiceCodec;
    hello_.text = live->has_captions();
    hello_.title = stream.title;
    begin(live);
  }
  // The channel of a relay stays when its next parent gets the stream by another way.
  hello_.servers = servers_told(*catalogue, stream, asked);
  said_why_not_.clear();
  return channel_;
}

/// Called at every keyframe: says a reason once for as long as it lasts.
void EngineOrigin::say_why_not(const std::string& why) {
  if (std::exchange(said_why_not_, why) == why) return;
  spdlog::error("{}: it is not published: {}", options_.stream, why);
}

void EngineOrigin::end() {
  if (!batches_) return;
  batches_->collect_end();
  if (batches_->waiting_bytes() > 0) flush();
}

/// Another channel has a clock of its own: the edges join anew.
void EngineOrigin::begin(const std::shared_ptr<const protocol::LiveChannel>& channel) {
  end();
  channel_ = channel;
  batches_.emplace(random_digits(kRunIdDigits));
}

void EngineOrigin::on_moment() {
  if (stopped_) return;
  const auto now_live = channel();
  if (!now_live) {
    // What was published until now has ended, however long its channel is kept.
    end();
    return;
  }
  batches_->collect(*now_live);
  if (now_live->ended()) batches_->collect_end();
  if (batches_->waiting_bytes() > 0) flush_soon();
}

void EngineOrigin::flush_soon() {
  if (options_.batch.count() == 0 || batches_->waiting_bytes() > kBatchBytesMax) {
    flush();
    return;
  }
  if (std::exchange(batch_begun_, true)) return;
  batch_timer_.after(options_.batch, [this] { flush(); });
}

/// Without a connection too: who misses it asks for it later, and nothing old is sent by itself.
void EngineOrigin::flush() {
  batch_begun_ = false;
  batch_timer_.cancel();
  const std::string batch = batches_->next_batch();
  if (connected_) bus_->send({batch_subject(options_.stream), "", batch});
  await_beat();
}

void EngineOrigin::await_beat() {
  beat_timer_.after(kBeat, [this] {
    if (batches_ && batches_->running()) {
      flush();
    } else {
      await_beat();
    }
  });
}

void EngineOrigin::on_message(const Bus::Message& message) {
  if (stopped_ || !batches_ || message.reply_to.empty() || !may_answer()) return;
  const auto join = protocol::parse_engine_join(message.bytes);
  if (!join) {
    spdlog::debug("{}: a question makes no sense: {}", options_.stream, join.error().message);
    return;
  }
  const auto answer = batches_->answer(*join, hello_);
  if (answer) bus_->send({message.reply_to, "", *answer});
}

bool EngineOrigin::may_answer() {
  const Instant now = steady_clock::now();
  if (now - second_begin_ >= std::chrono::seconds(1)) {
    second_begin_ = now;
    answers_ = 0;
  }
  if (++answers_ <= kAnswersPerSecond) return true;
  ++unanswered_;
  return false;
}

void EngineOrigin::describe(Status& status) const {
  if (!status.engine) status.engine.emplace();
  if (bus_) status.engine->messages_left_out += bus_->left_out();
  status.engine->questions_left_out += unanswered_;
}

}  // namespace aucast::server
