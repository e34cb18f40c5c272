#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/view/image.h"
#include "client/view/video_encoder.h"
#include "common/result.h"

namespace aucast::app {

/// Makes `folder` and its parents. If it cannot be made or written to, fails with the reason and
/// `asked_by`, the option or command that named the folder.
[[nodiscard]] Result<void> make_output_folder(std::string_view asked_by,
                                              const std::filesystem::path& folder);

/// Writes pictures as frame_000001.png and so on into a folder, which is made if it is missing.
class FrameFolder {
 public:
  [[nodiscard]] static Result<FrameFolder> open(const std::filesystem::path& folder);
  [[nodiscard]] Result<void> add(const view::Image& picture);
  /// Call it after the last picture. Returns a sentence about pictures that an earlier, longer run
  /// has left in the folder; empty: there are none.
  [[nodiscard]] std::string leftovers() const;

 private:
  explicit FrameFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_;
  std::uint64_t count_ = 0;
};

/// One page with the faces that keyframes reach, each with a caption. It covers the whole stream:
/// of more than kPicturesMax keyframes it shows that many, evenly spread, if their number is known
/// before, or else every second, every fourth and so on.
class Sheet {
 public:
  /// Nine columns of six.
  static constexpr std::size_t kPicturesMax = 54;

  struct Options {
    bool halved = false;  ///< pictures stand on the page at half their width and height
    std::optional<std::uint64_t> keyframes{};  ///< of the whole stream, if known
  };

  Sheet(std::filesystem::path file, const Options& options)
      : file_(std::move(file)), options_(options) {}
  /// Call it once for each keyframe. Returns whether its picture is to be added.
  [[nodiscard]] bool wants_next();
  void add(const view::Image& picture, std::string caption);
  /// Writes the page, unless no picture was added.
  [[nodiscard]] Result<void> finish() const;

 private:
  std::filesystem::path file_;
  Options options_;
  std::uint64_t keyframes_ = 0;  ///< that wants_next() was asked about
  std::uint64_t every_ = 1;      ///< 2: every second keyframe gets a picture
  std::vector<view::Image> pictures_;
  std::vector<std::string> captions_;
};

}  // namespace aucast::app
