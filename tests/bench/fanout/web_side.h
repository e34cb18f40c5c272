#pragma once

#include <string>
#include <string_view>

namespace aucast::bench {

/// A viewer's side of a WebSocket, with only what au-transmitter needs: the upgrade, texts of the
/// server, Pongs.
class WebSide {
 public:
  /// What a viewer sends first.
  [[nodiscard]] static std::string upgrade();

  /// Takes what came over the wire. Appends the texts of the server to `text`, and what is to be
  /// sent to `answer`: `greeting`, as soon as the server has agreed to the upgrade, and Pongs.
  /// Returns false if this is no WebSocket or was closed.
  [[nodiscard]] bool received(std::string_view wire, const std::string& greeting, std::string& text,
                              std::string& answer);

 private:
  [[nodiscard]] bool take_agreement(const std::string& greeting, std::string& answer);

  std::string held_;  ///< an incomplete reply or frame
  bool agreed_ = false;
};

}  // namespace aucast::bench
