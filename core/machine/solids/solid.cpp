#include "core/machine/solids/solid.h"

namespace geargraph {
namespace {

Eigen::Vector3d wide(const Float3& p) {
  return {p[0], p[1], p[2]};
}

Float3 narrow(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

}  // namespace

double signedVolume(const Solid& solid) {
  double sixfold = 0;
  for (const Triangle& t : solid.triangles) {
    sixfold +=
        wide(solid.positions[t[0]]).dot(wide(solid.positions[t[1]]).cross(wide(solid.positions[t[2]])));
  }
  return sixfold / 6;
}

Eigen::AlignedBox3d boundsOf(const Solid& solid) {
  Eigen::AlignedBox3d box;
  for (const Float3& p : solid.positions) box.extend(wide(p));
  return box;
}

void append(Solid& whole, const Solid& part, const Eigen::Isometry3d& placed) {
  const std::size_t vertices = whole.positions.size(), triangles = whole.triangles.size();
  const std::size_t normals = whole.normals.size();  // a solid from a file may have none
  const auto first = static_cast<std::uint32_t>(vertices);
  whole.positions.resize(vertices + part.positions.size());
  whole.normals.resize(normals + part.normals.size());
  whole.triangles.resize(triangles + part.triangles.size());
  for (std::size_t i = 0; i < part.positions.size(); ++i) {
    whole.positions[vertices + i] = narrow(placed * wide(part.positions[i]));
  }
  for (std::size_t i = 0; i < part.normals.size(); ++i) {
    whole.normals[normals + i] = narrow(placed.linear() * wide(part.normals[i]));
  }
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    const Triangle& t = part.triangles[i];
    whole.triangles[triangles + i] = {t[0] + first, t[1] + first, t[2] + first};
  }
}

Solid moved(const Solid& solid, const Eigen::Isometry3d& placed) {
  Solid result;
  append(result, solid, placed);
  return result;
}

}  // namespace geargraph
