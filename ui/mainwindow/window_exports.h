#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/foundations/files/csv.h"
#include "core/mechanism/graph/integer_matrix.h"
#include "core/presentation/sheet_files/sheet_files.h"
#include "core/teaching/derivation/quantity_table.h"

class QPrinter;
class QWidget;

namespace geargraph::inline canvas {
class DrawingView;
}  // namespace geargraph::inline canvas
namespace geargraph::inline pages {
struct ReportLists;
}  // namespace geargraph::inline pages
namespace geargraph::inline printing {
class PrintedPages;
using PrintedPagesPtr = std::shared_ptr<const PrintedPages>;
}  // namespace geargraph::inline printing
namespace geargraph::inline ui_schematic {
class SchematicView;
}  // namespace geargraph::inline ui_schematic
namespace geargraph::inline view3d {
class MotionPanel;
class View3D;
}  // namespace geargraph::inline view3d
namespace geargraph::inline workbench {
class Workbench;
}  // namespace geargraph::inline workbench

namespace geargraph::inline mainwindow {

struct PictureWish;
class ExportJobs;
class PictureClipboard;
class WindowFiles;

/// What a window writes besides its document: matrices and tables as CSV, drawings, 3D pictures and
/// animations, the derivation, traced paths and speeds. A file is written whole or not at all; refused() and
/// noted() tell.
class WindowExports : public QObject {
  Q_OBJECT

 public:
  /// They are exported as they are shown.
  struct Views {
    std::vector<DrawingView*> drawings;
    SchematicView* schematic = nullptr;
    View3D* view3d = nullptr;
    MotionPanel* motion = nullptr;
  };

  /// `window`: the parent of its dialogs, and of this.
  WindowExports(Workbench& workbench, const WindowFiles& files, Views views, ExportJobs* jobs,
                PictureClipboard* clipboard, QWidget* window);

  /// A matrix with its labels as CSV; written() follows, and a large one can be stopped. Cost: O(rows ·
  /// columns).
  void exportCsv(const IntegerMatrixPtr& matrix, const QString& path, const CsvOptions& options = {});
  void exportCsv(const QuantityTablePtr& table, const QString& path, const CsvOptions& options = {});
  /// A picture of a view; written() follows, at once for a drawing, later for the 3D view.
  void exportPicture(const PictureWish& wish, const QString& path);
  /// A view as a picture on the clipboard, by the name of its drawing, or "3d": soon after, and with the
  /// document where it is a drawing.
  void copyPicture(const QString& view);
  /// The derivation in the form that the path's suffix names (html, pdf, tex, md); written() follows.
  void exportDerivation(const QString& path);
  /// The mechanism as one page for any browser, or as a package for learning platforms (zip); written()
  /// follows.
  void exportHandout(const QString& path);
  /// The same with the questions of a plan, with feedback. Without kinds: one of every kind that the document
  /// gives.
  void exportHandoutAsking(const QString& path, const SheetPlan& plan);
  /// Sheets, solutions and files for answers, into a new folder; written() follows.
  void exportSheets(const QString& folder, const SheetWish& wish);
  /// Prints pages on a thread.
  void print(const PrintedPagesPtr& pages, const std::shared_ptr<QPrinter>& printer);
  /// The newest path that the 3D view has traced, as CSV. @pre there is one
  bool saveTrace(const QString& path);
  /// What the plots show, as CSV: points and angles in one file each, "speeds.csv" and "speeds-2.csv".
  bool saveSpeeds(const QString& path);

  // The same with a dialog for the path, and for matrices one for the options of CSV.
  void chooseAndExport(const IntegerMatrixPtr& matrix);
  void chooseAndExportQuantity(const QuantityTablePtr& table);
  /// A table that is CSV already; `name`: proposed for its file.
  void chooseAndExportTable(const QString& name, const QString& csv);
  void chooseAndExportPicture(const PictureWish& wish);
  void chooseAndExportDerivation();
  void chooseAndExportHandout();
  void chooseAndExportHandoutAsking(const geargraph::SheetPlan& plan);
  void chooseAndExportSheets(const geargraph::SheetWish& wish);
  void chooseAndSaveTrace();
  void chooseAndSaveSpeeds();

  /// What keeps the document from being derived, as a sentence; empty for nothing.
  [[nodiscard]] QString whyNoDerivation() const;

 signals:
  void refused(const QString& why);
  void noted(const QString& note);
  /// A table, a picture or a derivation.
  void written(const QString& path);

 private:
  void chooseCsv(const QString& name, const std::function<void(const QString&, const CsvOptions&)>& write);
  void exportView3D(const PictureWish& wish, const QString& path);
  void copyView3D();
  [[nodiscard]] std::optional<ReportLists> shownLists();
  [[nodiscard]] QString handoutPath(const QStringList& forms, QString& chosen) const;
  [[nodiscard]] static SheetPlan everyKind();
  void writeHandout(const QString& path, const std::optional<SheetPlan>& plan);
  void writePicture(const Expected<std::string>& bytes, const QString& path);
  void onWritten(const QString& path);

  Workbench& m_workbench;
  const WindowFiles& m_files;
  Views m_views;
  ExportJobs* m_jobs;
  PictureClipboard* m_clipboard;
  QWidget* m_window;
};

}  // namespace geargraph::inline mainwindow
