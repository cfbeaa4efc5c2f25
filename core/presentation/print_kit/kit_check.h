#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/presentation/print_kit/print_kit.h"

namespace geargraph {

/// The parts in their places, for tests of overlap.
class KitAssembly {
 public:
  KitAssembly();
  ~KitAssembly();
  KitAssembly(const KitAssembly&) = delete;
  KitAssembly& operator=(const KitAssembly&) = delete;

  void add(const KitPart& part);
  /// Takes the last one away.
  void drop();
  [[nodiscard]] std::size_t size() const;
  /// Do the surfaces of two parts meet when `a` is displaced by `moved` and `b` by `movedB`?
  [[nodiscard]] bool overlaps(std::size_t a, std::size_t b,
                              const Eigen::Isometry3d& moved = Eigen::Isometry3d::Identity(),
                              const Eigen::Isometry3d& movedB = Eigen::Isometry3d::Identity()) const;
  /// The first two parts that overlap; std::nullopt if none do.
  [[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> overlap(const std::stop_token& stop) const;

  /// An order of assembly, found by taking the whole apart from above (the first of the directions): parts
  /// that leave along one of the directions without meeting another one, first singly, then with the parts of
  /// their link. Steps that were not found free are marked. Cost: O(parts^2) straight ways in steps of a
  /// millimetre.
  [[nodiscard]] std::vector<KitStep> order(std::span<const KitPart> parts,
                                           std::span<const Eigen::Vector3d> directions,
                                           const std::stop_token& stop) const;

 private:
  struct Shape;
  std::vector<std::unique_ptr<Shape>> m_shapes;
};

}  // namespace geargraph
