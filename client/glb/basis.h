#pragma once

#include <cstdint>

namespace aucast::glb {

/// What there is a morph target for.
enum class Basis : std::uint8_t {
  Muscles,  ///< each muscle and lid: close to the face that is played
  Aus,      ///< each Action Unit and side: for driving by hand
};

}  // namespace aucast::glb
