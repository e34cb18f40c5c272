#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/playback/caption_line.h"
#include "client/playback/playback.h"
#include "common/result.h"
#include "common/time.h"
#include "protocol/packet.h"

namespace aucast::app {

/// The captions of what plays (those that come with a server's stream, or those of the .vtt file
/// beside a stream file), and the stream's title.
/// Thread: none of its own.
class SpokenText {
 public:
  /// Call it when something else plays: forgets everything.
  void begin_again() { *this = {}; }
  /// Call it when the stream that plays was read from this file. Reads the stream's title and the
  /// .vtt file beside the file, if there is one. Fails if the .vtt file cannot be read or is not
  /// valid.
  [[nodiscard]] Result<void> read_beside(const std::filesystem::path& file);
  /// Takes the captions that have come, and goes to this place of the stream.
  void move_to(playback::Playback& playback, Duration place);

  [[nodiscard]] const std::string& title() const { return title_; }
  /// The caption to be shown; empty: none.
  [[nodiscard]] const std::string& caption() const { return caption_; }

 private:
  std::vector<protocol::CaptionData> all_;  ///< the captions of a file
  playback::CaptionLine line_;              ///< the captions of a server
  std::string title_;
  std::string caption_;
};

}  // namespace aucast::app
