#include "client/gallery/gallery_plan.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/process.h"
#include "tests/unit/gallery/gallery_fixture.h"

namespace aucast::gallery {
namespace {

std::set<std::string> files_of(const GalleryPlan& plan) {
  std::set<std::string> files;
  for (const GalleryPicture& picture : plan.pictures) files.insert(picture.file);
  return files;
}

const GalleryPicture& named_picture(const GalleryPlan& plan, const std::string& file) {
  const auto found = std::find_if(plan.pictures.begin(), plan.pictures.end(),
                                  [&](const GalleryPicture& one) { return one.file == file; });
  EXPECT_NE(found, plan.pictures.end()) << file;
  static const GalleryPicture kNothing;
  return found == plan.pictures.end() ? kNothing : *found;
}

TEST(GalleryPlan, HasEveryAuWithEveryLetterAndTheSidesThatFacsScores) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"aus"});
  ASSERT_TRUE(plan.has_value());
  const auto files = files_of(*plan);
  for (const char letter : std::string("ABCDE")) {
    for (const char* stem : {"au12_?_both", "au12_?_left", "au12_?_right", "au26_?", "au46_?_left",
                             "au46_?_right", "au51_?"}) {
      std::string file = std::string("au/") + stem + ".png";
      file.replace(file.find('?'), 1, 1, letter);
      EXPECT_TRUE(files.contains(file)) << file;
    }
  }
  EXPECT_TRUE(files.contains("au/neutral.png"));
  EXPECT_EQ(files.size(), 1U + 7U * 5U);
  const GalleryPicture& left = named_picture(*plan, "au/au12_C_left.png");
  EXPECT_EQ(protocol::format_au_set(left.aus), "L12:50");
  EXPECT_EQ(left.rules, "facs");
}

TEST(GalleryPlan, HasTheSectionsInTheOrderOfThePage) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan();
  ASSERT_TRUE(plan.has_value());
  std::vector<std::string> names;
  for (const GallerySection& section : plan->sections) names.push_back(section.name);
  EXPECT_EQ(names, (std::vector<std::string>{"aus", "prototypes", "combinations", "appendix-a",
                                             "appendix-b"}));
  EXPECT_EQ(files_of(*plan).size(), plan->pictures.size()) << "a file is planned once";
}

TEST(GalleryPlan, CombinesTheSixInFifteenPairs) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"combinations"});
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ(plan->pictures.size(), 30U);
  const GalleryPicture& pair = named_picture(*plan, "combinations/surprise_happiness.png");
  EXPECT_EQ(pair.sources, (std::vector<std::string>{"surprise", "happiness"}));
}

TEST(GalleryPlan, SetsAppendixBBesideWaters) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"appendix-b"});
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ(plan->pictures.size(), 6U * 2U * 3U + 6U);
  const GalleryPicture& one = named_picture(*plan, "appendix_b/anger_average_kumar2010.png");
  EXPECT_EQ(one.mixer, face::Mixer::Average);
  EXPECT_EQ(one.rules, "kumar2010");
  const auto& block = plan->sections.front().blocks.front();
  EXPECT_EQ(block.columns.size(), 4U);
  EXPECT_EQ(block.rows.size(), 6U);
  EXPECT_EQ(plan->pictures[*block.rows[0].figures[0].picture].muscles.size(), 1U);
}

TEST(GalleryPlan, LeavesTheCellEmptyOnAFaceWithoutTheMuscle) {
  PlannedGallery gallery;
  gallery.expressions[2].muscles.front().name = "nowhere";
  gallery.expressions[2].muscles.front().spellings.clear();
  const auto plan = gallery.plan({"appendix-b"});
  ASSERT_TRUE(plan.has_value());
  EXPECT_FALSE(plan->sections[0].blocks[0].rows[0].figures[0].picture.has_value());
}

