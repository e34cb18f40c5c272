#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "common/time.h"
#include "protocol/answer_window.h"
#include "protocol/live_channel.h"
#include "protocol/packet.h"
#include "protocol/packet_writer.h"

namespace aucast::protocol {

/// Sends a live stream to one client, from the present moment, with its voice and captions if the
/// client gets them. Leaves out moments that the client was too slow for. See Delivery for what the
/// functions do. Thread: none of its own.
class LiveDelivery {
 public:
  /// What is passed by reference must outlive this object.
  LiveDelivery(const LiveChannel& channel, AnswerWindow& window, PacketWriter& writer)
      : channel_(channel), window_(window), writer_(writer) {}

  void grant(const HelloAsked& asked, HelloGranted& granted);
  void pump(std::string& out);
  void pump_new_moments(std::string& out);
  /// The next packet must not be changes-only, since the client has paused.
  void send_full_next() { full_next_ = true; }
  [[nodiscard]] bool complete() const { return window_.settled() && at_end(); }

 private:
  [[nodiscard]] bool at_end() const;
  [[nodiscard]] std::string_view packet_of(const LiveMoment& moment, bool full) const;
  void send_moment(const LiveMoment& moment, std::string& out);
  void skip_spoken_before(Milliseconds place);
  [[nodiscard]] Milliseconds spoken_end() const;
  void send_spoken(std::string& out);

  const LiveChannel& channel_;
  AnswerWindow& window_;
  PacketWriter& writer_;
  bool granted_ = false;  ///< else in the classic form
  bool delta_ = false;    ///< the changes-only form was granted
  bool voice_ = false;
  bool text_ = false;

  bool full_next_ = true;
  std::optional<std::uint64_t> last_moment_;  ///< the number of the last moment sent
  std::uint64_t next_voice_ = 0;              ///< number in the channel
  std::uint64_t next_caption_ = 0;            ///< likewise
  Milliseconds sent_to_{0};                   ///< the client's clock: the times of the moments sent
  Milliseconds shift_{0};  ///< what to add to a place on the channel's clock to get the client's
  // On the channel's clock.
  Milliseconds joined_at_{0};   ///< where the first moment sent begins
  Milliseconds heard_from_{0};  ///< voice that begins before is left out
};

}  // namespace aucast::protocol
