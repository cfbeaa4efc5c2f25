#include "ui/view3d/section_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <cmath>

#include "ui/view3d/viewer.h"

namespace geargraph {
namespace {

constexpr int kSteps = 500;

QToolButton* flatButton(QWidget* parent, const char* name, const QString& text, const QString& tip) {
  auto* button = new QToolButton(parent);
  button->setObjectName(QLatin1String(name));
  button->setText(text);
  button->setToolTip(tip);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

QSlider* slider(QWidget* parent, const char* name, const QString& tip) {
  auto* made = new QSlider(Qt::Horizontal, parent);
  made->setObjectName(QLatin1String(name));
  made->setRange(0, kSteps);
  made->setFocusPolicy(Qt::TabFocus);
  made->setToolTip(tip);
  made->setMinimumWidth(90);
  return made;
}

QHBoxLayout* rowOf(QWidget* widget, const QString& title) {
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  row->addWidget(new QLabel(title, widget));
  return row;
}

}  // namespace

SectionBar::SectionBar(Viewer* viewer, QWidget* parent) : QWidget(parent), m_viewer(viewer) {
  setObjectName(QStringLiteral("view3dStrip"));
  setAttribute(Qt::WA_StyledBackground);  // so that the style draws the veil
  setProperty("look", "veil");
  m_section = makeSectionRow();
  m_exploded = makeExplodedRow();
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(6, 0, 6, 0);
  rows->setSpacing(0);
  rows->addWidget(m_section);
  rows->addWidget(m_exploded);
  connect(viewer, &Viewer::optionsChanged, this, &SectionBar::refresh);
  refresh();
}

QWidget* SectionBar::makeSectionRow() {
  auto* widget = new QWidget(this);
  QHBoxLayout* row = rowOf(widget, tr("Section"));
  const auto change = [this](const auto& changed) {
    ViewOptions options = m_viewer->options();
    if (!options.section) return;
    changed(*options.section);
    m_viewer->setOptions(options);
  };
  const char* names[] = {"view3dCutX", "view3dCutY", "view3dCutZ"};
  const QString letters[] = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  for (std::size_t axis = 0; axis < m_axes.size(); ++axis) {
    m_axes[axis] = flatButton(widget, names[axis], letters[axis], tr("Cut square to %1").arg(letters[axis]));
    m_axes[axis]->setCheckable(true);
    row->addWidget(m_axes[axis]);
    connect(m_axes[axis], &QToolButton::clicked, this, [change, axis] {
      change([axis](SectionChoice& section) { section.axis = static_cast<int>(axis); });
    });
  }
  m_place = slider(widget, "view3dCutPlace", tr("Where the train is cut"));
  row->addWidget(m_place, 1);
  connect(m_place, &QSlider::valueChanged, this, [change](int step) {
    change([step](SectionChoice& section) { section.place = double(step) / kSteps; });
  });
  QToolButton* turn = flatButton(widget, "view3dCutTurn", tr("Turn"), tr("Take away the other half"));
  row->addWidget(turn);
  connect(turn, &QToolButton::clicked, this,
          [change] { change([](SectionChoice& section) { section.isTurned = !section.isTurned; }); });
  return widget;
}

QWidget* SectionBar::makeExplodedRow() {
  auto* widget = new QWidget(this);
  QHBoxLayout* row = rowOf(widget, tr("Exploded view"));
  m_apart = slider(widget, "view3dApart", tr("How far the parts are moved apart along their axes"));
  row->addWidget(m_apart, 1);
  connect(m_apart, &QSlider::valueChanged, this, [this](int step) {
    ViewOptions options = m_viewer->options();
    options.explosion = std::max(1, step) / double(kSteps);  // at 0 the slider would be gone
    m_viewer->setOptions(options);
  });
  return widget;
}

void SectionBar::refresh() {
  const ViewOptions& options = m_viewer->options();
  m_section->setVisible(options.section.has_value());
  m_exploded->setVisible(options.explosion > 0);
  setVisible(options.section || options.explosion > 0);
  const QSignalBlocker quietPlace(m_place), quietApart(m_apart);
  m_apart->setValue(static_cast<int>(std::lround(options.explosion * kSteps)));
  if (!options.section) return;
  m_place->setValue(static_cast<int>(std::lround(options.section->place * kSteps)));
  for (std::size_t axis = 0; axis < m_axes.size(); ++axis) {
    m_axes[axis]->setChecked(options.section->axis == static_cast<int>(axis));
  }
}

}  // namespace geargraph

#include "moc_section_bar.cpp"