TEST(GalleryPlan, ASweepGoesUpHoldsAndComesBack) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"sweeps"}, {"L12:80", "happiness"});
  ASSERT_TRUE(plan.has_value());
  ASSERT_EQ(plan->sweeps.size(), 2U);
  EXPECT_EQ(plan->sweeps[0].name, "auL12-80");
  EXPECT_EQ(plan->sweeps[0].count, 41U);
  EXPECT_EQ(plan->pictures[0].file, "sweeps/auL12-80/frame_000001.png");
  EXPECT_EQ(plan->pictures[40].sweep_frame->time_ms, kSweepEndMs);
  EXPECT_EQ(plan->sweeps[1].begin, 41U);
  EXPECT_EQ(sweep_strength(0), 0);
  EXPECT_FLOAT_EQ(sweep_strength(300), 0.5F);
  EXPECT_EQ(sweep_strength(600), 1);
  EXPECT_EQ(sweep_strength(1000), 1);
  EXPECT_FLOAT_EQ(sweep_strength(1300), 0.5F);
  EXPECT_EQ(sweep_strength(1600), 0);
  float before = 0;
  for (int time_ms = 0; time_ms <= kApexMs; time_ms += 40) {
    EXPECT_GE(sweep_strength(time_ms), before);
    before = sweep_strength(time_ms);
  }
}

TEST(GalleryPlan, AllSweepsAreEveryAuAndEveryExpressionOnce) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"sweeps"}, {"12", "all"});
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ(plan->sweeps.size(), 4U + 18U);
}

TEST(GalleryPlan, AnUnknownSweepIsNamed) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({}, {"hapiness"});
  ASSERT_FALSE(plan.has_value());
  EXPECT_EQ(plan.error().kind, ErrorKind::Usage);
  EXPECT_NE(plan.error().message.find("did you mean happiness?"), std::string::npos);
}

TEST(GalleryCoverage, NamesEveryAuOfAppendixCRecordedOrNot) {
  const auto table = coverage_of(small_gallery_face());
  EXPECT_EQ(table.size(), 54U);
  const auto row = [&table](int number) {
    return *std::find_if(table.begin(), table.end(),
                         [number](const Coverage& one) { return one.number == number; });
  };
  EXPECT_TRUE(row(12).recorded);
  EXPECT_TRUE(row(12).sided);
  EXPECT_EQ(row(12).drives.size(), 2U);
  EXPECT_FALSE(row(26).sided);
  EXPECT_EQ(row(26).note, "its best form on this mesh");
  EXPECT_FALSE(row(19).recorded);
  EXPECT_EQ(row(19).name, "Tongue Show");
}

TEST(GalleryFileStem, IsMadeOfNumbersSidesAndPercents) {
  EXPECT_EQ(file_stem(*protocol::parse_au_set("6,12:80,R14")), "au06_au12-80_auR14");
  EXPECT_EQ(file_stem(*protocol::parse_au_set("0")), "au00");
}

TEST(GalleryFileStem, OfManyAusIsShortEnoughForAFileAndTheirOwn) {
  const auto stem = [](const std::string& last) {
    std::string words = "1";
    for (int number = 2; number < 90; ++number) words += "," + std::to_string(number) + ":50";
    return file_stem(*protocol::parse_au_set(words + "," + last));
  };
  EXPECT_EQ(stem("99").size(), 200U);
  EXPECT_TRUE(stem("99").starts_with("au01_au02-50_"));
  EXPECT_NE(stem("99"), stem("98"));
}

TEST(ShippedGallery, PlansEveryRecordedAuAndEveryExpression) {
  const std::filesystem::path data = test::program("data");
  const auto face = face::load_face(data / "faces" / "default", data);
  ASSERT_TRUE(face.has_value()) << face.error().message;
  const auto expressions = load_expressions(data / "expressions.toml");
  ASSERT_TRUE(expressions.has_value()) << expressions.error().message;
  const GalleryRules rules = empty_rules();
  const auto plan = plan_gallery({*face, *expressions, rules, face::Mixer::Maximum, {}, {}});
  ASSERT_TRUE(plan.has_value()) << plan.error().message;
  const auto files = files_of(*plan);
  for (const Expression& expression : *expressions) {
    EXPECT_TRUE(files.contains("prototypes/" + expression.name + ".png")) << expression.name;
  }
  EXPECT_EQ(plan->sections[0].blocks.size(), face->recordings.size());
}

}  // namespace
}  // namespace aucast::gallery
