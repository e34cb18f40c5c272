#include "client/app/window/files/gallery_session.h"

#include <cmath>
#include <utility>
#include <variant>

#include "client/gui/storage/home_folder.h"
#include "client/gui/texts/said_text.h"
#include "common/overloaded.h"

namespace aucast::app {

void GallerySession::apply(const gui::GalleryCommand& command, const PlayerOptions& shown) {
  const Overloaded carry_out{[&](const gui::OpenGallery&) {
                               view_.open = true;
                               plan(shown);
                             },
                             [&](const gui::CloseGallery&) { view_.open = false; },
                             [&](const gui::ChangeGallery& one) {
                               view_.settings = one.settings;
                               view_.outcome.clear();
                               plan(shown);
                             },
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

/// The options that the command line would have for this gallery.
PlayerOptions GallerySession::options_under(PlayerOptions options) const {
  const gui::GallerySettings& settings = view_.settings;
  options.command = Command::Gallery;
  options.quiet = true;
  options.gallery = {gui::with_home(settings.folder), gui::wanted_sections(settings),
                     gui::wanted_sweeps(settings)};
  options.output.width = settings.width;
  options.output.height = settings.height;
  return options;
}

void GallerySession::plan(const PlayerOptions& shown) {
  view_.planned = 0;
  view_.complaint.clear();
  if (gui::wanted_sections(view_.settings).empty()) return;  // which would mean all of them
  const auto pictures = count_(options_under(shown));
  if (!pictures) view_.complaint = gui::in_used_language(pictures.error().message);
  if (pictures) view_.planned = *pictures;
}

void GallerySession::begin(const PlayerOptions& shown) {
  view_.outcome.clear();
  view_.drawn = view_.total = 0;
  view_.left_s.reset();
  first_at_.reset();
  const auto begun =
      work_.begin([make = make_, options = options_under(shown)](BackgroundWork::Course& course) {
        return make(options, course);
      });
  view_.running = static_cast<bool>(begun);
  view_.failed = !begun;
  if (!begun) view_.outcome = begun.error().message;
}

/// How long the rest takes, if it goes on at the pace of what has been drawn.
void GallerySession::estimate(Instant now) {
  /// Of fewer pictures the pace is a guess.
  constexpr std::size_t kFew = 3;
  const auto [drawn, total] = work_.reached();
  view_.total = total;
  if (drawn == view_.drawn) return;
  view_.drawn = drawn;
  if (!first_at_) {
    first_at_ = now;
    first_ = view_.drawn;
  }
  const std::size_t since = view_.drawn - first_;
  if (since < kFew || view_.drawn > view_.total) return;
  const double each_s = seconds(now - *first_at_) / static_cast<double>(since);
  view_.left_s = std::lround(std::ceil(each_s * static_cast<double>(view_.total - view_.drawn)));
}

void GallerySession::advance(Instant now) {
  if (!work_.running()) return;
  estimate(now);
  const auto outcome = work_.take_outcome();
  if (!outcome) return;
  view_.running = view_.ending = false;
  view_.stopped = !*outcome && work_.cancelled();
  view_.failed = !*outcome && !view_.stopped;
  view_.outcome = *outcome ? **outcome : outcome->error().message;
}

}  // namespace aucast::app
