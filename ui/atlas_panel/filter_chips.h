#pragma once

#include <QWidget>
#include <map>
#include <optional>

class QGridLayout;
class QLabel;
class QToolButton;

namespace geargraph {

/// A filter by a small number: a button for each choice with how many chains it would show below it. A second
/// press lets go of a choice.
class FilterChips final : public QWidget {
  Q_OBJECT

 public:
  /// `name`: of the filter, in "links.6" of its buttons.
  FilterChips(const QString& name, const QString& title, QWidget* parent = nullptr);

  /// The text of a choice in place of its number, before its first count.
  void setText(int choice, const QString& text) { m_texts[choice] = text; }
  void setCounts(const std::map<int, int>& counts);
  void setChoice(const std::optional<int>& choice);
  [[nodiscard]] const std::optional<int>& choice() const { return m_choice; }
  /// As shown; -1 if there is no such choice.
  [[nodiscard]] int countOf(int choice) const;

 signals:
  /// The user has made another choice.
  void changed();

 private:
  struct Chip {
    QToolButton* button = nullptr;
    QLabel* count = nullptr;
  };
  Chip& chipOf(int choice);

  QString m_name;
  QGridLayout* m_layout;
  std::map<int, QString> m_texts;
  std::map<int, Chip> m_chips;
  std::map<int, int> m_counts;
  std::optional<int> m_choice;
};

}  // namespace geargraph
