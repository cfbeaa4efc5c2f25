// Which brake or clutch carries the largest torque, and in which gear.

#include <algorithm>

#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/exercise_statics.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

constexpr int kLeastTorque = 5;  ///< N m at the drive
constexpr int kMaxTorque = 60;

/// One torque of a comparison: of a coupling in a state.
struct Carried {
  ShiftElementOrdinal coupling = 0;
  const StateTorques* state = nullptr;
  [[nodiscard]] Rational size() const { return state->couplings[coupling]->abs(); }
};

/// The couplings of one state, or one coupling in its states; their torques are not all equal.
struct Comparison {
  bool isOfState = true;
  std::vector<Carried> torques;  ///< at least two
};

std::vector<StateTorques> allTorques(const ExerciseSource& source) {
  std::vector<StateTorques> all;
  for (std::size_t state = 0; state < source.mechanism().states.size(); ++state)
    if (auto torques = stateTorques(source, static_cast<int>(state))) all.push_back(std::move(*torques));
  return all;
}

std::vector<Comparison> comparisonsOf(const ExerciseSource& source, const std::vector<StateTorques>& states) {
  std::vector<Comparison> all;
  const auto add = [&](Comparison comparison) {
    const auto& torques = comparison.torques;
    const bool differ = std::any_of(torques.begin(), torques.end(), [&](const Carried& each) {
      return each.size() != torques.front().size();
    });
    if (differ) all.push_back(std::move(comparison));
  };
  const auto couplings = static_cast<int>(source.mechanism().couplings.size());
  const auto isEngaged = [](const StateTorques& state, ShiftElementOrdinal coupling) {
    return state.couplings[coupling].has_value();
  };
  for (const StateTorques& state : states) {
    Comparison ofState;
    for (ShiftElementOrdinal coupling = 0; coupling < couplings; ++coupling)
      if (isEngaged(state, coupling)) ofState.torques.push_back({coupling, &state});
    add(std::move(ofState));
  }
  for (ShiftElementOrdinal coupling = 0; coupling < couplings; ++coupling) {
    Comparison ofCoupling{false, {}};
    for (const StateTorques& state : states)
      if (isEngaged(state, coupling)) ofCoupling.torques.push_back({coupling, &state});
    add(std::move(ofCoupling));
  }
  return all;
}

class BrakeQuestion {
 public:
  BrakeQuestion(const ExerciseSource& source, Comparison comparison, int drive)
      : m_source(source), m_comparison(std::move(comparison)), m_drive(drive) {
    m_largest = m_comparison.torques.front();
    for (const Carried& each : m_comparison.torques)
      if (each.size() > m_largest.size()) m_largest = each;
  }

  Question make() {
    ask();
    std::vector<std::vector<std::string>> right;
    for (const Carried& each : m_comparison.torques) {
      if (each.size() != m_largest.size()) continue;
      for (const std::string& text : texts(newtonMetres(each))) right.push_back({optionOf(each), text});
    }
    m_build.accept(right.front(), right);
    addChoices();
    addSizes();
    return std::move(m_build.question);
  }

 private:
  [[nodiscard]] const ShiftState& stateOf(const StateTorques& torques) const {
    return m_source.mechanism().states[static_cast<std::size_t>(torques.state)];
  }
  [[nodiscard]] const ShiftElement& couplingOf(ShiftElementOrdinal coupling) const {
    return m_source.mechanism().couplings[coupling];
  }
  [[nodiscard]] std::string nameOf(ShiftElementOrdinal coupling) const {
    const ShiftElement& named = couplingOf(coupling);
    return couplingName(named.kind, named.id.text());
  }
  [[nodiscard]] std::string optionOf(const Carried& each) const {
    return m_comparison.isOfState ? couplingOf(each.coupling).id.text() : stateOf(*each.state).name;
  }
  [[nodiscard]] Rational newtonMetres(const Carried& each) const { return each.size() * m_drive; }
  [[nodiscard]] std::string label(const std::optional<LinkId>& link) const {
    return m_source.linkLabel(m_source.graph().nodeOf(*link));
  }
  /// With either sign: the question asks for a size.
  static std::vector<std::string> texts(const Rational& size) {
    return {size.toString(), (-size).toString()};
  }
  /// The coupling or the state that a torque is compared by.
  [[nodiscard]] std::string whose(const Carried& each) const {
    return m_comparison.isOfState ? nameOf(each.coupling) : translated("state “%1”", {optionOf(each)});
  }

  /// "State “1” engages B2 and C, link 2 drives, link 3 bears the load", which begins a sentence or goes on
  /// with it
  [[nodiscard]] std::string described(const StateTorques& torques, bool isFirst) const {
    const ShiftState& state = stateOf(torques);
    std::vector<std::string> engaged;
    for (std::size_t i = 0; i < torques.couplings.size(); ++i)
      if (torques.couplings[i]) engaged.push_back(namedInPrompt(couplingOf(static_cast<int>(i)).id.text()));
    const std::string name = namedInPrompt(state.name);
    const std::string couplings = listed(engaged, kAllNames);
    const std::string drive = label(state.drive);
    const std::string driven = label(state.driven);
    return isFirst ? translated("State “%1” engages %2, link $%3$ drives and link $%4$ bears the load",
                                {name, couplings, drive, driven})
                   : translated("state “%1” engages %2, link $%3$ drives and link $%4$ bears the load",
                                {name, couplings, drive, driven});
  }

