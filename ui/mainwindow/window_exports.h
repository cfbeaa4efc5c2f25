#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/foundations/files/csv.h"
#include "core/mechanism/graph/integer_matrix.h"
#include "core/presentation/exercise_sheets/sheet_files.h"
#include "core/presentation/report/report.h"
#include "core/teaching/derivation/result_table.h"

class QPrinter;
class QWidget;

namespace geargraph {
class DrawingView;
}  // namespace geargraph
namespace geargraph {
struct Exporter;
struct OptionValues;
}  // namespace geargraph
namespace geargraph {
class PrintedPages;
using PrintedPagesPtr = std::shared_ptr<const PrintedPages>;
}  // namespace geargraph
namespace geargraph {
class SchematicView;
}  // namespace geargraph
namespace geargraph {
class MotionPanel;
class View3D;
}  // namespace geargraph
namespace geargraph {
class Workbench;
}  // namespace geargraph

namespace geargraph {

struct ExportedDocument;
struct PictureOptions;
struct RecentExport;
class ExportJobs;
class PictureClipboard;
class WindowFiles;

/// The exports of a window: every format of core's allExporters(), and what is shown: matrices and tables as
/// CSV, drawings, 3D pictures and animations, the derivation, traced paths and speeds. Files are written
/// atomically; rejected() and noted() report.
class WindowExports : public QObject {
  Q_OBJECT

 public:
  /// The views that are exported, as they are shown.
  struct Sources {
    std::vector<DrawingView*> drawings;
    SchematicView* schematic = nullptr;
    View3D* view3d = nullptr;
    MotionPanel* motion = nullptr;
  };

  /// `window`: parent of the dialogs, and of this object.
  WindowExports(Workbench& workbench, const WindowFiles& files, Sources views, ExportJobs* jobs,
                PictureClipboard* clipboard, QWidget* window);

  /// Exports a result with its labels as CSV, in the form that it is shown in; written() follows; a large one
  /// can be stopped. Cost: O(rows · columns).
  void exportCsv(const ResultTablePtr& table, const QString& path, const CsvOptions& options = {});
  /// Exports a picture of a view; written() follows, immediately for a drawing, later for the 3D view.
  void exportPicture(const PictureOptions& options, const QString& path);
  /// Copies a view as a picture to the clipboard, by the name of its drawing, or "3d": asynchronously, and
  /// for a drawing together with the document.
  void copyPicture(const QString& view);
  /// Exports the derivation in the form of the path's suffix (html, pdf, tex, md); written() follows.
  void exportDerivation(const QString& path);
  /// Exports the mechanism as one HTML page, or as a package for learning platforms (zip); written() follows.
  void exportHandout(const QString& path);
  /// The same without asking anything: beside the document, or among the user's documents where it has no
  /// file. A handout that was written so before is replaced, another file is not.
  void exportHandoutNow();
  /// The same with the questions of a plan, with feedback. Without kinds: one question of every available
  /// kind.
  void exportHandoutAsking(const QString& path, const SheetPlan& plan);
  /// Exports sheets, solutions and files for answers into a new folder; written() follows.
  void exportSheets(const QString& folder, const SheetRequest& request);
  /// Exports all lessons as pages and as packages, with a page that lists them, into a new folder; written()
  /// follows.
  void exportLessons(const QString& folder);
  /// Exports the document by an exporter of core with its options; written() follows, and what it has to say
  /// is noted. @pre the options hold those that choose the exporter
  /// @param mayOverwrite files that are in the folder already are written anew
  void exportAs(const Exporter& exporter, const OptionValues& options, const QString& path,
                bool mayOverwrite = false);
  /// Writes what was exported before once more, of the document as it is now.
  void exportAgain(const geargraph::RecentExport& again);
  /// Prints pages on a background thread.
  void print(const PrintedPagesPtr& pages, const std::shared_ptr<QPrinter>& printer);
  /// Saves the newest traced path of the 3D view as CSV. @pre there is one
  bool saveTrace(const QString& path);
  /// Saves the plots as CSV: points and angles in one file each, "speeds.csv" and "speeds-2.csv".
  bool saveSpeeds(const QString& path);

  // The same with a dialog for the path, and for matrices one for the options of CSV.
  /// With a dialog for the format and its options before it.
  void chooseAndExport();
  void chooseAndExportResult(const geargraph::ResultTablePtr& table);
  /// A table that is CSV already; `name`: default file name.
  void chooseAndExportTable(const QString& name, const QString& csv);
  void chooseAndExportPicture(const PictureOptions& options);
  void chooseAndExportDerivation();
  void chooseAndExportHandout();
  void chooseAndExportHandoutAsking(const geargraph::SheetPlan& plan);
  void chooseAndExportLessons();
  void chooseAndExportSheets(const geargraph::SheetRequest& request);
  void chooseAndSaveTrace();
  void chooseAndSaveSpeeds();

  /// Why the document has no derivation, as a sentence; empty if it has one.
  [[nodiscard]] QString whyNoDerivation() const;

 signals:
  void rejected(const QString& why);
  void noted(const QString& note);
  /// A table, a picture or a derivation.
  void written(const QString& path);

 private:
  void exportView3D(const PictureOptions& options, const QString& path);
  void copyView3D();
  [[nodiscard]] std::optional<ReportLists> shownLists();
  [[nodiscard]] QString handoutPath(const QStringList& forms, QString& chosen) const;
  [[nodiscard]] static SheetPlan everyKind();
  void writeHandout(const QString& path, const std::optional<SheetPlan>& plan);
  [[nodiscard]] ExportedDocument exported() const;
  [[nodiscard]] QString exportFolder() const;
  [[nodiscard]] QString exportPath(const Exporter& exporter) const;
  void onWritten(const QString& path);

  Workbench& m_workbench;
  const WindowFiles& m_files;
  Sources m_views;
  ExportJobs* m_jobs;
  PictureClipboard* m_clipboard;
  QWidget* m_window;
};

}  // namespace geargraph
