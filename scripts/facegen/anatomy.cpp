#include "scripts/facegen/anatomy.h"

namespace aucast::facegen {
namespace {

/// How far along the eye, 0 at the inner corner and 1 at the outer one.
double along_eye(double dx) {
  return saturate((dx - kInnerCanthus) / (kOuterCanthus - kInnerCanthus));
}

/// From corner to corner. The outer one lies higher, which looks friendly.
double canthal_line(double t) {
  return mix(-0.17, 0.10, t);
}

}  // namespace

double upper_lid(double dx) {
  const double t = along_eye(dx);
  // The lid covers the top of the iris; with a higher arch the eye stares.
  return canthal_line(t) + 0.52 * power(std::sin(kPi * power(t, 0.80)), 0.78);
}

double lower_lid(double dx) {
  const double t = along_eye(dx);
  return canthal_line(t) - 0.42 * power(std::sin(kPi * power(t, 1.22)), 0.90);
}

double lip_contact(double x) {
  const double t = saturate(x / kMouthCorner);
  // The last term lifts the corners to a trace of a smile.
  return -2.33 - 0.040 * bell(x, 0.30) + 0.035 * bell(x - 0.6, 0.45) - 0.02 * t + 0.09 * t * t * t;
}

double upper_lip_border(double x) {
  const double t = saturate(x / kMouthCorner);
  const double height = 0.552 * power(1 - t, 0.75) * (1 + 0.15 * t);
  const double cupids_bow = -0.085 * bell(x, 0.20) + 0.07 * bell(x - 0.36, 0.24) * (1 - t);
  return lip_contact(x) + height + cupids_bow;
}

double lower_lip_border(double x) {
  const double t = saturate(x / kMouthCorner);
  return lip_contact(x) - 0.74 * power(1 - t * t, 0.85);
}

Vec3 brow_spine(double t) {
  const double arch = 0.46 * std::sin(std::min(1.0, t * 1.05) * 2.2);
  return {mix(0.78, 3.55, t), 4.05 + arch - 0.30 * t * t * t, 0.0};
}

double brow_half_width(double t) {
  return 0.30 * (1 - 0.80 * power(t, 1.5)) * smooth_step(-0.10, 0.16, t);
}

}  // namespace aucast::facegen
