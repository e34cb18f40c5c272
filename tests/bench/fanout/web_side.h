#pragma once

#include <string>
#include <string_view>

namespace aucast::bench {

/// A viewer's side of a WebSocket, as far as au-transmitter needs one to be there: the upgrade,
/// texts of the server, Pongs.
class WebSide {
 public:
  /// What a viewer says first, before anything is known of the server.
  [[nodiscard]] static std::string upgrade();

  /// What came over the wire. Appends the texts of the server to `text`, and to `answer` what is to
  /// be sent: as soon as the server has agreed `greeting`, and Pongs. False: it is no WebSocket, or
  /// it was closed.
  [[nodiscard]] bool received(std::string_view wire, const std::string& greeting, std::string& text,
                              std::string& answer);

 private:
  [[nodiscard]] bool take_agreement(const std::string& greeting, std::string& answer);

  std::string held_;  ///< an incomplete reply or frame
  bool agreed_ = false;
};

}  // namespace aucast::bench
