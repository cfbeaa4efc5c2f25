#pragma once

#include <QString>
#include <QStringList>

namespace geargraph::inline search {

/// A text as it is searched: lower case, accents taken off, "Γ" spelled "gamma".
[[nodiscard]] QString foldedText(const QString& text);

/// The words of a query, folded.
[[nodiscard]] QStringList wordsOf(const QString& query);

/// How well a folded text answers the words of a query; 0 where a word finds nothing in it. Every word has to
/// stand in the text: as a whole word (best), as the beginning of one, within one, or, where `fuzzy`, with
/// one slip of the keyboard. A word that holds a digit is never taken fuzzily.
/// Cost: O(length of the text) a word.
[[nodiscard]] int matchScore(const QString& text, const QStringList& words, bool fuzzy);

}  // namespace geargraph::inline search
