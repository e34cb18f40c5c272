#pragma once

#include <functional>

#include "scripts/facegen/identity.h"

namespace aucast::facegen {

// Stage 1: the form of the head as one signed distance, melted together from ellipsoids and rounded
// bones and then engraved with the small relief of lids, nose and lips. No mesh yet.

/// Distance from the skin: negative inside the head. Symmetric in x.
[[nodiscard]] double head_distance(const Identity& who, const Vec3& p);

/// How deep the folds beside nose and mouth are at a place of the skin.
[[nodiscard]] double fold_depth(const Identity& who, const Vec3& p);

/// The signed distance of a point from a body, for leave().
using Distance = std::function<double(const Vec3&)>;

/// head_distance() for one person.
[[nodiscard]] Distance head_of(const Identity& who);

/// Distance from neck and torso in a shirt; only make_shirt() needs it.
[[nodiscard]] double torso_distance(const Form& form, const Vec3& p);

/// Unit vector away from the head, from differences of head_distance() over `step`.
[[nodiscard]] Vec3 head_normal(const Identity& who, const Vec3& p, double step = 0.01);

/// The nearest place on the skin, found in at most `steps` steps along the gradient.
[[nodiscard]] Vec3 on_skin(const Identity& who, Vec3 p, int steps = 10);

/// z of the foremost point of the face at (x, y).
[[nodiscard]] double face_z(const Identity& who, double x, double y);

/// Where a ray from inside the body leaves the body for good.
[[nodiscard]] Vec3 leave(const Vec3& origin, const Vec3& direction, const Distance& distance);

}  // namespace aucast::facegen
