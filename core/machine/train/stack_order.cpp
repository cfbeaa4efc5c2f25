#include "core/machine/train/stack_order.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace geargraph {
namespace {

constexpr std::size_t kMaxPermuted = 6;

/// What a link spans on an axis, and where it has something.
struct Spanned {
  double low = 1e300;
  double high = -1e300;
  std::vector<double> at;

  void add(double height) {
    low = std::min(low, height);
    high = std::max(high, height);
    at.push_back(height);
  }
};

using SpansOfAxis = std::map<int, Spanned>;  // by link

/// `same`: what rounding leaves between heights that are one.
int enclosed(const SpansOfAxis& links, double same) {
  int count = 0;
  for (const auto& [link, spanned] : links) {
    const Spanned& span = spanned;
    for (const auto& [other, spanOfOther] : links) {
      if (other == link) continue;
      count += static_cast<int>(std::count_if(spanOfOther.at.begin(), spanOfOther.at.end(), [&](double z) {
        return span.low + same < z && z < span.high - same;
      }));
    }
  }
  return count;
}

/// A stack, better the less it encloses, then the lower it is, then the shorter its shafts are.
struct OrderVerdict {
  int enclosed = 0;
  double height = 0;
  double shafts = 0;
};

bool isBetter(const OrderVerdict& a, const OrderVerdict& b) {
  constexpr double kSame = 1e-9;
  if (a.enclosed != b.enclosed) return a.enclosed < b.enclosed;
  if (std::abs(a.height - b.height) > kSame * b.height) return a.height < b.height;
  return a.shafts < b.shafts - kSame * b.shafts;
}

class Stack {
 public:
  explicit Stack(const StackPlanes& planes) : m_planes(planes), m_same(1e-9 * planes.gap) {}

  /// Each plane on top of those before it that it meets.
  [[nodiscard]] std::vector<double> heightsOf(const std::vector<std::size_t>& order) const {
    std::vector<double> heights(order.size(), 0);
    for (std::size_t i = 1; i < order.size(); ++i) {
      double& height = heights[order[i]];
      for (std::size_t k = 0; k < i; ++k) {
        if (!m_planes.meets[order[i]][order[k]]) continue;
        const double apart = (m_planes.thickness[order[i]] + m_planes.thickness[order[k]]) / 2 + m_planes.gap;
        height = std::max(height, heights[order[k]] + apart);
      }
    }
    return heights;
  }

  [[nodiscard]] std::map<int, SpansOfAxis> spansOf(const std::vector<double>& heights) const {
    std::map<int, SpansOfAxis> axes;
    for (const StackPlanes::Wheel& wheel : m_planes.wheels)
      axes[wheel.axisGroup][wheel.link].add(heights[static_cast<std::size_t>(wheel.plane)] + wheel.offset);
    for (const StackPlanes::Carrier& carrier : m_planes.carriers)
      addArm(axes[carrier.axisGroup], carrier, heights);
    return axes;
  }

  [[nodiscard]] OrderVerdict verdictOf(const std::vector<double>& heights) const {
    OrderVerdict verdict;
    const std::map<int, SpansOfAxis> axes = spansOf(heights);
    for (const StackPlanes::BlockedPlane& cover : m_planes.covers) {
      const auto axis = axes.find(cover.axisGroup);
      if (axis == axes.end()) continue;
      const double z = heights[static_cast<std::size_t>(cover.plane)] + cover.offset;
      verdict.enclosed +=
          static_cast<int>(std::count_if(axis->second.begin(), axis->second.end(), [&](const auto& entry) {
            return entry.second.low + m_same < z && z < entry.second.high - m_same;
          }));
    }
    for (const auto& [axis, links] : axes) {
      verdict.enclosed += enclosed(links, m_same);
      for (const auto& [link, span] : links) verdict.shafts += span.high - span.low;
    }
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    verdict.height = *high - *low;
    return verdict;
  }

 private:
  /// On the side of what it carries where it is in nobody's way, the lower one first.
  void addArm(SpansOfAxis& axis, const StackPlanes::Carrier& carrier,
              const std::vector<double>& heights) const {
    if (carrier.planes.empty()) return;
    double low = 1e300, high = -1e300;
    for (const int plane : carrier.planes) {
      const auto p = static_cast<std::size_t>(plane);
      const double half = (m_planes.thickness[p] + m_planes.gap) / 2;
      low = std::min(low, heights[p] - half);
      high = std::max(high, heights[p] + half);
    }
    SpansOfAxis below = axis, above = axis;
    below[carrier.link].add(low);
    above[carrier.link].add(high);
    axis = enclosed(above, m_same) < enclosed(below, m_same) ? std::move(above) : std::move(below);
  }

  const StackPlanes& m_planes;
  double m_same;
};

/// Every order.
std::vector<double> bestOfAll(const Stack& stack, std::vector<std::size_t> order,
                              const std::stop_token& stop) {
  std::vector<double> best = stack.heightsOf(order);
  OrderVerdict least = stack.verdictOf(best);
  while (!stop.stop_requested() && std::next_permutation(order.begin(), order.end())) {
    std::vector<double> heights = stack.heightsOf(order);
    const OrderVerdict verdict = stack.verdictOf(heights);
    if (!isBetter(verdict, least)) continue;
    least = verdict;
    best = std::move(heights);
  }
  return best;
}

std::vector<double> bestByMoves(const Stack& stack, std::vector<std::size_t> order,
                                const std::stop_token& stop) {
  std::vector<double> best = stack.heightsOf(order);
  OrderVerdict least = stack.verdictOf(best);
  for (bool moves = true; moves;) {
    moves = false;
    for (std::size_t from = 0; from < order.size(); ++from) {
      for (std::size_t to = 0; to < order.size(); ++to) {
        if (to == from) continue;
        if (stop.stop_requested()) return best;
        std::vector<std::size_t> other = order;
        const std::size_t plane = other[from];
        other.erase(other.begin() + static_cast<std::ptrdiff_t>(from));
        other.insert(other.begin() + static_cast<std::ptrdiff_t>(to), plane);
        std::vector<double> heights = stack.heightsOf(other);
        const OrderVerdict verdict = stack.verdictOf(heights);
        if (!isBetter(verdict, least)) continue;
        least = verdict;
        best = std::move(heights);
        order = std::move(other);
        moves = true;
      }
    }
  }
  return best;
}

}  // namespace

int enclosedCount(const StackPlanes& planes, const std::vector<double>& heights) {
  return Stack(planes).verdictOf(heights).enclosed;
}

std::vector<double> stackedHeights(const StackPlanes& planes, const std::stop_token& stop) {
  std::vector<std::size_t> order(planes.thickness.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const Stack stack(planes);
  return order.size() <= kMaxPermuted ? bestOfAll(stack, order, stop) : bestByMoves(stack, order, stop);
}

}  // namespace geargraph
