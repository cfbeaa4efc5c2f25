#include "ui/help/word_match.h"

#include <algorithm>

namespace geargraph {
namespace {

constexpr int kWhole = 100;
constexpr int kBeginning = 70;
constexpr int kWithin = 35;
constexpr int kSlip = 20;
constexpr qsizetype kShortestWithSlip = 4;

bool isWordAt(const QString& text, qsizetype at) {
  return at == 0 || !text[at - 1].isLetterOrNumber();
}

/// Do the words differ by one letter too many, too few, another, or two exchanged? `typed` may stop early.
bool isOneSlipFrom(QStringView typed, QStringView word) {
  qsizetype i = 0;
  while (i < typed.size() && i < word.size() && typed[i] == word[i]) ++i;
  const QStringView typedRest = typed.mid(i);
  const QStringView wordRest = word.mid(i);
  if (typedRest.isEmpty() || wordRest.isEmpty()) return typedRest.size() <= 1;
  const auto goesOn = [](QStringView whole, QStringView start) { return whole.startsWith(start); };
  if (goesOn(wordRest, typedRest.mid(1)) || goesOn(wordRest.mid(1), typedRest) ||
      goesOn(wordRest.mid(1), typedRest.mid(1))) {
    return true;
  }
  return typedRest.size() > 1 && wordRest.size() > 1 && typedRest[0] == wordRest[1] &&
         typedRest[1] == wordRest[0] && goesOn(wordRest.mid(2), typedRest.mid(2));
}

bool hasDigit(const QString& word) {
  return std::any_of(word.begin(), word.end(), [](QChar letter) { return letter.isDigit(); });
}

int slipScore(const QString& text, const QString& word) {
  if (word.size() < kShortestWithSlip || hasDigit(word)) return 0;
  for (qsizetype at = 0; at < text.size();) {
    qsizetype end = at;
    while (end < text.size() && text[end].isLetterOrNumber()) ++end;
    if (end > at && text[at] == word[0] && isOneSlipFrom(word, QStringView(text).mid(at, end - at))) {
      return kSlip;
    }
    at = end + 1;
  }
  return 0;
}

/// The best place of the word in the text; earlier words of a text count a little more.
int wordScore(const QString& text, const QString& word, bool fuzzy) {
  int best = 0;
  for (qsizetype at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1)) {
    const qsizetype end = at + word.size();
    const bool ends = end == text.size() || !text[end].isLetterOrNumber();
    const int score = !isWordAt(text, at) ? kWithin : ends ? kWhole : kBeginning;
    best = std::max(best, score + (at == 0 ? 10 : 0));
    if (best >= kWhole) break;
  }
  return best == 0 && fuzzy ? slipScore(text, word) : best;
}

}  // namespace

QString foldedText(const QString& text) {
  QString folded;
  for (const QChar letter : text.normalized(QString::NormalizationForm_KD)) {
    if (letter.category() == QChar::Mark_NonSpacing) continue;
    folded += letter.toLower();
  }
  return folded.replace(QStringLiteral("γ"), QStringLiteral("gamma"))
      .replace(QStringLiteral("θ"), QStringLiteral("theta"));
}

QStringList wordsOf(const QString& query) {
  return foldedText(query).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

int matchScore(const QString& text, const QStringList& words, bool fuzzy) {
  int sum = 1;  // no word finds everything
  for (const QString& word : words) {
    const int score = wordScore(text, word, fuzzy);
    if (score == 0) return 0;
    sum += score;
  }
  return sum;
}

}  // namespace geargraph
