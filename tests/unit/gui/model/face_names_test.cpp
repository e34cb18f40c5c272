#include "client/gui/model/face_names.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

FacesView three_faces() {
  FacesView faces;
  faces.entries = std::make_shared<const std::vector<FaceEntry>>(
      std::vector<FaceEntry>{{"default", "/s/default", FaceKind::Shipped},
                             {"anna", "/o/anna", FaceKind::Own},
                             {"berta", "/e/berta", FaceKind::Elsewhere}});
  faces.shown = "/o/anna";
  return faces;
}

TEST(FaceNames, ANameThatCannotBeTakenIsSaid) {
  const FacesView faces = three_faces();
  EXPECT_EQ(wrong_face_name("anna 2", faces), "");
  EXPECT_EQ(wrong_face_name("Anna", faces), "");
  EXPECT_EQ(wrong_face_name("berta", faces), "") << "that one lies elsewhere";
  EXPECT_EQ(wrong_face_name("Zoé's", faces), "");
  EXPECT_EQ(wrong_face_name("", faces), "Give it a name first.");
  EXPECT_EQ(wrong_face_name("  ", faces), "Give it a name first.");
  EXPECT_EQ(wrong_face_name("a/b", faces), "There can be no / in a name.");
  EXPECT_EQ(wrong_face_name("a\"b\\c", faces), "");
  EXPECT_EQ(wrong_face_name("..", faces), "A folder that begins with a dot is hidden.");
  EXPECT_EQ(wrong_face_name("anna", faces), "anna is there already.");
  EXPECT_EQ(wrong_face_name("default", faces), "default is the name of a shipped face.");
  EXPECT_EQ(wrong_face_name("a\nb", faces), "There can be no control characters in a name.");
  EXPECT_NE(wrong_face_name("\xff", faces), "") << "that is no UTF-8";
  EXPECT_EQ(wrong_face_name("anna", {}), "") << "before there is a list";
}

TEST(FaceNames, ACopyGetsTheFirstNumberThatIsFree) {
  const auto upto = [](int most) {
    return [most](const std::string& name) { return name.back() <= '0' + most; };
  };
  EXPECT_EQ(name_for_copy("anna", upto(0)), "anna 2");
  EXPECT_EQ(name_for_copy("anna", upto(3)), "anna 4");
  EXPECT_EQ(name_for_copy("anna 2", upto(2)), "anna 3");
  EXPECT_EQ(name_for_copy("h2", upto(0)), "h2 2");
  EXPECT_EQ(name_for_copy("2", upto(0)), "2 2");
}

TEST(FaceNames, ANameIsTakenByShippedFacesAndOnesOwn) {
  const FacesView faces = three_faces();
  EXPECT_TRUE(is_face_name("default", faces));
  EXPECT_TRUE(is_face_name("anna", faces));
  EXPECT_FALSE(is_face_name("berta", faces)) << "that one lies elsewhere";
  EXPECT_FALSE(is_face_name("a\nb 2", faces)) << "wrong, but free";
  EXPECT_FALSE(is_face_name("anna", {})) << "before there is a list";
}

TEST(FaceNames, TheFaceThatIsShownIsFoundInTheList) {
  FacesView faces = three_faces();
  ASSERT_NE(shown_face(faces), nullptr);
  EXPECT_EQ(shown_face(faces)->name, "anna");
  faces.shown = "/o/gone";
  EXPECT_EQ(shown_face(faces), nullptr);
  EXPECT_EQ(shown_face({}), nullptr);
}

}  // namespace
}  // namespace aucast::gui
