#include "ui/mainwindow/file_texts.h"

#include <QCoreApplication>

#include "ui/models/term_tips.h"

namespace geargraph {

QString documentFilter() {
  return QCoreApplication::translate("MainWindow", "GearGraph documents (*.geargraph);;All files (*)");
}

QString readableFilter() {
  return QCoreApplication::translate("MainWindow",
                                     "Documents and tables (*.geargraph *.csv *.tsv);;"
                                     "GearGraph documents (*.geargraph);;"
                                     "Tables of documents (*.csv *.tsv);;All files (*)");
}

QString textOf(const Difference& difference) {
  return shownText(differenceText(difference));
}

Edit takingOver(const QString& text, const MechanismPtr& mechanism) {
  return {text, [mechanism](const Mechanism&) -> Expected<Mechanism> { return *mechanism; }, 0};
}

}  // namespace geargraph
