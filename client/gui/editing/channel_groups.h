#pragma once

#include <vector>

#include "client/face/face.h"
#include "client/gui/model/gui_model.h"

namespace aucast::gui {

/// The channels of a face grouped by region, in the face's order. A left and a right channel share
/// a row. Regions without a channel are left out. Values come from `activations`, one per channel.
[[nodiscard]] std::vector<ChannelGroup> channel_groups(const face::Face& face,
                                                       const std::vector<float>& activations);

}  // namespace aucast::gui
