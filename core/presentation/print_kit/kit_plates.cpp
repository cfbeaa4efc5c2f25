#include "core/presentation/print_kit/kit_plates.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

struct Laid {
  std::size_t part = 0;
  double turn = 0;
  AlignedBox2d box;
};

/// The turn in steps of 5 degrees that makes the part lowest and still fits the plate.
std::optional<Laid> laid(const KitPart& part, std::size_t index, const KitOptions& options) {
  std::optional<Laid> best;
  for (int step = 0; step < 36; ++step) {
    const double turn = step * std::numbers::pi / 36;
    const AlignedBox2d box = footprint(part, turn);
    const Vector2d size = box.sizes();
    if (size.x() > options.bedX - options.gap || size.y() > options.bedY - options.gap) continue;
    // Straight where nothing is gained, so that long parts lie along an edge.
    if (best && size.y() >= best->box.sizes().y() - 0.5) continue;
    best = Laid{index, turn, box};
  }
  return best;
}

/// Rows from the front to the back of a plate.
class Shelves {
 public:
  explicit Shelves(const KitOptions& options) : m_options(options) {}

  bool put(const Laid& part, KitPlate& plate) {
    const Vector2d size = part.box.sizes() + Vector2d(m_options.gap, m_options.gap);
    for (Row& row : m_rows) {
      if (row.depth + 1e-9 < size.y() || row.used + size.x() > m_options.bedX + 1e-9) continue;
      place(part, row, plate);
      return true;
    }
    if (m_depth + size.y() > m_options.bedY + 1e-9) return false;
    m_rows.push_back({m_depth, size.y(), 0});
    m_depth += size.y();
    place(part, m_rows.back(), plate);
    return true;
  }

 private:
  struct Row {
    double from = 0;
    double depth = 0;
    double used = 0;
  };

  void place(const Laid& part, Row& row, KitPlate& plate) {
    const double half = m_options.gap / 2;
    const Vector2d corner(row.used + half, row.from + half);
    plate.parts.push_back({part.part, corner - part.box.min(), part.turn});
    row.used += part.box.sizes().x() + m_options.gap;
  }

  const KitOptions& m_options;
  std::vector<Row> m_rows;
  double m_depth = 0;
};

}  // namespace

AlignedBox2d footprint(const KitPart& part, double turn) {
  const Eigen::Rotation2Dd rotation(turn);
  AlignedBox2d box;
  for (const Float3& p : part.solid->positions) box.extend(rotation * Vector2d(p[0], p[1]));
  return box;
}

std::variant<std::vector<KitPlate>, KitFailure> platesFor(std::span<const KitPart> parts,
                                                          const KitOptions& options) {
  std::vector<Laid> all;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const std::optional<Laid> part = laid(parts[p], p, options);
    if (!part) {
      const Vector2d size = footprint(parts[p], 0).sizes();
      return KitFailure{
          KitFailure::Kind::bed,
          translated(
              "\"%1\" measures %2 mm by %3 mm and does not fit the plate; scale the kit down.",
              {parts[p].name, readableNumber(std::ceil(size.x())), readableNumber(std::ceil(size.y()))}),
          {}};
    }
    all.push_back(*part);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Laid& a, const Laid& b) { return a.box.sizes().y() > b.box.sizes().y(); });
  std::vector<KitPlate> plates;
  std::vector<Shelves> shelves;
  for (const Laid& part : all) {
    bool isPut = false;
    for (std::size_t plate = 0; plate < plates.size() && !isPut; ++plate)
      isPut = shelves[plate].put(part, plates[plate]);
    if (isPut) continue;
    plates.emplace_back();
    shelves.emplace_back(options);
    shelves.back().put(part, plates.back());
  }
  return plates;
}

}  // namespace geargraph
