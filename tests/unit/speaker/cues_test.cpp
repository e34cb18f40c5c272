#include "speaker/cues.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/au_numbers.h"
#include "speaker/performance.h"

namespace aucast::speaker {
namespace {

TEST(SetsOf, HasNoAusForWhatIsMadeOfMusclesAlone) {
  std::vector<Expression> read(3);
  read[0].name = "neutral";
  read[1].name = "joy";
  set_intensity(read[1].aus, 12, Side::Both, 0.6F);
  read[1].muscles = read[2].muscles = {{"zygomaticus_major", {}, 1, 1}};
  read[2].name = "pull";
  EXPECT_EQ(sets_of(read), (Expressions{{"neutral", {{0, Side::Both, 100}}},
                                        {"joy", {{12, Side::Both, 60}}},
                                        {"pull", {}}}));
}

/// What is said of a text with cues; empty: they are right.
std::string complaint(const std::string& text) {
  const Expressions expressions{{"happiness-12C", {{12, Side::Both, 50}}},
                                {"surprise", {{1, Side::Both, 100}}},
                                {"mild 50", {{1, Side::Both, 20}}},
                                {"waters-fear", {}}};
  const auto script = parse_script(text, "t.txt");
  EXPECT_TRUE(script);
  const auto checked = check_cues(*script, expressions, "t.txt");
  if (checked) return "";
  EXPECT_EQ(checked.error().kind, ErrorKind::BadData);
  return checked.error().message;
}

TEST(CheckCues, TakeExpressionsPercentAndAus) {
  for (const char* cue : {"L12:40",
                          "12C,R2:10",
                          "6,12:60",
                          "{6+12}",
                          "R14",
                          "0",
                          "Surprise 40",
                          "surprise",
                          "happiness-12C",
                          "Happiness-12c",
                          "happiness-12C 50",
                          "smile",
                          "SMILE 100",
                          "smile 0",
                          "mild 50",
                          "Mild 50",
                          "mild 50 50",
                          "6,12:60 50",
                          "6, 12",
                          "6 + 12"}) {
    EXPECT_EQ(complaint("[" + std::string(cue) + "] a"), "") << cue;
  }
}

TEST(CheckCues, NameTheNearestExpressionOrWhereTheyAreListed) {
  EXPECT_EQ(complaint("hello [suprise] a"),
            "t.txt:1:7: [suprise] is no expression; did you mean [surprise]?");
  EXPECT_EQ(complaint("hello\n\n[suprise 40] a"),
            "t.txt:3:1: [suprise] is no expression; did you mean [surprise]?");
  EXPECT_EQ(complaint("[see page] a"),
            "t.txt:1:1: [see page] is no expression; [smile], AUs and the names of `face-player "
            "pose --list` are");
  EXPECT_NE(complaint("[] a"), "");
}

TEST(CheckCues, TellOfAWrongPercent) {
  for (const char* percent : {"500", "101", "-1", "50.5"}) {
    const std::string cue = "[smile " + std::string(percent) + "]";
    EXPECT_EQ(complaint(cue + " a"),
              "t.txt:1:1: " + cue + " has a percent that is no whole number from 0 to 100");
  }
}

TEST(CheckCues, TellWhatIsWrongWithAus) {
  EXPECT_EQ(complaint("[6,12:900] a"),
            "t.txt:1:1: AU set '6,12:900', column 8: an intensity is 0-100 percent");
  EXPECT_NE(complaint("[6;400] a").find("a time (';') has a meaning in a stream"),
            std::string::npos);
  EXPECT_NE(complaint("[R12Z] a").find("AU set 'R12Z', column 4"), std::string::npos);
}

TEST(CheckCues, TellThatMusclesAreNotCarried) {
  for (const char* cue : {"[waters-fear]", "[Waters-Fear 40]"}) {
    EXPECT_NE(complaint(cue + std::string(" a")).find("is made of muscles alone, which no stream"),
              std::string::npos)
        << cue;
  }
  EXPECT_EQ(complaint("[waters-fer] a").find("waters-fear"), std::string::npos)
      << "nor is it proposed";
}

/// Says the script's words one second apart, from 2 s on, without a sound that moves the lips.
Speech a_word_each_second(const Script& script) {
  Speech speech;
  const Characters text(script.text);
  Milliseconds begin{2000};
  for (std::size_t i = 0; i < text.count(); ++i) {
    if (text.part(i, 1) == " " || text.part(i, 1) == "\n") continue;
    std::size_t length = 1;
    while (text.part(i + length, 1) != " " && text.part(i + length, 1) != "\n") ++length;
    speech.words.push_back({begin, i, length});
    begin += Milliseconds(1000);
    i += length;
  }
  speech.samples.resize(static_cast<std::size_t>((begin.count() + 2000) * speech.rate / 1000));
  return speech;
}

class Performed {
 public:
  explicit Performed(const std::string& text, float amount = 0) {
    const Expressions expressions{{"brows", {{kOuterBrowRaiser, Side::Both, 80}}},
                                  {"smirk", {{kLipCornerPuller, Side::Left, 100}}},
                                  {"gape", {{kJawDrop, Side::Both, 100}}},
                                  {"neutral", {{0, Side::Both, 100}}}};
    auto script = parse_script(text, "t");
    EXPECT_TRUE(script);
    EXPECT_TRUE(check_cues(*script, expressions, "t"));
    const Speech speech = a_word_each_second(*script);
    length_ = speech.length();
    stream_ = perform(speech, *script, expressions, {.seed = 1, .amount = amount});
  }

