#include "speaker/alignment.h"

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <numbers>

namespace aucast::speaker {
namespace {

constexpr std::size_t kBands = 26;
constexpr double kLowHz = 100;
constexpr double kHighHz = 7500;

double mel(double hz) {
  return 1127 * std::log(1 + hz / 700);
}

/// Power spectra of windows of one length.
class Spectrum {
 public:
  Spectrum(std::size_t window, int rate) : window_(window) {
    while (size_ < window) size_ *= 2;
    in_.reset(fftwf_alloc_real(size_));
    out_.reset(fftwf_alloc_complex(size_ / 2 + 1));
    plan_.reset(
        fftwf_plan_dft_r2c_1d(static_cast<int>(size_), in_.get(), out_.get(), FFTW_ESTIMATE));
    for (std::size_t i = 0; i < window; ++i) {
      const double x = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(window);
      hamming_.push_back(static_cast<float>(0.54 - 0.46 * std::cos(x)));
    }
    const double bottom = mel(kLowHz);
    const double width = (mel(kHighHz) - bottom) / (kBands + 1);
    for (std::size_t bin = 0; bin <= size_ / 2; ++bin) {
      const double hz = static_cast<double>(bin) * rate / static_cast<double>(size_);
      places_.push_back((mel(hz) - bottom) / width);
    }
  }

  /// The logarithm of the energy in each band of a window that begins at `samples`.
  [[nodiscard]] std::array<float, kBands> bands(std::span<const float> samples, float before) {
    constexpr float kPreEmphasis = 0.97F;
    constexpr float kFloor = 1e-7F;
    std::fill_n(in_.get(), size_, 0.0F);
    for (std::size_t i = 0; i < window_; ++i) {
      in_.get()[i] = (samples[i] - kPreEmphasis * (i == 0 ? before : samples[i - 1])) * hamming_[i];
    }
    fftwf_execute(plan_.get());
    std::array<float, kBands> energy{};
    for (std::size_t bin = 0; bin < places_.size(); ++bin) {
      // Triangles that overlap by half: band k is centred at k + 1.
      const double place = places_[bin];
      if (place <= 0 || place >= kBands + 1) continue;
      const float* const value = out_.get()[bin];
      const float power = value[0] * value[0] + value[1] * value[1];
      const auto below = static_cast<std::size_t>(place);
      const auto share = static_cast<float>(place - static_cast<double>(below));
      if (below >= 1) energy[below - 1] += (1 - share) * power;
      if (below < kBands) energy[below] += share * power;
    }
    for (float& value : energy) value = std::log(value + kFloor);
    return energy;
  }

 private:
  struct Free {
    void operator()(void* memory) const { fftwf_free(memory); }
  };
  struct DestroyPlan {
    void operator()(fftwf_plan_s* plan) const { fftwf_destroy_plan(plan); }
  };

