#pragma once

#include <filesystem>
#include <string>

namespace aucast::mirror {

struct MirrorOptions {
  std::filesystem::path program;  ///< au-transmitter; empty: beside this program, or in $PATH
  std::string source = "camera";  ///< camera, camera:DEVICE, or a film or FIFO in its place
};

}  // namespace aucast::mirror
