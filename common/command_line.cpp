#include "common/command_line.h"

#include <algorithm>

#include "common/text.h"

namespace aucast {
namespace {

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

bool looks_like_option(const std::string& argument) {
  return argument.size() > 1 && argument[0] == '-';
}

std::string unexpected(const CLI::App& app, const std::vector<std::string>& extras) {
  const auto option = std::find_if(extras.begin(), extras.end(), looks_like_option);
  if (option == extras.end()) {
    return "unexpected argument '" + escaped(extras.empty() ? "" : extras.front()) + "'";
  }
  const std::string name = option->substr(0, option->find('='));
  return "unknown option " + escaped(name) + did_you_mean(name, option_names(app));
}

/// What CLI11 says, in one line.
std::string reason_of(const CLI::ParseError& error) {
  std::string text = error.what();
  if (text.ends_with(" missing")) return text.substr(0, text.find(':')) + " needs a value";
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

Result<void> parse_command_line(CLI::App& app, std::vector<std::string> arguments) {
  const std::string hint = " (try --help)";
  app.allow_extras();  // so that they are told apart here, with the nearest option
  try {
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    return Error{ErrorKind::Usage, reason_of(error) + hint};
  }
  const std::vector<std::string> extras = app.remaining();
  if (!extras.empty()) return Error{ErrorKind::Usage, unexpected(app, extras) + hint};
  return {};
}

}  // namespace aucast
