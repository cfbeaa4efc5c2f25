#include "core/teaching/work_check/vocabulary.h"

#include <algorithm>
#include <charconv>

#include "core/foundations/base/translation.h"
#include "core/mechanism/graph/spanning_tree.h"
#include "core/teaching/exercises/link_gears.h"
#include "core/theory/matroid/symbolic_solution.h"
#include "core/theory/states/relative_speed.h"
#include "core/theory/ttgraph/notation.h"

namespace geargraph {
namespace {

std::optional<int> numberOf(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::string shown(const WrittenName& name) {
  return (name.base == "theta" ? "\u03b8"
          : name.base == "w"   ? "\u03c9"
                               : name.base) +
         name.subscript + std::string(static_cast<std::size_t>(name.primes), '\'');
}

}  // namespace

Vocabulary::Vocabulary(const ExerciseSource& source)
    : m_source(source), m_ring(ratioRingOf(source.mechanism())) {
  const std::vector<RatioNames> names = ratioNames(source.graph());
  for (std::size_t mesh = 0; mesh < names.size(); ++mesh) {
    m_ratios.emplace(names[mesh].matroid, std::pair(static_cast<int>(mesh), false));
    m_ratios.emplace(names[mesh].ttGraph, std::pair(static_cast<int>(mesh), false));
    m_ratios.emplace(names[mesh].inverse, std::pair(static_cast<int>(mesh), true));
  }
}

RationalFunction Vocabulary::constant(const Rational& value) const {
  constexpr std::size_t kDigits = 17;
  const std::string text = value.toString();
  const auto slash = text.find('/');
  const auto whole = [&](std::string digits) {
    const bool isNegative = digits.starts_with('-');
    if (isNegative) digits.erase(0, 1);
    RationalFunction sum = RationalFunction::fromInteger(m_ring, 0);
    for (std::size_t at = 0; at < digits.size(); at += kDigits) {
      const std::string part = digits.substr(at, kDigits);
      std::int64_t scale = 1;
      for (std::size_t i = 0; i < part.size(); ++i) scale *= 10;
      sum *= RationalFunction::fromInteger(m_ring, scale);
      sum += RationalFunction::fromInteger(m_ring, std::stoll(part));
    }
    return isNegative ? -sum : sum;
  };
  if (slash == std::string::npos) return whole(text);
  return whole(text.substr(0, slash)) / whole(text.substr(slash + 1));
}

Rational Vocabulary::atTeeth(const RationalFunction& value) const {
  return value.valueAt(m_ring->values()).value_or(Rational(0));
}

bool Vocabulary::ratiosAreFree() const {
  const MatroidAnalysis* const matroid = m_source.matroid();
  return matroid != nullptr && matroid->rank == m_source.graph().c();
}

std::optional<NamedValue> Vocabulary::value(const WrittenName& name, std::string& fault) const {
  if (name.base == "N" || name.base == "d") return wheel(name, fault);
  const std::string primes(static_cast<std::size_t>(name.primes), '\'');
  std::string links = name.subscript;
  auto found = m_ratios.find(name.base + links + primes);
  if (found == m_ratios.end() && links.size() == 3) {  // "4_1" of one digit each
    std::erase(links, '_');
    found = m_ratios.find(name.base + links + primes);
  }
  if (found == m_ratios.end()) {
    fault = translated("This mechanism has no ratio %1.", {shown(name)});
    return std::nullopt;
  }
  const auto [mesh, isInverse] = found->second;
  return NamedValue{RationalFunction::power(m_ring, 1, mesh, isInverse ? -1 : 1), true};
}

/// The gears of a link, by mesh; primes choose among several.
std::optional<NamedValue> Vocabulary::wheel(const WrittenName& name, std::string& fault) const {
  const auto link = numberOf(name.subscript);
  const std::vector<LinkGear> gears = link ? gearsOfLink(m_source, *link) : std::vector<LinkGear>();
  const bool isTeeth = name.base == "N";
  const auto same = [&](const LinkGear& gear) {
    return isTeeth ? gear.teeth == gears.front().teeth : gear.diameter == gears.front().diameter;
  };
  const bool isOne = !gears.empty() && std::all_of(gears.begin(), gears.end(), same);
  const auto place = static_cast<std::size_t>(std::max(name.primes, 1)) - 1;
  if (place >= gears.size() || (name.primes == 0 && !isOne)) {
    fault = gears.empty()
                ? translated("Link %1 has no gear, so %2 has no value.", {name.subscript, shown(name)})
                : translated("Link %1 has several gears: write %2' or %2'', in the order of its meshes.",
                             {name.subscript, shown(name)});
    return std::nullopt;
  }
  if (isTeeth) return NamedValue{constant(gears[place].teeth), false};
  if (gears[place].diameter) return NamedValue{constant(*gears[place].diameter), false};
  fault = translated("The diameter %1 is no fraction: use numbers of teeth.", {shown(name)});
  return std::nullopt;
}

/// "51" with one digit for each link, "12_3", or one link against the ground.
std::optional<std::pair<int, int>> Vocabulary::linksOf(const std::string& subscript) const {
  const auto mark = subscript.find('_');
  std::optional<int> of;
  std::optional<int> to;
  if (mark != std::string::npos) {
    of = numberOf(subscript.substr(0, mark));
    to = numberOf(subscript.substr(mark + 1));
  } else if (subscript.size() == 2 && m_source.graph().n() < 10) {
    of = subscript[0] - '0';
    to = subscript[1] - '0';
  } else {
    of = numberOf(subscript);
    to = 0;
  }
  const auto isLink = [&](const std::optional<int>& label) {
    return label && *label >= 0 && *label < m_source.graph().nodeCount();
  };
  if (!isLink(of) || !isLink(to)) return std::nullopt;
  return std::pair(*of, *to);
}

std::optional<RateSum> Vocabulary::rate(const WrittenName& name, std::string& fault) const {
  const Digraph& graph = m_source.graph();
  if (name.base == "theta") {
    const auto label = numberOf(name.subscript);
    const JointOrdinal joint = label.value_or(0) - graph.edgeLabel(0);
    if (label && joint >= 0 && joint < graph.t()) return RateSum{{joint, 1}};
    fault = translated("This mechanism has no turning joint %1, so no %2.", {name.subscript, shown(name)});
    return std::nullopt;
  }
  const auto links = linksOf(name.subscript);
  if (!links) {
    fault =
        translated("%1 names no links of this mechanism: write ω with two labels, as ω5_1.", {shown(name)});
    return std::nullopt;
  }
  return between(links->second, links->first, fault);
}

/// The sum of the rates on the way, each +1 where it turns the link on, about the direction of the last one.
std::optional<RateSum> Vocabulary::between(int from, int to, std::string& fault) const {
  const SpanningTree* const tree = m_source.tree();
  if (tree == nullptr || !m_source.snapshot()->kinematics) {
    fault = translated("The turning joints are no spanning tree, so no velocity follows from them.");
    return std::nullopt;
  }
  const Placement& placement = m_source.snapshot()->kinematics->placement();
  const std::vector<PathStep> steps = treePath(*tree, from, to);
  const AxisGroups& classes = *placement.classes;
  const auto classOf = [&](const PathStep& step) { return classes.classOf[step.joint]; };
  const auto orientationSignOf = [&](const PathStep& step) { return classes.orientationSign[step.joint]; };
  RateSum sum;
  for (const PathStep& step : steps) {
    const PathStep& last = steps.back();
    const int sense = directionSign(placement, classOf(step), classOf(last)) * orientationSignOf(step) *
                      orientationSignOf(last);
    if (sense == 0) {
      fault = translated(
          "The velocity of link %1 relative to link %2 has several directions: write one equation for each "
          "level.",
          {std::to_string(to), std::to_string(from)});
      return std::nullopt;
    }
    sum[step.joint] = sense * step.direction;
  }
  return sum;
}

}  // namespace geargraph
