#include "core/mechanism/kinds/joint_kind.h"

namespace geargraph {

std::string_view jointKindName(JointKind kind) {
  return kind == JointKind::turning ? "turning" : "sliding";
}

std::optional<JointKind> jointKindFrom(std::string_view name) {
  for (const JointKind kind : {JointKind::turning, JointKind::sliding}) {
    if (name == jointKindName(kind)) return kind;
  }
  return std::nullopt;
}

}  // namespace geargraph
