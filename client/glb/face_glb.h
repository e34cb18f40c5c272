#pragma once

#include <string>

#include "client/face/face.h"
#include "client/glb/face_notes.h"
#include "client/glb/face_rig.h"
#include "client/glb/morph_targets.h"
#include "client/glb/motion.h"
#include "common/result.h"

namespace aucast::glb {

/// The face as a binary glTF 2.0 file: joints as nodes, surfaces with morph targets, and an
/// animation if there is one (null: the face alone). The same arguments give the same bytes. Failed
/// when there is no memory for a picture, or the file would exceed 4 GB, the most that the format
/// allows.
[[nodiscard]] Result<std::string> face_glb(const face::Face& face, const MorphTargets& targets,
                                           const FaceRig& rig, const Motion* motion,
                                           const About& about);

}  // namespace aucast::glb
