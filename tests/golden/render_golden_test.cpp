#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "client/app/window/settings/window_style.h"
#include "client/render/face_renderer.h"
#include "client/render/gl_objects.h"
#include "client/render/offscreen_context.h"
#include "client/render/offscreen_target.h"
#include "client/render/window.h"
#include "client/view/image.h"
#include "client/view/viewpoint.h"
#include "common/embedded_file.h"
#include "common/files.h"
#include "tests/golden/baseline.h"
#include "tests/golden/render_scene.h"
#include "tests/support/image_difference.h"
#include "tests/support/process.h"
#include "tests/support/temp_folder.h"

namespace aucast {
namespace {

constexpr int kSide = 200;
/// Another processor rounds differently: a pixel counts from a difference of 8 on, and one in a
/// hundred may.
constexpr int kTolerance = 8;
constexpr double kShareMax = 0.01;

/// One OpenGL context and renderer for a test.
class RenderGolden : public testing::Test {
 protected:
  void SetUp() override {
    auto context = render::OffscreenContext::create();
    ASSERT_TRUE(context.has_value()) << context.error().message;
    context_ = std::move(context.value());
    auto renderer = render::FaceRenderer::create();
    ASSERT_TRUE(renderer.has_value()) << renderer.error().message;
    renderer_ = std::move(renderer.value());
  }

  view::Image drawn(const view::MovingMesh& mesh, const view::Viewpoint& viewpoint,
                    int width = kSide, int height = kSide,
                    const view::Background& background = {}) {
    auto target = render::OffscreenTarget::create(width, height);
    EXPECT_TRUE(target.has_value()) << target.error().message;
    (*target)->bind();
    renderer_->pose(mesh);
    renderer_->draw(viewpoint, {.background = background}, width, height);
    return (*target)->read();
  }

  render::FaceRenderer& renderer() { return *renderer_; }

