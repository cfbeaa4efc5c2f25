#include "ui/learning/lesson_progress.h"

#include <QVariant>
#include <algorithm>

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

}  // namespace geargraph
