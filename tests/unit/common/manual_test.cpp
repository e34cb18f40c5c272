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
  EXPECT_TRUE(script.ends_with("complete -o filenames -o default -F _a_b a-b\n"));
  const std::string zsh = zsh_completion("a-b", {"--x", "--y"}, {"play"});
  EXPECT_TRUE(zsh.starts_with("#compdef a-b\n"));
  EXPECT_NE(zsh.find("compadd -- --x --y\n"), std::string::npos);
  EXPECT_NE(zsh.find("compadd -- play\n"), std::string::npos);
  EXPECT_EQ(fish_completion("a-b", {"--x"}, {"play"}),
            "# fish completion for a-b\n"
            "complete -c a-b -n 'test (count (commandline -opc)) -eq 1' -a play\n"
            "complete -c a-b -l x\n");
}

TEST(Completion, IsForTheShellThatIsAskedFor) {
  const auto asked = [](const std::vector<std::string>& arguments) {
    return asked_completion(arguments, "p", {"--x"}, {});
  };
  EXPECT_EQ(asked({"--help-completion"}), bash_completion("p", {"--x"}, {}));
  EXPECT_EQ(asked({"--help-completion", "bash"}), bash_completion("p", {"--x"}, {}));
  EXPECT_EQ(asked({"--help-completion", "zsh"}), zsh_completion("p", {"--x"}, {}));
  EXPECT_EQ(asked({"--help-completion", "fish"}), fish_completion("p", {"--x"}, {}));
  EXPECT_EQ(asked({"--help-completion", "csh"}), std::nullopt);
  EXPECT_EQ(asked({"--help"}), std::nullopt);
  EXPECT_EQ(asked({}), std::nullopt);
}

}  // namespace
}  // namespace aucast
