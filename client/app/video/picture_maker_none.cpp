#include "client/app/video/picture_maker.h"

namespace aucast::app {

struct PictureMaker::State {};

PictureMaker::PictureMaker(std::unique_ptr<State> state) : state_(std::move(state)) {}
PictureMaker::~PictureMaker() = default;

Result<std::unique_ptr<PictureMaker>> PictureMaker::create(const face::Face&, const OutputOptions&,
                                                           view::ViewpointPreset, Sharpness) {
  return Error{ErrorKind::Failed,
               "this face-player was built without OpenGL (AUCAST_BUILD_RENDER=OFF): no pictures"};
}

view::Image PictureMaker::picture(std::span<const float>, const face::HairSway&) {
  return {};
}

}  // namespace aucast::app
