#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/machine/solids/gear_body.h"
#include "core/presentation/brep/brep_builder.h"
#include "core/presentation/brep/wheel_brep.h"

namespace geargraph {

using std::numbers::pi;

void addBodyBelow(BrepBuilder& builder, const GearSpec& spec, const std::vector<LoopEdge>& top,
                  const std::vector<LoopEdge>& bottom) {
  const std::vector<ProfileVertex> body = bodyProfile(spec);
  const auto circles = builder.addCircles(body);
  std::vector<std::vector<std::vector<LoopEdge>>> holes(body.size());
  if (const auto windows = bodyWindows(spec)) {
    const ProfileVertex rim{windows->rim, windows->half}, hub{windows->hub, windows->half};
    const auto below = [](const ProfileVertex& vertex) {
      return ProfileVertex{vertex.radius, -vertex.height};
    };
    std::size_t upper = 0, lower = 0;
    for (std::size_t i = 0; i + 1 < body.size(); ++i) {
      if (body[i] == rim && body[i + 1] == hub) upper = i;
      if (body[i] == below(hub) && body[i + 1] == below(rim)) lower = i;
    }
    for (int k = 0; k < windows->count; ++k) {
      const double turn = -pi / spec.teeth + (2 * k + 1) * pi / windows->count;
      auto walls = builder.addWall(windowOutline(*windows, turn), -windows->half, windows->half, true);
      holes[upper].push_back(std::move(walls.top));
      holes[lower].push_back(std::move(walls.bottom));
    }
  }
  const bool isInside = isRing(spec);
  builder.addRevolved(body, circles, isInside, holes);
  std::vector<std::vector<LoopEdge>> upper{isInside ? against(top) : top},
      lower{isInside ? bottom : against(bottom)};
  if (!circles.front().empty()) upper.push_back(isInside ? circles.front() : against(circles.front()));
  if (!circles.back().empty()) lower.push_back(isInside ? against(circles.back()) : circles.back());
  if (isInside) {
    std::swap(upper[0], upper[1]);
    std::swap(lower[0], lower[1]);
  }
  builder.addPlane(body.front().height, true, std::move(upper));
  builder.addPlane(body.back().height, false, std::move(lower));
}

KindTable<GearKind, WheelCad>& wheelCads() {
  static constinit KindTable<GearKind, WheelCad> table(&kTwistedCad, &kTwistedCad, &kConeCad, &kSmoothCad,
                                                       &kTwistedCad, &kThroatCad, &kNoCad, &kConeBlankCad);
  return table;
}

const char* noExactFaces(const GearSpec& spec) {
  const auto refuse = wheelCads()[spec.kind].refuse;
  return refuse != nullptr ? refuse(spec) : "";
}

WheelBrep wheelBrep(const GearSpec& spec, double deviation) {
  return wheelCads()[spec.kind].make(spec, deviation * toothSize(spec));
}

}  // namespace geargraph
