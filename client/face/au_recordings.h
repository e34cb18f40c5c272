#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "client/face/face.h"
#include "common/toml_reader.h"

namespace aucast::face {

/// Returns the channels that a name in a drive table means; empty if the face has none.
using ChannelFinder = std::function<std::vector<std::size_t>(std::string_view name)>;

/// Reads the [[au]] tables of an AU file (data/faces/FORMAT.md) for the channels of `face`. A name
/// that means fewer channels wins over one that means more: left_X over X. Errors are added to
/// `problems`; it is an error if `finder` finds no channel for a name, and the message suggests the
/// nearest of `names`. If the file is for many faces, pass `unknown`: then a name that is in
/// `names` needs no channel, and each AU that drives nothing in this face is added to `unknown`.
[[nodiscard]] std::map<int, AuRecording> read_recordings(TableReader& document, const Face& face,
                                                         const ChannelFinder& finder,
                                                         const std::vector<std::string>& names,
                                                         Problems& problems,
                                                         std::vector<int>* unknown = nullptr);

/// The channels that `name` means in a face of our own format: the one of that name, or left_name
/// and right_name.
[[nodiscard]] std::vector<std::size_t> channels_named(const Face& face, std::string_view name);

}  // namespace aucast::face
