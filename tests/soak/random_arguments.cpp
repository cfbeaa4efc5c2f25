#include "tests/soak/random_edits.h"

namespace geargraph::soak {

int RandomArguments::below(int limit) {
  return static_cast<int>(m_random() % static_cast<std::uint64_t>(limit));
}

/// The id of an element of a list, now and then one that no element has.
template <class Element>
auto RandomArguments::idIn(const std::vector<Element>& list) {
  using IdType = decltype(list.front().id);
  if (list.empty() || oneIn(60)) return IdType("missing");
  return list[static_cast<std::size_t>(below(static_cast<int>(list.size())))].id;
}

LinkId RandomArguments::link() {
  return idIn(m_mechanism.links);
}

AxisId RandomArguments::axis() {
  return idIn(m_mechanism.axes);
}

JointId RandomArguments::joint() {
  return idIn(m_mechanism.turningJoints);
}

MeshId RandomArguments::mesh() {
  return idIn(m_mechanism.gearMeshes);
}

ShiftElementId RandomArguments::coupling() {
  return idIn(m_mechanism.couplings);
}

int RandomArguments::state() {
  return below(static_cast<int>(m_mechanism.states.size()));
}

ElementId RandomArguments::element() {
  switch (below(8)) {
    case 0:
      return axis();
    case 1:
    case 2:
      return joint();
    case 3:
    case 4:
      return mesh();
    case 5:
      return coupling();
    case 6:
      if (!m_mechanism.wheels.empty()) return idIn(m_mechanism.wheels);
      return link();
    default:
      return link();
  }
}

std::vector<ElementId> RandomArguments::elements(int most) {
  std::vector<ElementId> chosen(static_cast<std::size_t>(1 + below(most)));
  for (ElementId& each : chosen) each = element();
  return chosen;
}

int RandomArguments::teeth() {
  switch (below(24)) {
    case 0:
      return kMinTeeth;
    case 1:
      return kMaxTeeth;
    case 2:
      return below(2) == 0 ? 0 : kMaxTeeth + 1;
    default:
      return 12 + below(60);
  }
}

Number RandomArguments::number() {
  static constexpr std::array<const char*, 9> kWritten = {
      "0.10", "1e-3", "-2.50", "12345678901234567890/98765432109876543211", "1e12", "0", "-0", "3.0", "7e-9"};
  switch (below(6)) {
    case 0:
      return Number::fromText(kWritten[static_cast<std::size_t>(below(kWritten.size()))]).value_or(Number(1));
    case 1:
      return Number(Rational(below(400) - 200, 1 + below(30)));
    case 2:
      return Number::fromDouble((below(2'000'000) - 1'000'000) / 4096.0);
    default:
      return Number(below(400) - 200);
  }
}

NumberTriple RandomArguments::triple() {
  return {number(), number(), number()};
}

CanvasPoint RandomArguments::place() {
  return {below(180'000) / 100.0 - 900, below(120'000) / 100.0 - 600};
}

std::string RandomArguments::text() {
  switch (below(12)) {
    case 0:
      return {};
    case 1:
      return "\"quoted\" \\ / \b\f\n\r\t and " + std::string(1, '\x01');
    case 2:
      return "Планетарная передача 行星齿轮 \U0001F600";
    case 3:
      return std::string(static_cast<std::size_t>(1 + below(4000)), 'a');
    default:
      return "name " + std::to_string(below(1000));
  }
}

std::string RandomArguments::id() {
  return oneIn(40) ? std::string() : "id" + std::to_string(below(60));
}

}  // namespace geargraph::soak
