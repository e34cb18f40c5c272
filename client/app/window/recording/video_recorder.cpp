#include "client/app/window/recording/video_recorder.h"

#include <span>
#include <utility>

#include "client/gui/texts/texts.h"
#include "common/files.h"

namespace aucast::app {

Result<void> VideoRecorder::begin(int width, int height, Instant now) {
  // That one's file does not exist yet, so this one would get the same name.
  if (completing()) return Error{ErrorKind::Failed, gui::tr("said.video_before")};
  const auto file = hooks_.new_file();
  if (!file) return file.error();
  auto video = SessionVideo::open(*file, width, height, now);
  if (!video) return video.error();
  video_ = std::move(*video);
  file_ = whole_path(*file);
  hooks_.hear([this](Instant heard_at, std::span<const float> samples) {
    video_->hear(heard_at, samples);
  });
  return {};
}

Result<void> VideoRecorder::record(const Picture& picture, Instant now) {
  if (!running() || !video_->wants_picture(now)) return {};
  auto image = picture(video_->width(), video_->height());
  const auto shown = image ? video_->show(std::move(*image), now) : Result<void>(image.error());
  if (!shown) let_go();
  return shown;
}

Result<std::string> VideoRecorder::end() {
  const std::shared_ptr<SessionVideo> video = let_go();
  repeated_ = video->repeated();
  sound_cut_ = video->sound_cut();
  const auto complete = [video]() -> Result<std::string> {
    if (auto finished = video->finish(); !finished) return finished.error();
    return std::string();
  };
  if (!work_.begin([complete](BackgroundWork::Course&) { return complete(); })) {
    return sentence(complete());
  }
  return gui::tr("said.writing", file_.string());
}

std::optional<Result<std::string>> VideoRecorder::ended() {
  const auto outcome = work_.take_outcome();
  if (!outcome) return std::nullopt;
  return sentence(*outcome);
}

Result<std::string> VideoRecorder::sentence(const Result<std::string>& outcome) const {
  if (!outcome) return outcome;
  std::string saved = repeated_ == 0
                          ? std::string(gui::tr("said.video", file_.string()))
                          : std::string(gui::tr("said.video_slow", file_.string(), repeated_));
  if (!sound_cut_) return saved;
  return gui::tr("said.video_sound_cut", saved, sound::WavFile::kHours);
}

std::unique_ptr<SessionVideo> VideoRecorder::let_go() {
  hooks_.hear({});
  return std::move(video_);
}

gui::VideoView VideoRecorder::view() const {
  const std::string name = file_.filename().string();
  return {running() ? name : "", completing() ? name : ""};
}

}  // namespace aucast::app
