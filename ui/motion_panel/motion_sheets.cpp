#include "ui/motion_panel/motion_sheets.h"

#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/csv.h"
#include "core/presentation/drawing/palette.h"
#include "core/theory/dynamics/motion_table.h"

namespace geargraph {
namespace {

Rgb rgbOf(int number) {
  const Color color = linkColor(number);
  return {static_cast<float>(color.red) / 255, static_cast<float>(color.green) / 255,
          static_cast<float>(color.blue) / 255};
}

/// The colour of the link that a joint moves.
Rgb colorOfJoint(const MechanismDynamics& train, const Mechanism& mechanism, int joint) {
  return rgbOf(mechanism.colorNumber(train.train.tree->child(joint)));
}

std::string nameOf(const Mechanism& mechanism, int joint) {
  return translated("joint %1", {std::to_string(mechanism.jointLabel(joint))});
}

MotionCurve curveOf(const Simulation& simulation, std::string name, const Rgb& colour,
                    const std::function<double(const MotionSample&)>& value) {
  MotionCurve curve{std::move(name), colour, false, {}};
  for (const MotionSample& sample : simulation.samples) curve.values.push_back(value(sample));
  return curve;
}

void addSpeeds(CurveSheet& sheet, const Mechanism& mechanism, const SimulatedMotion& motion,
               const std::set<ElementId>& chosen) {
  const MechanismDynamics& train = *motion.train;
  std::vector<int> joints = train.inputs;
  for (int joint = 0; joint < mechanism.t(); ++joint) {
    const bool isInput = std::find(joints.begin(), joints.end(), joint) != joints.end();
    if (!isInput && chosen.contains(mechanism.turningJoints[static_cast<std::size_t>(joint)].id))
      joints.push_back(joint);
  }
  for (const int joint : joints) {
    sheet.curves.push_back(
        curveOf(motion.simulation, nameOf(mechanism, joint), colorOfJoint(train, mechanism, joint),
                [&](const MotionSample& sample) { return train.train.gains.row(joint).dot(sample.speeds); }));
  }
}

void addTorques(CurveSheet& sheet, const Mechanism& mechanism, const SimulatedMotion& motion) {
  for (std::size_t i = 0; i < motion.train->inputs.size(); ++i) {
    const int joint = motion.train->inputs[i];
    sheet.curves.push_back(
        curveOf(motion.simulation, nameOf(mechanism, joint), colorOfJoint(*motion.train, mechanism, joint),
                [i](const MotionSample& sample) { return sample.torques[static_cast<Eigen::Index>(i)]; }));
  }
}

void addEnergies(CurveSheet& sheet, const SimulatedMotion& motion) {
  const Simulation& simulation = motion.simulation;
  const MotionSample& first = simulation.samples.front();
  const double start = first.kinetic + first.potential - first.work;
  const auto add = [&](const std::string& name, int colour, const auto& value) {
    sheet.curves.push_back(curveOf(simulation, name, rgbOf(colour), value));
  };
  add(translated("kinetic"), 1, [](const MotionSample& sample) { return sample.kinetic; });
  add(translated("potential"), 3,
      [&](const MotionSample& sample) { return sample.potential - first.potential; });
  add(translated("work done"), 2, [](const MotionSample& sample) { return sample.work; });
  add(translated("energy balance"), 4,
      [&](const MotionSample& sample) { return sample.kinetic + sample.potential - sample.work - start; });
}

}  // namespace

CurveSheet motionSheet(const Mechanism& mechanism, const SimulatedMotion& motion, MotionQuantity quantity,
                       const std::set<ElementId>& chosen) {
  CurveSheet sheet;
  for (const MotionSample& sample : motion.simulation.samples) sheet.times.push_back(sample.time);
  switch (quantity) {
    case MotionQuantity::speeds:
      sheet.title = translated("Speeds of the joints");
      sheet.unit = "rad/s";
      addSpeeds(sheet, mechanism, motion, chosen);
      break;
    case MotionQuantity::torques:
      sheet.title = translated("Torques of the motors");
      sheet.unit = "N m";
      addTorques(sheet, mechanism, motion);
      break;
    case MotionQuantity::energies:
      sheet.title = translated("Energy gained and work done");
      sheet.unit = "J";
      addEnergies(sheet, motion);
      break;
  }
  return sheet;
}

InputTrajectoryPtr trajectoryOf(const Simulation& simulation) {
  std::vector<InputTrajectory::Sample> samples;
  for (const MotionSample& sample : simulation.samples) {
    samples.push_back({sample.time,
                       {sample.angles.begin(), sample.angles.end()},
                       {sample.speeds.begin(), sample.speeds.end()}});
  }
  return std::make_shared<const InputTrajectory>(std::move(samples));
}

std::string motionCsv(const Mechanism& mechanism, const SimulatedMotion& motion, char separator) {
  std::vector<std::string> inputs;
  for (const int joint : motion.train->inputs) inputs.push_back(std::to_string(mechanism.jointLabel(joint)));
  TextSink sink;
  {
    CsvOptions options;
    options.separator = separator;
    CsvWriter csv(sink, motionColumns(inputs), options);
    for (std::size_t i = 0; i < motion.simulation.samples.size(); ++i)
      csv.row(std::to_string(i), motionRow(motion.simulation.samples[i]));
  }
  return sink.text();
}

}  // namespace geargraph
