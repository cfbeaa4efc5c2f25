#include "app/cli/serve_edits.h"

#include <algorithm>
#include <array>

#include "app/cli/arguments.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/mechanism/model/validate.h"
#include "core/theory/states/state_edits.h"

namespace geargraph::cli {
namespace {

/// Reads the members of one edit; the first that is missing or wrong stays told.
class Members {
 public:
  explicit Members(const JsonValue& edit) : m_edit(edit) {}

  /// Empty where the member may be left out and is.
  std::string text(std::string_view name, bool isNeeded = true) {
    const auto value = m_edit.member(name);
    if (value && value->is(JsonKind::string)) return value->string();
    if (value && value->is(JsonKind::number)) return std::string(value->slice());
    if (value || isNeeded) wrong(name, "a text");
    return {};
  }
  int whole(std::string_view name) {
    const auto number = numberFrom<int>(text(name));
    if (!number) wrong(name, "a whole number");
    return number.value_or(0);
  }
  std::vector<std::string> texts(std::string_view name) {
    std::vector<std::string> list;
    const auto value = m_edit.member(name);
    if (!value || !value->is(JsonKind::array)) {
      wrong(name, "a list of texts");
      return list;
    }
    value->forEachElement([&](const JsonValue& each, std::size_t /*position*/) {
      each.is(JsonKind::string) ? list.push_back(each.string()) : wrong(name, "a list of texts");
    });
    return list;
  }
  /// None where the member is left out or null.
  std::optional<NumberTriple> triple(std::string_view name) {
    const auto value = m_edit.member(name);
    if (!value || value->is(JsonKind::null)) return std::nullopt;
    NumberTriple triple;
    bool isFine = value->is(JsonKind::array) && value->size() == triple.size();
    for (std::size_t i = 0; isFine && i < triple.size(); ++i) {
      const auto number = numberOf(*value->element(i));
      isFine = number.has_value();
      if (number) triple.at(i) = *number;
    }
    if (!isFine) wrong(name, "a list of three numbers");
    return triple;
  }
  std::vector<Input> inputs(std::string_view name) {
    std::vector<Input> inputs;
    const auto value = m_edit.member(name);
    if (!value || !value->is(JsonKind::array)) {
      wrong(name, "a list of inputs");
      return inputs;
    }
    value->forEachElement([&](const JsonValue& each, std::size_t /*position*/) {
      const auto joint = each.is(JsonKind::object) ? each.member("joint") : std::nullopt;
      const auto speed = each.is(JsonKind::object) ? each.member("speed") : std::nullopt;
      const auto number = speed ? numberOf(*speed) : std::nullopt;
      if (!joint || !joint->is(JsonKind::string) || !number) return wrong(name, "a list of inputs");
      inputs.push_back({JointId(joint->string()), *number, {}});
    });
    return inputs;
  }

  [[nodiscard]] const std::optional<Diagnostic>& problem() const { return m_problem; }

 private:
  static std::optional<Number> numberOf(const JsonValue& value) {
    if (value.is(JsonKind::string)) return Number::fromText(value.string());
    return value.is(JsonKind::number) ? Number::fromText(value.slice()) : std::nullopt;
  }
  void wrong(std::string_view name, std::string_view expected) {
    if (m_problem) return;
    m_problem =
        Diagnostic{Code::schema,
                   "The member \"" + std::string(name) + "\" has to be " + std::string(expected) + ".",
                   {},
                   {}};
  }

