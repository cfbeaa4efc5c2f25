#include "core/theory/statics/held_parts.h"

#include <map>

#include "core/theory/states/relative_speed.h"

namespace geargraph {
namespace {

class PartMaker {
 public:
  PartMaker(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement)
      : m_mechanism(mechanism), m_model(model), m_placement(placement) {}

  void addCoupling(int position, std::vector<HeldPart>& parts) const {
    for (const KinematicModel::HeldRow& row : heldRows(m_mechanism, m_placement, position)) {
      // The first axis on the way to the ground, as its joint points; for a clutch on the ground's side of
      // everything, that of the other link.
      const LinkOrdinal first = row.to != 0 ? row.to : row.from;
      const JointOrdinal joint = m_placement.tree->joint[first];
      HeldPart& part = parts.emplace_back();
      part.coupling = position;
      const int along = directionSign(m_placement, row.axisGroup, m_placement.classes->classOf[joint]);
      part.isMain = along != 0;
      part.axis = part.isMain ? AxisOrdinal(m_placement.tree->axisOf[joint])
                              : m_placement.classes->classes[row.axisGroup].axis;
      const int sign = part.isMain ? along * m_placement.classes->orientationSign[joint] : 1;
      for (const auto& term : row.links) part.byLink.emplace_back(term.of, Rational(sign * term.factor));
      for (const auto& term : row.joints) part.byJoint.emplace_back(term.of, Rational(sign * term.factor));
    }
  }

  [[nodiscard]] HeldPart balanceAt(int position, const TorquePlace& place) const {
    HeldPart part;
    part.balance = position;
    part.axis = place.axis;
    if (place.inJoint()) {
      const KinematicModel::JointRate& rate = m_model.jointRate(place.joint);
      part.byLink.emplace_back(rate.child, Rational(rate.sign));
      if (rate.parent != 0) part.byLink.emplace_back(rate.parent, Rational(-rate.sign));
      part.byJoint.emplace_back(place.joint, Rational(1));
      return part;
    }
    const auto factor = [&](const ExactVector3& direction) {
      const Real cosine = cosineBetween(direction, place.direction);
      part.isExact = part.isExact && cosine.isExact();
      return cosine.isExact() ? *cosine.fraction() : Rational::fromDouble(cosine.number());
    };
    const AxisGroups& classes = *m_placement.classes;
    for (int at = place.link; at != 0;) {
      const AxisGroupOrdinal axisGroup = classes.classOfLink(at);
      Rational cosine = factor(exactLineOfClass(m_mechanism, m_placement, axisGroup).direction);
      if (!cosine.isZero()) part.byLink.emplace_back(at, std::move(cosine));
      at = classes.classes[axisGroup].rootLink;
    }
    const SpanningTree& tree = m_model.tree();
    for (int at = place.link; at != 0; at = tree.parent(at)) {
      const JointOrdinal joint = tree.jointToParent(at);
      const AxisOrdinal axis = m_placement.tree->axisOf[joint];
      Rational cosine = Rational(-tree.directionToGround(joint)) *
                        factor(exactLine(m_mechanism, m_placement, axis).direction);
      if (!cosine.isZero()) part.byJoint.emplace_back(joint, std::move(cosine));
    }
    return part;
  }

 private:
  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
};

}  // namespace

bool HeldPart::holds(const RadicalColumns& load) const {
  std::map<int, Rational> own;
  for (const auto& [link, factor] : byLink) own[link] += factor;
  std::erase_if(own, [](const auto& entry) { return entry.second.isZero(); });
  bool hasPower = false;
  for (const RadicalColumns::Column& column : load.columns()) {
    if (column.entries.empty()) continue;
    hasPower = true;
    if (column.entries.size() != own.size()) return false;
    const Rational scale = column.entries.begin()->second;
    for (auto entry = column.entries.begin(), mine = own.cbegin(); mine != own.cend(); ++entry, ++mine) {
      const bool isAlong =
          entry->first == mine->first && entry->second * own.begin()->second == scale * mine->second;
      if (!isAlong) return false;
    }
  }
  return hasPower;
}

std::vector<HeldPart> heldParts(const Mechanism& mechanism, const KinematicModel& model,
                                const Placement& placement, const StaticsProblem& problem) {
  const PartMaker maker(mechanism, model, placement);
  std::vector<HeldPart> parts;
  for (const ShiftElementOrdinal coupling : problem.engaged) maker.addCoupling(coupling, parts);
  for (std::size_t i = 0; i < problem.balances.size(); ++i)
    parts.push_back(maker.balanceAt(static_cast<int>(i), problem.balances[i]));
  return parts;
}

}  // namespace geargraph
