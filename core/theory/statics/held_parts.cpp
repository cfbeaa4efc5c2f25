#include "core/theory/statics/held_parts.h"

#include <algorithm>

#include "core/foundations/base/position_index.h"

namespace geargraph::inline statics {
namespace {

/// The two links of a coupling: what it acts on, and where the reaction is.
std::pair<int, int> linksOf(const Mechanism& mechanism, const Coupling& coupling) {
  const PositionIndex<LinkTag> links(mechanism.links);
  const int acts = links.at(coupling.links.front());
  return {acts, coupling.kind == CouplingKind::brake ? 0 : links.at(coupling.links.back())};
}

class PartMaker {
 public:
  PartMaker(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement)
      : m_mechanism(mechanism), m_model(model), m_placement(placement) {}

  void addCoupling(int position, std::vector<HeldPart>& parts) const {
    const auto [link, against] =
        linksOf(m_mechanism, m_mechanism.couplings[static_cast<std::size_t>(position)]);
    if (link == against) return;  // a brake on the ground holds nothing
    // The first axis on the way to the ground, as its joint points; for a clutch on the ground's side of
    // everything, that of the other link.
    const int first = link != 0 ? link : against;
    const auto joint = static_cast<std::size_t>(m_placement.tree->joint[static_cast<std::size_t>(first)]);
    const int axis = m_placement.tree->axisOf[joint];
    const int mainClass = m_placement.classes->classOf[joint];
    const int sense = m_placement.classes->sense[joint];
    const RelativeSpeed speed = RelativeSpeed::between(m_placement, against, link);
    for (const RelativeSpeed::Part& of : speed.parts) {
      HeldPart& part = parts.emplace_back();
      part.coupling = position;
      const int along = directionSign(m_placement, of.axisClass, mainClass);
      part.isMain = along != 0;
      part.axis =
          part.isMain ? axis : m_placement.classes->classes[static_cast<std::size_t>(of.axisClass)].axis;
      const int sign = part.isMain ? along * sense : 1;
      for (const RelativeSpeed::Term& term : of.terms)
        part.byLink.emplace_back(term.link, Rational(sign * term.factor));
      addCircuit(against, link, of.axisClass, sign, part);
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
    const AxisClasses& classes = *m_placement.classes;
    for (int at = place.link; at != 0;) {
      const int axisClass = classes.classOfLink(at);
      Rational cosine = factor(exactLineOfClass(m_mechanism, m_placement, axisClass).direction);
      if (!cosine.isZero()) part.byLink.emplace_back(at, std::move(cosine));
      at = classes.classes[static_cast<std::size_t>(axisClass)].top;
    }
    const SpanningTree& tree = m_model.tree();
    for (int at = place.link; at != 0; at = tree.parent(at)) {
      const int joint = tree.jointToParent(at);
      const int axis = m_placement.tree->axisOf[static_cast<std::size_t>(joint)];
      Rational cosine = Rational(-tree.directionToGround(joint)) *
                        factor(exactLine(m_mechanism, m_placement, axis).direction);
      if (!cosine.isZero()) part.byJoint.emplace_back(joint, std::move(cosine));
    }
    return part;
  }

 private:
  /// The joints on the way whose axes are parallel to the class's line.
  void addCircuit(int from, int to, int axisClass, int sign, HeldPart& part) const {
    for (const PathStep& step : treePath(m_model.tree(), from, to)) {
      const auto joint = static_cast<std::size_t>(step.joint);
      const int along = directionSign(m_placement, m_placement.classes->classOf[joint], axisClass);
      if (along == 0) continue;
      part.byJoint.emplace_back(step.joint,
                                Rational(sign * along * step.direction * m_placement.classes->sense[joint]));
    }
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
};

}  // namespace

std::vector<HeldPart> heldParts(const Mechanism& mechanism, const KinematicModel& model,
                                const Placement& placement, const StaticsProblem& problem) {
  const PartMaker maker(mechanism, model, placement);
  std::vector<HeldPart> parts;
  for (const int coupling : problem.engaged) maker.addCoupling(coupling, parts);
  for (std::size_t i = 0; i < problem.balances.size(); ++i)
    parts.push_back(maker.balanceAt(static_cast<int>(i), problem.balances[i]));
  return parts;
}

bool closesWithoutLinkage(const Mechanism& mechanism, const Placement& placement, int coupling) {
  const auto [link, against] = linksOf(mechanism, mechanism.couplings[static_cast<std::size_t>(coupling)]);
  return RelativeSpeed::between(placement, against, link).closesWithoutLinkage();
}

}  // namespace geargraph::inline statics
