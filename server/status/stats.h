#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <variant>

#include "common/time.h"
#include "protocol/server_session.h"

namespace aucast::server {

/// Why a client's connection ended, for reasons that its session does not know.
enum class EndedHere : std::uint8_t {
  HandedOver,  ///< the client is a publisher
  TimedOut,    ///< --client-timeout
  TlsFailed,
};
using ClientEnd = std::variant<protocol::CloseConnection::Why, EndedHere>;

/// The reason as --stats writes it: "finished", "timed out", ...
[[nodiscard]] std::string_view name(ClientEnd reason);

/// What one client was sent, from accept to close.
struct ClientRecord {
  std::uint64_t number = 0;  ///< counts from 1 in the order of arrival
  std::string peer;          ///< ADDR:PORT
  int level = 1;             ///< 1 classic, 2 negotiated
  std::string stream;        ///< empty when it ended before one was chosen
  protocol::SentCounts sent;
  std::uint64_t bytes_total = 0;  ///< all that the socket took, hello, error and {-2} included
  /// From when the first keyframe was given to the socket until the last answer had come and {-2}
  /// was due, or until the connection ended before that. Zero when no keyframe was sent.
  Duration send_time{0};
  ClientEnd end_reason{};  ///< when it has ended
};

/// Sums over connections; the fields are those of ClientRecord.
struct Totals {
  protocol::SentCounts sent;
  std::uint64_t bytes_total = 0;
  Duration send_time{0};

  void add(const ClientRecord& record);
};

/// What --stats reports. The totals count all that was sent; only the latest kRecordsMax records of
/// clients are kept, so that a transmitter may run for years.
class Stats {
 public:
  static constexpr std::size_t kRecordsMax = 1000;

  void add(ClientRecord record);
  /// Counts what was sent to a server that we have dialled, which is no client.
  void add_pushed(const ClientRecord& record) { totals_.add(record); }

  [[nodiscard]] const Totals& totals() const { return totals_; }
  [[nodiscard]] const std::map<std::string, std::uint64_t>& end_reasons() const {
    return end_reasons_;
  }

  /// One JSON object with one line per field and a newline at its end.
  [[nodiscard]] std::string to_json() const;

 private:
  std::deque<ClientRecord> records_;
  std::uint64_t clients_ = 0;  ///< including those whose records are not kept
  Totals totals_;
  std::map<std::string, std::uint64_t> end_reasons_;
};

}  // namespace aucast::server
