#include "ui/help/search_model.h"

#include <QAction>
#include <algorithm>

#include "core/foundations/base/translation.h"
#include "ui/help/word_match.h"

namespace geargraph {
namespace {

constexpr int kPagesBehind = 4;

bool isPossible(const SearchEntry& entry) {
  return entry.action == nullptr || entry.action->isEnabled();
}

QString kindOf(const SearchEntry& entry) {
  if (entry.isAnswer) return SearchModel::tr("answer");
  if (entry.edit) return SearchModel::tr("edit");
  if (entry.element) return SearchModel::tr("element");
  if (!entry.page.isEmpty()) return SearchModel::tr("manual");
  return entry.term ? SearchModel::tr("term") : SearchModel::tr("command");
}

QString detailOf(const SearchEntry& entry) {
  if (!entry.detail.isEmpty()) return entry.detail;
  if (entry.action != nullptr) return entry.action->toolTip().remove(QLatin1Char('&'));
  if (!entry.page.isEmpty()) return entry.summary;
  if (!entry.term) return SearchModel::tr("Enter selects and shows it.");
  return QString::fromStdString(translated(definitionOf(*entry.term).text));
}

}  // namespace

QStringList SearchModel::kinds() {
  return {tr("answer"), tr("edit"), tr("element"), tr("manual"), tr("term"), tr("command")};
}

void SearchModel::setEntries(std::vector<SearchEntry> entries) {
  beginResetModel();
  m_answers.clear();
  m_entries = std::move(entries);
  m_found.clear();
  endResetModel();
}

void SearchModel::setQuery(const QString& query, std::vector<SearchEntry> answers) {
  const QStringList words = wordsOf(query);
  std::vector<std::pair<int, std::size_t>> found;  // minus the score, so that the best sort first
  for (std::size_t i = 0; i < m_entries.size(); ++i) {
    const SearchEntry& entry = m_entries[i];
    int score = matchScore(entry.haystack, words, false);
    if (score == 0 && !entry.synonyms.isEmpty()) {
      // A name counts more than another word for it.
      score = matchScore(entry.haystack + QLatin1Char(' ') + entry.synonyms, words, false) / 2;
    }
    // What may be mistyped counts least: "film" is no "file" where an animation is made.
    if (score == 0 && !entry.element) score = matchScore(entry.haystack, words, true);
    // Pages tell about what commands do: those come first.
    if (!entry.page.isEmpty() && score > 0) score = std::max(1, score / kPagesBehind);
    if (score > 0) found.emplace_back(-score, i);
  }
  const std::size_t kept = std::min(found.size(), std::size_t{kMax});
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(kept), found.end());
  beginResetModel();
  m_answers = std::move(answers);
  m_found.clear();
  for (std::size_t i = 0; i < kept; ++i) m_found.push_back(found[i].second);
  endResetModel();
}

int SearchModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_answers.size() + m_found.size());
}

QVariant SearchModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || !checkIndex(index)) return {};
  const SearchEntry& entry = entryAt(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return entry.title;
    case Qt::AccessibleDescriptionRole:
    case DetailRole:
      return detailOf(entry);
    case SideRole:
      return entry.side;
    case EnabledRole:
      return isPossible(entry);
    case KindRole:
      return kindOf(entry);
    default:
      return {};
  }
}

}  // namespace geargraph

#include "moc_search_model.cpp"
