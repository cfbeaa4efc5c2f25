#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "core/teaching/grading/member_reader.h"
#include "core/teaching/lessons/lesson.h"

namespace geargraph {

/// Reports an error if the object has any other member.
void checkMembers(MemberReader& reader, const JsonValue& object, const std::string& pointer,
                  std::initializer_list<std::string_view> known);

/// The member as a mechanism: the name of an example, or a document.
[[nodiscard]] LessonDocument readDocument(MemberReader& reader, const JsonValue& object,
                                          std::string_view name, const std::string& pointer);

/// Reads a member such as "gearMeshes/17" as an element, if it exists.
[[nodiscard]] std::optional<ElementId> readElement(MemberReader& reader, const JsonValue& object,
                                                   std::string_view name, const std::string& pointer);

/// Reads the member "task" of a step with its content.
void readTask(MemberReader& reader, const JsonValue& step, const std::string& pointer, LessonStep& into);

}  // namespace geargraph
