#pragma once

#include <filesystem>
#include <string>

namespace aucast::mirror {

/// What a Mirror shows, and by which program. Whether the files exist is not checked here.
struct MirrorOptions {
  std::filesystem::path program;  ///< au-transmitter; empty: beside this program, or in $PATH
  std::string source = "camera";  ///< camera, camera:DEVICE, or a film or FIFO in its place
  // For guests, while the mirror is live.
  std::filesystem::path token{};  ///< --token-file: the token that they must show; empty: none
  std::filesystem::path certificate{};  ///< --tls-cert; empty: no TLS
  std::filesystem::path key{};          ///< --tls-key
};

}  // namespace aucast::mirror
