#include "client/app/command_pages.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "client/app/option_rows.h"
#include "client/app/receiving_rows.h"
#include "client/gallery/section_names.h"
#include "client/view/style.h"

namespace aucast::app {
namespace {

/// A paragraph with its lines broken at blanks, so that none has more than 80 columns.
std::string paragraph(std::string_view words) {
  constexpr std::size_t kColumns = 80;
  std::string text;
  for (; words.size() > kColumns; words.remove_prefix(words.rfind(' ', kColumns) + 1)) {
    text += std::string(words.substr(0, words.rfind(' ', kColumns))) + "\n";
  }
  return text + std::string(words) + "\n";
}

std::string layers() {
  return "Layers: " + view::layer_names() + ".";
}

std::string sections() {
  std::string list;
  for (std::size_t i = 0; i < gallery::kSectionNames.size(); ++i) {
    list += (i == 0 ? "" : ", ") + std::string(gallery::kSectionNames[i]);
    const std::string_view note = gallery::kSectionNotes[i];
    if (!note.empty()) list += " (" + std::string(note) + ")";
  }
  return "Sections: " + list + ".";
}

/// What stands after the options. A page refers to it.
std::string_view notes_of(Command command) {
  static const std::string of_pose = paragraph(layers());
  static const std::string of_gallery = of_pose + paragraph(sections());
  static const std::string of_watch =
      paragraph(layers() + " In the window: ? lists keys and mouse, f is full screen, q leaves.") +
      "Exit codes: 0 done, 1 failed, 2 usage, 3 bad data, 4 unreadable, 5 network.\n";
  switch (command) {
    case Command::Watch:
    case Command::Help:
    case Command::Play:
      return of_watch;
    case Command::Pose:
      return of_pose;
    case Command::Gallery:
      return of_gallery;
    case Command::Rules:
    case Command::Export:
      break;
  }
  return {};
}

void describe_rules(CommandPage& page) {
  page.command = "rules";
  page.usage = {"face-player rules AUS [OPTIONS]"};
  page.about =
      "Prints what the co-occurrence rules make of a set of AUs.\n"
      "In parentheses: defaults.\n";
  page.examples = {"face-player rules 51,52:40",
                   "face-player rules 1,2,5,15,16,20,26 --rules kumar2010 --explain"};
}

void describe_export(CommandPage& page) {
  page.command = "export";
  page.usage = {"face-player export STREAM FILE.glb [OPTIONS]   face and animation",
                "face-player export FILE.glb [OPTIONS]          the face alone"};
  page.about =
      "Writes the face as glTF 2.0 for other programs, with morph targets, and prints\n"
      "by how much it differs from the face that face-player draws. The same stream and\n"
      "options give the same bytes. For the sound, run face-player play STREAM --sound\n"
      "FILE.wav. Sound and animation begin together. In parentheses: defaults.\n";
  page.examples = {"face-player export talk.txt talk.glb",
                   "face-player export talk.txt talk.glb --fps 60 --idle 1",
                   "face-player export --face marek --basis aus marek.glb"};
}

}  // namespace

CommandPage command_page(Command command) {
  PlayerOptions described;
  CommandPage page{.program = "face-player",
                   .rows = unbound(option_rows(command, described)),
                   .notes = notes_of(command)};
  switch (command) {
    case Command::Watch:
    case Command::Help:
      page.usage = {"face-player [OPTIONS] HOST[:PORT]              in a window (port 4650)",
                    "face-player --headless [OPTIONS] HOST[:PORT]   without a display",
                    "face-player --list HOST[:PORT]                 its streams",
                    "face-player --mirror [camera:DEVICE|FILM]      your own face, in a window",
                    "face-player play FILE                          stream file or AU table",
                    "face-player pose|rules|gallery|export --help   pictures, rules, GLB"};
      page.about = "Receives a face as FACS Action Units and draws it. In parentheses: defaults.\n";
      page.examples = {"face-player --headless 10.0.0.7:4650 --record talk.mp4 --stats talk.json"};
      break;
    case Command::Play: {
      page.command = "play";
      page.usage = {"face-player play FILE [OPTIONS]",
                    "face-player play FILE --headless [OPTIONS]"};
      page.about =
          "Plays a stream file, or the table of a recogniser, without a server.\n"
          "In parentheses: defaults.\n";
      // Receiving options are accepted so that both commands take the same.
      const std::vector<OptionRow> receiving = receiving_rows(described.playback);
      for (OptionRow& row : page.rows) {
        if (find_row(receiving, row.option.name) == nullptr) continue;
        if (row.more.empty()) row.more = row.text;
        row.text = {};
        if (row.heading == "Receiving") row.heading = "Receiving, once the window has a server";
      }
      page.examples = {"face-player play talk.txt --headless --record talk.mp4",
                       "face-player play six_expressions.txt --speed 500"};
      break;
    }
    case Command::Pose:
      page.command = "pose";
      page.usage = {"face-player pose [AUS] [OPTIONS]"};
      page.about =
          "Writes one still of a face. Without --png and --obj, prints how active each of\n"
          "its channels (muscles, lids, jaw ...) is. In parentheses: defaults.\n";
      page.examples = {"face-player pose 6,12 --png smile.png",
                       "face-player pose --expression sadness --camera three-quarter --png sad.png",
                       "face-player pose 12 --show wireframe,muscles --png muscles.png",
                       "face-player pose --muscle left_zygomaticus_major=1 --obj pull.obj"};
      break;
    case Command::Rules:
      describe_rules(page);
      break;
    case Command::Gallery:
      page.command = "gallery";
      page.usage = {"face-player gallery DIR [OPTIONS]"};
      page.about =
          "Writes pictures of every AU and expression, with a page (DIR/index.html) and a\n"
          "list (DIR/manifest.csv), which are written last. The same face and options give\n"
          "the same bytes. Ctrl-C ends it with code 1 and leaves no incomplete picture.\n"
          "In parentheses: defaults.\n";
      page.examples = {"face-player gallery pictures",
                       "face-player gallery stimuli --only aus --size 800x1000 --background 808080",
                       "face-player gallery sweeps --only sweeps --sweep 12 --sweep happiness"};
      break;
    case Command::Export:
      describe_export(page);
      break;
  }
  return page;
}

std::vector<CommandPage> command_pages() {
  std::vector<CommandPage> pages;
  for (const Command command : {Command::Watch, Command::Play, Command::Pose, Command::Rules,
                                Command::Gallery, Command::Export}) {
    pages.push_back(command_page(command));
  }
  return pages;
}

}  // namespace aucast::app