  std::size_t window_;
  std::size_t size_ = 1;
  std::unique_ptr<float, Free> in_;
  std::unique_ptr<fftwf_complex, Free> out_;
  std::unique_ptr<fftwf_plan_s, DestroyPlan> plan_;
  std::vector<float> hamming_;
  std::vector<double> places_;  ///< of each bin, in bands
};

/// The first coefficients of the cosine transform of the bands.
void add_cosines(const std::array<float, kBands>& bands, std::vector<float>& rows) {
  for (std::size_t k = 0; k < Cepstrum::kCoefficients; ++k) {
    double sum = 0;
    for (std::size_t i = 0; i < kBands; ++i) {
      const double angle =
          std::numbers::pi * static_cast<double>(k) * (static_cast<double>(i) + 0.5) / kBands;
      sum += static_cast<double>(bands[i]) * std::cos(angle);
    }
    rows.push_back(static_cast<float>(sum));
  }
}

void normalise(Cepstrum& cepstrum) {
  const std::size_t n = cepstrum.windows();
  for (std::size_t k = 0; n > 0 && k < Cepstrum::kCoefficients; ++k) {
    double sum = 0;
    double squares = 0;
    for (std::size_t i = k; i < cepstrum.rows.size(); i += Cepstrum::kCoefficients) {
      sum += static_cast<double>(cepstrum.rows[i]);
      squares += static_cast<double>(cepstrum.rows[i]) * static_cast<double>(cepstrum.rows[i]);
    }
    const double mean = sum / static_cast<double>(n);
    const double deviation =
        std::sqrt(std::max(squares / static_cast<double>(n) - mean * mean, 1e-9));
    for (std::size_t i = k; i < cepstrum.rows.size(); i += Cepstrum::kCoefficients) {
      cepstrum.rows[i] =
          static_cast<float>((static_cast<double>(cepstrum.rows[i]) - mean) / deviation);
    }
  }
}

float distance(const Cepstrum& a, std::size_t i, const Cepstrum& b, std::size_t j) {
  const float* const x = &a.rows[i * Cepstrum::kCoefficients];
  const float* const y = &b.rows[j * Cepstrum::kCoefficients];
  float sum = 0;
  for (std::size_t k = 0; k < Cepstrum::kCoefficients; ++k) sum += (x[k] - y[k]) * (x[k] - y[k]);
  return std::sqrt(sum);
}

/// Which windows of b are considered for each of a: [first, last).
struct Band {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Where the cheapest way to a pair of windows comes from.
enum class Step : std::uint8_t { None, Both, OfA, OfB };

/// Dynamic time warping within a band for each window of a. No path is found through sounds whose
/// samples are no numbers: none of their distances is less than another.
AlignmentPath warp(const Cepstrum& a, const Cepstrum& b, const std::vector<Band>& bands) {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  std::vector<std::vector<Step>> steps(a.windows());
  std::vector<float> before;
  Band band_before{};
  for (std::size_t i = 0; i < a.windows(); ++i) {
    const Band band = bands[i];
    std::vector<float> costs(band.last - band.first, kNever);
    steps[i].resize(costs.size());
    const auto above = [&](std::size_t j) {
      const bool inside = i > 0 && j >= band_before.first && j < band_before.last;
      return inside ? before[j - band_before.first] : kNever;
    };
    for (std::size_t j = band.first; j < band.last; ++j) {
      const std::size_t at = j - band.first;
      float cheapest = i == 0 && j == 0 ? 0 : kNever;
      const auto take = [&](float cost, Step step) {
        if (!(cost < cheapest)) return;
        cheapest = cost;
        steps[i][at] = step;
      };
      if (j > 0) take(above(j - 1), Step::Both);
      take(above(j), Step::OfA);
      if (at > 0) take(costs[at - 1], Step::OfB);
      costs[at] = cheapest + distance(a, i, b, j);
    }
    before = std::move(costs);
    band_before = band;
  }
  // Back from the end. Each step leads to a pair that has a cost, so it stays within the bands.
  AlignmentPath path{{a.windows() - 1, b.windows() - 1}};
  while (true) {
    auto [i, j] = path.back();
    const Step step = steps[i][j - bands[i].first];
    if (step == Step::None) break;
    if (step != Step::OfB) --i;
    if (step != Step::OfA) --j;
    path.emplace_back(i, j);
  }
  if (path.back() != std::pair<std::size_t, std::size_t>()) return {};
  std::reverse(path.begin(), path.end());
  return path;
}

/// A coarser cepstrum: each window is the mean of `by` windows.
Cepstrum coarser(const Cepstrum& fine, std::size_t by) {
  Cepstrum coarse;
  for (std::size_t begin = 0; begin < fine.windows(); begin += by) {
    const std::size_t end = std::min(begin + by, fine.windows());
    for (std::size_t k = 0; k < Cepstrum::kCoefficients; ++k) {
      float sum = 0;
      for (std::size_t i = begin; i < end; ++i) sum += fine.rows[i * Cepstrum::kCoefficients + k];
      coarse.rows.push_back(sum / static_cast<float>(end - begin));
    }
  }
  return coarse;
}

/// Bands around the diagonal, of `reach` windows to either side, or of more where b is so much
/// longer that neighbouring bands would not touch.
std::vector<Band> diagonal(std::size_t a, std::size_t b, std::size_t reach) {
  reach = std::max(reach, b / a + 1);
  std::vector<Band> bands(a);
  for (std::size_t i = 0; i < a; ++i) {
    const std::size_t centre = i * b / a;
    bands[i] = {centre > reach ? centre - reach : 0, std::min(centre + reach + 1, b)};
  }
  bands.front().first = 0;
  bands.back().last = b;
  return bands;
}

/// Bands around a path through cepstra that are `by` times coarser.
std::vector<Band> around(const AlignmentPath& coarse, std::size_t by, std::size_t a, std::size_t b,
                         std::size_t reach) {
  std::vector<Band> bands(a, Band{b, 0});
  for (const auto& [i, j] : coarse) {
    const std::size_t first = j * by > reach ? j * by - reach : 0;
    const std::size_t last = std::min((j + 1) * by + reach, b);
    for (std::size_t k = i * by; k < std::min((i + 1) * by, a); ++k) {
      bands[k].first = std::min(bands[k].first, first);
      bands[k].last = std::max(bands[k].last, last);
    }
  }
  bands.front().first = 0;
  bands.back().last = b;
  return bands;
}

float likeness(const Cepstrum& a, const Cepstrum& b, const AlignmentPath& path) {
  const auto loudness = [](const Cepstrum& sound, std::size_t window) {
    return static_cast<double>(sound.rows[window * Cepstrum::kCoefficients]);
  };
  const auto n = static_cast<double>(path.size());
  double x = 0;
  double y = 0;
  double xx = 0;
  double yy = 0;
  double xy = 0;
  for (const auto& [i, j] : path) {
    const double in_a = loudness(a, i);
    const double in_b = loudness(b, j);
    x += in_a;
    y += in_b;
    xx += in_a * in_a;
    yy += in_b * in_b;
    xy += in_a * in_b;
  }
  // Of a sound that never changes, rounding alone is left.
  constexpr double kVarianceMin = 1e-3;
  const double variance_a = xx / n - x / n * x / n;
  const double variance_b = yy / n - y / n * y / n;
  if (path.empty() || std::min(variance_a, variance_b) < kVarianceMin) return 0;
  const double together = xy / n - x / n * y / n;
  return static_cast<float>(together / std::sqrt(variance_a * variance_b));
}

}  // namespace

Cepstrum cepstrum_of(std::span<const float> samples, int rate) {
  const auto per_ms = [rate](std::size_t ms) { return ms * static_cast<std::size_t>(rate) / 1000; };
  const std::size_t length = per_ms(32);
  Cepstrum cepstrum;
  Spectrum spectrum(length, rate);
  for (std::size_t window = 0;; ++window) {
    const std::size_t at = per_ms(window * static_cast<std::size_t>(Cepstrum::kHop.count()));
    if (at + length > samples.size()) break;
    add_cosines(spectrum.bands(samples.subspan(at, length), at == 0 ? 0 : samples[at - 1]),
                cepstrum.rows);
  }
  normalise(cepstrum);
  return cepstrum;
}

AlignmentPath align(const Cepstrum& a, const Cepstrum& b) {
  constexpr std::size_t kCoarser = 20;       // 200 ms
  constexpr std::size_t kCoarseReach = 300;  // a minute beside the diagonal
  constexpr std::size_t kReach = 100;        // a second beside the coarse path
  if (a.windows() == 0 || b.windows() == 0) return {};
  const Cepstrum coarse_a = coarser(a, kCoarser);
  const Cepstrum coarse_b = coarser(b, kCoarser);
  const AlignmentPath coarse =
      warp(coarse_a, coarse_b, diagonal(coarse_a.windows(), coarse_b.windows(), kCoarseReach));
  if (coarse.empty()) return {};
  return warp(a, b, around(coarse, kCoarser, a.windows(), b.windows(), kReach));
}

CarriedOver carried_over(const Speech& synthesised, std::vector<float> narration, int rate) {
  const Cepstrum made = cepstrum_of(synthesised.samples, synthesised.rate);
  const Cepstrum read = cepstrum_of(narration, rate);
  const AlignmentPath path = align(made, read);
  const auto moved = [&path](Milliseconds time) {
    const auto hop = Cepstrum::kHop;
    const auto window = static_cast<std::size_t>(time / hop);
    // Where one window belongs to several the middle one is the likeliest.
    const auto [first, last] =
        std::equal_range(path.begin(), path.end(), std::pair{window, std::size_t{0}},
                         [](const auto& x, const auto& y) { return x.first < y.first; });
    if (first == last) return path.empty() ? time : hop * static_cast<int>(path.back().second);
    const std::size_t middle = (first->second + std::prev(last)->second) / 2;
    return hop * static_cast<int>(middle) + time % hop;
  };
  Speech speech;
  speech.rate = rate;
  speech.samples = std::move(narration);
  // None before the one that comes before it, and none after the end.
  const auto carried = [&moved, length = speech.length()](Milliseconds time, Milliseconds& last) {
    return last = std::max(last, std::min(moved(time), length));
  };
  Milliseconds last{0};
  for (const Phoneme& phoneme : synthesised.phonemes) {
    speech.phonemes.push_back({phoneme.ipa, carried(phoneme.begin, last)});
  }
  last = Milliseconds::zero();
  for (const Word& word : synthesised.words) {
    speech.words.push_back({carried(word.begin, last), word.at, word.length});
  }
  last = Milliseconds::zero();
  for (const Milliseconds end : synthesised.clause_ends) {
    speech.clause_ends.push_back(carried(end, last));
  }
  return {std::move(speech), likeness(made, read, path)};
}

}  // namespace aucast::speaker
