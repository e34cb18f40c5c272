#include "client/render/offscreen.h"

#include <dlfcn.h>
#include <epoxy/egl.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/render/gl_objects.h"

namespace aucast::render {
namespace {

constexpr GLint kSamples = 4;
constexpr const char* kRemedy = ": apt install libgl1 libegl1 libgl1-mesa-dri";

/// libepoxy ends the program when a library is not there, so it is asked for beforehand. It stays
/// loaded: libepoxy is about to use it.
std::optional<std::string> missing_library() {
  for (const char* name : {"libEGL.so.1", "libGL.so.1"}) {
    if (::dlopen(name, RTLD_LAZY | RTLD_LOCAL) == nullptr) return name;
  }
  return std::nullopt;
}

std::string egl_reason() {
  std::array<char, 16> code{};
  std::snprintf(code.data(), code.size(), "0x%04x", static_cast<unsigned>(eglGetError()));
  return std::string("EGL error ") + code.data();
}

bool client_extension(const char* name) {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  return extensions != nullptr && std::strstr(extensions, name) != nullptr;
}

/// One way to a display. No display and no reason: this EGL does not know that way.
struct Way {
  const char* name;
  EGLDisplay (*display)();
};

EGLDisplay surfaceless_display() {
  if (!client_extension("EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
  return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

EGLDisplay device_display() {
  if (!client_extension("EGL_EXT_platform_device")) return EGL_NO_DISPLAY;
  if (!client_extension("EGL_EXT_device_enumeration") && !client_extension("EGL_EXT_device_base")) {
    return EGL_NO_DISPLAY;
  }
  EGLDeviceEXT device = nullptr;
  EGLint count = 0;
  if (eglQueryDevicesEXT(1, &device, &count) != EGL_TRUE || count < 1) return EGL_NO_DISPLAY;
  return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
}

EGLDisplay default_display() {
  return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

constexpr std::array<Way, 3> kWays{{{"surfaceless", surfaceless_display},
                                    {"device", device_display},
                                    {"default display", default_display}}};

EGLContext make_context(EGLDisplay display, Api api) {
  const bool es = api == Api::OpenGlEs30;
  const std::array<EGLint, 5> config_wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE,
                                            es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display, config_wanted.data(), &config, 1, &count) != EGL_TRUE || count < 1) {
    return EGL_NO_CONTEXT;
  }
  const std::array<EGLint, 7> context_wanted{EGL_CONTEXT_MAJOR_VERSION,
                                             3,
                                             EGL_CONTEXT_MINOR_VERSION,
                                             es ? 0 : 3,
                                             es ? EGL_NONE : EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                             EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, context_wanted.data());
}

}  // namespace

struct OffscreenContext::State {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
    eglReleaseThread();
  }

  /// The reason when it did not work.
  [[nodiscard]] std::optional<std::string> open(const Way& way, Api api) {
    const EGLDisplay found = way.display();
    if (found == EGL_NO_DISPLAY) return "not there";
    if (eglInitialize(found, nullptr, nullptr) != EGL_TRUE) return egl_reason();
    display = found;
    if (eglBindAPI(api == Api::OpenGlEs30 ? EGL_OPENGL_ES_API : EGL_OPENGL_API) != EGL_TRUE)
      return "no OpenGL, " + egl_reason();
    context = make_context(display, api);
    if (context == EGL_NO_CONTEXT) return "no OpenGL 3.3 core, " + egl_reason();
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE) {
      return egl_reason();
    }
    return std::nullopt;
  }
};

OffscreenContext::OffscreenContext(std::unique_ptr<State> state) : state_(std::move(state)) {}
OffscreenContext::~OffscreenContext() = default;

Result<std::unique_ptr<OffscreenContext>> OffscreenContext::create(Api api) {
  if (const auto library = missing_library(); library.has_value()) {
    return Error{ErrorKind::Failed, *library + " cannot be loaded" + kRemedy};
  }
  std::string tried;
  for (const Way& way : kWays) {
    auto state = std::make_unique<State>();
    const auto reason = state->open(way, api);
    if (!reason.has_value()) {
      return std::unique_ptr<OffscreenContext>(new OffscreenContext(std::move(state)));
    }
    tried += (tried.empty() ? "" : "; ") + std::string(way.name) + ": " + *reason;
  }
  return Error{ErrorKind::Failed, "no OpenGL 3.3 without a display (" + tried + ")" + kRemedy};
}

struct OffscreenTarget::State {
  int width = 0;
  int height = 0;
  Renderbuffer colour;
  Renderbuffer depth;
  Renderbuffer resolved_colour;
  Framebuffer framebuffer;
  Framebuffer resolved;

  /// False when the driver does not take this size or number of samples.
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
