#pragma once

#include <array>
#include <string_view>

namespace aucast::gallery {

// The sections of a gallery, as `gallery --only` takes them.
inline constexpr std::string_view kAusSection = "aus";
inline constexpr std::string_view kPrototypesSection = "prototypes";
inline constexpr std::string_view kCombinationsSection = "combinations";
inline constexpr std::string_view kAppendixASection = "appendix-a";
inline constexpr std::string_view kAppendixBSection = "appendix-b";
inline constexpr std::string_view kSweepsSection = "sweeps";
inline constexpr std::string_view kCoverageSection = "coverage";

inline constexpr std::array kSectionNames{
    kAusSection,       kPrototypesSection, kCombinationsSection, kAppendixASection,
    kAppendixBSection, kSweepsSection,     kCoverageSection};

}  // namespace aucast::gallery
