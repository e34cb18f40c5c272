#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace aucast::sources {

/// Splits bytes that come in pieces into lines. A line is complete when its end has come: LF, CRLF
/// or CR. Of a line longer than `bytes_max` only the beginning is kept, so memory is bounded.
class LineSplitter {
 public:
  struct Line {
    std::string text;        ///< without its end
    std::size_t number = 0;  ///< from 1
    bool too_long = false;   ///< it was cut
  };

  explicit LineSplitter(std::size_t bytes_max) : bytes_max_(bytes_max) {}

  /// Takes bytes; they must outlive the calls of next() up to the one that returns nothing.
  void feed(std::string_view bytes) { fed_ = bytes; }
  /// The next whole line; nothing when the bytes are used up.
  [[nodiscard]] std::optional<Line> next();
  /// Forgets a line without its end; true when there was one.
  bool drop_partial();
  /// Counts lines from 1 again.
  void restart();

 private:
  std::size_t bytes_max_;
  std::string_view fed_;
  std::string partial_;
  bool cut_ = false;
  bool after_return_ = false;  ///< the last line ended in CR: an LF that follows belongs to it
  std::size_t number_ = 0;
};

}  // namespace aucast::sources
