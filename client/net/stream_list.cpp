#include "client/net/stream_list.h"

#include <array>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>
#include <variant>

#include <asio/buffer.hpp>
#include <asio/connect.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>
#include <asio/write.hpp>

#include "common/link/name_lookup.h"
#include "common/text.h"
#include "common/tls/channel.h"
#include "protocol/codec.h"
#include "protocol/decoder.h"

namespace aucast::net {
namespace {

using asio::ip::tcp;
using Names = std::vector<std::string>;

std::string peer_name(const RemoteOptions& options) {
  const std::string host = escaped(options.host);
  const bool v6 = host.find(':') != std::string::npos;
  return (v6 ? "[" + host + "]" : host) + ":" + std::to_string(options.port);
}

/// One question and its answer. Everything runs in the thread that calls ask().
class Question {
 public:
  explicit Question(const RemoteOptions& options) : options_(options) {}

  Result<Names> ask() {
    timer_.expires_after(options_.connect_timeout);
    timer_.async_wait([this](const std::error_code& error) {
      if (!error) fail("no answer in time; --connect-timeout sets how long to wait");
    });
    std::error_code no_address;
    const auto address = asio::ip::make_address(options_.host, no_address);
    if (no_address) {
      lookup_.start(options_.host, options_.port,
                    [this](const std::string& failure, link::Addresses found) {
                      if (failure.empty()) {
                        connect(std::move(found));
                      } else {
                        fail(failure + "; check the host's name");
                      }
                    });
    } else {
      connect({tcp::endpoint(address, options_.port)});
    }
    io_.run();
    return result_.value_or(Error{ErrorKind::Network, peer_name(options_) + ": no answer"});
  }

 private:
  void connect(link::Addresses addresses) {
    addresses_ = std::move(addresses);
    asio::async_connect(socket_, addresses_,
                        [this](const std::error_code& error, const tcp::endpoint& peer) {
                          if (error) {
                            fail("cannot be reached: " + error.message() +
                                 "; is au-transmitter running there, on an address (--bind) that "
                                 "can be reached from here?");
                          } else {
                            connected(peer);
                          }
                        });
  }

  void connected(const tcp::endpoint& peer) {
    const Security& security = options_.security;
    const bool open = security.token.empty() || security.tls || security.insecure_token;
    if (!open && !peer.address().is_loopback()) {
      fail("everybody on the way could read the token; --tls, or --insecure-token");
      return;
    }
    if (security.tls) {
      tls_ = std::make_unique<tls::Channel>(*security.tls, options_.host);
      write(tls_->take_output());
    } else {
      write(protocol::encode(protocol::StreamsAsked{security.token}));
    }
    read();
  }

  /// Our few words fit in any socket's buffer; still they are written to the end.
  void write(std::string words) {
    if (words.empty()) return;
    auto kept = std::make_shared<std::string>(std::move(words));
    asio::async_write(socket_, asio::buffer(*kept), [kept](const std::error_code&, std::size_t) {});
  }

  void read() {
    socket_.async_read_some(asio::buffer(incoming_),
                            [this](const std::error_code& error, std::size_t size) {
                              if (result_) return;
                              if (error) {
                                fail("ended the connection without a list of its streams");
                              } else {
                                on_read({incoming_.data(), size});
                              }
                            });
  }

  void on_read(std::string_view bytes) {
    std::string plain;
    if (tls_) {
      const bool before = tls_->ready();
      const bool good = tls_->received(bytes, plain);
      if (good && tls_->ready() && !before) {
        tls_->send(protocol::encode(protocol::StreamsAsked{options_.security.token}));
      }
      write(tls_->take_output());
      if (!good) {
        fail(tls_->reason());
        return;
      }
      bytes = plain;
    }
    look(bytes);
    if (!result_) read();
  }

  void look(std::string_view bytes) {
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

  void fail(const std::string& why) {
    end(Error{ErrorKind::Network, peer_name(options_) + ": " + why});
  }

  void end(Result<Names> result) {
    if (result_) return;
    result_ = std::move(result);
    std::error_code ignored;
    lookup_.cancel();
    timer_.cancel();
    socket_.close(ignored);
  }

  const RemoteOptions& options_;
  asio::io_context io_{1};
  asio::steady_timer timer_{io_};
  link::NameLookup lookup_{io_};
  link::Addresses addresses_;
  tcp::socket socket_{io_};
  std::unique_ptr<tls::Channel> tls_;  ///< nothing: plain
  protocol::ServerPacketDecoder decoder_;
  std::array<char, 4096> incoming_{};
  std::optional<Result<Names>> result_;
};

}  // namespace

Result<std::vector<std::string>> list_streams(const RemoteOptions& options) {
  // Asio throws when the system has no thread or descriptor left for it.
  try {
    return Question(options).ask();
  } catch (const std::system_error& failure) {
    return Error{ErrorKind::Network, peer_name(options) + ": " + failure.code().message() +
                                         "; the system is short of threads or files"};
  }
}

}  // namespace aucast::net
