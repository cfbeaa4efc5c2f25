#pragma once

#include <QFrame>
#include <QRegion>
#include <QWidget>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace geargraph::inline ui_help {

/// One station of a tour.
struct TourStep {
  QString title;
  QString text;
  /// Brings to the front what is pointed at; may be empty.
  std::function<void()> prepare;
  /// What is pointed at, in coordinates of the window; empty for the whole of it.
  std::function<QRegion()> target;
};

/// A tour of a window: all but one part is dimmed, and a card beside that part tells what it is for. Return
/// and the arrow keys go on and back, Esc ends it. Nothing below can be clicked meanwhile.
class Tour : public QWidget {
  Q_OBJECT

 public:
  /// Begins at once. It deletes itself at its end. @pre there is a step
  Tour(std::vector<TourStep> steps, QWidget* window);

  [[nodiscard]] int step() const { return m_step; }
  [[nodiscard]] int count() const { return static_cast<int>(m_steps.size()); }
  /// The rectangles that are not dimmed; empty where none is pointed at.
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

}  // namespace geargraph::inline ui_help
