#include "client/app/window/gallery_session.h"

#include <utility>
#include <variant>

#include "common/overloaded.h"

namespace aucast::app {

void GallerySession::apply(const gui::GalleryCommand& command, const PlayerOptions& shown) {
  const Overloaded carry_out{[&](const gui::OpenGallery&) { view_.open = true; },
                             [&](const gui::CloseGallery&) { view_.open = false; },
                             [&](const gui::ChangeGallery& one) { view_.settings = one.settings; },
                             [&](const gui::BeginGallery&) {
                               if (!work_.running() && problem(view_.settings).empty())
                                 begin(shown);
                             },
                             [&](const gui::CancelGallery&) {
                               work_.cancel();
                               view_.ending = work_.running();
                             }};
  std::visit(carry_out, command);
}

void GallerySession::begin(PlayerOptions options) {
  const gui::GallerySettings& settings = view_.settings;
  options.command = Command::Gallery;
  options.quiet = true;
  options.gallery = {settings.folder, gui::wanted_sections(settings), gui::wanted_sweeps(settings)};
  options.output.width = settings.width;
  options.output.height = settings.height;
  view_.outcome.clear();
  view_.drawn = view_.total = 0;
  const auto begun =
      work_.begin([make = make_, options = std::move(options)](BackgroundWork::Course& course) {
        return make(options, course);
      });
  view_.running = static_cast<bool>(begun);
  view_.failed = !begun;
  if (!begun) view_.outcome = begun.error().message;
}

void GallerySession::advance() {
  if (!work_.running()) return;
  view_.drawn = work_.done();
  view_.total = work_.total();
  const auto outcome = work_.take_outcome();
  if (!outcome) return;
  view_.running = view_.ending = false;
  view_.failed = !*outcome && !work_.cancelled();
  view_.outcome = *outcome ? **outcome : outcome->error().message;
}

}  // namespace aucast::app
