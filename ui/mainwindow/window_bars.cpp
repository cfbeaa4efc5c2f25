// The tool bar: tools, history, the motion, and the search field at its right end.

#include <QMenuBar>
#include <QToolButton>
#include <cmath>

#include "ui/canvas/digraph_view.h"
#include "ui/canvas/drawing_view.h"
#include "ui/help/search_field.h"
#include "ui/mainwindow/fitting_tool_bar.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/play_controls.h"
#include "ui/mainwindow/status_line.h"
#include "ui/mainwindow/window_help.h"
#include "ui/view3d/view3d.h"

namespace geargraph {
namespace {

constexpr double kFaster = 1.4142135623730951;  // two steps double the speed

void multiplySpeed(Playback& playback, double factor) {
  const double speed = playback.speed() * factor;
  const double most = PlayControls::kFastest;
  if (std::abs(speed) <= most * 1.01 && std::abs(speed) >= 0.99 / most) playback.setSpeed(speed);
}

}  // namespace

void MainWindow::makeToolBar() {
  auto* bar = new FittingToolBar(tr("Tools"), this);
  addToolBar(bar);
  bar->setObjectName(QStringLiteral("toolBar"));
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->setIconSize({16, 16});
  QAction* const note = m_actions->tool[static_cast<std::size_t>(ToolKind::note)];
  QAction* const measure = m_actions->tool[static_cast<std::size_t>(ToolKind::measure)];
  for (QAction* tool : m_actions->tools->actions()) {
    const bool isNamed =
        tool != note && tool != measure && tool->data().toInt() != static_cast<int>(ToolKind::pan);
    if (isNamed) bar->addNamed(tool);
  }
  bar->addNamed((*m_actions)[CommandId::insertSet]);
  // Without their words the bar holds the longer ones of other languages on a small screen.
  bar->addActions({note, measure});
  bar->addSeparator();
  bar->addActions({(*m_actions)[CommandId::undo], (*m_actions)[CommandId::redo]});
  for (QAction* action : {note, measure, (*m_actions)[CommandId::undo], (*m_actions)[CommandId::redo]}) {
    qobject_cast<QToolButton*>(bar->widgetForAction(action))->setToolButtonStyle(Qt::ToolButtonIconOnly);
  }
  for (auto* button : bar->findChildren<QToolButton*>()) button->setFocusPolicy(Qt::TabFocus);
  bar->addSeparator();
  // One transport in the window: below the 3D picture, and here while that is not in sight.
  m_transport = bar->addWidget(new PlayControls(&view3d().playback(), bar));
  view3d().installEventFilter(this);
  auto* gap = new QWidget(bar);
  gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(gap);
  m_search = new SearchField(m_document, m_selection, menuBar(), bar);
  bar->addWidget(m_search);
  connect(m_search, &SearchField::elementChosen, this, &MainWindow::showElement);
  connect(m_search, &SearchField::elementsChosen, this, [this](const std::vector<ElementId>& elements) {
    m_selection->select({elements.begin(), elements.end()});
    drawing().setFocus();
  });
  connect(m_search, &SearchField::editChosen, m_document, &Document::apply);
  connect(m_search, &SearchField::rejected, m_status, &StatusLine::showRejection);
  connect(m_search, &SearchField::pageChosen, m_help, &WindowHelp::showPage);
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  const bool isShown = event->type() == QEvent::Show;
  if (m_transport != nullptr && watched == &view3d() && (isShown || event->type() == QEvent::Hide))
    m_transport->setVisible(!isShown);
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::wireMotion() {
  const WindowActions& a = *m_actions;
  Playback& playback = view3d().playback();
  connect(a[CommandId::play], &QAction::triggered, &playback, &Playback::toggle);
  connect(a[CommandId::toStart], &QAction::triggered, &playback, [&playback] { playback.setTime(0); });
  connect(a[CommandId::faster], &QAction::triggered, &playback,
          [&playback] { multiplySpeed(playback, kFaster); });
  connect(a[CommandId::slower], &QAction::triggered, &playback,
          [&playback] { multiplySpeed(playback, 1 / kFaster); });
  connect(a[CommandId::normalSpeed], &QAction::triggered, &playback, [&playback] { playback.setSpeed(1); });
  connect(a[CommandId::backwards], &QAction::triggered, &playback,
          [&playback] { playback.setSpeed(-playback.speed()); });
  connect(&playback, &Playback::playingChanged, this, [&a](bool playing) {
    a[CommandId::play]->setText(playing ? tr("&Pause\tSpace") : tr("&Play\tSpace"));
  });
  connect(&playback, &Playback::speedChanged, this,
          [&a](double speed) { a[CommandId::backwards]->setChecked(speed < 0); });
}

/// Selects an element and brings it into sight.
void MainWindow::showElement(const ElementId& element) {
  if (element.kind == ElementKind::note) showDrawing(digraph().objectName());
  m_selection->select({element});
  const QRect box = drawing().boxOf(element);
  if (!box.isNull()) drawing().ensureVisible(drawing().mapToScene(box).boundingRect());
}

}  // namespace geargraph
