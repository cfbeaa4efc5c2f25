// The languages of the window: its menu of them, and the window that is built anew in another one.

#include <QActionGroup>
#include <QMenu>

#include "core/teaching/lessons/course.h"
#include "ui/canvas/drawing_view.h"
#include "ui/learning/lesson_panel.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/presentation.h"
#include "ui/mainwindow/start_page.h"
#include "ui/mainwindow/window_files.h"
#include "ui/settings/languages.h"
#include "ui/view3d/view3d.h"

namespace geargraph {

void MainWindow::addLanguages(QMenu& menu) {
  auto* group = new QActionGroup(&menu);
  const auto add = [&](const QString& text, const QString& code) {
    QAction* action = menu.addAction(text, this, [this, code] { emit languageWanted(code); });
    action->setObjectName(QStringLiteral("view.language.") + code);
    action->setCheckable(true);
    action->setChecked(savedLanguage() == code);
    group->addAction(action);
    return action;
  };
  add(tr("As the &system"), {})->setToolTip(tr("The language of the system, where the program speaks it"));
  menu.addSeparator();
  for (const QString& code : languageCodes()) add(nativeName(code), code);
}

std::unique_ptr<MainWindow> MainWindow::inPlaceOf(MainWindow& former) {
  former.m_presentation->setOn(false);
  const QByteArray geometry = former.saveGeometry();
  const QByteArray state = former.m_docks->layout();
  const QPoint place = former.pos();
  const QString drawing = former.m_drawings->currentWidget()->objectName();
  const int tool = former.m_actions->tools->checkedAction()->data().toInt();
  const Playback& motion = former.view3d().playback();
  const double time = motion.time();
  const double speed = motion.speed();
  const bool isPlaying = motion.isPlaying();
  const bool isStarting = former.m_start->isVisible();
  former.hide();
  disconnect(former.m_document, nullptr, &former, nullptr);

  std::unique_ptr<MainWindow> window(new MainWindow(new Workbench(*former.m_workbench, nullptr), nullptr));
  window->m_files->takeOver(*former.m_files);
  window->restoreLayout(geometry, state);
  window->move(place);
  window->m_actions->tool[static_cast<std::size_t>(tool)]->setChecked(true);
  window->showDrawing(drawing);
  if (former.view3d().isCameraChosen()) window->view3d().startAnew(former.view3d().camera());
  Playback& renewed = window->view3d().playback();
  renewed.setSpeed(speed);
  renewed.setTime(time);
  renewed.setPlaying(isPlaying);
  if (isStarting) window->showStartPage();
  if (former.m_lesson != nullptr) window->resumeLesson(former);
  return window;
}

}  // namespace geargraph
