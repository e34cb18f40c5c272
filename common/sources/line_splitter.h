#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace aucast::sources {

/// Splits bytes that come in pieces into lines. A line is complete when its end, LF, CRLF or CR,
/// has come; one longer than `bytes_max` as soon as that many have, and the rest of it is left out.
class LineSplitter {
 public:
  struct Line {
    std::string text;        ///< without its end
    std::size_t number = 0;  ///< from 1
    bool too_long = false;   ///< `text` is only the line's beginning, and its end need not be there
  };

  explicit LineSplitter(std::size_t bytes_max) : bytes_max_(bytes_max) {}

  /// Takes bytes, which must stay valid until next() returns nullopt.
  void feed(std::string_view bytes) { fed_ = bytes; }
  /// The next whole line; nullopt when the bytes are used up.
  [[nodiscard]] std::optional<Line> next();
  /// Drops the beginning of a line whose end has not come. Returns whether there was any.
  bool drop_partial();
  /// Counts lines from 1 again.
  void restart();

 private:
  std::size_t bytes_max_;
  std::string_view fed_;
  std::string partial_;
  bool skipping_ = false;      ///< the rest of a line that was too long
  bool after_return_ = false;  ///< the last line ended in CR: an LF that follows belongs to it
  std::size_t number_ = 0;
};

}  // namespace aucast::sources
