#include "client/gallery/gallery_plan.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

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

TEST(GalleryPlan, EveryFigureShowsAPictureOrASweepThatIsThere) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({}, {"12", "all"});
  ASSERT_TRUE(plan.has_value());
  std::set<std::size_t> shown;
  for (const GallerySection& section : plan->sections) {
    EXPECT_FALSE(section.title.empty());
    for (const GalleryBlock& block : section.blocks) {
      for (const GalleryRow& row : block.rows) {
        if (!block.columns.empty()) {
          EXPECT_EQ(row.figures.size(), block.columns.size()) << block.heading;
        }
        for (const GalleryFigure& figure : row.figures) {
          EXPECT_LE(figure.video, plan->sweeps.size());
          if (!figure.picture) continue;
          ASSERT_LT(*figure.picture, plan->pictures.size());
          shown.insert(*figure.picture);
        }
      }
    }
  }
  for (const GallerySweep& sweep : plan->sweeps) {
    ASSERT_LE(sweep.begin + sweep.count, plan->pictures.size());
    for (std::size_t i = 0; i < sweep.count; ++i) shown.insert(sweep.begin + i);
  }
  EXPECT_EQ(shown.size(), plan->pictures.size()) << "no picture is drawn for nothing";
}

TEST(GalleryPlan, AFilesNameWorksOnEverySystem) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({}, {"all", "1,2,5B,L12:40"});
  ASSERT_TRUE(plan.has_value());
  std::set<std::string> lowered;
  for (const GalleryPicture& picture : plan->pictures) {
    EXPECT_EQ(picture.file.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDELR0123456789_-./"),
              std::string::npos)
        << picture.file;
    EXPECT_FALSE(picture.file.starts_with('/') || picture.file.find("..") != std::string::npos);
    std::string same = picture.file;
    std::transform(same.begin(), same.end(), same.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    EXPECT_TRUE(lowered.insert(same).second) << picture.file << ": where case does not count";
  }
}

TEST(GalleryPlan, AnAskedSectionAloneIsPlanned) {
  const PlannedGallery gallery;
  for (const char* section : {"aus", "prototypes", "combinations", "appendix-a", "appendix-b"}) {
    const auto plan = gallery.plan({section}, {});
    ASSERT_TRUE(plan.has_value());
    ASSERT_EQ(plan->sections.size(), 1U) << section;
    EXPECT_EQ(plan->sections.front().name, section);
    EXPECT_FALSE(plan->pictures.empty());
  }
  EXPECT_TRUE(gallery.plan({"sweeps"}, {})->sections.empty()) << "none was asked for";
}

TEST(GalleryPlan, TheLettersAreFacsFiveIntensities) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"aus"});
  ASSERT_TRUE(plan.has_value());
  std::vector<std::string> aus;
  for (const char letter : std::string("ABCDE")) {
    const std::string file = std::string("au/au26_") + letter + ".png";
    aus.push_back(protocol::format_au_set(named_picture(*plan, file).aus));
  }
  EXPECT_EQ(aus, (std::vector<std::string>{"26:10", "26:25", "26:50", "26:80", "26"}));
  EXPECT_EQ(named_picture(*plan, "au/neutral.png").aus, AuFrame{});
}

TEST(GalleryPlan, AppendixANamesWhatTheFaceLacks) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"appendix-a"});
  ASSERT_TRUE(plan.has_value());
  const auto& figures = plan->sections.front().blocks.front().rows.front().figures;
  EXPECT_EQ(figures.size(), 16U);
  EXPECT_EQ(plan->pictures.size(), 2U) << "of the sixteen the face has 12 and 26";
  EXPECT_EQ(std::count_if(figures.begin(), figures.end(),
                          [](const GalleryFigure& one) { return one.text == "not recorded"; }),
            14);
  EXPECT_EQ(figures.front().title, "AU 1 Inner Brow Raiser");
}

TEST(GalleryPlan, APairIsTheStrongerOfBothAndIsLeftOutWhereOneIsUnknown) {
  PlannedGallery gallery;
  gallery.expressions[0].aus = *protocol::parse_au_set("12:40,26");    // surprise
  gallery.expressions[12].aus = *protocol::parse_au_set("12:80,L46");  // happiness
  const auto plan = gallery.plan({"combinations"});
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ(
      protocol::format_au_set(named_picture(*plan, "combinations/surprise_happiness.png").aus),
      "12:80,26,L46");
  std::erase_if(gallery.expressions, [](const Expression& one) { return one.name == "fear"; });
  EXPECT_EQ(gallery.plan({"combinations"})->pictures.size(), 30U - 5U);
}

