#include "common/manual.h"

#include <gtest/gtest.h>

namespace aucast {
namespace {

TEST(ManualPage, EscapesWhatIsSpecialToRoff) {
  ManualPage page("a-b", "1.0", "does it");
  page.paragraph(".dot -x \\n\n'quote");
  EXPECT_TRUE(page.text().starts_with(".TH A-B 1 \"\" \"AUcast 1.0\" \"AUcast\"\n"));
  EXPECT_NE(page.text().find("\na\\-b \\- does it\n"), std::string::npos);
  EXPECT_NE(page.text().find("\n\\&.dot \\-x \\en\n\\&'quote\n"), std::string::npos) << page.text();
}

TEST(ManualPage, ReadsAPageOfHelp) {
  ManualPage page("p", "1", "does it");
  add_help_page(page, "p", R"(p: does it

Receiving
  --one N (5)  --two    what it is
                        and goes on
Running text that
goes on.

  p --one 3
)");
  const std::string expected =
      ".PP\np: does it\n.SS Receiving\n.TP\n\\fB\\-\\-one N (5)\\fR\n\\&\n"
      ".TP\n\\fB\\-\\-two\\fR\nwhat it is and goes on\n"
      ".PP\nRunning text that goes on.\n.PP\n.nf\n.RS\np \\-\\-one 3\n.RE\n.fi\n";
  EXPECT_TRUE(page.text().ends_with(expected)) << page.text();
}

TEST(Completion, OptionsAreFoundInAText) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(options_in("--b N, --a-c; -x -- --b=1 ---"), (Names{"--a-c", "--b"}));
}

TEST(Completion, NamesTheProgramAndItsOptions) {
  const std::string script = bash_completion("a-b", {"--x", "--y"}, {"play"});
  EXPECT_NE(script.find("compgen -W '--x --y' "), std::string::npos);
  EXPECT_NE(script.find("compgen -W 'play' "), std::string::npos);
  EXPECT_TRUE(script.ends_with("complete -o default -F _a_b a-b\n"));
}

}  // namespace
}  // namespace aucast
