#include "client/app/video/picture_sinks.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <system_error>
#include <utility>

#include "common/text.h"

namespace aucast::app {
namespace {

/// The number of columns that makes the page a little wider than high.
int columns_for(std::size_t pictures) {
  const auto count = static_cast<double>(pictures);
  return static_cast<int>(std::ceil(std::sqrt(count * 1.4)));
}

std::string frame_name(std::uint64_t number) {
  std::array<char, 40> name{};
  std::snprintf(name.data(), name.size(), "frame_%06" PRIu64 ".png", number);
  return name.data();
}

}  // namespace

Result<void> make_output_folder(std::string_view asked_by, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && !std::filesystem::is_directory(folder, error) && !error) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (!error && ::access(folder.c_str(), W_OK | X_OK) != 0) {
    error = std::error_code(errno, std::generic_category());
  }
  if (!error) return {};
  return Error{ErrorKind::Failed,
               std::string(asked_by) + " " +
                   at_place(folder.string(), "cannot be written: " + error.message()) +
                   "; choose another folder"};
}

Result<FrameFolder> FrameFolder::open(const std::filesystem::path& folder) {
  if (auto made = make_output_folder("--frames", folder); !made) return made.error();
  return FrameFolder(folder);
}

Result<void> FrameFolder::add(const view::Image& picture) {
  return view::write_png(picture, folder_ / frame_name(++count_));
}

std::string FrameFolder::leftovers() const {
  std::uint64_t more = 0;
  std::error_code ignored;
  while (std::filesystem::exists(folder_ / frame_name(count_ + more + 1), ignored)) ++more;
  if (more == 0) return {};
  return at_place(folder_.string(), counted(more, "picture") + " from " + frame_name(count_ + 1) +
                                        " on are of an earlier run; remove them before you make "
                                        "a video of this folder");
}

bool Sheet::wants_next() {
  const std::uint64_t next = keyframes_++;
  if (!options_.keyframes || *options_.keyframes <= kPicturesMax) return next % every_ == 0;
  // The first and the last one, and the others evenly between them.
  const std::uint64_t last = *options_.keyframes - 1;
  return next * (kPicturesMax - 1) >= pictures_.size() * last;
}

void Sheet::add(const view::Image& picture, std::string caption) {
  if (pictures_.size() == kPicturesMax) {
    every_ *= 2;
    for (std::size_t i = 1; i < kPicturesMax / 2; ++i) {  // the first one stays
      pictures_[i] = std::move(pictures_[2 * i]);
      captions_[i] = std::move(captions_[2 * i]);
    }
    pictures_.resize(kPicturesMax / 2);
    captions_.resize(kPicturesMax / 2);
  }
  pictures_.push_back(options_.halved ? view::halved(picture) : picture);
  captions_.push_back(std::move(caption));
}

Result<void> Sheet::finish() const {
  if (pictures_.empty()) return {};
  return view::write_png(view::contact_sheet(pictures_, captions_, columns_for(pictures_.size())),
                         file_);
}

}  // namespace aucast::app
