#pragma once

#include <optional>

#include "client/net/server_connection.h"
#include "client/playback/keyframe_source.h"

namespace aucast::net {

/// The keyframes of a server: a ServerConnection feeds them into the reader, and this class takes
/// them out for the player. Classes that run the connection derive from this one.
/// Thread: the player's; the connection's thread uses only the reader.
class ConnectedSource : public playback::KeyframeSource {
 public:
  [[nodiscard]] std::optional<playback::Keyframe> take() final;
  [[nodiscard]] std::optional<playback::Voice> take_voice() final;
  [[nodiscard]] std::optional<playback::Caption> take_caption() final;
  [[nodiscard]] bool ready() const final;
  [[nodiscard]] playback::SourceStatus status() const final;
  void stop() final;

  /// The user pauses or resumes the transmission; what is buffered plays on. In level 2 this takes
  /// effect at once; in classic, -1 can only take the place of an answer, so one more packet comes.
  void pause() final;
  void resume() final;

 protected:
  explicit ConnectedSource(AuReaderOptions options) : reader_(std::move(options)) {}
  [[nodiscard]] SharedReader& reader() { return reader_; }

 private:
  /// Both do what ServerConnection's functions of these names do. speak() is called when the reader
  /// may have something to send.
  virtual void speak() = 0;
  virtual void leave() = 0;
  void set_paused(bool paused);

  mutable SharedReader reader_;
};

}  // namespace aucast::net
