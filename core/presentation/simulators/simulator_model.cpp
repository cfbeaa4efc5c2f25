#include "core/presentation/simulators/simulator_model.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numbers>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/machine/train/train_parts.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "core/theory/dynamics/dynamics_report.h"
#include "core/theory/matroid/coefficient_matrix.h"
#include "core/theory/matroid/joint_coupling.h"
#include "core/theory/pose/turning_lines.h"
#include "core/theory/states/engagement.h"
#include "core/theory/statics/applied_loads.h"

namespace geargraph {
namespace {

/// Simulators take no less: MuJoCo's least mass and moment of inertia.
constexpr double kLeastInertia = 1e-15;

/// Of a text that toTranslate() marks.
SimulatorNote noteOf(std::string_view text, std::string_view first, std::string_view second = {}) {
  return {filled(translated(text), {first, second}), filled(text, {first, second})};
}

class ModelMaker {
 public:
  ModelMaker(const AnalysisSnapshot& snapshot, const GearTrain& train, const SimulatorOptions& options,
             std::stop_token stop)
      : m_mechanism(*snapshot.mechanism),
        m_kinematics(*snapshot.kinematics),
        m_placement(snapshot.kinematics->placement()),
        m_tree(*snapshot.tree),
        m_matroid(*snapshot.matroid()),
        m_train(train),
        m_options(options),
        m_stop(std::move(stop)) {}

  std::variant<SimulatorModel, SimulatorError> run() {
    auto dynamics = dynamicsOf(m_mechanism, *m_kinematics.model, m_placement, m_matroid, m_train, m_stop);
    if (!dynamics) return stopped();
    if (!*dynamics) return SimulatorError{SimulatorError::Kind::model, dynamics->error().front().message};
    m_dynamics = **std::move(dynamics);
    m_model.name = m_mechanism.name;
    m_model.metres = metresPerUnit(m_mechanism)->toDouble();
    m_model.density = m_mechanism.density ? m_mechanism.density->value() : kSteelDensity;
    m_model.gravity = m_dynamics.train.gravity;
    for (const TurningJoint& joint : m_mechanism.turningJoints) m_model.joints.push_back(joint.id.text());
    addLinks();
    if (auto error = tooLight()) return *error;
    addMeshRows();
    addCouplings();
    addInputs();
    if (!addGains()) return stopped();
    if (auto error = addSolids()) return *error;
    return std::move(m_model);
  }

 private:
  static SimulatorError stopped() { return {SimulatorError::Kind::stopped, "Stopped."}; }

  void addLinks() {
    const std::vector<TurningLine> lines = turningLines(m_placement);
    const std::vector<AngleLimits> limits = angleLimits(m_mechanism);
    for (LinkOrdinal link = 0; link <= m_mechanism.n(); ++link) {
      SimulatedLink& made = m_model.links.emplace_back();
      made.link = link;
      made.name = m_mechanism.links[link].id.text();
      const LinkInertia& inertia = m_dynamics.links[static_cast<std::size_t>(link)];
      made.body = inertia.body;
      if (link > 0) {
        made.parent = m_tree.parent(link);
        made.joint = m_tree.jointToParent(link);
        made.jointName = m_model.joints[static_cast<std::size_t>(made.joint)];
        made.limits = limits[static_cast<std::size_t>(made.joint)];
        const TurningLine& line = lines[static_cast<std::size_t>(made.joint)];
        const double offset = m_mechanism.turningJoints[made.joint].offset.value();
        made.axis = -m_tree.directionToGround(made.joint) * line.direction;
        made.origin = m_model.metres * (line.point + offset * line.direction);
      }
      if (inertia.source == MassSource::none) makeBall(made);
    }
    for (const LinkOrdinal link : m_tree.preorder().subspan(1)) m_model.order.push_back(link);
    const bool hasWorld = std::any_of(m_model.links.begin(), m_model.links.end(),
                                      [](const SimulatedLink& link) { return link.name == "world"; });
    for (SimulatedLink& link : m_model.links) {
      if (link.name == "world") link.name = "link world";
    }
    if (hasWorld)
      m_model.notes.push_back(
          noteOf(toTranslate("The link \"%1\" is written as \"%2\"."), "world", "link world"));
  }

  void makeBall(SimulatedLink& link) const {
    constexpr double kModules = 2;
    constexpr double kWithoutGears = 0.005;  // m
    double radius = kWithoutGears;
    if (!m_train.gears.empty()) radius = kModules * toothSize(m_train.gears.front().spec) * m_model.metres;
    link.isBall = true;
    link.body.mass = m_model.density * 4 / 3 * std::numbers::pi * radius * radius * radius;
    link.body.center = link.origin;
    link.body.inertia = 0.4 * link.body.mass * radius * radius * Eigen::Matrix3d::Identity();
  }

  [[nodiscard]] std::optional<SimulatorError> tooLight() const {
    for (const SimulatedLink& link : m_model.links) {
      if (link.link == 0) continue;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> moments(link.body.inertia, Eigen::EigenvaluesOnly);
      const double least = std::min(link.body.mass, moments.eigenvalues().minCoeff());
      if (least >= kLeastInertia) continue;
      return SimulatorError{
          SimulatorError::Kind::model,
          translated("Link %1 has too little mass or inertia for simulators, which take 1e-15 kg and kg m² "
                     "and more. Is the unit of length right?",
                     {std::to_string(link.link)})};
    }
    return std::nullopt;
  }

