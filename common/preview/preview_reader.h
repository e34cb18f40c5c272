#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "common/preview/seen.h"
#include "common/result.h"

namespace aucast::preview {

/// The stream can be played there, on this host.
struct Listening {
  std::string address;  ///< ADDR:PORT
};
/// Others can connect there.
struct Live {
  std::string address;
};
struct Private {};
/// How many of them are connected.
struct Watching {
  std::size_t count = 0;
};
struct Refused {
  std::string sentence;
};
using Record = std::variant<Listening, Seen, Live, Private, Watching, Refused>;

/// Takes records out of bytes as they come, however they are cut. Holds no more than one record and
/// what was fed last. Pure.
class PreviewReader {
 public:
  void feed(std::string_view bytes) { bytes_ += bytes; }

  /// The next record; nothing: more bytes are needed. BadData for anything else, and from then on.
  [[nodiscard]] Result<std::optional<Record>> next();

  /// The longest line, and the longest text of AUs.
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
