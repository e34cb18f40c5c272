#include "client/app/window/window_pictures.h"

#include <cstdio>

#include "client/app/steady.h"
#include "client/app/video/picture_notes.h"
#include "client/app/window/playing/playing_stream.h"
#include "client/app/window/settings/window_style.h"
#include "client/gui/texts/texts.h"
#include "common/files.h"
#include "common/log.h"
#include "common/text.h"

namespace aucast::app {

view::Style WindowPictures::style() const {
  view::Style style =
      window_style(session_.settings().rendering(), output_.background, display_.scale());
  style.background.transparent |= output_.transparent;
  return style;
}

/// That of the settings, else the part of the window that the panel leaves free; in full screen,
/// where the panel comes and goes with the mouse, all of it.
void WindowPictures::size(int& width, int& height) const {
  if (display_.full_screen()) {
    display_.whole_size(width, height);
  } else {
    display_.free_size(width, height);
  }
  const gui::PictureSettings& wanted = session_.settings().pictures();
  if (wanted.width <= 0 || wanted.height <= 0) return;
  width = wanted.width;
  height = wanted.height;
}

void WindowPictures::save(const std::vector<float>& activations, Instant now) {
  int width = 0;
  int height = 0;
  size(width, height);
  const auto image = display_.picture(width, height, Sharpness::Still, style());
  if (!image) return complain(image.error(), now);
  const auto file =
      new_picture_file(session_.settings().pictures(), session_.named(), today(), ".png");
  if (!file) return complain(file.error(), now);
  const gui::AnimationSettings& animation = session_.settings().animation();
  const std::string edited = session_.face().edited();
  const auto texts = texts_of({assets_.face,
                               session_.face().aus(),
                               animation.rules,
                               animation.mixer,
                               style().layers,
                               {},
                               activations,
                               edited});
  if (const auto written = view::write_png(*image, *file, texts); !written) {
    return complain(written.error(), now);
  }
  tell(gui::tr("said.picture", whole_path(*file).string()), now);
}

void WindowPictures::toggle_video(Instant now) {
  if (video_.running()) return end_video(now);
  int width = 0;
  int height = 0;
  size(width, height);
  if (const auto begun = video_.begin(width, height, now); !begun) {
    return complain(begun.error(), now);
  }
  if (session_.settings().rendering().ground == gui::Ground::None)
    tell(gui::tr("said.video_black"), now);
}

void WindowPictures::advance(Instant now) {
  const auto picture = [this](int width, int height) {
    return display_.picture(width, height, Sharpness::Video, style());
  };
  if (const auto shown = video_.record(picture, now); !shown) complain(shown.error(), now);
  tell_of_video(now);
}

Duration WindowPictures::wait_max() const {
  if (video_.running()) return Milliseconds(1000 / SessionVideo::kFps);
  return video_.completing() ? Duration(kFrameMax) : Duration::max();
}

void WindowPictures::finish(Instant now) {
  if (video_.running()) end_video(now);
  video_.wait();
  tell_of_video(now);
}

void WindowPictures::end_video(Instant now) {
  const auto ending = video_.end();
  if (!ending) return complain(ending.error(), now);
  tell(*ending, now);
}

void WindowPictures::tell_of_video(Instant now) {
  const auto ended = video_.ended();
  if (!ended) return;
  if (!*ended) return complain(ended->error(), now);
  tell(**ended, now);
}

void WindowPictures::tell(const std::string& sentence, Instant now) {
  std::fprintf(stderr, "%s\n", printable(sentence).c_str());
  session_.notices().say(sentence, false, now);
}

void WindowPictures::complain(const Error& error, Instant now) {
  spdlog::error("{}", error.message);
  session_.notices().say(error.message, true, now);
}

}  // namespace aucast::app
