// Completion as it is installed, in the shells themselves.
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/integration/installed.h"

namespace aucast::test {
namespace {

using Words = std::set<std::string>;

// Bash and zsh offer words at a terminal alone: zsh's own terminal is theirs. What is typed is $1
// and the tabulator, not before the prompt is there: until then a terminal edits lines in its own
// way.

const char* const kBash = R"(
zmodload zsh/zpty
zpty shell TERM=dumb INPUTRC=/dev/null bash --norc --noprofile -i
zpty -w shell "for file in $PREFIX/share/bash-completion/completions/*; do source \$file; done
bind 'set completion-query-items 0' 'set page-completions off' '\"\\t\": possible-completions'
PS1='<re''ady>'"
zpty -r shell said '*<ready>*'
zpty -n -w shell "$1"$'\t\C-U'"echo '<en''d>'"$'\n'
zpty -r shell said '*<end>*'
print -rl -- ${=said})";

const char* const kZsh = R"(
zmodload zsh/zpty
zpty shell TERM=dumb zsh -f -i
zpty -w shell 'LISTMAX=10000
fpath=($PREFIX/share/zsh/site-functions $fpath); autoload -U compinit; compinit -u -D
compadd() {
  local -a offered
  [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]] || {
    builtin compadd -A offered "$@"
    print -rl -- "" "<"${^offered}">"
  }
  builtin compadd "$@"
}
offer() { zle list-choices; print -r "<end>" }
zle -N offer
bindkey "^I" offer
PROMPT="<re""ady>"'
zpty -r shell said '*<ready>*'
zpty -n -w shell "$1"$'\t'
zpty -r shell said '*<end>*'
for line in ${(f)said}; do
  [[ $line == '<'*'>'* ]] && print -r -- ${${line#<}%%>*}
done)";

const char* const kFish = "complete -C $argv[1]";

class Completion : public Installed {
 protected:
  /// What the shell offers in a folder with talk.txt and pictures/; of --option=WORD the word.
  Words offered(std::vector<std::string> shell, const std::string& typed) {
    folder_.write("here/talk.txt", "");
    folder_.write("here/pictures/one.png", "");
    const std::string prefix = folder_.path().string();
    std::vector<std::string> command{"sh", "-c", "cd \"$PREFIX/here\" && exec \"$@\"", "sh"};
    shell.push_back(typed);
    command.insert(command.end(), shell.begin(), shell.end());
    const Finished done = run(
        command, {"PREFIX=" + prefix, "PATH=" + prefix + "/bin:/usr/bin:/bin", "HOME=" + prefix,
                  "XDG_CONFIG_HOME=" + prefix, "XDG_DATA_DIRS=" + prefix + "/share:/usr/share"});
    EXPECT_NE(done.exit_code, -1) << shell[0] << ": " << typed;
    EXPECT_EQ(done.err, "") << shell[0] << ": " << typed;
    Words words;
    std::istringstream lines(done.out);
    for (std::string line; std::getline(lines, line);) {
      line.erase(0, line.find('=') + 1);
      std::erase(line, '\r');
      if (line.ends_with('/')) line.pop_back();
      words.insert(line);
    }
    return words;
  }
};

TEST_F(Completion, OffersTheSameInBashZshAndFish) {
  const std::vector<std::vector<std::string>> shells{
      {"zsh", "-f", "-c", kBash, "bash"}, {"zsh", "-f", "-c", kZsh, "zsh"}, {"fish", "-c", kFish}};
  struct Case {
    const char* typed;
    Words offered;
    Words others;
  };
  const std::vector<Case> cases{
      {"au-transmitter --classic", {"--classic-min"}, {"--loop", "talk.txt"}},
      {"au-transmitter --loop --key", {"--keyframe"}, {"--loop"}},
      {"au-transmitter conv", {"convert"}, {"talk.txt"}},
      {"au-transmitter ", {"convert", "talk.txt", "pictures"}, {"--loop"}},
      {"au-transmitter --tls-cert ", {"talk.txt", "pictures"}, {"convert"}},
      {"au-transmitter --tls-cert=t", {"talk.txt"}, {"pictures", "convert"}},
      {"au-transmitter convert ", {"talk.txt"}, {"convert"}},
      {"face-player exp", {"export"}, {"play"}},
      {"face-player p", {"play", "pose", "pictures"}, {"gallery", "talk.txt"}},
      {"face-player play --inter", {"--interpolation"}, {"--fps"}}};
  for (const auto& shell : shells) {
    for (const Case& one : cases) {
      SCOPED_TRACE(shell.back() + ": " + one.typed);
      const Words words = offered(shell, one.typed);
      for (const std::string& word : one.offered) EXPECT_TRUE(words.contains(word)) << word;
      for (const std::string& word : one.others) EXPECT_FALSE(words.contains(word)) << word;
    }
  }
}

}  // namespace
}  // namespace aucast::test
