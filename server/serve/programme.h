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
#include "protocol/server_session.h"
#include "server/live/live_beat.h"
#include "server/push/pushed_streams.h"
#include "server/serve/running_sources.h"
#include "server/settings/transmitter_options.h"
#include "server/status/status.h"
#include "server/streams/repertoire.h"
#include "server/voice/voice_tracks.h"

namespace aucast::server {

/// What is served, as one catalogue: the streams as they were read last, those of the running
/// sources, and those that publishers bring. A client keeps the catalogue that was current when it
/// connected, which lives as long as any of its clients. Thread: that of the io_context, which must
/// outlive it together with the events' captures and the options.
class Programme {
 public:
  struct Events {
    std::function<void()> on_moment;         ///< a live stream has moved on
    std::function<void()> on_over;           ///< nothing is served any more and nothing can come
    std::function<void()> on_voice = [] {};  ///< more of a voice is there
    camera::OnSight on_sight{};              ///< a camera sees something, on its own thread
    camera::GivenUp given_up{};              ///< while open_sources() waits for a camera
  };

  Programme(asio::io_context& io, const TransmitterOptions& options, Repertoire repertoire,
            Events events);
  Programme(const Programme&) = delete;
  Programme& operator=(const Programme&) = delete;

  /// Opens the sources that are still being written, and goes to other servers.
  [[nodiscard]] Result<void> open_sources() { return sources_.open(); }
  /// The clocks of the live streams begin.
  void begin() { make_live(*catalogue_); }
  /// Nothing is live any more, and nothing that was read is taken over.
  void stop();
  [[nodiscard]] bool stopped() const { return stopped_; }

  /// Serves `loaded` to clients that connect from now on, and logs it if the streams differ from
  /// before; live sources stay. Whether they differ.
  bool take_over(Repertoire loaded);
  /// The viewers' token, if one is needed, and who may bring streams.
  void set_tokens(std::string token, std::shared_ptr<const protocol::Publishers> publishers);
  /// Takes the stream that a publisher brings on this link.
  void take(std::shared_ptr<link::Link> link, const protocol::HelloAsked& hello, std::string peer) {
    pushed_.take(std::move(link), hello, std::move(peer));
  }
  /// The stream of that name, or else the first; null: there is none.
  [[nodiscard]] const protocol::ServedStream* named(const std::string& name) const;
  /// For a server that we push to: only named(), under that name; without one under its own.
  [[nodiscard]] std::shared_ptr<const protocol::ServerCatalogue> alone(
      const std::string& name) const;
  /// The profile of the signals may have changed: reads it for the live sources again.
  void condition_sources_anew() { sources_.condition_anew(); }
  /// Sends what is due, before something that takes time.
  void catch_up() { beat_.catch_up(); }

  [[nodiscard]] std::shared_ptr<const protocol::ServerCatalogue> catalogue() const {
    return catalogue_;
  }
  /// What the system may hold back unsent for a client; 0: as much as it likes.
  [[nodiscard]] int held_back_max() const { return any_live() ? held_back_max_ : 0; }
  /// Fills in all that `status` says of streams.
  void describe(Status& status) const;
  /// What went wrong with live sources without stopping anything. Waits until the records are
  /// written.
  [[nodiscard]] Result<void> finish() { return sources_.finish(); }

 private:
  [[nodiscard]] bool any_live() const { return options_.live || sources_.any() || takes_streams(); }
  [[nodiscard]] bool takes_streams() const { return !options_.credentials.publishers.empty(); }
  [[nodiscard]] bool is_own(const std::string& name) const;
  void open_to_publishers(protocol::ServerCatalogue& catalogue);
  [[nodiscard]] std::optional<protocol::ErrorReply> publish_refused(
      const protocol::HelloAsked& hello) const;
  void serve_pushed(protocol::ServerCatalogue& catalogue);
  void on_moment_of_source();
  void add_faces();
  void make_live(protocol::ServerCatalogue& catalogue);
  [[nodiscard]] bool over() const;
  [[nodiscard]] protocol::ServerCatalogue accompanied(Repertoire repertoire);
  void share_with_before(protocol::ServerCatalogue& catalogue) const;

  asio::io_context& io_;
  const TransmitterOptions& options_;
  Events events_;
  const std::string id_;  ///< of this server, by which relays find loops
  RunningSources sources_;
  PushedStreams pushed_;
  std::vector<std::string> pushed_names_;  ///< as they are in the catalogue
  LiveBeat beat_;
  VoiceTracks voices_;
  std::shared_ptr<protocol::ServerCatalogue> catalogue_;
  int held_back_max_;  ///< of a live stream
  bool stopped_ = false;
};

}  // namespace aucast::server
