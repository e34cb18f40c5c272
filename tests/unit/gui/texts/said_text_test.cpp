#include "client/gui/texts/said_text.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "client/gui/storage/language_file.h"
#include "client/gui/texts/texts.h"

namespace aucast::gui {
namespace {

class SaidText : public testing::Test {
 protected:
  void TearDown() override { use_english(); }
  static void use_french() {
    auto french = load_language(std::filesystem::path(AUCAST_TEST_DATA) / "languages" / "fr.toml");
    ASSERT_TRUE(french) << french.error().message;
    use_language(std::move(french->language));
  }
};

const std::vector<std::string> kSaid = {
    "cannot reach 127.0.0.1:4650: Connection refused; is au-transmitter running there, on an "
    "address that can be reached from here?",
    "venus:4650: the connection ended before the end of the stream, {-2}; the server's log may say "
    "why",
    "[::1]:4650: the server refused: 404 there is no stream 'x' here",
    "venus:4650: the server's certificate has been revoked",
    "venus:4650: the server's certificate comes from an authority of which --tls-ca has no "
    "revocation list",
    "venus:4650: the server's certificate cannot be checked: its authority's revocation list in "
    "--tls-ca is out of date",
    "venus:4650: cannot be reached: no answer within 500 ms; is au-transmitter running there, on "
    "an address that can be reached from here?",
    "/tmp/a.glb: 3.49 MB, 133 targets\nfarthest vertex from the face itself: median 0.10 mm, nine "
    "of ten below 0.50 mm, worst 1.00 mm (200 random faces)",
    "/tmp/a.glb: 3.49 MB, 133 targets, 30 samples in 1.0 s\nfarthest vertex from the face itself: "
    "median 0.10 mm, nine of ten below 0.50 mm, worst 1.00 mm (30 samples)",
    "OpenFace 2: 10 rows, 2 without a face, 1 left out (no later time); one of 3 faces",
    "/tmp/p.csv: Py-Feat wrote no times here; say how many pictures a second there are, such as "
    "Pictures/s 30",
    "/tmp/p.csv: no row has a later time than the first; say how many pictures a second there are, "
    "such as "
    "Pictures/s 30",
    "1000 rows a second are no camera's: Pictures/s says how many",
    "100 rows without a later time: Pictures/s 60 reads them all",
    "AU7 100 %, AU20 100 %, AU10 77 % and 12 more: no neutral face was subtracted; leave out "
    "'Neutral, s', or cut what is before the face is neutral",
    "movement of AU4 73 %, AU1 61 %, AU2 58 % and 2 more: no neutral face was subtracted; "
    "'Neutral, s' 1 subtracts one",
    "AU7 100 %: no neutral face was subtracted; 'Neutral, s' 10 subtracts one",
    "/tmp/a.txt: cannot be read: No such file or directory",
    "/tmp/a.txt: cannot be read: Permission denied",
    "/tmp/a.txt: cannot be read: No such file or directory; check the name",
    "/tmp/a.txt: cannot be read: Permission denied; check its permissions",
    "/tmp/a.txt: cannot be written: Read-only file system; choose another folder",
    "this face cannot be copied to /home/anna/own: Permission denied",
    "this face cannot be renamed to /home/anna/own/b: Read-only file system",
    "this face cannot be deleted: /home/anna/own/a: No such file or directory",
    "not all of this face could be deleted: /home/anna/own/.deleted: Permission denied",
    "/home/anna/own/a: is there already; choose another name",
    "/home/anna/own/a: this face is gone; choose another one",
    "/home/anna/own/a is a classic face: its Action Units come from a table for all such faces and "
    "cannot be saved with it",
    "/tmp/fifo.txt: cannot be read: it is a pipe, not a file",
    "/tmp: cannot be read: it is a folder",
    "/dev/zero: cannot be read: it is a device, not a file",
    "/tmp/a.mp4: there are no pictures in it",
    "/tmp/a.mp4: there are no pictures in it; ffmpeg says: Broken pipe",
    "/tmp/a.csv:1:1: a table whose columns are of no recogniser known here; known are OpenFace",
    "/tmp/a.png: cannot be written: No space left on device",
    "/tmp: Is a directory",
    "/tmp/a.txt:1:1: there is no stream: Beg_Stream, packets and End_Stream are missing",
    "/tmp/a.csv:1:1: the file is empty",
    "/tmp/a.png:1:1: this is not text: found the byte '\\x89'; a stream file is ASCII or UTF-8 "
    "text",
    "/tmp/a.csv:1:1: the recording has no rows",
    "/dev/video7: there is no such camera; plug it in, or name another one or a film",
    "cannot listen on 0.0.0.0:4650: Address already in use; another program has this port: stop "
    "it, "
    "or choose one with the number beside Address (0 takes any free one)",
    "cannot listen on 10.9.9.9:4650: Cannot assign requested address; that is not an address of "
    "this host: choose one with Address (127.0.0.1 for this host only, 0.0.0.0 for all addresses)",
    "cannot listen on 0.0.0.0:80: Permission denied; ports below 1024 are for root: choose another "
    "with the number beside Address",
    "the sweep '100' is neither a set of AUs nor an expression",
    "the sweep 'hapiness' is neither a set of AUs nor an expression; did you mean happiness?"};

TEST_F(SaidText, IsAsItCameInEnglish) {
  for (const std::string& text : kSaid) EXPECT_EQ(in_used_language(text), text);
}

TEST_F(SaidText, HasNoEnglishLeftInFrench) {
  use_french();
  for (const std::string& text : kSaid) {
    const std::string french = in_used_language(text);
    EXPECT_NE(french, text);
    for (const char* english :
         {" is ", "found", "address", "set of", "the ", "a second", " more", "Pictures", "Neutral",
          "refused", "cannot", "within", "worst", "rows", "faces", "targets", "answer"}) {
      EXPECT_EQ(french.find(english), std::string::npos) << french;
    }
  }
}

TEST_F(SaidText, ASentenceComesBeforeWhatIsKnownInEnglishOnly) {
  const Error strange{ErrorKind::BadData, "/tmp/a.txt:2:3: a strange packet"};
  const Error absent{ErrorKind::Unreadable,
                     "/tmp/a.txt: cannot be read: No such file or directory"};
  EXPECT_EQ(error_in_used_language(strange), strange.message);
  EXPECT_EQ(error_in_used_language(absent), absent.message);
  use_french();
  const std::string said = error_in_used_language(strange);
  EXPECT_EQ(said, std::string(tr("said.bad_data")) + "\n" + strange.message);
  EXPECT_EQ(error_in_used_language(absent), in_used_language(absent.message));
  EXPECT_NE(in_used_language(absent.message), absent.message);
  const Error usage{ErrorKind::Usage, "as it was asked for"};
  EXPECT_EQ(error_in_used_language(usage), usage.message);
}

TEST_F(SaidText, ATokenIsAskedForWhereTheWindowHasAFieldForIt) {
  const std::string said =
      "venus:4650: the server refused: 401 a token is needed here (--token-file)";
  for (const bool in_french : {false, true}) {
    if (in_french) use_french();
    const std::string shown = in_used_language(said);
    EXPECT_EQ(shown.find("--token-file"), std::string::npos) << shown;
    EXPECT_NE(shown.find(tr("play.token_file")), std::string::npos) << shown;
    EXPECT_NE(shown.find("401"), std::string::npos) << shown;
  }
}

TEST_F(SaidText, NamesNoOptionWhereTheWindowHasAField) {
  const std::string at = "venus:4650: ";
  const std::string certificate =
      at +
      "the server's certificate comes from an authority that is not known here; --tls-ca FILE "
      "names one to believe";
  for (const bool in_french : {false, true}) {
    if (in_french) use_french();
    const std::string only = in_used_language(
        at + "the server refused: 400 this server speaks TLS only (face-player --tls)");
    const std::string none = in_used_language(
        at +
        "the server does not speak TLS; leave out --tls (of aucasts:// the s), or serve with "
        "--tls-cert");
    const std::string unknown = in_used_language(certificate);
    for (const std::string& shown : {only, none, unknown}) {
      EXPECT_EQ(shown.find("--"), std::string::npos) << shown;
      EXPECT_NE(shown.find("venus:4650"), std::string::npos) << shown;
    }
    EXPECT_NE(only.find("aucasts://"), std::string::npos) << only;
    EXPECT_NE(none.find("aucast://"), std::string::npos) << none;
    EXPECT_NE(unknown.find(tr("play.authorities_file")), std::string::npos) << unknown;
  }
}

TEST_F(SaidText, KeepsNamesAndNumbersAndWhatItDoesNotKnow) {
  use_french();
  const std::string refused = in_used_language(kSaid[0]);
  EXPECT_NE(refused.find("127.0.0.1:4650"), std::string::npos) << refused;
  EXPECT_NE(in_used_language(kSaid[1]).find("{-2}"), std::string::npos);
  EXPECT_NE(in_used_language(kSaid[2]).find("[::1]:4650"), std::string::npos);
  for (const char* own : {"", "venus: a server's own words", "AU12 saved"}) {
    EXPECT_EQ(in_used_language(own), own);
  }
}

}  // namespace
}  // namespace aucast::gui
