#include "ui/forces/explanation_label.h"

#include <algorithm>

#include "core/teaching/force_tables/cutset_words.h"
#include "ui/models/term_tips.h"

namespace geargraph {
namespace {

/// The position of the one element of a kind that is selected; none where there are more.
template <class Elements>
std::optional<int> onlyOne(const Elements& elements, const std::set<ElementId>& selected) {
  std::optional<int> found;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (!selected.contains(ElementId(elements[i].id))) continue;
    if (found) return std::nullopt;
    found = static_cast<int>(i);
  }
  return found;
}

}  // namespace

ExplanationLabel::ExplanationLabel(Selection* selection, QWidget* parent)
    : QLabel(parent), m_selection(selection) {
  setObjectName(QStringLiteral("forcesExplanation"));
  setWordWrap(true);
  setTextFormat(Qt::PlainText);
  setContentsMargins(12, 0, 12, 4);
  setToolTip(tr(
      "T: torque in a joint; M: torque of a mesh on the part beyond the joint; both about the joint's axis. "
      "What the joint cuts off, and what crosses, is lit in all views."));
  setVisible(false);
  connect(selection, &Selection::selectionChanged, this, &ExplanationLabel::explain);
}

void ExplanationLabel::show(const ForcesPtr& forces) {
  m_forces = forces;
  explain();
}

void ExplanationLabel::setAwake(bool awake) {
  m_isAwake = awake;
  explain();
}

void ExplanationLabel::explain() {
  std::set<ElementId> highlighted;
  const QString text = m_isAwake && m_forces && m_forces->report ? words(highlighted) : QString();
  setText(text);
  setVisible(!text.isEmpty());
  emit filled(!text.isEmpty());
  m_selection->setFallbackHighlight(std::move(highlighted));
}

/// A row of the table selects a joint with its links, and a mesh with its gears.
QString ExplanationLabel::words(std::set<ElementId>& highlighted) const {
  const Mechanism& mechanism = *m_forces->solved->mechanism;
  const auto& kinematics = *m_forces->solved->kinematics;
  const std::set<ElementId>& selected = m_selection->selected();
  const auto joint = onlyOne(mechanism.turningJoints, selected);
  const auto mesh = onlyOne(mechanism.gearMeshes, selected);
  if (joint && !mesh) {
    const auto cutset =
        cutsetWords(mechanism, *kinematics.model, kinematics.placement(), *m_forces->report, *joint);
    if (!cutset) return {};
    const std::vector<ElementId> elements = cutset->elements();
    highlighted = {elements.begin(), elements.end()};
    return shownText(cutset->sentence + "  " + cutset->equation);
  }
  if (!mesh || joint) return {};
  return shownText(
      driverSentence(mechanism, kinematics.placement(), *m_forces->report, *mesh).value_or(std::string()));
}

}  // namespace geargraph

#include "moc_explanation_label.cpp"
