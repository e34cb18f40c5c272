#include "scripts/facegen/proportions.h"

namespace aucast::facegen {

double middle_drop(const Form& form, double y) {
  return form.short_lip * smooth_step(-1.75, -0.45, y) +
         form.short_nose * smooth_step(-0.60, 1.35, y);
}

void shorten_middle(const Form& form, std::vector<Part>& parts) {
  for (Part& part : parts) {
    for (Vertex& vertex : part.vertices) {
      vertex.position.y -= middle_drop(form, vertex.position.y);
    }
  }
}

}  // namespace aucast::facegen
