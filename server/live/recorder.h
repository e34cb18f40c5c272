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

/// Records a live stream while it is served (--record): the face in a stream file, and the voice,
/// from its first packet on, in an Ogg Opus file of the same name beside it.
/// Thread: that of its owner.
class Recorder {
 public:
  /// Errors are those of RecordFile::create().
  [[nodiscard]] static Result<std::unique_ptr<Recorder>> start(const std::filesystem::path& path);
  Recorder(std::filesystem::path path, std::unique_ptr<RecordWriter> face);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Records a voice too from now on. Errors are those of RecordFile::create().
  [[nodiscard]] Result<void> add_voice_file();

  /// Adds a keyframe; the arguments are those of RecordTimeline::add().
  void add(const protocol::Keyframe& keyframe, SteadyTime now, bool free);
  /// Adds a voice packet. `after`: how long after the last keyframe's end it begins; negative:
  /// before that end.
  void add_voice(protocol::VoicePacket packet, Milliseconds after);
  void end_of_stream() { timeline_.end(); }
  /// Waits until everything is written. Fails with the error that ended the recording, if any.
  [[nodiscard]] Result<void> finish();

 private:
  std::filesystem::path path_;
  std::unique_ptr<RecordWriter> face_;
  std::unique_ptr<RecordWriter> voice_;  ///< null: no voice is recorded
  /// Used on the voice's writing thread, since hours of silence take long to write.
  voice::OggOpusWriter pages_;
  sources::RecordTimeline timeline_;
  Milliseconds end_{0};  ///< of the last keyframe, on the file's clock
  bool finished_ = false;
};

/// The file in which a stream is recorded. `record` is the value of --record. If it is a folder,
/// each stream gets a file of its own, named after the stream and the time,
/// NAME-20261121T115000Z.txt, or NAME-20261121T115000Z-2.txt if there is one already; otherwise
/// only the `first` stream is recorded. nullopt: this stream is not recorded.
[[nodiscard]] std::optional<std::filesystem::path> record_path(const std::filesystem::path& record,
                                                               const std::string& stream,
                                                               bool first);

/// The file for the voice of a stream that is recorded in `record`.
[[nodiscard]] std::filesystem::path voice_record_path(std::filesystem::path record);

}  // namespace aucast::server
