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

/// The faces that keyframes reach, with a caption each, on one page.
class Sheet {
 public:
  static constexpr std::size_t kPicturesMax = 60;

  explicit Sheet(std::filesystem::path file) : file_(std::move(file)) {}
  /// More than kPicturesMax are left out.
  void add(const view::Image& picture, std::string caption);
  [[nodiscard]] bool full() const { return pictures_.size() >= kPicturesMax; }
  /// Writes the page; nothing when no picture came.
  [[nodiscard]] Result<void> finish() const;

 private:
  std::filesystem::path file_;
  std::vector<view::Image> pictures_;
  std::vector<std::string> captions_;
};

}  // namespace aucast::app
