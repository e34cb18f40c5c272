#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/time.h"
#include "protocol/encoded_track.h"
#include "protocol/limits.h"
#include "protocol/packet.h"
#include "protocol/recent.h"

namespace aucast::protocol {

/// A keyframe that everybody is sent now, in every form. `number` counts from 0, and counts on when
/// a stream starts again: a client that was last sent n and is now to be sent n + 2 has missed one.
struct LiveMoment {
  std::uint64_t number = 0;
  std::string classic;
  std::string full;     ///< level 2
  std::string changes;  ///< level 2, for clients that got the previous moment
  /// On the channel's clock, which is the sum of the times of its moments so far.
  Milliseconds begin{0};
  Milliseconds time{0};
};

/// A live stream: the newest moment, and of the past only the latest voice and the present caption.
/// Sessions read it through the public functions; a derived class writes it, from a recording
/// (LiveReplay) or a running source (LiveFeed). Its writer and the sessions share its ownership.
/// Thread: none of its own; sessions and writer are on the same one.
class LiveChannel {
 public:
  /// How many moments latest() has at most, the newest ones: no window takes more.
  static constexpr std::size_t kLatestMax = kWindowMax;

  LiveChannel(const LiveChannel&) = delete;
  LiveChannel& operator=(const LiveChannel&) = delete;

  /// The moment that everybody is sent now; null before the first.
  [[nodiscard]] const LiveMoment* newest() const {
    return moments_.empty() ? nullptr : &moments_.back();
  }
  /// The moments that began at the last change, the newest last. There are several when the writer
  /// was late; a session that keeps up sends each of them.
  [[nodiscard]] std::span<const LiveMoment> latest() const { return moments_; }
  /// Whether the stream has ended. It may go on later if its source comes back.
  [[nodiscard]] bool ended() const { return ended_; }
  /// Whether the moments have a changes-only form.
  [[nodiscard]] bool has_changes() const { return has_changes_; }
  /// The length of the whole stream; nullopt: it has no end, or its length is not known.
  [[nodiscard]] std::optional<std::uint64_t> duration_ms() const { return duration_ms_; }
  /// Whether voice may come, and whether captions may.
  [[nodiscard]] bool has_voice() const { return spoken_.voice; }
  [[nodiscard]] bool has_captions() const { return spoken_.captions; }
  /// The voice packets of the last kLiveWindowTime. Their places are on the channel's clock and
  /// never decrease.
  [[nodiscard]] const Recent<EncodedVoice>& voice() const { return voice_; }
  /// The present caption and those that follow.
  [[nodiscard]] const Recent<CaptionData>& captions() const { return captions_; }
  /// How many captions were dropped, before the next one began, because of kLiveCaptionsMax.
  [[nodiscard]] std::uint64_t captions_left_out() const { return captions_left_out_; }
  /// The largest window to grant: as many moments as begin within kLiveWindowTime, but at least
  /// two.
  [[nodiscard]] std::size_t window_max() const { return window_max_; }

 protected:
  struct Spoken {
    bool voice = false;
    bool captions = false;
  };

  LiveChannel(bool has_changes, std::optional<std::uint64_t> duration_ms, Spoken spoken)
      : has_changes_(has_changes), duration_ms_(duration_ms), spoken_(spoken) {}
  ~LiveChannel() = default;

  /// Sets window_max(). `mean_ms`: the mean time between two moments.
  void limit_window(double mean_ms);
  /// Adds a voice packet and drops those that are too old. A packet that begins before the end of
  /// the last one is left out.
  void keep(EncodedVoice voice);
  void keep(CaptionData caption);

  std::vector<LiveMoment> moments_;
  bool ended_ = false;

 private:
  bool has_changes_;
  std::optional<std::uint64_t> duration_ms_;
  std::size_t window_max_ = 2;
  Spoken spoken_;
  Recent<EncodedVoice> voice_;
  Recent<CaptionData> captions_;
  std::uint64_t captions_left_out_ = 0;
};

}  // namespace aucast::protocol
