#include <array>
#include <cmath>

#include "core/foundations/base/translation.h"
#include "core/teaching/derivation/result_tables.h"
#include "core/theory/matroid/screw.h"

namespace geargraph {
namespace {

constexpr double kRounding = 1e-12;  // of the largest component: what doubles lose, shown as 0

/// L M N P Q R.
template <class Scalar>
std::array<Scalar, 6> componentsOf(const Screw<Scalar>& screw) {
  const auto& [u, r] = screw;
  return {u[0], u[1], u[2], r[0], r[1], r[2]};
}

class ScrewTable final : public ResultTable {
 public:
  ScrewTable(const NamedResult& result, SnapshotPtr snapshot, EntryForm form)
      : ResultTable(result, form), m_snapshot(std::move(snapshot)) {
    const IntegerMatrix& cycles = *m_snapshot->matrix(MatrixKind::spanningTree);
    std::vector<MatrixEntry> entries;
    for (MeshOrdinal mesh = 0; mesh < cycles.rows(); ++mesh) {
      cycles.rowEntries(mesh, entries);
      for (const MatrixEntry& entry : entries) m_rows.push_back({mesh, entry.column});
    }
  }

  [[nodiscard]] int rows() const override { return static_cast<int>(m_rows.size()); }
  [[nodiscard]] int columns() const override { return 6; }
  [[nodiscard]] std::optional<int> partition() const override { return 3; }
  [[nodiscard]] Heading columnHeading(int column) const override {
    return {column, std::string(1, "LMNPQR"[column]), {}};
  }
  [[nodiscard]] Heading rowHeading(int row) const override {
    const Digraph& graph = *m_snapshot->graph;
    const auto [mesh, joint] = at(row);
    const int label = graph.edgeLabel(joint);
    return {label, "C" + std::to_string(graph.edgeLabel(graph.t() + mesh)) + "  " + std::to_string(label),
            graph.edgeId(joint)};
  }
  [[nodiscard]] std::set<ElementId> elementsOfRow(int row) const override {
    const Digraph& graph = *m_snapshot->graph;
    return {graph.edgeId(at(row).joint), graph.edgeId(graph.t() + at(row).mesh)};
  }

  [[nodiscard]] std::vector<ResultEntry> row(int row) const override {
    const std::array<double, 6> values = componentsOf(screwOf(at(row)));
    std::optional<std::array<Rational, 6>> exact;
    if (const auto screw = exactScrewOf(at(row))) exact = componentsOf(*screw);
    std::vector<ResultEntry> entries;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const int column = static_cast<int>(i);
      if (exact ? (*exact)[i].isZero() : isRounding(values, i)) continue;
      if (form() == EntryForm::decimals) {
        entries.push_back(decimalEntry(column, values[i]));
      } else {
        entries.push_back(exact ? fractionEntry(column, (*exact)[i]) : irrationalEntry(column, values[i]));
      }
    }
    return entries;
  }

  [[nodiscard]] CellExplanation explanation(int row, int column) const override {
    const Digraph& graph = *m_snapshot->graph;
    const auto [mesh, joint] = at(row);
    const std::string jointName = translated("joint %1", {std::to_string(graph.edgeLabel(joint))});
    const std::string meshName = translated("mesh %1", {std::to_string(graph.edgeLabel(graph.t() + mesh))});
    const auto shown = entry(row, column);
    const std::string axis(1, "xyz"[column % 3]);
    CellExplanation cell;
    cell.title = "C" + std::to_string(graph.edgeLabel(graph.t() + mesh)) + ", " + jointName + ", " +
                 std::string(1, "LMNPQR"[column]) + ": " + (shown ? shown->text : "0");
    if (slides(at(row))) {
      cell.text = column < 3 ? translated("%1 slides: its screw has no angular part.", {jointName})
                             : translated(
                                   "The %1 component of the direction in which %2 slides: how fast the "
                                   "pitch point of %3 moves for one unit of speed.",
                                   {axis, jointName, meshName});
    } else if (column < 3) {
      cell.text = translated("The %1 component of the unit vector u along the axis of %2. Eqs. (7)-(9)",
                             {axis, jointName});
    } else {
      cell.text = translated(
          "The %1 component of the moment of %2's axis about the pitch point of %3: how fast "
          "that point moves for one unit of speed. Eqs. (10)-(12)",
          {axis, jointName, meshName});
    }
    return cell;
  }

 private:
  struct Place {
    MeshOrdinal mesh = 0;
    JointOrdinal joint = 0;
  };

  [[nodiscard]] Place at(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
  [[nodiscard]] const Placement& placement() const { return m_snapshot->kinematics->placement(); }

  /// The screw of a sliding joint is (0; d): its direction is its moment about any point.
  [[nodiscard]] bool slides(Place place) const {
    return geargraph::slides(m_snapshot->mechanism->turningJoints[place.joint]);
  }

  [[nodiscard]] Screw<double> screwOf(Place place) const {
    const auto joint = static_cast<std::size_t>(place.joint);
    const AxisGroups& classes = *placement().classes;
    const AxisLine& line = placement().lineOfClass(classes.classOf[joint]);
    const double sense = classes.orientationSign[joint];
    if (slides(place)) return {{0, 0, 0}, sense * line.direction};
    return screwAbout(placement().meshes[place.mesh]->pitchPoint, line.point, sense * line.direction);
  }

  /// Nothing where the pitch point or the length of the direction is a root.
  [[nodiscard]] std::optional<Screw<Rational>> exactScrewOf(Place place) const {
    const auto joint = static_cast<std::size_t>(place.joint);
    const AxisGroups& classes = *placement().classes;
    // The pitch point does not matter to a slide.
    const auto point = slides(place) ? std::optional(ExactVector3{0, 0, 0})
                                     : exactPitchPoint(*m_snapshot->mechanism, placement(), place.mesh);
    const ExactLine line = exactLineOfClass(*m_snapshot->mechanism, placement(), classes.classOf[joint]);
    const auto length = dot(line.direction, line.direction).squareRoot();
    if (!point || !length) return std::nullopt;
    const Rational scale = Rational(classes.orientationSign[joint]) / *length;
    if (slides(place)) return Screw<Rational>{{0, 0, 0}, scale * line.direction};
    return screwAbout(*point, line.point, scale * line.direction);
  }

  static bool isRounding(const std::array<double, 6>& values, std::size_t i) {
    const std::size_t part = i < 3 ? 0 : 3;
    const double most = std::max({std::abs(values[part]), std::abs(values[part + 1]),
                                  std::abs(values[part + 2]), part == 0 ? 1.0 : 0.0});
    return std::abs(values[i]) <= kRounding * most;
  }

  SnapshotPtr m_snapshot;
  std::vector<Place> m_rows;
};

}  // namespace

ResultTablePtr screwTable(const NamedResult& result, SnapshotPtr snapshot, EntryForm form) {
  return std::make_shared<const ScrewTable>(result, std::move(snapshot), form);
}

}  // namespace geargraph
