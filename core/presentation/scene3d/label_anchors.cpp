#include "core/presentation/scene3d/label_anchors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace geargraph {
namespace {

constexpr double kCell = 4;      // logical pixels
constexpr double kNarrow = 0.7;  // of a plate's radius within the part: less, and the plate stands beside it
constexpr double kStillGood = 0.5;  // of the widest place of a narrow part: an anchor with more stays

/// Whose label stands in for each cell of the map, and how deep in its part the cell lies.
class LabelMap {
 public:
  static constexpr int kNobody = -1;
  static constexpr int kGround = -2;

  explicit LabelMap(const LabelGround& ground)
      : m_map(*ground.seen), m_owners(m_map.numbers.size(), kNobody) {
    std::unordered_map<ElementId, int> labelOf;
    for (std::size_t i = 0; i < ground.stage.labels.size(); ++i) {
      const SceneLabel& label = ground.stage.labels[i];
      if (label.kind == LabelKind::link && ground.isShown(label))
        labelOf.emplace(label.element, static_cast<int>(i));
    }
    for (std::size_t cell = 0; cell < m_owners.size(); ++cell) {
      const std::uint32_t number = m_map.numbers[cell];
      if (number == 0) m_owners[cell] = kGround;
      if (number == 0 || number > ground.stage.scene.instances.size()) continue;
      const auto label = labelOf.find(ground.stage.scene.instances[number - 1].element);
      if (label != labelOf.end()) m_owners[cell] = label->second;
    }
    m_width = ground.viewport.width / ground.pixelRatio / m_map.columns;
    m_height = ground.viewport.height / ground.pixelRatio / m_map.rows;
    measureRooms();
  }

  [[nodiscard]] const VisibilityBuffer& map() const { return m_map; }
  [[nodiscard]] int owner(int column, int row) const {
    return m_map.has(column, row) ? m_owners[m_map.at(column, row)] : kNobody;
  }
  /// Logical pixels from the middle of the cell to the border of its part, about.
  [[nodiscard]] double room(int column, int row) const {
    return (m_rooms[m_map.at(column, row)] - 0.5) * std::min(m_width, m_height);
  }
  [[nodiscard]] Eigen::Vector2d middle(int column, int row) const {
    return {(column + 0.5) * m_width, (row + 0.5) * m_height};
  }
  [[nodiscard]] int columnAt(double x) const { return static_cast<int>(std::floor(x / m_width)); }
  [[nodiscard]] int rowAt(double y) const { return static_cast<int>(std::floor(y / m_height)); }

 private:
  /// Steps to the nearest cell of another part, twice through the map.
  void measureRooms() {
    m_rooms.assign(m_owners.size(), 0);
    const auto spread = [this](int column, int row, int side) {
      const int own = owner(column, row);
      int nearest = m_map.columns + m_map.rows;
      for (const auto& [right, down] : {std::pair(side, 0), std::pair(0, side)}) {
        const int x = column + right;
        const int y = row + down;
        const bool same = m_map.has(x, y) && m_owners[m_map.at(x, y)] == own;
        nearest = std::min(nearest, same ? m_rooms[m_map.at(x, y)] : 0);
      }
      return nearest + 1;
    };
    for (int row = 0; row < m_map.rows; ++row) {
      for (int column = 0; column < m_map.columns; ++column)
        m_rooms[m_map.at(column, row)] = spread(column, row, -1);
    }
    for (int row = m_map.rows - 1; row >= 0; --row) {
      for (int column = m_map.columns - 1; column >= 0; --column) {
        int& room = m_rooms[m_map.at(column, row)];
        room = std::min(room, spread(column, row, 1));
      }
    }
  }

  const VisibilityBuffer& m_map;
  std::vector<int> m_owners;
  std::vector<int> m_rooms;
  double m_width = kCell;
  double m_height = kCell;
};

/// A cell of a part.
struct Spot {
  int column = -1;
  int row = -1;
  double room = 0;
  [[nodiscard]] bool isAny() const { return column >= 0; }
};

/// By label: the cell with room for the plate that is nearest to the middle of the part; where there is none,
/// the cell with most room.
std::vector<Spot> bestSpots(const LabelGround& ground, const LabelMap& map) {
  constexpr double kFarther = 0.01;  // a pixel away from the middle counts as so much less room
  std::vector<Spot> best(ground.stage.labels.size());
  std::vector<double> scores(best.size(), 0);
  std::vector<Eigen::Vector2d> middles;
  for (const SceneLabel& label : ground.stage.labels)
    middles.push_back(ground.project(ground.middleOf(label)));
  for (int row = 0; row < map.map().rows; ++row) {
    for (int column = 0; column < map.map().columns; ++column) {
      const int owner = map.owner(column, row);
      if (owner < 0) continue;
      const auto label = static_cast<std::size_t>(owner);
      const double room = std::min(map.room(column, row), kLabelRadius);
      const double score = room - kFarther * (map.middle(column, row) - middles[label]).norm();
      if (best[label].isAny() && score <= scores[label]) continue;
      best[label] = {column, row, room};
      scores[label] = score;
    }
  }
  return best;
}

/// Where the plate of a narrow part stands: as near to it as may be, on what is no part if there is such a
/// place, clear of the other plates.
class SideFinder {
 public:
  explicit SideFinder(const LabelGround& ground, const LabelMap& map)
      : m_map(map),
        m_width(ground.viewport.width / ground.pixelRatio),
        m_height(ground.viewport.height / ground.pixelRatio) {}

