#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "common/preview/seen.h"
#include "common/result.h"

namespace aucast::preview {

/// The stream can be played at this address, on this host only.
struct Listening {
  std::string address;  ///< ADDR:PORT
  std::string token;    ///< to be shown there; empty: none
};
/// Others can connect at this address.
struct Live {
  std::string address;
};
/// Others can no longer connect.
struct Private {};
/// How many others are connected.
struct Watching {
  std::size_t count = 0;
};
/// An order was refused; the sentence says why.
struct Refused {
  std::string sentence;
};
using Record = std::variant<Listening, Seen, Live, Private, Watching, Refused>;

/// Takes records out of bytes that come in pieces. Keeps no more than one record and what was fed
/// last. Pure. Thread: none of its own.
class PreviewReader {
 public:
  void feed(std::string_view bytes) { bytes_ += bytes; }

  /// Returns the next record; nullopt: more bytes are needed. Fails with BadData for anything that
  /// is no record, and then in every later call.
  [[nodiscard]] Result<std::optional<Record>> next();

  /// The most bytes of a line, and of a text of AUs.
  static constexpr std::size_t kTextMax = 4096;

 private:
  [[nodiscard]] Result<std::optional<Record>> take_seen(std::string_view line,
                                                        std::size_t line_bytes);
  [[nodiscard]] Result<std::optional<Record>> take_line(std::string_view line,
                                                        std::size_t line_bytes);
  [[nodiscard]] Error broken(std::string_view line);

  std::string bytes_;
  bool broken_ = false;
};

}  // namespace aucast::preview
