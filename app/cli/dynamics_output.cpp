#include "app/cli/dynamics_output.h"

#include <array>

#include "app/cli/text_table.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/result_json/diagnostics_json.h"
#include "core/theory/dynamics/motion_table.h"

namespace geargraph::cli {
namespace {

using Layout = JsonWriter::Layout;

std::string labelOfInput(const DynamicsResult& result, std::size_t input) {
  return std::to_string(result.snapshot->graph->edgeLabel(result.dynamics.inputs[input]));
}

std::vector<std::string> inputLabels(const DynamicsResult& result) {
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < result.dynamics.inputs.size(); ++i) labels.push_back(labelOfInput(result, i));
  return labels;
}

template <class Vector>
void writeNumbers(JsonWriter& json, const Vector& values) {
  json.beginArray(Layout::row);
  for (const double value : values) json.number(value);
  json.endArray();
}

void writeMatrixRows(JsonWriter& json, const Eigen::MatrixXd& matrix) {
  json.beginArray();
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) writeNumbers(json, matrix.row(row));
  json.endArray();
}

void writeLinks(JsonWriter& json, const DynamicsResult& result) {
  json.beginObject();
  for (std::size_t i = 1; i < result.dynamics.links.size(); ++i) {
    const LinkInertia& link = result.dynamics.links[i];
    const Eigen::Matrix3d& inertia = link.body.inertia;
    json.key(std::to_string(i));
    json.beginObject(Layout::row);
    json.member("mass", link.body.mass);
    json.key("center");
    writeNumbers(json, link.body.center);
    json.key("inertia");
    writeNumbers(json, std::array{inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2),
                                  inertia(1, 2)});
    json.member("source", std::string_view(massSourceName(link.source)));
    json.key("reflected");
    writeNumbers(json, result.reflected.row(static_cast<Eigen::Index>(i)));
    json.endObject();
  }
  json.endObject();
}

void writeSimulation(JsonWriter& json, const DynamicsResult& result) {
  if (!result.simulation) return json.null();
  const Simulation& simulation = *result.simulation;
  json.beginObject();
  json.member("end", endName(simulation.end));
  if (simulation.limitJoint >= 0)
    json.member("limitJoint", result.snapshot->graph->edgeLabel(simulation.limitJoint));
  json.key("columns");
  json.beginArray(Layout::row);
  for (const std::string& column : motionColumns(inputLabels(result))) json.string(column);
  json.endArray();
  json.key("rows");
  json.beginArray();
  for (const MotionSample& sample : simulation.samples) writeNumbers(json, motionRow(sample));
  json.endArray();
  json.endObject();
}

std::string endOf(const DynamicsResult& result) {
  const Simulation& simulation = *result.simulation;
  const int joint = simulation.limitJoint;
  return endSentence(simulation.end,
                     joint < 0 ? std::string() : std::to_string(result.snapshot->graph->edgeLabel(joint)));
}

/// The last row of the motion: what it has come to.
std::string motionText(const DynamicsResult& result) {
  const Simulation& simulation = *result.simulation;
  if (simulation.samples.empty()) return '\n' + translated("Motion") + "\n  " + endOf(result) + '\n';
  const MotionSample& last = simulation.samples.back();
  TextRows rows{
      {translated("input"), translated("angle, rad"), translated("speed, rad/s"), translated("torque, N m")}};
  for (std::size_t i = 0; i < result.dynamics.inputs.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    rows.push_back({labelOfInput(result, i), readableNumber(last.angles[at]), readableNumber(last.speeds[at]),
                    readableNumber(last.torques[at])});
  }
  std::string text = '\n' + aligned(translated("Motion, after %1 s", {readableNumber(last.time)}), rows);
  text +=
      "  " +
      translated("kinetic energy %1 J, potential %2 J, work of motors and loads %3 J",
                 {readableNumber(last.kinetic), readableNumber(last.potential), readableNumber(last.work)}) +
      '\n';
  const std::string end = endOf(result);
  return end.empty() ? text : text + "  " + end + '\n';
}

}  // namespace

