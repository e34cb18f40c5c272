#include "client/glb/drift.h"

#include <gtest/gtest.h>

#include "tests/unit/face/small_face.h"

namespace aucast::glb {
namespace {

using face::test::only;
using face::test::small_face;

TEST(Drift, IsNothingWhereTargetsAreExact) {
  face::Face face = small_face();
  // Its muscles move its eyeballs too, which no target does.
  face.mesh.parts.resize(1);
  const FaceRig rig(face, true);
  const MorphTargets targets(face, Basis::Muscles, rig);
  Drift drift(face, targets, rig);
  drift.add({{}, std::vector<float>(face.channels.size())});
  for (const Target& target : targets.all()) {
    drift.add({{}, target.pose});
    EXPECT_LT(drift.summary().worst_mm, 0.15) << target.name;
  }
  EXPECT_EQ(drift.summary().faces, 1 + targets.all().size());
  EXPECT_LT(drift.summary().worst_mm, 0.15) << "a step of 8 bits, and what is not worth a number";
}

TEST(Drift, SeesAFaceThatTheFileDoesNotShow) {
  const face::Face face = small_face();
  const FaceRig rig(face, false);
  const MorphTargets targets(face, Basis::Aus, rig);
  Drift drift(face, targets, rig);
  // Activations without AUs: no weight follows them.
  drift.add({{}, only(face, "jaw", 2)});
  EXPECT_GT(drift.summary().worst_mm, 5);
}

TEST(Drift, RandomFacesAreTheSameEachTime) {
  const face::Face face = small_face();
  const FaceRig rig(face, true);
  const MorphTargets targets(face, Basis::Muscles, rig);
  const pipeline::AuMapping mapping{face, face.recordings, {}, face::Mixer::Maximum};
  const auto measured = [&](std::uint64_t seed) {
    Drift drift(face, targets, rig);
    add_random_faces(mapping, 20, seed, drift);
    EXPECT_EQ(drift.summary().faces, 20U);
    return drift.summary().worst_mm;
  };
  EXPECT_EQ(measured(1), measured(1));
  EXPECT_NE(measured(1), measured(2));
}

TEST(Drift, SummaryIsOfAllThatWasAdded) {
  const face::Face face = small_face();
  const FaceRig rig(face, false);
  const MorphTargets targets(face, Basis::Aus, rig);
  Drift drift(face, targets, rig);
  EXPECT_EQ(drift.summary().faces, 0U);
  EXPECT_EQ(drift.summary().worst_mm, 0);
  // Activations without AUs, which the file's targets do not know of: further and further.
  for (int i = 0; i < 10; ++i) drift.add({{}, only(face, "jaw", 0.2F * static_cast<float>(i))});
  const Drift::Summary summary = drift.summary();
  EXPECT_EQ(summary.faces, 10U);
  EXPECT_LT(summary.median_mm, summary.most_mm);
  EXPECT_LE(summary.most_mm, summary.worst_mm);
  EXPECT_NEAR(summary.median_mm / summary.worst_mm, 5.0 / 9, 0.1);
}

}  // namespace
}  // namespace aucast::glb
