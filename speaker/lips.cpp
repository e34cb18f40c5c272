#include "speaker/lips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "common/au_numbers.h"
#include "speaker/visemes.h"

namespace aucast::speaker {
namespace {

constexpr float kLagOfLead = 0.6F;  ///< lips leave a sound faster than they come to it
constexpr double kReachMs = 450;    ///< beyond this a sound does not reach
constexpr float kRestWeight = 0.03F;

/// The lips of one sound, or of one half of a diphthong; times in ms.
struct Target {
  const Viseme* viseme;
  double core_begin;
  double core_end;

  [[nodiscard]] float weight(double t) const {
    const float lead = static_cast<float>(viseme->lead_ms) / 2;
    float away = 0;
    if (t < core_begin) away = static_cast<float>(core_begin - t) / std::max(lead, 20.0F);
    if (t > core_end) away = static_cast<float>(t - core_end) / std::max(lead * kLagOfLead, 20.0F);
    return viseme->dominance * std::exp(-away * away);
  }
};

/// A contact that must be there from `begin` to `end`.
struct Contact {
  double begin;
  double end;
  const Viseme* viseme;

  static constexpr double kAttackMs = 50;
  static constexpr double kReleaseMs = 40;

  /// How far it is made at a moment, in [0,1].
  [[nodiscard]] float degree(double t) const {
    const double in = (t - (begin - kAttackMs)) / kAttackMs;
    const double out = (end + kReleaseMs - t) / kReleaseMs;
    return static_cast<float>(std::clamp(std::min(in, out), 0.0, 1.0));
  }
};

struct Plan {
  std::vector<Target> targets;
  std::vector<Contact> contacts;
};

void plan_pause(double begin, double end, Plan& plan) {
  // The lips come to rest a little after the voice does, and set out before it is back.
  constexpr double kAfter = 80;
  constexpr double kBefore = 120;
  if (end - begin < kAfter) return;
  plan.targets.push_back(
      {&pause_viseme(), begin + kAfter, std::max(begin + kAfter, end - kBefore)});
}

void plan_sound(const Phoneme& sound, double begin, double end, Plan& plan) {
  const Viseme* const viseme = viseme_of(sound.ipa);
  if (viseme == nullptr) return;
  const double length = end - begin;
  if (viseme->closes) {
    constexpr double kHeldMs = 50;
    const int before = closure_before_ms(sound.ipa);
    if (before > 0) {
      plan.contacts.push_back({begin - before, begin, viseme});
    } else {
      // The hum of an m is heard that much later than espeak-ng's mark of it.
      constexpr double kHumLateMs = 30;
      const double released = std::max(begin + std::min(kHeldMs, length), end - 20);
      plan.contacts.push_back({begin + kHumLateMs, released + kHumLateMs, viseme});
    }
  } else if (viseme->on_teeth) {
    plan.contacts.push_back({begin, begin + 0.7 * length, viseme});
  }
  if (const Viseme* const glide = glide_of(sound.ipa)) {
    plan.targets.push_back({viseme, begin + 0.1 * length, begin + 0.4 * length});
    plan.targets.push_back({glide, begin + 0.7 * length, begin + 0.9 * length});
  } else {
    plan.targets.push_back({viseme, begin + 0.1 * length, begin + 0.6 * length});
  }
}

Plan plan_of(const std::vector<Phoneme>& phonemes, Milliseconds end) {
  Plan plan;
  for (std::size_t i = 0; i < phonemes.size(); ++i) {
    const auto from = static_cast<double>(phonemes[i].begin.count());
    const auto to =
        static_cast<double>((i + 1 < phonemes.size() ? phonemes[i + 1].begin : end).count());
    if (phonemes[i].ipa.empty()) {
      plan_pause(from, to, plan);
    } else {
      plan_sound(phonemes[i], from, to, plan);
    }
  }
  return plan;
}

/// The intensities of the mouth's AUs at one moment.
class Mouth {
 public:
  void blend(const Viseme& viseme, float weight) {
    total_ += weight;
    for (const LipAu& au : viseme.aus) {
      if (au.number != 0) sum_[au.number] += weight * au.intensity;
    }
  }

  void settle() {
    for (auto& [number, value] : sum_) value /= total_;
  }

  void touch(const Contact& contact, float degree) {
    const auto keep = [&](int number, float share) {
      if (const auto found = sum_.find(number); found != sum_.end()) {
        found->second *= 1 - degree * (1 - share);
      }
    };
    keep(kJawDrop, 0.2F);
    keep(kTongueShow, 0);
    if (contact.viseme->on_teeth) {
      keep(kLipPresser, 0);
      keep(kLipPucker, 0.5F);
      keep(kLipFunneler, 0.5F);
    } else {
      for (const int open : {kLowerLipDepressor, kLipStretcher, kLipsPart, kBite}) keep(open, 0);
      keep(kLipFunneler, 0.4F);
    }
    for (const LipAu& au : contact.viseme->aus) {
      if (au.number == 0) continue;
      float& reached = sum_[au.number];
      reached = std::max(reached, degree * au.intensity);
    }
  }

  [[nodiscard]] const std::map<int, float>& aus() const { return sum_; }

 private:
  float total_ = kRestWeight;
  std::map<int, float> sum_;
};

}  // namespace

void move_lips(const std::vector<Phoneme>& phonemes, Milliseconds end, Curves& curves) {
  const Plan plan = plan_of(phonemes, end);
  std::size_t first = 0;
  std::size_t first_contact = 0;
  for (std::size_t step = 0; step < curves.steps; ++step) {
    const auto t = static_cast<double>(step) * static_cast<double>(Curves::kStep.count());
    Mouth mouth;
    while (first < plan.targets.size() && plan.targets[first].core_end + kReachMs < t) ++first;
    for (std::size_t i = first; i < plan.targets.size(); ++i) {
      if (plan.targets[i].core_begin - kReachMs > t) break;
      mouth.blend(*plan.targets[i].viseme, plan.targets[i].weight(t));
    }
    mouth.settle();
    while (first_contact < plan.contacts.size() &&
           plan.contacts[first_contact].end + kReachMs < t) {
      ++first_contact;
    }
    for (std::size_t i = first_contact; i < plan.contacts.size(); ++i) {
      if (plan.contacts[i].begin - kReachMs > t) break;
      mouth.touch(plan.contacts[i], plan.contacts[i].degree(t));
    }
    for (const auto& [number, intensity] : mouth.aus()) {
      float& sample = curves.of(number)[step];
      sample = std::max(sample, intensity);
    }
  }
}

}  // namespace aucast::speaker
