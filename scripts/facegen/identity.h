#pragma once

#include <optional>
#include <string_view>

#include "scripts/facegen/part.h"

namespace aucast::facegen {

/// What makes another person of the same head: how its finished form is drawn out and how it is
/// coloured. Eyes, lids and numbering stay, so that muscles and recordings serve every identity.
struct Identity {
  std::string_view name;
  double jaw_width = 1;    ///< of everything below the cheekbones
  double chin_length = 0;  ///< further down, mesh units
  double nose_width = 1;
  double nose_length = 0;  ///< of the tip, forward
  double neck_width = 1;
  double crown_height = 1;  ///< of what lies above the forehead
  Vec3 skin{1};             ///< factors on the colours of the default face, linear
  Vec3 lips{1};
  Vec3 hair{1};
  Vec3 iris{1};
  Vec3 cloth{1};
};

/// The identity of that name; nothing when there is none.
[[nodiscard]] std::optional<Identity> identity_named(std::string_view name);

/// Stage 9: turns the finished default head into the identity.
void apply(const Identity& identity, std::vector<Part>& parts);

}  // namespace aucast::facegen
