// Does a train lock itself when it is driven backwards?

#include <array>
#include <charconv>

#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/exercise_statics.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

constexpr const char* kLocks = toTranslate("locks itself");
constexpr const char* kTurns = toTranslate("turns");

/// Four digits: "0.9412".
std::string asDecimal(const Rational& value) {
  std::array<char, 32> digits{};
  constexpr int kDigits = 4;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value.toDouble(),
                                 std::chars_format::general, kDigits);
  return {digits.data(), end.ptr};
}

/// The efficiencies of a mesh that are tried, in this order.
std::vector<Rational> meshEfficiencies(ExerciseRandom& random) {
  std::vector<Rational> efficiencies{Rational(49, 50), Rational(24, 25), Rational(19, 20), Rational(9, 10),
                                     Rational(4, 5)};
  for (std::size_t i = efficiencies.size(); i > 1; --i)
    std::swap(efficiencies[i - 1], efficiencies[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  efficiencies.emplace_back(99, 100);  // with this one every train of drivenTrains() turns forward
  return efficiencies;
}

struct LossyTrain {
  Rational meshEfficiency;
  TrainEfficiency passed;
};

/// With an efficiency of a mesh with which the train turns forward and, if it can be, does backwards what is
/// wanted.
LossyTrain chosenLosses(const ExerciseSource& source, const DrivenTrain& train, bool wantsLocked,
                        ExerciseRandom& random) {
  std::optional<LossyTrain> other;
  for (const Rational& each : meshEfficiencies(random)) {
    auto passed = efficiencyOf(source, train, each);
    if (!passed || !passed->forward) continue;
    const bool isLocked = !passed->backward;
    if (isLocked == wantsLocked) return {each, std::move(*passed)};
    if (!other) other = LossyTrain{each, std::move(*passed)};
  }
  return std::move(*other);
}

class LockingQuestion {
 public:
  LockingQuestion(const ExerciseSource& source, const DrivenTrain& train, LossyTrain losses)
      : m_source(source),
        m_train(train),
        m_passed(std::move(losses.passed)),
        m_mesh(std::move(losses.meshEfficiency)) {}

  Question make() {
    m_build.question.prompt = prompt() + ' ';
    m_build.question.prompt += translated(
        "Of the power that it takes, seen from its carrier, each mesh passes the part $%1$; nothing else "
        "loses power. Now %2 drives backwards and %3 takes the power. Does the train turn, or does it lock "
        "itself? With which efficiency does it pass the power (0 where it locks itself)? A fraction or a "
        "decimal of three digits will do.",
        {asTex(m_mesh), m_driven, m_drive});
    for (const MeshOrdinal mesh : m_passed.passing)
      m_build.question.elements.push_back(m_source.meshId(mesh));
    m_build.question.rule = m_passed.backward ? turningRule() : lockingRule();
    m_build.field(toTranslate("driven backwards it"), FieldKind::choice, {m_turns, m_locks});
    m_build.field(toTranslate("efficiency backwards"), FieldKind::number);
    m_build.accept({m_passed.backward ? m_turns : m_locks, backward().toString()});
    m_passed.backward ? addTurning() : addLocking();
    return std::move(m_build.question);
  }

 private:
  [[nodiscard]] Rational backward() const { return m_passed.backward.value_or(Rational(0)); }

  std::string prompt() {
    if (m_train.state < 0) {
      m_drive = translated("joint $%1$", {m_source.edgeLabel(m_train.drive)});
      m_driven = translated("joint $%1$", {m_source.edgeLabel(m_train.driven)});
      std::vector<std::string> held;
      for (const int input : m_source.inputs())
        if (input != m_train.drive) held.push_back("$" + m_source.edgeLabel(input) + "$");
      const std::string inputs = listed(held, kAllNames);
      return held.empty()       ? translated("A motor in %1 drives a load at %2.", {m_drive, m_driven})
             : held.size() == 1 ? translated("A motor in %1 drives a load at %2, with joint %3 held.",
                                             {m_drive, m_driven, inputs})
                                : translated("A motor in %1 drives a load at %2, with joints %3 held.",
                                             {m_drive, m_driven, inputs});
    }
    m_drive = translated("link $%1$", {m_source.linkLabel(m_train.drive)});
    m_driven = translated("link $%1$", {m_source.linkLabel(m_train.driven)});
    const ShiftState& state = m_source.mechanism().states[static_cast<std::size_t>(m_train.state)];
    std::vector<std::string> engaged;
    for (const ShiftElementId& coupling : state.engaged) engaged.push_back(namedInPrompt(coupling.text()));
    return translated("In state “%1”, with %2 engaged, %3 drives a load on %4.",
                      {namedInPrompt(state.name), listed(engaged, kAllNames), m_drive, m_driven});
  }

  /// "2 W for each watt that is fed, seen from their carriers"
  [[nodiscard]] std::string latentPower() const {
    return m_passed.passing.size() == 1
               ? translated("the mesh passes %1 W for each watt that is fed, seen from its carrier",
                            {asDecimal(m_passed.latent)})
               : translated("the meshes pass %1 W for each watt that is fed, seen from their carriers",
                            {asDecimal(m_passed.latent)});
  }

  [[nodiscard]] std::string turningRule() const {
    std::vector<std::string> drivers;
    for (const MeshOrdinal mesh : m_passed.passing) {
      const auto driver = m_passed.drivers[mesh].driver;
      const int edge = m_source.graph().t() + mesh;
      const bool isTail = driver == MeshLoss::Driver::tail;
      if (driver == MeshLoss::Driver::none) continue;
      const int gear = isTail ? m_source.graph().edge(edge).tail : m_source.graph().edge(edge).head;
      drivers.push_back(
          translated("gear %1 drives in mesh %2", {m_source.linkLabel(gear), m_source.meshLabel(mesh)}));
    }
    return translated("Driven backwards, %1: of each watt that is fed %2 W arrive, so that the train turns.",
                      {listed(drivers, kAllNames), asDecimal(backward())});
  }

  [[nodiscard]] std::string lockingRule() const {
    return translated(
        "Without losses %1, and each loses %2 of what it takes: with these losses no load, however large, "
        "turns the drive: the train locks itself.",
        {latentPower(), inWords(Rational(1) - m_mesh)});
  }

  void addTurning() {
    addEfficiencies(translated("Backwards it passes %1.", {asDecimal(backward())}));
    m_build.wrongField(
        "efficiency-upside-down", 1, {backward().inverse().toString()},
        translated("Your efficiency is upside down: it is the power taken over the power fed, less than 1."));
    m_build.wrongField("lock-claimed", 0, {m_locks},
                       translated("It does not lock itself: the losses are less than the power fed, and %1 "
                                  "of the power arrives when it is driven backwards.",
                                  {asDecimal(backward())}));
  }

  void addLocking() {
    addEfficiencies(translated("Backwards it locks itself."));
    m_build.wrongField(
        "lock-overlooked", 0, {m_turns},
        translated("It locks itself: %1, and with these losses no load, however large, turns the drive.",
                   {latentPower()}));
    m_build.wrongIf("locked-with-power", {{Test::values, {0}, {{m_locks}}}, {Test::differs, {1}, {{"0"}}}},
                    translated("It locks itself, right; but then no power passes: the efficiency is 0."), {},
                    {1});
  }

  /// Efficiencies that answer another question; `instead` says what the right one is.
  void addEfficiencies(const std::string& instead) {
    Rational fixed = 1;
    for (std::size_t i = 0; i < m_passed.passing.size(); ++i) fixed *= m_mesh;
    m_build.wrong(
        "forward-for-backward", {m_turns, m_passed.forward->toString()},
        translated("This is the efficiency with the motor driving: backwards the other gears drive.") + ' ' +
            instead);
    m_build.wrong("losses-ignored", {m_turns, "1"},
                  translated("You leave out the losses of the meshes.") + ' ' + instead);
    m_build.wrong(
        "fixed-axis-losses", {m_turns, fixed.toString()},
        translated("You multiply the efficiencies of the meshes as in a train of fixed axes: seen from its "
                   "carrier a mesh passes another power.") +
            ' ' + instead);
  }

  const ExerciseSource& m_source;
  const DrivenTrain& m_train;
  TrainEfficiency m_passed;
  Rational m_mesh;
  std::string m_drive, m_driven;
  std::string m_turns = translated(kTurns);
  std::string m_locks = translated(kLocks);
  QuestionBuilder m_build{ExerciseKind::selfLocking, 5};
};

Question selfLockingQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const std::vector<DrivenTrain> trains = drivenTrains(source);
  const bool wantsLocked = random.below(2) == 0;
  // Few trains can lock themselves: look for one of them first where one is wanted.
  std::vector<int> order = random.someOf(firstNumbers(static_cast<int>(trains.size())), 3);
  std::optional<LossyTrain> losses;
  int chosen = order.front();
  for (const int train : order) {
    chosen = train;
    losses = chosenLosses(source, trains[static_cast<std::size_t>(train)], wantsLocked, random);
    if (!losses->passed.backward.has_value() == wantsLocked) break;
  }
  return LockingQuestion(source, trains[static_cast<std::size_t>(chosen)], std::move(*losses)).make();
}

Lack withoutLosses(const ExerciseSource& source) {
  if (const Lack reason = withoutFreedom(source)) return reason;
  return drivenTrains(source).empty() ? Lack(translated("no drive passes power through 1 to 6 meshes"))
                                      : std::nullopt;
}

}  // namespace

ExerciseEntry selfLockingEntry() {
  return {.kind = ExerciseKind::selfLocking,
          .name = "self-locking",
          .title = toTranslate("Self-locking"),
          .hint = toTranslate(
              "Let the load drive: behind each mesh less power arrives, by its efficiency. If none "
              "would be left at the input, or it would have to be driven, the train locks."),
          .view = LessonView::schematic,
          .lack = withoutLosses,
          .make = selfLockingQuestion};
}

}  // namespace geargraph
