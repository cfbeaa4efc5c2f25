// The torques of a mesh's two ports.

#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

Question portTorqueQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const MeshOrdinal mesh = random.below(source.graph().c());
  const TerminalPair& pair = *source.ttGraph()->terminal(mesh);
  const std::string label = source.meshLabel(mesh);
  const std::string comma = source.graph().n() > 9 ? "," : "";
  const std::string tail = source.linkLabel(pair.tail) + comma + source.linkLabel(pair.carrier);
  const std::string head = source.linkLabel(pair.head) + comma + source.linkLabel(pair.carrier);
  const Rational speed(pair.sign * pair.tailTeeth, pair.headTeeth);  // w_head = speed * w_tail
  const Rational factor = -speed.inverse();
  QuestionBuilder build(ExerciseKind::portTorque, 3);
  build.question.prompt = translated(
      "The terminal equation of mesh $%1$ is $\\omega_{%2} = %3 \\, \\omega_{%4}$. No power is lost. Write "
      "the torque of the second port in terms of the first one's: the factor $f$ with its sign.",
      {label, head, asTex(speed), tail});
  build.question.formula = "M_{" + head + "} = f \\, M_{" + tail + "}";
  build.question.elements = {source.meshId(mesh)};
  build.question.rule = translated(
      "The powers of both ports add up to 0, so that the torques have the inverse ratio of the speeds with "
      "the opposite sign: f = %1.",
      {inWords(factor)});
  build.field("f", FieldKind::number, {}, {source.meshId(mesh)});
  build.accept({factor.toString()});
  const std::vector<ElementId> elements{source.meshId(mesh)};
  build.wrong(
      "torque-sign", {(-factor).toString()},
      translated("The ratio is right, but the sign is not: what one port takes in the other gives off."),
      elements);
  build.wrong(
      "torque-as-speed", {speed.toString()},
      translated("You use the relation of the speeds: torques have the inverse ratio and the opposite sign."),
      elements);
  build.wrong("ratio-upside-down", {factor.inverse().toString()},
              translated("Your ratio is upside down: the gear that turns more slowly has the larger torque."),
              elements);
  return std::move(build.question);
}

}  // namespace

ExerciseEntry portTorqueEntry() {
  return {.kind = ExerciseKind::portTorque,
          .name = "port-torque",
          .title = toTranslate("Torque of a port, sign"),
          .hint = toTranslate(
              "Write the power of each port, torque times speed. Their sum is zero if no power is lost; "
              "then put in the terminal equation."),
          .view = LessonView::schematic,
          .lack = withoutEquations,
          .make = portTorqueQuestion};
}

}  // namespace geargraph