  JsonValue m_edit;
  std::optional<Diagnostic> m_problem;
};

/// What is removed, by its lists as in a document: {"links": ["3"], "gearMeshes": ["15"]}.
std::vector<ElementId> elementsOf(Members& members, const JsonValue& edit) {
  constexpr std::array kKinds = {ElementKind::link, ElementKind::turningJoint, ElementKind::gearMesh,
                                 ElementKind::coupling, ElementKind::load};
  std::vector<ElementId> elements;
  for (const ElementKind kind : kKinds) {
    if (!edit.member(listName(kind))) continue;
    for (const std::string& id : members.texts(listName(kind))) elements.emplace_back(kind, Atom(id));
  }
  return elements;
}

using Apply = Expected<Mechanism> (*)(Mechanism, Members&, const JsonValue&);

struct ServedEdit {
  std::string_view name;
  Apply apply;
};

constexpr std::array kEdits = {
    ServedEdit{"addLink",
               [](Mechanism m, Members& of, const JsonValue&) {
                 auto next = withLink(std::move(m), {}, of.text("name", false));
                 if (!next) return next;
                 Mechanism made = std::move(next).value();
                 made.view.nodes.erase(made.links.back().id);  // drawings lay it out
                 return Expected<Mechanism>(std::move(made));
               }},
    ServedEdit{"addTurningJoint",
               [](Mechanism m, Members& of, const JsonValue&) {
                 const LinkId tail(of.text("tail")), head(of.text("head"));
                 return withTurningJoint(std::move(m), tail, head, AxisId(of.text("axis", false)));
               }},
    ServedEdit{"addGearMesh",
               [](Mechanism m, Members& of, const JsonValue&) {
                 const LinkId tail(of.text("tail")), head(of.text("head"));
                 const int tailTeeth = of.whole("tailTeeth"), headTeeth = of.whole("headTeeth");
                 return withGearMesh(std::move(m), tail, head, tailTeeth, headTeeth);
               }},
    ServedEdit{"remove",
               [](Mechanism m, Members& of, const JsonValue& edit) {
                 return withoutElements(std::move(m), elementsOf(of, edit));
               }},
    ServedEdit{"setTeeth",
               [](Mechanism m, Members& of, const JsonValue&) {
                 const MeshId mesh(of.text("mesh"));
                 const int tailTeeth = of.whole("tailTeeth"), headTeeth = of.whole("headTeeth");
                 return withTeeth(std::move(m), mesh, tailTeeth, headTeeth);
               }},
    ServedEdit{"setPitchPoint",
               [](Mechanism m, Members& of, const JsonValue&) {
                 return withPitchPoint(std::move(m), MeshId(of.text("mesh")), of.triple("point"));
               }},
    ServedEdit{"setAxis",
               [](Mechanism m, Members& of, const JsonValue&) {
                 return withAxisPlaced(std::move(m), AxisId(of.text("axis")), of.triple("point"),
                                       of.triple("direction"));
               }},
    ServedEdit{"setInputs", [](Mechanism m, Members& of,
                               const JsonValue&) { return withInputs(std::move(m), of.inputs("inputs")); }},
    ServedEdit{"engage",
               [](Mechanism m, Members& of, const JsonValue&) {
                 const std::vector<std::string> names = of.texts("couplings");
                 return withCouplingsEngaged(std::move(m), {names.begin(), names.end()});
               }},
    ServedEdit{"rename",
               [](Mechanism m, Members& of, const JsonValue&) {
                 const LinkId link(of.text("link"));
                 return withName(std::move(m), link, of.text("name"));
               }},
};

}  // namespace

std::string servedEditNames() {
  std::string names;
  for (const ServedEdit& edit : kEdits) names += (names.empty() ? "" : ", ") + std::string(edit.name);
  return names;
}

Expected<Mechanism> withServedEdits(Mechanism mechanism, const JsonValue& edits) {
  std::optional<Diagnostics> problems;
  edits.forEachElement([&](const JsonValue& edit, std::size_t position) {
    if (problems) return;
    const std::string pointer = "/params/edits/" + std::to_string(position);
    const auto name = edit.is(JsonKind::object) ? edit.member("edit") : std::nullopt;
    const auto found = std::find_if(kEdits.begin(), kEdits.end(), [&](const ServedEdit& served) {
      return name && name->is(JsonKind::string) && name->equals(served.name);
    });
    if (found == kEdits.end()) {
      problems = {{Code::schema, "An edit is one of " + servedEditNames() + ".", {}, pointer}};
      return;
    }
    Members members(edit);
    auto next = found->apply(mechanism, members, edit);
    if (members.problem()) {
      problems = {*members.problem()};
      problems->front().pointer = pointer;
    } else if (!next) {
      problems = next.error();
      problems->front().pointer = pointer;
    } else {
      mechanism = std::move(next).value();
    }
  });
  if (!problems) {
    Diagnostics wrong = wellFormedDiagnostics(mechanism);
    if (wrong.empty()) return mechanism;
    problems = std::move(wrong);
  }
  return *std::move(problems);
}

}  // namespace geargraph::cli
