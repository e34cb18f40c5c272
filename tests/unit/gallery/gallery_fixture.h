#pragma once

#include <string>
#include <vector>

#include "client/gallery/gallery_plan.h"
#include "protocol/codec.h"

namespace aucast::gallery {

/// A face of six channels: AU 12 on both sides, 26 by the jaw, 46 as a wink, 51 by the head.
inline face::Face small_gallery_face() {
  face::Face face;
  face.name = "small";
  face.channels = {{"left_zygomaticus_major", Side::Left, 2, false},
                   {"right_zygomaticus_major", Side::Right, 2, false},
                   {"jaw", Side::Both, 4, false},
                   {"left_lid_close", Side::Left, 1, true},
                   {"right_lid_close", Side::Right, 1, true},
                   {"head_turn_left", Side::Both, 1, false}};
  const auto record = [&face](int number, std::vector<float> activation, std::string note) {
    face.recordings[number] = {number, std::move(activation), std::move(note)};
  };
  record(0, {0, 0, 0, 0, 0, 0}, "neutral");
  record(12, {1, 1, 0, 0, 0, 0}, "corners");
  record(26, {0, 0, 2, 0, 0, 0}, "its best form on this mesh");
  record(46, {0, 0, 0, 1, 1, 0}, "");
  record(51, {0, 0, 0, 0, 0, 1}, "");
  return face;
}

inline Expression named(const std::string& name, const std::string& aus,
                        const std::string& source) {
  Expression expression;
  expression.name = name;
  expression.label = name;
  expression.aus = *protocol::parse_au_set(aus);
  expression.source = source;
  return expression;
}

/// The names that sections look for, Waters' among them.
inline std::vector<Expression> small_expressions() {
  std::vector<Expression> list;
  for (const char* emotion : {"surprise", "fear", "disgust", "anger", "happiness", "sadness"}) {
    list.push_back(named(emotion, "12", "guide"));
    list.push_back(named(std::string("thesis-") + emotion, "12,26", "thesis"));
    list.push_back(named(std::string("waters-") + emotion, "0", "waters"));
    list.back().muscles = {{"zygomaticus_major", {"Zygomatic_Major"}, 1.0F, 0.5F}};
  }
  return list;
}

inline GalleryRules empty_rules() {
  GalleryRules rules;
  rules.chosen.name = "facs";
  rules.facs.name = "facs";
  rules.kumar2010.name = "kumar2010";
  rules.none.name = "none";
  return rules;
}

/// All that a plan borrows from, and the plan.
struct PlannedGallery {
  face::Face face = small_gallery_face();
  std::vector<Expression> expressions = small_expressions();
  GalleryRules rules = empty_rules();

  [[nodiscard]] Result<GalleryPlan> plan(std::set<std::string> only = {},
                                         std::vector<std::string> sweeps = {}) const {
    return plan_gallery(
        {face, expressions, rules, face::Mixer::Maximum, std::move(only), std::move(sweeps)});
  }
};

}  // namespace aucast::gallery
