#pragma once

#include <vector>

#include "client/face/face.h"
#include "client/gui/gui_model.h"

namespace aucast::gui {

/// The channels of a face by region of the face, left and right ones on one line, in the order of
/// the face. Regions without a channel are left out. Values are those of `activations`, one per
/// channel.
[[nodiscard]] std::vector<ChannelGroup> channel_groups(const face::Face& face,
                                                       const std::vector<float>& activations);

}  // namespace aucast::gui
