#include "client/net/stream_list.h"

#include <chrono>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>
#include <variant>

#include <asio/io_context.hpp>

#include "client/net/dialling.h"
#include "common/link/host.h"
#include "common/text.h"
#include "protocol/codec.h"
#include "protocol/decoder.h"

namespace aucast::net {
namespace {

using Names = std::vector<std::string>;

/// One question and its answer. Everything runs in the thread that calls ask().
class Question final : public link::LinkUser {
 public:
  explicit Question(const RemoteOptions& options) : options_(options) {}
  ~Question() override {
    if (link_) link_->close();
  }
  Question(const Question&) = delete;
  Question& operator=(const Question&) = delete;

  Result<Names> ask() {
    until_ = std::chrono::steady_clock::now() + options_.connect_timeout;
    dialler_.dial(dial_options(options_), [this](link::Dialled dialled) {
      if (auto* const link = std::get_if<std::shared_ptr<link::Link>>(&dialled)) {
        link_ = std::move(*link);
        link_->start(*this);
      } else {
        const auto& failure = std::get<link::DialFailure>(dialled);
        fail((failure.final ? "" : "cannot be reached: ") + failure.reason);
      }
    });
    io_.run();
    return std::move(*result_);
  }

 private:
  void on_open() override {
    link_->wake_at(until_);
    link_->write(protocol::encode(protocol::StreamsAsked{options_.security.token}));
  }

  void on_bytes(std::string_view bytes) override {
    const auto packet = decoder_.next(bytes);
    if (!packet) {
      if (decoder_.error()) fail(decoder_.error()->reason + "; is it an au-transmitter?");
      return;
    }
    if (const auto* list = std::get_if<protocol::StreamList>(&*packet)) {
      end(list->names);
    } else if (const auto* refused = std::get_if<protocol::ErrorReply>(&*packet)) {
      fail("refused: " + std::to_string(refused->code) + " " + escaped(refused->text, 200));
    } else {
      fail("answered without a list of its streams: it may be a classic server, with one");
    }
  }

  void on_peer_end() override { fail("ended the connection without a list of its streams"); }
  void on_room() override {}
  void on_time() override { fail("no answer in time; --connect-timeout sets how long to wait"); }
  void on_closed(const link::Ending& ending) override {
    if (ending.why == link::Ending::Why::Lost) {
      on_peer_end();
    } else {
      fail(ending.reason);
    }
  }

  void fail(const std::string& why) {
    end(Error{ErrorKind::Network, link::host_and_port(options_.host, options_.port) + ": " + why});
  }

  void end(Result<Names> result) {
    if (result_) return;
    result_ = std::move(result);
    if (link_) link_->close();
  }

  const RemoteOptions& options_;
  asio::io_context io_{1};
  link::Dialler dialler_{io_};
  std::shared_ptr<link::Link> link_;
  Instant until_{};
  protocol::ServerPacketDecoder decoder_;
  std::optional<Result<Names>> result_;
};

}  // namespace

Result<std::vector<std::string>> list_streams(const RemoteOptions& options) {
  // Asio throws when the system has no thread or descriptor left for it.
  try {
    return Question(options).ask();
  } catch (const std::system_error& failure) {
    return Error{ErrorKind::Network, link::host_and_port(options.host, options.port) + ": " +
                                         failure.code().message() +
                                         "; the system is short of threads or files"};
  }
}

}  // namespace aucast::net