  void ask() {
    const std::string torque =
        translated("The torque of the drive is $%1$ N m, and no power is lost.", {asText(m_drive)});
    std::vector<std::string> options;
    if (m_comparison.isOfState) {
      m_build.question.prompt = described(*m_largest.state, true) + ". " + torque + ' ';
      m_build.question.prompt += translated(
          "Which of the engaged brakes and clutches carries the largest torque, and how large is it in N m, "
          "without a sign? A fraction or a decimal of three digits will do.");
      for (const ShiftElement& coupling : m_source.mechanism().couplings)
        options.push_back(coupling.id.text());
      for (const Carried& each : m_comparison.torques)
        m_build.question.elements.emplace_back(couplingOf(each.coupling).id);
    } else {
      std::string list;
      for (const Carried& each : m_comparison.torques)
        list += (list.empty() ? "" : "; ") + described(*each.state, list.empty());
      m_build.question.prompt = list + ". " + torque + ' ';
      m_build.question.prompt += translated(
          "In which state does %1 carry the largest torque, and how large is it in N m, without a sign? A "
          "fraction or a decimal of three digits will do.",
          {namedInPrompt(nameOf(m_largest.coupling))});
      for (const ShiftState& state : m_source.mechanism().states) options.push_back(state.name);
      m_build.question.elements.emplace_back(couplingOf(m_largest.coupling).id);
    }
    m_build.field(m_comparison.isOfState ? toTranslate("largest torque in") : toTranslate("state"),
                  FieldKind::choice, options);
    m_build.field(toTranslate("torque in N m"), FieldKind::number);
    m_build.inUnit("N m");
    std::vector<std::string> sizes;
    for (const Carried& each : m_comparison.torques)
      sizes.push_back(whose(each) + ' ' + newtonMetres(each).toString() + " N m");
    m_build.question.rule =
        translated("The torques on each link and in each mesh balance: %1.", {listed(sizes, kAllNames)});
  }

  void addChoices() {
    const auto fastest = m_comparison.isOfState ? fastestClutch() : largestRatio();
    for (const Carried& each : m_comparison.torques) {
      if (each.size() == m_largest.size()) continue;
      const std::vector<ElementId> elements{couplingOf(each.coupling).id};
      const std::string less = newtonMetres(each).toString();
      const std::string most = newtonMetres(m_largest).toString();
      if (fastest && fastest->coupling == each.coupling && fastest->state == each.state) {
        m_build.wrongField(
            m_comparison.isOfState ? "fastest-coupling" : "largest-ratio", 0, {optionOf(each)},
            m_comparison.isOfState
                ? translated("You choose the clutch that turns fastest, but the torque does not follow "
                             "the speed: it carries %1 N m, less than the %2 N m of %3.",
                             {less, most, whose(m_largest)})
                : translated("You choose the state of the largest ratio, but the brake's torque does not "
                             "follow the ratio's size: it carries %1 N m, less than the %2 N m of %3.",
                             {less, most, whose(m_largest)}),
            elements);
      } else {
        m_build.wrongField("smaller-torque", 0, {optionOf(each)},
                           m_comparison.isOfState
                               ? translated("The %1 carries %2 N m, less than the %3 N m of %4.",
                                            {nameOf(each.coupling), less, most, whose(m_largest)})
                               : translated("In state “%1” it carries %2 N m, less than the %3 N m of %4.",
                                            {optionOf(each), less, most, whose(m_largest)}),
                           elements);
      }
    }
    addReleased();
  }

  /// What is not engaged carries nothing.
  void addReleased() {
    if (m_comparison.isOfState) {
      for (std::size_t i = 0; i < m_largest.state->couplings.size(); ++i) {
        if (m_largest.state->couplings[i]) continue;
        const ShiftElementOrdinal coupling = static_cast<int>(i);
        m_build.wrongField(
            "released-coupling", 0, {couplingOf(coupling).id.text()},
            translated("The %1 is released in this state: it carries no torque.", {nameOf(coupling)}),
            {couplingOf(coupling).id});
      }
      return;
    }
    const ShiftElementId& id = couplingOf(m_largest.coupling).id;
    for (const ShiftState& state : m_source.mechanism().states) {
      if (std::find(state.engaged.begin(), state.engaged.end(), id) != state.engaged.end()) continue;
      m_build.wrongField("released-coupling", 0, {state.name},
                         translated("State “%1” releases the %2: it carries no torque.",
                                    {state.name, nameOf(m_largest.coupling)}),
                         {id});
    }
  }

