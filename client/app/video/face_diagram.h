#pragma once

#include <memory>
#include <span>
#include <vector>

#include "client/face/face.h"
#include "client/face/face_deformer.h"
#include "client/view/style.h"

namespace aucast::app {

/// Draws what drives a face: muscles with attachment, insertion, zone of influence and fall-off
/// radii, and the vertices that the jaw and the lids move. The face must outlive it. Thread: one at
/// a time.
class FaceDiagram {
 public:
  explicit FaceDiagram(const face::Face& face);
  ~FaceDiagram();
  FaceDiagram(const FaceDiagram&) = delete;
  FaceDiagram& operator=(const FaceDiagram&) = delete;

  /// Draws what `layers` ask for. `activations`: one per channel.
  void update(const view::Layers& layers, std::span<const float> activations,
              const face::DeformedFace& deformed);

  /// The muscles. They follow head and jaw but not the skin. Active ones are coloured by their
  /// activation.
  [[nodiscard]] std::span<const view::Segment> muscles() const;
  /// Dots on the vertices that jaw and lids move, from blue (a little) to red (all the way).
  [[nodiscard]] std::span<const view::Segment> tags() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aucast::app
