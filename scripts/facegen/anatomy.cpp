#include "scripts/facegen/anatomy.h"

namespace aucast::facegen {
namespace {

/// How far along the eye, 0 at the inner corner and 1 at the outer one.
double along_eye(double dx) {
  return saturate((dx - kInnerCanthus) / (kOuterCanthus - kInnerCanthus));
}

/// From corner to corner. The outer one lies higher, which looks friendly.
double canthal_line(const Identity& who, double t) {
  return mix(who.form.inner_canthus_up, who.form.outer_canthus_up, t);
}

}  // namespace

Vec3 eye_centre(const Form& form) {
  return {form.eye_apart, 2.72, 6.14};
}

NeckRope neck_rope(const Form& form) {
  const double wide = form.neck_width;
  return {{2.75 * wide, -0.6, 0.4}, {0.95 * wide, -10.8, 3.3 * wide - 1.85}};
}

double upper_lid(const Identity& who, double dx) {
  const double t = along_eye(dx);
  // The lid covers the top of the iris; with a higher arch the eye stares. It rises more over the
  // corners than the lower lid falls: as much, and a narrowed eye is a straight slot.
  return canthal_line(who, t) + who.form.upper_lid * power(std::sin(kPi * power(t, 0.80)), 0.90);
}

double lower_lid(const Identity& who, double dx) {
  const double t = along_eye(dx);
  return canthal_line(who, t) - who.form.lower_lid * power(std::sin(kPi * power(t, 1.30)), 0.88);
}

double lid_fold(const Identity& who, double dx) {
  return upper_lid(who, dx) + who.form.lid_fold + 0.03 * dx;
}

double lip_contact(const Identity& who, double x) {
  const double t = saturate(x / kMouthCorner);
  // The last term lifts the corners to a trace of a smile.
  return -2.33 - 0.030 * bell(x, 0.30) + 0.035 * bell(x - 0.6, 0.45) - 0.02 * t +
         who.form.corner_lift * t * t * t;
}

double upper_lip_border(const Identity& who, double x) {
  const double t = saturate(x / kMouthCorner);
  const double height = who.form.upper_lip * power(1 - t, 0.75) * (1 + 0.15 * t);
  const double cupids_bow = who.form.cupids_bow * (-0.085 * bell(x, 0.20) +
                                                   0.07 * bell(x - kPhiltrumRidge, 0.24) * (1 - t));
  return lip_contact(who, x) + height + cupids_bow;
}

double lower_lip_border(const Identity& who, double x) {
  const double t = saturate(x / kMouthCorner);
  return lip_contact(who, x) - who.form.lower_lip * power(1 - t * t, 0.85);
}

Vec3 brow_spine(const Identity& who, double t) {
  // It rises from the nose to two thirds of its way; an inner end as high as the middle pleads.
  const double arch = who.form.brow_arch * power(std::sin(saturate(t / 0.95) * 2.2), 1.2);
  return {mix(who.form.brow_begin, 3.70, t),
          who.form.brow_up + arch - who.form.brow_tail_drop * t * t * t, 0.0};
}

double brow_half_width(const Identity& who, double t) {
  return who.form.brow_width * (1 - 0.74 * power(t, 1.7)) * smooth_step(-0.24, 0.34, t);
}

}  // namespace aucast::facegen
