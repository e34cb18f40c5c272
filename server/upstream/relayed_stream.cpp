#include "server/upstream/relayed_stream.h"

#include <utility>

#include "protocol/codec.h"
#include "protocol/limits.h"

namespace aucast::server {
namespace {

std::string ms_text(std::uint64_t ms) {
  return std::to_string(ms) + " ms";
}

const char* kind_of(bool live) {
  return live ? "live" : "recorded";
}

const char* end_of(bool loop) {
  return loop ? "starts again at its end (--loop)" : "ends";
}

}  // namespace

RelayedStream::RelayedStream(Options options)
    : options_(std::move(options)), shared_(std::make_shared<protocol::UpstreamStream>()) {
  shared_->name = options_.name;
  shared_->patience = options_.patience;
}

protocol::HelloAsked RelayedStream::asked() const {
  protocol::HelloAsked asked;
  asked.window = protocol::kWindowMax;
  asked.stream = shared_->name;
  asked.delta = true;
  asked.from_ms = place_ms();
  asked.voice = protocol::kVoiceCodec;
  asked.text = true;
  asked.loop = true;
  return asked;
}

std::optional<std::string> RelayedStream::objection(const protocol::HelloGranted& hello) const {
  const std::string& name = shared_->name;
  if (!name.empty() && !hello.stream.empty() && hello.stream != name) {
    return "it sends the stream '" + hello.stream + "', asked was '" + name + "'";
  }
  if (name.empty() && hello.stream.empty()) {
    return "it does not say its stream's name; ask for one by aucast://HOST/STREAM";
  }
  if (begun() && hello.live != live()) {
    return std::string("its stream is ") + kind_of(hello.live) + ", and what is served here is " +
           kind_of(live());
  }
  if (begun() && hello.keyframe_ms != shared_->keyframe_ms) {
    return "its keyframes without a time take " + ms_text(hello.keyframe_ms) +
           ", and what is served here has " + ms_text(shared_->keyframe_ms);
  }
  if (hello.live) return std::nullopt;
  if (!hello.duration_ms) return "it does not say how long its stream is";
  if (hello.loop && *hello.duration_ms == 0) {
    return "its stream takes no time at all, so it cannot start again and again";
  }
  if (begun() && hello.loop != shared_->loop) {
    return std::string("its stream ") + end_of(hello.loop) + ", and what is served here " +
           end_of(shared_->loop);
  }
  if (begun() && hello.duration_ms != recording_->duration_ms()) {
    return "its stream takes " + ms_text(*hello.duration_ms) + ", and what is served here " +
           ms_text(recording_->duration_ms());
  }
  if (hello.from_ms != place_ms()) {
    return "it begins at " + ms_text(hello.from_ms) + ", asked was " + ms_text(place_ms());
  }
  return std::nullopt;
}

std::optional<std::string> RelayedStream::begin(const protocol::HelloGranted& hello) {
  if (auto wrong = objection(hello)) return wrong;
  if (shared_->name.empty() && options_.take_name && !options_.take_name(hello.stream)) {
    return "its first stream is '" + hello.stream +
           "', and another one here has that name; ask for one by aucast://HOST/STREAM, or leave "
           "one out";
  }
  shared_->servers = hello.servers;
  if (begun()) {
    if (recording_) recording_->go_on();
    if (feed_) shift_ = feed_->end_of_newest();
    return std::nullopt;
  }
  if (shared_->name.empty()) shared_->name = hello.stream;
  shared_->keyframe_ms = hello.keyframe_ms;
  shared_->title = hello.title;
  shared_->loop = hello.loop && !hello.live;
  recording_.reset();
  if (hello.live) {
    feed_ = std::make_shared<protocol::LiveFeed>(hello.keyframe_ms, options_.classic_min,
                                                 hello.voice == protocol::kVoiceCodec, hello.text,
                                                 hello.duration_ms);
    shared_->content = feed_;
  } else {
    recording_.emplace(hello, options_.may_hold);
  }
  return std::nullopt;
}

void RelayedStream::begin_call() {
  if (feed_) feed_->begin_moments();
}

std::optional<std::string> RelayedStream::add(const protocol::DeliverKeyframe& keyframe,
                                              std::string_view packet) {
  const std::uint32_t time_ms = keyframe.time_ms.value_or(shared_->keyframe_ms);
  const protocol::Keyframe state{canonical_terms(keyframe.aus), false, keyframe.time_ms,
                                 keyframe.place_ms};
  protocol::EncodedKeyframe encoded;
  encoded.classic = encode_classic(state, options_.classic_min);
  encoded.full = keyframe.changes_only ? encode(state) : std::string(packet);
  encoded.changes = packet;
  if (feed_) {
    feed_->add(std::move(encoded), Milliseconds(time_ms));
    return std::nullopt;
  }
  auto wrong = recording_->add(encoded, time_ms);
  if (!wrong) show_recording();
  return wrong;
}

void RelayedStream::show_recording() {
  if (!shared_->known()) shared_->content = recording_->content();
}

std::optional<std::string> RelayedStream::add(const protocol::DeliverVoice& voice) {
  if (!feed_) return recording_->add(voice.packet);
  feed_->add_voice({voice.packet.place + shift_, voice.packet.opus});
  return std::nullopt;
}

std::optional<std::string> RelayedStream::add(const protocol::DeliverCaption& caption) {
  if (!feed_) return recording_->add(caption.caption);
  const auto place = Milliseconds(caption.caption.place_ms) + shift_;
  feed_->add_caption({static_cast<std::uint64_t>(place.count()), caption.caption.text});
  return std::nullopt;
}

std::optional<std::string> RelayedStream::end() {
  if (!recording_) return std::nullopt;
  auto wrong = recording_->end();
  if (!wrong) show_recording();
  return wrong;
}

void RelayedStream::give_up() {
  if (feed_) feed_->end();
  if (recording_) recording_->break_off();
}

}  // namespace aucast::server
