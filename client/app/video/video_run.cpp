#include "client/app/video/video_run.h"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>
#include <optional>
#include <string>

#include "client/app/files_read.h"
#include "client/app/loss_warnings.h"
#include "client/app/missing_aus.h"
#include "client/app/progress_line.h"
#include "client/app/steady.h"
#include "client/app/video/picture_maker.h"
#include "client/app/video/picture_sinks.h"
#include "client/app/video/video_run_sound.h"
#include "client/pipeline/hair_swing.h"
#include "client/pipeline/idle_face.h"
#include "client/pipeline/player.h"
#include "client/playback/movement.h"
#include "common/log.h"
#include "common/text.h"

namespace aucast::app {
namespace {

using playback::kPositionsPerKeyframe;

constexpr int kRecordFps = 30;
/// The head's way through a keyframe is told to the hair so often, whatever the pictures' rate.
constexpr std::int64_t kHeadStepMs = 10;

/// The last line of output: how many pictures there are and where they were written.
std::string where_they_are(const OutputOptions& output, std::uint64_t pictures) {
  std::string places;
  for (const auto& place : {output.frames, output.record, output.sheet}) {
    if (!place.empty()) places += (places.empty() ? "" : ", ") + place.string();
  }
  return counted(pictures, "picture") + " drawn" + (places.empty() ? "" : ": " + places);
}

std::string how_far(std::uint64_t pictures, double video_ms) {
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "%" PRIu64 " pictures, %.1f s of the stream", pictures,
                video_ms / 1000.0);
  return text.data();
}

/// Everything that gets the run's pictures.
struct Sinks {
  std::optional<FrameFolder> frames;
  std::unique_ptr<view::VideoEncoder> video;
  std::optional<Sheet> sheet;
  std::optional<int> frames_fps;
  int video_fps = kRecordFps;
  std::int64_t frames_next = 0;  ///< n of the next picture at n / fps
  std::int64_t video_next = 0;
};

Sheet::Options sheet_options(const PlayerOptions& options, const playback::Playback& playback) {
  const OutputOptions& output = options.output;
  // Alone, its pictures are drawn smaller.
  Sheet::Options sheet{.halved = output.film() && !output.size_given};
  // Of what a server sends, how much has come by now would be chance.
  if (options.command == Command::Play) sheet.keyframes = playback.status().keyframes_received;
  return sheet;
}

Result<Sinks> open_sinks(const OutputOptions& output, const Sheet::Options& sheet,
                         const std::function<bool()>& stop) {
  Sinks sinks;
  sinks.frames_fps = output.fps;
  sinks.video_fps = output.fps.value_or(kRecordFps);
  if (!output.frames.empty()) {
    auto frames = FrameFolder::open(output.frames);
    if (!frames) return frames.error();
    sinks.frames = std::move(*frames);
  }
  if (!output.record.empty()) {
    auto video =
        view::VideoEncoder::open(output.record, output.width, output.height, sinks.video_fps, stop);
    if (!video) return video.error();
    sinks.video = std::move(*video);
  }
  if (!output.sheet.empty()) sinks.sheet.emplace(output.sheet, sheet);
  return sinks;
}

/// One run, with what drawing a keyframe needs.
class VideoRun {
 public:
  VideoRun(const Assets& assets, const PlayerOptions& options, playback::Playback& playback,
           sound::SoundTrack* track, const std::function<bool()>& stop, PlayerStats& stats)
      : assets_(assets),
        options_(options),
        stop_(stop),
        stats_(stats),
        mapping_(au_mapping(assets, options.face.mixer)),
        player_(mapping_, options.playback.interpolation),
        drawn_(player_.face()),
        sheet_(sheet_options(options, playback)),
        progress_(options.output.pictures() && !options.quiet),
        idle_(assets.face),
        hair_(assets.face),
        sound_(playback, track, stop) {
    player_.open(&playback);
  }

  Result<void> open() {
    if (auto opened = sound_.open(options_.sound, options_.output); !opened) return opened;
    auto sinks = open_sinks(options_.output, sheet_, stop_);
    if (!sinks) return sinks.error();
    sinks_ = std::move(*sinks);
    if (auto writable = check_last_outputs(options_.output); !writable) return writable;
    if (!options_.output.pictures()) return {};
    auto maker = PictureMaker::create(assets_.face, options_.output, view::ViewpointPreset::Front,
                                      options_.output.film() ? Sharpness::Video : Sharpness::Still);
    if (!maker) return maker.error();
    maker_ = std::move(*maker);
    return {};
  }

