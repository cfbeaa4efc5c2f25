#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace geargraph {

/// The share of the tolerance for flanks: in a mesh the chordal errors of both gears add up as transmission
/// error.
constexpr double kFlankShare = 0.5;

/// Arcs shorter than this (modules) get no points of their own: rounded to floats these could coincide.
constexpr double kShortestArc = 1e-4;

/// The number of chords for an arc of `angle` (rad) with a chordal error of at most `tolerance` (a length).
[[nodiscard]] inline int chordsOfArc(double angle, double radius, double tolerance) {
  if (radius <= tolerance) return std::max(1, static_cast<int>(std::ceil(angle)));
  const double step = 2 * std::acos(1 - tolerance / radius);
  return std::max(1, static_cast<int>(std::ceil(std::abs(angle) / step - 1e-9)));
}

/// The root of a function with opposite signs at `low` and `high`, by 60 bisections.
template <class Function>
[[nodiscard]] double bisect(double low, double high, const Function& f) {
  const bool lowPositive = f(low) > 0;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    ((f(middle) > 0) == lowPositive ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Parameters from `from` to `to` (both included) that cut a plane curve into chords of equal sagitta, none
/// above `tolerance`. `pointAt(t)` returns a point with members x, y. Sagitta of a chord is ds * dtheta / 8,
/// so the curve is divided evenly by the integral of sqrt(ds dtheta).
template <class PointAt>
[[nodiscard]] std::vector<double> equalSagitta(double from, double to, double tolerance,
                                               const PointAt& pointAt) {
  constexpr int kProbes = 24;
  double x[kProbes + 1];
  double y[kProbes + 1];
  for (int i = 0; i <= kProbes; ++i) {
    const auto p = pointAt(from + (to - from) * i / kProbes);
    x[i] = p.x;
    y[i] = p.y;
  }
  double measure[kProbes + 1] = {0};  // integral up to probe i
  double turns[kProbes + 1] = {0};    // turning angle at the inner probes
  for (int i = 1; i < kProbes; ++i) {
    const double ax = x[i] - x[i - 1], ay = y[i] - y[i - 1], bx = x[i + 1] - x[i], by = y[i + 1] - y[i];
    turns[i] = std::abs(std::atan2(ax * by - ay * bx, ax * bx + ay * by));
  }
  turns[0] = turns[1];
  turns[kProbes] = turns[kProbes - 1];
  for (int i = 0; i < kProbes; ++i) {
    const double length = std::hypot(x[i + 1] - x[i], y[i + 1] - y[i]);
    measure[i + 1] = measure[i] + std::sqrt(length * 0.5 * (turns[i] + turns[i + 1]));
  }
  const double total = measure[kProbes];
  const int chords = std::max(1, static_cast<int>(std::ceil(total / std::sqrt(8 * tolerance))));
  std::vector<double> result{from};
  int probe = 0;
  for (int c = 1; c < chords; ++c) {
    const double goal = total * c / chords;
    while (probe < kProbes - 1 && measure[probe + 1] < goal) ++probe;
    const double part = (goal - measure[probe]) / std::max(measure[probe + 1] - measure[probe], 1e-300);
    result.push_back(from + (to - from) * (probe + part) / kProbes);
  }
  result.push_back(to);
  return result;
}

}  // namespace geargraph
