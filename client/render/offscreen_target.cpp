#include "client/render/offscreen_target.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "client/render/gl_objects.h"

namespace aucast::render {
namespace {

constexpr GLint kSamples = 4;

}  // namespace

struct OffscreenTarget::State {
  int width = 0;
  int height = 0;
  Renderbuffer colour;
  Renderbuffer depth;
  Renderbuffer resolved_colour;
  Framebuffer framebuffer;
  Framebuffer resolved;

  /// Returns false if the driver does not accept this size or number of samples.
  [[nodiscard]] bool allocate(GLint samples) {
    glBindRenderbuffer(GL_RENDERBUFFER, colour.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, depth.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, resolved_colour.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, resolved.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              resolved_colour.id());
    const bool resolved_whole = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.id());
    return resolved_whole && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE &&
           glGetError() == GL_NO_ERROR;
  }
};

OffscreenTarget::OffscreenTarget(std::unique_ptr<State> state) : state_(std::move(state)) {}
OffscreenTarget::~OffscreenTarget() = default;

Result<std::unique_ptr<OffscreenTarget>> OffscreenTarget::create(int width, int height) {
  GLint side_max = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &side_max);
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  if (width < 1 || height < 1 || width > side_max || height > side_max) {
    return Error{ErrorKind::Failed, "a picture of " + size +
                                        " is not possible here: each side 1 to " +
                                        std::to_string(side_max)};
  }
  GLint samples_max = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &samples_max);
  auto state = std::make_unique<State>();
  state->width = width;
  state->height = height;
  if (state->allocate(std::min(kSamples, samples_max)) || state->allocate(0)) {
    return std::unique_ptr<OffscreenTarget>(new OffscreenTarget(std::move(state)));
  }
  return Error{ErrorKind::Failed, "the graphics driver has no room for a picture of " + size};
}

void OffscreenTarget::bind() {
  glBindFramebuffer(GL_FRAMEBUFFER, state_->framebuffer.id());
  glViewport(0, 0, state_->width, state_->height);
}

view::Image OffscreenTarget::read() {
  const int width = state_->width;
  const int height = state_->height;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, state_->framebuffer.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, state_->resolved.id());
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, state_->resolved.id());
  view::Image image = view::make_image(width, height);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  glBindFramebuffer(GL_FRAMEBUFFER, state_->framebuffer.id());
  // OpenGL's first row is the lowest.
  const auto stride = static_cast<std::ptrdiff_t>(width) * 4;
  for (std::ptrdiff_t top = 0, low = height - 1; top < low; ++top, --low) {
    std::swap_ranges(image.rgba.begin() + top * stride, image.rgba.begin() + (top + 1) * stride,
                     image.rgba.begin() + low * stride);
  }
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

}  // namespace aucast::render
