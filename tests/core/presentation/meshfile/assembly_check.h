#pragma once

#include <QString>

namespace geargraph::test {

/// What a check of an assembly export found, from its files alone: it shares no code with what made them.
struct AssemblyMeasurements {
  int gears = 0;
  int pairs = 0;
  int frames = 0;
  double phaseError = 0;   ///< worst of all pairs and frames, in pitches
  double penetration = 0;  ///< deepest point of one gear inside its mate, in modules
  double leastTravel =
      1e9;             ///< of the pairs: pitches between the least and the greatest position in the frames
  bool closed = true;  ///< every STL welds, by equal numbers, to a closed mesh with positive volume
  QString problem;     ///< what could not be read
};

/// Reads `folder`/assembly.json and its STL files, and measures. `turned`: a gear that is turned about its
/// own axis by `pitches` first, to see that the check notices.
[[nodiscard]] AssemblyMeasurements checkedAssembly(const QString& folder, const QString& turned = {},
                                                   double pitches = 0);

}  // namespace geargraph::test
