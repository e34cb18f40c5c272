#include "scripts/facegen/identity.h"

#include <array>

namespace aucast::facegen {
namespace {

/// Swept to the side and tucked behind the ears.
constexpr std::array<Key<Vec3>, 18> kLongHairline{{{0, {0, 6.95, 7.1}},
                                                   {0.4, {0.6, 6.97, 7.0}},
                                                   {1, {1.4, 6.95, 6.8}},
                                                   {2, {2.6, 6.55, 6.2}},
                                                   {3, {3.45, 5.75, 5.5}},
                                                   {3.8, {3.95, 4.75, 4.9}},
                                                   {4.6, {4.25, 3.8, 4.0}},
                                                   {5.3, {4.45, 2.5, 3.15}},
                                                   {5.8, {4.5, 1.95, 2.65}},
                                                   {6.3, {4.6, 2.7, 2.15}},
                                                   {7, {4.85, 3.55, 1.3}},
                                                   {7.7, {4.8, 3.4, 0.0}},
                                                   {8.4, {4.6, 3.0, -1.2}},
                                                   {9.2, {4.1, 2.8, -2.6}},
                                                   {10.2, {3.0, 2.7, -4.0}},
                                                   {11.2, {1.4, 2.7, -4.9}},
                                                   {11.6, {0.7, 2.7, -5.1}},
                                                   {12, {0, 2.7, -5.2}}}};

/// A bob, parted on the left, longer in front, its ends curled in.
constexpr std::array<std::array<Vec3, 9>, 11> kBob{{
    // the front of the left side: along the hairline as far as the temple
    {{{1.5, 6.93, 6.8},
      {2.6, 6.5, 6.25},
      {3.5, 5.65, 5.85},
      {4.25, 4.5, 5.2},
      {4.75, 3.0, 4.7},
      {4.85, 1.3, 4.6},
      {4.4, -0.8, 5.2},
      {3.55, -3, 5.6},
      {2.5, -5.1, 5.2}}},
    {{{1.5, 8.45, 5.7},
      {2.85, 8.5, 5.8},
      {4.3, 7.6, 5.2},
      {5.15, 6.1, 4.6},
      {5.5, 4.2, 4},
      {5.7, 2.1, 3.7},
      {5.6, -0.3, 3.6},
      {5.2, -2.8, 3.7},
      {3.75, -5.4, 3.95}}},
    // over the left ear
    {{{1.45, 10.1, 2.9},
      {2.85, 10.25, 2.8},
      {4.55, 8.95, 2.4},
      {5.4, 7.1, 2},
      {5.9, 5, 1.7},
      {6.25, 2.6, 1.5},
      {6.1, 0.2, 1.4},
      {5.65, -2.5, 1.6},
      {4.3, -4.9, 2.0}}},
    {{{1.25, 10.75, 0.4},
      {2.6, 10.8, 0},
      {4.3, 9.2, -0.6},
      {5.25, 7.2, -1.1},
      {5.75, 5, -1.4},
      {6, 2.6, -1.5},
      {5.85, 0.1, -1.5},
      {5.25, -2.4, -1.3},
      {4.2, -4.3, -0.9}}},
    {{{1.05, 10.6, -1.2},
      {2, 10.6, -2.2},
      {3.1, 9.2, -3.2},
      {3.75, 7.3, -4.0},
      {4.1, 5.2, -4.3},
      {4.2, 3, -4.2},
      {4.05, 0.8, -3.95},
      {3.6, -1.4, -3.4},
      {2.9, -3.5, -3.0}}},
    // the back
    {{{0.95, 10.45, -2},
      {0.75, 10.3, -3.2},
      {0.4, 9.0, -4.3},
      {0.1, 7.3, -5.3},
      {0, 5.4, -5.8},
      {0, 3.4, -5.78},
      {0, 1.2, -5.35},
      {0, -0.9, -4.55},
      {0, -2.8, -3.75}}},
    {{{1.12, 10.6, -1.2},
      {-0.2, 10.95, -2.2},
      {-2.3, 9.7, -3.1},
      {-3.6, 7.6, -4.0},
      {-4.1, 5.2, -4.3},
      {-4.2, 3, -4.2},
      {-4.05, 0.8, -3.95},
      {-3.6, -1.4, -3.4},
      {-2.9, -3.5, -3.0}}},
    {{{1.3, 10.75, 0.4},
      {-0.4, 11.2, 0.1},
      {-3.3, 10.2, -0.5},
      {-5, 7.8, -1.1},
      {-5.75, 5, -1.4},
      {-6, 2.6, -1.5},
      {-5.85, 0.1, -1.5},
      {-5.25, -2.4, -1.3},
      {-4.2, -4.3, -0.9}}},
    // over the right ear
    {{{1.46, 10.1, 2.9},
      {0, 10.95, 2.9},
      {-3, 10.3, 2.6},
      {-5.1, 8, 2.1},
      {-5.9, 5, 1.7},
      {-6.25, 2.6, 1.5},
      {-6.1, 0.2, 1.4},
      {-5.65, -2.5, 1.6},
      {-4.3, -4.9, 2.0}}},
    {{{1.5, 8.45, 5.7},
      {0.3, 9.2, 6.15},
      {-2.2, 8.8, 5.9},
      {-4.35, 7.3, 5.3},
      {-5.4, 4.5, 4.2},
      {-5.7, 2.1, 3.7},
      {-5.6, -0.3, 3.6},
      {-5.2, -2.8, 3.7},
      {-3.75, -5.4, 3.95}}},
    // the front of the right side, leaving the hairline above the temple
    {{{1.5, 6.93, 6.8},
      {-0.2, 6.95, 7.1},
      {-2.3, 6.55, 6.5},
      {-3.85, 5.2, 5.65},
      {-4.75, 3.2, 4.75},
      {-4.85, 1.4, 4.65},
      {-4.4, -0.8, 5.2},
      {-3.55, -3, 5.6},
      {-2.5, -5.1, 5.2}}},
}};

/// Short, and gone over the temples. Round the crown it never turns back, or the sheet would fold:
/// the sideburn lies behind the temple.
constexpr std::array<Key<Vec3>, 20> kRecedingHairline{
    {{0, {0, 6.75, 7.05}},      {0.4, {0.6, 6.76, 7.03}},  {1, {1.3, 6.88, 6.85}},
     {2, {2.4, 7.3, 5.95}},     {3, {3.35, 6.4, 5.45}},    {3.8, {3.85, 5.1, 5.35}},
     {4.6, {4.2, 3.7, 4.9}},    {5.2, {4.42, 2.3, 4.25}},  {5.63, {4.5, 1.0, 3.6}},
     {6, {4.55, 0.7, 3.0}},     {6.38, {4.6, 0.7, 2.2}},   {6.75, {4.65, 1.7, 1.9}},
     {7.2, {4.85, 2.3, 1.2}},   {7.7, {4.8, 1.9, 0.3}},    {8.4, {4.6, 0.3, -0.1}},
     {9.2, {4.1, -1.3, -0.8}},  {10.2, {3.0, -2.1, -2.3}}, {11.2, {1.4, -2.5, -3.4}},
     {11.6, {0.7, -2.5, -3.6}}, {12, {0, -2.45, -3.7}}}};

/// From the parting on the left, back and a little to the right.
constexpr std::array<std::array<Vec3, 5>, 6> kCombedBack{{
    {{{2.9, 7.1, 5.6}, {3.2, 8.6, 3.2}, {2.9, 9.3, 0.6}, {2.1, 9.2, -2.4}, {1.2, 7.6, -4.9}}},
    {{{1.8, 7.1, 6.5}, {1.6, 9.0, 4.2}, {0.9, 9.9, 1.2}, {-0.3, 9.5, -2.2}, {-1.4, 7.4, -4.8}}},
    {{{0.7, 6.78, 7.05}, {0.2, 9.0, 4.8}, {-1.0, 9.8, 2.0}, {-2.5, 9.0, -1.2}, {-3.5, 6.9, -3.6}}},
    {{{-0.5, 6.78, 7.0}, {-1.3, 8.8, 5.0}, {-2.7, 9.2, 2.6}, {-3.9, 8.2, 0.2}, {-4.6, 6.4, -2.0}}},
    {{{-1.6, 6.95, 6.6}, {-2.5, 8.4, 5.0}, {-3.6, 8.4, 3.3}, {-4.4, 7.4, 1.6}, {-4.8, 6.0, 0.0}}},
    {{{-2.6, 7.2, 5.8}, {-3.3, 7.7, 4.8}, {-3.9, 7.4, 3.9}, {-4.3, 6.8, 3.0}, {-4.7, 5.8, 2.0}}},
}};

/// A woman of about thirty.
Identity young_woman() {
  Identity who;
  who.name = "default";
  Form& form = who.form;
  form.narrowing = 0.070;
  form.jaw_width = 0.02;
  form.jaw_bow = 0.12;
  form.chin_width = 0.02;
  form.chin_forward = -0.12;
  form.cheek = 0.12;
  form.cheekbone = -0.14;
  form.cheek_hollow = 0.02;
  form.brow_ridge = -0.10;
  form.forehead_round = 0.45;
  form.nose_root = 0.13;
  form.neck_width = 0.85;
  form.larynx = -0.25;
  form.nose_width = 1.02;
  form.bridge_width = -0.12;
  form.nose_up = 0.13;
  form.nose_tip = -0.035;
  form.nose_forward = -0.10;
  form.upper_lip = 0.60;
  form.lower_lip = 0.82;
  form.lip_bulge = 1.15;
  form.cupids_bow = 1.2;
  form.outer_canthus_up = 0.13;
  form.socket = -0.30;
  form.upper_lid = 0.41;
  form.lower_lid = 0.465;
  form.lid_fold = 0.225;
  form.furrow = 0.022;
  form.chin_fold = 0.07;
  form.brow_up = 4.10;
  form.brow_arch = 0.42;
  form.brow_tail_drop = 0.16;
  form.brow_width = 0.27;
  form.brow_begin = 0.80;
  Haircut& hair = who.hair;
  hair.hairline = kLongHairline;
  hair.guides = kBob;
  hair.side = 0.30;
  hair.top = 0.40;
  who.lines = {.seed = 1, .depth = 0.9};
  Palette& colours = who.colours;
  colours.lip = {0.60, 0.225, 0.215};
  colours.hair = {0.115, 0.058, 0.034};
  colours.hair_light = {0.36, 0.19, 0.10};
  return who;
}

/// A man of about fifty.
Identity man_of_fifty() {
  Identity who;
  who.name = "marek";
  Form& form = who.form;
  form.narrowing = 0.03;
  form.jaw_width = -0.05;
  form.jaw_bow = 0.55;
  form.jaw_drop = 0.28;
  form.chin_width = 0.24;
  form.chin_drop = 0.22;
  form.chin_forward = 0.10;
  form.cheek = -0.10;
  form.cheekbone = 0.14;
  form.cheek_hollow = 0.155;
  form.brow_ridge = 0.13;
  form.forehead_slope = 0.25;
  form.muzzle = 0.10;
  form.throat_drop = 0.25;
  form.neck_width = 1.12;
  form.larynx = 0.12;
  form.nose_width = 1.17;
  form.bridge_width = 0.0;
  form.nose_forward = 0.16;
  form.nose_up = -0.16;
  form.nose_hump = -0.01;
  form.nose_root = 0.09;
  form.upper_lid = 0.39;
  form.inner_canthus_up = -0.14;
  form.outer_canthus_up = 0.0;
  form.lid_fold = 0.17;
  form.eye_bag = 0.032;
  form.socket = -0.16;
  form.lash = 0.45;
  form.upper_lip = 0.40;
  form.lower_lip = 0.62;
  form.lip_bulge = 0.82;
  form.cupids_bow = 0.5;
  form.corner_lift = 0.02;
  form.philtrum = 1.2;
  form.brow_up = 3.92;
  form.brow_arch = 0.30;
  form.brow_tail_drop = 0.10;
  form.brow_begin = 0.74;
  form.brow_width = 0.32;
  form.furrow = 0.07;
  form.jowl = 0.05;
  form.chin_fold = 0.14;
  who.hair = {.hairline = kRecedingHairline,
              .crown = {0.6, 9.6, 1.2},
              .combed = kCombedBack,
              .side = 0.28,
              .top = 0.64,
              .grey = true};
  who.lines = {.seed = 2, .depth = 1.12, .width = 0.94, .uneven = 0.16, .forehead_up = 0.06};
  Palette& colours = who.colours;
  colours.skin = {0.50, 0.295, 0.195};
  colours.flush = {0.50, 0.215, 0.155};
  colours.forehead_skin = {0.53, 0.325, 0.21};
  colours.neck_skin = {0.48, 0.28, 0.19};
  colours.lid_skin = {0.38, 0.20, 0.145};
  colours.lid_rim = {0.36, 0.17, 0.14};
  colours.lip = {0.44, 0.195, 0.165};
  colours.brow = {0.115, 0.100, 0.092};
  colours.hair = {0.076, 0.072, 0.069};
  colours.hair_light = {0.40, 0.388, 0.376};
  colours.iris_inner = {0.26, 0.13, 0.05};
  colours.iris_outer = {0.13, 0.065, 0.03};
  colours.cloth = {0.30, 0.055, 0.06};
  colours.collar = {0.24, 0.045, 0.05};
  colours.beard = 0.21;
  return who;
}

const std::array<Identity, 2>& identities() {
  static const std::array<Identity, 2> all{young_woman(), man_of_fifty()};
  return all;
}

}  // namespace

const Identity& default_identity() {
  return identities()[0];
}

const Identity* identity_named(std::string_view name) {
  for (const Identity& identity : identities()) {
    if (identity.name == name) return &identity;
  }
  return nullptr;
}

}  // namespace aucast::facegen
