#include "core/theory/dynamics/link_inertia.h"

#include "core/foundations/base/contract.h"
#include "core/machine/body_layout/body_recipe.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/solids/toothless_gear.h"

namespace geargraph {
namespace {

/// The gear in its own frame. Teeth too fine to be seen are a cylinder: it has their volume but for some
/// parts in a thousand.
MassProperties gearMass(const TrainGear& gear, bool withTeeth, GearCache& cache, double density) {
  const bool isToothless = !withTeeth || gear.spec.teeth > kMaxShownTeeth;
  if (isToothless) return massProperties(toothlessGear(gear.spec, kScreenTolerance), density);
  const auto solid = cache.solid(gear.spec, kScreenTolerance);
  return solid ? massProperties(**solid, density) : MassProperties{};
}

/// The part in its own frame, then moved: the coordinates of a solid are floats.
MassProperties partMass(const BodyPart& part, double density) {
  BodyPart alone = part;
  alone.placed = Eigen::Isometry3d::Identity();
  return moved(massProperties(madeBy({alone}, kBodyTolerance), density), part.placed);
}

Eigen::Vector3d vectorOf(const NumberTriple& triple) {
  return {triple[0].value(), triple[1].value(), triple[2].value()};
}

Eigen::Matrix3d matrixOf(const InertiaNumbers& inertia) {
  const auto at = [&](std::size_t i) { return inertia[i].value(); };
  Eigen::Matrix3d matrix;
  matrix << at(0), at(3), at(4), at(3), at(1), at(5), at(4), at(5), at(2);
  return matrix;
}

/// A point of the axis about which the link turns; the origin for the ground.
Eigen::Vector3d placeOnAxis(const Placement& placement, LinkOrdinal link) {
  if (link == 0) return Eigen::Vector3d::Zero();
  const JointTree& tree = *placement.tree;
  const AxisOrdinal axis = tree.axisOf[tree.joint[link]];
  return Eigen::Vector3d(placement.axes[axis].point.data());
}

/// What the document states, over what the solids give (lengths in m).
LinkInertia asStated(const LinkMass& stated, const MassProperties& solids, const Eigen::Vector3d& onAxis,
                     double metres) {
  LinkInertia result;
  result.source = MassSource::stated;
  MassProperties& body = result.body;
  body.mass = stated.mass.value();
  const bool hasSolids = solids.mass > 0;
  if (stated.center) {
    body.center = metres * vectorOf(*stated.center);
  } else {
    body.center = hasSolids ? solids.center : metres * onAxis;
  }
  if (stated.inertia) {
    body.inertia = matrixOf(*stated.inertia);
  } else if (hasSolids) {
    body.inertia = body.mass / solids.mass * solids.inertia;
    result.source = MassSource::scaled;
  }
  return result;
}

}  // namespace

const char* massSourceName(MassSource source) {
  switch (source) {
    case MassSource::none:
      return "none";
    case MassSource::solids:
      return "solids";
    case MassSource::scaled:
      return "scaled";
    case MassSource::stated:
      return "stated";
  }
  return "";
}

std::vector<LinkInertia> linkInertias(const Mechanism& mechanism, const Placement& placement,
                                      const GearTrain& train, double metres, const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(placement.tree.has_value());
  const double density = mechanism.density ? mechanism.density->value() : kSteelDensity;
  ByLink<MassProperties> solids(mechanism.links.size());
  const auto add = [&](LinkOrdinal link, const MassProperties& part) {
    MassProperties& whole = solids[link];
    whole = joined(whole, part);
  };
  GearCache cache;
  for (const TrainGear& gear : train.gears) {
    if (stop.stop_requested()) return {};
    add(gear.link, moved(gearMass(gear, !train.hasSimpleBodies, cache, density), gear.pose));
  }
  for (const LinkBody& body : train.bodies) {
    if (stop.stop_requested()) return {};
    for (const BodyPart& part : *body.recipe) add(body.link, partMass(part, density));
  }
  std::vector<LinkInertia> inertias;
  for (std::size_t link = 0; link < mechanism.links.size(); ++link) {
    // Density is per m³, the solids are in the document's unit.
    MassProperties inMetres = rescaled(solids[link], metres);
    inMetres.mass *= metres * metres * metres;
    inMetres.inertia *= metres * metres * metres;
    const auto& stated = mechanism.links[link].mass;
    if (stated) {
      inertias.push_back(asStated(*stated, inMetres, placeOnAxis(placement, static_cast<int>(link)), metres));
    } else {
      inertias.push_back({inMetres, inMetres.mass > 0 ? MassSource::solids : MassSource::none});
    }
  }
  return inertias;
}

}  // namespace geargraph