TEST(GalleryPlan, RulesDecideWhatIsShownAndNotWhatIsAsked) {
  PlannedGallery gallery;
  gallery.rules.chosen.rules = {
      {.kind = face::RuleKind::Exclusion, .sources = {26}, .targets = {12}, .source = {}}};
  const auto plan = gallery.plan({"prototypes"});
  ASSERT_TRUE(plan.has_value());
  const GalleryPicture& picture = named_picture(*plan, "prototypes/thesis-fear.png");
  EXPECT_EQ(protocol::format_au_set(picture.aus), "12,26");
  EXPECT_EQ(protocol::format_au_set(picture.shown), "26");
}

TEST(GalleryPlan, ASweepThatIsAskedForTwiceIsMadeOnceAndOneOfMusclesKeepsThem) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({}, {"12", "12", "R12", "waters-fear", "waters-fear"});
  ASSERT_TRUE(plan.has_value());
  ASSERT_EQ(plan->sweeps.size(), 3U);
  EXPECT_EQ(plan->sweeps[1].name, "auR12");
  const GalleryPicture& frame = plan->pictures[plan->sweeps[2].begin];
  EXPECT_EQ(frame.file, "sweeps/waters-fear/frame_000001.png");
  EXPECT_EQ(frame.muscles.size(), 1U);
  const auto& figures = plan->sections.back().blocks.front().rows.front().figures;
  ASSERT_EQ(figures.size(), 3U);
  EXPECT_EQ(plan->pictures[*figures[2].picture].sweep_frame->time_ms, kApexMs);
  EXPECT_EQ(figures[2].text, "waters-fear");
}

TEST(GalleryPlan, ASweepOfMusclesThatTheFaceLacksIsRefusedAndLeftOutOfAll) {
  PlannedGallery gallery;
  gallery.expressions[2].muscles.front() = {"nowhere", {}, 1, 1};
  const auto refused = gallery.plan({}, {"waters-surprise"});
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message.find("nowhere"), std::string::npos) << refused.error().message;
  EXPECT_EQ(gallery.plan({"sweeps"}, {"all"})->sweeps.size(), 4U + 17U);
}

TEST(GalleryPlan, AHostileSweepIsNamedWithoutItsControlCharacters) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({}, {"../\x1b[2J"});
  ASSERT_FALSE(plan.has_value());
  EXPECT_EQ(plan.error().message.find('\x1b'), std::string::npos);
  EXPECT_NE(plan.error().message.find("\\x1b"), std::string::npos);
}

TEST(GallerySided, IsWhatFacsScoresByASideIfTheFaceCanShowIt) {
  face::Face face = small_gallery_face();
  EXPECT_TRUE(is_sided(face, 12));
  EXPECT_FALSE(is_sided(face, 51)) << "a turn of the head has no sides";
  EXPECT_FALSE(is_sided(face, 10)) << "not recorded";
  face.recordings[10] = {10, {1, 0, 0, 0, 0, 0}, ""};
  EXPECT_FALSE(is_sided(face, 10)) << "this face has one of its sides";
  face.recordings[10] = {10, {1, 1, 0, 0, 0, 0}, ""};
  EXPECT_TRUE(is_sided(face, 10));
  face.recordings[26] = {26, {1, 1, 2, 0, 0, 0}, ""};
  EXPECT_FALSE(is_sided(face, 26)) << "FACS does not score it by sides";
}

TEST(GalleryCoverage, HasWhatTheUserMadeToo) {
  face::Face face = small_gallery_face();
  face.recordings[98] = {98, {0, 0, 1, 0, 0, 0}, "mine"};
  const auto table = coverage_of(face);
  EXPECT_EQ(table.size(), 55U);
  EXPECT_EQ(table.back().number, 98);
  EXPECT_EQ(table.back().name, "not named by FACS");
  EXPECT_EQ(table.back().drives, std::vector<std::string>{"jaw"});
  EXPECT_TRUE(std::is_sorted(table.begin(), table.end(), [](const Coverage& a, const Coverage& b) {
    return a.number < b.number;
  }));
}

}  // namespace
}  // namespace aucast::gallery
