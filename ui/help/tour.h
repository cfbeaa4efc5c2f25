#pragma once

#include <QFrame>
#include <QRegion>
#include <QWidget>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace geargraph {

/// One step of a tour.
struct TourStep {
  QString title;
  QString text;
  /// Makes the target visible; may be empty.
  std::function<void()> prepare;
  /// The region to point at, in coordinates of the window; empty for the whole window.
  std::function<QRegion()> target;
};

/// A guided tour of a window: everything but one part is dimmed, and a card beside that part explains it.
/// Return and the arrow keys go forward and back, Esc ends it. The widgets below do not receive clicks
/// meanwhile.
class Tour : public QWidget {
  Q_OBJECT

 public:
  /// Starts immediately. Deletes itself at the end. @pre there is a step
  Tour(std::vector<TourStep> steps, QWidget* window);

  [[nodiscard]] int step() const { return m_step; }
  [[nodiscard]] int count() const { return static_cast<int>(m_steps.size()); }
  /// The region that is not dimmed; may be empty.
  [[nodiscard]] const QRegion& target() const { return m_target; }
  [[nodiscard]] QFrame& card() { return *m_card; }

 public slots:
  void next();
  void back();
  void end();

 signals:
  void ended();

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  void makeCard();
  QPushButton* makeButton(const char* name, const QString& text, void (Tour::*slot)());
  void goTo(int step);
  void place();
  [[nodiscard]] QPoint cardPlace(const QSize& size) const;

  std::vector<TourStep> m_steps;
  int m_step = 0;
  bool m_hasEnded = false;
  QRegion m_target;
  QFrame* m_card;
  QLabel* m_title;
  QLabel* m_text;
  QLabel* m_count;
  QPushButton* m_skip = nullptr;
  QPushButton* m_back = nullptr;
  QPushButton* m_next = nullptr;
};

}  // namespace geargraph
