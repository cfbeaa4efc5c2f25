#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/teaching/grading/grade.h"
#include "core/teaching/grading/question.h"

namespace geargraph {

/// What a class got right and which mistakes it made, question by question: how often, and by whom. Variants
/// of a sheet ask the same kinds of questions in one order, so that question 3 is the same question to all.
class ClassSummary {
 public:
  /// Counts the grade of one answer. `student`: as on the answers, else the name of their file.
  void add(int question, const Question& asked, const std::string& student, const Verdict& verdict);

  [[nodiscard]] bool isEmpty() const { return m_questions.empty(); }

  /// "question,kind,result,mistake,times,of,students": of each question the right answers, then the wrong
  /// ones by the first mistake found in them, the most frequent first, those that cannot be read, and those
  /// left out. `of`: answers to that question. Students are sorted, each is named once, and separated by ";
  /// ". English, for programs.
  [[nodiscard]] std::string csv() const;

  /// A page of HTML with bars, in the current language: the points of each student and the questions that
  /// were not right, then the same as csv(). It needs nothing from the network.
  [[nodiscard]] std::string html(const std::string& title) const;

 private:
  enum class Result { right, wrong, unreadable, unanswered };
  struct Outcome {
    int times = 0;
    std::set<std::string> students;
  };
  using Key =
      std::pair<Result, std::string>;  ///< with the mistake's name, empty where none explains the answer
  struct Asked {
    std::string kind;
    int answers = 0;
    std::map<Key, Outcome> outcomes;
  };

  /// Right, wrong by falling frequency, unreadable, unanswered.
  [[nodiscard]] static std::vector<std::pair<Key, const Outcome*>> inOrder(const Asked& asked);
  [[nodiscard]] static std::string titleOf(const Key& key);

  /// What one student reached.
  struct Reached {
    int points = 0;
    int of = 0;
    std::vector<int> missed;  ///< questions that were not right
  };
  [[nodiscard]] std::string studentsTable() const;

  std::map<int, Asked> m_questions;
  std::map<std::string, Reached> m_students;
};

}  // namespace geargraph
