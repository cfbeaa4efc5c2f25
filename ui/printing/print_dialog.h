#pragma once

#include <QDialog>
#include <QPrinter>
#include <memory>
#include <vector>

#include "core/theory/analysis/analysis.h"
#include "ui/printing/printed_pages.h"
#include "ui/service/service.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace geargraph::inline printing {

class PagePreview;

/// What can be printed of a document, as it was when that was asked for.
struct PrintSource {
  QString title;
  std::vector<PrintedDrawing> drawings;
  std::size_t inFront = 0;  ///< the drawing that is chosen at first
  SnapshotPtr snapshot;     ///< complete; null: there is no derivation
  QString whyNoDerivation = {};
};

/// Asks what to print, shows it page by page, and prints it. It does not lock the window.
class PrintDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit PrintDialog(PrintSource source, QWidget* parent = nullptr);

  [[nodiscard]] PagePreview& preview() { return *m_preview; }
  [[nodiscard]] const PrintedPagesPtr& pages() const { return m_pages->answer(); }
  /// Are the pages those of what is chosen?
  [[nodiscard]] bool isUpToDate() const { return m_pages->isUpToDate(); }
  [[nodiscard]] const std::shared_ptr<QPrinter>& printer() const { return m_printer; }

  /// Paints all pages on a printer: why it could not, as a sentence; empty where it has. Any thread may do
  /// it, where no other uses the printer.
  [[nodiscard]] static QString print(const PrintedPages& pages, QPrinter& printer,
                                     const std::stop_token& stop = {});

 signals:
  /// The user has chosen a printer: print(pages, printer) is to be called on a thread.
  void printWanted(const geargraph::PrintedPagesPtr& pages, const std::shared_ptr<QPrinter>& printer);

 private:
  struct Request {
    std::vector<PrintedDrawing> drawings;
    bool withDerivation = false;
    QSizeF paper;
    QFont font;
  };
  using Pages = Service<Request, PrintedPagesPtr>;

  QWidget* makeChoices();
  QWidget* makePageField();
  void request();
  void showPages(const PrintedPagesPtr& pages);
  void setUpPage();
  void choosePrinter();

  PrintSource m_source;
  std::shared_ptr<QPrinter> m_printer;
  Pages* m_pages;
  PagePreview* m_preview;
  std::vector<QCheckBox*> m_drawings;
  QCheckBox* m_derivation = nullptr;
  QSpinBox* m_page = nullptr;
  QPushButton* m_print = nullptr;
};

}  // namespace geargraph::inline printing
