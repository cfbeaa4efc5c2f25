#pragma once

#include <QWidget>

#include "ui/forces/force_views.h"

class QButtonGroup;
class QComboBox;
class QHBoxLayout;

namespace geargraph {

/// The questions as a row of buttons, or as a list where there is no room for all of them; and at the
/// trailing edge controls that concern each of them.
class QuestionBar : public QWidget {
  Q_OBJECT

 public:
  explicit QuestionBar(QWidget* parent = nullptr);

  /// Adds a control after the questions.
  void addControl(QWidget* control);
  void choose(ForceQuestion question);
  [[nodiscard]] ForceQuestion chosen() const;
  /// Are the questions in a list?
  [[nodiscard]] bool isFolded() const;
  [[nodiscard]] QSize minimumSizeHint() const override;

 signals:
  /// Emitted when the user has chosen another question.
  void asked(geargraph::ForceQuestion question);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void fold();
  [[nodiscard]] int widthBeside(const QWidget& questions) const;

  QWidget* m_row;  ///< of the buttons
  QButtonGroup* m_buttons;
  QComboBox* m_list;
  QWidget* m_controls;
  QHBoxLayout* m_layout;
};

}  // namespace geargraph
