#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/teaching/lessons/lesson.h"

namespace geargraph {

/// The number of fresh questions at the end of a lesson that have to be right at the first check.
constexpr int kFreshQuestions = 3;

/// The id of the lesson that startTest() makes.
inline constexpr std::string_view kStartTestId = "start-test";

/// The tasks of fresh questions about a lesson: those that its file lists, else its exercise steps, each kind
/// about each mechanism once. Empty for a lesson about which the program can ask nothing.
[[nodiscard]] std::vector<PracticeTask> practiceOf(const Lesson& lesson);

/// A fresh question as a step, whose task is an exercise. The tasks follow one another in turn; the same
/// `seed` and `number`, from 0, give the same question. @pre practiceOf(lesson) is not empty
[[nodiscard]] LessonStep freshStep(const Lesson& lesson, std::uint64_t seed, int number);

/// The lesson with a fresh question as a further step.
[[nodiscard]] Lesson withFreshStep(Lesson lesson, std::uint64_t seed, int number);

/// A test that tells where to begin: a fresh question about each lesson, in their order.
struct StartTest {
  Lesson lesson;
  std::vector<std::size_t> lessons;  ///< by step: the position of the lesson that it is about
};
[[nodiscard]] StartTest startTest(const std::vector<Lesson>& lessons, std::uint64_t seed);

}  // namespace geargraph