 private:
  std::unique_ptr<render::OffscreenContext> context_;
  std::unique_ptr<render::FaceRenderer> renderer_;
};

void expect_as_baseline(const view::Image& image, const std::string& name) {
  test::expect_as_baseline(image, name, kTolerance, kShareMax);
}

int brightness(const view::Image& image, int x, int y) {
  const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                              static_cast<std::size_t>(x));
  return image.rgba[at] + image.rgba[at + 1] + image.rgba[at + 2];
}

TEST_F(RenderGolden, SphereHeadLooksAsBefore) {
  const test::SphereHead head;
  renderer().load(head.static_mesh());
  for (const auto& [name, preset] : std::vector<std::pair<std::string, view::ViewpointPreset>>{
           {"render_spheres_front", view::ViewpointPreset::Front},
           {"render_spheres_three_quarter", view::ViewpointPreset::ThreeQuarter}}) {
    expect_as_baseline(drawn(head.moving_mesh(), view::portrait_viewpoint(preset)), name);
  }
}

TEST_F(RenderGolden, EveryLayerLooksAsBefore) {
  const test::SphereHead head;
  renderer().load(head.static_mesh());
  const std::array<view::Segment, 3> marks{
      {{{-3, 2, 9}, {3, 3, 9}, {1, 0.3F, 0.1F, 1}, 3},     // in front of the head
       {{-3, 0, 2}, {3, 0, 2}, {0.2F, 0.9F, 0.3F, 1}, 3},  // inside it
       {{0, 5, 9}, {0, 5, 9}, {1, 1, 0.2F, 1}, 12}}};      // a dot
  for (const std::string layers : {"polygons", "textured,wireframe,vertices", "wireframe",
                                   "transparent,muscles", "vertices,transparent"}) {
    auto target = render::OffscreenTarget::create(kSide, kSide);
    ASSERT_TRUE(target.has_value()) << target.error().message;
    (*target)->bind();
    view::Style style{.layers = *view::parse_layers(layers), .diagram = marks};
    renderer().pose(head.moving_mesh());
    renderer().draw({}, style, kSide, kSide);
    std::string name = "render_layers_" + layers;
    std::replace(name.begin(), name.end(), ',', '_');
    expect_as_baseline((*target)->read(), name);
  }
  // What was drawn leaves no trace in the next picture.
  expect_as_baseline(
      drawn(head.moving_mesh(), view::portrait_viewpoint(view::ViewpointPreset::Front)),
      "render_spheres_front");
}

TEST_F(RenderGolden, TheKeyLightLightsItsSide) {
  const test::SphereHead head;
  renderer().load(head.static_mesh());
  const auto lit_from = [&](float yaw_deg, float strength) {
    auto target = render::OffscreenTarget::create(kSide, kSide);
    EXPECT_TRUE(target.has_value());
    (*target)->bind();
    const view::Style style{.light = view::key_light(yaw_deg, 20, strength)};
    renderer().pose(head.moving_mesh());
    renderer().draw({}, style, kSide, kSide);
    return (*target)->read();
  };
  const int left = kSide / 2 + 30;
  const int right = kSide / 2 - 30;
  const view::Image from_left = lit_from(60, 1);
  const view::Image from_right = lit_from(-60, 1);
  EXPECT_GT(brightness(from_left, left, kSide / 2), brightness(from_right, left, kSide / 2));
  EXPECT_LT(brightness(from_left, right, kSide / 2), brightness(from_right, right, kSide / 2));
  EXPECT_GT(brightness(lit_from(60, 1.5F), left, kSide / 2),
            brightness(from_left, left, kSide / 2));
}

TEST_F(RenderGolden, DrawsTheSameBytesTwice) {
  const test::SphereHead head;
  renderer().load(head.static_mesh());
  const view::Image first = drawn(head.moving_mesh(), {});
  const view::Image second = drawn(head.moving_mesh(), {});
  EXPECT_TRUE(first.rgba == second.rgba);
  // What was drawn in between leaves no trace.
  view::Viewpoint other;
  other.yaw_rad = 1;
  EXPECT_FALSE(drawn(head.moving_mesh(), other).rgba == first.rgba);
  EXPECT_TRUE(drawn(head.moving_mesh(), {}).rgba == first.rgba);
  auto again = render::FaceRenderer::create();
  ASSERT_TRUE(again.has_value());
  (*again)->load(head.static_mesh());
  auto target = render::OffscreenTarget::create(kSide, kSide);
  ASSERT_TRUE(target.has_value());
  (*target)->bind();
  (*again)->pose(head.moving_mesh());
  (*again)->draw({}, {}, kSide, kSide);
  EXPECT_TRUE((*target)->read().rgba == first.rgba);
}

TEST(FaceRenderer, DrawsTheSamePictureWithOpenGlEs) {
  const test::SphereHead head;
  const auto drawn_with = [&](render::Api api) {
    const auto context = render::OffscreenContext::create(api);
    EXPECT_TRUE(context.has_value()) << context.error().message;
    EXPECT_EQ(epoxy_is_desktop_gl(), api == render::Api::OpenGl33Core);
    auto renderer = render::FaceRenderer::create();
    EXPECT_TRUE(renderer.has_value()) << renderer.error().message;
    (*renderer)->load(head.static_mesh());
    (*renderer)->pose(head.moving_mesh());
    auto target = render::OffscreenTarget::create(kSide, kSide);
    EXPECT_TRUE(target.has_value());
    (*target)->bind();
    (*renderer)->draw({}, {}, kSide, kSide);
    const view::Image image = (*target)->read();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    return image;
  };
  const view::Image wanted = drawn_with(render::Api::OpenGl33Core);
  EXPECT_EQ(test::compare(drawn_with(render::Api::OpenGlEs30), wanted, 1).share, 0);
}

TEST(FaceRenderer, DrawsEdgesAndCornersWithOpenGlEsToo) {
  const test::SphereHead head;
  const auto context = render::OffscreenContext::create(render::Api::OpenGlEs30);
  ASSERT_TRUE(context.has_value()) << context.error().message;
  auto renderer = render::FaceRenderer::create();
  ASSERT_TRUE(renderer.has_value()) << renderer.error().message;
  (*renderer)->load(head.static_mesh());
  (*renderer)->pose(head.moving_mesh());
  auto target = render::OffscreenTarget::create(kSide, kSide);
  ASSERT_TRUE(target.has_value());
  const auto drawn = [&](const view::Layers& layers) {
    view::Style style;
    style.layers = layers;
    (*target)->bind();
    (*renderer)->draw({}, style, kSide, kSide);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    return (*target)->read();
  };
  const view::Image plain = drawn({.polygons = true, .textured = false});
  for (const view::Layers& layers :
       {view::Layers{.polygons = true, .textured = false, .wireframe = true},
        view::Layers{.polygons = true, .textured = false, .vertices = true}}) {
    EXPECT_GT(test::compare(drawn(layers), plain, 5).share, 0.01) << view::format_layers(layers);
  }
}

TEST(FaceRenderer, ShadersInTheFolderOfTheEnvironmentMayChangeWhileItRuns) {
  const auto context = render::OffscreenContext::create();
  ASSERT_TRUE(context.has_value()) << context.error().message;
  const test::TempFolder folder;
  for (const auto& file : embedded::shaders()) folder.write(std::string(file.name), file.bytes);
  auto written = std::filesystem::file_time_type::clock::now();
  const auto write_backdrop = [&](const std::string& main) {
    const auto file =
        folder.write("backdrop_fragment.glsl",
                     "uniform vec3 u_centre;\nuniform vec3 u_edge;\nuniform float u_square;\n"
                     "out vec4 o_colour;\n" +
                         main);
    std::filesystem::last_write_time(file, written += std::chrono::seconds(1));
  };
  write_backdrop(
      "void main() { o_colour = vec4(step(u_centre, u_edge + u_square + 1.0).r, 0, 0, 1); }\n");
  ::setenv("AUCAST_SHADERS", folder.path().c_str(), 1);
  auto renderer = render::FaceRenderer::create();
  ASSERT_TRUE(renderer.has_value()) << renderer.error().message;
  auto target = render::OffscreenTarget::create(1, 1);
  ASSERT_TRUE(target.has_value()) << target.error().message;
  (*renderer)->load({});
  std::string fault;
  const auto pixel = [&] {
    const auto renewed = (*renderer)->renew_shaders();
    fault = renewed.has_value() ? "" : renewed.error().message;
    (*target)->bind();
    (*renderer)->draw({}, {}, 1, 1);
    return (*target)->read().rgba;
  };
  EXPECT_EQ(pixel(), (std::vector<std::uint8_t>{255, 0, 0, 255}));
  write_backdrop(
      "void main() { o_colour = vec4(0, step(u_centre, u_edge + u_square + 1.0).g, 0, 1); }\n");
  EXPECT_EQ(pixel(), (std::vector<std::uint8_t>{0, 255, 0, 255}));
  EXPECT_EQ(fault, "");
  write_backdrop("void main() { nonsense; }\n");
  EXPECT_EQ(pixel(), (std::vector<std::uint8_t>{0, 255, 0, 255}));
  EXPECT_NE(fault.find("nonsense"), std::string::npos) << fault;
  write_backdrop("void main() { o_colour = vec4(u_centre, 1.0); }\n");  // u_edge is not there
  EXPECT_EQ(pixel(), (std::vector<std::uint8_t>{0, 255, 0, 255}));
  std::filesystem::remove(folder.path() / "lit_vertex.glsl");
  const auto broken = render::FaceRenderer::create();
  ::unsetenv("AUCAST_SHADERS");
  ASSERT_FALSE(broken.has_value());
  EXPECT_NE(broken.error().message.find("lit_vertex.glsl"), std::string::npos);
}

TEST_F(RenderGolden, GivesCompletePicturesOfAnySize) {
  const test::SphereHead head;
  renderer().load(head.static_mesh());
  for (const auto& [width, height] :
       std::vector<std::pair<int, int>>{{1, 1}, {3, 201}, {201, 3}, {333, 77}, {640, 480}}) {
    const view::Image image = drawn(head.moving_mesh(), {}, width, height);
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    ASSERT_EQ(image.rgba.size(), 4U * static_cast<unsigned>(width * height));
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);
  }
}

