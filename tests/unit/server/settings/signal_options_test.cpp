// The options on a recogniser's signals, and the profile beneath them.
#include "server/settings/signal_options.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

using sources::AuName;
using sources::OneEuroSettings;
using sources::PerAu;
using test::TempFolder;

Complaint read_into(SignalOptions& options, const std::string& name, const std::string& word) {
  const auto rows = signal_rows(options);
  return find_row(rows, name)->value.read(word);
}

SignalOptions read_one(const std::string& name, const std::string& word) {
  SignalOptions options;
  const Complaint wrong = read_into(options, name, word);
  EXPECT_FALSE(wrong) << word << " " << *wrong;
  return options;
}

std::string complaint(const std::string& name, const std::string& word) {
  SignalOptions options;
  const Complaint wrong = read_into(options, name, word);
  EXPECT_EQ(options, SignalOptions()) << word;
  return wrong.value_or("accepted");
}

sources::ConditioningSettings settled(const SignalOptions& options) {
  const auto settings = conditioning_of(options);
  if (!settings) {
    ADD_FAILURE() << settings.error().message;
    return {};
  }
  return *settings;
}

TEST(SignalOptions, AreRead) {
  EXPECT_EQ(read_one("neutral", "2.5").neutral_seconds, 2.5);
  EXPECT_EQ(read_one("neutral", "auto").neutral_seconds, std::nullopt);
  EXPECT_TRUE(read_one("neutral", "auto").neutral_auto);
  EXPECT_FALSE(read_one("neutral", "2").neutral_auto);
  EXPECT_EQ(read_one("gain", "1.2").gain, (std::vector<AuNumber>{{std::nullopt, 1.2}}));
  EXPECT_EQ(read_one("gain", "0.5,45=1.6,L12=2").gain,
            (std::vector<AuNumber>{
                {std::nullopt, 0.5}, {AuName{45, Side::Both}, 1.6}, {AuName{12, Side::Left}, 2}}));
  EXPECT_EQ(read_one("dead-band", "0").dead_band, (std::vector<AuNumber>{{std::nullopt, 0}}));
  EXPECT_EQ(read_one("filter", "0.5").filter, (OneEuroSettings{0.5, 5, 1}));
  EXPECT_EQ(read_one("filter", "0.5,0").filter, (OneEuroSettings{0.5, 0, 1}));
  EXPECT_EQ(read_one("filter", "0.5,2,3").filter, (OneEuroSettings{0.5, 2, 3}));
  EXPECT_TRUE(read_one("distance", "true").distance);
}

TEST(SignalOptions, WrongWordsAreNamedWithTheirForm) {
  for (const char* word : {"-1", "61", "nan", "", "2s"}) {
    EXPECT_EQ(complaint("neutral", word),
              "is neither auto nor a number of seconds from 0 (no neutral face) to 60");
  }
  for (const char* word : {"-1", "11", "nan", "", "12=", "=2", "0=1", "12:2", "1,,2", "12=1,"}) {
    EXPECT_EQ(complaint("gain", word),
              "is not a list of numbers from 0 to 10, such as 1.2 or 45=1.6,L12=1.2");
  }
  for (const char* word : {"1.5", "51", "-1", "12=x", "2,12=0.5"}) {
    EXPECT_EQ(complaint("dead-band", word),
              "is not a list of whole percents from 0 to 50, such as 2 or 2,12=4,L45=0");
  }
  for (const char* word : {"", "-1", "101", "1,", "1,2,0", "1,2,3,4", "nan", "1;2"}) {
    EXPECT_EQ(complaint("filter", word),
              "is not CUTOFF[,BETA[,CUTOFF]], Hz to 100 and 0 to 100, such as 1,5; 0 is no filter");
  }
}

TEST(SignalOptions, WithoutAnyOnlyTheDeadBandIsOn) {
  const auto settings = settled({});
  EXPECT_EQ(settings.profile.gain, PerAu(1));
  EXPECT_EQ(settings.profile.dead_band, PerAu(2));
  EXPECT_FALSE(settings.profile.filter);
  EXPECT_FALSE(settings.neutral_seconds);
  EXPECT_FALSE(settings.distance);
}

TEST(SignalOptions, WinOverTheProfile) {
  const TempFolder folder;
  SignalOptions options;
  options.profile = folder.write("p.toml",
                                 "[neutral]\n12 = 10\n[gain]\nall = 2\n45 = 3\n"
                                 "[dead-band]\n12 = 4\n[filter]\nmin-cutoff = 0.5\nbeta = 3\n");
  auto settings = settled(options);
  EXPECT_EQ(settings.profile.gain.of(45, false), 3);
  EXPECT_EQ(settings.profile.dead_band.of(12, false), 4);
  EXPECT_EQ(settings.profile.filter, (OneEuroSettings{0.5, 3, 1}));
  options.gain = {{AuName{1, Side::Both}, 1.5}};
  options.dead_band = {{std::nullopt, 3}};
  options.filter = OneEuroSettings{0, 1, 1};
  options.neutral_seconds = 0;
  settings = settled(options);
  EXPECT_EQ(settings.profile.gain.of(45, false), 3);
  EXPECT_EQ(settings.profile.gain.of(1, false), 1.5);
  EXPECT_EQ(settings.profile.dead_band, PerAu(3)) << "one alone is for all";
  EXPECT_FALSE(settings.profile.filter);
  EXPECT_FALSE(settings.neutral_seconds);
  EXPECT_FALSE(sources::is_signal(settings.profile.neutral[12]));
}

TEST(SignalOptions, AProfileThatIsNotThereOrWrongEndsIt) {
  const TempFolder folder;
  SignalOptions options;
  options.profile = folder.path() / "none.toml";
  EXPECT_EQ(conditioning_of(options).error().kind, ErrorKind::Unreadable);
  options.profile = folder.write("p.toml", "[gain]\n12 = 'a'\n");
  EXPECT_EQ(conditioning_of(options).error().kind, ErrorKind::BadData);
  EXPECT_EQ(conditioning_of(options).error().message,
            options.profile.string() + ":2:6: 12 is not a number");
}

TEST(SignalOptions, ASavedProfileIsAllThatIsNeededNextTime) {
  const TempFolder folder;
  SignalOptions options;
  options.profile = folder.write("old.toml", "[neutral]\n4 = 7\n[gain]\n45 = 1.6\n");
  options.save_profile = folder.path() / "new.toml";
  options.neutral_seconds = 2;
  options.filter = OneEuroSettings{0.5, 2, 1};
  sources::MeasuredNeutral measured;
  measured.rows = 60;
  measured.signals[12] = 0.25F;
  ASSERT_TRUE(save_profile(options.save_profile, settled(options), measured));
  SignalOptions next;
  next.profile = options.save_profile;
  const auto settings = settled(next);
  EXPECT_FALSE(settings.neutral_seconds);
  EXPECT_FLOAT_EQ(settings.profile.neutral[12], 0.25F);
  EXPECT_FLOAT_EQ(settings.profile.neutral[4], 0.07F) << "not seen now";
  EXPECT_EQ(settings.profile.gain.of(45, true), 1.6);
  EXPECT_EQ(settings.profile.filter, options.filter);
  measured.rows = 0;
  EXPECT_EQ(save_profile(options.save_profile, settings, measured).error().kind,
            ErrorKind::BadData);
  EXPECT_EQ(save_profile(folder.path() / "no" / "p.toml", settings, std::nullopt).error().kind,
            ErrorKind::Failed);
}

}  // namespace
}  // namespace aucast::server