  /// Draws one keyframe that begins at `begin_ms` on the video clock, or as much of it as there is
  /// time for before the user stops.
  Result<void> keyframe(const playback::KeyframeBegun& begun, std::int64_t begin_ms) {
    const std::int64_t takes_ms = begun.time.count();
    const std::string missing = missing_.look_at(mapping_, begun.target.aus);
    if (!missing.empty()) warn(missing);
    sound_.keyframe(begun, begin_ms + takes_ms);
    move_hair(begin_ms, takes_ms);
    if (sinks_.frames) {
      if (auto drawn = frames(begin_ms, takes_ms); !drawn) return drawn;
    }
    if (auto drawn = video(begin_ms, takes_ms); !drawn) return drawn;
    if (sinks_.sheet && sinks_.sheet->wants_next()) {
      sinks_.sheet->add(draw(1.0, static_cast<double>(begin_ms + takes_ms), {}),
                        describe(assets_, begun.target.aus));
    }
    return {};
  }

  /// After the last keyframe, at `begin_ms`: the face holds while there is sound.
  Result<void> tail(std::int64_t begin_ms) {
    const std::int64_t takes_ms = sound_.tail_ms();
    if (takes_ms == 0) return {};
    sound_.tail(begin_ms + takes_ms);
    holds_ = true;
    return video(begin_ms, takes_ms);
  }

  [[nodiscard]] pipeline::Player& player() { return player_; }

  void warn(const std::string& text) {
    progress_.interrupt();
    spdlog::warn("{}", text);
  }

  Result<void> finish() {
    stats_.sound.voice = sound_.counts();
    if (sinks_.video) {
      const auto sound = sound_.file();
      if (!sound) return sound.error();
      if (auto finished = sinks_.video->finish(*sound); !finished) return finished;
    }
    if (auto finished = sound_.finish(); !finished) return finished;
    if (const std::string cut = sound_.complaint(); !cut.empty()) warn(cut);
    if (sinks_.sheet) {
      if (auto finished = sinks_.sheet->finish(); !finished) return finished;
    }
    OutputOptions written = options_.output;
    if (sinks_.video_next == 0) written.record.clear();  // a video of no picture is not written
    progress_.end_with(where_they_are(written, stats_.frames_drawn));
    if (const std::string left = sinks_.frames ? sinks_.frames->leftovers() : std::string();
        !left.empty()) {
      spdlog::warn("{}", left);
    }
    return {};
  }

 private:
  /// Tells the hair how the head goes in this keyframe.
  void move_hair(std::int64_t begin_ms, std::int64_t takes_ms) {
    if (!hair_.can_swing() || !options_.output.film()) return;
    const auto add = [&](std::int64_t ms, double mu) {
      player_.pipeline().at(mu, drawn_);
      hair_.move(Instant(Milliseconds(begin_ms + ms)), drawn_.activations);
    };
    hair_.forget_before(Instant(Milliseconds(begin_ms)));
    for (std::int64_t ms = 0; ms < takes_ms; ms += kHeadStepMs) {
      add(ms, static_cast<double>(ms) / static_cast<double>(takes_ms));
    }
    add(takes_ms, 1.0);
  }

  /// Where the hair hangs in a film's picture.
  [[nodiscard]] face::HairSway hair_at(double video_ms) const {
    return hair_.at(Instant(std::chrono::floor<Duration>(Seconds(video_ms / 1000.0))));
  }

  Result<void> video(std::int64_t begin_ms, std::int64_t takes_ms) {
    if (!sinks_.video) return {};
    const auto add = [this](const view::Image& image) { return sinks_.video->add(image); };
    return timed(begin_ms, takes_ms, sinks_.video_fps, sinks_.video_next, add);
  }