  void take(const Eigen::Vector2d& plate) { m_taken.push_back(plate); }

  /// From the anchor to the plate; `before`: where it stood in the last picture.
  Eigen::Vector2d find(const Eigen::Vector2d& anchor, const Eigen::Vector2d& before) {
    constexpr int kDirections = 16;
    constexpr double kPerPixel = 0.12, kMoved = 1;
    Eigen::Vector2d best(0, 0);
    double least = std::numeric_limits<double>::infinity();
    for (const double gap : {6.0, 16.0, 28.0, 42.0}) {
      for (int i = 0; i < kDirections; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / kDirections;
        const Eigen::Vector2d away = (kLabelRadius + gap) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        const double moved = (away - before).norm() < 1 ? 0 : kMoved;
        const double cost = covered(anchor + away) + kPerPixel * gap + moved;
        if (cost >= least) continue;
        least = cost;
        best = away;
      }
    }
    take(anchor + best);
    return best;
  }

 private:
  /// What a plate here would lie on: cells of parts, and other plates.
  [[nodiscard]] double covered(const Eigen::Vector2d& plate) const {
    constexpr double kPlate = 20, kOutside = 100;
    const double reach = kLabelRadius + 2;
    if (plate.x() < reach || plate.y() < reach || plate.x() > m_width - reach || plate.y() > m_height - reach)
      return kOutside;
    double cost = 0;
    for (const Eigen::Vector2d& other : m_taken) {
      if ((other - plate).norm() < 2 * kLabelRadius + 2) cost += kPlate;
    }
    for (int row = m_map.rowAt(plate.y() - reach); row <= m_map.rowAt(plate.y() + reach); ++row) {
      for (int column = m_map.columnAt(plate.x() - reach); column <= m_map.columnAt(plate.x() + reach);
           ++column) {
        const bool within = (m_map.middle(column, row) - plate).norm() < reach;
        if (within && m_map.owner(column, row) != LabelMap::kGround) cost += 1;
      }
    }
    return cost;
  }

  const LabelMap& m_map;
  double m_width;
  double m_height;
  std::vector<Eigen::Vector2d> m_taken;
};

/// Where the anchor stands now, if that still shows enough of the label's link.
Spot spotOf(const LabelGround& ground, const LabelMap& map, std::size_t label, const LabelAnchor& anchor,
            double bestRoom) {
  const Eigen::Vector2d at = ground.project(ground.middleOf(ground.stage.labels[label]) + anchor.off);
  Spot spot{map.columnAt(at.x()), map.rowAt(at.y()), 0};
  if (map.owner(spot.column, spot.row) != static_cast<int>(label)) return {};
  spot.room = std::min(map.room(spot.column, spot.row), kLabelRadius);
  const bool isWide = spot.room >= kNarrow * kLabelRadius;
  const bool isAsGoodAsAny = bestRoom < kNarrow * kLabelRadius && spot.room >= kStillGood * bestRoom;
  return isWide || isAsGoodAsAny ? spot : Spot{};
}

}  // namespace

Viewport labelCells(const Viewport& viewport, double pixelRatio) {
  const auto cells = [&](int pixels) {
    return std::clamp(static_cast<int>(std::lround(pixels / (kCell * pixelRatio))), 1, 1024);
  };
  return {cells(viewport.width), cells(viewport.height)};
}

void LabelAnchors::renew(const LabelGround& ground) {
  const std::map<ElementId, LabelAnchor> before = std::exchange(m_anchors, {});
  m_areNew = false;
  if (ground.seen->numbers.empty()) return;
  const LabelMap map(ground);
  const std::vector<Spot> best = bestSpots(ground, map);
  SideFinder sides(ground, map);
  std::vector<std::size_t> narrow;
  for (std::size_t i = 0; i < best.size(); ++i) {
    if (!best[i].isAny()) continue;
    const SceneLabel& label = ground.stage.labels[i];
    const auto known = before.find(label.element);
    LabelAnchor anchor = known == before.end() ? LabelAnchor() : known->second;
    Spot spot = known == before.end() ? Spot() : spotOf(ground, map, i, anchor, best[i].room);
    if (!spot.isAny()) {
      spot = best[i];
      anchor.off = map.map().point(spot.column, spot.row) - ground.middleOf(label);
    }
    if (spot.room < kNarrow * kLabelRadius) {
      narrow.push_back(i);
    } else {
      anchor.away = {0, 0};
      sides.take(ground.project(ground.middleOf(label) + anchor.off));
    }
    m_anchors.emplace(label.element, anchor);
  }
  for (const std::size_t i : narrow) {
    const SceneLabel& label = ground.stage.labels[i];
    LabelAnchor& anchor = m_anchors.at(label.element);
    anchor.away = sides.find(ground.project(ground.middleOf(label) + anchor.off), anchor.away);
  }
}

}  // namespace geargraph