TEST_F(RenderGolden, ShowsTheTopAtTheTop) {
  const test::SphereHead head;
  renderer().load(head.static_mesh());
  const view::Image image = drawn(head.moving_mesh(), {});
  // Hair above, skin below it.
  EXPECT_LT(brightness(image, kSide / 2, kSide / 8), brightness(image, kSide / 2, kSide / 3));
}

TEST_F(RenderGolden, PaintsTheBackgroundAsked) {
  const test::SphereHead head;
  renderer().load(head.static_mesh());
  const view::Background white{glm::vec3(1.5F), glm::vec3(1.5F)};
  const view::Image image = drawn(head.moving_mesh(), {}, kSide, kSide, white);
  EXPECT_EQ(brightness(image, 1, 1), 3 * 255);
  EXPECT_LT(brightness(image, kSide / 2, kSide / 2), 3 * 255);
  const view::Image dark =
      drawn(head.moving_mesh(), {}, kSide, kSide, {glm::vec3(0), glm::vec3(0)});
  EXPECT_EQ(brightness(dark, 1, 1), 0);
}

TEST_F(RenderGolden, TheWindowsPlainGroundsAreThatColourOnTheScreen) {
  const test::SphereHead head;
  renderer().load(head.static_mesh());
  const auto corner = [&](gui::Ground ground) {
    gui::RenderingSettings settings;
    settings.ground = ground;
    const view::Style style = app::window_style(settings, std::nullopt, 1);
    return brightness(drawn(head.moving_mesh(), {}, kSide, kSide, style.background), 1, 1);
  };
  EXPECT_EQ(corner(gui::Ground::White), 3 * 255);
  EXPECT_EQ(corner(gui::Ground::Black), 0);
  EXPECT_NEAR(corner(gui::Ground::Grey), 3 * 0x73, 3);
}