  Result<void> frames(std::int64_t begin_ms, std::int64_t takes_ms) {
    const auto add = [this](const view::Image& image) { return sinks_.frames->add(image); };
    if (sinks_.frames_fps) {
      return timed(begin_ms, takes_ms, *sinks_.frames_fps, sinks_.frames_next, add);
    }
    for (int k = 1; k <= kPositionsPerKeyframe && !stop_(); ++k) {
      const double mu = static_cast<double>(k) / kPositionsPerKeyframe;
      const double at_ms = static_cast<double>(begin_ms) + mu * static_cast<double>(takes_ms);
      if (auto added = add(draw(mu, at_ms, hair_at(at_ms))); !added) return added;
    }
    return {};
  }

  /// The pictures at n / fps that fall into this keyframe, its end included.
  template <typename Add>
  Result<void> timed(std::int64_t begin_ms, std::int64_t takes_ms, int fps, std::int64_t& next,
                     const Add& add) {
    const std::int64_t end_ms = begin_ms + takes_ms;
    for (; next * 1000 <= end_ms * fps && !stop_(); ++next) {
      const double at_ms = static_cast<double>(next) * 1000.0 / fps;
      const bool reached = takes_ms == 0 || holds_;
      const double mu =
          reached ? 1.0 : (at_ms - static_cast<double>(begin_ms)) / static_cast<double>(takes_ms);
      if (auto added = add(draw(std::clamp(mu, 0.0, 1.0), at_ms, hair_at(at_ms))); !added) {
        return added;
      }
    }
    return {};
  }

  view::Image draw(double mu, double video_ms, const face::HairSway& hair) {
    const Instant begin = steady_now();
    player_.pipeline().at(mu, drawn_);
    idle_.apply({options_.playback.idle_seed, options_.playback.blink}, video_ms / 1000.0,
                drawn_.activations);
    view::Image image = maker_->picture(drawn_.activations, hair);
    if (stats_.frames_drawn++ == 0) stats_.first_frame_ms = since_start_ms();
    stats_.draw_seconds += seconds(steady_now() - begin);
    progress_.show([&] { return how_far(stats_.frames_drawn, video_ms); });
    return image;
  }

  const Assets& assets_;
  const PlayerOptions& options_;
  const std::function<bool()>& stop_;
  PlayerStats& stats_;
  pipeline::AuMapping mapping_;
  pipeline::Player player_;
  pipeline::FaceState drawn_;
  Sheet::Options sheet_;
  ProgressLine progress_;
  pipeline::IdleFace idle_;
  pipeline::HairSwing hair_;
  VideoRunSound sound_;
  MissingAus missing_;
  bool holds_ = false;  ///< the last keyframe has been reached
  std::unique_ptr<PictureMaker> maker_;
  Sinks sinks_;
};

}  // namespace

Result<void> run_video(const Assets& assets, const PlayerOptions& options,
                       playback::Playback& playback, sound::SoundTrack* track,
                       const std::function<bool()>& stop, PlayerStats& stats) {
  VideoRun run(assets, options, playback, track, stop, stats);
  if (auto opened = run.open(); !opened) return opened;
  std::optional<Instant> first;
  std::int64_t video_ms = 0;
  const auto video_now = [&video_ms] { return Instant(Milliseconds(video_ms)); };
  Result<void> drawn;
  const auto draw = [&](const playback::KeyframeBegun& begun) {
    if (!drawn) return;
    if (!first) first = steady_now();
    if (stats.first_frame_ms == 0) stats.first_frame_ms = since_start_ms();
    drawn = run.keyframe(begun, video_ms);
    video_ms += begun.time.count();
    stats.playback_seconds = seconds(steady_now() - *first);
  };
  const auto told = [&](Result<void> result) {
    stats.keyframes_played = playback.keyframes_played();
    stats.media_seconds = seconds(playback.media_time());
    return result;
  };
  LossWarnings losses;
  while (!playback.over()) {
    // The video clock stands still until the source has something or has ended.
    while (!playback.wait_until(steady_now() + Milliseconds(50)) && !stop()) {
      if (const std::string loss = losses.look_at(playback); !loss.empty()) run.warn(loss);
    }
    if (stop()) {
      playback.stop(video_now());
      break;
    }
    run.player().advance(video_now(), draw);
    if (!drawn) return told(drawn);
  }
  if (playback.state() == playback::PlaybackState::Ended) drawn = run.tail(video_ms);
  return told(drawn ? run.finish() : drawn);
}

}  // namespace aucast::app
