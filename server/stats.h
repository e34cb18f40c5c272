#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

#include "common/time.h"

namespace aucast::server {

/// What one client got, from accept to close.
struct ClientRecord {
  std::uint64_t number = 0;       ///< counts from 1 in the order of arrival
  std::string peer;               ///< ADDR:PORT
  int level = 1;                  ///< 1 classic, 2 negotiated
  std::string stream;             ///< empty when it ended before one was chosen
  std::uint64_t packets = 0;      ///< keyframes handed out
  std::uint64_t bytes = 0;        ///< their bytes alone, as table 5.5 of the thesis counts them
  std::uint64_t bytes_total = 0;  ///< all bytes the socket took: with hello, error and {-2}
  /// From the first keyframe's handing to the socket until the last answer was in and {-2} was
  /// due, or until the connection ended without that. Zero when no keyframe went out.
  Duration send_time{0};
  std::string end_reason;
  std::uint64_t packets_merged = 0;  ///< live keyframes left out because the client was slow
  friend bool operator==(const ClientRecord&, const ClientRecord&) = default;
};

/// What --stats reports. Totals count every client; of the single records the latest
/// kRecordsMax are kept, so that a transmitter may run for years.
class Stats {
 public:
  static constexpr std::size_t kRecordsMax = 1000;

  void add(ClientRecord record);

  [[nodiscard]] const std::deque<ClientRecord>& records() const { return records_; }
  [[nodiscard]] std::uint64_t clients() const { return clients_; }

  /// One JSON object, a line per field, with a newline at its end.
  [[nodiscard]] std::string to_json() const;

 private:
  std::deque<ClientRecord> records_;
  std::uint64_t clients_ = 0;
  std::uint64_t packets_ = 0;
  std::uint64_t packets_merged_ = 0;
  std::uint64_t bytes_ = 0;
  std::uint64_t bytes_total_ = 0;
  Duration send_time_{0};
};

}  // namespace aucast::server
