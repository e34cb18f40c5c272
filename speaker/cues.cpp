#include "speaker/cues.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "common/au_numbers.h"
#include "common/number_of.h"
#include "common/text.h"
#include "common/text_file.h"
#include "protocol/codec.h"

namespace aucast::speaker {
namespace {

Error wrong(const std::string& text) {
  return {ErrorKind::BadData, text};
}

std::string bracketed(std::string_view cue) {
  return "[" + escaped(cue) + "]";
}

/// Whether a cue is meant as AUs: 6,12 or R14:50, perhaps in braces.
bool begins_with_au(std::string_view cue) {
  if (cue.starts_with('{')) cue.remove_prefix(1);
  if (cue.starts_with('L') || cue.starts_with('R')) cue.remove_prefix(1);
  return !cue.empty() && cue.front() >= '0' && cue.front() <= '9';
}

/// The expression of that name, in any case.
Expressions::const_iterator find(std::string_view name, const Expressions& expressions) {
  return std::find_if(expressions.begin(), expressions.end(), [name](const auto& expression) {
    return lowered(expression.first) == lowered(name);
  });
}

Error unknown(std::string_view name, const Expressions& expressions) {
  std::vector<std::string> known{"smile"};
  for (const auto& [other, terms] : expressions) {
    if (!terms.empty()) known.push_back(other);
  }
  const auto near = nearest(lowered(name), known);
  return wrong(bracketed(name) + " is no expression; " +
               (near ? "did you mean " + bracketed(*near) + "?"
                     : "[smile], AUs and the names of `face-player pose --list` are"));
}

/// The AUs of a cue without its percent.
Result<std::vector<AuTerm>> named(std::string_view name, const Expressions& expressions) {
  if (const auto found = find(name, expressions); found != expressions.end()) {
    if (!found->second.empty()) return found->second;
    return wrong(bracketed(name) +
                 " is made of muscles alone, which no stream carries; take an expression of AUs");
  }
  if (lowered(name) == "smile") {
    return std::vector<AuTerm>{{kCheekRaiser, Side::Both, 50}, {kLipCornerPuller, Side::Both, 70}};
  }
  if (!begins_with_au(name)) return unknown(name, expressions);
  const auto aus = protocol::parse_au_set(name);
  if (!aus) return wrong(aus.error().message);
  return canonical_terms(*aus);
}

}  // namespace

Expressions sets_of(const std::vector<Expression>& expressions) {
  Expressions sets;
  for (const Expression& expression : expressions) {
    const bool of_muscles = expression.aus == AuFrame{} && !expression.muscles.empty();
    sets[expression.name] = of_muscles ? std::vector<AuTerm>() : canonical_terms(expression.aus);
  }
  return sets;
}

Result<std::vector<AuTerm>> terms_of(std::string_view cue, const Expressions& expressions) {
  // AUs may have blanks between them, which a percent after them needs.
  if (begins_with_au(cue)) {
    if (auto whole = named(cue, expressions)) return whole;
  }
  const std::size_t blank = cue.rfind(' ');
  const bool one_word = blank == std::string_view::npos;
  const auto percent = one_word ? std::nullopt : number_of<double>(cue.substr(blank + 1));
  // A name may end in a number, too.
  if (!percent || find(cue, expressions) != expressions.end()) return named(cue, expressions);
  auto terms = named(trimmed(cue.substr(0, blank), " \t"), expressions);
  if (!terms) return terms;
  if (*percent < 0 || *percent > 100 || *percent != std::floor(*percent)) {
    return wrong(bracketed(cue) + " has a percent that is no whole number from 0 to 100");
  }
  for (AuTerm& term : *terms) {
    term.percent = static_cast<std::uint8_t>(term.percent * static_cast<int>(*percent) / 100);
  }
  return terms;
}

Result<void> check_cues(const Script& script, const Expressions& expressions,
                        std::string_view file) {
  for (const Cue& cue : script.cues) {
    const auto terms = terms_of(cue.name, expressions);
    if (terms) continue;
    const Error& error = terms.error();
    return Error{error.kind, at_place(file, cue.line, cue.column, error.message)};
  }
  return {};
}

}  // namespace aucast::speaker
