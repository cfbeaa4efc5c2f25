#include "ui/mainwindow/renumbering_notice.h"

#include <QStringList>
#include <set>
#include <utility>

#include "core/mechanism/model/renumbering.h"

namespace geargraph {

RenumberingNotice::RenumberingNotice(Document* document, Selection* selection, StatusLine* status,
                                     QObject* parent)
    : QObject(parent),
      m_document(document),
      m_selection(selection),
      m_status(status),
      m_before(document->mechanism()) {
  connect(document, &Document::changed, this, &RenumberingNotice::onChanged);
  connect(document, &Document::replaced, this, [this] {  // another document: no element of it is the same
    if (!std::exchange(m_isShown, false)) return;
    m_status->clearRejection();
    m_selection->unhover();
  });
}

void RenumberingNotice::onChanged() {
  constexpr int kMaxNamed = 4;
  const MechanismPtr before = std::exchange(m_before, m_document->mechanism());
  const std::vector<Renumbered> moved = renumberedByRemoval(*before, *m_before);
  m_isShown = !moved.empty();
  if (!m_isShown) return;
  QStringList names;
  std::set<ElementId> elements;
  for (const Renumbered& each : moved) {
    elements.insert(each.element);
    if (names.size() < kMaxNamed) names << tr("%1 is now %2").arg(each.before).arg(each.after);
  }
  const QString list = names.join(QStringLiteral(", "));
  const auto others = static_cast<int>(moved.size()) - kMaxNamed;
  m_status->showNote(others > 0 ? tr("New numbers: %1, and %2 more").arg(list).arg(others)
                                : tr("New numbers: %1").arg(list));
  m_selection->hover(std::move(elements));
}

}  // namespace geargraph

#include "moc_renumbering_notice.cpp"
