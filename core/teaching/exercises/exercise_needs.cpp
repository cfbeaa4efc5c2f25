// What mechanisms lack for questions.

#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {

Lack withoutEdges(const ExerciseSource& source) {
  if (source.graph().edgeCount() == 0) return translated("no joints");
  return std::nullopt;
}

Lack withoutTree(const ExerciseSource& source) {
  if (source.tree() == nullptr) return translated("the turning joints are no spanning tree");
  if (source.graph().t() == 0) return translated("no joints");
  return std::nullopt;
}

Lack withoutMeshes(const ExerciseSource& source) {
  if (const Lack reason = withoutTree(source)) return reason;
  if (source.graph().c() == 0) return translated("no meshes");
  return std::nullopt;
}

Lack withoutEquations(const ExerciseSource& source) {
  if (const Lack reason = withoutMeshes(source)) return reason;
  if (hasSlides(source.mechanism())) return translated("a joint slides");
  if (source.ttGraph() == nullptr || source.matroid() == nullptr) return translated("a mesh has no geometry");
  return std::nullopt;
}

Lack withoutFreedom(const ExerciseSource& source) {
  if (const Lack reason = withoutEquations(source)) return reason;
  return source.matroid()->dof == 0 ? Lack(translated("nothing can move")) : std::nullopt;
}

Lack withoutStates(const ExerciseSource& source) {
  if (const Lack reason = withoutEquations(source)) return reason;
  if (source.mechanism().couplings.empty()) return translated("no brakes or clutches");
  return statesWithRatio(source).empty() ? Lack(translated("no states with a ratio")) : std::nullopt;
}

}  // namespace geargraph
