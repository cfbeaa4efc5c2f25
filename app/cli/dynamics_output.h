#pragma once

#include <string>
#include <vector>

#include "core/foundations/files/byte_sink.h"
#include "core/foundations/files/csv.h"
#include "core/foundations/files/json_writer.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/dynamics/dynamics_report.h"

namespace geargraph::cli {

/// What `dynamics` has found about one mechanism.
struct DynamicsResult {
  SnapshotPtr snapshot;
  MechanismDynamics dynamics;
  SimulationOptions start;  ///< angles, speeds and motors; with `simulation` also how long
  EquationOfMotion equation;
  Eigen::MatrixXd reflected;                     ///< links x inputs
  Eigen::VectorXd torques;                       ///< of the motors at the start
  std::optional<Eigen::VectorXd> accelerations;  ///< none where a motion moves no mass
  std::optional<Simulation> simulation;
};

/// For people.
[[nodiscard]] std::string dynamicsText(const DynamicsResult& result);
/// `dynamics --json`; with null where the mechanism has errors.
void writeDynamicsJson(JsonWriter& json, const DynamicsResult* result, const Diagnostics& diagnostics);
/// A row a sample: time, angles, speeds, accelerations and torques of the inputs, energies and work.
void writeMotionCsv(ByteSink& sink, const DynamicsResult& result, const CsvOptions& options);

}  // namespace geargraph::cli
