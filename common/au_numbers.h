#pragma once

#include <cstdint>

namespace aucast {

// AUs that the code names. Left and right are the subject's own.
inline constexpr std::uint8_t kInnerBrowRaiser = 1;
inline constexpr std::uint8_t kOuterBrowRaiser = 2;
inline constexpr std::uint8_t kBrowLowerer = 4;
inline constexpr std::uint8_t kUpperLidRaiser = 5;
inline constexpr std::uint8_t kCheekRaiser = 6;
inline constexpr std::uint8_t kLidTightener = 7;
inline constexpr std::uint8_t kUpperLipRaiser = 10;
inline constexpr std::uint8_t kLipCornerPuller = 12;
inline constexpr std::uint8_t kSharpLipPuller = 13;
inline constexpr std::uint8_t kDimpler = 14;
inline constexpr std::uint8_t kLipCornerDepressor = 15;
inline constexpr std::uint8_t kLowerLipDepressor = 16;
inline constexpr std::uint8_t kChinRaiser = 17;
inline constexpr std::uint8_t kLipPucker = 18;
inline constexpr std::uint8_t kTongueShow = 19;
inline constexpr std::uint8_t kLipStretcher = 20;
inline constexpr std::uint8_t kLipFunneler = 22;
inline constexpr std::uint8_t kLipTightener = 23;
inline constexpr std::uint8_t kLipPresser = 24;
inline constexpr std::uint8_t kLipsPart = 25;
inline constexpr std::uint8_t kJawDrop = 26;
inline constexpr std::uint8_t kMouthStretch = 27;
inline constexpr std::uint8_t kLipsSuck = 28;
inline constexpr std::uint8_t kBite = 32;
inline constexpr std::uint8_t kBlink = 45;
inline constexpr std::uint8_t kHeadLeft = 51;
inline constexpr std::uint8_t kHeadRight = 52;
inline constexpr std::uint8_t kHeadUp = 53;
inline constexpr std::uint8_t kHeadDown = 54;
inline constexpr std::uint8_t kHeadTiltLeft = 55;
inline constexpr std::uint8_t kHeadTiltRight = 56;
inline constexpr std::uint8_t kHeadForward = 57;
inline constexpr std::uint8_t kHeadBack = 58;
inline constexpr std::uint8_t kEyesLeft = 61;
inline constexpr std::uint8_t kEyesRight = 62;
inline constexpr std::uint8_t kEyesUp = 63;
inline constexpr std::uint8_t kEyesDown = 64;

}  // namespace aucast
