#include "client/app/option_rows.h"

#include <cmath>
#include <optional>
#include <utility>

#include "client/app/face_rows.h"
#include "client/app/picture_rows.h"
#include "client/app/program_rows.h"
#include "client/app/receiving_rows.h"
#include "client/app/recording_rows.h"
#include "client/gallery/section_names.h"
#include "common/number_of.h"
#include "common/text.h"

namespace aucast::app {
namespace {

using Kind = OptionValue::Kind;
using Where = OptionRow::Where;

Complaint read_muscle(const std::string& word,
                      std::vector<std::pair<std::string, float>>& muscles) {
  const std::size_t equals = word.find('=');
  const auto value = equals == std::string::npos
                         ? std::nullopt
                         : number_of<float>(std::string_view(word).substr(equals + 1));
  if (!value || !std::isfinite(*value)) return "is not NAME=VALUE, such as jaw=1.5";
  muscles.emplace_back(word.substr(0, equals), *value);
  return std::nullopt;
}

Complaint read_sections(const std::string& word, std::vector<std::string>& sections) {
  for (const std::string_view part : split(word, ',')) {
    std::string section;
    if (const auto wrong =
            one_of(section, {gallery::kSectionNames.begin(), gallery::kSectionNames.end()})
                .read(std::string(part))) {
      return wrong;
    }
    sections.push_back(std::move(section));
  }
  return std::nullopt;
}

std::string section_names() {
  std::string names;
  for (const std::string_view name : gallery::kSectionNames) {
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return names;
}

OptionRow aus_row(PoseOptions& pose) {
  return {.option = {"aus", "AUS"},
          .text = "such as 1,6,12 or 12:80,R14:50 or 4C+9D",
          .more =
              "A set of AUs as in a packet, such as 1,6,12 or 12:80,R14:50, in FACS notation, such "
              "as 4C+9D, or by FACS names: 'Cheek Raiser:50'. L and R are the subject's own sides.",
          .value = word(pose.aus),
          .where = Where::Positional};
}

std::vector<OptionRow> pose_rows(PoseOptions& pose) {
  return {
      aus_row(pose),
      {.option = {"expression", "NAME"},
       .text = "a named expression, such as happiness",
       .more = "A named expression instead of AUS, such as happiness, thesis-anger or waters-fear; "
               "--list names them all.",
       .value = word(pose.expression)},
      {.option = {"muscle", "NAME=VALUE"},
       .text = "set a muscle or another channel; may be repeated",
       .more = "Sets a muscle or another channel after the mixer. May be repeated.",
       .value = parsed(Kind::Words, read_muscle, pose.muscles)},
      {.option = {"list"}, .text = "list channels, AUs and expressions", .value = flag(pose.list)},
      {.option = {"png", "FILE"}, .text = "write the picture", .value = word(pose.png)},
      {.option = {"obj", "FILE"},
       .text = "write the skin's mesh, without picture smoothing",
       .more = "Writes the deformed skin as Wavefront OBJ, with the vertices in the order of the "
               "face's mesh. Pictures round off this mesh for a smooth outline, with a further "
               "vertex at each edge that bends.",
       .value = word(pose.obj)},
      viewpoint_row(pose),
  };
}

std::vector<OptionRow> gallery_rows(PlayerOptions& options) {
  static const std::string kOnly = "Only these sections: " + section_names() + ". May be repeated.";
  GalleryOptions& gallery = options.gallery;
  return {
      {.option = {"dir", "DIR"},
       .text = "folder to write to; other files in it are kept",
       .value = word(gallery.folder),
       .where = Where::Positional},
      {.option = {"only", "SECTION[,...]"},
       .text = "only these sections, and what --sweep asks for",
       .more = kOnly,
       .value = parsed(Kind::Words, read_sections, gallery.only)},
      {.option = {"sweep", "AUS|NAME|all"},
       .text = "frames and a video, from neutral to full and back",
       .more =
           "From neutral to the apex and back, as frames, and as a video if ffmpeg is installed: "
           "of a set of AUs, of an expression, or of all AUs and all expressions. May be repeated.",
       .value = words(gallery.sweeps)},
      viewpoint_row(options.pose),
  };
}

std::vector<OptionRow> export_rows(PlayerOptions& options) {
  OptionRow fps = fps_row(options.output);
  fps.option.fallback = "30";
  fps.text = "animation samples a second, 1 to 240 (30)";
  fps.more = "Animation samples a second, 1 to 240.";
  std::vector<OptionRow> rows{
      {.option = {"files", "[STREAM] FILE.glb"},
       .more = "FILE.glb is the file to write. STREAM, a stream file or the table of a recogniser, "
               "becomes its animation; without STREAM the face has no animation.",
       .value = words(options.exported.files),
       .where = Where::Positional},
      {.option = {"basis", "BASIS", "muscles"},
       .text = "morph targets: muscles or aus (muscles)",
       .more = "muscles has a morph target for each muscle and lid, and is true to the face; aus "
               "has one for each Action Unit and side, to be driven by hand.",
       .value = one_of<glb::Basis>(options.exported.basis,
                                   {{"muscles", glb::Basis::Muscles}, {"aus", glb::Basis::Aus}}),
       .heading = "File"},
      std::move(fps)};
  return rows;
}

}  // namespace

std::vector<OptionRow> option_rows(Command command, PlayerOptions& options) {
  std::vector<OptionRow> rows;
  if (command == Command::Watch) {
    rows = {
        {.option = {"host", "HOST"},
         .more = "The server: HOST or HOST:PORT; the port is 4650 by default. Or a stream's "
                 "address: aucast://HOST[:PORT][,HOST...][/STREAM], aucasts:// over TLS. Of "
                 "several hosts, the next one is tried when one is lost (as with --reconnect), is "
                 "full or does not have the stream yet. face-player gives up when all hosts have "
                 "refused it. Without a window it also gives up when no host could be reached at "
                 "first, unless --reconnect is given.",
         .value = word(options.playback.endpoint),
         .where = Where::Positional},
        {.option = {"list"},
         .more = "Prints the server's streams, one a line. On a terminal each has \"live\" or its "
                 "length, and its title, as far as the server tells them; a pipe or a file gets "
                 "the names alone.",
         .value = flag(options.list)},
        {.option = {"mirror"},
         .more = "Opens the window at its Camera tab: your own face as others will see it, beside "
                 "what the camera sees, and the button \"Go live\". HOST is a camera then: camera "
                 "(the default), camera:DEVICE, or a film to try it with. face-player starts "
                 "au-transmitter for this; scripts/install_models.sh must have fetched the models "
                 "that read faces. While you are live, guests can watch. With --token-file they "
                 "must show its token, and with --tls-cert and --tls-key they must come over TLS.",
         .value = flag(options.shows_mirror)}};
  } else if (command == Command::Play) {
    rows = {{.option = {"file", "FILE"},
             .text = "a stream file or a recogniser's table",
             .value = word(options.playback.file),
             .where = Where::Positional}};
  } else if (command == Command::Pose) {
    rows = pose_rows(options.pose);
  } else if (command == Command::Gallery) {
    rows = gallery_rows(options);
  } else if (command == Command::Export) {
    rows = export_rows(options);
  } else {
    rows = {aus_row(options.pose),
            {.option = {"explain"},
             .text = "a line for each rule that applied, and its reference",
             .value = flag(options.pose.explain)}};
  }
  const bool plays = command == Command::Watch || command == Command::Play;
  const bool draws = plays || command == Command::Pose || command == Command::Gallery;
  const bool moves = plays || command == Command::Export;
  if (command == Command::Play || command == Command::Export) {
    append(rows, table_rows(options.table));
  }
  if (plays) append(rows, receiving_rows(options.playback));
  if (moves) append(rows, animation_rows(options.playback));
  if (plays) append(rows, sound_rows(options.sound));
  if (command != Command::Rules) append(rows, face_rows(options.face));
  append(rows, rules_rows(options.face));
  if (draws) append(rows, picture_rows(options.output));
  if (plays) append(rows, recording_rows(options.output));
  if (plays) append(rows, window_rows(options));
  append(rows, program_rows(options));
  append(rows, help_rows());
  return rows;
}

}  // namespace aucast::app