TEST_F(RenderGolden, TheWindowShowsSquaresWherePicturesAreTransparent) {
  const test::SphereHead head;
  renderer().load(head.static_mesh());
  gui::RenderingSettings settings;
  settings.ground = gui::Ground::None;
  const view::Background ground = app::window_style(settings, std::nullopt, 1).background;
  EXPECT_TRUE(ground.transparent);
  const view::Image image = drawn(head.moving_mesh(), {}, kSide, kSide, ground);
  const int side = static_cast<int>(ground.squares_px);
  const int first = brightness(image, 1, 1);
  EXPECT_NE(brightness(image, 1 + side, 1), first);
  EXPECT_NE(brightness(image, 1, 1 + side), first);
  EXPECT_EQ(brightness(image, 1 + side, 1 + side), first);
}

TEST_F(RenderGolden, DrawsAnEmptyMeshAsBackground) {
  renderer().load({});
  const view::Image image = drawn({}, {});
  EXPECT_GT(brightness(image, kSide / 2, kSide / 2), 0);
}

TEST_F(RenderGolden, SmoothsTheOutline) {
  const test::SphereHead head;
  renderer().load(head.static_mesh());
  const view::Image image =
      drawn(head.moving_mesh(), {}, kSide, kSide, {glm::vec3(0), glm::vec3(0)});
  // Between the black ground and the skin stand pixels that are partly both.
  const int row = kSide / 2;
  int begin = 0;
  while (begin < kSide && brightness(image, begin, row) == 0) ++begin;
  ASSERT_LT(begin + 3, kSide);
  EXPECT_LT(brightness(image, begin, row), brightness(image, begin + 2, row));
}

