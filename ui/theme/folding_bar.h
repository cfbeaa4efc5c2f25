#pragma once

#include <QWidget>

class QBoxLayout;

namespace geargraph {

/// Two groups of controls: one row where it is wide enough for both, otherwise the second below the first, so
/// that a panel need not be wider than the wider group.
class FoldingBar : public QWidget {
  Q_OBJECT

 public:
  /// Takes both groups. The second is at the trailing edge.
  FoldingBar(QWidget* first, QWidget* second, QWidget* parent = nullptr);

  [[nodiscard]] bool isFolded() const;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void fold();

  QWidget* m_first;
  QWidget* m_second;
  QBoxLayout* m_layout;
};

}  // namespace geargraph
