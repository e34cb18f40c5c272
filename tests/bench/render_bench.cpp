// Frames per second of the default face, the sizes of the thesis' table 5.3: deforming and drawing
// each frame anew, beside a frame that is only cleared and read back; the last column is the ratio
// of their processor times.
//   bench_render [SECONDS per line, default 2]

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>

#include "client/render/face_renderer.h"
#include "client/render/offscreen_context.h"
#include "client/render/offscreen_target.h"
#include "common/files.h"
#include "tests/golden/render_scene.h"

namespace {

using namespace aucast;
using Clock = std::chrono::steady_clock;

struct Rate {
  double mean_fps = 0;
  double best_fps = 0;
  double cpu_ms = 0;  ///< of all threads, a frame: hardly depends on what else the machine does
};

Rate measure(double seconds, const std::function<void(int)>& frame) {
  frame(0);
  double best_s = 1e9;
  int frames = 0;
  const std::clock_t cpu_begin = std::clock();
  const auto begin = Clock::now();
  auto last = begin;
  while (last - begin < std::chrono::duration<double>(seconds) || frames < 3) {
    frame(++frames);
    const auto now = Clock::now();
    best_s = std::min(best_s, std::chrono::duration<double>(now - last).count());
    last = now;
  }
  const double cpu_s = static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC;
  return {frames / std::chrono::duration<double>(last - begin).count(), 1 / best_s,
          1000 * cpu_s / frames};
}

/// Mouth, brows and head all move, as they would in speech.
AuFrame moving(int frame) {
  AuFrame aus;
  const auto wave = [frame](int period) {
    const int place = frame % period;
    return static_cast<float>(std::min(place, period - place)) / static_cast<float>(period) * 2;
  };
  for (const auto& [number, period] : {std::pair{12, 40}, {26, 17}, {1, 90}, {51, 130}}) {
    aus.left[static_cast<std::size_t>(number)] = wave(period);
    aus.right[static_cast<std::size_t>(number)] = wave(period);
  }
  return aus;
}

Result<void> run(double seconds) {
  const auto data = find_data_folder({});
  if (!data.has_value()) return data.error();
  auto scene = test::PosedFace::load(*data / "faces" / "default", *data);
  if (!scene.has_value()) return scene.error();
  auto context = render::OffscreenContext::create();
  if (!context.has_value()) return context.error();
  auto renderer = render::FaceRenderer::create();
  if (!renderer.has_value()) return renderer.error();
  (*renderer)->load((*scene)->static_mesh());
  std::printf("OpenGL: %s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  std::printf("default face: %zu vertices, %zu triangles\n", (*scene)->face().mesh.positions.size(),
              (*scene)->face().mesh.triangles.size());
  std::printf("%-10s %-26s %9s %9s %9s %9s\n", "size", "frame", "mean fps", "best fps", "cpu ms",
              "x clear");
  for (const auto& [width, height] : {std::pair{800, 600}, {1024, 768}}) {
    auto target = render::OffscreenTarget::create(width, height);
    if (!target.has_value()) return target.error();
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    const Rate clear = measure(seconds, [&target](int frame) {
      (*target)->bind();
      glClearColor(static_cast<float>(frame % 2), 0, 0, 1);
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      static_cast<void>((*target)->read());
    });
    const Rate face = measure(seconds, [&, width = width, height = height](int frame) {
      (*scene)->pose(moving(frame));
      (*target)->bind();
      (*renderer)->pose((*scene)->moving_mesh());
      (*renderer)->draw({}, {}, width, height);
      static_cast<void>((*target)->read());
    });
    const auto print = [&size, &clear](const char* frame, const Rate& rate) {
      std::printf("%-10s %-26s %9.1f %9.1f %9.1f %9.1f\n", size.c_str(), frame, rate.mean_fps,
                  rate.best_fps, rate.cpu_ms, rate.cpu_ms / clear.cpu_ms);
    };
    print("clear, read", clear);
    print("mix, deform, draw, read", face);
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 2;
  const auto done = run(seconds);
  if (done.has_value()) return 0;
  std::fprintf(stderr, "%s\n", done.error().message.c_str());
  return exit_code(done.error());
}
