#include "core/presentation/schematic/drawn_train.h"

#include <algorithm>
#include <utility>

#include "core/machine/body_layout/derived_geometry.h"

namespace geargraph {
namespace {

constexpr int kNotDrawn = -2;  ///< -1 is an occupied interval of no link

/// By position in the document: the position in the part.
using Positions = std::vector<int>;

int drawnAt(const Positions& positions, int position) {
  return position < 0 ? position : positions[static_cast<std::size_t>(position)];
}

Positions positionsIn(const std::vector<int>& labels, int firstLabel, std::size_t count) {
  Positions positions(count, kNotDrawn);
  for (std::size_t i = 0; i < labels.size(); ++i)
    positions[static_cast<std::size_t>(labels[i] - firstLabel)] = static_cast<int>(i);
  return positions;
}

/// Takes what the part draws out of the whole train.
class TrainFilter {
 public:
  TrainFilter(const DrawnPart& part, const DerivedGeometry& document)
      : m_part(part),
        m_whole(document.placement()),
        m_axes(document.mechanism().axes),
        m_links(positionsIn(part.linkLabels, 0, document.mechanism().links.size())),
        m_joints(positionsIn(part.jointLabels, document.mechanism().jointLabel(0),
                             document.mechanism().turningJoints.size())),
        m_meshes(positionsIn(part.meshLabels, document.mechanism().meshLabel(0),
                             document.mechanism().gearMeshes.size())) {}

  DrawnTrain take(const TrainWheels& wheels, const Arrangement& arrangement) {
    takePlacement();
    takeWheels(wheels);
    takeArrangement(arrangement);
    return std::move(m_train);
  }

 private:
  void takePlacement() {
    m_train.placement = placementOf(m_part.mechanism);
    for (std::size_t a = 0; a < m_part.mechanism.axes.size(); ++a) {
      const auto isSame = [&](const Axis& axis) { return axis.id == m_part.mechanism.axes[a].id; };
      const auto found = std::find_if(m_axes.begin(), m_axes.end(), isSame);
      m_train.placement.axes[a] = m_whole.axes[found - m_axes.begin()];
    }
    m_classes.assign(m_whole.classes->classes.size(), kNotDrawn);
    for (std::size_t j = 0; j < m_joints.size(); ++j) {
      if (m_joints[j] >= 0)
        m_classes[static_cast<std::size_t>(m_whole.classes->classOf[j])] =
            m_train.placement.classes->classOf[m_joints[j]];
    }
  }

  void takeWheels(const TrainWheels& whole) {
    m_gears.assign(whole.wheels.size(), kNotDrawn);
    for (std::size_t w = 0; w < whole.wheels.size(); ++w) {
      TrainWheel wheel = whole.wheels[w];
      wheel.link = drawnAt(m_links, wheel.link);
      wheel.axisGroup = drawnAt(m_classes, wheel.axisGroup);
      if (wheel.link < 0 || wheel.axisGroup < 0) continue;
      std::size_t kept = 0;
      for (std::size_t m = 0; m < wheel.meshes.size(); ++m) {
        const int mesh = drawnAt(m_meshes, wheel.meshes[m]);
        if (mesh < 0) continue;
        wheel.meshes[kept] = mesh;
        wheel.planes[kept++] = wheel.planes[m];
      }
      wheel.meshes.resize(kept);
      wheel.planes.resize(kept);
      if (kept == 0) continue;
      m_gears[w] = static_cast<int>(m_train.wheels.wheels.size());
      m_train.wheels.wheels.push_back(std::move(wheel));
    }
    for (TrainPair pair : whole.pairs) {
      pair.mesh = drawnAt(m_meshes, pair.mesh);
      if (pair.mesh < 0) continue;
      pair.tail = drawnAt(m_gears, pair.tail);
      pair.head = drawnAt(m_gears, pair.head);
      m_train.wheels.pairs.push_back(pair);
    }
  }

