#include "client/gallery/gallery_plan.h"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "client/gallery/gallery_sections.h"
#include "common/mixed_bits.h"

namespace aucast::gallery {
namespace {

/// AUs whose asymmetry FACS scores with L and R. Lids as a pair, the jaw, lips as a ring, head and
/// gaze are not among them.
constexpr std::array kSided{1,  2,  4,  5,  6,  7,  9,  10, 11, 12,
                            13, 14, 15, 16, 20, 30, 34, 35, 36, 46};

/// The thesis' appendix C, tables 1 and 2.
constexpr std::array kNamed{1,  2,  4,  5,  6,  7,  9,  10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20,
                            21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38,
                            39, 43, 45, 46, 51, 52, 53, 54, 55, 56, 57, 58, 61, 62, 63, 64, 65, 66};

/// Words in a recording's note which say that the mesh cannot show the AU well.
constexpr std::string_view kLimited = "best form";

/// File systems take names of 255 bytes; a file that is not complete yet has a longer one.
constexpr std::size_t kStemMax = 200;

}  // namespace

bool is_limited(const Coverage& row) {
  return row.note.find(kLimited) != std::string::npos;
}

float sweep_strength(int time_ms) {
  const auto rise = [](int passed, int whole) {
    const double mu = std::clamp(static_cast<double>(passed) / whole, 0.0, 1.0);
    return static_cast<float>((1.0 - std::cos(std::numbers::pi * mu)) / 2.0);
  };
  if (time_ms < kApexMs) return rise(time_ms - kOnsetMs, kApexMs - kOnsetMs);
  if (time_ms <= kOffsetMs) return 1;
  return rise(kSweepEndMs - time_ms, kSweepEndMs - kOffsetMs);
}

bool is_sided(const face::Face& face, int number) {
  if (std::find(kSided.begin(), kSided.end(), number) == kSided.end()) return false;
  const auto found = face.recordings.find(number);
  if (found == face.recordings.end()) return false;
  bool left = false;
  bool right = false;
  for (std::size_t i = 0; i < face.channels.size(); ++i) {
    if (found->second.activation[i] <= 0) continue;
    left = left || face.channels[i].side == Side::Left;
    right = right || face.channels[i].side == Side::Right;
  }
  return left && right;
}

std::vector<Coverage> coverage_of(const face::Face& face) {
  std::set<int> numbers(kNamed.begin(), kNamed.end());
  for (const auto& [number, recording] : face.recordings) {
    if (number != 0) numbers.insert(number);
  }
  std::vector<Coverage> table;
  for (const int number : numbers) {
    Coverage row;
    row.number = number;
    row.name = std::string(facs_name(number).value_or("not named by FACS"));
    if (const auto found = face.recordings.find(number); found != face.recordings.end()) {
      row.recorded = true;
      row.sided = is_sided(face, number);
      row.note = found->second.note;
      for (std::size_t i = 0; i < face.channels.size(); ++i) {
        if (found->second.activation[i] > 0) row.drives.push_back(face.channels[i].name);
      }
    }
    table.push_back(std::move(row));
  }
  return table;
}

std::string file_stem(const AuFrame& aus) {
  std::string stem;
  for (const AuTerm& term : canonical_terms(aus)) {
    std::array<char, 24> text{};
    const char* side = term.side == Side::Left ? "L" : term.side == Side::Right ? "R" : "";
    std::snprintf(text.data(), text.size(), "au%s%02d", side, term.number);
    if (!stem.empty()) stem += '_';
    stem += text.data();
    if (term.percent != 100) stem += "-" + std::to_string(term.percent);
  }
  if (stem.size() <= kStemMax) return stem;
  std::uint64_t mixed = 0;
  for (const char c : stem) mixed = SplitMix64(mixed ^ static_cast<unsigned char>(c)).next();
  std::array<char, 20> digits{};
  std::snprintf(digits.data(), digits.size(), "-%016" PRIx64, mixed);
  return stem.substr(0, kStemMax - 17) + digits.data();
}

Result<GalleryPlan> plan_gallery(const GalleryInput& input) {
  GalleryPlanner planner(input);
  planner.add_sections();
  if (auto swept = planner.add_sweeps(); !swept) return swept.error();
  return planner.take();
}

}  // namespace aucast::gallery
