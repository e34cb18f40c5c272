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
  const auto complete = [video, saved = saved(*video)]() -> Result<std::string> {
    if (auto finished = video->finish(); !finished) return finished.error();
    return saved;
  };
  if (!work_.begin([complete](BackgroundWork::Course&) { return complete(); })) return complete();
  return gui::tr("said.writing", file_.string());
}

/// The sentence that says where the video is, and what it lacks.
std::string VideoRecorder::saved(const SessionVideo& video) const {
  std::string saved =
      video.repeated() == 0
          ? std::string(gui::tr("said.video", file_.string()))
          : std::string(gui::tr("said.video_slow", file_.string(), video.repeated()));
  if (!video.sound_cut()) return saved;
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
