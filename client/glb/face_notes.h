#pragma once

#include <string>

#include "client/face/face.h"
#include "client/glb/face_rig.h"
#include "client/glb/glb_file.h"
#include "client/glb/morph_targets.h"
#include "common/sources/arkit_table.h"

namespace aucast::glb {

/// What a file says about itself beyond the numbers.
struct About {
  std::string licence;         ///< of the face; empty: unknown
  std::string sound;           ///< name of the sound file that goes with the animation; empty: none
  sources::ArkitTable curves;  ///< ARKit's names of curves and the AUs that they stand for
};

/// The contents of the file's `extras`, which viewers show and programs may read: units, what
/// weights mean, and which targets and joints make each Action Unit and each curve of ARKit.
[[nodiscard]] Json face_notes(const face::Face& face, const MorphTargets& targets,
                              const FaceRig& rig, const About& about);

}  // namespace aucast::glb
