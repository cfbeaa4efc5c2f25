#include "core/theory/lost_motion/lost_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/foundations/exact/elimination.h"
#include "core/foundations/exact/fields.h"
#include "core/foundations/exact/linear_maximum.h"
#include "core/machine/train/wheel_backlash.h"
#include "core/theory/matroid/exact_solution.h"

namespace geargraph {
namespace {

constexpr int kMaxPivots = 20'000;

/// Rows over the phi, then the play e_c of each mesh as a given column: meshes, couplings, held inputs.
SparseRows<Rational> playRows(const KinematicModel& model, std::span<const int> inputs) {
  const RationalField field;
  SparseRows<Rational> rows;
  for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh) {
    model.addMeshRow(rows, mesh, field);
    rows.add(model.n() + mesh, field.fromInteger(-1));
    rows.endRow();
  }
  for (const KinematicModel::HeldRow& held : model.held()) {
    KinematicModel::addHeldRow(rows, held, field);
    rows.endRow();
  }
  for (const int input : inputs) {
    model.addRateRow(rows, input, field);
    rows.endRow();
  }
  return rows;
}

/// A row of the system as a condition of a linear program over the phi.
LinearBound boundOf(const SparseRows<Rational>& rows, int row, int unknowns, bool isNegated, Rational bound) {
  LinearBound made{std::vector<Rational>(static_cast<std::size_t>(unknowns)), std::move(bound)};
  for (int entry = rows.begin(row); entry < rows.end(row); ++entry) {
    const int column = rows.column(entry);
    if (column >= unknowns) continue;
    made.coefficients[static_cast<std::size_t>(column)] += isNegated ? -rows.value(entry) : rows.value(entry);
  }
  return made;
}

/// What the play of shared meshes leaves, by linear programs: every mesh between its stops, half of its play
/// away on either side.
class SharedPlay {
 public:
  SharedPlay(const KinematicModel& model, const SparseRows<Rational>& rows, const ByMesh<Rational>& plays)
      : m_model(model) {
    for (int row = 0; row < rows.rows(); ++row) {
      const bool isMesh = row < model.c();
      const Rational half = isMesh ? plays[MeshOrdinal(row)] * Rational(1, 2) : Rational(0);
      for (const bool isNegated : {false, true})
        m_bounds.push_back(boundOf(rows, row, model.n(), isNegated, half));
    }
  }

  [[nodiscard]] std::optional<Rational> rangeOf(JointOrdinal joint) const {
    SparseRows<Rational> rate;
    m_model.addRateRow(rate, joint, RationalField());
    rate.endRow();
    const LinearBound objective = boundOf(rate, 0, m_model.n(), false, 0);
    const auto most = linearMaximum(m_bounds, objective.coefficients, kMaxPivots);
    if (!most) return std::nullopt;
    return Rational(2) * *most;  // the polytope is symmetric
  }

  void setPlay(MeshOrdinal mesh, const Rational& play) {
    for (const std::size_t side : {0, 1})
      m_bounds[2 * static_cast<std::size_t>(int{mesh}) + side].bound = play * Rational(1, 2);
  }

 private:
  const KinematicModel& m_model;
  std::vector<LinearBound> m_bounds;
};

void addShared(LostMotion& into, const KinematicModel& model, SharedPlay& play, const ByMesh<Rational>& plays,
               const std::stop_token& stop) {
  if (model.c() > LostMotions::kMaxSharedMeshes) return;
  into.worst = play.rangeOf(into.joint);
  if (!into.worst) return;
  for (MeshOrdinal mesh = 0; mesh < model.c() && !stop.stop_requested(); ++mesh) {
    play.setPlay(mesh, 0);
    into.parts.push_back(*into.worst - play.rangeOf(into.joint).value_or(*into.worst));
    play.setPlay(mesh, plays[mesh]);
  }
}

/// The sums, from the weights.
void addSums(LostMotion& into, const ByMesh<Rational>& plays) {
  Rational worst;
  Rational squares;
  for (const MeshOrdinal mesh : plays.ordinals()) {
    Rational part = into.weights[mesh].abs() * plays[mesh];
    worst += part;
    squares += part * part;
    into.parts.push_back(std::move(part));
  }
  into.worst = std::move(worst);
  into.rootOfSquares = std::sqrt(squares.toDouble());
}

}  // namespace

std::optional<MeshOrdinal> LostMotion::mostOf() const {
  std::optional<MeshOrdinal> most;
  for (const MeshOrdinal mesh : parts.ordinals()) {
    if (!parts[mesh].isZero() && (!most || parts[mesh] > parts[*most])) most = mesh;
  }
  return most;
}

std::optional<LostMotions> lostMotions(const Mechanism& mechanism, const KinematicModel& model,
                                       std::span<const int> inputs, const std::stop_token& stop) {
  const RationalField field;
  const auto meshes = static_cast<std::size_t>(model.c());
  if (meshes * static_cast<std::size_t>(model.t()) > ExactSolution::kMaxExactEntries) return std::nullopt;
  LostMotions result;
  for (const int input : inputs) result.held.emplace_back(input);
  for (const GearMesh& mesh : mechanism.gearMeshes) {
    Rational play = backlashOf(mechanism, mesh.tailWheel) + backlashOf(mechanism, mesh.headWheel);
    const bool hasPlay = play.sign() > 0 && touches(saidKind(mesh));  // belts and pins have no flanks
    result.plays.push_back(hasPlay ? std::move(play) : Rational(0));
  }
  for (JointOrdinal joint = 0; joint < model.t(); ++joint) {
    if (std::find(inputs.begin(), inputs.end(), int{joint}) != inputs.end()) continue;
    result.outputs.emplace_back().joint = joint;
  }
  const SparseRows<Rational> rows = playRows(model, inputs);
  const auto system = eliminate(field, rows, model.n(), model.n() + model.c(), stop);
  if (!system) return std::nullopt;
  result.isShared = !system->checks.empty();
  if (result.isShared) {
    SharedPlay play(model, rows, result.plays);
    for (LostMotion& output : result.outputs) {
      if (stop.stop_requested()) return std::nullopt;
      addShared(output, model, play, result.plays, stop);
    }
    return result;
  }
  std::vector<Rational> x(static_cast<std::size_t>(system->columns));
  for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh) {
    if (stop.stop_requested()) return std::nullopt;
    Rational& given = x[static_cast<std::size_t>(model.n() + mesh)];
    given = 1;
    substitute(field, *system, std::span<Rational>(x));
    given = 0;
    for (LostMotion& output : result.outputs)
      output.weights.push_back(model.rateOf(field, output.joint, std::span<const Rational>(x)));
  }
  for (LostMotion& output : result.outputs) addSums(output, result.plays);
  return result;
}

}  // namespace geargraph
