#pragma once

#include <QAbstractListModel>

#include "ui/help/search_entries.h"

namespace geargraph {

/// The results of a query: answers, then what is found, best first; with equal scores commands come before
/// elements, terms, and pages of the manual.
class SearchModel : public QAbstractListModel {
  Q_OBJECT

 public:
  static constexpr int kMax = 100;  ///< number of results kept

  enum Role {
    SideRole = Qt::UserRole,  ///< QString: the text at the right
    EnabledRole,              ///< bool: false only for disabled commands
    KindRole,                 ///< QString: "command", "element", "term", "manual", "answer", "edit"
    DetailRole,               ///< QString: description, or why it is disabled
  };

  using QAbstractListModel::QAbstractListModel;

  /// The words for the kinds of entries, in the current language.
  [[nodiscard]] static QStringList kinds();

  void setEntries(std::vector<SearchEntry> entries);
  /// `answers`: to the query, shown before all that is found. Cost: O(length of all entries' texts).
  void setQuery(const QString& query, std::vector<SearchEntry> answers = {});
  /// @pre the row is in the model
  [[nodiscard]] const SearchEntry& entryAt(int row) const {
    const auto at = static_cast<std::size_t>(row);
    return at < m_answers.size() ? m_answers[at] : m_entries[m_found[at - m_answers.size()]];
  }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

 private:
  std::vector<SearchEntry> m_answers;
  std::vector<SearchEntry> m_entries;
  std::vector<std::size_t> m_found;
};

}  // namespace geargraph
