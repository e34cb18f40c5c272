#pragma once

#include <string>

#include "client/face/face.h"
#include "client/glb/face_notes.h"
#include "client/glb/face_rig.h"
#include "client/glb/morph_targets.h"
#include "client/glb/motion.h"
#include "common/result.h"

namespace aucast::glb {

/// The face as a binary glTF 2.0 file: joints as nodes, surfaces with morph targets, and the
/// animation `motion` (null: none). The same arguments give the same bytes. Fails if there is no
/// memory for a picture or the file would exceed 4 GB, the limit of the format.
[[nodiscard]] Result<std::string> face_glb(const face::Face& face, const MorphTargets& targets,
                                           const FaceRig& rig, const Motion* motion,
                                           const About& about);

}  // namespace aucast::glb
