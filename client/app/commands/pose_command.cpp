#include "client/app/commands/pose_command.h"

#include <spdlog/spdlog.h>

#include <cstdio>

#include "client/app/assets.h"
#include "client/app/missing_aus.h"
#include "client/app/video/obj_writer.h"
#include "client/app/video/picture_maker.h"
#include "client/app/video/picture_notes.h"
#include "client/face/au_blender.h"
#include "client/face/face_deformer.h"
#include "client/face/side_word.h"
#include "client/gui/model/view_text.h"
#include "client/pipeline/expression_muscles.h"
#include "common/files.h"
#include "common/problems.h"
#include "common/text.h"
#include "protocol/codec.h"

namespace aucast::app {
namespace {

void print_list(const Assets& assets) {
  std::printf("Channels of %s (name, range):\n", printable(assets.face.name).c_str());
  for (const face::Channel& channel : assets.face.channels) {
    std::printf("  %-36s 0..%g\n", printable(channel.name).c_str(),
                static_cast<double>(channel.activation_max));
  }
  std::printf("Action Units:\n");
  for (const auto& [number, recording] : assets.face.recordings) {
    const auto facs = facs_name(number);
    std::printf("  %-4d %s\n", number, facs ? std::string(*facs).c_str() : "");
  }
  std::printf("Expressions:\n");
  for (const Expression& expression : assets.expressions) {
    std::printf("  %-20s %-24s %s\n", printable(expression.name).c_str(),
                protocol::format_au_set(expression.aus).c_str(),
                printable(expression.source).c_str());
  }
}

void print_activations(const Assets& assets, std::span<const float> activations) {
  bool any = false;
  for (std::size_t i = 0; i < activations.size(); ++i) {
    if (activations[i] == 0.0F) continue;
    any = true;
    std::printf("%-36s %g\n", printable(assets.face.channels[i].name).c_str(),
                static_cast<double>(activations[i]));
  }
  if (!any) std::printf("nothing is activated: the neutral face\n");
}

/// Checks --muscle NAME=VALUE: the name must be known and the value in the channel's range.
Result<void> set_channel(const face::Face& face, const std::string& name, float value,
                         std::span<float> activations) {
  const auto index = face.channel_index(name);
  if (!index) {
    std::vector<std::string> names;
    for (const face::Channel& channel : face.channels) names.push_back(channel.name);
    return Error{ErrorKind::Usage, "--muscle: " + printable(face.name) + " has no '" +
                                       escaped(name) + "'" + did_you_mean(name, names) +
                                       " (face-player pose --list names them)"};
  }
  const float largest = face.channels[*index].activation_max;
  if (value < 0 || value > largest) {
    return Error{ErrorKind::Usage, "--muscle " + name + ": " + plain(static_cast<double>(value)) +
                                       " is outside 0 to " + plain(static_cast<double>(largest)) +
                                       "; give a value between them"};
  }
  activations[*index] = value;
  return {};
}

/// The AUs of the command line: the set, the expression, or both (the set wins where both speak).
Result<AuFrame> requested_aus(const PoseOptions& pose, const Expression& expression) {
  AuFrame frame = expression.aus;
  if (!pose.aus.empty()) {
    auto aus = protocol::parse_au_set(pose.aus);
    if (!aus) return aus;
    for (std::size_t i = 0; i < frame.left.size(); ++i) {
      if (aus->left[i] > 0) frame.left[i] = aus->left[i];
      if (aus->right[i] > 0) frame.right[i] = aus->right[i];
    }
  }
  return frame;
}

/// `aus`: with the rules applied.
Result<void> write_outputs(const Assets& assets, const PlayerOptions& options, const AuFrame& aus,
                           std::span<const float> activations) {
  const PoseOptions& pose = options.pose;
  if (!pose.obj.empty()) {
    face::FaceDeformer deformer(assets.face);
    const std::string text = format_obj(assets.face.mesh, deformer.deform(activations).positions);
    if (auto written = write_file_atomically(pose.obj, text); !written) return written;
  }
  if (!pose.png.empty()) {
    auto maker =
        PictureMaker::create(assets.face, options.output, pose.viewpoint, Sharpness::Still);
    if (!maker) return maker.error();
    const auto texts = texts_of({assets.face, aus, assets.rules.name, options.face.mixer,
                                 options.output.layers, name(pose.viewpoint), activations});
    return view::write_png((*maker)->picture(activations), pose.png, texts);
  }
  if (pose.obj.empty()) print_activations(assets, activations);
  return {};
}

}  // namespace

Result<void> run_pose(const PlayerOptions& options) {
  auto assets = load_assets(options.face);
  if (!assets) return assets.error();
  if (options.pose.list) {
    print_list(**assets);
    return {};
  }
  Expression expression;
  if (!options.pose.expression.empty()) {
    auto found = find_expression(**assets, options.pose.expression);
    if (!found) return found.error();
    expression = std::move(*found);
  }
  auto aus = requested_aus(options.pose, expression);
  if (!aus) return aus.error();
  if (const std::string missing = missing_text((*assets)->face, *aus); !missing.empty()) {
    spdlog::warn("{}", missing);
  }
  std::vector<float> activations((*assets)->face.channels.size());
  const AuFrame blended = face::blend((*assets)->rules, *aus);
  face::mix((*assets)->face, blended, options.face.mixer, activations);
  auto applied = pipeline::apply_muscles((*assets)->face, expression, activations);
  if (!applied) return applied;
  for (const auto& [name, value] : options.pose.muscles) {
    if (auto set = set_channel((*assets)->face, name, value, activations); !set) return set;
  }
  return write_outputs(**assets, options, blended, activations);
}

Result<void> run_rules(const PlayerOptions& options) {
  auto aus = protocol::parse_au_set(options.pose.aus);
  if (!aus) return aus.error();
  std::filesystem::path data;
  if (options.face.rules != "none") {
    auto found = find_data_folder(options.face.data);
    if (!found) return found.error();
    data = std::move(*found);
  }
  auto rules = face::find_rules(options.face.rules, data);
  if (!rules) return rules.error();
  std::vector<face::RuleFired> fired;
  const AuFrame blended = face::blend(*rules, *aus, &fired);
  std::printf("%s\n", protocol::format_au_set(blended).c_str());
  if (!options.pose.explain) return {};
  if (fired.empty()) std::printf("no rule of '%s' changed anything\n", rules->name.c_str());
  for (const face::RuleExplained& one : face::explain(fired)) {
    std::printf("%s (%s): %s [%s]\n", std::string(face::name(one.rule->kind)).c_str(),
                face::side_word(one.side), gui::effect_in_words(one).c_str(),
                one.rule->source.c_str());
  }
  return {};
}

}  // namespace aucast::app
