#include "client/gui/storage/aus_file.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

#include "client/gui/storage/toml_edit.h"
#include "client/gui/texts/texts.h"
#include "common/action_unit.h"
#include "common/text.h"
#include "common/toml_document.h"
#include "common/toml_writer.h"

namespace aucast::gui {
namespace {

std::string drive_text(const Drive& drive) {
  if (drive.empty()) return "{}";
  std::string text = "{ ";
  for (const auto& [name, value] : drive) {
    if (text.size() > 2) text += ", ";
    text += toml_key(name) + " = " + toml_real(value);
  }
  return text + " }";
}

/// The position after the brace that closes the one at `open`, which must be on the same line.
std::optional<std::size_t> end_of_braces(std::string_view text, std::size_t open) {
  if (open >= text.size() || text[open] != '{') return std::nullopt;
  char quote = 0;
  int depth = 0;
  for (std::size_t i = open; i < text.size() && text[i] != '\n'; ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == '\\' && quote == '"') ++i;
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth == 0) {
      return i + 1;
    }
  }
  return std::nullopt;
}

/// The [[au]] table of a number; null when there is none.
const TomlValue* table_of(const TomlValue& document, int number) {
  const TomlValue* aus = document.find("au");
  if (aus == nullptr) return nullptr;
  for (const TomlValue& table : aus->items) {
    const TomlValue* value = table.find("number");
    const bool is_it = value != nullptr && value->kind == TomlValue::Kind::Integer;
    if (is_it && value->integer == number) return &table;
  }
  return nullptr;
}

std::string with_new_au(std::string_view text, int number, const Drive& drive,
                        const std::string& note) {
  std::string result(text);
  if (!result.empty() && result.back() != '\n') result += '\n';
  if (!result.empty()) result += '\n';
  const auto name = facs_name(number);
  return result + aus_text(number, drive, name ? std::string(*name) : note);
}

/// `text` with the note replaced for the AU whose drive ends at `drive_end`.
Result<std::string> with_note(std::string text, std::string_view file, const TomlValue& table,
                              std::size_t drive_end, const std::string& note) {
  const TomlValue* old = table.find("note");
  if (old == nullptr) {
    const std::size_t line_end = std::min(text.find('\n', drive_end), text.size());
    std::string line = toml_line("note", toml_text(note));
    line.pop_back();
    return text.insert(line_end, "\n" + line);
  }
  if (old->text == note) return text;
  if (auto put = put_text(text, file, *old, note); !put) return put.error();
  return text;
}

/// The drive in the order of the table; names that are new to the table come last.
Drive in_order_of(const TomlValue& table, Drive drive) {
  const auto place = [&table](const auto& one) {
    return std::find_if(table.entries.begin(), table.entries.end(),
                        [&one](const TomlValue::Entry& entry) { return entry.key == one.first; });
  };
  std::stable_sort(drive.begin(), drive.end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });
  return drive;
}

}  // namespace

Drive drive_of(const face::Face& face, const std::vector<float>& activations) {
  Drive drive;
  for (std::size_t i = 0; i < face.channels.size(); ++i) {
    const std::string& name = face.channels[i].name;
    const auto [side, base] = split_side(name);
    std::optional<std::size_t> partner;
    if (side != Side::Both) partner = face.channel_index(sided_name(opposite(side), base));
    const bool joined =
        partner && !face.channel_index(base) && activations[i] == activations[*partner];
    if (joined && *partner < i) continue;  // written with its partner
    if (activations[i] > 0) drive.emplace_back(joined ? base : name, activations[i]);
  }
  return drive;
}

std::string drive_in_words(const Drive& drive) {
  std::string text;
  for (const auto& [name, value] : drive) {
    const auto [side, base] = split_side(name);
    std::string plain(base);
    std::replace(plain.begin(), plain.end(), '_', ' ');
    plain = data_word(plain);
    if (side == Side::Left) plain = tr("editor.left_one", plain);
    if (side == Side::Right) plain = tr("editor.right_one", plain);
    std::array<char, 16> number{};
    std::snprintf(number.data(), number.size(), "%.3g", static_cast<double>(value));
    text += (text.empty() ? "" : ", ") + plain + ' ' + number.data();
  }
  return text;
}

std::string aus_text(int number, const Drive& drive, const std::string& note) {
  std::string text =
      "[[au]]\nnumber = " + std::to_string(number) + "\ndrive = " + drive_text(drive) + "\n";
  if (!note.empty()) text += toml_line("note", toml_text(note));
  return text;
}

Result<std::string> with_au(std::string_view text, std::string_view file, int number,
                            const Drive& drive, const std::string& note) {
  auto document = parse_toml(text, file);
  if (!document) return document.error();
  const TomlValue* table = table_of(*document, number);
  if (table == nullptr) return with_new_au(text, number, drive, note);
  const auto old = std::find_if(table->entries.begin(), table->entries.end(),
                                [](const TomlValue::Entry& entry) { return entry.key == "drive"; });
  if (old == table->entries.end()) {
    return Error{ErrorKind::BadData,
                 at_place(file, table->place.line, table->place.column,
                          "AU" + std::to_string(number) + " has no drive to be replaced")};
  }
  const auto begin = byte_at(text, old->value.place);
  const auto end = begin ? end_of_braces(text, *begin) : std::nullopt;
  if (!end) {
    return Error{ErrorKind::BadData,
                 at_place(file, old->place.line, old->place.column,
                          "the drive of AU" + std::to_string(number) +
                              " is not written as { ... } on one line; write it so, then save "
                              "again")};
  }
  std::string result(text.substr(0, *begin));
  result += drive_text(in_order_of(old->value, drive));
  const std::size_t drive_end = result.size();
  result += text.substr(*end);
  if (note.empty()) return result;
  // The places of what stands behind the drive on its line have moved.
  if (drive_end != *end) {
    auto again = parse_toml(result, file);
    if (!again) return again.error();
    return with_note(result, file, *table_of(*again, number), drive_end, note);
  }
  return with_note(result, file, *table, drive_end, note);
}

Result<std::string> without_au(std::string_view text, std::string_view file, int number) {
  auto document = parse_toml(text, file);
  if (!document) return document.error();
  const TomlValue* table = table_of(*document, number);
  if (table == nullptr) return std::string(text);
  const auto begin = byte_at(text, {table->place.line, 1});
  if (!begin || !text.substr(*begin).starts_with("[[au]]")) {
    return Error{ErrorKind::BadData, at_place(file, table->place.line, table->place.column,
                                              "AU" + std::to_string(number) +
                                                  " does not begin with a line [[au]]; remove it "
                                                  "with an editor")};
  }
  // Up to its last line that says something: comments below it belong to what follows.
  std::size_t end = *begin;
  for (std::size_t line = end; line < text.size();) {
    const std::size_t next = std::min(text.find('\n', line), text.size() - 1) + 1;
    const std::size_t first = text.find_first_not_of(" \t\r\n", line);
    const char mark = first < next ? text[first] : '#';
    if (mark == '[' && line != *begin) break;
    if (mark != '#') end = next;
    line = next;
  }
  std::string result(text.substr(0, *begin));
  if (result.ends_with("\n\n")) result.pop_back();
  return result += text.substr(end);
}

}  // namespace aucast::gui
