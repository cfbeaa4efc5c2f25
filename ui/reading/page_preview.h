#pragma once

#include <QWidget>

#include "ui/reading/printed_pages.h"

namespace geargraph {

/// Shows one page as it will be printed, fitted to the widget. Page Up and Down, Home and End turn the pages.
class PagePreview final : public QWidget {
  Q_OBJECT

 public:
  explicit PagePreview(QWidget* parent = nullptr);

  /// Sets the pages; null: nothing to be printed, `why` is shown instead.
  void setPages(const PrintedPagesPtr& pages, const QString& why);
  [[nodiscard]] int page() const { return m_page; }
  void setPage(int page);
  [[nodiscard]] QSize sizeHint() const override { return {420, 560}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 260}; }

 signals:
  void pageChanged(int page);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void tell();

  PrintedPagesPtr m_pages;
  QString m_why;
  int m_page = 0;
  FlowPainter m_painter;
};

}  // namespace geargraph
