#include "core/teaching/exercises/class_summary.h"

#include <algorithm>
#include <array>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/csv.h"
#include "core/teaching/exercises/exercise_kinds.h"
#include "core/teaching/grading/mistake_names.h"

namespace geargraph {
namespace {

constexpr std::array<const char*, 4> kResults = {"right", "wrong", "unreadable", "unanswered"};

std::string joined(const std::set<std::string>& students) {
  std::string text;
  for (const std::string& student : students) text += (text.empty() ? "" : "; ") + student;
  return text;
}

std::string percent(int times, int of) {
  return std::to_string((200 * times + of) / (2 * of));
}

}  // namespace

void ClassSummary::add(int question, const Question& asked, const std::string& student,
                       const Verdict& verdict) {
  Asked& entry = m_questions[question];
  entry.kind = asked.kind;
  ++entry.answers;
  Key key{Result::wrong, {}};
  if (verdict.isRight) {
    key.first = Result::right;
  } else if (verdict.isBlank) {
    key.first = Result::unanswered;
  } else {
    if (verdict.isUnreadable) key.first = Result::unreadable;
    if (verdict.mistake) key.second = verdict.mistake->name;
  }
  Outcome& outcome = entry.outcomes[key];
  ++outcome.times;
  outcome.students.insert(student);
  Reached& reached = m_students[student];
  reached.points += verdict.points;
  reached.of += asked.points;
  if (!verdict.isRight) reached.missed.push_back(question);
}

std::vector<std::pair<ClassSummary::Key, const ClassSummary::Outcome*>> ClassSummary::inOrder(
    const Asked& asked) {
  std::vector<std::pair<Key, const Outcome*>> rows;
  for (const auto& [key, outcome] : asked.outcomes) rows.emplace_back(key, &outcome);
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
    return a.first.first != b.first.first ? a.first.first < b.first.first : a.second->times > b.second->times;
  });
  return rows;
}

std::string ClassSummary::titleOf(const Key& key) {
  switch (key.first) {
    case Result::right:
      return translated("right");
    case Result::unanswered:
      return translated("not answered");
    case Result::wrong:
    case Result::unreadable:
      break;
  }
  if (!key.second.empty()) return translated(mistakeTitle(key.second));
  return key.first == Result::wrong ? translated("wrong, by no known mistake") : translated("cannot be read");
}

std::string ClassSummary::csv() const {
  std::string text = "question,kind,result,mistake,times,of,students\n";
  for (const auto& [number, asked] : m_questions) {
    for (const auto& [key, outcome] : inOrder(asked)) {
      const std::array<std::string, 7> cells = {std::to_string(number),
                                                asked.kind,
                                                kResults[static_cast<std::size_t>(key.first)],
                                                key.second,
                                                std::to_string(outcome->times),
                                                std::to_string(asked.answers),
                                                joined(outcome->students)};
      for (std::size_t i = 0; i < cells.size(); ++i) text += (i > 0 ? "," : "") + csvLabel(cells[i], ',');
      text += '\n';
    }
  }
  return text;
}

std::string ClassSummary::studentsTable() const {
  std::string text = "<h2>" + escapedXml(translated("Students")) + "</h2>\n<table>\n";
  for (const auto& [student, reached] : m_students) {
    std::string missed;
    for (const int question : reached.missed)
      missed += (missed.empty() ? "" : ", ") + std::to_string(question);
    text += "<tr><th scope=\"row\">" + escapedXml(student) +
            "</th><td class=\"bar\"><span class=\"right\" style=\"width:" +
            percent(reached.points, std::max(1, reached.of)) + "%\"></span></td><td>" +
            escapedXml(translated("%1 of %2", {std::to_string(reached.points), std::to_string(reached.of)})) +
            "</td><td>" +
            (missed.empty() ? std::string() : escapedXml(translated("not right: %1", {missed}))) +
            "</td></tr>\n";
  }
  return text + "</table>\n";
}

std::string ClassSummary::html(const std::string& title) const {
  const std::string heading = escapedXml(title.empty() ? translated("Exercises") : title);
  std::string body = m_students.empty() ? std::string() : studentsTable();
  for (const auto& [number, asked] : m_questions) {
    const auto kind = kindFromName(asked.kind);
    body += "<h2>" +
            escapedXml(translated("Question %1: %2",
                                  {std::to_string(number), kind ? kindTitle(*kind) : asked.kind})) +
            "</h2>\n<table>\n";
    for (const auto& [key, outcome] : inOrder(asked)) {
      const std::string share = percent(outcome->times, asked.answers);
      body += "<tr><th scope=\"row\">" + escapedXml(titleOf(key)) + "</th><td class=\"bar\"><span class=\"" +
              kResults[static_cast<std::size_t>(key.first)] + "\" style=\"width:" + share +
              "%\"></span></td><td>" +
              escapedXml(
                  translated("%1 of %2", {std::to_string(outcome->times), std::to_string(asked.answers)})) +
              "</td><td>" +
              (key.first == Result::right ? std::string() : escapedXml(joined(outcome->students))) +
              "</td></tr>\n";
    }
    body += "</table>\n";
  }
  return "<!DOCTYPE html>\n<html lang=\"" + translated("en") +
         "\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, "
         "initial-scale=1\">\n<title>" +
         heading +
         R"html(</title>
<style>
body { font: 16px/1.5 sans-serif; margin: 2em auto; max-width: 70em; padding: 0 1em; color-scheme: light dark; }
h2 { font-size: 1.1em; margin: 1.6em 0 0.4em; }
table { border-collapse: collapse; width: 100%; }
th, td { padding: 0.2em 1em 0.2em 0; text-align: left; vertical-align: top; font-weight: normal; }
th { width: 20em; } td:nth-child(3) { width: 5em; } td:last-child { width: 20em; }
.bar { width: 14em; }
.bar span { display: block; height: 1em; margin-top: 0.25em; min-width: 2px; border-radius: 2px; }
.right { background: #2a8a5a; }
.wrong { background: #c4552d; }
.unreadable { background: #a8862a; }
.unanswered { background: #8a8f98; }
</style>
</head>
<body>
<h1>)html" +
         heading + "</h1>\n" + body + "</body>\n</html>\n";
}

}  // namespace geargraph
