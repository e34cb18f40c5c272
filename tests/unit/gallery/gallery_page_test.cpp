#include "client/gallery/gallery_page.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/gallery/gallery_fixture.h"

namespace aucast::gallery {
namespace {

const GallerySetting kPageSetting{"small", "front", "default", "creases", "1.2.3", 300, 375};

/// The values of an attribute, in order.
std::vector<std::string> values_of(const std::string& html, const std::string& attribute) {
  std::vector<std::string> values;
  const std::string begin = " " + attribute + "=\"";
  for (std::size_t at = html.find(begin); at != std::string::npos; at = html.find(begin, at + 1)) {
    const std::size_t from = at + begin.size();
    values.push_back(html.substr(from, html.find('"', from) - from));
  }
  return values;
}

TEST(HtmlEscaped, LeavesNoMarkup) {
  EXPECT_EQ(html_escaped("a<b>&\"c\"'d'"), "a&lt;b&gt;&amp;&quot;c&quot;&#39;d&#39;");
  EXPECT_EQ(html_escaped("plain"), "plain");
}

TEST(GalleryPage, ShowsEveryPictureByARelativeLinkAndNothingFromOutside) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan();
  ASSERT_TRUE(plan.has_value());
  const std::string html = format_page(*plan, kPageSetting, {});
  const auto sources = values_of(html, "src");
  const std::set<std::string> shown(sources.begin(), sources.end());
  for (const GalleryPicture& picture : plan->pictures) {
    EXPECT_TRUE(shown.contains(picture.file)) << picture.file;
  }
  EXPECT_EQ(html.find("://"), std::string::npos);
  EXPECT_EQ(html.find("<script"), std::string::npos);
}

TEST(GalleryPage, ItsLinksLeadToItsOwnPlaces) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan();
  ASSERT_TRUE(plan.has_value());
  const std::string html = format_page(*plan, kPageSetting, {});
  const auto ids = values_of(html, "id");
  const std::set<std::string> places(ids.begin(), ids.end());
  EXPECT_EQ(places.size(), ids.size()) << "an id stands twice";
  for (const std::string& link : values_of(html, "href")) {
    if (link.starts_with('#')) {
      EXPECT_TRUE(places.contains(link.substr(1))) << link;
    }
  }
}

TEST(GalleryPage, MarksWhatIsMissingAndWhatIsLimited) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"coverage"});
  ASSERT_TRUE(plan.has_value());
  EXPECT_TRUE(plan->pictures.empty());
  const std::string html = format_page(*plan, kPageSetting, {});
  EXPECT_NE(html.find("4 of 54 are recorded"), std::string::npos);
  EXPECT_NE(html.find("<td>26</td><td>Jaw Drop</td><td><span class=\"mark limited\">"),
            std::string::npos);
  EXPECT_NE(html.find("<td>19</td><td>Tongue Show</td><td><span class=\"mark missing\">"),
            std::string::npos);
  // Both sides of AU 12 at once.
  EXPECT_NE(html.find("<td class=\"drives\">zygomaticus_major</td>"), std::string::npos);
}

TEST(GalleryPage, ANoteThatIsTheNameAgainIsLeftOut) {
  PlannedGallery gallery;
  gallery.face.recordings.at(12).note = "lip corner puller";
  const auto plan = gallery.plan({"coverage"});
  ASSERT_TRUE(plan.has_value());
  const std::string html = format_page(*plan, kPageSetting, {});
  EXPECT_EQ(html.find("lip corner puller"), std::string::npos);
  EXPECT_NE(html.find("Lip Corner Puller"), std::string::npos);
  EXPECT_NE(html.find("its best form on this mesh"), std::string::npos);
}

