#include "client/app/gallery/gallery_command.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "client/app/assets.h"
#include "client/app/files_read.h"
#include "client/app/progress_line.h"
#include "client/app/steady.h"
#include "client/app/video/picture_maker.h"
#include "client/app/video/picture_notes.h"
#include "client/app/video/picture_sinks.h"
#include "client/gallery/gallery_manifest.h"
#include "client/gallery/gallery_page.h"
#include "client/gallery/gallery_plan.h"
#include "client/pipeline/expression_muscles.h"
#include "client/view/video_encoder.h"
#include "common/ffmpeg.h"
#include "common/files.h"
#include "common/overwriting.h"

namespace aucast::app {
namespace {

Result<gallery::GalleryRules> load_rules(const Assets& assets) {
  gallery::GalleryRules rules;
  rules.chosen = assets.rules;
  const std::array<std::pair<const char*, face::RuleSet*>, 3> wanted{
      {{"kumar2010", &rules.kumar2010}, {"facs", &rules.facs}, {"none", &rules.none}}};
  for (const auto& [name, place] : wanted) {
    auto found = face::find_rules(name, assets.data_folder);
    if (!found) return found.error();
    *place = std::move(*found);
  }
  return rules;
}

Result<void> make_folders(const std::filesystem::path& root, const gallery::GalleryPlan& plan) {
  if (auto made = make_output_folder("gallery", root); !made) return made;
  std::filesystem::path last;
  for (const gallery::GalleryPicture& picture : plan.pictures) {
    const std::filesystem::path folder = (root / picture.file).parent_path();
    if (folder == last) continue;
    if (auto made = make_output_folder("gallery", folder); !made) return made;
    last = folder;
  }
  return {};
}

/// Videos are optional: without the program that makes them, frames are enough.
bool ffmpeg_is_there() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  std::string folder;
  while (std::getline(folders, folder, ':')) {
    if (::access((std::filesystem::path(folder) / kFfmpeg).c_str(), X_OK) == 0) return true;
  }
  return false;
}

constexpr const char* kManifest = "manifest.csv";
constexpr const char* kPage = "index.html";

std::filesystem::path video_file(const gallery::GallerySweep& sweep) {
  return std::filesystem::path("sweeps") / (sweep.name + ".mp4");
}

/// A video that is stopped is not kept: ffmpeg needs no time for its end.
constexpr Milliseconds kStopPatience{1'000};
constexpr const char* kVideosMissing = "no videos of the sweeps: install ffmpeg for them";

/// Draws a plan into its folder, one picture at a time.
class GalleryWriter {
 public:
  GalleryWriter(const Assets& assets, const PlayerOptions& options,
                const gallery::GalleryPlan& plan, const std::function<bool()>& stop,
                const std::function<void(std::size_t, std::size_t)>& on_drawn)
      : assets_(assets),
        options_(options),
        plan_(plan),
        stop_(stop),
        on_drawn_(on_drawn),
        progress_(!options.quiet),
        activations_(assets.face.channels.size()) {}

  /// If it was stopped, the error says so, whatever else failed because of it.
  Result<void> write() {
    auto written = draw_all();
    if (written) return write_texts();
    if (!stop_()) return written;
    return Error{ErrorKind::Failed, "stopped after " + count_text(drawn_) +
                                        "; the page and the manifest are written last, run it "
                                        "again for all"};
  }

  /// Whether videos of sweeps are missing, because ffmpeg is.
  [[nodiscard]] bool videos_missing() const { return videos_missing_; }

 private:
  [[nodiscard]] std::string count_text(std::size_t drawn) const {
    return std::to_string(drawn) + " of " + std::to_string(plan_.pictures.size()) + " pictures";
  }

  Result<void> draw_all() {
    auto maker = PictureMaker::create(assets_.face, options_.output, options_.pose.viewpoint,
                                      Sharpness::Still);
    if (!maker) return maker.error();
    maker_ = std::move(*maker);
    const std::size_t stills = plan_.sweeps.empty() ? plan_.pictures.size() : plan_.sweeps[0].begin;
    for (std::size_t i = 0; i < stills; ++i) {
      if (auto drawn = draw(i, nullptr); !drawn) return drawn;
    }
    const bool with_videos = ffmpeg_is_there();
    videos_missing_ = !plan_.sweeps.empty() && !with_videos;
    if (videos_missing_ && !options_.quiet) {
      std::fprintf(stderr, "face-player: %s\n", kVideosMissing);
    }
    for (std::size_t i = 0; i < plan_.sweeps.size(); ++i) {
      if (auto swept = sweep(i, with_videos); !swept) return swept;
    }
    return {};
  }

  Result<void> draw(std::size_t index, view::VideoEncoder* video) {
    if (stop_()) return Error{ErrorKind::Failed, "stopped"};
    const gallery::GalleryPicture& picture = plan_.pictures[index];
    face::mix(assets_.face, picture.shown, picture.mixer, activations_);
    Expression muscles;
    muscles.muscles = picture.muscles;
    if (auto applied = pipeline::apply_muscles(assets_.face, muscles, activations_); !applied)
      return applied;
    if (picture.sweep_frame) {
      const float strength = gallery::sweep_strength(picture.sweep_frame->time_ms);
      for (float& activation : activations_) activation *= strength;
    }
    const view::Image image = maker_->picture(activations_);
    const bool only_muscles = !picture.muscles.empty() && picture.shown == AuFrame{};
    auto texts = texts_of({assets_.face, only_muscles ? std::nullopt : std::optional(picture.shown),
                           picture.rules, picture.mixer, options_.output.layers,
                           name(options_.pose.viewpoint), activations_});
    if (picture.sweep_frame) {
      const int time_ms = picture.sweep_frame->time_ms;
      texts.push_back({"Strength", gallery::strength_text(time_ms) + " %"});
      texts.push_back({"Time", std::to_string(time_ms) + " ms"});
    }
    auto written = view::write_png(image, options_.gallery.folder / picture.file, texts);
    if (!written) return written;
    if (video != nullptr) {
      if (auto added = video->add(image); !added) return added;
    }
    ++drawn_;
    if (on_drawn_) on_drawn_(drawn_, plan_.pictures.size());
    progress_.show([&] { return count_text(drawn_) + time_left(); },
                   drawn_ == plan_.pictures.size());
    return {};
  }

  /// The time that is left, in words; empty until it can be estimated.
  [[nodiscard]] std::string time_left() const {
    const auto passed = seconds(steady_now() - begin_);
    const auto drawn = static_cast<double>(drawn_);
    const double left = passed / drawn * (static_cast<double>(plan_.pictures.size()) - drawn);
    if (left < 10) return "";
    return left < 90 ? ", " + std::to_string(std::lround(left)) + " s left"
                     : ", " + std::to_string(std::lround(left / 60)) + " min left";
  }

  Result<void> sweep(std::size_t number, bool with_video) {
    const gallery::GallerySweep& sweep = plan_.sweeps[number];
    std::unique_ptr<view::VideoEncoder> video;
    if (with_video) {
      auto opened = view::VideoEncoder::open(options_.gallery.folder / video_file(sweep),
                                             options_.output.width, options_.output.height,
                                             gallery::kSweepFps, stop_, kStopPatience);
      if (!opened) return opened.error();
      video = std::move(*opened);
    }
    for (std::size_t i = sweep.begin; i < sweep.begin + sweep.count; ++i) {
      if (auto drawn = draw(i, video.get()); !drawn) return drawn;
    }
    if (video == nullptr) return {};
    videos_.push_back(number);
    return video->finish();
  }

  Result<void> write_texts() {
    gallery::GallerySetting setting;
    setting.face = assets_.face.name;
    setting.viewpoint = name(options_.pose.viewpoint);
    setting.background = options_.output.transparent ? "none" : "default";
    if (options_.output.background) {
      std::array<char, 16> text{};
      std::snprintf(text.data(), text.size(), "%06X", *options_.output.background);
      setting.background = text.data();
    }
    setting.layers = view::format_layers(options_.output.layers);
    setting.version = AUCAST_VERSION;
    setting.width = options_.output.width;
    setting.height = options_.output.height;
    const auto& folder = options_.gallery.folder;
    auto manifest = write_file_atomically(folder / kManifest,
                                          gallery::format_manifest(plan_, setting, videos_));
    if (!manifest) return manifest;
    return write_file_atomically(folder / kPage, gallery::format_page(plan_, setting, videos_));
  }

  const Assets& assets_;
  const PlayerOptions& options_;
  const gallery::GalleryPlan& plan_;
  const std::function<bool()>& stop_;
  const std::function<void(std::size_t, std::size_t)>& on_drawn_;
  ProgressLine progress_;
  Instant begin_ = steady_now();
  std::size_t drawn_ = 0;
  std::unique_ptr<PictureMaker> maker_;
  std::vector<float> activations_;
  std::vector<std::size_t> videos_;
  bool videos_missing_ = false;
};

Result<gallery::GalleryPlan> plan_of(const Assets& assets, const PlayerOptions& options) {
  const auto rules = load_rules(assets);
  if (!rules) return rules.error();
  const gallery::GalleryInput input{assets.face,
                                    assets.expressions,
                                    *rules,
                                    options.face.mixer,
                                    {options.gallery.only.begin(), options.gallery.only.end()},
                                    options.gallery.sweeps};
  return gallery::plan_gallery(input);
}

Result<void> check_pictures(const PlayerOptions& options, const gallery::GalleryPlan& plan) {
  const std::filesystem::path& folder = options.gallery.folder;
  std::vector<std::filesystem::path> outputs{folder / kManifest, folder / kPage};
  for (const gallery::GalleryPicture& picture : plan.pictures) {
    outputs.push_back(folder / picture.file);
  }
  for (const gallery::GallerySweep& sweep : plan.sweeps) {
    outputs.push_back(folder / video_file(sweep));
  }
  return check_not_read(outputs, files_read(options));
}

/// A sentence about what was made, and which AUs the face lacks or cannot show well.
std::string summary(const std::filesystem::path& folder, const gallery::GalleryPlan& plan) {
  std::size_t recorded = 0;
  std::string missing;
  std::string limited;
  const auto list = [](std::string& numbers, int number) {
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(number);
  };
  for (const gallery::Coverage& row : plan.coverage) {
    if (row.recorded) ++recorded;
    if (!row.recorded) list(missing, row.number);
    if (gallery::is_limited(row)) list(limited, row.number);
  }
  std::string text = (folder / kPage).string() + ": " + std::to_string(plan.pictures.size()) +
                     " pictures; " + std::to_string(recorded) + " of " +
                     std::to_string(plan.coverage.size()) + " Action Units are recorded";
  if (!missing.empty()) text += ", not " + missing;
  if (!limited.empty()) text += "; in their best form only: " + limited;
  return text;
}

}  // namespace

Result<std::string> make_gallery(const PlayerOptions& options, const std::function<bool()>& stop,
                                 const std::function<void(std::size_t, std::size_t)>& on_drawn) {
  auto assets = load_assets(options.face);
  if (!assets) return assets.error();
  const auto plan = plan_of(**assets, options);
  if (!plan) return plan.error();
  if (auto kept = check_pictures(options, *plan); !kept) return kept.error();
  if (auto made = make_folders(options.gallery.folder, *plan); !made) return made.error();
  GalleryWriter writer(**assets, options, *plan, stop, on_drawn);
  if (auto written = writer.write(); !written) return written.error();
  std::string sentence = summary(options.gallery.folder, *plan);
  if (options.quiet && writer.videos_missing()) sentence += std::string("; ") + kVideosMissing;
  return sentence;
}

Result<std::size_t> gallery_size(const Assets& assets, const PlayerOptions& options) {
  const auto plan = plan_of(assets, options);
  if (!plan) return plan.error();
  return plan->pictures.size();
}

Result<void> run_gallery(const PlayerOptions& options, const std::function<bool()>& stop) {
  const auto made = make_gallery(options, stop);
  if (!made) return made.error();
  std::printf("%s\n", made->c_str());
  return {};
}

}  // namespace aucast::app
