#include "ui/help/search_answers.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <array>

#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/shift_edits.h"
#include "ui/canvas/brake_edits.h"
#include "ui/help/link_ratio.h"
#include "ui/help/word_match.h"
#include "ui/models/link_text.h"
#include "ui/models/printed_number.h"

namespace geargraph {
namespace {

constexpr std::size_t kMostMeshes = 8;
constexpr std::size_t kMostLinks = 4;

QString tr(const char* text) {
  return QCoreApplication::translate("search", text);
}

/// Is the word the English one, or one of the language's, parted by blanks?
bool isOneOf(const QString& word, const char* english, const QString& own) {
  return word == QLatin1String(english) || foldedText(own).split(QLatin1Char(' ')).contains(word);
}

bool isFiller(const QString& word) {
  static const std::array kEnglish = {"of", "the", "link", "links", "gear", "mesh", "with", "by", "between"};
  const auto isIt = [&](const char* each) { return word == QLatin1String(each); };
  return std::any_of(kEnglish.begin(), kEnglish.end(), isIt) ||
         foldedText(tr("of the link between")).split(QLatin1Char(' ')).contains(word);
}

/// "to", "and", or what parts two numbers of a ratio.
bool isBetween(const QString& word) {
  static const std::array kEnglish = {"to", "and", "against", ":"};
  const auto isIt = [&](const char* each) { return word == QLatin1String(each); };
  return std::any_of(kEnglish.begin(), kEnglish.end(), isIt) ||
         foldedText(tr("to and against")).split(QLatin1Char(' ')).contains(word);
}

QStringList wordsAndMarks(const QString& query) {
  QString text = foldedText(query);
  for (const char mark : {':', '/', ','}) text.replace(QLatin1Char(mark), QStringLiteral(" : "));
  return text.split(QRegularExpression(QStringLiteral("\\s+")), Qt::SkipEmptyParts);
}

QString nameOf(const Mechanism& mechanism, int node) {
  if (node == 0) return tr("the ground");
  return linkText(QString::number(mechanism.linkLabel(node)),
                  mechanism.links[static_cast<std::size_t>(node)].name);
}

/// The nodes that are meant: one with this label, else those with these words in their names.
std::vector<int> linksMeant(const Mechanism& mechanism, const QStringList& words) {
  std::vector<int> nodes;
  if (words.isEmpty()) return nodes;
  bool isLabel = false;
  const int label = words.front().toInt(&isLabel);
  for (int node = 0; node <= mechanism.n(); ++node) {
    const Link& link = mechanism.links[static_cast<std::size_t>(node)];
    if (isLabel && words.size() == 1) {
      if (mechanism.linkLabel(node) == label) return {node};
      continue;
    }
    const QString name = foldedText(QString::fromStdString(link.name));
    if (!name.isEmpty() && matchScore(name, words, false) > 0) nodes.push_back(node);
  }
  if (nodes.size() > kMostLinks) nodes.resize(kMostLinks);
  return nodes;
}

/// What is meant on both sides of "to"; without it, by the two words.
std::pair<QStringList, QStringList> sidesOf(const QStringList& words) {
  QStringList first, second;
  bool isSecond = false;
  for (const QString& word : words) {
    if (isBetween(word)) {
      isSecond = !first.isEmpty();
    } else if (!isFiller(word)) {
      (isSecond ? second : first) << word;
    }
  }
  if (second.isEmpty() && first.size() == 2) second << first.takeLast();
  return {first, second};
}

SearchEntry ratioEntry(const AnswerSource& source, int of, int to) {
  const Mechanism& mechanism = *source.mechanism;
  const QString one = nameOf(mechanism, of), other = nameOf(mechanism, to);
  SearchEntry entry;
  entry.isAnswer = true;
  entry.elements = {ElementId(mechanism.links[static_cast<std::size_t>(of)].id),
                    ElementId(mechanism.links[static_cast<std::size_t>(to)].id)};
  const QString pair = QStringLiteral("%1 : %2").arg(one, other);
  if (!source.areAnswersOpen) {
    entry.title = pair;
    entry.detail = tr("A ratio holds the answer: it is told when the step is right or shown.");
    return entry;
  }
  const bool isOfDocument = source.snapshot && *source.snapshot->mechanism == mechanism;
  const LinkRatio ratio = isOfDocument ? linkRatio(*source.snapshot, of, to) : LinkRatio();
  using enum LinkRatio::Kind;
  const bool isThere = ratio.kind == exact || ratio.kind == now;
  entry.title = isThere ? QStringLiteral("%1 = %2").arg(pair, printedFraction(ratio.value)) : pair;
  const QString enter = QLatin1Char(' ') + tr("Enter selects both.");
  const Rational size = ratio.value.sign() < 0 ? -ratio.value : ratio.value;
  const QString times = printedFraction(size);
  if (isThere) entry.side = printedNumber(ratio.value.toDouble());
  switch (ratio.kind) {
    case exact:
      entry.detail =
          (ratio.value.sign() < 0
               ? tr("Exactly, in every motion: %1 turns %3 times as fast as %2, the other way round.")
               : tr("Exactly, in every motion: %1 turns %3 times as fast as %2, the same way round."))
              .arg(one, other, times);
      break;
    case now:
      entry.detail = tr("With the speeds that the inputs have now: with others it is another.");
      break;
    case still:
      entry.detail = tr("There is no ratio to %1, which stands still.").arg(other);
      break;
    case notParallel:
      entry.detail =
          tr("They turn about axes that are not parallel, or about several at once: the results "
             "have their speeds about each axis.");
      break;
    case unsolved:
      entry.detail = tr("There is no exact solution now: Problems says what is missing.");
      break;
  }
  entry.detail += enter;
  return entry;
}

std::vector<SearchEntry> ratios(const QStringList& words, const AnswerSource& source) {
  const auto [first, second] = sidesOf(words);
  std::vector<SearchEntry> entries;
  for (const int of : linksMeant(*source.mechanism, first)) {
    for (const int to : linksMeant(*source.mechanism, second)) {
      if (of != to) entries.push_back(ratioEntry(source, of, to));
    }
  }
  return entries;
}

bool isHeld(const Mechanism& mechanism, LinkId link) {
  return std::any_of(mechanism.couplings.begin(), mechanism.couplings.end(), [&](const ShiftElement& each) {
    return each.kind == ShiftElementKind::brake && each.links.front() == link &&
           isEngaged(mechanism, each.id);
  });
}

/// Brakes that are, or are not yet, engaged: what is so already is told.
std::vector<SearchEntry> brakes(const QStringList& words, const AnswerSource& source, bool holds) {
  const Mechanism& mechanism = *source.mechanism;
  QStringList named;
  std::copy_if(words.begin(), words.end(), std::back_inserter(named),
               [](const QString& word) { return !isFiller(word); });
  std::vector<SearchEntry> entries;
  for (const int node : linksMeant(mechanism, named)) {
    const LinkId link = mechanism.links[static_cast<std::size_t>(node)].id;
    SearchEntry entry;
    entry.elements = {ElementId(link)};
    const QString name = nameOf(mechanism, node);
    entry.title = holds ? tr("Hold %1 with a brake").arg(name) : tr("Release the brake of %1").arg(name);
    if (node == 0) {
      entry.isAnswer = true;
      entry.detail = tr("The ground does not move.");
    } else if (isHeld(mechanism, link) == holds) {
      entry.isAnswer = true;
      entry.detail = holds ? tr("Its brake is engaged already.") : tr("No brake holds it.");
    } else {
      entry.edit = toggleBrakeEdit(mechanism, link);
      entry.detail = tr("Changes the document; one step back (Ctrl+Z) undoes it.");
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

SearchEntry teethEntry(const Mechanism& mechanism, const GearMesh& mesh, int label, int tail, int head) {
  SearchEntry entry;
  const auto labelOf = [&](LinkId link) {
    const auto found = std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                    [link](const Link& each) { return each.id == link; });
    return QString::number(mechanism.linkLabel(static_cast<int>(found - mechanism.links.begin())));
  };
  entry.elements = {ElementId(mesh.id)};
  entry.title = tr("Mesh %1: %2 teeth on link %3, %4 on link %5")
                    .arg(label)
                    .arg(tail)
                    .arg(labelOf(mesh.tail))
                    .arg(head)
                    .arg(labelOf(mesh.head));
  entry.side = tr("now %1 : %2").arg(mesh.tailTeeth).arg(mesh.headTeeth);
  if (mesh.tailTeeth == tail && mesh.headTeeth == head) {
    entry.isAnswer = true;
    entry.detail = tr("It has these teeth already.");
    return entry;
  }
  entry.edit = Edit{tr("Change teeth"), [id = mesh.id, tail, head](const PlacedMechanism& before) {
                      return withTeethFitted(before, id, tail, head);
                    }};
  entry.detail = tr("Changes the document; one step back (Ctrl+Z) undoes it.");
  return entry;
}

std::vector<SearchEntry> teeth(const QStringList& words, const AnswerSource& source) {
  const Mechanism& mechanism = *source.mechanism;
  std::vector<int> numbers;
  for (const QString& word : words) {
    if (isFiller(word) || isBetween(word)) continue;
    bool isNumber = false;
    numbers.push_back(word.toInt(&isNumber));
    if (!isNumber) return {};
  }
  if (numbers.size() != 2 && numbers.size() != 3) return {};
  const std::size_t first = numbers.size() - 2;
  std::vector<SearchEntry> chosen, all;
  for (int i = 0; i < mechanism.c(); ++i) {
    const GearMesh& mesh = mechanism.gearMeshes[static_cast<std::size_t>(i)];
    const int label = mechanism.meshLabel(i);
    if (first == 1 && label != numbers.front()) continue;
    const bool isSelected = source.selected.contains(ElementId(mesh.id));
    if (!isSelected && all.size() == kMostMeshes) continue;
    (isSelected ? chosen : all)
        .push_back(teethEntry(mechanism, mesh, label, numbers[first], numbers[first + 1]));
  }
  return chosen.empty() ? all : chosen;
}

}  // namespace

std::vector<SearchEntry> answersTo(const QString& query, const AnswerSource& source) {
  QStringList words = wordsAndMarks(query);
  if (words.size() < 2 || !source.mechanism) return {};
  const QString verb = words.takeFirst();
  if (isOneOf(verb, "ratio", tr("ratio i"))) return ratios(words, source);
  if (isOneOf(verb, "hold", tr("hold brake fix"))) return brakes(words, source, true);
  if (isOneOf(verb, "release", tr("release free"))) return brakes(words, source, false);
  if (isOneOf(verb, "teeth", tr("teeth z"))) return teeth(words, source);
  return {};
}

}  // namespace geargraph
