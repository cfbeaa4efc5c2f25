#pragma once

#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/theory/levers/lever_plan.h"

namespace geargraph {

/// With more levers the bars are laid out one by one instead of by the best of all orders.
constexpr std::size_t kMaxOrderedBars = 6;

/// A lever as a vertical bar. Heights and lengths are exact, in lengths of the shortest bar, upward.
struct BarPlace {
  int lever = 0;  ///< of the plan
  Rational bottom;
  Rational length = 1;
  bool isTurnedOver = false;  ///< the end at 1 is the lower one

  [[nodiscard]] Rational heightOf(const LeverPoint& point) const {
    return bottom + length * (isTurnedOver ? Rational(1) - point.at : point.at);
  }
};

/// A point that two bars share; with three bars two ties.
struct BarTie {
  LinkOrdinal link = 0;  ///< the first at the point
  int from = 0;          ///< position in the layout
  int to = 0;            ///< a later one
  bool isLevel = true;   ///< else it runs around the bars between
};

struct LeverLayout {
  std::vector<BarPlace> bars;  ///< from left to right
  std::vector<BarTie> ties;
  Rational height;
};

/// Places the levers of a plan so that shared points are level. The order passes the fewest bars with ties,
/// then brings couplings' links near each other; bars are turned over and get lengths with which ties close
/// level and pass above or below the bars between (bar_lengths.h). Where no lengths do that, ties are given
/// up one by one. Cost: at most 128 small linear programs, of up to kMaxOrderedBars bars; of more near
/// bars^2.
[[nodiscard]] LeverLayout leverLayout(const Mechanism& mechanism, const LeverPlan& plan);

}  // namespace geargraph