  void addMeshRows() {
    const CoefficientMatrix matrix(m_mechanism, *m_kinematics.model, m_placement);
    for (MeshOrdinal mesh = 0; mesh < m_mechanism.c(); ++mesh) {
      const GearMesh& gears = m_mechanism.gearMeshes[mesh];
      const MeshGeometry& geometry = *m_placement.meshes[mesh];
      const double radius = std::abs(geometry.tailRadius) * m_model.metres;
      SimulatedRow& row = m_model.rows.emplace_back();
      row.name = "mesh " + gears.id.text();
      for (const CoefficientMatrix::Entry& entry : matrix.row(mesh)) {
        const int teeth = entry.tail ? gears.tailTeeth : gears.headTeeth;
        row.joints.emplace_back(entry.joint, entry.sign * radius * teeth / gears.tailTeeth);
      }
    }
  }

  void addCouplings() {
    const std::vector<int> engaged = engagedCouplings(m_mechanism);
    for (ShiftElementOrdinal coupling = 0; coupling < static_cast<int>(m_mechanism.couplings.size());
         ++coupling) {
      const std::string id = m_mechanism.couplings[coupling].id.text();
      if (!closesWithoutLinkage(m_mechanism, m_placement, coupling)) {
        m_model.notes.push_back(
            noteOf(toTranslate("Coupling %1 would close a linkage and is left out."), id));
        continue;
      }
      int number = 0;
      for (const KinematicModel::HeldRow& held : heldRows(m_mechanism, m_placement, coupling)) {
        SimulatedRow& row = m_model.rows.emplace_back();
        row.name = "coupling " + id + (++number > 1 ? " " + std::to_string(number) : "");
        row.isActive = std::binary_search(engaged.begin(), engaged.end(), coupling);
        for (const KinematicModel::HeldRow::Term& term : held.joints)
          row.joints.emplace_back(term.of, static_cast<double>(term.factor));
      }
    }
  }

  void addInputs() {
    TrainDynamics dynamics(m_dynamics.train);
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(m_dynamics.train.inputs());
    const EquationOfMotion& equation = dynamics.at(rest, rest);
    for (std::size_t i = 0; i < m_dynamics.inputs.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      m_model.inputs.push_back(
          {m_dynamics.inputs[i], m_matroid.speeds[i].toDouble(), equation.inertia(at, at)});
    }
  }

  bool addGains() {
    const std::vector<int>& inputs = m_dynamics.inputs;
    const std::vector<Rational> rest(inputs.size());
    const auto exact = solveExact(*m_kinematics.model, inputs, rest, m_stop);
    if (!exact) return false;
    for (JointOrdinal joint = 0; joint < static_cast<int>(m_model.joints.size()); ++joint)
      m_model.gains.push_back(gainsOf(*exact, joint));
    return true;
  }

  std::optional<SimulatorError> addSolids() {
    GearCache cache;
    const TrainParts made = trainParts(m_mechanism, m_train, cache, m_options.tolerance, m_stop);
    if (m_stop.stop_requested()) return stopped();
    MeshWriteOptions options;
    options.stop = m_stop;
    for (SimulatedLink& link : m_model.links) {
      MeshScene scene{"link " + std::to_string(link.link), m_mechanism.unit, {}, {}};
      for (const LinkPart& part : made.parts) {
        if (part.link != link.link) continue;
        MeshNode& node = scene.nodes.emplace_back();
        node.name = part.name;
        node.pose = part.pose;
        node.solid = part.solid;
      }
      if (scene.nodes.empty()) continue;
      options.mostTriangles -= std::min(options.mostTriangles, m_triangles);
      m_triangles = triangleCount(scene);
      auto encoded = encodedMesh(scene, MeshFormat::stl, scene.name, options);
      if (const auto* error = std::get_if<MeshFileError>(&encoded)) {
        const bool isLimit = error->kind == MeshFileError::Kind::limit;
        if (error->kind == MeshFileError::Kind::stopped) return stopped();
        return SimulatorError{isLimit ? SimulatorError::Kind::limit : SimulatorError::Kind::model,
                              error->message};
      }
      link.mesh = "meshes/link-" + std::to_string(link.link) + ".stl";
      m_model.meshes.emplace_back(link.mesh,
                                  std::move(std::get<std::vector<EncodedFile>>(encoded).front().bytes));
    }
    return std::nullopt;
  }

  const Mechanism& m_mechanism;
  const LiveKinematics& m_kinematics;
  const Placement& m_placement;
  const SpanningTree& m_tree;
  const MatroidAnalysis& m_matroid;
  const GearTrain& m_train;
  const SimulatorOptions& m_options;
  std::stop_token m_stop;
  MechanismDynamics m_dynamics;
  SimulatorModel m_model;
  std::size_t m_triangles = 0;
};

}  // namespace

std::variant<SimulatorModel, SimulatorError> simulatorModel(const AnalysisSnapshot& snapshot,
                                                            const GearTrain& train,
                                                            const SimulatorOptions& options,
                                                            const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(snapshot.matroid() != nullptr && snapshot.matroid()->solution);
  return ModelMaker(snapshot, train, options, stop).run();
}

}  // namespace geargraph
