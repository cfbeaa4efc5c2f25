// File > Export picture: drawings as SVG, PDF or PNG; the 3D view as PNG, as an animation, or as solids.

#include <QFileDialog>
#include <QFileInfo>

#include "core/presentation/mechanism_scene/scene_picture.h"
#include "core/presentation/meshfile/mesh_writer.h"
#include "ui/canvas/drawing_view.h"
#include "ui/canvas/schematic_view.h"
#include "ui/mainwindow/export_jobs.h"
#include "ui/mainwindow/picture_clipboard.h"
#include "ui/mainwindow/picture_dialog.h"
#include "ui/mainwindow/window_exports.h"
#include "ui/mainwindow/window_files.h"
#include "ui/view3d/overlay.h"
#include "ui/view3d/overlay_layer.h"
#include "ui/view3d/view3d.h"
#include "ui/workbench/workbench.h"

namespace geargraph {
namespace {

/// The view's picture or animation, with its labels, as a job for another thread.
ExportJobs::Job renderingJob(const SceneRendering& rendering, const ViewOptions& options,
                             const QString& forcesCaption, const PaintOver& over, bool dark, SolidForm form,
                             const QString& path) {
  const auto run = [=](const ExportJobs::Progress& progress, const std::stop_token& stop) {
    RenderingRun how;
    how.progress = progress;
    how.stop = stop;
    const auto overlay = std::make_shared<PictureOverlay>(options, dark);
    const QString caption = options.marks.forces ? forcesCaption : QString();
    how.finish = [overlay, caption, over, dark](Image& image, ScenePainter& painter) {
      const VisibilityBuffer seen = painter.seenForLabels();
      const ShownForces forces{
          painter.seen().view().forces, painter.seen().forceArrows(), {}, caption, static_cast<bool>(over)};
      overlay->paint(image, painter.labelGround(seen), forces);
      paintLayer(image, painter.labelGround(seen), painter.seen().view(), over, dark, forces);
    };
    const std::filesystem::path file = QFile::encodeName(path).toStdString();
    const auto failure = form == SolidForm::pictures ? writePictures(rendering, file, how)
                                                     : geargraph::writePicture(rendering, file, how);
    return failure ? QString::fromStdString(failure->message) : QString();
  };
  return {path, rendering.animation.has_value(), run};
}

ExportJobs::Job drawingJob(const std::function<DisplayList()>& draw, const DrawingPicture& how,
                           const QString& path) {
  const auto run = [=](const ExportJobs::Progress&, const std::stop_token& stop) {
    const DisplayList list = draw();
    if (stop.stop_requested()) return WindowExports::tr("The export was stopped.");
    const Expected<std::string> bytes = pictureOf(list, how);
    return bytes ? writingError(path, *bytes) : QString::fromStdString(bytes.error().front().message);
  };
  return {path, false, run};
}

ExportJobs::Job solidsJob(const MechanismScenePtr& stage, const SceneView& view, const QString& path) {
  const auto run = [=](const ExportJobs::Progress&, const std::stop_token& stop) {
    MeshWriteOptions how;
    how.stop = stop;
    const auto failure =
        writeMesh(sceneOf(*stage, view, stop), MeshFormat::glb, QFile::encodeName(path).toStdString(), how);
    return failure ? QString::fromStdString(failure->message) : QString();
  };
  return {path, false, run};
}

/// What lies over the view; empty: nothing.
PaintOver paintingOver(const View3D& view) {
  const auto* layer = view.findChild<const OverlayLayer*>();
  return layer != nullptr ? layer->painting() : PaintOver();
}

QString suffixOf(const PictureOptions& options) {
  if (options.view == QLatin1String("3d") && options.solid == SolidForm::glb) return QStringLiteral("glb");
  if (options.view == QLatin1String("3d") && options.solid == SolidForm::pictures) return {};
  const std::string_view form = pictureFormName(options.picture.form);
  return QString::fromLatin1(form.data(), static_cast<qsizetype>(form.size()));
}

}  // namespace

void WindowExports::chooseAndExportPicture(const PictureOptions& options) {
  const QString suffix = suffixOf(options);
  const QString name = QFileInfo(m_files.title()).completeBaseName();
  const QString proposed = QStringLiteral("%1-%2").arg(name, options.view);
  if (suffix.isEmpty()) {
    const QString folder = QFileDialog::getSaveFileName(m_window, tr("Export pictures into the new folder"),
                                                        proposed, tr("Folders (*)"));
    if (!folder.isEmpty()) exportPicture(options, folder);
    return;
  }
  QString path = QFileDialog::getSaveFileName(
      m_window, tr("Export picture"), proposed + QLatin1Char('.') + suffix,
      QStringLiteral("%1 (*.%2);;%3 (*)").arg(suffix.toUpper(), suffix, tr("All files")));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + suffix;
  exportPicture(options, path);
}

void WindowExports::exportPicture(const PictureOptions& options, const QString& path) {
  if (options.view == QLatin1String("3d")) return exportView3D(options, path);
  for (DrawingView* each : m_views.drawings) {
    if (each->objectName() != options.view) continue;
    DrawingPicture picture = options.picture;
    picture.title = m_workbench.document().mechanism()->name;
    const std::function<DisplayList()> draw = each->pictureMaker();
    const QString why = each->whyNoPicture();
    if (!why.isEmpty()) return emit rejected(why);
    m_jobs->add(drawingJob(draw, picture, path));
  }
}

// What the view shows at this moment, whatever happens to it while the pictures are painted.
void WindowExports::exportView3D(const PictureOptions& options, const QString& path) {
  const MechanismScenePtr stage = m_views.view3d->stage();
  if (!stage || stage->scene.instances.empty()) {
    emit rejected(tr("The 3D view is empty: there is nothing to export."));
    return;
  }
  if (options.solid == SolidForm::glb) return m_jobs->add(solidsJob(stage, m_views.view3d->view(), path));
  const SheetStyle& style = options.picture.style;
  SceneRendering rendering;
  rendering.stage = stage;
  rendering.view = m_views.view3d->view();
  rendering.view.style = pictureStyle(style.theme, style.transparent);
  rendering.view.style.faces = m_views.view3d->options().faces;
  if (style.size) rendering.size = {style.size->width, style.size->height};
  rendering.fits = options.isFitted;
  rendering.animation = options.animation;
  m_jobs->add(renderingJob(rendering, m_views.view3d->options(), m_views.view3d->forcesCaption(),
                           paintingOver(*m_views.view3d), style.theme == Theme::dark, options.solid, path));
}

void WindowExports::copyPicture(const QString& view) {
  if (view == QLatin1String("3d")) return copyView3D();
  for (DrawingView* each : m_views.drawings) {
    if (each->objectName() != view) continue;
    CopiedContent content;
    content.drawing = each->pictureMaker();
    const QString why = each->whyNoPicture();
    if (!why.isEmpty()) return emit rejected(why);
    content.document = m_workbench.document().mechanism();
    m_clipboard->copy(std::move(content));
    emit noted(tr("Copied the drawing as a picture"));
  }
}

/// As the view shows it, at the size of a page.
void WindowExports::copyView3D() {
  const MechanismScenePtr stage = m_views.view3d->stage();
  if (!stage || stage->scene.instances.empty())
    return emit rejected(tr("The 3D view is empty: there is nothing to copy."));
  const ViewOptions options = m_views.view3d->options();
  CopiedContent::Seen seen{{},
                           options,
                           options.marks.forces ? m_views.view3d->forcesCaption() : QString(),
                           paintingOver(*m_views.view3d)};
  seen.rendering.stage = stage;
  seen.rendering.view = m_views.view3d->view();
  seen.rendering.view.style = pictureStyle(Theme::light, true);
  seen.rendering.view.style.faces = seen.options.faces;
  seen.rendering.fits = false;
  CopiedContent content;
  content.seen = std::move(seen);
  m_clipboard->copy(std::move(content));
  emit noted(tr("Copied the 3D view as a picture"));
}

void WindowExports::onWritten(const QString& path) {
  if (path.isEmpty()) return emit noted(tr("Sent to the printer"));
  emit noted(tr("Exported %1").arg(QFileInfo(path).fileName()));
  emit written(path);
}

}  // namespace geargraph
