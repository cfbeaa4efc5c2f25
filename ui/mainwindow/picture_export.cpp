// File > Export picture: drawings as SVG, PDF or PNG, the 3D view as PNG.

#include <QFileDialog>
#include <QFileInfo>

#include "core/io/file.h"
#include "core/scene/stage_picture.h"
#include "ui/canvas/drawing_view.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/picture_dialog.h"
#include "ui/mainwindow/status_line.h"
#include "ui/view3d/view3d.h"

namespace geargraph {
namespace {

/// The 3D view's picture as the bytes of a PNG.
Expected<std::string> stagePng(const Stage& stage, const PictureOptions& options) {
  const Expected<Image> image = stagePicture(stage, options);
  if (!image) return image.error();
  const std::vector<std::uint8_t> png = pngBytes(*image);
  return std::string(png.begin(), png.end());
}

}  // namespace

void MainWindow::askForPicture() {
  std::vector<std::pair<QString, QString>> views;
  for (int i = 0; i < m_drawings->count(); ++i) {
    views.emplace_back(m_drawings->widget(i)->objectName(), m_drawings->tabText(i));
  }
  views.emplace_back(QStringLiteral("3d"), tr("3D"));
  auto* dialog = new PictureDialog(views, drawing().objectName(), drawing().theme() == Theme::dark, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PictureDialog::wanted, this, [this](const PictureWish& wish) {
    const std::string_view form = pictureFormName(wish.picture.form);
    const QString suffix = QString::fromLatin1(form.data(), static_cast<qsizetype>(form.size()));
    QString name = QFileInfo(m_document->filePath()).completeBaseName();
    if (name.isEmpty())
      name = QFileInfo(windowTitle().section(QLatin1String("[*]"), 0, 0)).completeBaseName();
    const QString proposed = QStringLiteral("%1-%2.%3").arg(name, wish.view, suffix);
    QString path = QFileDialog::getSaveFileName(
        this, tr("Export picture"), proposed,
        QStringLiteral("%1 (*.%2);;%3 (*)").arg(suffix.toUpper(), suffix, tr("All files")));
    if (path.isEmpty()) return;
    if (QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + suffix;
    exportPicture(wish, path);
  });
  dialog->show();
}

void MainWindow::exportPicture(const PictureWish& wish, const QString& path) {
  if (wish.view == QLatin1String("3d")) {
    // Painting it may take a second where there is no graphics card.
    const SheetLook& look = wish.picture.look;
    PictureOptions options;
    if (look.size) options.size = {look.size->width, look.size->height};
    options.theme = look.theme;
    options.transparent = look.transparent;
    options.time = m_view3d->playback().time();
    const StagePtr stage = m_view3d->stage();
    if (!stage || stage->scene.instances.empty()) {
      m_status->showRefusal(tr("The 3D view is empty: there is nothing to export."));
      return;
    }
    m_pictureThread = std::jthread([this, stage, options, path] {
      const auto bytes = std::make_shared<const Expected<std::string>>(stagePng(*stage, options));
      QMetaObject::invokeMethod(
          this, [this, bytes, path] { writePicture(*bytes, path); }, Qt::QueuedConnection);
    });
    return;
  }
  for (DrawingView* each : m_allDrawings) {
    if (each->objectName() != wish.view) continue;
    DrawingPicture picture = wish.picture;
    picture.title = m_document->mechanism()->name;
    writePicture(pictureOf(each->picture(), picture), path);
  }
}

void MainWindow::writePicture(const Expected<std::string>& bytes, const QString& path) {
  const QString name = QFileInfo(path).fileName();
  if (!bytes) {
    m_status->showRefusal(QString::fromStdString(bytes.error().front().message));
  } else if (const auto error = writeFile(QFile::encodeName(path).toStdString(), *bytes)) {
    m_status->showRefusal(QString::fromStdString(error->message));
  } else {
    m_status->showNote(tr("Exported %1").arg(name));
    emit pictureExported(path);
  }
}

}  // namespace geargraph
