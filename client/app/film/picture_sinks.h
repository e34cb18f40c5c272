#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "client/view/image.h"
#include "client/view/video_encoder.h"
#include "common/result.h"

namespace aucast::app {

/// Makes `folder`, with what is missing above it. Failed, with the reason and `asked_by` (the
/// option or command that named it), when it is not there afterwards or cannot be written.
[[nodiscard]] Result<void> make_output_folder(std::string_view asked_by,
                                              const std::filesystem::path& folder);

/// Pictures as frame_000001.png ... in a folder, which is made when it is missing.
class FrameFolder {
 public:
  [[nodiscard]] static Result<FrameFolder> open(const std::filesystem::path& folder);
  [[nodiscard]] Result<void> add(const view::Image& picture);

 private:
  explicit FrameFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_;
  std::uint64_t count_ = 0;
};

/// The faces that keyframes reach, with a caption each, on one page. Of a stream of more keyframes
/// than kPicturesMax every second, fourth, ... one, so that the page shows all of it.
class Sheet {
 public:
  static constexpr std::size_t kPicturesMax = 60;

  explicit Sheet(std::filesystem::path file) : file_(std::move(file)) {}
  /// To be asked once for each keyframe: whether a picture of it is to be added.
  [[nodiscard]] bool wants_next() { return keyframes_++ % every_ == 0; }
  void add(const view::Image& picture, std::string caption);
  /// Writes the page; nothing when no picture came.
  [[nodiscard]] Result<void> finish() const;

 private:
  std::filesystem::path file_;
  std::uint64_t keyframes_ = 0;
  std::uint64_t every_ = 1;  ///< keyframe has its picture
  std::vector<view::Image> pictures_;
  std::vector<std::string> captions_;
};

}  // namespace aucast::app
