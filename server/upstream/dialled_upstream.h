#pragma once

#include <functional>

#include <asio/io_context.hpp>

#include "server/upstream/dialled_address.h"
#include "server/upstream/redialler.h"
#include "server/upstream/upstream.h"

namespace aucast::server {

/// An aucast:// address as a source: dials the parents that it names, one at a time, and goes on to
/// the next when one is lost. There is one connection, however many clients there are.
/// Thread: that of the io_context, which must outlive it.
class DialledUpstream final : public Upstream {
 public:
  /// `on_moment` is called when the stream has something new.
  DialledUpstream(asio::io_context& io, DialledAddress from, Reception::Options options,
                  std::function<void()> on_moment);
  ~DialledUpstream() override { halt(); }

  [[nodiscard]] Result<void> start() override;
  void stop() override { halt(); }
  [[nodiscard]] const Reception& reception() const override { return reception_; }

 private:
  void halt();
  void on_over(const Parent::Outcome& outcome);

  DialledAddress from_;
  Reception reception_;
  Redialler redialler_;
};

}  // namespace aucast::server
