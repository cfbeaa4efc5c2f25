#pragma once

#include <string>

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The differences between two versions of one document, counted by id.
struct Difference {
  struct Count {
    int added = 0;
    int removed = 0;
    int changed = 0;
    friend bool operator==(const Count&, const Count&) = default;
  };

  Count links;
  Count joints;
  Count meshes;
  bool axes = false;
  bool inputs = false;
  bool places = false;  ///< of the nodes in the drawing
  bool other = false;   ///< name, notes of the document and on the sheet, wheels, couplings, loads, members
                        ///< of other programs, the order of a list

  friend bool operator==(const Difference&, const Difference&) = default;
};

/// Cost: O((n + t + c) log (n + t + c)).
[[nodiscard]] Difference differenceOf(const Mechanism& before, const Mechanism& after);

/// Are they equal except for the positions in the drawings, which no analysis depends on?
/// Cost: O(n + t + c).
[[nodiscard]] bool isSameButForView(const Mechanism& a, const Mechanism& b);

/// Have they the same links, axes, joints and wheels, with the same teeth, inputs and engaged couplings,
/// whatever their names, notes and places on sheets? Released couplings and attached 3D files are not
/// compared. Cost: O(n + t + c).
[[nodiscard]] bool isSameTrain(const Mechanism& a, const Mechanism& b);

/// Have they the same digraph, down to names, numbers, motors and couplings? Teeth, axes and other dimensions
/// are not compared. Cost: O(n + t + c).
[[nodiscard]] bool isSameDigraph(const Mechanism& a, const Mechanism& b);

/// As text for the user: "2 links and 1 turning joint added; 1 gear mesh changed; inputs changed", or
/// "nothing".
[[nodiscard]] std::string differenceText(const Difference& difference);

}  // namespace geargraph
