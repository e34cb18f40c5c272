#include "server/upstream/relayed_stream.h"

#include <algorithm>
#include <utility>

#include "protocol/codec.h"
#include "protocol/limits.h"
#include "server/settings/limits.h"

namespace aucast::server {
namespace {

using protocol::Extent;

std::string ms_text(std::uint64_t ms) {
  return std::to_string(ms) + " ms";
}

const char* kind_of(bool live) {
  return live ? "live" : "recorded";
}

const char* end_of(bool loop) {
  return loop ? "starts again at its end (--loop)" : "ends";
}

/// After how many keyframes the free memory is checked again.
constexpr std::size_t kKeptBetweenLooks = 4096;

/// How many keyframes of 0 ms are at the end.
std::size_t keyframes_at_the_end(const protocol::EncodedStream& stream) {
  const auto takes_time = [](protocol::KeyframeTime time) { return time.count() > 0; };
  const auto last = std::find_if(stream.times.rbegin(), stream.times.rend(), takes_time);
  return static_cast<std::size_t>(last - stream.times.rbegin());
}

bool is_before(const protocol::CaptionData& one, const protocol::CaptionData& other) {
  return one.place_ms < other.place_ms;
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
  asked.from_ms = place_ms_;
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
  if (begun() && hello.duration_ms != recorded_->duration_ms) {
    return "its stream takes " + ms_text(*hello.duration_ms) + ", and what is served here " +
           ms_text(recorded_->duration_ms.value_or(0));
  }
  if (hello.from_ms != place_ms_) {
    return "it begins at " + ms_text(hello.from_ms) + ", asked was " + ms_text(place_ms_);
  }
  return std::nullopt;
}

/// Forgets a recorded stream without keyframes.
void RelayedStream::forget_announced() {
  recorded_.reset();
  spoken_.reset();
  voice_.reset();
  shared_->loop = false;
  caption_bytes_ = 0;
}

std::optional<std::string> RelayedStream::begin(const protocol::HelloGranted& hello) {
  if (auto wrong = objection(hello)) return wrong;
  if (shared_->name.empty() && options_.take_name && !options_.take_name(hello.stream)) {
    return "its first stream is '" + hello.stream +
           "', and another one here has that name; ask for one by aucast://HOST/STREAM, or leave "
           "one out";
  }
  shared_->servers = hello.servers;
  caption_again_ = 0;
  if (begun()) {
    if (recorded_ && !whole()) recorded_->extent = Extent::Growing;
    if (recorded_) sent_again_ = keyframes_at_the_end(*recorded_);
    if (feed_) shift_ = feed_->end_of_newest();
    return std::nullopt;
  }
  forget_announced();
  if (shared_->name.empty()) shared_->name = hello.stream;
  shared_->keyframe_ms = hello.keyframe_ms;
  shared_->title = hello.title;
  const bool voice = hello.voice == protocol::kVoiceCodec;
  if (hello.live) {
    feed_ = std::make_shared<protocol::LiveFeed>(hello.keyframe_ms, options_.classic_min, voice,
                                                 hello.text, hello.duration_ms);
    shared_->content = feed_;
    return std::nullopt;
  }
  recorded_ = std::make_shared<protocol::EncodedStream>();
  recorded_->duration_ms = hello.duration_ms;
  recorded_->extent = Extent::Growing;
  shared_->loop = hello.loop;
  changes_ = hello.delta;
  if (voice) voice_ = std::make_shared<protocol::EncodedTrack>();
  if (voice || hello.text) {
    spoken_ = std::make_shared<protocol::SpokenTrack>();
    spoken_->voice = voice_;
    spoken_->captions_come = hello.text;
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
  return keep(encoded, time_ms);
}

std::optional<std::string> RelayedStream::keep(const protocol::EncodedKeyframe& keyframe,
                                               std::uint32_t time_ms) {
  protocol::EncodedStream& stream = *recorded_;
  if (time_ms == 0 && sent_again_ > 0) {
    --sent_again_;
    return std::nullopt;
  }
  if (place_ms_ + time_ms > stream.duration_ms.value_or(0)) {
    return "it sends more than the " + ms_text(stream.duration_ms.value_or(0)) +
           " that it announced";
  }
  if (auto full = no_room()) return full;
  sent_again_ = 0;
  stream.classic.push_back(keyframe.classic);
  stream.negotiated.push_back(keyframe.full);
  if (changes_) stream.changes.push_back(keyframe.changes);
  stream.times.emplace_back(time_ms);
  place_ms_ += time_ms;
  if (voice_) voice_->encoded_to(place());
  // Not before: by its lists sessions see which forms there are.
  show_recorded();
  return std::nullopt;
}

void RelayedStream::show_recorded() {
  if (shared_->known()) return;
  shared_->content = protocol::RecordedStream{recorded_, spoken_};
}

/// Called before more of a recorded stream is kept.
std::optional<std::string> RelayedStream::no_room() {
  const std::uint64_t bytes =
      held_bytes(*recorded_) + (voice_ ? voice_->bytes() : 0) + caption_bytes_;
  if (bytes > kRelayedBytesMax) {
    return "its stream has more than " + std::to_string(kRelayedBytesMax >> 30U) + " GiB";
  }
  if (looks_ % kKeptBetweenLooks == 0) {
    // As much again is taken for a moment when the buffers grow.
    if (const auto may = options_.may_hold(bytes); !may) return may.error().message;
  }
  ++looks_;
  return std::nullopt;
}

/// Leaves out voice that is here already: a parent repeats the packet that is heard where it was
/// asked to begin.
std::optional<std::string> RelayedStream::add(const protocol::DeliverVoice& voice) {
  if (feed_) {
    feed_->add_voice({voice.packet.place + shift_, voice.packet.opus});
  } else if (voice_) {
    if (auto full = no_room()) return full;
    const auto before = voice_->packets();
    if (before.empty() || voice.packet.place >= before.back().end) voice_->add(voice.packet);
  }
  return std::nullopt;
}

std::optional<std::string> RelayedStream::add(const protocol::DeliverCaption& caption) {
  if (feed_) {
    const auto place = Milliseconds(caption.caption.place_ms) + shift_;
    feed_->add_caption({static_cast<std::uint64_t>(place.count()), caption.caption.text});
  } else if (spoken_) {
    if (auto full = no_room()) return full;
    keep(caption.caption);
  }
  return std::nullopt;
}

/// Leaves out captions that are here already: a parent repeats the one that is shown where it was
/// asked to begin, and those that came before the keyframe at which the last parent was lost.
void RelayedStream::keep(const protocol::CaptionData& caption) {
  auto& captions = spoken_->captions;
  const auto again = captions.begin() + static_cast<std::ptrdiff_t>(caption_again_);
  const auto [first, end] = std::equal_range(again, captions.end(), caption, is_before);
  if (const auto here = std::find(first, end, caption); here != end) {
    caption_again_ = static_cast<std::size_t>(here - captions.begin()) + 1;
    return;
  }
  if (!captions.empty() && is_before(caption, captions.back())) return;
  captions.push_back(caption);
  caption_again_ = captions.size();
  caption_bytes_ += sizeof(protocol::CaptionData) + caption.text.size();
}

std::optional<std::string> RelayedStream::end() {
  if (!recorded_) return std::nullopt;
  if (place_ms_ < recorded_->duration_ms.value_or(0)) {
    return "it ended after " + ms_text(place_ms_) + " of the " +
           ms_text(recorded_->duration_ms.value_or(0)) + " that it announced";
  }
  recorded_->extent = Extent::Whole;
  if (voice_) voice_->finish();
  show_recorded();
  return std::nullopt;
}

void RelayedStream::give_up() {
  if (feed_) feed_->end();
  if (recorded_ && !whole()) recorded_->extent = Extent::BrokenOff;
}

bool RelayedStream::whole() const {
  return recorded_ && recorded_->extent == Extent::Whole;
}

}  // namespace aucast::server
