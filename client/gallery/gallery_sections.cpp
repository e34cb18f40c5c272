#include "client/gallery/gallery_sections.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "client/face/au_blender.h"
#include "client/face/side_word.h"
#include "client/gallery/section_names.h"
#include "client/pipeline/expression_muscles.h"
#include "common/text.h"
#include "protocol/codec.h"

namespace aucast::gallery {
namespace {

constexpr std::array kEmotions{"surprise", "fear", "disgust", "anger", "happiness", "sadness"};
constexpr std::string_view kLetters = "ABCDE";

/// The thesis' appendix A: the AUs that its player knew.
constexpr std::array kAppendixA{1, 2, 4, 5, 6, 7, 9, 10, 12, 14, 15, 16, 17, 20, 23, 26};

std::string au_title(int number) {
  std::string title = "AU " + std::to_string(number);
  if (const auto name = facs_name(number)) title += " " + std::string(*name);
  return title;
}

/// For a caption, where lines may break between AUs: 1, 2, 5:25.
std::string spaced(const AuFrame& aus) {
  std::string text;
  for (const char c : protocol::format_au_set(aus)) {
    text += c;
    if (c == ',') text += ' ';
  }
  return text;
}

std::string au_stem(int number) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "au%02d", number);
  return text.data();
}

/// The sides on which an AU is shown. AUs such as a wink or a jaw that goes sideways are never on
/// both.
std::vector<Side> sides_of(const face::Face& face, int number) {
  if (!is_sided(face, number)) return {Side::Both};
  if (shows_on_one_side(number)) return {Side::Left, Side::Right};
  return {Side::Both, Side::Left, Side::Right};
}

}  // namespace

bool GalleryPlanner::wanted(std::string_view section) const {
  return input_.only.empty() || input_.only.contains(std::string(section));
}

const Expression* GalleryPlanner::expression(const std::string& name) const {
  const auto found = std::find_if(input_.expressions.begin(), input_.expressions.end(),
                                  [&](const Expression& one) { return one.name == name; });
  return found == input_.expressions.end() ? nullptr : &*found;
}

bool GalleryPlanner::can_show(const Expression& expression) const {
  std::vector<float> unused(input_.face.channels.size());
  return pipeline::apply_muscles(input_.face, expression, unused).has_value();
}

GalleryPlanner::Subject GalleryPlanner::subject(const Expression& expression) {
  return {{expression.name}, expression.aus, expression.muscles};
}

std::size_t GalleryPlanner::picture(const std::string& file, const Subject& subject,
                                    face::Mixer mixer, const face::RuleSet& rules) {
  const auto [place, fresh] = files_.try_emplace(file, plan_.pictures.size());
  if (!fresh) return place->second;
  GalleryPicture picture;
  picture.file = file;
  picture.sources = subject.sources;
  picture.aus = subject.aus;
  picture.shown = face::blend(rules, subject.aus);
  picture.muscles = subject.muscles;
  picture.mixer = mixer;
  picture.rules = rules.name;
  plan_.pictures.push_back(std::move(picture));
  return place->second;
}

std::size_t GalleryPlanner::picture(const std::string& file, const Subject& subject) {
  return picture(file, subject, input_.mixer, input_.rules.chosen);
}

std::size_t GalleryPlanner::au_picture(int number, char letter, Side side) {
  std::string file = "au/" + au_stem(number) + "_" + letter;
  if (is_sided(input_.face, number)) file += std::string("_") + face::side_word(side);
  const AuTerm term{static_cast<std::uint8_t>(number), side,
                    percent_of_letter(letter).value_or(std::uint8_t{100})};
  return picture(file + ".png", {{}, frame_from_terms({&term, 1}), {}});
}

GalleryFigure GalleryPlanner::expression_figure(const Expression& expression) {
  GalleryFigure figure;
  figure.title = expression.label;
  figure.text = expression.name;
  if (expression.muscles.empty()) {
    figure.text += ": " + spaced(expression.aus);
  }
  if (can_show(expression)) {
    figure.picture = picture("prototypes/" + expression.name + ".png", subject(expression));
  }
  return figure;
}

