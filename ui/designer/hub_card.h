#pragma once

#include <QWidget>

#include "ui/designer/hub_services.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QWidget;

namespace geargraph {

class DrawingPreview;

/// The chosen candidate with its section, what all candidates share, and the count or measurement that tells
/// them apart, with its answers as buttons.
class HubCard final : public QWidget {
  Q_OBJECT

 public:
  explicit HubCard(QWidget* parent = nullptr);

  /// The candidates that are left. Null: nothing has been searched.
  void setSearch(const HubSearchPtr& search);
  /// `number`: in the list, from 1; 0: none is chosen.
  void setNumber(int number);
  void setDetail(const HubDetailPtr& detail);

 signals:
  void openWanted();
  void answered(const geargraph::HubQuestion& question, const QString& answer);

 private:
  [[nodiscard]] QWidget* makeQuestion();
  void updateQuestion();
  [[nodiscard]] const HubQuestion* question() const;

  HubSearchPtr m_search;
  QLabel* m_title;
  DrawingPreview* m_drawing;
  QLabel* m_shared;
  QWidget* m_box = nullptr;
  QLabel* m_heading = nullptr;
  QComboBox* m_questions = nullptr;
  QLabel* m_ask = nullptr;
  QWidget* m_answers = nullptr;
  QLineEdit* m_other = nullptr;
  QPushButton* m_open;
};

}  // namespace geargraph
