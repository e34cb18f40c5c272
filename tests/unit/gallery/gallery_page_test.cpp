#include "client/gallery/gallery_page.h"

#include <set>

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

}  // namespace
}  // namespace aucast::gallery
