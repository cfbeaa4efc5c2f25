#pragma once

#include <QDialog>
#include <QPrinter>
#include <memory>
#include <vector>

#include "core/theory/analysis/analysis.h"
#include "ui/reading/printed_pages.h"
#include "ui/service/service.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace geargraph {

class PagePreview;

/// The printable parts of a document, as of the opening of the dialog.
struct PrintSource {
  QString title;
  std::vector<PrintedDrawing> drawings;
  std::size_t inFront = 0;  ///< index of the drawing chosen initially
  SnapshotPtr snapshot;     ///< complete; null: no derivation
  QString whyNoDerivation = {};
};

/// Lets the user choose what to print and shows the pages. Not modal.
class PrintDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit PrintDialog(PrintSource source, QWidget* parent = nullptr);

  [[nodiscard]] PagePreview& preview() { return *m_preview; }
  [[nodiscard]] const PrintedPagesPtr& pages() const { return m_pages->answer(); }
  /// Are pages() those of the current choice?
  [[nodiscard]] bool isUpToDate() const { return m_pages->isUpToDate(); }
  [[nodiscard]] const std::shared_ptr<QPrinter>& printer() const { return m_printer; }

  /// Paints all pages on a printer. Returns why it failed, as a sentence; empty on success. May be called
  /// from any thread while no other one uses the printer.
  [[nodiscard]] static QString print(const PrintedPages& pages, QPrinter& printer,
                                     const std::stop_token& stop = {});

 signals:
  /// The user has chosen a printer: print(pages, printer) is to be called on a background thread.
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
  void choosePaper();
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

}  // namespace geargraph
