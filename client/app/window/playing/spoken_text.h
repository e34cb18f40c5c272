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

/// What is said in writing while something plays: the captions that come with a server's stream, or
/// those of the .vtt file beside a stream file, and the stream's title.
/// Thread: none of its own.
class SpokenText {
 public:
  /// Something else plays.
  void begin_again() { *this = {}; }
  /// What plays was read from this stream file. Errors of the .vtt file beside it, if there is one.
  [[nodiscard]] Result<void> read_beside(const std::filesystem::path& file);
  /// Takes in what came, and goes to this place of the stream.
  void move_to(playback::Playback& playback, Duration place);

  [[nodiscard]] const std::string& title() const { return title_; }
  /// Empty: nothing is said.
  [[nodiscard]] const std::string& caption() const { return caption_; }

 private:
  std::vector<protocol::CaptionData> all_;  ///< of a file
  playback::CaptionLine line_;              ///< of a server
  std::string title_;
  std::string caption_;
};

}  // namespace aucast::app
