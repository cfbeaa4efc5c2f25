#include "core/design/teeth_search/meant_teeth.h"

#include <algorithm>
#include <cstdlib>

#include "core/foundations/files/json_writer.h"

namespace geargraph {
namespace {

constexpr int kMinMeantTeeth = 4;
constexpr std::size_t kMaxMeantChoices = 1'000;

/// Centre distances that the drawn teeth miss may be missed as far.
void admitDrawnSums(TeethProblem& problem) {
  for (SumCondition& sum : problem.sums) {
    std::int64_t drawn = 0;
    for (const SumCondition::Term& term : sum.terms)
      drawn += std::int64_t{term.factor} * problem.wheels[static_cast<std::size_t>(term.wheel)].drawn;
    sum.low = std::min(sum.low, drawn);
    sum.high = std::max(sum.high, drawn);
  }
}

/// All sets with this number of the wheels that may differ, in order.
class WheelSets {
 public:
  WheelSets(const TeethProblem& problem, int count) : m_chosen(static_cast<std::size_t>(count)) {
    for (std::size_t i = 0; i < problem.wheels.size(); ++i)
      if (!problem.wheels[i].isKept) m_free.push_back(static_cast<int>(i));
    for (std::size_t i = 0; i < m_chosen.size(); ++i) m_chosen[i] = i;
    m_isValid = m_chosen.size() <= m_free.size();
  }

  [[nodiscard]] bool isValid() const { return m_isValid; }
  [[nodiscard]] std::vector<int> wheels() const {
    std::vector<int> wheels;
    for (const std::size_t each : m_chosen) wheels.push_back(m_free[each]);
    return wheels;
  }
  void next() {
    std::size_t at = m_chosen.size();
    while (at > 0 && m_chosen[at - 1] == m_free.size() - m_chosen.size() + at - 1) --at;
    m_isValid = at > 0;
    if (!m_isValid) return;
    ++m_chosen[at - 1];
    for (; at < m_chosen.size(); ++at) m_chosen[at] = m_chosen[at - 1] + 1;
  }

 private:
  std::vector<int> m_free;
  std::vector<std::size_t> m_chosen;
  bool m_isValid = true;
};

int teethChanged(const TeethProblem& problem, const MeantChoice& choice) {
  int sum = 0;
  for (const int each : choice.changed) {
    const auto wheel = static_cast<std::size_t>(each);
    sum += std::abs(choice.found.teeth[wheel] - problem.wheels[wheel].drawn);
  }
  return sum;
}

}  // namespace

Expected<MeantTeeth> meantTeeth(const PlacedMechanism& drawn, const TeethWish& wish,
                                const MeantTeethOptions& options, const std::stop_token& stop) {
  auto made = teethProblemOf(drawn, wish);
  if (!made) return made.error();
  auto problem = std::make_shared<TeethProblem>(std::move(made).value());
  admitDrawnSums(*problem);
  MeantTeeth meant;
  std::vector<int> teeth;
  for (const SearchedWheel& wheel : problem->wheels) teeth.push_back(wheel.drawn);
  for (std::size_t ratio = 0; ratio < problem->ratios.size(); ++ratio) {
    meant.drawn.push_back(solvedRatio(*problem, ratio, teeth));
    meant.fits.push_back(
        meant.drawn.back() && problem->ratios[ratio].bounds.contains(*meant.drawn.back()) ? 1 : 0);
  }
  for (int count = 0; count <= options.wheels && meant.choices.empty(); ++count) {
    for (WheelSets sets(*problem, count); sets.isValid(); sets.next()) {
      if (stop.stop_requested()) break;
      TeethProblem near = *problem;
      for (SearchedWheel& wheel : near.wheels) wheel.counts = {wheel.drawn};
      const std::vector<int> changed = sets.wheels();
      for (const int each : changed) {
        SearchedWheel& wheel = near.wheels[static_cast<std::size_t>(each)];
        wheel.counts.clear();
        for (int number = std::max(kMinMeantTeeth, wheel.drawn - options.by);
             number <= wheel.drawn + options.by; ++number) {
          if (number != wheel.drawn) wheel.counts.push_back(number);
        }
      }
      TeethSearchOptions search;
      search.most = kMaxMeantChoices;
      TeethFound found = searchTeeth(near, search, stop);
      meant.tried += found.counts.tried;
      for (FoundTeeth& each : found.best) meant.choices.push_back({changed, std::move(each)});
    }
    if (!meant.choices.empty()) meant.changed = count;
  }
  std::sort(meant.choices.begin(), meant.choices.end(), [&](const MeantChoice& a, const MeantChoice& b) {
    const int ofA = teethChanged(*problem, a);
    const int ofB = teethChanged(*problem, b);
    if (ofA != ofB) return ofA < ofB;
    return a.found.error != b.found.error ? a.found.error < b.found.error : a.found.teeth < b.found.teeth;
  });
  meant.problem = std::move(problem);
  return meant;
}

TeethAnswer meantAnswer(const MeantTeeth& meant, std::size_t most, const std::stop_token& stop) {
  TeethAnswer answer;
  answer.problem = meant.problem;
  answer.found.counts.tried = meant.tried;
  answer.found.counts.within = answer.found.counts.accepted = static_cast<std::int64_t>(meant.choices.size());
  for (std::size_t i = 0; i < std::min(most, meant.choices.size()) && !stop.stop_requested(); ++i)
    answer.choices.push_back(choiceOf(*meant.problem, meant.choices[i].found, stop));
  answer.found.isComplete = !stop.stop_requested();
  return answer;
}

std::string meantTeethJson(const MeantTeeth& meant, std::size_t limit) {
  using Row = JsonWriter::Layout;
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-meant-teeth");
    json.member("version", 1);
    json.key("drawn");
    json.beginArray(Row::row);
    for (const auto& ratio : meant.drawn) ratio ? json.string(ratio->toString()) : json.null();
    json.endArray();
    json.key("fits");
    json.beginArray(Row::row);
    for (const char each : meant.fits) json.boolean(each != 0);
    json.endArray();
    json.key("changed");
    meant.changed < 0 ? json.null() : json.number(std::int64_t{meant.changed});
    json.key("tried");
    json.number(meant.tried);
    json.member("count", static_cast<std::int64_t>(meant.choices.size()));
    json.key("choices");
    json.beginArray();
    for (std::size_t i = 0; i < std::min(limit, meant.choices.size()); ++i) {
      const MeantChoice& choice = meant.choices[i];
      json.beginObject(Row::row);
      json.key("changes");
      json.beginArray(Row::row);
      for (const int each : choice.changed) {
        const auto wheel = static_cast<std::size_t>(each);
        json.beginObject(Row::row);
        json.member("wheel", meant.problem->wheels[wheel].name);
        json.member("drawn", meant.problem->wheels[wheel].drawn);
        json.member("meant", choice.found.teeth[wheel]);
        json.endObject();
      }
      json.endArray();
      json.key("ratios");
      json.beginArray(Row::row);
      for (const Rational& ratio : choice.found.ratios) json.string(ratio.toString());
      json.endArray();
      json.member("error", choice.found.error.toDouble());
      json.endObject();
    }
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

}  // namespace geargraph
