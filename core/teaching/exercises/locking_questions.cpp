// Does a train lock itself when it is driven backwards?

#include <array>
#include <charconv>

#include "core/teaching/exercises/exercise_statics.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_makers.h"

namespace geargraph::inline exercises {
namespace {

constexpr const char* kLocks = "locks itself";
constexpr const char* kTurns = "turns";

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
    m_build.question.prompt =
        prompt() + " Of the power that it takes, seen from its carrier, each mesh passes the part $" +
        asTex(m_mesh) + "$; nothing else loses power. Now " + m_driven + " drives backwards and " + m_drive +
        " takes the power. Does the train turn, or does it lock itself? With which efficiency does it pass "
        "the power (0 where it locks itself)? A fraction or a decimal of three digits will do.";
    for (const int mesh : m_passed.passing) m_build.question.elements.push_back(m_source.meshId(mesh));
    m_build.question.rule = m_passed.backward ? turningRule() : lockingRule();
    m_build.field("driven backwards it", FieldKind::choice, {kTurns, kLocks});
    m_build.field("efficiency backwards", FieldKind::number);
    m_build.accept({m_passed.backward ? kTurns : kLocks, backward().toString()});
    m_passed.backward ? addTurning() : addLocking();
    return std::move(m_build.question);
  }

 private:
  [[nodiscard]] Rational backward() const { return m_passed.backward.value_or(Rational(0)); }

  std::string prompt() {
    if (m_train.state < 0) {
      m_drive = "joint $" + m_source.edgeLabel(m_train.drive) + "$";
      m_driven = "joint $" + m_source.edgeLabel(m_train.driven) + "$";
      std::vector<std::string> held;
      for (const int input : m_source.inputs())
        if (input != m_train.drive) held.push_back("$" + m_source.edgeLabel(input) + "$");
      const std::string inputs = held.empty()
                                     ? ""
                                     : ", with " + std::string(held.size() == 1 ? "joint " : "joints ") +
                                           listed(held, kAllNames) + " held";
      return "A motor in " + m_drive + " drives a load at " + m_driven + inputs + ".";
    }
    m_drive = "link $" + m_source.linkLabel(m_train.drive) + "$";
    m_driven = "link $" + m_source.linkLabel(m_train.driven) + "$";
    const ShiftState& state = m_source.mechanism().states[static_cast<std::size_t>(m_train.state)];
    std::vector<std::string> engaged;
    for (const CouplingId& coupling : state.engaged) engaged.push_back(namedInPrompt(coupling.text()));
    return "In state \u201c" + namedInPrompt(state.name) + "\u201d, with " + listed(engaged, kAllNames) +
           " engaged, " + m_drive + " drives a load on " + m_driven + ".";
  }

  /// "2 W for each watt that is fed, seen from their carriers"
  [[nodiscard]] std::string latentPower() const {
    return std::string(m_passed.passing.size() == 1 ? "the mesh passes " : "the meshes pass ") +
           asDecimal(m_passed.latent) + " W for each watt that is fed, seen from " +
           (m_passed.passing.size() == 1 ? "its carrier" : "their carriers");
  }

  [[nodiscard]] std::string turningRule() const {
    std::vector<std::string> drivers;
    for (const int mesh : m_passed.passing) {
      const auto driver = m_passed.drivers[static_cast<std::size_t>(mesh)].driver;
      const int edge = m_source.graph().t() + mesh;
      const bool isTail = driver == MeshLoss::Driver::tail;
      if (driver == MeshLoss::Driver::none) continue;
      const int gear = isTail ? m_source.graph().edge(edge).tail : m_source.graph().edge(edge).head;
      drivers.push_back("gear " + m_source.linkLabel(gear) + " drives in mesh " + m_source.meshLabel(mesh));
    }
    return "Driven backwards, " + listed(drivers, kAllNames) + ": of each watt that is fed " +
           asDecimal(backward()) + " W arrive, so that the train turns.";
  }

  [[nodiscard]] std::string lockingRule() const {
    return "Without losses " + latentPower() + ", and each loses " + inWords(Rational(1) - m_mesh) +
           " of what it takes: with these losses no load, however large, turns the drive: the "
           "train locks itself.";
  }

  void addTurning() {
    const std::string right = " of the power arrives when it is driven backwards.";
    addEfficiencies(" Backwards it passes " + asDecimal(backward()) + ".");
    m_build.wrongField(
        "efficiency-upside-down", 1, {backward().inverse().toString()},
        "Your efficiency is upside down: it is the power taken over the power fed, less than 1.");
    m_build.wrongField("lock-claimed", 0, {kLocks},
                       "It does not lock itself: the losses are less than the power fed, and " +
                           asDecimal(backward()) + right);
  }

  void addLocking() {
    addEfficiencies(" Backwards it locks itself.");
    m_build.wrongField("lock-overlooked", 0, {kTurns},
                       "It locks itself: " + latentPower() +
                           ", and with these losses no load, however large, turns the drive.");
    m_build.wrongIf("locked-with-power", {{Test::values, {0}, {{kLocks}}}, {Test::differs, {1}, {{"0"}}}},
                    "It locks itself, right; but then no power passes: the efficiency is 0.", {}, {1});
  }

  /// Efficiencies that answer another question; `instead` says what the right one is.
  void addEfficiencies(const std::string& instead) {
    Rational fixed = 1;
    for (std::size_t i = 0; i < m_passed.passing.size(); ++i) fixed *= m_mesh;
    m_build.wrong(
        "forward-for-backward", {kTurns, m_passed.forward->toString()},
        "This is the efficiency with the motor driving: backwards the other gears drive." + instead);
    m_build.wrong("losses-ignored", {kTurns, "1"}, "You leave out the losses of the meshes." + instead);
    m_build.wrong("fixed-axis-losses", {kTurns, fixed.toString()},
                  "You multiply the efficiencies of the meshes as in a train of fixed axes: seen from its "
                  "carrier a mesh passes another power." +
                      instead);
  }

  const ExerciseSource& m_source;
  const DrivenTrain& m_train;
  TrainEfficiency m_passed;
  Rational m_mesh;
  std::string m_drive, m_driven;
  QuestionBuilder m_build{ExerciseKind::selfLocking, 5};
};

}  // namespace

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

}  // namespace geargraph::inline exercises
