#include "protocol/live_replay.h"

#include <utility>

namespace aucast::protocol {

LiveReplay::LiveReplay(std::shared_ptr<const EncodedStream> stream, bool loop, Instant begin,
                       std::shared_ptr<const SpokenTrack> spoken)
    : LiveChannel(!stream->changes.empty(), loop ? std::nullopt : stream->duration_ms,
                  {spoken && spoken->voice, spoken && spoken->has_captions()}),
      stream_(std::move(stream)),
      spoken_(std::move(spoken)),
      clock_(stream_->times, loop, begin) {
  limit_window(static_cast<double>(clock_.turn().count()) /
               static_cast<double>(stream_->times.size()));
  if (loop) turn_time_ = clock_.turn();
}

bool LiveReplay::advance(Instant now) {
  if (!clock_.advance(now)) return false;
  ended_ = clock_.ended();
  std::uint64_t number = clock_.first_shown();
  moments_.resize(static_cast<std::size_t>(clock_.begun() - number));
  for (LiveMoment& moment : moments_) {
    const auto keyframe = static_cast<std::size_t>(number % stream_->times.size());
    moment.number = number++;
    moment.classic = stream_->classic[keyframe];
    moment.full = stream_->negotiated[keyframe];
    if (has_changes()) moment.changes = stream_->changes[keyframe];
    go_to(moment.number);
    moment.begin = next_begin_;
    moment.time = stream_->times[keyframe];
  }
  play_spoken(moments_.front().begin,
              ended_ ? Milliseconds::max() : moments_.back().begin + moments_.back().time);
  return true;
}

/// Moves next_begin_ on to where the moment with this number begins.
void LiveReplay::go_to(std::uint64_t number) {
  const std::size_t size = stream_->times.size();
  // Turns that the clock has left out are not gone through, nor heard.
  if (const std::uint64_t turns = (number - next_number_) / size; turns > 1) {
    next_number_ += (turns - 1) * size;
    next_begin_ += static_cast<std::int64_t>(turns - 1) * turn_time_;
    turn_begin_ += static_cast<std::int64_t>(turns - 1) * turn_time_;
  }
  for (; next_number_ < number; ++next_number_) {
    next_begin_ += stream_->times[static_cast<std::size_t>(next_number_ % size)];
    if ((next_number_ + 1) % size > 0) continue;
    play_spoken(turn_begin_, next_begin_);
    turn_begin_ = next_begin_;
    next_voice_ = 0;
    next_caption_ = 0;
  }
}

/// Hands out the sound of this turn that begins before `end`. A voice that was encoded too late, so
/// that it would have been over before `begin`, is left out: nobody could hear it in its place. So
/// is what reaches into the next turn of a loop, for it would cost the beginning of that.
void LiveReplay::play_spoken(Milliseconds begin, Milliseconds end) {
  if (!spoken_) return;
  for (; next_caption_ < spoken_->captions.size(); ++next_caption_) {
    const CaptionData& caption = spoken_->captions[next_caption_];
    const Milliseconds place = Milliseconds(caption.place_ms) + turn_begin_;
    if (place >= end) break;
    keep(CaptionData{static_cast<std::uint64_t>(place.count()), caption.text});
  }
  if (!spoken_->voice) return;
  const auto voice = spoken_->voice->packets();
  for (; next_voice_ < voice.size(); ++next_voice_) {
    if (voice[next_voice_].begin + turn_begin_ >= end) break;
    if (voice[next_voice_].end > turn_time_) break;
    if (voice[next_voice_].end + turn_begin_ <= begin) continue;
    EncodedVoice packet = voice[next_voice_];
    packet.begin += turn_begin_;
    packet.end += turn_begin_;
    keep(std::move(packet));
  }
}

}  // namespace aucast::protocol
