#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "client/gallery/gallery_plan.h"

namespace aucast::gallery {

/// Builds a plan section by section. A picture that two sections show is planned once.
class GalleryPlanner {
 public:
  explicit GalleryPlanner(const GalleryInput& input) : input_(input) {}

  /// Adds the sections that were asked for, in the order of the page.
  void add_sections();
  /// Adds the frames and the figure of each sweep that was asked for.
  [[nodiscard]] Result<void> add_sweeps();
  [[nodiscard]] GalleryPlan take();

 private:
  /// What a picture shows, without its file.
  struct Subject {
    std::vector<std::string> sources;
    AuFrame aus;
    std::vector<ExpressionMuscle> muscles;
  };

  [[nodiscard]] bool wanted(std::string_view section) const;
  [[nodiscard]] const Expression* expression(const std::string& name) const;
  [[nodiscard]] bool can_show(const Expression& expression) const;
  [[nodiscard]] static Subject subject(const Expression& expression);
  /// Returns the index of the picture with that file. Adds it if it is not in the plan yet.
  std::size_t picture(const std::string& file, const Subject& subject, face::Mixer mixer,
                      const face::RuleSet& rules);
  std::size_t picture(const std::string& file, const Subject& subject);
  std::size_t au_picture(int number, char letter, Side side);
  GalleryFigure expression_figure(const Expression& expression);

  void add_aus();
  void add_prototypes();
  void add_combinations();
  void add_appendix_a();
  void add_appendix_b();
  [[nodiscard]] GalleryRow benchmark_row(const std::string& emotion, face::Mixer mixer);
  [[nodiscard]] GalleryBlock combination_block(const std::string& heading,
                                               const std::string& prefix);
  [[nodiscard]] Result<void> add_sweep(const std::string& word, GalleryBlock& block);
  void add_sweep_frames(const std::string& name, const std::string& title, const Subject& subject,
                        GalleryBlock& block);

  const GalleryInput& input_;
  GalleryPlan plan_;
  std::map<std::string, std::size_t> files_;
};

}  // namespace aucast::gallery
