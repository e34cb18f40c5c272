#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>

#include "common/camera/camera_feed.h"
#include "common/result.h"
#include "common/stopped.h"
#include "protocol/server_session.h"
#include "server/live/live_beat.h"
#include "server/push/pushed_streams.h"
#include "server/serve/running_sources.h"
#include "server/settings/transmitter_options.h"
#include "server/status/status.h"
#include "server/streams/repertoire.h"
#include "server/voice/voice_tracks.h"

namespace aucast::server {

/// Everything that is served, as one catalogue: the streams as they were read last, those of the
/// running sources, and those that publishers send. A client keeps the stream that it is sent; a
/// client that still waits for its stream gets it whenever it comes. Thread: that of the
/// io_context. The io_context, the options and what the events capture must outlive this object.
class Programme {
 public:
  struct Events {
    std::function<void()> on_moment;  ///< a stream has something new
    std::function<void()> on_over;    ///< all sources have ended, and no other stream is left
    std::function<void()> on_voice = [] {};  ///< a voice has grown
    camera::OnSight on_sight{};              ///< a camera sees something, on its own thread
  };

  Programme(asio::io_context& io, const TransmitterOptions& options, Repertoire repertoire,
            Events events);
  Programme(const Programme&) = delete;
  Programme& operator=(const Programme&) = delete;

  /// Opens the sources that are still being written, and begins to receive streams of other
  /// servers. `given_up`: as of RunningSources::open().
  [[nodiscard]] Result<void> open_sources(const GivenUp& given_up = {}) {
    return sources_.open(given_up);
  }
  /// Starts the clocks of the live streams.
  void begin();
  /// Ends all live streams; take_over() must not be called afterwards.
  void stop();
  [[nodiscard]] bool stopped() const { return stopped_; }

  /// Serves `loaded` to clients that get their stream from now on, and keeps live sources. Returns
  /// whether the streams differ from before; if they do not, logs that.
  bool take_over(Repertoire loaded);
  /// Sets the viewers' token (empty: none is needed) and who may send streams here (null: nobody).
  void set_tokens(std::string token, std::shared_ptr<const protocol::Publishers> publishers);
  /// Receives the stream that a publisher sends over this link.
  void take(std::shared_ptr<link::Link> link, const protocol::HelloAsked& hello, std::string peer) {
    pushed_.take(std::move(link), hello, std::move(peer));
  }
  /// The stream with this name, or the first one if none has it; null: there are no streams.
  [[nodiscard]] const protocol::ServedStream* named_or_first(const std::string& name) const;
  /// A catalogue for a server that we push to, with a single stream: the one that is called `name`.
  /// If there is none, the first stream is given that name. If `name` is empty, the first stream
  /// keeps its own.
  [[nodiscard]] std::shared_ptr<const protocol::ServerCatalogue> alone(
      const std::string& name) const;
  /// Holds for what live sources deliver from now on.
  void condition_sources(const sources::ConditioningSettings& settings) {
    sources_.condition(settings);
  }
  /// Sends what is due now. Call it before something that takes long.
  void catch_up() { beat_.catch_up(); }

  [[nodiscard]] std::shared_ptr<const protocol::ServerCatalogue> catalogue() const {
    return catalogue_;
  }
  /// How many unsent bytes the system may hold for each client, see link::tcp_link().
  [[nodiscard]] int held_back_max() const { return may_be_live() ? held_back_max_ : 0; }
  /// Fills in everything about streams.
  void describe(Status& status) const;
  /// Waits until the records and the profile of --save-profile are written. Fails with the first
  /// error of a live source, also if that source went on after it.
  [[nodiscard]] Result<void> finish() { return sources_.finish(); }

 private:
  using Streams = std::vector<protocol::ServedStream>;

  [[nodiscard]] bool may_be_live() const;
  [[nodiscard]] bool takes_streams() const { return !options_.credentials.publishers.empty(); }
  [[nodiscard]] Streams own() const;
  [[nodiscard]] bool is_own(const std::string& name) const;
  void renew();
  [[nodiscard]] bool take_name(const std::string& name);
  void open_to_publishers();
  [[nodiscard]] std::optional<protocol::ErrorReply> publish_refused(
      const protocol::HelloAsked& hello) const;
  void on_moment_of_source();
  [[nodiscard]] bool over() const;
  [[nodiscard]] Streams accompanied(Repertoire repertoire);
  void play_live(Streams& read);
  void share_with_before(Streams& read) const;

  asio::io_context& io_;
  const TransmitterOptions& options_;
  Events events_;
  const std::string id_;  ///< this server's; a relay that meets its own ID has come back to itself
  RunningSources sources_;
  PushedStreams pushed_;
  LiveBeat beat_;
  VoiceTracks voices_;
  int held_back_max_;  ///< for a live stream
  /// What was read last. Those that are absent() are the streams of running sources.
  Streams read_;
  const std::shared_ptr<protocol::ServerCatalogue> catalogue_;
  bool stopped_ = false;
};

}  // namespace aucast::server
