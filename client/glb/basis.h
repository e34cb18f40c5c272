#pragma once

#include <cstdint>

namespace aucast::glb {

/// What each morph target of a file stands for.
enum class Basis : std::uint8_t {
  Muscles,  ///< a muscle or a lid: closest to the face that the player shows
  Aus,      ///< an Action Unit on one side: easy to drive by hand
};

}  // namespace aucast::glb
