#include "client/gallery/gallery_manifest.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/seeded.h"
#include "tests/unit/gallery/gallery_fixture.h"

namespace aucast::gallery {
namespace {

const GallerySetting kSetting{"small", "front", "808080", "creases", "1.2.3", 300, 375};

/// Reads CSV as RFC 4180 has it.
std::vector<std::vector<std::string>> read_csv(std::string_view text) {
  std::vector<std::vector<std::string>> lines{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    std::string& field = lines.back().back();
    if (quoted) {
      const bool doubled = c == '"' && i + 1 < text.size() && text[i + 1] == '"';
      if (c == '"' && !doubled) {
        quoted = false;
      } else {
        field += c;
        if (doubled) ++i;
      }
    } else if (c == '"') {
      quoted = true;
    } else if (c == ',') {
      lines.back().emplace_back();
    } else if (c == '\r') {
      continue;
    } else if (c == '\n') {
      lines.push_back({""});
    } else {
      field += c;
    }
  }
  lines.pop_back();
  return lines;
}

TEST(CsvField, QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(csv_field(""), "");
  EXPECT_EQ(csv_field("plain words"), "plain words");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("say \"so\""), "\"say \"\"so\"\"\"");
  EXPECT_EQ(csv_field("two\r\nlines"), "\"two\r\nlines\"");
}

TEST(CsvField, IsReadBackWhateverIsInIt) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const std::string alphabet = "ab ,\"\n;";
  for (int round = 0; round < 500; ++round) {
    std::vector<std::string> fields(3);
    std::string line;
    for (std::string& field : fields) {
      for (int n = seeded.integer(0, 6); n > 0; --n) {
        field += alphabet[static_cast<std::size_t>(seeded.integer(0, 6))];
      }
      line += (&field == &fields.front() ? "" : ",") + csv_field(field);
    }
    const auto lines = read_csv(line + "\r\n");
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines.front(), fields);
  }
}

TEST(Manifest, HasOneLineForEachPictureWithAllFields) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"aus", "appendix-b", "sweeps"}, {"12"});
  ASSERT_TRUE(plan.has_value());
  const auto lines = read_csv(format_manifest(*plan, kSetting, {0}));
  ASSERT_EQ(lines.size(), 1 + plan->pictures.size() + 1);
  for (const auto& line : lines) EXPECT_EQ(line.size(), lines.front().size()) << line.front();
}

TEST(Manifest, SaysWhatAPictureShows) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"aus", "appendix-b", "sweeps"}, {"12,26:30"});
  ASSERT_TRUE(plan.has_value());
  const std::string text = format_manifest(*plan, kSetting, {0});
  for (const char* line :
       {"au/"
        "au12_C_left.png,12,50,left,L12:50,,,small,maximum,facs,front,300,375,808080,creases,1.2.3,"
        ",,,,,,"
        "\r\n",
        "appendix_b/fear_average_none.png,12 26,100 100,both both,\"12,26\",thesis-fear,,small,"
        "average,none,front,300,375,808080,creases,1.2.3,,,,,,,\r\n",
        "prototypes/waters-fear.png,,,,,waters-fear,zygomaticus_major=1/0.5,small,,,front,300,375,"
        "808080,creases,1.2.3,,,,,,,\r\n",
        "sweeps/au12_au26-30/frame_000016.png,12 26,100 30,both both,\"12,26:30\",,,small,maximum,"
        "facs,front,300,375,808080,creases,1.2.3,16,600,100.0,0,600,1000,1600\r\n",
        "sweeps/au12_au26-30/frame_000036.png,12 26,100 30,both both,\"12,26:30\",,,small,maximum,"
        "facs,front,300,375,808080,creases,1.2.3,36,1400,25.0,0,600,1000,1600\r\n",
        "sweeps/au12_au26-30.mp4,12 26,100 30,both "
        "both,\"12,26:30\",,,small,maximum,facs,front,300,"
        "375,808080,creases,1.2.3,,,,0,600,1000,1600\r\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line;
  }
}

TEST(Manifest, AFieldOfAnyKindStaysOneField) {
  PlannedGallery gallery;
  gallery.expressions.front().name = "a,b\"c";
  const auto plan = gallery.plan({"prototypes"});
  ASSERT_TRUE(plan.has_value());
  GallerySetting setting = kSetting;
  setting.face = "my, \"own\"\r\nface";
  const auto lines = read_csv(format_manifest(*plan, setting, {}));
  ASSERT_EQ(lines.size(), 1 + plan->pictures.size());
  for (const auto& line : lines) ASSERT_EQ(line.size(), lines.front().size());
  const auto column = [&lines](const std::string& name) {
    const auto found = std::find(lines.front().begin(), lines.front().end(), name);
    EXPECT_NE(found, lines.front().end()) << name;
    return static_cast<std::size_t>(found - lines.front().begin());
  };
  EXPECT_EQ(lines[1][column("expression")], "a,b\"c");
  EXPECT_EQ(lines[1][column("file")], "prototypes/a,b\"c.png");
}

TEST(Manifest, SaysWhatTheRulesLeft) {
  PlannedGallery gallery;
  gallery.rules.facs.rules = {
      {.kind = face::RuleKind::Exclusion, .sources = {26}, .targets = {12}, .source = {}}};
  const auto plan = gallery.plan({"appendix-b"});
  ASSERT_TRUE(plan.has_value());
  const std::string text = format_manifest(*plan, kSetting, {});
  EXPECT_NE(text.find("appendix_b/fear_maximum_facs.png,12 26,100 100,both both,26,thesis-fear"),
            std::string::npos);
  EXPECT_NE(text.find("appendix_b/fear_maximum_none.png,12 26,100 100,both both,\"12,26\""),
            std::string::npos);
}

TEST(Manifest, AVideoIsListedOnlyIfItWasWritten) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"sweeps"}, {"12", "26"});
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ(format_manifest(*plan, kSetting, {}).find(".mp4"), std::string::npos);
  const auto lines = read_csv(format_manifest(*plan, kSetting, {1}));
  EXPECT_EQ(lines.back().front(), "sweeps/au26.mp4");
  EXPECT_EQ(lines.size(), 1U + 2U * 41U + 1U);
}

TEST(StrengthText, HasOneDecimalAndGoesUpAndDown) {
  EXPECT_EQ(strength_text(0), "0.0");
  EXPECT_EQ(strength_text(kApexMs), "100.0");
  EXPECT_EQ(strength_text(kOffsetMs), "100.0");
  EXPECT_EQ(strength_text(kSweepEndMs), "0.0");
  EXPECT_EQ(strength_text(40), "1.1");
  EXPECT_EQ(strength_text(kSweepEndMs - 40), "1.1") << "down as it went up";
}

}  // namespace
}  // namespace aucast::gallery
