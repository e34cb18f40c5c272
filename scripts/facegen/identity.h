#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"
#include "scripts/facegen/palette.h"

namespace aucast::facegen {

/// The measures in which one head differs from another; lengths in mesh units (1.4 cm). What is not
/// here - the eyeballs, the teeth, the corners of the mouth, the frame - is common to all, so that
/// one set of muscles and recordings serves every identity.
struct Form {
  // skull and jaw
  double narrowing = 0.055;  ///< by what share everything below the cheekbones is narrower
  double jaw_width = 0;      ///< the angle of the jaw, outwards
  double jaw_bow = 0;        ///< between angle and chin, outwards; 1 is much
  double jaw_drop = 0;       ///< the angle of the jaw, downwards
  double chin_width = 0;
  double chin_drop = 0;
  double chin_forward = 0;
  double cheek = 0;            ///< fullness of the cheeks
  double cheekbone = 0;        ///< outwards
  double cheek_hollow = 0.06;  ///< depth below the arch of the cheekbone
  double brow_ridge = 0;
  double forehead_slope = 0;  ///< how far the forehead is set back near the hairline
  double forehead_round = 0;  ///< its bosses, towards the middle and forwards
  double muzzle = 0;          ///< the region of the lips, forwards
  double throat_drop = 0;     ///< floor of the mouth
  double short_lip = 0.11;    ///< by how much the skin of the upper lip is shorter than sculpted
  double short_nose = 0.18;   ///< likewise the way from the nose to the eyes
  double neck_width = 1;
  double larynx = 0;
  double collar = 0;  ///< of the shirt: 0 a round band, 1 turned down
  // nose
  double nose_width = 1;    ///< of tip, wings and nostrils
  double bridge_width = 0;  ///< added to the radius of the bridge
  double nose_forward = 0;  ///< the tip
  double nose_up = 0;       ///< the tip, turned up; negative: hanging
  double nose_tip = 0;      ///< added to its radii
  double nose_hump = 0;     ///< on the bridge
  double nose_root = 0.12;  ///< depth between the brows and the bridge
  // ears
  double ear_size = 1;  ///< factor
  double ear_up = 0;    ///< upwards
  // eyes: height of the lids over their corners, and of the corners over the eye's centre
  double eye_apart = 2.10;  ///< x of the centre
  double upper_lid = 0.50;
  double lower_lid = 0.345;
  double inner_canthus_up = -0.24;
  double outer_canthus_up = 0.0;
  double lid_fold = 0.30;      ///< over the margin
  double eye_bag = 0.018;      ///< depth of the groove under the eye
  double socket = 0;           ///< depth between lid and brow
  double inner_socket = 0.18;  ///< depth between the inner corner and the root of the nose
  double lash = 1;             ///< length, factor
  // lips
  double upper_lip = 0.552;
  double lower_lip = 0.74;
  double lip_bulge = 1;
  double cupids_bow = 1;
  double corner_lift = 0.09;
  double philtrum = 1;
  // brows
  double brow_up = 4.05;
  double brow_arch = 0.46;
  double brow_tail_drop = 0.30;
  double brow_begin = 0.78;  ///< x of the inner end
  double brow_width = 0.30;
  // signs of age
  double furrow = 0;        ///< depth of the furrow from nose to mouth
  double jowl = 0;          ///< depth of the fold before the jowls
  double chin_fold = 0.16;  ///< between lower lip and chin
};

/// A measure of the form and its name in a person's file.
struct Measure {
  std::string_view name;
  double Form::*member = nullptr;
  /// `varied` (variation.h) moves it. It leaves alone, first of all, what face.toml, haircut and
  /// shirt must fit. With another set, every number gives another person.
  bool varies = true;
  bool above_zero = false;  ///< without any of it there is no head
};

/// All measures of the form.
[[nodiscard]] std::span<const Measure> form_measures();

/// A lock of long hair that lies loosely on the rest and goes its own way.
struct Lock {
  double s = 0;        ///< where across the hair it begins, 0 (first guide) to 1 (last guide)
  double drift = 0;    ///< how far from there it ends, in units of s
  double begin = 0;    ///< where along the hair it begins: 0 at the roots, 1 at the tips
  double end = 1;      ///< where it ends; above 1: it is longer than the rest
  double width = 0;    ///< half its width, in units of s
  double lift = 0;     ///< height over the rest at its end, mesh units
  double over = 0;     ///< height over the rest all along, mesh units
  double cover = 0.9;  ///< how dense it is; below 0.5 single hairs show
};

/// The number of locks on a head. If there are fewer in a haircut, they come again.
inline constexpr std::size_t kLocks = 16;

/// A haircut: where the hair grows and how it falls.
struct Haircut {
  /// Points of the left hairline, from the middle of the forehead (0) past temple, sideburn and ear
  /// to the nape (12).
  std::vector<Key<Vec3>> hairline;
  Vec3 crown{0.9, 9.9, -2.6};
  /// The lines along which long hair falls, from root to tip, at equal steps across the hair: from
  /// the front of the left side round the back to the front of the right one. Empty: the hair is
  /// short and lies along the scalp.
  std::vector<std::array<Vec3, 9>> guides;
  /// Loose locks of long hair, at most `kLocks`.
  std::vector<Lock> locks;
  /// The lines along which the top of short hair is combed, from the hairline of the forehead over
  /// the crown, at equal steps from the parting on the left to the right side.
  std::vector<std::array<Vec3, 5>> combed;
  double side = 0.30;  ///< thickness of the hair over the skin
  double top = 0.72;   ///< the same on top of the head
  bool grey = false;   ///< white hairs are mixed with dark ones
};

/// The look of the lines that expressions draw on this skin (creases.h).
struct ExpressionLines {
  int seed = 0;            ///< another number draws them a little differently
  double depth = 1;        ///< factor on how dark they are
  double width = 1;        ///< factor
  double uneven = 0.12;    ///< how far they stray from the drawn line, mesh units
  double forehead_up = 0;  ///< how much higher those of the forehead lie, mesh units
};

/// How far the left side of the face differs from the right one (`make_uneven`), mesh units.
struct Askew {
  double brow = 0;   ///< the left brow, upwards
  double mouth = 0;  ///< the left corner, upwards
  double nose = 0;   ///< the tip, to the left
  double chin = 0;   ///< to the left
};

/// What makes a person. All else in the generator is the same for everybody.
struct Identity {
  /// Who in people/ shows where this person's measures may go (`varied`); empty: nobody.
  std::string varies_towards;
  Form form;
  Haircut hair;
  ExpressionLines lines;
  Askew askew;
  Palette colours;
};

/// The person that a file like those in people/ describes. Fails with Unreadable, or with BadData
/// and the place of the first error.
[[nodiscard]] Result<Identity> read_identity(const std::filesystem::path& file);
/// The same; whom the person is `like` is looked for in `people`.
[[nodiscard]] Result<Identity> read_identity(const std::filesystem::path& file,
                                             const std::filesystem::path& people);

/// The person of that name in people/. Fails with a Usage error if there is none.
[[nodiscard]] Result<Identity> identity_named(std::string_view name);

}  // namespace aucast::facegen
