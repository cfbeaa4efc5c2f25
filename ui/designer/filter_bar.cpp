#include "ui/designer/filter_bar.h"

#include <QBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include "ui/designer/hits_model.h"

namespace geargraph {

FilterBar::FilterBar(HitsModel* hits, ShownHits* shown, QWidget* parent)
    : QWidget(parent),
      m_hits(hits),
      m_shown(shown),
      m_chips(new QHBoxLayout),
      m_add(new QToolButton(this)),
      m_menu(new QMenu(this)),
      m_count(new QLabel(this)) {
  setObjectName(QStringLiteral("hitFilters"));
  m_add->setObjectName(QStringLiteral("addFilter"));
  m_add->setText(tr("Filter"));
  m_add->setToolTip(
      tr("Shows only gearboxes with a property (Ctrl+F); H hides a single one, Ctrl+Z brings it back"));
  m_add->setPopupMode(QToolButton::InstantPopup);
  m_add->setMenu(m_menu);
  m_count->setObjectName(QStringLiteral("shownCount"));
  m_count->setProperty("look", "hint");
  m_chips->setSpacing(4);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 2, 12, 4);
  row->addWidget(m_add);
  row->addLayout(m_chips);
  row->addStretch(1);
  row->addWidget(m_count);
  connect(m_menu, &QMenu::aboutToShow, this, &FilterBar::fillMenu);
  connect(m_shown, &ShownHits::choiceChanged, this, &FilterBar::renew);
  connect(m_hits, &QAbstractItemModel::rowsInserted, this, &FilterBar::renew);
  connect(m_hits, &QAbstractItemModel::modelReset, this, &FilterBar::renew);
  renew();
}

void FilterBar::openMenu() {
  m_add->setFocus();
  m_add->showMenu();
}

/// What can be asked for beside the conditions that are there: bounds that tell these gearboxes apart.
void FilterBar::fillMenu() {
  m_menu->clear();
  const auto add = [this](QMenu* menu, HitCondition condition, const Rational& bound) {
    menu->addAction(conditionText(condition, bound), this, [this, condition, bound] {
      HitFilter filter = m_shown->filter();
      filter.set(condition, bound);
      m_shown->setFilter(filter);
    });
  };
  for (const HitCondition condition : kHitConditions) {
    const std::vector<Rational> bounds = boundsOf(condition, m_hits->all());
    if (bounds.empty()) continue;
    if (!m_menu->isEmpty()) m_menu->addSeparator();
    for (const Rational& bound : bounds) add(m_menu, condition, bound);
  }
  if (m_menu->isEmpty())
    m_menu->addAction(tr("There is nothing in which these gearboxes differ."))->setEnabled(false);
}

QToolButton* FilterBar::addChip(const QString& name, const QString& text, int hidden) {
  auto* chip = new QToolButton(this);
  chip->setObjectName(name);
  chip->setProperty("look", "chip");
  chip->setText(text + QStringLiteral("  ✕"));
  chip->setToolTip(tr("Hides %1; a click lets go of it").arg(hidden));
  m_chips->addWidget(chip);
  return chip;
}

void FilterBar::renew() {
  while (const QLayoutItem* item = m_chips->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  const HitFilter& filter = m_shown->filter();
  for (const auto& [condition, bound] : filter.conditions()) {
    const QToolButton* const chip =
        addChip(QStringLiteral("filter.%1").arg(static_cast<int>(condition)), conditionText(condition, bound),
                filter.hiddenBy(condition, m_hits->all()));
    connect(chip, &QToolButton::clicked, this, [this, which = condition] {
      HitFilter less = m_shown->filter();
      less.remove(which);
      m_shown->setFilter(less);
    });
  }
  if (m_shown->hiddenCount() > 0) {
    const QToolButton* const chip =
        addChip(QStringLiteral("filter.hidden"), tr("hidden: %1").arg(m_shown->hiddenCount()),
                m_shown->hiddenCount());
    connect(chip, &QToolButton::clicked, m_shown, &ShownHits::showAllHidden);
  }
  const int all = m_hits->rowCount();
  m_add->setEnabled(all > 1);
  m_count->setText(all == 0 ? QString() : tr("%1 of %2 shown").arg(m_shown->rowCount()).arg(all));
}

}  // namespace geargraph

#include "moc_filter_bar.cpp"
