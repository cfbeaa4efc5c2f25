#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "core/presentation/meshfile/mesh_writer.h"
#include "core/presentation/meshfile/train_files.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// Why an export failed.
struct ExportFailure {
  enum class Kind {
    stopped,
    mechanism,  ///< the mechanism has errors
    limit,      ///< the mechanism is too large, or its period too long
    triangles,  ///< more than the limit at this tolerance
    choice,     ///< there is no such gear or link
  };
  Kind kind = Kind::mechanism;
  std::string message;           ///< a sentence without its full stop; empty if `diagnostics` explain it
  Diagnostics diagnostics = {};  ///< gears that cannot be made
};

/// An analysed mechanism with its gears and motions.
struct ExportTrain {
  SnapshotPtr snapshot;  ///< with a tree and its kinematics
  GearTrain train;
  Diagnostics diagnostics;  ///< of the train: teeth, assembly, clearance
  /// Rates of all joints (rad/s): at the document's speeds, and with all inputs at different ones, which
  /// moves meshes that are at rest at the former. Empty without a solution.
  std::vector<std::vector<Rational>> motions;

  [[nodiscard]] const Mechanism& mechanism() const { return *snapshot->mechanism; }
  [[nodiscard]] PlacedTrain placed() const {
    return {mechanism(), *snapshot->tree, snapshot->kinematics->placement(), train};
  }
};

/// Makes the gears of a snapshot without errors. Cost: that of the wheels and bodies, once per snapshot.
[[nodiscard]] std::variant<ExportTrain, ExportFailure> exportTrain(SnapshotPtr snapshot,
                                                                   const std::stop_token& stop = {});

/// The gear named "15:tail", by the label of its mesh, or by the id of its wheel; null if there is none.
[[nodiscard]] const TrainGear* gearNamed(const ExportTrain& train, std::string_view name);

/// The options of an export of solids.
struct SolidsChoice {
  /// The chordal error, in modules. None: kExportTolerance, or the finest coarser one that keeps the train
  /// below the limit of triangles.
  std::optional<double> tolerance = {};
  std::optional<std::string> link = {};  ///< only the link with this label
  bool moves = false;                    ///< with the motion at the document's speeds
  /// The duration of one period in the file, or of the way there and back between the limits of joints, s; 0:
  /// real time. If the period is too long for a file: this many
  /// seconds of the motion in real time; 0: kStretch, less of what is faster, and of what is faster still the
  /// train at rest.
  double seconds = 0;
};

struct TrainSolids {
  MeshScene scene;
  double tolerance = 0;  ///< the one taken, in modules
  Diagnostics left;  ///< about gears of a large train that cannot be made and are left out, as in the 3D view
  std::string shows;  ///< what the file shows instead of one period, as between limits; empty otherwise
};

/// The whole train, or one link of it, as a scene for a 3D file. Fails if a gear of a small train cannot be
/// made.
[[nodiscard]] std::variant<TrainSolids, ExportFailure> trainSolids(const ExportTrain& train,
                                                                   const SolidsChoice& choice,
                                                                   const std::stop_token& stop = {});

/// One gear, alone in its own frame.
[[nodiscard]] std::variant<MeshScene, ExportFailure> gearScene(const ExportTrain& train,
                                                               const std::string& name, double tolerance);

/// All gears with poses in `frames` moments, for a check of their teeth (assemblyOf()).
[[nodiscard]] std::variant<Assembly, ExportFailure> trainAssembly(const ExportTrain& train, double tolerance,
                                                                  std::size_t frames,
                                                                  const std::stop_token& stop = {});

// Bounds of the options.
constexpr double kFinestTolerance = 1e-4;  ///< modules
constexpr double kCoarsestTolerance = 0.2;
constexpr double kShortestAnimation = 1e-3;  ///< s
constexpr double kMaxAnimation = 1e6;
constexpr double kStretch = 60;  ///< s of a motion whose period is too long
constexpr std::size_t kMaxAssemblyFrames = 10'000;

}  // namespace geargraph
