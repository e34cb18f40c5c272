#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/result.h"
#include "protocol/stream_file.h"
#include "speaker/captions.h"
#include "speaker/speech.h"

namespace aucast::speaker {

/// Where the files of one run go. Empty: that one is not written.
struct OutputFiles {
  std::filesystem::path stream;
  std::filesystem::path captions;
  std::filesystem::path voice;
  std::filesystem::path labels;
};

/// The files `name` in `folder`. The narration, if there is one, is not written again where it lies
/// beside the stream already, under a name that au-transmitter serves.
[[nodiscard]] OutputFiles output_files(const std::filesystem::path& folder, const std::string& name,
                                       const std::filesystem::path& narration,
                                       const std::filesystem::path& labels);

/// Refuses before the work: a file that would be written over one of `inputs`, or twice (Usage); a
/// file that cannot be written (Failed), as far as its folder is not one that write_outputs()
/// makes.
[[nodiscard]] Result<void> check_outputs(const OutputFiles& files,
                                         const std::vector<std::filesystem::path>& inputs);

/// Writes all files or none, and makes the folder of the stream if need be.
[[nodiscard]] Result<void> write_outputs(const OutputFiles& files, const Speech& speech,
                                         const protocol::StreamFile& stream,
                                         const std::vector<TimedCaption>& captions);

/// A line for each sound that is no pause: where it begins and ends, in seconds, and its letters.
[[nodiscard]] std::string labels_of(const Speech& speech);

}  // namespace aucast::speaker
