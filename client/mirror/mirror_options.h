#pragma once

#include <filesystem>
#include <string>

namespace aucast::mirror {

/// What a Mirror shows, and by which program. Whether they exist is known only when it runs.
struct MirrorOptions {
  std::filesystem::path program;  ///< au-transmitter; empty: beside this program, or in $PATH
  std::string source = "camera";  ///< camera, camera:DEVICE, or a film or FIFO in its place
  // What guests are asked for while it is live.
  std::filesystem::path token{};        ///< of --token-file; empty: none
  std::filesystem::path certificate{};  ///< of --tls-cert; empty: no TLS
  std::filesystem::path key{};          ///< of --tls-key
};

}  // namespace aucast::mirror
