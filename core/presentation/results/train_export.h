#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "core/presentation/meshfile/mesh_writer.h"
#include "core/presentation/meshfile/train_files.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::inline results {

/// Why no gears are exported.
struct ExportFailure {
  enum class Kind {
    stopped,
    mechanism,  ///< it has errors
    limit,      ///< it is too large, or its period too long
    triangles,  ///< more than the limit at this tolerance
    choice,     ///< there is no such gear or link
  };
  Kind kind = Kind::mechanism;
  std::string message;           ///< a sentence without its full stop; empty where `diagnostics` say all
  Diagnostics diagnostics = {};  ///< gears that cannot be made
};

/// An analysed mechanism with its gears and how they move.
struct ExportTrain {
  SnapshotPtr snapshot;  ///< with a tree and its kinematics
  GearTrain train;
  Diagnostics diagnostics;  ///< of the train: teeth, assembly, clearance
  /// Rates of all joints (rad/s): at the document's speeds, and with all inputs at different ones, which
  /// moves meshes that those leave at rest. Empty where there is nothing to solve.
  std::vector<std::vector<Rational>> motions;

  [[nodiscard]] const Mechanism& mechanism() const { return *snapshot->mechanism; }
  [[nodiscard]] PlacedTrain placed() const {
    return {mechanism(), *snapshot->tree, snapshot->kinematics->placement(), train};
  }
};

/// Makes the gears of a snapshot without errors. Cost: that of the wheels and bodies, once a snapshot.
[[nodiscard]] std::variant<ExportTrain, ExportFailure> exportTrain(SnapshotPtr snapshot,
                                                                   const std::stop_token& stop = {});

/// The gear named "15:tail", after the label of its mesh, or by the id of its wheel; null where there is
/// none.
[[nodiscard]] const TrainGear* gearNamed(const ExportTrain& train, std::string_view name);

/// What is exported of a train, and how finely.
struct SolidsChoice {
  /// Of chords, in modules. None: kExportTolerance, or the finest coarser one that keeps the train below the
  /// limit of triangles.
  std::optional<double> tolerance = {};
  std::optional<std::string> link = {};  ///< only the link with this label
  bool moves = false;                    ///< with the motion at the document's speeds
  /// How long one period plays; 0: as long as it takes. Of a period that is too long for a file, as many
  /// seconds of the motion as it really is; 0: kStretch.
  double seconds = 0;
};

struct TrainSolids {
  MeshScene scene;
  double tolerance = 0;  ///< the one taken, in modules
  Diagnostics left;      ///< gears of a large train that cannot be made: left out, as in the 3D view
  std::string shows;     ///< what the file shows instead of one period, and why; empty otherwise
};

/// The whole train, or one link of it, as a scene for a 3D file. A train of few gears needs all of them.
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

// Bounds of what may be asked for.
constexpr double kFinestTolerance = 1e-4;  ///< modules
constexpr double kCoarsestTolerance = 0.2;
constexpr double kShortestAnimation = 1e-3;  ///< s
constexpr double kLongestAnimation = 1e6;
constexpr double kStretch = 60;  ///< s of a motion whose period is too long
constexpr std::size_t kMostAssemblyFrames = 10'000;

}  // namespace geargraph::inline results
