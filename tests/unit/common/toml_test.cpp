// What toml_writer writes, toml_document reads back as it was.
#include <limits>

#include <gtest/gtest.h>

#include "common/toml_reader.h"
#include "common/toml_writer.h"
#include "tests/support/seeded.h"

namespace aucast {
namespace {

/// The value of the only line of a file.
TomlValue read_back(const std::string& line) {
  const auto document = parse_toml(line, "f.toml");
  EXPECT_TRUE(document.has_value()) << line << (document ? "" : document.error().message);
  if (!document || document->entries.size() != 1) return {};
  return document->entries.front().value;
}

/// Any text that UTF-8 can hold, with much of what TOML treats as special.
std::string random_text(test::Seeded& random) {
  static const std::vector<std::string> kPieces = {"a",
                                                   "Z",
                                                   "9",
                                                   "_",
                                                   "-",
                                                   " ",
                                                   ".",
                                                   "#",
                                                   "=",
                                                   "\"",
                                                   "\\",
                                                   "'",
                                                   "\n",
                                                   "\r",
                                                   "\t",
                                                   "\x7f",
                                                   "\x01",
                                                   std::string(1, '\0'),
                                                   "\xc3\xa4",
                                                   "\xe2\x82\xac",
                                                   "\xf0\x9f\x99\x82",
                                                   "\xc2\x9b",
                                                   "]",
                                                   "}"};
  std::string text;
  for (int length = random.integer(0, 11); length > 0; --length) {
    text +=
        kPieces[static_cast<std::size_t>(random.integer(0, static_cast<int>(kPieces.size()) - 1))];
  }
  return text;
}

TEST(TomlWriter, EveryTextAndKeyIsReadBackAsItWas) {
  test::Seeded random(1);
  for (int i = 0; i < 3000; ++i) {
    const std::string key = random_text(random);
    const std::string text = random_text(random);
    const auto document = parse_toml(toml_line(key, toml_text(text)), "f.toml");
    ASSERT_TRUE(document.has_value()) << document.error().message;
    ASSERT_EQ(document->entries.size(), 1U);
    EXPECT_EQ(document->entries[0].key, key);
    EXPECT_EQ(document->entries[0].value.text, text);
  }
}

TEST(TomlWriter, EveryNumberIsReadBackAsItWas) {
  test::Seeded random(2);
  for (int i = 0; i < 3000; ++i) {
    const auto value = static_cast<float>(random.real(-1e9, 1e9) / random.integer(1, 1000000));
    const TomlValue read = read_back(toml_line("x", toml_real(value)));
    EXPECT_EQ(read.kind, TomlValue::Kind::Real);
    EXPECT_EQ(static_cast<float>(read.real), value);
  }
  EXPECT_EQ(toml_real(1), "1.0");
  EXPECT_EQ(toml_real(0.1F), "0.1");
  for (const float extreme : {std::numeric_limits<float>::max(), 1e20F, 1e-40F}) {
    EXPECT_EQ(static_cast<float>(read_back(toml_line("x", toml_real(extreme))).real), extreme);
  }
}

TEST(TomlWriter, AListIsReadBackAsItWas) {
  const std::vector<std::string> texts{"a", "", "\"b\"\n", "c,d"};
  const auto document = parse_toml(toml_line("x", toml_texts(texts)), "f.toml");
  ASSERT_TRUE(document.has_value());
  Problems problems("f.toml");
  EXPECT_EQ(TableReader(*document, problems).texts("x"), texts);
  EXPECT_EQ(toml_texts({}), "[]");
}

TEST(TomlWriter, BytesThatAreNotUtf8StillGiveAFileThatCanBeRead) {
  EXPECT_EQ(read_back(toml_line("x", toml_text("a\xff"))).text, "a\xef\xbf\xbd");
}

TEST(TomlWriter, QuotesAKeyOnlyWhereItMust) {
  EXPECT_EQ(toml_key("L12"), "L12");
  EXPECT_EQ(toml_key("dead-band_1"), "dead-band_1");
  EXPECT_EQ(toml_key("a.b"), "\"a.b\"");
  EXPECT_EQ(toml_key(""), "\"\"");
}

TEST(TableReader, NamesThePlaceOfTheFirstProblem) {
  const auto problem_of = [](std::string_view text, auto read) {
    const auto document = parse_toml(text, "f.toml");
    Problems problems("f.toml");
    TableReader reader(*document, problems);
    read(reader);
    reader.finish();
    const auto result = problems.result();
    return result ? std::string("none") : result.error().message;
  };
  const auto number = [](TableReader& reader) { reader.number("x", Bounds::between(0, 1)); };
  EXPECT_EQ(problem_of("x = 0.5\n", number), "none");
  EXPECT_EQ(problem_of("\n  x = 2\n", number), "f.toml:2:7: x is 2, must be from 0 to 1");
  EXPECT_EQ(problem_of("x = nan\n", number), "f.toml:1:5: x is not a finite number");
  EXPECT_EQ(problem_of("x = 'a'\n", number), "f.toml:1:5: x must be a number");
  EXPECT_EQ(problem_of("x = 1\ny = 2\n", number), "f.toml:2:1: unknown key 'y'");
  const auto word = [](TableReader& reader) {
    static constexpr std::array<std::string_view, 2> kWords{"linear", "cosine"};
    EXPECT_EQ(reader.word_or("x", 1, kWords), 1U);
  };
  EXPECT_EQ(problem_of("", word), "none");
  EXPECT_EQ(problem_of("x = 'cosine'\n", word), "none");
  EXPECT_EQ(problem_of("x = 'cubic'\n", word),
            "f.toml:1:5: x 'cubic' is not one of linear, cosine");
}

/// What is said of a table with these keys.
std::string said_of_keys(const std::vector<std::string>& present,
                         const std::vector<std::string>& required) {
  std::string text;
  for (const std::string& key : present) text += key + " = 1\n";
  const auto document = parse_toml(text, "f");
  Problems problems("f");
  TableReader reader(*document, problems);
  for (const std::string& key : required) reader.number(key);
  reader.finish();
  const auto result = problems.result();
  return result ? std::string("none") : result.error().message;
}

TEST(TableReader, AMissingKeyIsNamedHoweverNearTheOthersAre) {
  const std::vector<std::string> keys{"source", "sources", "b", "a", "name", "note"};
  for (const std::string& left_out : keys) {
    std::vector<std::string> present = keys;
    std::erase(present, left_out);
    EXPECT_TRUE(said_of_keys(present, keys).ends_with("'" + left_out + "' is missing"))
        << said_of_keys(present, keys);
  }
}

TEST(TableReader, AMisspeltKeySaysMoreThanTheMissingOne) {
  EXPECT_EQ(said_of_keys({"source", "sorces"}, {"sources", "source"}),
            "f:2:1: unknown key 'sorces'; did you mean sources?");
  EXPECT_EQ(said_of_keys({"elsewhere"}, {"sources"}), "f:1:1: 'sources' is missing");
}

TEST(ReadToml, RefusesWhatIsNoFileAndNamesThePlaceOfAMistake) {
  const auto device = read_toml("/dev/zero");
  ASSERT_FALSE(device.has_value());
  EXPECT_EQ(device.error().kind, ErrorKind::Unreadable);
  const auto bad = parse_toml("a = 1\nb = [\n", "f.toml");
  ASSERT_FALSE(bad.has_value());
  EXPECT_EQ(bad.error().kind, ErrorKind::BadData);
  EXPECT_TRUE(bad.error().message.starts_with("f.toml:2:")) << bad.error().message;
}

TEST(ReadToml, NamesAKeyThatIsDefinedTwiceAndItsPlace) {
  const auto said_of = [](std::string_view text) {
    const auto bad = parse_toml(text, "f.toml");
    return bad ? std::string("accepted") : bad.error().message;
  };
  const std::string twice = " is defined a second time; keep one of the two";
  EXPECT_EQ(said_of("port = 1\n\nport = 2\n"), "f.toml:3:1: port" + twice);
  EXPECT_EQ(said_of("[a]\nx=1\n  x=[2,\n3]\n"), "f.toml:3:3: x" + twice);
  EXPECT_EQ(said_of("x.y = 1\nx.y = 2\n"), "f.toml:2:1: x.y" + twice);
  EXPECT_EQ(said_of("a = {xx = 1, b = 'x', xx = 2}\n"), "f.toml:1:23: xx" + twice);
  EXPECT_EQ(said_of("\"a b\" = 1\n\"a b\" = 2\n"), "f.toml:2:1: \"a b\"" + twice);
  EXPECT_EQ(said_of("[a.b]\nx=1\n[a.b]\n"), "f.toml:3:2: a.b" + twice);
}

}  // namespace
}  // namespace aucast