std::string dynamicsText(const DynamicsResult& result) {
  TextRows links{{translated("link"), translated("mass, kg"), translated("from")}};
  for (std::size_t i = 0; i < result.dynamics.inputs.size(); ++i)
    links.front().push_back(translated("at motor %1, kg m²", {labelOfInput(result, i)}));
  for (std::size_t link = 1; link < result.dynamics.links.size(); ++link) {
    const LinkInertia& inertia = result.dynamics.links[link];
    std::vector<std::string> cells{std::to_string(link), readableNumber(inertia.body.mass),
                                   massSourceName(inertia.source)};
    for (const double reflected : result.reflected.row(static_cast<Eigen::Index>(link)))
      cells.push_back(readableNumber(reflected));
    links.push_back(std::move(cells));
  }
  TextRows motors{{translated("input"), translated("inertia, kg m²"), translated("holding torque, N m"),
                   translated("torque, N m"), translated("acceleration, rad/s²")}};
  for (std::size_t i = 0; i < result.dynamics.inputs.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    motors.push_back(
        {labelOfInput(result, i), readableNumber(result.equation.inertia(at, at)),
         readableNumber(result.equation.bias[at] - result.equation.load[at]),
         readableNumber(result.torques[at]),
         result.accelerations ? readableNumber((*result.accelerations)[at]) : translated("moves no mass")});
  }
  std::string text = aligned(translated("Links, and the inertia that each has at the motors"), links) + '\n' +
                     aligned(translated("Inputs, at the start"), motors);
  if (result.dynamics.inputs.size() > 1) {
    TextRows rows{{""}};
    for (std::size_t i = 0; i < result.dynamics.inputs.size(); ++i)
      rows.front().push_back(labelOfInput(result, i));
    for (std::size_t i = 0; i < result.dynamics.inputs.size(); ++i) {
      rows.push_back({labelOfInput(result, i)});
      for (const double entry : result.equation.inertia.row(static_cast<Eigen::Index>(i)))
        rows.back().push_back(readableNumber(entry));
    }
    text += '\n' + aligned(translated("Generalised inertia M, kg m²"), rows);
  }
  return result.simulation ? text + motionText(result) : text;
}

void writeDynamicsJson(JsonWriter& json, const DynamicsResult* result, const Diagnostics& diagnostics) {
  json.beginObject();
  json.member("format", "geargraph-dynamics");
  json.member("version", 1);
  if (result != nullptr) {
    json.key("inputs");
    json.beginArray(Layout::row);
    for (const int input : result->dynamics.inputs)
      json.number(std::int64_t{result->snapshot->graph->edgeLabel(input)});
    json.endArray();
    json.key("gravity");
    writeNumbers(json, result->dynamics.train.gravity);
    json.key("links");
    writeLinks(json, *result);
    json.key("inertia");
    writeMatrixRows(json, result->equation.inertia);
    json.key("bias");
    writeNumbers(json, result->equation.bias);
    json.key("load");
    writeNumbers(json, result->equation.load);
    json.key("torques");
    writeNumbers(json, result->torques);
    json.key("accelerations");
    if (result->accelerations) {
      writeNumbers(json, *result->accelerations);
    } else {
      json.null();
    }
    json.key("simulation");
    writeSimulation(json, *result);
  } else {
    for (const char* const name : {"inputs", "gravity", "links", "inertia", "bias", "load", "torques",
                                   "accelerations", "simulation"}) {
      json.key(name);
      json.null();
    }
  }
  json.key("diagnostics");
  writeDiagnostics(json, diagnostics);
  json.endObject();
}

void writeMotionCsv(ByteSink& sink, const DynamicsResult& result, const CsvOptions& options) {
  CsvWriter csv(sink, motionColumns(inputLabels(result)), options);
  for (std::size_t i = 0; i < result.simulation->samples.size() && !csv.failed(); ++i) {
    csv.row(std::to_string(i), motionRow(result.simulation->samples[i]));
  }
}

}  // namespace geargraph::cli
