#include "ui/mainwindow/edit_preview.h"

#include <QCoreApplication>
#include <QMenu>
#include <memory>
#include <utility>

#include "core/machine/bodies/derived_geometry.h"
#include "ui/canvas/menu_preview.h"
#include "ui/models/term_tips.h"
#include "ui/workbench/workbench.h"

namespace geargraph::inline mainwindow {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("mainwindow", text);
}

/// No document's revision is as high: what keeps answers by revision does not take one for the other. The
/// document's own is asked for between two menus, so that numbers may begin anew with each.
constexpr quint64 kPreviews = quint64{1} << 63;

}  // namespace

void showPreviews(QMenu& menu, Workbench& workbench, std::function<void(const QString&)> tell) {
  MenuPreview& preview = MenuPreview::of(menu);
  QObject::connect(
      &preview, &MenuPreview::wanted, &menu,
      [&workbench, tell, number = kPreviews](const Edit& edit) mutable {
        const Expected<PlacedMechanism> tried = edit.reduce(workbench.document().placed());
        if (!tried) {
          workbench.request();
          return tell(shownText(tried.error().front().message));
        }
        workbench.analysis().request({std::make_shared<const DerivedGeometry>(*tried), ++number});
        tell(tr("Preview: %1. Click to keep it; leave it, or Esc, to go back").arg(edit.text));
      });
  QObject::connect(&preview, &MenuPreview::ended, &menu, [&workbench, tell = std::move(tell)] {
    workbench.request();
    tell({});
  });
}

}  // namespace geargraph::inline mainwindow
