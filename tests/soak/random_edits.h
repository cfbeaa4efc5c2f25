#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::soak {

using Reduce = std::function<Expected<Mechanism>(const Mechanism&)>;

/// Random arguments for the edits of a mechanism: mostly its own elements, now and then one that it does not
/// have, and numbers and texts up to the limits of the format. The same seed gives the same sequence.
class RandomArguments {
 public:
  RandomArguments(std::mt19937_64& random, const Mechanism& mechanism)
      : m_random(random), m_mechanism(mechanism) {}

  [[nodiscard]] const Mechanism& mechanism() const { return m_mechanism; }
  /// 0..limit-1. @pre limit > 0
  [[nodiscard]] int below(int limit);
  [[nodiscard]] bool oneIn(int count) { return below(count) == 0; }

  [[nodiscard]] LinkId link();
  [[nodiscard]] AxisId axis();
  [[nodiscard]] JointId joint();
  [[nodiscard]] MeshId mesh();
  [[nodiscard]] ShiftElementId coupling();
  /// The position of a state. @pre there are states
  [[nodiscard]] int state();
  [[nodiscard]] ElementId element();
  [[nodiscard]] std::vector<ElementId> elements(int most);

  /// Usual tooth counts, now and then one at a limit or beyond it.
  [[nodiscard]] int teeth();
  /// Whole numbers, decimals as they are typed ("0.10", "1e-3"), fractions with long numerators.
  [[nodiscard]] Number number();
  [[nodiscard]] NumberTriple triple();
  [[nodiscard]] CanvasPoint place();
  /// A name: empty, with quotes, of other scripts, of thousands of characters.
  [[nodiscard]] std::string text();
  /// An id out of a small supply, so that some collide.
  [[nodiscard]] std::string id();
  template <class Value>
  [[nodiscard]] std::optional<Value> maybe(Value value) {
    return oneIn(4) ? std::nullopt : std::optional<Value>(std::move(value));
  }

 private:
  template <class Element>
  [[nodiscard]] auto idIn(const std::vector<Element>& list);

  std::mt19937_64& m_random;
  const Mechanism& m_mechanism;
};

/// One kind of edit: the function of the program that makes it, and calls of it with random arguments. An
/// empty Reduce where the mechanism has nothing that it could be called with.
struct EditKind {
  std::string function;
  std::function<Reduce(RandomArguments& random)> make;
  int weight = 4;  ///< how often it is drawn, relative to the others; expensive ones are rare
};

/// Every kind of edit that the program makes. The test `soak.edit_kinds` compares it with the headers.
[[nodiscard]] const std::vector<EditKind>& editKinds();

/// A kind of edit drawn by weight.
[[nodiscard]] const EditKind& randomKind(std::mt19937_64& random);

}  // namespace geargraph::soak
