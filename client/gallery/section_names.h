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

/// What is in each, for --help; empty: its name says it.
inline constexpr std::array<std::string_view, kSectionNames.size()> kSectionNotes{
    "each at A to E on the left, on the right and on both sides",
    "",
    "pairs of basic expressions",
    "the AUs of Kumar's thesis, 2010",
    "its expressions",
    "",
    "which AUs the face has"};

}  // namespace aucast::gallery
