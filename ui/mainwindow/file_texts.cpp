#include "ui/mainwindow/file_texts.h"

#include "ui/mainwindow/main_window.h"
#include "ui/models/term_tips.h"

namespace geargraph::inline mainwindow {

QString documentFilter() {
  return MainWindow::tr("GearGraph documents (*.geargraph);;All files (*)");
}

QString textOf(const Difference& difference) {
  return shownText(differenceText(difference));
}

Edit takingOver(const QString& text, const MechanismPtr& mechanism) {
  return {text, [mechanism](const Mechanism&) -> Expected<Mechanism> { return *mechanism; }, 0};
}

}  // namespace geargraph::inline mainwindow
