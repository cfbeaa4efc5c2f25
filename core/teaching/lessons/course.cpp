#include "core/teaching/lessons/course.h"

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/teaching/lessons/bundled_files.h"
#include "core/teaching/lessons/lesson_reader.h"

namespace geargraph {
namespace {

std::string_view textOf(std::span<const unsigned char> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};  // NOLINT: bytes are text
}

}  // namespace

const std::vector<Lesson>& course() {
  static const std::vector<Lesson> lessons = [] {
    std::vector<Lesson> all;
    for (const auto& file : lessonFiles()) {
      auto lesson = readLesson(textOf(file));
      GEARGRAPH_REQUIRE(lesson.has_value());
      all.push_back(std::move(lesson).value());
    }
    return all;
  }();
  return lessons;
}

Expected<MechanismPtr> bundledExample(const std::string& name) {
  const auto files = exampleFiles();
  std::string_view names = textOf(files.front());
  for (std::size_t i = 1; i < files.size(); ++i) {
    const std::string_view file = names.substr(0, names.find('\n'));
    names.remove_prefix(file.size() + 1);
    if (file != name) continue;
    auto mechanism = readMechanism(textOf(files[i]));
    GEARGRAPH_REQUIRE(mechanism.has_value());
    return std::make_shared<const Mechanism>(std::move(mechanism).value());
  }
  return Diagnostic{Code::unknownId, translated("There is no example \"%1\".", {name}), {}, {}};
}

}  // namespace geargraph
