#include "common/options.h"

#include <algorithm>
#include <iterator>

#include "common/command_line.h"

namespace aucast {
namespace {

constexpr std::size_t kAnyNumber = 100'000;

/// The words of a flag, one for each time it was typed; the last one counts.
Result<std::vector<std::string>> words_of_flag(const OptionRow& row, const CLI::Option& option) {
  try {
    return std::vector<std::string>(option.count(), option.as<bool>() ? "true" : "false");
  } catch (const CLI::Error&) {
    return wrong_word(typed_name(row), option.results().back(), "is neither true nor false");
  }
}

/// As CLI11 wants it: "-v,--verbose".
std::string cli_name(const OptionRow& row) {
  return row.letter == 0 ? typed_name(row)
                         : "-" + std::string(1, row.letter) + "," + typed_name(row);
}

}  // namespace

std::string typed_name(const OptionRow& row) {
  return row.where == OptionRow::Where::Positional ? std::string(row.option.argument)
                                                   : "--" + std::string(row.option.name);
}

const OptionRow* find_row(const std::vector<OptionRow>& rows, std::string_view name) {
  const auto row = std::find_if(rows.begin(), rows.end(), [name](const OptionRow& other) {
    return other.option.name == name;
  });
  return row == rows.end() ? nullptr : &*row;
}

std::vector<OptionRow> unbound(std::vector<OptionRow> rows) {
  for (OptionRow& row : rows) row.value.read = nullptr;
  return rows;
}

void append(std::vector<OptionRow>& rows, std::vector<OptionRow> more) {
  std::move(more.begin(), more.end(), std::back_inserter(rows));
}

Result<TypedWords> sort_arguments(const std::vector<OptionRow>& rows,
                                  std::vector<std::string> arguments) {
  using Kind = OptionValue::Kind;
  CLI::App app;
  app.set_help_flag();  // ours is one of the rows
  std::map<std::string_view, CLI::Option*> options;
  std::map<std::string_view, std::vector<std::string>> words;
  for (const OptionRow& row : rows) {
    if (row.value.kind == Kind::Flag) {
      options[row.option.name] = app.add_flag(cli_name(row));
      continue;
    }
    CLI::Option* option = options[row.option.name] =
        app.add_option(cli_name(row), words[row.option.name]);
    if (row.where == OptionRow::Where::Positional && row.value.kind == Kind::Words) {
      option->expected(1, kAnyNumber);
      continue;
    }
    // Without extra arguments, or it would take the positional word behind it.
    option->expected(1)->allow_extra_args(false)->take_all();
  }
  if (auto parsed = parse_command_line(app, std::move(arguments)); !parsed) return parsed.error();
  TypedWords typed;
  for (const OptionRow& row : rows) {
    const CLI::Option& option = *options.at(row.option.name);
    if (option.count() == 0) continue;
    auto list = row.value.kind == Kind::Flag ? words_of_flag(row, option)
                                             : Result(std::move(words.at(row.option.name)));
    if (!list) return list.error();
    if (list->size() > 1 && row.value.kind != Kind::Flag && row.value.kind != Kind::Words) {
      return usage_error(typed_name(row) + " is given " + std::to_string(list->size()) +
                         " times; give it once");
    }
    typed.emplace(row.option.name, std::move(*list));
  }
  return typed;
}

Complaint read_word(const OptionRow& row, const std::string& word) {
  if (word.empty()) return "is empty";
  return row.value.read ? row.value.read(word) : std::nullopt;
}

Error usage_error(const std::string& message) {
  return {ErrorKind::Usage, message + " (try --help)"};
}

Error wrong_word(const std::string& name, const std::string& word, const std::string& complaint) {
  const std::string said = word.empty() ? "" : " '" + escaped(word) + "'";
  return usage_error(name + said + " " + complaint);
}

Result<void> read_words(const std::vector<OptionRow>& rows, const TypedWords& words) {
  for (const OptionRow& row : rows) {
    const auto found = words.find(row.option.name);
    if (found == words.end()) continue;
    for (const std::string& word : found->second) {
      if (const Complaint wrong = read_word(row, word)) {
        return wrong_word(typed_name(row), word, *wrong);
      }
    }
  }
  return {};
}

OptionValue flag(bool& out, bool given) {
  return {OptionValue::Kind::Flag, [&out, given](const std::string& word) -> Complaint {
            if (word != "true" && word != "false") return "is neither true nor false";
            out = (word == "true") == given;
            return std::nullopt;
          }};
}

OptionValue flag() {
  return {OptionValue::Kind::Flag, {}};
}

std::vector<OptionRow> help_rows() {
  constexpr auto kTyped = OptionRow::Where::Typed;
  return {{.option = {"help"},
           .text = "this page",
           .more = "Prints the options, one a line.",
           .value = flag(),
           .where = kTyped,
           .letter = 'h'},
          {.option = {"version"},
           .text = "print version, protocol and licence",
           .more = "Prints version, protocol and licence.",
           .value = flag(),
           .where = kTyped}};
}

OptionValue one_of(std::string& out, const std::vector<std::string_view>& names) {
  std::vector<std::pair<std::string_view, std::string>> choices;
  for (const std::string_view name : names) choices.emplace_back(name, name);
  return one_of(out, std::move(choices));
}

OptionValue log_level(std::string& out) {
  return one_of(out, {"trace", "debug", "info", "warning", "error", "off"});
}

Result<void> apply_verbosity(TypedWords& typed, const std::vector<std::string>& verbose) {
  const auto times = [&typed](std::string_view name) -> std::size_t {
    const auto flag = typed.find(name);
    return flag == typed.end() || flag->second.back() == "false" ? 0 : flag->second.size();
  };
  const std::size_t louder = times("verbose");
  const bool quiet = times("quiet") > 0;
  if (louder > 0 && quiet) return usage_error("-v and -q exclude each other");
  if (louder > 0) {
    typed.try_emplace("log-level", 1, verbose[std::min(louder, verbose.size()) - 1]);
  }
  if (quiet) typed.try_emplace("log-level", 1, "error");
  return {};
}

}  // namespace aucast