void GalleryPlanner::add_aus() {
  GallerySection section{std::string(kAusSection),
                         "Action Units",
                         "Every Action Unit that this face has, from a trace (A) to the maximum "
                         "(E). Left and right are the subject's own.",
                         {}};
  const std::size_t neutral = picture("au/neutral.png", {{}, AuFrame{}, {}});
  section.blocks.push_back({"Neutral", {}, {{"", {{neutral, "", "0", 0}}}}});
  std::vector<std::string> columns;
  for (const char letter : kLetters) {
    columns.push_back(std::string(1, letter) + ", " +
                      std::to_string(percent_of_letter(letter).value_or(0)) + " %");
  }
  for (const auto& [number, recording] : input_.face.recordings) {
    if (number == 0) continue;
    GalleryBlock block{au_title(number), columns, {}};
    for (const Side side : sides_of(input_.face, number)) {
      GalleryRow row;
      if (is_sided(input_.face, number)) row.heading = face::side_word(side);
      for (const char letter : kLetters) {
        row.figures.push_back({au_picture(number, letter, side), "", "", 0});
      }
      block.rows.push_back(std::move(row));
    }
    section.blocks.push_back(std::move(block));
  }
  plan_.sections.push_back(std::move(section));
}

void GalleryPlanner::add_prototypes() {
  GallerySection section{std::string(kPrototypesSection),
                         "Prototypes",
                         "What the literature says an emotion looks like; each name is what "
                         "face-player pose --expression takes.",
                         {}};
  for (const Expression& expression : input_.expressions) {
    const auto block =
        std::find_if(section.blocks.begin(), section.blocks.end(),
                     [&](const GalleryBlock& one) { return one.heading == expression.source; });
    GalleryFigure figure = expression_figure(expression);
    if (block != section.blocks.end()) {
      block->rows.front().figures.push_back(std::move(figure));
    } else {
      section.blocks.push_back({expression.source, {}, {{"", {std::move(figure)}}}});
    }
  }
  plan_.sections.push_back(std::move(section));
}

GalleryBlock GalleryPlanner::combination_block(const std::string& heading,
                                               const std::string& prefix) {
  GalleryBlock block{heading, {}, {{}}};
  for (std::size_t i = 0; i < kEmotions.size(); ++i) {
    for (std::size_t j = i + 1; j < kEmotions.size(); ++j) {
      const Expression* a = expression(prefix + kEmotions[i]);
      const Expression* b = expression(prefix + kEmotions[j]);
      if (a == nullptr || b == nullptr) continue;
      const Subject both{{a->name, b->name}, stronger(a->aus, b->aus), {}};
      const std::size_t index = picture("combinations/" + a->name + "_" + b->name + ".png", both);
      block.rows.front().figures.push_back(
          {index, a->label + " and " + b->label, spaced(both.aus), 0});
    }
  }
  return block;
}

void GalleryPlanner::add_combinations() {
  plan_.sections.push_back(
      {std::string(kCombinationsSection),
       "Combinations of two",
       "Two basic expressions at once (the thesis' figure 5.18): the Action Units of both.",
       {combination_block("FACS Investigator's Guide", ""),
        combination_block("The thesis' sets (table 3.2)", "thesis-")}});
}

void GalleryPlanner::add_appendix_a() {
  GalleryBlock block{"", {}, {{}}};
  for (const int number : kAppendixA) {
    GalleryFigure figure;
    figure.title = au_title(number);
    if (input_.face.recordings.contains(number)) {
      figure.picture = au_picture(number, 'E', Side::Both);
    } else {
      figure.text = "not recorded";
    }
    block.rows.front().figures.push_back(std::move(figure));
  }
  plan_.sections.push_back({std::string(kAppendixASection),
                            "Appendix A",
                            "The Action Units that the thesis' player implemented, at maximum.",
                            {std::move(block)}});
}

GalleryRow GalleryPlanner::benchmark_row(const std::string& emotion, face::Mixer mixer) {
  GalleryRow row;
  GalleryFigure benchmark;
  if (const Expression* waters = expression("waters-" + emotion)) {
    benchmark = expression_figure(*waters);
    benchmark.title.clear();
  }
  row.figures.push_back(std::move(benchmark));
  const Expression* thesis = expression("thesis-" + emotion);
  if (thesis == nullptr) return row;
  row.heading = thesis->label;
  for (const face::RuleSet* rules :
       {&input_.rules.kumar2010, &input_.rules.facs, &input_.rules.none}) {
    const std::string file =
        "appendix_b/" + emotion + "_" + std::string(face::name(mixer)) + "_" + rules->name + ".png";
    const std::size_t index = picture(file, subject(*thesis), mixer, *rules);
    row.figures.push_back({index, "", spaced(plan_.pictures[index].shown), 0});
  }
  return row;
}

