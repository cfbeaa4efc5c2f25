// What a brake does to its link and to the housing: torque and sense.

#include <algorithm>

#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/exercise_statics.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

constexpr int kLeastTorque = 5;  ///< N m at the drive
constexpr int kMaxTorque = 60;
constexpr const char* kWith = toTranslate("as the drive's torque");
constexpr const char* kAgainst = toTranslate("against the drive's torque");

/// An engaged brake that carries a torque about the axis of the drive.
struct HoldingBrake {
  StateTorques state;
  ShiftElementOrdinal coupling = 0;
  bool isAlone = false;  ///< no other brake is engaged, and the load turns about the same axis
  [[nodiscard]] const Rational& torque() const { return *state.couplings[coupling]; }
};

const ShiftElement& couplingOf(const ExerciseSource& source, ShiftElementOrdinal coupling) {
  return source.mechanism().couplings[coupling];
}

/// The first axis on the way from a link to the ground.
const AxisId& axisOf(const ExerciseSource& source, const LinkId& link) {
  const JointOrdinal joint = source.tree()->jointToParent(source.graph().nodeOf(link));
  return source.mechanism().turningJoints[joint].axis;
}

std::vector<HoldingBrake> holdingBrakes(const ExerciseSource& source) {
  std::vector<HoldingBrake> brakes;
  const auto& states = source.mechanism().states;
  for (int state = 0; state < static_cast<int>(states.size()); ++state) {
    const auto torques = stateTorques(source, state);
    if (!torques) continue;
    const ShiftState& asked = states[static_cast<std::size_t>(state)];
    const AxisId& axis = axisOf(source, *asked.drive);
    const auto isBrake = [&](ShiftElementOrdinal coupling) {
      return torques->couplings[coupling] && couplingOf(source, coupling).kind == ShiftElementKind::brake;
    };
    const auto all = static_cast<int>(torques->couplings.size());
    int engaged = 0;
    for (ShiftElementOrdinal coupling = 0; coupling < all; ++coupling) engaged += isBrake(coupling) ? 1 : 0;
    for (ShiftElementOrdinal coupling = 0; coupling < all; ++coupling) {
      if (!isBrake(coupling) || torques->couplings[coupling]->isZero()) continue;
      if (axisOf(source, couplingOf(source, coupling).links.front()) != axis) continue;
      brakes.push_back({*torques, coupling, engaged == 1 && axisOf(source, *asked.driven) == axis});
    }
  }
  return brakes;
}

class ReactionQuestion {
 public:
  ReactionQuestion(const ExerciseSource& source, HoldingBrake brake, int drive)
      : m_source(source),
        m_brake(std::move(brake)),
        m_drive(drive),
        m_state(source.mechanism().states[static_cast<std::size_t>(m_brake.state.state)]),
        m_coupling(couplingOf(source, m_brake.coupling)),
        m_torque(m_brake.torque() * drive) {}

  Question make() {
    ask();
    m_build.accept({m_torque.toString(), senseOf(-m_torque)});
    addTorques();
    addSenses();
    return std::move(m_build.question);
  }

 private:
  /// The drive's torque is positive.
  [[nodiscard]] const std::string& senseOf(const Rational& torque) const {
    return torque.sign() > 0 ? m_with : m_against;
  }
  [[nodiscard]] std::string label(const LinkId& link) const {
    return m_source.linkLabel(m_source.graph().nodeOf(link));
  }
  [[nodiscard]] std::string held() const { return label(m_coupling.links.front()); }

