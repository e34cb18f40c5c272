#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/face/co_occurrence_rules.h"
#include "client/face/face.h"
#include "client/face/muscle_mixer.h"
#include "common/action_unit.h"
#include "common/expressions/expressions.h"
#include "common/result.h"

namespace aucast::gallery {

/// A sweep goes from the neutral face to the apex and back. These are the times at which its phases
/// begin; each ends when the next one begins.
inline constexpr int kSweepFps = 25;
inline constexpr int kOnsetMs = 0;
inline constexpr int kApexMs = 600;
inline constexpr int kOffsetMs = 1000;
inline constexpr int kSweepEndMs = 1600;

/// The share of the apex's activations at a time of a sweep, in [0,1]: it rises along a cosine,
/// holds, and falls along a cosine.
[[nodiscard]] float sweep_strength(int time_ms);

/// Which frame of a sweep a picture is.
struct SweepFrame {
  int number = 1;
  int time_ms = 0;
};

/// One PNG of the gallery: what it shows and how it was made.
struct GalleryPicture {
  std::string file;                  ///< path below DIR, with '/'
  std::vector<std::string> sources;  ///< names of the expressions in it; empty: it shows AUs only
  AuFrame aus;                       ///< the AUs asked for
  AuFrame shown;                     ///< the AUs after the rules
  std::vector<ExpressionMuscle> muscles;
  face::Mixer mixer = face::Mixer::Maximum;
  std::string rules;
  std::optional<SweepFrame> sweep_frame;
};

/// A place for a picture on the page.
struct GalleryFigure {
  std::optional<std::size_t> picture;  ///< index into GalleryPlan::pictures; nullopt: an empty cell
  std::string title;
  std::string text;
  std::size_t video = 0;  ///< 1 + index into GalleryPlan::sweeps; 0: none
};

struct GalleryRow {
  std::string heading;
  std::vector<GalleryFigure> figures;
};

/// Pictures that belong together: a table if there are columns, else figures one after another.
struct GalleryBlock {
  std::string heading;
  std::vector<std::string> columns;
  std::vector<GalleryRow> rows;
};

struct GallerySection {
  std::string name;  ///< as in --only
  std::string title;
  std::string text;
  std::vector<GalleryBlock> blocks;
};

/// The frames of one sweep: `count` pictures from GalleryPlan::pictures[begin] on.
struct GallerySweep {
  std::string name;  ///< name of its folder and its video below sweeps/
  std::size_t begin = 0;
  std::size_t count = 0;
};

/// One AU in the coverage table.
struct Coverage {
  int number = 0;
  std::string name;
  bool recorded = false;
  bool sided = false;
  std::vector<std::string> drives;
  std::string note;
};

/// Whether the recording's note says that the mesh cannot show this AU well.
[[nodiscard]] bool is_limited(const Coverage& row);

/// Everything that `gallery` will make.
struct GalleryPlan {
  std::vector<GalleryPicture> pictures;  ///< each file once, in the order of drawing
  std::vector<GallerySection> sections;
  std::vector<GallerySweep> sweeps;
  std::vector<Coverage> coverage;
};

/// The rules that a gallery may need.
struct GalleryRules {
  face::RuleSet chosen;
  face::RuleSet kumar2010;
  face::RuleSet facs;
  face::RuleSet none;
};

/// What a plan is made from. References and spans must outlive it.
struct GalleryInput {
  const face::Face& face;
  std::span<const Expression> expressions;
  const GalleryRules& rules;
  face::Mixer mixer = face::Mixer::Maximum;
  std::set<std::string> only;       ///< sections; empty: all
  std::vector<std::string> sweeps;  ///< each a set of AUs, the name of an expression, or "all"
};

/// Lists the pictures. A sweep that is neither a set of AUs nor an expression is a Usage error.
[[nodiscard]] Result<GalleryPlan> plan_gallery(const GalleryInput& input);

/// Whether FACS scores this AU on each side separately and the face can show that.
[[nodiscard]] bool is_sided(const face::Face& face, int number);

/// The AUs of the thesis' appendix C (tables 1 and 2), and any others that the face has.
[[nodiscard]] std::vector<Coverage> coverage_of(const face::Face& face);

/// A set of AUs in a form for file names, with only letters, digits, '.', '-' and '_':
/// au06_au12-80_auR14. The end of one that is too long for a file's name is replaced by digits made
/// of the whole.
[[nodiscard]] std::string file_stem(const AuFrame& aus);

}  // namespace aucast::gallery
