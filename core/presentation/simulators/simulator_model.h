#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/foundations/files/folder.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/solids/mass_properties.h"
#include "core/machine/train/train.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/pose/joint_limits.h"

namespace geargraph {

/// How the inputs are driven in the simulator.
enum class SimulatorMotor : std::uint8_t {
  speed,   ///< servos that hold the document's speeds, with rotors
  torque,  ///< motors that take a torque
  none,
};

struct SimulatorOptions {
  double timestep = 0.001;  ///< s
  SimulatorMotor motor = SimulatorMotor::speed;
  std::optional<double> armature;       ///< rotor inertia, kg m²; none: 100 times the reflected inertia
  double tolerance = kScreenTolerance;  ///< of the visual meshes, modules
};

/// A link as a rigid body with the joint to its parent. Lengths in m; all frames are parallel to the base
/// frame in the reference pose.
struct SimulatedLink {
  LinkOrdinal link = 0;
  int parent = 0;           ///< link; that of the ground is the ground
  std::string name;         ///< its id
  JointOrdinal joint = -1;  ///< ordinal; -1 for the ground
  std::string jointName;
  /// The axis of the joint's rotation: its direction if the joint's arrow points away from the ground, else
  /// the opposite, so that the angle is that of the document.
  Eigen::Vector3d axis{0, 0, 1};
  AngleLimits limits;               ///< of the joint, rad
  Eigen::Vector3d origin{0, 0, 0};  ///< of its frame, on the axis at the bearing, in the base frame
  MassProperties body;              ///< base frame
  bool isBall = false;  ///< it has neither a solid nor a stated mass: a ball of a bearing's size is used
  std::string mesh;     ///< file within the folder, base frame, document's unit; empty: none
};

/// A linear constraint of joint angles: a mesh, or an engaged coupling.
struct SimulatedRow {
  std::string name;
  std::vector<std::pair<int, double>>
      joints;  ///< with coefficients; of a mesh in m, so that its force is in N
  bool isActive = true;
};

struct SimulatedInput {
  JointOrdinal joint = 0;
  double speed = 0;    ///< rad/s
  double inertia = 0;  ///< reflected inertia in the reference pose, the other inputs at rest, kg m²
};

/// A sentence for people: the program's language where it is shown, English in the files, whose comments are
/// for users of other programs.
struct SimulatorNote {
  std::string text;
  std::string inEnglish;
};

/// A mechanism for rigid-body simulators.
struct SimulatorModel {
  std::string name;
  double metres = 0.001;  ///< in one of the document's unit
  double density = 7850;
  Eigen::Vector3d gravity{0, 0, 0};
  std::vector<SimulatedLink> links;  ///< by ordinal, the ground first
  std::vector<int> order;            ///< links, parents before children, without the ground
  std::vector<std::string> joints;   ///< names by ordinal
  std::vector<SimulatedRow> rows;
  std::vector<SimulatedInput> inputs;
  /// K by joint and input, exact: theta_joint = K theta_inputs.
  std::vector<std::vector<Rational>> gains;
  FolderFiles meshes;
  std::vector<SimulatorNote> notes;  ///< on what the files leave out or rename
};

/// Why there is no model, as a sentence.
struct SimulatorError {
  enum class Kind : std::uint8_t { stopped, limit, model };
  Kind kind = Kind::model;
  std::string message;
};

/// The model of a mechanism as engaged. Rows of meshes are teeth times metres per tooth (pitch radius of the
/// tail over its teeth), so the ratio is exactly that of the teeth. Fails for links too light for simulators,
/// unknown units of length, and above the limit of triangles.
/// Cost: that of the solids and masses.
/// @pre the snapshot has no errors, a tree and a solution with its matrix; `train` is its own
[[nodiscard]] std::variant<SimulatorModel, SimulatorError> simulatorModel(const AnalysisSnapshot& snapshot,
                                                                          const GearTrain& train,
                                                                          const SimulatorOptions& options,
                                                                          const std::stop_token& stop = {});

/// The model as MJCF, the format of MuJoCo: every mesh and coupling is a fixed tendon with an equality
/// constraint.
[[nodiscard]] std::string mjcfText(const SimulatorModel& model, const SimulatorOptions& options);

/// The model as URDF, in which a joint can mimic only one other joint. Fails if a joint depends on several;
/// the message has the equations of the first three.
[[nodiscard]] std::variant<std::string, SimulatorError> urdfText(const SimulatorModel& model);

}  // namespace geargraph
