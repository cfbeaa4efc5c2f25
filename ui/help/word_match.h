#pragma once

#include <QString>
#include <QStringList>

namespace geargraph {

/// The text in the form that is searched: lower case, without accents, "Γ" as "gamma".
[[nodiscard]] QString foldedText(const QString& text);

/// The words of a query, folded.
[[nodiscard]] QStringList wordsOf(const QString& query);

/// How well a folded text matches the words of a query; 0 if a word does not occur in it. Each word may match
/// a whole word (best), the beginning of one, a part of one, or, if `fuzzy`, a word with one typing error.
/// Words with a digit never match fuzzily.
/// Cost: O(length of the text) per word.
[[nodiscard]] int matchScore(const QString& text, const QStringList& words, bool fuzzy);

}  // namespace geargraph