TEST(GalleryPage, EscapesWhatComesFromFiles) {
  PlannedGallery gallery;
  gallery.face.name = "<small>";
  gallery.face.recordings.at(12).note = "a & b";
  gallery.expressions.front().label = "\"<i>joy</i>\"";
  const auto plan = gallery.plan();
  ASSERT_TRUE(plan.has_value());
  GallerySetting setting = kPageSetting;
  setting.face = gallery.face.name;
  const std::string html = format_page(*plan, setting, {});
  EXPECT_EQ(html.find("<small>"), std::string::npos);
  EXPECT_EQ(html.find("<i>"), std::string::npos);
  EXPECT_NE(html.find("a &amp; b"), std::string::npos);
}

TEST(GalleryPage, LinksTheVideosThatThereAre) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"sweeps"}, {"12"});
  ASSERT_TRUE(plan.has_value());
  EXPECT_NE(format_page(*plan, kPageSetting, {0}).find("href=\"sweeps/au12.mp4\""),
            std::string::npos);
  EXPECT_EQ(format_page(*plan, kPageSetting, {}).find(".mp4"), std::string::npos);
}

/// How often a text stands in another one.
std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

/// Whether all elements that are opened are closed, inside each other; the names of those that are
/// not.
std::vector<std::string> unclosed(const std::string& html) {
  const std::set<std::string> void_ones{"!DOCTYPE", "meta", "img"};
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
    const bool closes = html[at + 1] == '/';
    const std::size_t from = at + (closes ? 2 : 1);
    const std::string name = html.substr(from, html.find_first_of(" >", from) - from);
    if (void_ones.contains(name)) continue;
    if (!closes) {
      open.push_back(name);
    } else if (!open.empty() && open.back() == name) {
      open.pop_back();
    } else {
      return {"</" + name};
    }
  }
  return open;
}

TEST(GalleryPage, EveryElementIsClosedWhereItWasOpened) {
  PlannedGallery gallery;
  gallery.face.recordings.at(12).note = "<b> & \"so\"";
  gallery.expressions[2].muscles.front() = {"nowhere", {}, 1, 1};
  const auto plan = gallery.plan({}, {"12", "happiness"});
  ASSERT_TRUE(plan.has_value());
  EXPECT_EQ(unclosed(format_page(*plan, kPageSetting, {0})), std::vector<std::string>{});
  EXPECT_EQ(unclosed(format_page({}, kPageSetting, {})), std::vector<std::string>{});
}

TEST(GalleryPage, AttributesOfATextThatIsHostileStayAttributes) {
  PlannedGallery gallery;
  const std::string hostile = "x\" onerror=\"alert(1)";
  gallery.expressions.front().label = hostile;
  gallery.expressions.front().source = hostile;
  const auto plan = gallery.plan({"prototypes", "combinations"});
  ASSERT_TRUE(plan.has_value());
  GallerySetting setting = kPageSetting;
  setting.face = setting.viewpoint = setting.background = setting.version = hostile;
  const std::string html = format_page(*plan, setting, {});
  EXPECT_EQ(html.find("onerror=\""), std::string::npos);
  EXPECT_NE(html.find("onerror=&quot;alert(1)"), std::string::npos);
}

TEST(GalleryPage, SaysHowManyPicturesThereAreAndHowLargeTheyAre) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"appendix-b"});
  ASSERT_TRUE(plan.has_value());
  const std::string html = format_page(*plan, kPageSetting, {});
  EXPECT_NE(html.find("<p>42 pictures, 300 x 375, camera front, background default."),
            std::string::npos);
  EXPECT_NE(html.find("width=\"300\" height=\"375\""), std::string::npos);
}

TEST(GalleryPage, OnlyManyBlocksHaveAnIndexAndAusAreThereByNumber) {
  PlannedGallery gallery;
  EXPECT_EQ(format_page(*gallery.plan({"aus"}), kPageSetting, {}).find("class=\"index\""),
            std::string::npos);
  for (int number = 1; number < 10; ++number) {
    gallery.face.recordings[number] = {number, {1, 1, 0, 0, 0, 0}, ""};
  }
  const auto plan = gallery.plan({"aus"});
  ASSERT_TRUE(plan.has_value());
  const std::string html = format_page(*plan, kPageSetting, {});
  EXPECT_NE(html.find("<a href=\"#aus-2\" title=\"AU 1 Inner Brow Raiser\">AU 1</a>"),
            std::string::npos);
  EXPECT_NE(html.find("<h3 id=\"aus-2\">AU 1 Inner Brow Raiser</h3>"), std::string::npos);
  EXPECT_NE(html.find("title=\"Neutral\">Neutral</a>"), std::string::npos)
      << "a heading of one word is whole";
}