  void addSizes() {
    const StateTorques& state = *m_largest.state;
    const Rational drive = m_drive;
    const Rational load = state.driven * m_drive;
    const std::vector<ElementId> elements{couplingOf(m_largest.coupling).id};
    const auto add = [&](const char* name, const Rational& size, const std::string& reason) {
      if (!size.isZero()) m_build.wrongField(name, 1, texts(size.abs()), reason, elements);
    };
    if (holdsTheSum(state)) {
      const Rational sum = drive + load.abs();
      const Rational difference = (drive - load.abs()).abs();
      add("torques-without-signs", newtonMetres(m_largest) == sum ? difference : sum,
          translated("The signs of both torques are lost: the brake holds the sum of %1 N m and %2 N m.",
                     {inWords(m_drive), inWords(load)}));
      add("ratio-upside-down", drive - drive / state.ratio,
          translated(
              "You use the ratio upside down: with the ratio %1 the torque on the driven link is %2 N m.",
              {inWords(state.ratio), inWords(load)}));
    }
    for (const Carried& other : m_comparison.torques) {
      if (other.size() == m_largest.size()) continue;
      add("torque-of-another", newtonMetres(other),
          m_comparison.isOfState
              ? translated("This is the torque of %1, which is not the largest.", {nameOf(other.coupling)})
              : translated("This is the torque in state “%1”, which is not the largest.",
                           {stateOf(*other.state).name}));
    }
    add("load-for-brake", load,
        translated("This is the torque of the load on link %1: %2 has to keep the balance.",
                   {label(stateOf(state).driven), nameOf(m_largest.coupling)}));
    add("drive-for-brake", drive,
        translated("This is the torque of the drive: %1 does not carry it as it is.",
                   {nameOf(m_largest.coupling)}));
  }

  /// Is the largest torque that of the only brake, on the axis of drive and load?
  [[nodiscard]] bool holdsTheSum(const StateTorques& state) const {
    for (std::size_t i = 0; i < state.couplings.size(); ++i) {
      const bool isBrake = couplingOf(static_cast<int>(i)).kind == ShiftElementKind::brake;
      const bool isLargest = static_cast<int>(i) == m_largest.coupling;
      if (state.couplings[i] && isBrake != isLargest) return false;
    }
    return m_largest.size() == (Rational(1) + state.driven).abs();
  }

  /// The clutch of the largest speed among those on links that turn on the ground, where there is one.
  [[nodiscard]] std::optional<Carried> fastestClutch() const {
    const int position = m_largest.state->state;
    const auto& rates = m_source.engagedSets(position)[*m_source.setOfState(position)].solution.rates;
    std::optional<Carried> fastest;
    Rational most = 0;
    for (const Carried& each : m_comparison.torques) {
      const ShiftElement& coupling = couplingOf(each.coupling);
      if (coupling.kind == ShiftElementKind::brake) continue;
      const LinkOrdinal link = m_source.graph().nodeOf(coupling.links.front());
      if (link == 0 || m_source.tree()->parent(link) != 0) continue;
      const Rational speed = rates[m_source.tree()->jointToParent(link)].abs();
      if (speed == most) fastest.reset();
      if (speed <= most) continue;
      most = speed;
      fastest = each;
    }
    return fastest;
  }

  [[nodiscard]] std::optional<Carried> largestRatio() const {
    return *std::max_element(
        m_comparison.torques.begin(), m_comparison.torques.end(),
        [](const Carried& a, const Carried& b) { return a.state->ratio.abs() < b.state->ratio.abs(); });
  }

  const ExerciseSource& m_source;
  Comparison m_comparison;
  int m_drive;
  Carried m_largest;
  QuestionBuilder m_build{ExerciseKind::brakeTorque, 4};
};

}  // namespace

bool hasBrakeComparison(const ExerciseSource& source) {
  return !comparisonsOf(source, allTorques(source)).empty();
}

namespace {

Question brakeTorqueQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const std::vector<StateTorques> states = allTorques(source);
  Comparison comparison = random.oneOf(comparisonsOf(source, states));
  const int drive = random.between(kLeastTorque, kMaxTorque);
  return BrakeQuestion(source, std::move(comparison), drive).make();
}

Lack withoutBrakeTorques(const ExerciseSource& source) {
  if (const Lack reason = withoutStates(source)) return reason;
  return hasBrakeComparison(source) ? Lack() : translated("no two torques of brakes or clutches to compare");
}

}  // namespace

ExerciseEntry brakeTorqueEntry() {
  return {
      .kind = ExerciseKind::brakeTorque,
      .name = "brake-torque",
      .title = toTranslate("Largest torque of a brake"),
      .hint = toTranslate(
          "The torques of all shafts and brakes of the train add up to zero, and so do their powers. Write "
          "both sums for what is engaged, then compare the sizes."),
      .view = LessonView::schematic,
      .lack = withoutBrakeTorques,
      .make = brakeTorqueQuestion};
}

}  // namespace geargraph
