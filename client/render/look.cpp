#include "client/render/look.h"

namespace aucast::render {

using view::Shading;

Look look_of(Shading shading) {
  switch (shading) {
    case Shading::Skin:
      return {1.0F, 0.19F, 20, Faces::Front, true, 0, 1};
    case Shading::Eye:
      return {0.25F, 0, 60, Faces::Front, false};
    case Shading::Teeth:
      // Teeth behind a lip are lit through and from all sides; in true shadow they look grey.
      return {0.8F, 0.5F, 40, Faces::Both, false, 0.5F};
    case Shading::Mouth:
      return {0.7F, 0.4F, 24, Faces::Both, false};
    case Shading::Hair:
      return {0.35F, 0.46F, 18, Faces::Front, true};
    case Shading::Cloth:
      return {0.15F, 0.06F, 8, Faces::Both, true};
    case Shading::Brow:
      return {0.2F, 0.05F, 10, Faces::Both, false};
    case Shading::Crease:
      return {};  // has a program of its own
  }
  return {};
}

}  // namespace aucast::render
