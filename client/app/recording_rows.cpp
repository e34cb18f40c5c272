#include "client/app/recording_rows.h"

#include "client/view/video_encoder.h"
#include "common/standard_output.h"

namespace aucast::app {
namespace {

using Kind = OptionValue::Kind;

}  // namespace

std::vector<OptionRow> sound_rows(SoundOptions& sound) {
  return {
      {.option = {"volume", "N", "100"},
       .text = "0 to 100 percent (100)",
       .more = "How loud the sound is, in the files that are written too: 0 to 100 percent of the "
               "loudness with which it comes, as it is heard. 50 percent is an eighth of the "
               "amplitude.",
       .value = whole(sound.volume, 0, 100),
       .heading = "Sound"},
      {.option = {"mute"},
       .text = "play silence in place of the sound",
       .more = "Plays silence; nothing else changes.",
       .value = flag(sound.mute)},
      {.option = {"sound", "FILE.wav"},
       .text = "write the sound to a file",
       .more = "Writes the sound to a WAV file, which has the length of the stream, and does not "
               "wait for the clock.",
       .value = word(sound.file)},
      {.option = {"no-sound"},
       .text = "no sound at all; videos are silent",
       .more = "Plays no sound, and asks the server for none. Videos of --record are silent.",
       .value = flag(sound.none)},
      {.option = {"sound-device", "NAME"},
       .text = "device to play on",
       .more = "The device to play on, or default. For an unknown name the available devices are "
               "listed. With --headless, sound is played only if this is given.",
       .value = word(sound.device)},
  };
}

OptionRow fps_row(OutputOptions& output) {
  return {
      .option = {"fps", "N"},
      .text = "frame rate of --record and --frames",
      .more =
          "Pictures a second, 1 to 240. In the window: samples a second of GLB files; and the keys "
          ", and . step by 1/N s (without --fps by a picture of the recording, or 1/25 s).",
      .value = whole(output.fps, 1, view::kVideoFpsMax)};
}

std::vector<OptionRow> recording_rows(OutputOptions& output) {
  return {
      {.option = {"frames", "DIR"},
       .text = "write PNGs: 50 per keyframe; with --fps N, N a second",
       .more = "Writes DIR/frame_000001.png and so on: 50 for each keyframe or, with --fps N, N a "
               "second.",
       .value = word(output.frames)},
      {.option = {"record", "FILE"},
       .text = "write a video: .mp4, .webm or .gif",
       .more = "Writes a video, .mp4, .webm or .gif: 30 pictures a second or, with --fps N, N. It "
               "has the sound, if there is any; a .gif has none.",
       .value = word(output.record)},
      {.option = {"sheet", "FILE.png"},
       .text = "write the keyframes to one page, at most 54",
       .more = "Writes the poses of the keyframes to one page; if there are more than 54, as many "
               "from beginning to end, or of a server's every second, fourth, ... Without --size "
               "each is 400x300.",
       .value = word(output.sheet)},
      fps_row(output),
      {.option = {"fast"},
       .text = "no window; as fast as the computer can",
       .more = "No window, and no waiting for the clock: plays as fast as the computer can. "
               "Implied by --frames, --record, --sheet and --sound.",
       .value = flag(output.fast)},
      {.option = {"stats", "FILE.json"},
       .text = "write statistics at exit; - for stdout",
       .more = "Writes statistics of buffers, delays and frames at exit, with - to stdout.",
       .value = parsed(Kind::Word, read_output_path, output.stats)},
      {.option = {"onsets", "FILE.csv"},
       .text = "write when the window showed each change",
       .more = "Writes a row for each picture in which the face had moved: when the picture was on "
               "the display (CLOCK_MONOTONIC, s), its keyframe and its AUs, for the clock of an "
               "experiment. The last column is called reached. In the first picture that shows a "
               "keyframe whole it has that keyframe's number ('3-5' if several have ended since "
               "the picture before); in the other pictures it is empty. Only with the window.",
       .value = word(output.onsets)},
  };
}

}  // namespace aucast::app
