#include "ui/learning/lesson_progress.h"

#include <QVariant>
#include <algorithm>
#include <array>

#include "core/teaching/lessons/mastery.h"
#include "ui/settings/settings.h"

namespace geargraph {
namespace {

QString keyOf(const Lesson& lesson, const char* member) {
  return QStringLiteral("lessons/%1/%2").arg(QString::fromStdString(lesson.id), QLatin1String(member));
}

}  // namespace

int LessonProgress::score() const {
  int score = 0;
  for (const int each : points) score += std::max(each, 0);
  return score;
}

int LessonProgress::doneSteps() const {
  return static_cast<int>(
      std::count_if(points.begin(), points.end(), [](int each) { return each != kNotDone; }));
}

LessonProgress progressOf(const Lesson& lesson) {
  LessonProgress progress;
  const int last = static_cast<int>(lesson.steps.size()) - 1;
  if (lesson.id.empty()) {
    progress.points.assign(lesson.steps.size(), kNotDone);
    return progress;
  }
  progress.step = std::clamp(savedSetting(keyOf(lesson, "step"), 0).toInt(), 0, last);
  const QStringList kept = savedSetting(keyOf(lesson, "points")).toStringList();
  for (qsizetype i = 0; i <= last; ++i) {
    bool isNumber = false;
    const int points = i < kept.size() ? kept[i].toInt(&isNumber) : kNotDone;
    progress.points.push_back(isNumber ? std::clamp(points, kNotDone, kStepPoints) : kNotDone);
  }
  return progress;
}

void saveProgress(const Lesson& lesson, const LessonProgress& progress) {
  if (lesson.id.empty()) return;
  QStringList points;
  for (const int each : progress.points) points << QString::number(each);
  saveSetting(keyOf(lesson, "step"), progress.step);
  saveSetting(keyOf(lesson, "points"), points);
}

QDate LessonMastery::due() const {
  constexpr std::array kDays = {1, 3, 7, 21, 60};
  return on.addDays(kDays[static_cast<std::size_t>(std::clamp(times, 1, int{kDays.size()}) - 1)]);
}

LessonMastery masteryOf(const Lesson& lesson) {
  return {QDate::fromString(savedSetting(keyOf(lesson, "mastered")).toString(), Qt::ISODate),
          savedSetting(keyOf(lesson, "reviews"), 0).toInt()};
}

void saveMastered(const Lesson& lesson, const QDate& today) {
  const LessonMastery before = masteryOf(lesson);
  if (before.isMastered() && today < before.due()) return;
  saveSetting(keyOf(lesson, "mastered"), today.toString(Qt::ISODate));
  saveSetting(keyOf(lesson, "reviews"), before.times + 1);
}

ReviewState reviewStateOf(const Lesson& lesson, const QDate& today) {
  if (!progressOf(lesson).isComplete() || practiceOf(lesson).empty()) return ReviewState::none;
  const LessonMastery mastery = masteryOf(lesson);
  if (!mastery.isMastered()) return ReviewState::freshLeft;
  return today >= mastery.due() ? ReviewState::due : ReviewState::none;
}

std::optional<std::size_t> lessonToBeginWith(const std::vector<Lesson>& lessons) {
  const StartTest test = startTest(lessons, 0);  // the questions differ by the seed, their order does not
  const LessonProgress progress = progressOf(test.lesson);
  if (progress.doneSteps() == 0) return std::nullopt;
  for (std::size_t i = 0; i < test.lessons.size(); ++i) {
    if (progress.points[i] != kStepPoints) return test.lessons[i];
  }
  return std::nullopt;
}

}  // namespace geargraph
