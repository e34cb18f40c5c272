#pragma once

#include <functional>
#include <optional>

#include "client/gui/model/gui_model.h"
#include "client/net/remote_source.h"
#include "common/task.h"
#include "protocol/packet.h"

namespace aucast::app {

/// Asks a server for its streams on a thread of its own, one question at a time.
/// Thread: the player's.
class StreamLister {
 public:
  using Ask =
      std::function<Result<protocol::StreamList>(const net::RemoteOptions&, Duration time_max)>;
  /// `ask` runs on the other thread and may block for `time_max`.
  explicit StreamLister(Ask ask);
  /// If a question is not answered yet, waits for its answer, at most kTimeMax.
  ~StreamLister() = default;
  StreamLister(const StreamLister&) = delete;
  StreamLister& operator=(const StreamLister&) = delete;

  static constexpr Milliseconds kTimeMax{3'000};

  /// Asks this server. If an earlier question is not answered yet, this one waits for that answer;
  /// of several that wait, only the last is asked.
  void ask(net::RemoteOptions server);
  /// Waits until the server that is being asked has answered.
  void wait() const { asking_.wait(); }
  /// Puts the answer into view() if it has come.
  void advance();
  [[nodiscard]] const gui::StreamsView& view() const { return view_; }

 private:
  void begin();

  Ask ask_;
  gui::StreamsView view_;
  std::optional<net::RemoteOptions> next_;
  Task<Result<protocol::StreamList>> asking_;
};

}  // namespace aucast::app
