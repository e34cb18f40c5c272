#include "client/render/offscreen_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace aucast::render {
namespace {

constexpr const char* kRemedy = ": apt install libgl1 libegl1 libgl1-mesa-dri";

/// Whether a library can be loaded. libepoxy would end the program if not. It stays loaded, as
/// libepoxy is about to use it.
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

/// What one way to a display led to. Neither display nor reason: this EGL does not know that way.
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

  /// Returns the reason if it does not work; nullopt: it does.
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

}  // namespace aucast::render
