#include "client/face/au_recordings.h"

#include <gtest/gtest.h>

#include "client/face/face_folder.h"
#include "tests/unit/face/small_face.h"

namespace aucast::face {
namespace {

/// Tables of AUs as they are read for the small face.
struct ReadAus {
  AuRecordings recordings;
  std::string complaint;  ///< after the name of the file; empty: none
  std::vector<int> unknown;
};

/// `names`: of a file for many faces; empty: the file is for this face alone.
ReadAus read_aus(const Face& face, const std::string& text,
                 const std::vector<std::string>& names = {}) {
  const auto document = parse_toml(text, "a");
  EXPECT_TRUE(document.has_value()) << (document ? "" : document.error().message);
  if (!document) return {};
  Problems problems("a");
  TableReader reader(*document, problems);
  const auto finder = [&face](std::string_view name) { return channels_named(face, name); };
  ReadAus read;
  read.recordings = read_recordings(reader, face, finder, names, problems,
                                    names.empty() ? nullptr : &read.unknown);
  if (const auto result = problems.result(); !result) read.complaint = result.error().message;
  return read;
}

float driven(const Face& face, const ReadAus& read, int number, std::string_view channel) {
  return read.recordings.at(number).activation[*face.channel_index(channel)];
}

TEST(ChannelsNamed, AreTheOneOfThatNameElseThoseOfBothSides) {
  const Face face = test::small_face();
  using Found = std::vector<std::size_t>;
  EXPECT_EQ(channels_named(face, "jaw"), Found{*face.channel_index("jaw")});
  EXPECT_EQ(channels_named(face, "right_depressor"), Found{*face.channel_index("right_depressor")});
  EXPECT_EQ(channels_named(face, "depressor"),
            (Found{*face.channel_index("left_depressor"), *face.channel_index("right_depressor")}));
  EXPECT_EQ(channels_named(face, "no_such"), Found{});
  EXPECT_EQ(channels_named(face, ""), Found{});
}

TEST(Recordings, DriveWhatTheyNameAndNothingElse) {
  const Face face = test::small_face();
  const ReadAus read = read_aus(face,
                                "[[au]]\nnumber = 0\n[[au]]\nnumber = 99\nnote = \"all\"\n"
                                "drive = { jaw = 4.0, depressor = 2.0, left_lid_close = 1.0 }\n");
  EXPECT_EQ(read.complaint, "");
  ASSERT_EQ(read.recordings.size(), 2U);
  EXPECT_EQ(read.recordings.at(0).activation, std::vector<float>(face.channels.size(), 0.0F));
  EXPECT_EQ(read.recordings.at(99).note, "all");
  EXPECT_EQ(driven(face, read, 99, "jaw"), 4.0F) << "as far as its channel goes";
  EXPECT_EQ(driven(face, read, 99, "right_depressor"), 2.0F);
  EXPECT_EQ(driven(face, read, 99, "left_lid_close"), 1.0F);
  EXPECT_EQ(driven(face, read, 99, "right_lid_close"), 0.0F);
}

TEST(Recordings, AnActivationMayNotBeMoreThanItsChannelTakes) {
  const Face face = test::small_face();
  const auto complaint = [&](const std::string& drive) {
    return read_aus(face, "[[au]]\nnumber = 1\ndrive = { " + drive + " }\n").complaint;
  };
  EXPECT_EQ(complaint("jaw = 4.1"), "a:3:17: jaw is 4.1, must be from 0 to 4");
  EXPECT_EQ(complaint("mentalis = 2.1"), "a:3:22: mentalis is 2.1, must be from 0 to 2");
  EXPECT_EQ(complaint("lid_raise = 1.1"), "a:3:23: lid_raise is 1.1, must be from 0 to 1");
  EXPECT_EQ(complaint("jaw = \"wide\""), "a:3:17: jaw must be a number");
}

TEST(Recordings, AnActivationMayBeTheLargestAsItIsWritten) {
  Face face = test::small_face();
  for (const std::string largest : {"0.7", "1.1", "1.3", "1.8", "1.9"}) {
    // As a float, some of these are a little more and some a little less than what is written.
    face.channels[*face.channel_index("mentalis")].activation_max = std::stof(largest);
    const auto complaint = [&](const std::string& value) {
      return read_aus(face, "[[au]]\nnumber = 1\ndrive = { mentalis = " + value + " }\n").complaint;
    };
    EXPECT_EQ(complaint(largest), "");
    EXPECT_EQ(complaint(largest + "01"),
              "a:3:22: mentalis is " + largest + "01, must be from 0 to " + largest);
  }
}

TEST(Recordings, AFileForManyFacesTellsWhatThisOneCannotShow) {
  const Face face = test::small_face();
  const std::vector<std::string> names{"jaw", "platysma", "nostril"};
  const ReadAus read = read_aus(face,
                                "[[au]]\nnumber = 0\n"
                                "[[au]]\nnumber = 21\ndrive = { platysma = 1.0 }\n"
                                "[[au]]\nnumber = 26\ndrive = { jaw = 2.0, platysma = 1.0 }\n"
                                "[[au]]\nnumber = 38\ndrive = { nostril = 1.0 }\n",
                                names);
  EXPECT_EQ(read.complaint, "");
  EXPECT_EQ(read.unknown, (std::vector<int>{21, 38})) << "the neutral face drives nothing anyway";
  EXPECT_EQ(driven(face, read, 26, "jaw"), 2.0F);
}

TEST(Recordings, ANameThatNoFaceHasIsRefusedInEitherFile) {
  const Face face = test::small_face();
  const std::string text = "[[au]]\nnumber = 26\ndrive = { jow = 2.0 }\n";
  EXPECT_EQ(read_aus(face, text).complaint,
            "a:3:11: AU26 drives 'jow', which this face does not have");
  EXPECT_EQ(read_aus(face, text, {"jaw"}).complaint,
            "a:3:11: AU26 drives 'jow', which this face does not have; did you mean jaw?");
}

TEST(Recordings, AnAuFileMayBeReadAloneForAFace) {
  const Face face = test::small_face();
  const aucast::test::TempFolder folder;
  const auto file = folder.write("mine.toml", test::small_aus_toml());
  const auto aus = load_aus(file, face);
  ASSERT_TRUE(aus.has_value()) << aus.error().message;
  EXPECT_EQ(aus->size(), face.recordings.size());
  const auto missing = load_aus(folder.path() / "none.toml", face);
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().kind, ErrorKind::Unreadable);
  const auto wrong = load_aus(folder.write("other.toml", "[[aus]]\n"), face);
  ASSERT_FALSE(wrong.has_value());
  EXPECT_EQ(wrong.error().kind, ErrorKind::BadData);
}

}  // namespace
}  // namespace aucast::face
