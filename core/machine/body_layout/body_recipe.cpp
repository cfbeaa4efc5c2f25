#include "core/machine/body_layout/body_recipe.h"

#include <algorithm>
#include <functional>

namespace geargraph {
namespace {

struct Maker {
  double tolerance;

  Solid operator()(const TubePart& t) const { return tube(t.outer, t.inner, t.from, t.to, tolerance); }
  Solid operator()(const RevolvedPart& l) const { return revolved(l.profile, tolerance); }
  Solid operator()(const SpiderPart& s) const { return spider(s.hub, s.ends, s.from, s.to, tolerance); }
  Solid operator()(const BarPart& b) const {
    return tubeSector(b.outer, b.inner, b.from, b.to, b.half, tolerance);
  }
  Solid operator()(const PlatePart& p) const { return plate(p.corners, p.from, p.to, tolerance); }
};

/// Adds the numbers of a part to a hash.
struct Hasher {
  std::size_t& seed;

  void add(double number) const { seed = seed * 1000003 + std::hash<double>{}(number); }
  void add(const Boss& boss) const {
    for (const double number : {boss.centre.x(), boss.centre.y(), boss.radius, boss.hole}) add(number);
  }
  void operator()(const TubePart& t) const {
    for (const double number : {t.outer, t.inner, t.from, t.to}) add(number);
  }
  void operator()(const RevolvedPart& l) const {
    for (const ProfileVertex& circle : l.profile) {
      add(circle.radius);
      add(circle.height);
    }
  }
  void operator()(const SpiderPart& s) const {
    add(s.hub);
    for (const Boss& end : s.ends) add(end);
    add(s.from);
    add(s.to);
  }
  void operator()(const BarPart& b) const {
    for (const double number : {b.outer, b.inner, b.from, b.to, b.half}) add(number);
  }
  void operator()(const PlatePart& p) const {
    for (const Boss& corner : p.corners) add(corner);
    add(p.from);
    add(p.to);
  }
};

}  // namespace

Solid madeBy(const BodyRecipe& recipe, double tolerance) {
  std::vector<Solid> shapes;         // equal ones that follow each other once
  std::vector<std::size_t> shapeOf;  // by part
  std::size_t vertices = 0, triangles = 0;
  for (std::size_t i = 0; i < recipe.size(); ++i) {
    const BodyPart& part = recipe[i];
    const bool again = i > 0 && part.module == recipe[i - 1].module && part.shape == recipe[i - 1].shape;
    if (!again) shapes.push_back(std::visit(Maker{tolerance * part.module}, part.shape));
    shapeOf.push_back(shapes.size() - 1);
    vertices += shapes.back().positions.size();
    triangles += shapes.back().triangles.size();
  }
  Solid whole;
  whole.positions.reserve(vertices);
  whole.normals.reserve(vertices);
  whole.triangles.reserve(triangles);
  for (std::size_t i = 0; i < recipe.size(); ++i) append(whole, shapes[shapeOf[i]], recipe[i].placed);
  return whole;
}

std::size_t BodyCache::Hash::operator()(const Key& key) const {
  std::size_t seed = key.recipe.size();
  const Hasher hasher{seed};
  hasher.add(key.tolerance);
  for (const BodyPart& part : key.recipe) {
    std::visit(hasher, part.shape);
    hasher.add(part.module);
    for (const double number : part.placed.matrix().reshaped()) hasher.add(number);
  }
  return seed;
}

std::shared_ptr<const DeferredSolid> BodyCache::deferred(const BodyRecipe& recipe, double tolerance) {
  const auto [entry, isNew] = m_solids.try_emplace(Key{recipe, tolerance});
  if (isNew) {
    entry->second.solid =
        std::make_shared<const DeferredSolid>([recipe, tolerance] { return madeBy(recipe, tolerance); });
  }
  entry->second.used = ++m_calls;
  const std::shared_ptr<const DeferredSolid> found = entry->second.solid;
  if (m_solids.size() > m_capacity) {
    m_solids.erase(std::min_element(m_solids.begin(), m_solids.end(), [](const auto& a, const auto& b) {
      return a.second.used < b.second.used;
    }));
  }
  return found;
}

}  // namespace geargraph
