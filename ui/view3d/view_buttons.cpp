#include "ui/view3d/view_buttons.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

namespace geargraph {

ViewButtons::ViewButtons(QWidget* parent) : QWidget(parent) {
  setObjectName("view3dButtons");
  setAttribute(Qt::WA_StyledBackground);  // so that the style draws the veil
  setProperty("look", "veil");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  add("view3dFit", tr("Fit"), tr("All of the train in the view (F)"), [this] { emit fitWanted(); });
  const auto addView = [this](const char* name, const QString& text, const QString& tip, StandardView view) {
    add(name, text, tip, [this, view] { emit viewWanted(view); });
  };
  addView("view3dIso", tr("Iso"), tr("Isometric (0)"), StandardView::isometric);
  addView("view3dFront", tr("Front"), tr("From the front: x to the right, z up (1)"), StandardView::front);
  addView("view3dRight", tr("Right"), tr("From the right: y to the right, z up (2)"), StandardView::right);
  addView("view3dTop", tr("Top"), tr("From above: x to the right, y up (3)"), StandardView::top);
  m_section =
      add("view3dSection", tr("Section"), tr("Cut the train open (S)"), [this] { emit sectionToggled(); });
  m_section->setCheckable(true);
  addMore();
}

void ViewButtons::setSection(bool isCut) {
  m_section->setChecked(isCut);
}

void ViewButtons::toggleSection() {
  m_section->click();
}

QToolButton* ViewButtons::add(const char* name, const QString& text, const QString& tip,
                              const std::function<void()>& act) {
  auto* button = new QToolButton(this);
  button->setObjectName(QLatin1String(name));
  button->setText(text);
  button->setToolTip(tip);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  layout()->addWidget(button);
  connect(button, &QToolButton::clicked, this, act);
  return button;
}

// The menu is filled when it opens: it shows what holds then.
void ViewButtons::addMore() {
  QToolButton* more = add("view3dMore", QStringLiteral("⋯"), tr("What is shown, and how"), [] {});
  auto* menu = new QMenu(more);
  menu->setToolTipsVisible(true);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    emit menuOpening(*menu);
  });
  more->setProperty("look", "flat");  // its text is sign enough of a menu
  more->setMenu(menu);
  more->setPopupMode(QToolButton::InstantPopup);
}

}  // namespace geargraph

#include "moc_view_buttons.cpp"
