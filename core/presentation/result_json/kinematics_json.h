#pragma once

#include "core/foundations/files/json_writer.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

// The values of the kinematic members of `analyze --json`, one function each; null if undefined. Joints,
// meshes and links are given by label.

/// [{"mesh", "carrier", "path", "axes", "sign"}]; carrier and sign are null if a mesh has none.
void writeTransferVertices(JsonWriter& json, const AnalysisSnapshot& snapshot);
/// The rows of engaged couplings below P, over the joints.
void writeCouplingRows(JsonWriter& json, const AnalysisSnapshot& snapshot);
void writeMatroidSolution(JsonWriter& json, const AnalysisSnapshot& snapshot);
void writeTtSolution(JsonWriter& json, const AnalysisSnapshot& snapshot);
void writeAgreement(JsonWriter& json, const AnalysisSnapshot& snapshot);
void writeJointSpeeds(JsonWriter& json, const AnalysisSnapshot& snapshot);
void writeLinkVelocities(JsonWriter& json, const AnalysisSnapshot& snapshot);

}  // namespace geargraph
