#include "ui/workbench/views.h"

#include <QWidget>
#include <algorithm>

#include "ui/workbench/workbench.h"

namespace geargraph {

Views::Views(Workbench& workbench, QObject* parent) : QObject(parent), m_workbench(workbench) {}

Document* Views::document() const {
  return &m_workbench.document();
}

Selection* Views::selection() const {
  return &m_workbench.selection();
}

ResultsView& Views::make(const ViewEntry& entry, QWidget* parent) {
  GEARGRAPH_REQUIRE(std::none_of(m_made.begin(), m_made.end(),
                                 [&](const Made& each) { return each.entry.id == entry.id; }));
  ResultsView* const view = entry.make(*this, parent);
  if (entry.minimumSize.isValid()) view->widget().setMinimumSize(entry.minimumSize);
  m_made.push_back({entry, view});
  return *view;
}

ResultsView& Views::byId(const QString& id) const {
  const auto found =
      std::find_if(m_made.begin(), m_made.end(), [&](const Made& each) { return each.entry.id == id; });
  GEARGRAPH_REQUIRE(found != m_made.end());
  return *found->view;
}

void Views::setMechanism(const MechanismPtr& mechanism) {
  for (const Made& each : m_made) each.view->setMechanism(mechanism);
}

void Views::setSnapshot(const SnapshotPtr& snapshot) {
  for (const Made& each : m_made) each.view->setSnapshot(snapshot);
}

void Views::setAnswersOpen(bool isOpen) {
  for (const Made& each : m_made) each.view->setAnswersOpen(isOpen);
}

bool Views::isSettled() const {
  return std::all_of(m_made.begin(), m_made.end(), [](const Made& each) { return each.view->isSettled(); });
}

}  // namespace geargraph

#include "moc_views.cpp"
