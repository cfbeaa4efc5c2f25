#include "core/presentation/diagrams/lever_layout.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <optional>

#include "core/foundations/base/position_index.h"
#include "core/presentation/diagrams/bar_lengths.h"

namespace geargraph {
namespace {

using Order = std::vector<int>;  ///< levers from left to right

/// Finds order, sides and lengths of the bars of one plan.
class BarArranger {
 public:
  BarArranger(const Mechanism& mechanism, const LeverPlan& plan) : m_plan(plan) {
    std::map<int, std::vector<int>> leversOf;  // by the first link of a point
    for (std::size_t lever = 0; lever < plan.levers.size(); ++lever) {
      for (const LeverPoint& point : plan.levers[lever].points)
        leversOf[point.links.front()].push_back(static_cast<int>(lever));
    }
    for (const auto& [link, levers] : leversOf) {
      if (levers.size() > 1) m_shared.push_back({link, levers});
    }
    const PositionIndex<LinkTag> linkAt(mechanism.links);
    for (const ShiftElement& coupling : mechanism.couplings) {
      if (coupling.kind != ShiftElementKind::brake)
        m_clutches.emplace_back(leversWith(linkAt.at(coupling.links[0])),
                                leversWith(linkAt.at(coupling.links[1])));
    }
  }

  LeverLayout arranged() {
    if (m_plan.levers.size() > kMaxOrderedBars) return placedOneByOne(greedyOrder());
    const Order order = bestOrder();
    std::vector<BarTie> ties = tiesOf(order);
    std::vector<BarTie> given;
    while (true) {
      if (auto layout = withLevelTies(order, ties)) {
        layout->ties.insert(layout->ties.end(), given.begin(), given.end());
        return *std::move(layout);
      }
      // The tie past the most bars is given up first; without ties any lengths will do.
      const auto longest = std::max_element(ties.begin(), ties.end(), [](const BarTie& a, const BarTie& b) {
        return a.to - a.from < b.to - b.from;
      });
      given.push_back(*longest);
      given.back().isLevel = false;
      ties.erase(longest);
    }
  }

 private:
  struct Shared {
    LinkOrdinal link = 0;
    std::vector<int> levers;
  };

  [[nodiscard]] std::vector<int> leversWith(LinkOrdinal link) const {
    std::vector<int> levers;
    for (std::size_t lever = 0; lever < m_plan.levers.size(); ++lever) {
      if (m_plan.levers[lever].pointOf(link) != nullptr) levers.push_back(static_cast<int>(lever));
    }
    return levers;
  }