  /// Renumbers; false if it is not drawn.
  template <class At>
  [[nodiscard]] bool take(const Positions& positions, At& position) const {
    position = drawnAt(positions, position);
    return position >= 0;
  }

  void takeArrangement(const Arrangement& whole) {
    Arrangement& drawn = m_train.arrangement;
    drawn.isSimple = whole.isSimple;
    drawn.axes.resize(m_train.placement.classes->classes.size());
    drawn.shaftsOn.resize(drawn.axes.size());
    for (std::size_t c = 0; c < whole.axes.size(); ++c) {
      if (m_classes[c] >= 0) drawn.axes[m_classes[c]] = axisOf(whole.axes[c]);
    }
    for (ShaftSegment shaft : whole.shafts) {
      if (!take(m_links, shaft.link) || !take(m_classes, shaft.axisGroup)) continue;
      drawn.shaftsOn[shaft.axisGroup].push_back(drawn.shafts.size());
      drawn.shafts.push_back(shaft);
    }
    for (ArmPlan arm : whole.arms) {
      if (take(m_links, arm.link) && take(m_links, arm.child) && take(m_classes, arm.from) &&
          take(m_classes, arm.to))
        drawn.arms.push_back(arm);
    }
    for (RingCarrierPlan ringCarrier : whole.ringCarriers) {
      if (take(m_gears, ringCarrier.gear)) drawn.ringCarriers.push_back(ringCarrier);
    }
    for (WallPlan wall : whole.walls) {
      if (take(m_links, wall.link) && take(m_classes, wall.axisGroup)) drawn.walls.push_back(wall);
    }
    for (PinPlan pin : whole.pins) {
      if (pin.home >= 0 && !take(m_classes, pin.home)) continue;
      if (take(m_links, pin.link) && take(m_classes, pin.axisGroup)) drawn.pins.push_back(pin);
    }
    for (CrossShaftBossPlan boss : whole.crossShaftBosses) {
      if (take(m_links, boss.link) && take(m_links, boss.child) && take(m_classes, boss.home) &&
          take(m_classes, boss.axisGroup))
        drawn.crossShaftBosses.push_back(boss);
    }
  }

  [[nodiscard]] AxisLayout axisOf(AxisLayout axis) const {
    for (std::vector<Interval>* all : {&axis.wheels, &axis.occupied}) {
      std::erase_if(*all, [&](Interval& s) { return (s.link = drawnAt(m_links, s.link)) == kNotDrawn; });
    }
    std::erase_if(axis.bearings, [&](Bearing& b) {
      b.parent = drawnAt(m_links, b.parent);
      return !take(m_joints, b.joint) || !take(m_links, b.child);
    });
    return axis;
  }

  const DrawnPart& m_part;
  const Placement& m_whole;
  const std::vector<Axis>& m_axes;  ///< of the document
  Positions m_links;
  Positions m_joints;
  Positions m_meshes;
  Positions m_classes;
  Positions m_gears;
  DrawnTrain m_train;
};

}  // namespace

std::optional<DrawnTrain> drawnTrain(const DrawnPart& part, const DerivedGeometry& document,
                                     const std::stop_token& stop) {
  const bool isFiltered = document.placement().tree && !part.isWhole();
  std::optional<DerivedGeometry> ofPart;
  if (!document.placement().tree) ofPart.emplace(part.mechanism);
  const DerivedGeometry& machine = ofPart ? *ofPart : document;
  if (!machine.placement().tree) return std::nullopt;
  const auto wheels = machine.wheels(stop);
  const auto arrangement = wheels ? machine.arrangement(stop) : nullptr;
  if (!arrangement) return std::nullopt;
  if (isFiltered) return TrainFilter(part, document).take(*wheels, *arrangement);
  return DrawnTrain{machine.placement(), *wheels, *arrangement};
}

}  // namespace geargraph