TEST_F(RenderGolden, LightsTheDefaultFace) {
  const auto data = find_data_folder({});
  ASSERT_TRUE(data.has_value()) << data.error().message;
  auto scene = test::PosedFace::load(*data / "faces" / "default", *data);
  ASSERT_TRUE(scene.has_value()) << scene.error().message;
  renderer().load((*scene)->static_mesh());
  const view::Image rest = drawn((*scene)->moving_mesh(), {}, 300, 300);
  // Red over blue in the middle of the face: skin in warm light.
  const std::size_t middle = 4U * (170U * 300U + 150U);
  EXPECT_GT(rest.rgba[middle], rest.rgba[middle + 2] + 20);
  expect_as_baseline(rest, "render_default_face_rest");

  // The grain of the skin is on the skin alone, and faint; so is its rounding.
  view::StaticMesh smooth = (*scene)->static_mesh();
  smooth.rest = {};
  renderer().load(smooth);
  const view::Image plain = drawn((*scene)->moving_mesh(), {}, 300, 300);
  EXPECT_GT(test::compare(rest, plain, 2).share, 0.02);
  EXPECT_LT(test::compare(rest, plain, 24).share, 0.01);
  EXPECT_EQ(brightness(rest, 5, 5), brightness(plain, 5, 5));
  renderer().load((*scene)->static_mesh());

  AuFrame smile;
  for (const int number : {6, 12, 25}) {
    smile.left[static_cast<std::size_t>(number)] = 1;
    smile.right[static_cast<std::size_t>(number)] = 1;
  }
  (*scene)->pose(smile);
  const view::Image smiling = drawn((*scene)->moving_mesh(), {}, 300, 300);
  EXPECT_GT(test::compare(rest, smiling, kTolerance).share, 0.01);
  (*scene)->pose({});
  EXPECT_TRUE(drawn((*scene)->moving_mesh(), {}, 300, 300).rgba == rest.rgba);
}

TEST_F(RenderGolden, TheShippedHeadsLookAsBefore) {
  struct Shot {
    std::string name;
    std::vector<AuTerm> aus;
    view::ViewpointPreset from = view::ViewpointPreset::Front;
  };
  const auto terms = [](std::initializer_list<std::uint8_t> numbers) {
    std::vector<AuTerm> all;
    for (const std::uint8_t number : numbers) all.push_back({number, Side::Both, 100});
    return all;
  };
  const std::vector<Shot> shots{{"smile", terms({6, 12, 25})},
                                {"worry", terms({1, 2, 4})},
                                {"eyes_shut", terms({43})},
                                {"profile", {}, view::ViewpointPreset::Profile}};
  const auto data = find_data_folder({});
  ASSERT_TRUE(data.has_value()) << data.error().message;
  for (const std::string face : {"default", "marek"}) {
    auto scene = test::PosedFace::load(*data / "faces" / face, *data);
    ASSERT_TRUE(scene.has_value()) << scene.error().message;
    renderer().load((*scene)->static_mesh());
    for (const Shot& shot : shots) {
      (*scene)->pose(frame_from_terms(shot.aus));
      expect_as_baseline(
          drawn((*scene)->moving_mesh(), view::portrait_viewpoint(shot.from), 300, 300),
          "render_" + face + "_" + shot.name);
    }
  }
}

