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

/// The channels that a name of a drive table means; none when the face has no such channel.
using ChannelFinder = std::function<std::vector<std::size_t>(std::string_view name)>;

/// Reads the [[au]] tables of an AU file (data/faces/FORMAT.md) for the channels of `face`. A name
/// that means fewer channels wins over one that means more: left_X beside X. What is wrong goes to
/// the problems, also a name for which `finder` finds no channel, with the nearest of `names`. When
/// the file is for many faces (`unknown` is given), names without a channel need only be in
/// `names`, and each AU that has nothing to drive here is added to `unknown`.
[[nodiscard]] std::map<int, AuRecording> read_recordings(TableReader& document, const Face& face,
                                                         const ChannelFinder& finder,
                                                         const std::vector<std::string>& names,
                                                         Problems& problems,
                                                         std::vector<int>* unknown = nullptr);

/// The channels of our own faces that `name` means: itself, or left_name and right_name.
[[nodiscard]] std::vector<std::size_t> channels_named(const Face& face, std::string_view name);

}  // namespace aucast::face