TEST(GalleryPage, ATableHasAsManyCellsInEachRowAsColumns) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"aus", "appendix-b"});
  ASSERT_TRUE(plan.has_value());
  const std::string html = format_page(*plan, kPageSetting, {});
  std::size_t tables = 0;
  for (std::size_t at = html.find("<table class=\"pictures\">"); at != std::string::npos;
       at = html.find("<table class=\"pictures\">", at + 1)) {
    ++tables;
    const std::string table = html.substr(at, html.find("</table>", at) - at);
    std::set<std::size_t> widths;
    for (std::size_t row = table.find("<tr>"); row != std::string::npos;
         row = table.find("<tr>", row + 1)) {
      const std::string cells = table.substr(row, table.find("</tr>", row) - row);
      widths.insert(count_of(cells, "<td") + count_of(cells, "<th"));
    }
    EXPECT_EQ(widths.size(), 1U) << table.substr(0, 200);
  }
  EXPECT_EQ(tables, 4U + 2U) << "a table for each AU, two for both mixers";
}

TEST(GalleryPage, ACellThatTheFaceCannotFillSaysSo) {
  PlannedGallery gallery;
  gallery.expressions[2].muscles.front() = {"nowhere", {}, 1, 1};
  const auto plan = gallery.plan({"prototypes"});
  ASSERT_TRUE(plan.has_value());
  const std::string html = format_page(*plan, kPageSetting, {});
  EXPECT_EQ(count_of(html, "not on this face"), 1U);
  EXPECT_EQ(count_of(html, "<img"), plan->pictures.size());
}

TEST(GalleryPage, APictureIsDescribedForWhoCannotSeeIt) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"aus"});
  ASSERT_TRUE(plan.has_value());
  const std::string html = format_page(*plan, kPageSetting, {});
  const auto alts = values_of(html, "alt");
  EXPECT_EQ(alts.size(), plan->pictures.size());
  EXPECT_TRUE(std::any_of(alts.begin(), alts.end(), [](const std::string& alt) {
    return alt.find("AU 12 Lip Corner Puller left") != std::string::npos &&
           alt.find("L12:50") != std::string::npos;
  }));
}

TEST(GalleryPage, ASweepTellsItsFramesAndEachVideoIsItsOwn) {
  const PlannedGallery gallery;
  const auto plan = gallery.plan({"sweeps"}, {"12", "26", "happiness"});
  ASSERT_TRUE(plan.has_value());
  const std::string html = format_page(*plan, kPageSetting, {1});
  EXPECT_EQ(count_of(html, ">41 frames</a>"), 3U);
  EXPECT_NE(html.find("href=\"sweeps/happiness/\""), std::string::npos);
  EXPECT_NE(html.find("href=\"sweeps/au26.mp4\""), std::string::npos);
  EXPECT_EQ(count_of(html, ".mp4\""), 1U) << "of the others there is none";
}

TEST(GalleryPage, ChannelsOfBothSidesAreNamedOnceAndSingleOnesWhole) {
  PlannedGallery gallery;
  gallery.face.recordings.at(46).activation = {0, 0, 0, 1, 0, 0};
  const auto plan = gallery.plan({"coverage"});
  ASSERT_TRUE(plan.has_value());
  const std::string html = format_page(*plan, kPageSetting, {});
  EXPECT_NE(html.find("<td class=\"drives\">left_lid_close</td>"), std::string::npos);
  EXPECT_NE(html.find("<td class=\"drives\">jaw</td>"), std::string::npos);
  EXPECT_EQ(html.find("right_zygomaticus_major"), std::string::npos);
}

}  // namespace
}  // namespace aucast::gallery
