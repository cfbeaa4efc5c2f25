#pragma once

#include <QStringList>
#include <QWidget>
#include <set>
#include <string>
#include <vector>

#include "core/design/teeth_search/teeth_answer.h"

class QGridLayout;
class QLabel;

namespace geargraph {

struct WheelName;

/// The wheels of a train: which may change, their teeth as drawn and with a choice. A wheel that a centre
/// distance determines is marked "=", one whose link is pinned keeps its teeth.
class WheelsList : public QWidget {
  Q_OBJECT

 public:
  explicit WheelsList(QWidget* parent = nullptr);

  /// `order`: as the search goes through the wheels; empty where nothing was searched.
  void setProblem(const TeethProblem& problem, const std::vector<int>& order);
  /// Teeth by wheel; empty: none is chosen. `title`: of their column.
  void setChosen(const std::vector<int>& teeth, const QString& title);
  void clear();
  /// Clears it, and forgets the wishes for wheels.
  void reset();
  /// Forgets the wishes for wheels that the mechanism does not have.
  void forgetUnknown(const Mechanism& mechanism);
  /// The wheels that keep their teeth by the user's wish, "15:tail".
  [[nodiscard]] const std::set<std::string>& kept() const { return m_kept; }

 signals:
  void edited();

 private:
  struct Row {
    std::string name;
    int drawn = 0;
    QLabel* follows = nullptr;
    QLabel* now = nullptr;
    QLabel* chosen = nullptr;
  };

  void makeRows(const TeethProblem& problem, const std::vector<WheelName>& names);
  QLabel* addLabel(int row, int column, const QString& text, const QString& look);

  std::set<std::string> m_kept;
  std::vector<Row> m_rows;
  QStringList m_shown;  ///< what the rows are made of
  QWidget* m_page = nullptr;
  QGridLayout* m_grid = nullptr;
  QLabel* m_title = nullptr;
};

}  // namespace geargraph
