#include "core/presentation/step/step_model.h"

#include <algorithm>
#include <charconv>

#include "core/foundations/base/translation.h"
#include "core/machine/solids/spec_diagnostics.h"
#include "core/presentation/brep/body_brep.h"
#include "core/presentation/brep/brep_builder.h"
#include "core/presentation/brep/wheel_brep.h"

namespace geargraph {
namespace {

/// Some digits, with a point in every language: it goes into a file.
std::string digits(double value) {
  std::array<char, 32> text{};
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3).ptr};
}

std::string nameOf(const Mechanism& mechanism, LinkOrdinal link) {
  const std::string& name = mechanism.links[link].name;
  return name.empty() ? "link " + std::to_string(mechanism.linkLabel(link)) : name;
}

class Assembler {
 public:
  Assembler(const Mechanism& mechanism, double millimetres,
            const std::function<std::array<float, 3>(int)>& colour)
      : m_mechanism(mechanism), m_scale(millimetres), m_colour(colour) {}

  StepModel model;

  /// A part in its place; the pose in the mechanism's unit.
  void add(LinkOrdinal link, const std::string& name, std::vector<Brep> solids, Eigen::Isometry3d pose,
           bool isAlone) {
    for (const Brep& solid : solids) model.faces += solid.faces.size();
    for (Brep& solid : solids) solid = placed(std::move(solid), Eigen::Isometry3d::Identity(), m_scale);
    pose.translation() *= m_scale;
    const int part = static_cast<int>(model.assembly.parts.size());
    model.assembly.parts.push_back({name, m_colour(m_mechanism.colorNumber(link)), std::move(solids)});
    model.assembly.nodes.push_back({name, pose, isAlone ? -1 : nodeOf(link), part});
  }

 private:
  int nodeOf(LinkOrdinal link) {
    if (m_link != link) {
      m_link = link;
      m_node = static_cast<int>(model.assembly.nodes.size());
      model.assembly.nodes.push_back({nameOf(m_mechanism, link), Eigen::Isometry3d::Identity(), -1, -1});
    }
    return m_node;
  }

  const Mechanism& m_mechanism;
  double m_scale;
  const std::function<std::array<float, 3>(int)>& m_colour;
  LinkOrdinal m_link = -1;
  int m_node = -1;
};

}  // namespace

std::variant<StepModel, StepFailure> stepModel(const Mechanism& mechanism, const GearTrain& train,
                                               const std::string& name, double millimetres,
                                               const std::function<std::array<float, 3>(int)>& colour,
                                               const StepChoice& choice, const std::stop_token& stop) {
  Diagnostics wrong;
  const auto isAsked = [&](const TrainGear& gear) {
    return choice.gear != nullptr ? &gear == choice.gear : !choice.link || gear.link == *choice.link;
  };
  for (const TrainGear& gear : train.gears) {
    if (isAsked(gear)) append(wrong, specDiagnostics(gear.spec));
  }
  for (const TrainGear& gear : train.gears) {
    if (!isAsked(gear)) continue;
    if (const char* const why = noExactFaces(gear.spec); *why != 0)
      wrong.push_back({Code::teethGeometry, translated(why, {gear.name}), {}, {}, 0, 0});
  }
  if (!wrong.empty()) return StepFailure{StepFailure::Kind::gears, std::move(wrong)};
  Assembler assembler(mechanism, millimetres, colour);
  StepModel& model = assembler.model;
  const auto addGear = [&](const TrainGear& gear, const Eigen::Isometry3d& pose) {
    WheelBrep wheel = wheelBrep(gear.spec, choice.deviation);
    model.deviation = std::max(model.deviation, wheel.deviation / toothSize(gear.spec));
    std::vector<Brep> solids;
    solids.push_back(std::move(wheel.solid));
    assembler.add(gear.link, gear.name, std::move(solids), pose, choice.gear != nullptr);
  };
  for (std::size_t link = 0; link < mechanism.links.size(); ++link) {
    for (const TrainGear& gear : train.gears) {
      if (stop.stop_requested()) return StepFailure{};
      if (gear.link != static_cast<int>(link) || !isAsked(gear)) continue;
      addGear(gear, choice.gear != nullptr ? Eigen::Isometry3d::Identity() : gear.pose);
      if (model.faces > kMaxStepFaces) return StepFailure{StepFailure::Kind::tooLarge, {}, model.faces};
    }
    for (const LinkBody& body : train.bodies) {
      if (body.link != static_cast<int>(link) || choice.gear != nullptr ||
          (choice.link && *choice.link != body.link))
        continue;
      const std::string label = std::to_string(mechanism.linkLabel(body.link));
      assembler.add(body.link, "body of link " + label, bodyBreps(*body.recipe),
                    Eigen::Isometry3d::Identity(), false);
    }
  }
  if (model.assembly.parts.empty()) return StepFailure{StepFailure::Kind::nothing};
  model.assembly.name = name;
  model.assembly.description = "Gear train; tooth surfaces within " +
                               digits(std::max(choice.deviation, model.deviation)) +
                               " modules of their exact form; lengths in mm";
  return std::move(model);
}

}  // namespace geargraph
