#include "core/presentation/brep/body_brep.h"

#include "core/presentation/brep/brep_builder.h"

namespace geargraph {
namespace {

/// In the frame of the part.
struct Maker {
  std::vector<Brep> operator()(const TubePart& t) const {
    return {revolvedBrep(tubeProfile(t.outer, t.inner, t.from, t.to))};
  }
  std::vector<Brep> operator()(const RevolvedPart& r) const { return {revolvedBrep(r.profile)}; }
  std::vector<Brep> operator()(const SpiderPart& s) const {
    std::vector<Brep> pieces;
    for (const FlatShape& shape : spiderShapes(s.hub, s.ends, s.from, s.to))
      pieces.push_back(flatBrep(shape));
    if (pieces.empty()) return (*this)(TubePart{s.hub.radius, s.hub.hole, s.from, s.to});
    return pieces;
  }
  std::vector<Brep> operator()(const BarPart& b) const {
    return {flatBrep(sectorShape(b.outer, b.inner, b.from, b.to, b.half))};
  }
  std::vector<Brep> operator()(const PlatePart& p) const {
    return {flatBrep(plateShape(p.corners, p.from, p.to))};
  }
};

}  // namespace

std::vector<Brep> bodyBreps(const BodyRecipe& recipe) {
  std::vector<Brep> solids;
  for (const BodyPart& part : recipe) {
    for (Brep& piece : std::visit(Maker{}, part.shape))
      solids.push_back(placed(std::move(piece), part.placed, 1));
  }
  return solids;
}

}  // namespace geargraph
