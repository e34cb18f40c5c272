#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "common/result.h"
#include "common/sources/record_timeline.h"
#include "common/time.h"
#include "common/voice/ogg_opus_file.h"
#include "protocol/packet.h"
#include "protocol/voice_packet.h"
#include "server/live/record_writer.h"

namespace aucast::server {

/// Keeps a live stream in files (--record) while it is served: the face in a stream file, and its
/// voice, from the first packet on, in an Ogg Opus file of the same name beside it.
/// Thread: that of its owner.
class Recorder {
 public:
  /// As RecordFile::create().
  [[nodiscard]] static Result<std::unique_ptr<Recorder>> start(const std::filesystem::path& path);
  Recorder(std::filesystem::path path, std::unique_ptr<RecordWriter> face);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Records a voice too from now on. Fails as RecordFile::create().
  [[nodiscard]] Result<void> add_voice_file();

  /// Adds a keyframe; the arguments are those of RecordTimeline.
  void add(const protocol::Keyframe& keyframe, SteadySeconds now, bool free);
  /// A packet that is heard so long `after` the end of the last keyframe, or, if negative, before
  /// it.
  void add_voice(protocol::VoicePacket packet, Milliseconds after);
  void end_of_stream() { timeline_.end(); }
  /// Waits until everything is written. The error that ended the recording, if one did.
  [[nodiscard]] Result<void> finish();

 private:
  std::filesystem::path path_;
  std::unique_ptr<RecordWriter> face_;
  std::unique_ptr<RecordWriter> voice_;  ///< null: it keeps none
  voice::OggOpusWriter pages_;
  sources::RecordTimeline timeline_;
  Milliseconds end_{0};  ///< of the last keyframe, in the file
  bool finished_ = false;
};

/// The file that a stream is kept in. `record`: what --record says; in a folder each stream gets a
/// file of its own, NAME-20261121T115000Z.txt by the time that it began, else only the `first` one
/// is kept.
[[nodiscard]] std::optional<std::filesystem::path> record_path(const std::filesystem::path& record,
                                                               const std::string& stream,
                                                               bool first);

/// Where the voice of a stream that is kept in `record` is kept.
[[nodiscard]] std::filesystem::path voice_record_path(std::filesystem::path record);

}  // namespace aucast::server