TEST_F(RenderGolden, AnIrisIsSeenFromTheSide) {
  const auto data = find_data_folder({});
  ASSERT_TRUE(data.has_value()) << data.error().message;
  auto scene = test::PosedFace::load(*data / "faces" / "default", *data);
  ASSERT_TRUE(scene.has_value()) << scene.error().message;
  // Nothing but the left eye, with an iris of pure red on a white ball.
  view::StaticMesh eye = (*scene)->static_mesh();
  const view::MovingMesh moving = (*scene)->moving_mesh();
  const glm::vec3 centre = moving.eye_centres[0];
  std::vector<glm::vec4> colours(eye.colours.size(), glm::vec4(1));
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const glm::vec3 from_centre = moving.positions[i] - centre;
    if (glm::dot(from_centre, moving.eye_forward[0]) > 0.9F * glm::length(from_centre)) {
      colours[i] = {1, 0, 0, 1};
    }
  }
  std::vector<view::MaterialRange> ranges(eye.ranges.begin(), eye.ranges.end());
  std::erase_if(ranges, [](const view::MaterialRange& range) { return range.eye != 0; });
  ASSERT_EQ(ranges.size(), 1U);
  eye.colours = colours;
  eye.ranges = ranges;
  eye.rest = {};
  renderer().load(eye);
  const auto red_pixels = [&](float yaw_deg) {
    const view::Viewpoint viewpoint{
        .target = centre, .yaw_rad = glm::radians(yaw_deg), .half_height = 1.5F};
    const view::Image image = drawn(moving, viewpoint);
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      if (image.rgba[i] > 2 * image.rgba[i + 1]) ++count;
    }
    return count;
  };
  // A flat colour on a ball would show 9 % of itself from the side; through the cornea it is about
  // a quarter.
  const int front = red_pixels(0);
  EXPECT_GT(front, 3'000);
  EXPECT_GT(red_pixels(90), front / 5);
  EXPECT_LT(red_pixels(90), front / 3);
  EXPECT_EQ(red_pixels(180), 0);
}

TEST(OffscreenTarget, RefusesSizesBeyondTheDriver) {
  const auto context = render::OffscreenContext::create();
  ASSERT_TRUE(context.has_value()) << context.error().message;
  for (const auto& [width, height] :
       std::vector<std::pair<int, int>>{{0, 10}, {10, 0}, {-1, 10}, {10, 1 << 20}}) {
    const auto target = render::OffscreenTarget::create(width, height);
    ASSERT_FALSE(target.has_value());
    EXPECT_EQ(target.error().kind, ErrorKind::Failed);
    EXPECT_NE(target.error().message.find("each side 1 to "), std::string::npos)
        << target.error().message;
  }
}

TEST(OffscreenContext, CanBeMadeAgain) {
  for (int i = 0; i < 3; ++i) {
    const auto context = render::OffscreenContext::create();
    ASSERT_TRUE(context.has_value()) << context.error().message;
    EXPECT_TRUE(render::FaceRenderer::create().has_value());
  }
}

TEST(OffscreenContext, SaysWhatToInstallWithoutADriver) {
  // The libraries read this variable once per process: hence a second one.
  const auto result = test::run(
      {test::program("test_render_golden"), "--gtest_filter=OffscreenContext.CanBeMadeAgain"},
      {"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent"});
  EXPECT_EQ(result.exit_code, 1);
  for (const char* words : {"no OpenGL 3.3 without a display (surfaceless: ", "; device: ",
                            "apt install libgl1 libegl1 libgl1-mesa-dri"}) {
    EXPECT_NE(result.out.find(words), std::string::npos) << words << " in " << result.out;
  }
}

TEST(Window, SaysWhatToDoWithoutADisplay) {
  ::unsetenv("DISPLAY");
  const auto window = render::Window::create(100, 100, "test");
  ASSERT_FALSE(window.has_value());
  EXPECT_EQ(window.error().kind, ErrorKind::Failed);
  EXPECT_NE(window.error().message.find("no display to open a window on"), std::string::npos);
  EXPECT_NE(window.error().message.find("--headless"), std::string::npos);
}

TEST(BuildProgram, GivesTheCompilersWords) {
  const auto context = render::OffscreenContext::create();
  ASSERT_TRUE(context.has_value()) << context.error().message;
  const std::array<const char*, 1> good{"#version 330 core\nvoid main() {}\n"};
  const std::array<const char*, 1> bad{"#version 330 core\nvoid main() { nonsense; }\n"};
  EXPECT_TRUE(render::build_program("plain", good, good).has_value());
  const auto broken = render::build_program("plain", good, bad);
  ASSERT_FALSE(broken.has_value());
  EXPECT_EQ(broken.error().kind, ErrorKind::Failed);
  EXPECT_NE(broken.error().message.find("\"plain\""), std::string::npos);
  EXPECT_NE(broken.error().message.find("nonsense"), std::string::npos) << broken.error().message;
}

}  // namespace
}  // namespace aucast
