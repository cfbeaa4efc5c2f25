#include "ui/mainwindow/edit_preview.h"

#include <QCoreApplication>
#include <QMenu>
#include <utility>

#include "ui/canvas/menu_preview.h"
#include "ui/models/term_tips.h"
#include "ui/workbench/edit_trial.h"
#include "ui/workbench/workbench.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("mainwindow", text);
}

}  // namespace

void showPreviews(QMenu& menu, Workbench& workbench, std::function<void(const QString&)> tell) {
  MenuPreview& preview = MenuPreview::of(menu);
  QObject::connect(&preview, &MenuPreview::wanted, &menu, [&workbench, tell](const Edit& edit) {
    if (const Diagnostics why = showTrial(workbench, edit); !why.empty())
      return tell(shownText(why.front().message));
    tell(tr("Preview: %1. Click to keep it; leave it, or Esc, to go back").arg(edit.text));
  });
  QObject::connect(&preview, &MenuPreview::ended, &menu, [&workbench, tell = std::move(tell)] {
    workbench.request();
    tell({});
  });
}

}  // namespace geargraph
