#include "client/app/video/picture_maker.h"

#include "client/app/video/shot.h"
#include "client/render/offscreen_context.h"

namespace aucast::app {

struct PictureMaker::State {
  view::Viewpoint viewpoint;
  view::Style style;
  // The view needs the context, so it is destroyed first.
  std::unique_ptr<render::OffscreenContext> context;
  std::unique_ptr<FaceView> view;
};

PictureMaker::PictureMaker(std::unique_ptr<State> state) : state_(std::move(state)) {}
PictureMaker::~PictureMaker() = default;

Result<std::unique_ptr<PictureMaker>> PictureMaker::create(const face::Face& face,
                                                           const OutputOptions& output,
                                                           view::ViewpointPreset viewpoint,
                                                           Sharpness sharpness) {
  auto context = render::OffscreenContext::create();
  if (!context) return context.error();
  auto view = FaceView::create(face);
  if (!view) return view.error();
  if (auto prepared = (*view)->prepare(output.width, output.height, sharpness); !prepared) {
    return prepared.error();
  }
  auto state = std::make_unique<State>();
  state->viewpoint = viewpoint_of(viewpoint, face);
  state->style.background = backdrop(output.background, output.transparent);
  state->style.scale = view::line_scale(output.height);
  state->style.layers = output.layers;
  state->context = std::move(*context);
  state->view = std::move(*view);
  return std::unique_ptr<PictureMaker>(new PictureMaker(std::move(state)));
}

view::Image PictureMaker::picture(std::span<const float> activations, const face::HairSway& hair) {
  state_->view->pose(activations, hair);
  return state_->view->picture(state_->viewpoint, state_->style);
}

}  // namespace aucast::app