  [[nodiscard]] const std::vector<protocol::Keyframe>& keyframes() const {
    return stream_.keyframes;
  }
  [[nodiscard]] Milliseconds length() const { return length_; }

  /// In percent, as a player shows it that draws straight lines.
  [[nodiscard]] double at(int ms, int au, Side side = Side::Both) const {
    double from = 0;
    std::uint32_t begin = 0;
    for (const protocol::Keyframe& keyframe : stream_.keyframes) {
      double to = 0;
      for (const AuTerm& term : keyframe.terms) {
        if (term.number == au && term.side == side) to = term.percent;
      }
      const std::uint32_t end = begin + *keyframe.time_ms;
      if (static_cast<std::uint32_t>(ms) <= end) {
        return from + (to - from) * (ms - static_cast<double>(begin)) / *keyframe.time_ms;
      }
      from = to;
      begin = end;
    }
    return from;
  }

 private:
  protocol::StreamFile stream_;
  Milliseconds length_{0};
};

constexpr double kNear = 8;  ///< percent: the tolerance of the keyframes, and what is rounded

TEST(Cues, ShowWhollyFromTheirWordAndBeginBeforeIt) {
  const Performed face("one [brows] two three");
  EXPECT_NEAR(face.at(3000, kOuterBrowRaiser), 80, kNear) << "the second word";
  EXPECT_NEAR(face.at(2825, kOuterBrowRaiser), 40, kNear) << "half of 350 ms before";
  EXPECT_EQ(face.at(2600, kOuterBrowRaiser), 0);
  EXPECT_NEAR(face.at(5000, kOuterBrowRaiser), 80, kNear) << "the end of the text is its end";
}

TEST(Cues, EndWithTheParagraphInSixTenthsOfASecond) {
  const Performed face("[brows] one two\n\nthree four");
  EXPECT_NEAR(face.at(4000, kOuterBrowRaiser), 80, kNear) << "the third word begins";
  EXPECT_NEAR(face.at(4300, kOuterBrowRaiser), 40, kNear);
  EXPECT_EQ(face.at(4700, kOuterBrowRaiser), 0);
}

TEST(Cues, EndWithTheNextOneAndZeroIsNoExpression) {
  const Performed face("[brows] one [smirk] two [0] three");
  EXPECT_EQ(face.at(3700, kOuterBrowRaiser), 0);
  EXPECT_NEAR(face.at(3500, kLipCornerPuller, Side::Left), 55, kNear)
      << "what a speaking mouth leaves of a smile";
  EXPECT_EQ(face.at(3500, kLipCornerPuller), 0) << "of one side";
  EXPECT_EQ(face.at(4800, kLipCornerPuller, Side::Left), 0);
}

TEST(Cues, ArePercentOfTheirExpression) {
  EXPECT_NEAR(Performed("[brows 50] one two").at(3000, kOuterBrowRaiser), 40, kNear);
  EXPECT_NEAR(Performed("[BROWS 50] one two").at(3000, kOuterBrowRaiser), 40, kNear);
  EXPECT_NEAR(Performed("[2:60 50] one two").at(3000, kOuterBrowRaiser), 30, kNear);
  EXPECT_EQ(Performed("[brows 0] one two").at(3000, kOuterBrowRaiser), 0);
  EXPECT_NEAR(Performed("[smile] one two").at(3000, kCheekRaiser), 50, kNear);
}

TEST(Cues, LeaveTheLipsToWhatTheySay) {
  EXPECT_EQ(Performed("[gape] one two").at(3000, kJawDrop), 0);
}

TEST(Cues, AfterTheLastWordAskForNothing) {
  const Performed face("one two [brows]");
  for (int ms = 0; ms < face.length().count(); ms += 100) {
    EXPECT_EQ(face.at(ms, kOuterBrowRaiser), 0) << ms;
  }
}

TEST(Perform, GivesAStreamFileThatReadsBackWhateverTheAmount) {
  for (const float amount : {0.0F, 1.0F, 2.0F}) {
    const Performed face("[smirk] one [brows] two three? four\n\nfive. [L12:100,R12:20] six",
                         amount);
    protocol::StreamFile stream;
    stream.keyframes = face.keyframes();
    const auto read = protocol::parse_stream_file(protocol::format_stream_file(stream), "t");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->keyframes.size(), face.keyframes().size());
    std::uint64_t ms = 0;
    for (const protocol::Keyframe& keyframe : face.keyframes()) {
      ASSERT_TRUE(keyframe.time_ms);
      EXPECT_GT(*keyframe.time_ms, 0U);
      EXPECT_LE(*keyframe.time_ms, 1000U) << "who joins waits no longer for a whole face";
      ms += *keyframe.time_ms;
    }
    EXPECT_EQ(ms, static_cast<std::uint64_t>(face.length().count()) / 20 * 20);
  }
}

std::vector<AuTerm> last_terms(Curves curves) {
  return keyframes_of(curves, 0.01F).back().terms;
}

TEST(KeyframesOf, AFaceThatDoesNothingIsNeutral) {
  const Curves still(Milliseconds(500));
  const auto keyframes = keyframes_of(still, 0.01F);
  ASSERT_EQ(keyframes.size(), 1U);
  EXPECT_EQ(keyframes.front().terms, (std::vector<AuTerm>{{0, Side::Both, 100}}));
  EXPECT_EQ(keyframes.front().time_ms, 500U);
}

TEST(KeyframesOf, ASideIsNamedWhereItIsStrongerThanBoth) {
  Curves curves(Milliseconds(100));
  curves.of(12).back() = 0.5F;
  curves.of(12, Side::Left).back() = 0.8F;
  curves.of(12, Side::Right).back() = 0.4F;
  curves.of(14, Side::Right).back() = 0.3F;
  curves.of(26).back() = 0.014F;
  EXPECT_EQ(
      last_terms(curves),
      (std::vector<AuTerm>{{12, Side::Both, 50}, {12, Side::Left, 80}, {14, Side::Right, 30}}))
      << "a percent is nothing";
}

TEST(KeyframesOf, AJumpIsWhereItIsAndNotBefore) {
  Curves curves(Milliseconds(2000));
  std::vector<float>& samples = curves.of(45);
  std::fill(samples.begin() + 30, samples.begin() + 33, 1.0F);
  std::uint32_t at = 0;
  std::vector<std::uint32_t> shut;
  for (const protocol::Keyframe& keyframe : keyframes_of(curves, 0.07F)) {
    at += *keyframe.time_ms;
    if (keyframe.terms.front().number == 45) shut.push_back(at);
  }
  EXPECT_EQ(shut, (std::vector<std::uint32_t>{600, 640}));
  EXPECT_EQ(at, 2000U);
}

TEST(KeyframesOf, ASpeechShorterThanAStepHasNone) {
  EXPECT_TRUE(keyframes_of(Curves(Milliseconds(10)), 0.05F).empty());
}

TEST(CurvesIndex, StaysWithinTheCurve) {
  const Curves curves(Milliseconds(100));
  EXPECT_EQ(curves.steps, 6U);
  EXPECT_EQ(curves.index(Milliseconds(-300)), 0U);
  EXPECT_EQ(curves.index(Milliseconds(39)), 1U);
  EXPECT_EQ(curves.index(Milliseconds(100)), 5U);
  EXPECT_EQ(curves.index(Milliseconds(5000)), 5U);
}

}  // namespace
}  // namespace aucast::speaker