  void ask() {
    std::vector<std::string> engaged;
    for (std::size_t i = 0; i < m_brake.state.couplings.size(); ++i)
      if (m_brake.state.couplings[i])
        engaged.push_back(namedInPrompt(couplingOf(m_source, static_cast<int>(i)).id.text()));
    const std::string brake = namedInPrompt(m_coupling.id.text());
    const std::string held = this->held();
    m_build.question.prompt = translated(
        "State “%1” engages %2, link $%3$ drives and link $%4$ bears the load. The torque of the drive is "
        "$%5$ N m, and no power is lost. What torque, with its sign, does brake %6 exert on link $%7$? And "
        "in "
        "which sense does it try to turn the housing? A fraction or a decimal of three digits will do.",
        {namedInPrompt(m_state.name), listed(engaged, kAllNames), label(*m_state.drive),
         label(*m_state.driven), asText(m_drive), brake, held});
    m_build.question.elements = {m_coupling.id, m_coupling.links.front()};
    m_build.field("torque on link " + held + " in N m", FieldKind::number);
    m_build.titled(translated("torque on link %1 in N m", {held}));
    m_build.inUnit("N m");
    m_build.field(toTranslate("turns the housing"), FieldKind::choice, {m_with, m_against});
    m_build.question.rule =
        translated("Brake %1 holds link %2 with %3 N m; the housing has the opposite, %4 N m.",
                   {m_coupling.id.text(), held, inWords(m_torque), inWords(-m_torque)});
  }

  void addTorques() {
    const std::vector<ElementId> elements{m_coupling.id};
    const Rational drive = m_drive;
    const Rational load = m_brake.state.driven * m_drive;
    m_build.wrongField("reaction-for-action", 0, {(-m_torque).toString()},
                       translated("This is what the housing feels: on link %1 the brake acts with %2 N m.",
                                  {held(), inWords(m_torque)}),
                       elements);
    if (m_brake.isAlone) {
      for (const Rational& size : {drive - load, load - drive})
        m_build.wrongField(
            "torques-without-signs", 0, {size.toString()},
            translated("A sign is lost: %1 N m of the drive, %2 N m that hold the load and the "
                       "torque of the brake add up to 0.",
                       {inWords(m_drive), inWords(load)}),
            elements);
      m_build.wrongField(
          "ratio-upside-down", 0, {(drive / m_brake.state.ratio - drive).toString()},
          translated("You use the ratio upside down: with the ratio %1 the load is held by %2 N m.",
                     {inWords(m_brake.state.ratio), inWords(load)}),
          elements);
    }
    m_build.wrongField("load-for-brake", 0, {load.toString(), (-load).toString()},
                       translated("This is the torque at the load on link %1: the brake has to keep the "
                                  "balance of drive and load.",
                                  {label(*m_state.driven)}),
                       elements);
    m_build.wrongField("drive-for-brake", 0, {drive.toString(), (-drive).toString()},
                       translated("This is the torque of the drive: the brake does not carry it as it is."),
                       elements);
  }

  void addSenses() {
    m_build.wrongField(
        "same-sense-on-both", 1, {senseOf(m_torque)},
        translated("Link %1 and the housing are turned in opposite senses by the brake: link %1 "
                   "has %2 N m, the housing %3 N m.",
                   {held(), inWords(m_torque), inWords(-m_torque)}),
        {m_coupling.id});
  }

  const ExerciseSource& m_source;
  HoldingBrake m_brake;
  int m_drive;
  const ShiftState& m_state;
  const ShiftElement& m_coupling;
  Rational m_torque;
  std::string m_with = translated(kWith);
  std::string m_against = translated(kAgainst);
  QuestionBuilder m_build{ExerciseKind::brakeReaction, 4};
};

}  // namespace

bool hasBrakeReaction(const ExerciseSource& source) {
  return !holdingBrakes(source).empty();
}

namespace {

Question brakeReactionQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  HoldingBrake brake = random.oneOf(holdingBrakes(source));
  const int drive = random.between(kLeastTorque, kMaxTorque);
  return ReactionQuestion(source, std::move(brake), drive).make();
}

Lack withoutReactions(const ExerciseSource& source) {
  if (const Lack reason = withoutStates(source)) return reason;
  return hasBrakeReaction(source) ? Lack()
                                  : translated("no brake that carries a torque about the drive's axis");
}

}  // namespace

ExerciseEntry brakeReactionEntry() {
  return {.kind = ExerciseKind::brakeReaction,
          .name = "brake-reaction",
          .title = toTranslate("Reaction of a brake, sense"),
          .hint = toTranslate(
              "The torques of drive, load and brake on the train add up to zero, and a brake passes no "
              "power. What acts on a link acts on the other part in the opposite sense."),
          .view = LessonView::schematic,
          .lack = withoutReactions,
          .make = brakeReactionQuestion};
}

}  // namespace geargraph