void GalleryPlanner::add_appendix_b() {
  GallerySection section{
      std::string(kAppendixBSection),
      "Appendix B",
      "The thesis' six expressions (table 3.2) with both mixers, with and without co-occurrence "
      "rules, beside Waters' own six, muscle by muscle (values above what a muscle of this face "
      "can do are cut). Under each picture: the Action Units that the rules left.",
      {}};
  for (const face::Mixer mixer : {face::Mixer::Average, face::Mixer::Maximum}) {
    GalleryBlock block{"Mixer: " + std::string(face::name(mixer)),
                       {"Waters (benchmark)", "rules kumar2010", "rules facs", "no rules"},
                       {}};
    for (const char* emotion : kEmotions) block.rows.push_back(benchmark_row(emotion, mixer));
    section.blocks.push_back(std::move(block));
  }
  plan_.sections.push_back(std::move(section));
}

void GalleryPlanner::add_sections() {
  if (wanted(kAusSection)) add_aus();
  if (wanted(kPrototypesSection)) add_prototypes();
  if (wanted(kCombinationsSection)) add_combinations();
  if (wanted(kAppendixASection)) add_appendix_a();
  if (wanted(kAppendixBSection)) add_appendix_b();
}

void GalleryPlanner::add_sweep_frames(const std::string& name, const std::string& title,
                                      const Subject& subject, GalleryBlock& block) {
  const std::string folder = "sweeps/" + name;
  if (files_.contains(folder)) return;  // asked for twice
  files_.emplace(folder, 0);
  GallerySweep sweep{name, plan_.pictures.size(), 0};
  std::size_t apex = sweep.begin;
  constexpr int kStepMs = 1000 / kSweepFps;
  for (int time_ms = 0; time_ms <= kSweepEndMs; time_ms += kStepMs) {
    const SweepFrame frame{time_ms / kStepMs + 1, time_ms};
    std::array<char, 32> file{};
    std::snprintf(file.data(), file.size(), "/frame_%06d.png", frame.number);
    const std::size_t index = picture(folder + file.data(), subject);
    plan_.pictures[index].sweep_frame = frame;
    if (time_ms == kApexMs) apex = index;
    ++sweep.count;
  }
  plan_.sweeps.push_back(std::move(sweep));
  block.rows.front().figures.push_back(
      {apex, title, subject.muscles.empty() ? spaced(subject.aus) : name, plan_.sweeps.size()});
}

Result<void> GalleryPlanner::add_sweep(const std::string& word, GalleryBlock& block) {
  if (const Expression* named = expression(word)) {
    std::vector<float> unused(input_.face.channels.size());
    if (auto can = pipeline::apply_muscles(input_.face, *named, unused); !can) return can;
    add_sweep_frames(named->name, named->label, subject(*named), block);
    return {};
  }
  const auto aus = protocol::parse_au_set(word);
  if (!aus) {
    std::vector<std::string> names{"all"};
    for (const Expression& one : input_.expressions) names.push_back(one.name);
    return Error{ErrorKind::Usage, "the sweep '" + escaped(word) +
                                       "' is neither a set of AUs nor an expression" +
                                       did_you_mean(word, names)};
  }
  add_sweep_frames(file_stem(*aus), "", {{}, *aus, {}}, block);
  return {};
}

Result<void> GalleryPlanner::add_sweeps() {
  GalleryBlock block{"", {}, {{}}};
  for (const std::string& word : input_.sweeps) {
    if (word != "all") {
      if (auto added = add_sweep(word, block); !added) return added;
      continue;
    }
    for (const auto& [number, recording] : input_.face.recordings) {
      const AuTerm term{static_cast<std::uint8_t>(number), Side::Both, 100};
      const AuFrame aus = frame_from_terms({&term, 1});
      if (number != 0) add_sweep_frames(file_stem(aus), au_title(number), {{}, aus, {}}, block);
    }
    for (const Expression& one : input_.expressions) {
      if (can_show(one)) add_sweep_frames(one.name, one.label, subject(one), block);
    }
  }
  if (!plan_.sweeps.empty()) {
    plan_.sections.push_back({std::string(kSweepsSection),
                              "Sweeps",
                              "From the neutral face to the apex and back: onset 600 ms, apex 400 "
                              "ms, offset 600 ms, 25 pictures a second. Here the apex.",
                              {std::move(block)}});
  }
  return {};
}

GalleryPlan GalleryPlanner::take() {
  plan_.coverage = coverage_of(input_.face);
  return std::move(plan_);
}

}  // namespace aucast::gallery
