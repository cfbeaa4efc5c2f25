// Speeds that follow from given inputs.

#include <algorithm>

#include "core/mechanism/graph/spanning_tree.h"
#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"
#include "core/teaching/exercises/rate_system.h"

namespace geargraph {
namespace {

constexpr int kFastest = 6;     ///< rad/s of an input
constexpr int kMaxMeshes = 12;  ///< whose mistakes are tried

using Speeds = std::vector<std::pair<int, Rational>>;

std::vector<std::vector<Rational>> rowsWith(const ExerciseSource& source, int changed, RowChange change) {
  std::vector<std::vector<Rational>> rows;
  for (MeshOrdinal mesh = 0; mesh < source.graph().c(); ++mesh)
    rows.push_back(source.teethRow(mesh, mesh == changed ? change : RowChange::none));
  return rows;
}

/// The rows of meshes whose carriers are taken for the ground.
std::vector<std::vector<Rational>> rowsFromGround(const ExerciseSource& source) {
  std::vector<std::vector<Rational>> rows;
  for (MeshOrdinal mesh = 0; mesh < source.graph().c(); ++mesh) {
    const TerminalPair& pair = *source.ttGraph()->terminal(mesh);
    std::vector<Rational> row;
    for (JointOrdinal joint = 0; joint < source.graph().t(); ++joint) {
      row.push_back(Rational(pair.tailTeeth * -source.tree()->pathEntry(joint, pair.tail)) -
                    Rational(pair.sign * pair.headTeeth * -source.tree()->pathEntry(joint, pair.head)));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

std::vector<int> predictableJoints(const ExerciseSource& source) {
  std::vector<int> joints;
  for (JointOrdinal joint = 0; joint < source.graph().t(); ++joint) {
    const auto& rates = source.rates()[static_cast<std::size_t>(joint)];
    const bool turns =
        std::any_of(rates.begin(), rates.end(), [](const Rational& rate) { return !rate.isZero(); });
    const bool isInput =
        std::find(source.inputs().begin(), source.inputs().end(), joint) != source.inputs().end();
    if (turns && !isInput) joints.push_back(joint);
  }
  return joints;
}

namespace {

Question speedQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const JointOrdinal joint = random.oneOf(predictableJoints(source));
  const auto& rates = source.rates()[static_cast<std::size_t>(joint)];
  Speeds speeds;
  Rational right;
  while (right.isZero()) {  // of some speeds the contributions cancel
    speeds.clear();
    right = 0;
    for (std::size_t i = 0; i < source.inputs().size(); ++i) {
      const int size = random.between(1, kFastest);
      speeds.emplace_back(source.inputs()[i], random.below(2) == 0 ? size : -size);
      right += rates[i] * speeds.back().second;
    }
  }
  const std::string name = source.edgeLabel(joint);
  QuestionBuilder build(ExerciseKind::speed, 5);
  std::vector<std::string> given;
  for (const auto& [input, speed] : speeds)
    given.push_back("$\\dot{\\theta}_{" + source.edgeLabel(input) + "} = " + asTex(speed) + "$");
  build.question.prompt = translated(
      "The inputs turn at %1 rad/s. What is $\\dot{\\theta}_{%2}$ in rad/s? A fraction or a decimal of three "
      "digits will do.",
      {listed(given, kAllNames), name});
  build.question.elements = {source.edgeId(joint)};
  build.question.rule =
      translated("The meshes in the chain give joint %1 the rate %2 rad/s.", {name, inWords(right)});
  build.field("speed of joint " + name, FieldKind::number, {}, {source.edgeId(joint)});
  build.titled(translated("speed of joint %1", {name}));
  build.inUnit("rad/s");
  build.accept({right.toString()});

  const auto add = [&](const char* mistake, const std::optional<std::vector<Rational>>& all,
                       const std::string& reason, const std::vector<ElementId>& elements) {
    if (all) build.wrong(mistake, {(*all)[static_cast<std::size_t>(joint)].toString()}, reason, elements);
  };
  build.wrong("sign-lost", {(-right).toString()},
              translated("The size is right, but the joint turns the other way."), {source.edgeId(joint)});
  for (std::size_t i = 0; i < speeds.size() && speeds.size() > 1; ++i) {
    const std::string input = source.edgeLabel(speeds[i].first);
    build.wrong("input-ignored", {(right - rates[i] * speeds[i].second).toString()},
                translated("You leave out input %1: the contributions of all inputs add up.", {input}),
                {source.edgeId(speeds[i].first)});
  }
  if (speeds.size() == 1) {
    build.wrong(
        "speed-inverted", {(speeds.front().second * speeds.front().second / right).toString()},
        translated("You multiply by the whole ratio where you have to divide by it: %1 turns at %2 rad/s.",
                   {name, inWords(right)}),
        {source.edgeId(joint)});
  }
  const int meshes = std::min(source.graph().c(), kMaxMeshes);
  for (MeshOrdinal mesh = 0; mesh < meshes; ++mesh) {
    const std::string label = source.meshLabel(mesh);
    add("ratio-upside-down", ratesFrom(rowsWith(source, mesh, RowChange::upsideDown), speeds),
        translated("You use the ratio of mesh %1 upside down.", {label}), {source.meshId(mesh)});
    add("mesh-sign", ratesFrom(rowsWith(source, mesh, RowChange::signOfHead), speeds),
        translated("The sign of mesh %1 is the opposite in your chain.", {label}), {source.meshId(mesh)});
  }
  if (source.ttGraph() != nullptr) {
    add("carrier-ignored", ratesFrom(rowsFromGround(source), speeds),
        translated("You use speeds relative to the ground in the meshes: a mesh relates the speeds of its "
                   "gears in their carrier."),
        {source.edgeId(joint)});
  }
  const Speeds known = speeds;
  if (const auto all = ratesFrom(rowsWith(source, -1, RowChange::none), known)) {
    const LinkOrdinal child = source.tree()->child(joint);
    Rational absolute;
    for (int other = 0; other < source.graph().t(); ++other)
      absolute += (*all)[static_cast<std::size_t>(other)] * Rational(-source.tree()->pathEntry(other, child));
    build.wrong("absolute-for-relative", {absolute.toString()},
                translated("This is the speed of link %1 relative to the ground: the joint's rate is "
                           "relative to the link that carries it.",
                           {source.linkLabel(child)}),
                {source.edgeId(joint), source.linkId(child)});
  }
  return std::move(build.question);
}

Lack withoutPredictable(const ExerciseSource& source) {
  if (const Lack reason = withoutFreedom(source)) return reason;
  constexpr int kMaxInputs = 6;
  if (source.matroid()->dof > kMaxInputs) return translated("too many inputs");
  return predictableJoints(source).empty() ? Lack(translated("no speed follows from the inputs"))
                                           : std::nullopt;
}

}  // namespace

ExerciseEntry speedEntry() {
  return {.kind = ExerciseKind::speed,
          .name = "speed",
          .title = toTranslate("Predict a speed"),
          .hint = toTranslate(
              "Look for a mesh whose equation has one unknown speed only, solve it, and go on to the "
              "next. A row of P θ̇ = 0 holds the joints of one cycle."),
          .view = LessonView::schematic,
          .lack = withoutPredictable,
          .make = speedQuestion};
}

}  // namespace geargraph
