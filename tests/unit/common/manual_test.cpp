#include "common/manual.h"

#include <gtest/gtest.h>

namespace aucast {
namespace {

using Where = OptionRow::Where;

TEST(ManualPage, EscapesWhatIsSpecialToRoff) {
  ManualPage page("a-b", "1.0", "does it");
  page.paragraph(".dot -x \\n\n'quote");
  EXPECT_TRUE(page.text().starts_with(".TH A-B 1 \"\" \"AUcast 1.0\" \"AUcast\"\n"));
  EXPECT_NE(page.text().find("\na\\-b \\- does it\n"), std::string::npos);
  EXPECT_NE(page.text().find("\n\\&.dot \\-x \\en\n\\&'quote\n"), std::string::npos) << page.text();
}

/// A command with each form of an option.
CommandPage example_page(std::string_view command) {
  static bool loop = false;
  static int port = 0;
  return {.program = "a-b",
          .command = command,
          .usage = {"a-b [OPTIONS] FILE", "a-b play"},
          .about = "Does it.\n",
          .rows = {{.option = {"file", "FILE"}, .text = "what to read", .where = Where::Positional},
                   {.option = {"port", "N", "7"},
                    .text = "(7)",
                    .more = "The port.",
                    .value = whole(port, 0, 9),
                    .heading = "Network"},
                   {.option = {"loop"}, .text = "again", .value = flag(loop), .letter = 'l'},
                   {.option = {"long-one", "SOMETHING"},
                    .text = "an explanation of more than half a line",
                    .value = whole(port, 0, 9)},
                   {.option = {"rare"}, .more = "Only in the manual.", .value = flag(loop)}},
          .notes = "Running text\nthat goes on.\n\nAnother.\n",
          .examples = {"a-b x.txt"}};
}

TEST(HelpText, HasALineForEachOptionWithAText) {
  EXPECT_EQ(help_text(example_page("")), R"(usage: a-b [OPTIONS] FILE
       a-b play
Does it.

  FILE                     what to read

Network:
  --port N                 (7)
  -l, --loop               again
  --long-one SOMETHING     an explanation of more than half a line

Running text
that goes on.

Another.

  a-b x.txt
)");
}

TEST(ManualPage, HasEveryOptionWithItsDefault) {
  ManualPage page("a-b", "1", "does it");
  page.command(example_page(""));
  EXPECT_TRUE(page.text().ends_with(
      ".PP\n.nf\n.RS\na\\-b [OPTIONS] FILE\n.RE\n.fi\n.PP\n.nf\n.RS\na\\-b play\n.RE\n.fi\n"
      ".PP\nDoes it.\n\n.TP\n\\fBFILE\\fR\nwhat to read\n"
      ".SS Network\n.TP\n\\fB\\-\\-port N\\fR\nThe port. Default: 7.\n"
      ".TP\n\\fB\\-l, \\-\\-loop\\fR\nagain\n"
      ".TP\n\\fB\\-\\-long\\-one SOMETHING\\fR\nan explanation of more than half a line\n"
      ".TP\n\\fB\\-\\-rare\\fR\nOnly in the manual.\n"
      ".PP\nRunning text\nthat goes on.\n.PP\nAnother.\n\n"
      ".PP\n.nf\n.RS\na\\-b x.txt\n.RE\n.fi\n"))
      << page.text();
}

TEST(ManualPage, AnOptionWithoutAnExplanationHasItsDefault) {
  ManualPage page("a-b", "1", "does it");
  page.options({{.option = {"quick", "N", "3"}}});
  EXPECT_TRUE(page.text().ends_with(".TP\n\\fB\\-\\-quick N\\fR\nDefault: 3.\n")) << page.text();
}

TEST(Completion, NamesTheProgramItsCommandsAndAllOptions) {
  const std::vector<CommandPage> pages{example_page(""), example_page("play")};
  const auto script = [&pages](const char* shell) {
    return asked_completion({"--help-completion", shell}, pages).value_or("none");
  };
  const std::string bash = script("bash");
  EXPECT_NE(bash.find("compgen -W '--long-one --loop --port --rare' "), std::string::npos) << bash;
  EXPECT_NE(bash.find("compgen -W 'play' "), std::string::npos);
  EXPECT_TRUE(bash.ends_with("complete -o filenames -o default -F _a_b a-b\n"));
  EXPECT_TRUE(script("zsh").starts_with("#compdef a-b\n"));
  EXPECT_NE(script("zsh").find("compadd -- --long-one --loop --port --rare\n"), std::string::npos);
  EXPECT_NE(script("zsh").find("compadd -- play\n"), std::string::npos);
  EXPECT_EQ(script("fish"),
            "# fish completion for a-b\n"
            "complete -c a-b -n 'test (count (commandline -opc)) -eq 1' -a play\n"
            "complete -c a-b -l long-one\ncomplete -c a-b -l loop\ncomplete -c a-b -l port\n"
            "complete -c a-b -l rare\n");
}

TEST(Completion, IsForTheShellThatIsAskedFor) {
  const auto asked = [](const std::vector<std::string>& arguments) {
    return asked_completion(arguments, {example_page("")});
  };
  EXPECT_NE(asked({"--help-completion"}), std::nullopt);
  EXPECT_EQ(asked({"--help-completion"}), asked({"--help-completion", "bash"}));
  EXPECT_EQ(asked({"--help-completion", "csh"}), std::nullopt);
  EXPECT_EQ(asked({"--help-completion", "bash", "more"}), std::nullopt);
  EXPECT_EQ(asked({"--help"}), std::nullopt);
  EXPECT_EQ(asked({}), std::nullopt);
}

}  // namespace
}  // namespace aucast
