#pragma once

#include <QTextBrowser>
#include <vector>

#include "ui/help/help_pictures.h"
#include "ui/reading/formula_painter.h"

namespace geargraph {
struct ManualPage;
}  // namespace geargraph

namespace geargraph {

/// Shows a page of the manual with its formulas and pictures, in the colours and fonts of the window. Clicks
/// on commands, pages and lessons are emitted as signals, which the window handles.
class HelpBrowser : public QTextBrowser {
  Q_OBJECT

 public:
  explicit HelpBrowser(QWidget* parent = nullptr);

  /// @pre the page is one of manualPages()
  void showPage(const ManualPage* page, const QString& anchor);
  [[nodiscard]] const ManualPage* page() const { return m_page; }
  /// Are all requested pictures available?
  [[nodiscard]] bool isSettled() const { return m_pictures.isSettled(); }

 signals:
  void pageWanted(const QString& pageAndAnchor);
  void commandWanted(const QString& menuPath);
  void lessonWanted(const QString& id);

 protected:
  QVariant loadResource(int type, const QUrl& name) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void setPage();
  void follow(const QUrl& link);
  [[nodiscard]] QString html();
  [[nodiscard]] QString sheet() const;
  [[nodiscard]] QImage formula(int position);
  [[nodiscard]] int roomForPictures() const;

  const ManualPage* m_page = nullptr;
  HelpPictures m_pictures;
  FormulaPainter m_painter;
  std::vector<std::string> m_formulas;  ///< of the page, in TeX
  int m_laidOutFor = 0;                 ///< width for pictures in the present layout
};

}  // namespace geargraph