  /// Bars passed by ties, then the way between the links of clutches.
  [[nodiscard]] std::pair<int, int> costOf(const Order& order) const {
    std::vector<int> placeOf(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      placeOf[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    const auto place = [&](int lever) { return placeOf[static_cast<std::size_t>(lever)]; };
    int passed = 0;
    for (const Shared& shared : m_shared) {
      std::vector<int> places;
      for (const int lever : shared.levers) places.push_back(place(lever));
      const auto [first, last] = std::minmax_element(places.begin(), places.end());
      passed += *last - *first + 1 - static_cast<int>(places.size());
    }
    int way = 0;
    for (const auto& [ones, others] : m_clutches) {
      int nearest = ones.empty() || others.empty() ? 0 : static_cast<int>(order.size());
      for (const int one : ones) {
        for (const int other : others) nearest = std::min(nearest, std::abs(place(one) - place(other)));
      }
      way += nearest;
    }
    return {passed, way};
  }

  [[nodiscard]] Order bestOrder() const {
    Order order(m_plan.levers.size());
    std::iota(order.begin(), order.end(), 0);
    Order best = order;
    auto cost = costOf(best);
    while (std::next_permutation(order.begin(), order.end())) {
      if (const auto other = costOf(order); other < cost) {
        best = order;
        cost = other;
      }
    }
    return best;
  }

  /// Each next bar is the one that shares the most points with those before.
  [[nodiscard]] Order greedyOrder() const {
    Order order;
    std::vector<int> left(m_plan.levers.size());
    std::iota(left.begin(), left.end(), 0);
    while (!left.empty()) {
      const auto sharedWithPlaced = [&](int lever) {
        return std::count_if(m_shared.begin(), m_shared.end(), [&](const Shared& shared) {
          const auto has = [&](int each) {
            return std::find(shared.levers.begin(), shared.levers.end(), each) != shared.levers.end();
          };
          return has(lever) && std::any_of(order.begin(), order.end(), has);
        });
      };
      const auto next = std::max_element(
          left.begin(), left.end(), [&](int a, int b) { return sharedWithPlaced(a) < sharedWithPlaced(b); });
      order.push_back(*next);
      left.erase(next);
    }
    return order;
  }

  [[nodiscard]] std::vector<BarTie> tiesOf(const Order& order) const {
    std::vector<BarTie> ties;
    for (const Shared& shared : m_shared) {
      int last = -1;
      for (std::size_t i = 0; i < order.size(); ++i) {
        if (std::find(shared.levers.begin(), shared.levers.end(), order[i]) == shared.levers.end()) continue;
        if (last >= 0) ties.push_back({shared.link, last, static_cast<int>(i)});
        last = static_cast<int>(i);
      }
    }
    return ties;
  }

  [[nodiscard]] BarSpot spotOf(const Order& order, const std::vector<char>& isTurned, int bar,
                               LinkOrdinal link) const {
    const auto at = static_cast<std::size_t>(bar);
    const Rational& part = m_plan.levers[static_cast<std::size_t>(order[at])].pointOf(link)->at;
    return {bar, isTurned[at] != 0 ? Rational(1) - part : part};
  }

  /// The best layout with these ties level, over the sides of bars and of passing ties. None of more than
  /// kMaxTried choices.
  [[nodiscard]] std::optional<LeverLayout> withLevelTies(const Order& order,
                                                         const std::vector<BarTie>& ties) const {
    constexpr std::size_t kMaxTried = 128;
    std::vector<std::pair<std::size_t, int>> passes;  // tie, bar
    for (std::size_t tie = 0; tie < ties.size(); ++tie) {
      for (int bar = ties[tie].from + 1; bar < ties[tie].to; ++bar) passes.emplace_back(tie, bar);
    }
    std::vector<int> free;  // bars whose side matters: tied to one before them
    for (int bar = 1; bar < static_cast<int>(order.size()); ++bar) {
      if (std::any_of(ties.begin(), ties.end(),
                      [&](const BarTie& tie) { return tie.to == bar || tie.from == bar; }))
        free.push_back(bar);
    }
    const std::size_t bits = free.size() + passes.size();
    if (bits >= 32 || (std::size_t{1} << bits) > kMaxTried) {
      return std::nullopt;
    }
    std::optional<BarLengths> best;
    std::vector<char> bestSides;
    for (std::size_t choice = 0; choice < std::size_t{1} << bits; ++choice) {
      std::vector<char> sides(order.size(), 0);
      for (std::size_t i = 0; i < free.size(); ++i)
        sides[static_cast<std::size_t>(free[i])] = (choice >> i & 1U) != 0 ? 1 : 0;
      BarDemands demands = demandsOf(order, ties, sides);
      for (std::size_t i = 0; i < passes.size(); ++i) {
        const BarTie& tie = ties[passes[i].first];
        demands.passes.push_back({spotOf(order, sides, tie.from, tie.link), passes[i].second,
                                  (choice >> (free.size() + i) & 1U) == 0});
      }
      auto lengths = barLengths(demands);
      if (!lengths || (best && !(costOf(*lengths) < costOf(*best)))) continue;
      best = std::move(lengths);
      bestSides = std::move(sides);
    }
    if (!best) return std::nullopt;
    return layoutOf(order, ties, *best, bestSides);
  }

  [[nodiscard]] BarDemands demandsOf(const Order& order, const std::vector<BarTie>& ties,
                                     const std::vector<char>& sides) const {
    BarDemands demands;
    demands.bars = static_cast<int>(order.size());
    for (const BarTie& tie : ties)
      demands.level.emplace_back(spotOf(order, sides, tie.from, tie.link),
                                 spotOf(order, sides, tie.to, tie.link));
    return demands;
  }

  /// Many bars: all of one length, each level with the first bar before it that shares a point, on the side
  /// that leads less far away. Ties that are not level then, or would run through a bar, run around.
  [[nodiscard]] LeverLayout placedOneByOne(const Order& order) const {
    LeverLayout layout;
    layout.ties = tiesOf(order);
    const auto pointAt = [&](int bar, LinkOrdinal link) -> const LeverPoint& {
      return *m_plan.levers[static_cast<std::size_t>(order[static_cast<std::size_t>(bar)])].pointOf(link);
    };
    for (int bar = 0; bar < static_cast<int>(order.size()); ++bar) {
      BarPlace place{order[static_cast<std::size_t>(bar)], 0, 1, false};
      const auto tie = std::find_if(layout.ties.begin(), layout.ties.end(),
                                    [&](const BarTie& each) { return each.to == bar; });
      if (tie != layout.ties.end()) {
        const Rational level =
            layout.bars[static_cast<std::size_t>(tie->from)].heightOf(pointAt(tie->from, tie->link));
        BarPlace turned = place;
        turned.isTurnedOver = true;
        place.bottom = level - place.heightOf(pointAt(bar, tie->link));
        turned.bottom = level - turned.heightOf(pointAt(bar, tie->link));
        if (turned.bottom.abs() < place.bottom.abs()) place = turned;
      }
      layout.bars.push_back(place);
    }
    Rational lowest;
    for (const BarPlace& bar : layout.bars) lowest = std::min(lowest, bar.bottom);
    for (BarPlace& bar : layout.bars) {
      bar.bottom -= lowest;
      layout.height = std::max(layout.height, bar.bottom + bar.length);
    }
    for (BarTie& tie : layout.ties) {
      const Rational level =
          layout.bars[static_cast<std::size_t>(tie.from)].heightOf(pointAt(tie.from, tie.link));
      tie.isLevel =
          level == layout.bars[static_cast<std::size_t>(tie.to)].heightOf(pointAt(tie.to, tie.link)) &&
          std::none_of(
              layout.bars.begin() + tie.from + 1, layout.bars.begin() + tie.to,
              [&](const BarPlace& bar) { return bar.bottom <= level && level <= bar.bottom + bar.length; });
    }
    return layout;
  }

  [[nodiscard]] static std::pair<Rational, Rational> costOf(const BarLengths& lengths) {
    Rational sum;
    for (const Rational& length : lengths.lengths) sum += length;
    return {lengths.height, sum};
  }

  [[nodiscard]] static LeverLayout layoutOf(const Order& order, const std::vector<BarTie>& ties,
                                            const BarLengths& lengths, const std::vector<char>& sides) {
    LeverLayout layout;
    for (std::size_t i = 0; i < order.size(); ++i)
      layout.bars.push_back({order[i], lengths.bottoms[i], lengths.lengths[i], sides[i] != 0});
    layout.ties = ties;
    layout.height = lengths.height;
    return layout;
  }

  const LeverPlan& m_plan;
  std::vector<Shared> m_shared;
  std::vector<std::pair<std::vector<int>, std::vector<int>>>
      m_clutches;  ///< levers with the one, the other link
};

}  // namespace

LeverLayout leverLayout(const Mechanism& mechanism, const LeverPlan& plan) {
  if (plan.levers.empty()) return {};
  return BarArranger(mechanism, plan).arranged();
}

}  // namespace geargraph
