#pragma once

#include <string>
#include <vector>

#include "core/foundations/files/byte_sink.h"
#include "core/foundations/files/csv.h"
#include "core/foundations/files/json_writer.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/dynamics/dynamics_report.h"

namespace geargraph::cli {

/// The results of `dynamics` for one mechanism.
struct DynamicsResult {
  SnapshotPtr snapshot;
  MechanismDynamics dynamics;
  SimulationOptions start;  ///< initial angles and speeds, motors; with `simulation` also the duration
  EquationOfMotion equation;
  Eigen::MatrixXd reflected;                     ///< reflected inertias, links x inputs
  Eigen::VectorXd torques;                       ///< motor torques at the start
  std::optional<Eigen::VectorXd> accelerations;  ///< std::nullopt if some motion moves no mass
  std::optional<Simulation> simulation;
};

/// The results as text for a terminal.
[[nodiscard]] std::string dynamicsText(const DynamicsResult& result);
/// Writes the output of `dynamics --json`. `result` is null if the mechanism has errors.
void writeDynamicsJson(JsonWriter& json, const DynamicsResult* result, const Diagnostics& diagnostics);
/// Writes one row per sample: time; angles, speeds, accelerations and torques of the inputs; energies and
/// work.
void writeMotionCsv(ByteSink& sink, const DynamicsResult& result, const CsvOptions& options);

}  // namespace geargraph::cli
