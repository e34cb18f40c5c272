#include "client/app/video/face_view.h"

#include <optional>
#include <utility>
#include <vector>

#include "client/app/video/face_diagram.h"
#include "client/app/video/face_scene.h"
#include "client/app/video/shot.h"
#include "client/face/face_deformer.h"
#include "client/render/face_renderer.h"
#include "client/render/offscreen_target.h"
#include "common/check.h"

namespace aucast::app {

struct FaceView::State {
  State(const face::Face& face, std::unique_ptr<render::FaceRenderer> made)
      : diagram(face), renderer(std::move(made)), activations(face.channels.size()) {
    renderer->load(FaceScene(face).still());
  }

  std::optional<face::FaceDeformer::Making> making;
  face::DeformedFace neutral;                  ///< what is drawn meanwhile
  std::optional<face::FaceDeformer> deformer;  ///< nullopt while it is being made
  FaceDiagram diagram;
  std::unique_ptr<render::FaceRenderer> renderer;
  std::vector<float> activations;
  face::HairSway hair;
  const face::DeformedFace* deformed = nullptr;
  std::unique_ptr<render::OffscreenTarget> target;
  int width = 0;  ///< of pictures
  int height = 0;
  Sharpness sharpness = Sharpness::Video;
  int drawn_larger = 1;  ///< factor
};

FaceView::FaceView(std::unique_ptr<State> state) : state_(std::move(state)) {}
FaceView::~FaceView() = default;

Result<std::unique_ptr<FaceView>> FaceView::create(const face::Face& face) {
  return create(face, face::FaceDeformer(face));
}

Result<std::unique_ptr<FaceView>> FaceView::create(const face::Face& face,
                                                   face::FaceDeformer deformer) {
  auto view = create_bare(face);
  if (!view) return view.error();
  (*view)->state_->deformer = std::move(deformer);
  (*view)->show_pose();
  return view;
}

Result<std::unique_ptr<FaceView>> FaceView::create_neutral(const face::Face& face) {
  auto view = create_bare(face);
  if (!view) return view.error();
  (*view)->state_->making.emplace(face);
  (*view)->state_->neutral = face::neutral_face(face);
  (*view)->show_pose();
  return view;
}

Result<std::unique_ptr<FaceView>> FaceView::create_bare(const face::Face& face) {
  auto renderer = render::FaceRenderer::create();
  if (!renderer) return renderer.error();
  return std::unique_ptr<FaceView>(
      new FaceView(std::make_unique<State>(face, std::move(*renderer))));
}

bool FaceView::make_more() {
  State& s = *state_;
  if (!s.making) return true;
  s.deformer = s.making->step();
  if (!s.deformer) return false;
  s.making.reset();
  show_pose();
  return true;
}

Result<void> FaceView::renew_shaders() {
  return state_->renderer->renew_shaders();
}

void FaceView::pose(std::span<const float> activations, const face::HairSway& hair) {
  state_->hair = hair;
  state_->activations.assign(activations.begin(), activations.end());
  show_pose();
}

void FaceView::show_pose() {
  State& s = *state_;
  s.deformed = s.deformer ? &s.deformer->deform(s.activations, s.hair) : &s.neutral;
  s.renderer->pose(FaceScene::moving(*s.deformed));
}

void FaceView::draw(const view::Viewpoint& viewpoint, view::Style style, int width, int height) {
  State& s = *state_;
  s.diagram.update(style.layers, s.activations, *s.deformed);
  style.diagram = s.diagram.muscles();
  style.tags = s.diagram.tags();
  s.renderer->draw(viewpoint, style, width, height);
}

Result<void> FaceView::prepare(int width, int height, Sharpness sharpness) {
  State& s = *state_;
  if (s.target && s.width == width && s.height == height && s.sharpness == sharpness) return {};
  s.drawn_larger = sharpness == Sharpness::Still ? 2 : 1;
  auto target = render::OffscreenTarget::create(s.drawn_larger * width, s.drawn_larger * height);
  if (!target && sharpness == Sharpness::Still) {
    s.drawn_larger = 1;
    target = render::OffscreenTarget::create(width, height);
  }
  if (!target) return target.error();
  s.target = std::move(*target);
  s.width = width;
  s.height = height;
  s.sharpness = sharpness;
  return {};
}

view::Image FaceView::picture(const view::Viewpoint& viewpoint, view::Style style) {
  State& s = *state_;
  AUCAST_CHECK(s.target != nullptr);
  style.scale *= static_cast<float>(s.drawn_larger);
  const auto drawn = [&] {
    s.target->bind();
    draw(viewpoint, style, s.drawn_larger * s.width, s.drawn_larger * s.height);
    view::Image image = s.target->read();
    return s.drawn_larger == 2 ? view::halved(image) : image;
  };
  if (!style.background.transparent) return drawn();
  style.background = backdrop(0x000000);
  const view::Image on_black = drawn();
  style.background = backdrop(0xFFFFFF);
  return view::without_ground(on_black, drawn());
}

}  // namespace aucast::app
