#include <algorithm>

#include "client/app/film/face_diagram.h"
#include "client/app/film/face_scene.h"
#include "client/app/film/picture_maker.h"
#include "client/render/face_renderer.h"
#include "client/render/offscreen.h"

namespace aucast::app {
namespace {

/// Lines keep their share of a large picture and stay lines in a small one.
float scale_of(int height) {
  constexpr float kUsualHeight = 800;
  return std::clamp(static_cast<float>(height) / kUsualHeight, 0.5F, 4.0F);
}

}  // namespace

struct PictureMaker::State {
  State(const face::Face& face, const view::Camera& from, const view::Background& behind)
      : camera(from), background(behind), scene(face), deformer(face), diagram(face) {}

  view::Camera camera;
  view::Background background;
  FaceScene scene;
  face::FaceDeformer deformer;
  FaceDiagram diagram;
  view::Layers layers;
  // In the order of their making: what needs the context goes before it.
  std::unique_ptr<render::OffscreenContext> context;
  std::unique_ptr<render::OffscreenTarget> target;
  std::unique_ptr<render::FaceRenderer> renderer;
  int width = 0;
  int height = 0;
  int drawn_larger = 1;  ///< factor
};

PictureMaker::PictureMaker(std::unique_ptr<State> state) : state_(std::move(state)) {}
PictureMaker::~PictureMaker() = default;

Result<std::unique_ptr<PictureMaker>> PictureMaker::create(const face::Face& face, int width,
                                                           int height, const view::Camera& camera,
                                                           const view::Background& behind,
                                                           Sharpness sharpness) {
  auto state = std::make_unique<State>(face, camera, behind);
  auto context = render::OffscreenContext::create();
  if (!context) return context.error();
  state->context = std::move(*context);
  auto target = render::OffscreenTarget::create(width, height);
  if (!target) return target.error();
  if (sharpness == Sharpness::Still) {
    if (auto larger = render::OffscreenTarget::create(2 * width, 2 * height); larger) {
      target = std::move(larger);
      state->drawn_larger = 2;
    }
  }
  state->width = width;
  state->height = height;
  state->target = std::move(*target);
  auto renderer = render::FaceRenderer::create();
  if (!renderer) return renderer.error();
  state->renderer = std::move(*renderer);
  state->renderer->load(state->scene.still());
  return std::unique_ptr<PictureMaker>(new PictureMaker(std::move(state)));
}

void PictureMaker::show(const view::Layers& layers) {
  state_->layers = layers;
}

view::Image PictureMaker::picture(std::span<const float> activations) {
  State& s = *state_;
  const face::DeformedFace& deformed = s.deformer.deform(activations);
  s.target->bind();
  s.diagram.update(s.layers, activations, deformed);
  const view::Style style{.background = s.background,
                          .layers = s.layers,
                          .scale = scale_of(s.height) * static_cast<float>(s.drawn_larger),
                          .diagram = s.diagram.muscles(),
                          .tags = s.diagram.tags()};
  s.renderer->draw(FaceScene::moving(deformed), s.camera, style, s.width * s.drawn_larger,
                   s.height * s.drawn_larger);
  view::Image image = s.target->read();
  return s.drawn_larger == 2 ? view::halved(image) : image;
}

}  // namespace aucast::app
