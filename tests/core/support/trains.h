#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::test {

using ExactTriple = std::array<Rational, 3>;

[[nodiscard]] ExactTriple sum(const ExactTriple& a, const ExactTriple& b);
[[nodiscard]] ExactTriple scaled(const ExactTriple& a, const Rational& factor);
[[nodiscard]] Rational dot(const ExactTriple& a, const ExactTriple& b);
[[nodiscard]] NumberTriple numbers(const ExactTriple& triple);
[[nodiscard]] ExactTriple exactOf(const NumberTriple& triple);

/// Builds gear trains link by link, exactly. Link ids are "0", "1", ... in order; joints and meshes get ids
/// "j0", "m0", ... Pitch points follow from the axes and the teeth (design of the operating pitch point):
/// parallel axes at feet a_i, a_j: P = (N_j a_i - s N_i a_j)/(N_j - s N_i);
/// axes that meet in O:            P = O + m (N_j u_i - s N_i u_j) for any m, u of length 1.
class TrainBuilder {
 public:
  explicit TrainBuilder(std::string name);

  /// A new axis. `direction` has a rational length; it is stored as given.
  int axis(const ExactTriple& point, const ExactTriple& direction);
  /// A new link that turns about the axis relative to `parent`; returns its number.
  int link(int parent, int axis, std::string name = {});
  /// The same with the joint drawn the other way, tail the new link.
  int linkReversed(int parent, int axis, std::string name = {});

  void external(int tail, int tailAxis, int tailTeeth, int head, int headAxis, int headTeeth);
  void internal(int tail, int tailAxis, int tailTeeth, int head, int headAxis, int headTeeth);
  /// A bevel pair; both axes meet. `sign` is that of the terminal equation, for axes as they point; `side`
  /// scales the pitch line from the apex and may be negative.
  void bevel(int tail, int tailAxis, int tailTeeth, int head, int headAxis, int headTeeth, int sign,
             const Rational& side = 1);
  void input(int joint, const Rational& speed = 1);

  [[nodiscard]] const Mechanism& mechanism() const { return m_mechanism; }

 private:
  int addLink(int parent, int axis, bool reversed, std::string name);
  GearMesh& mesh(int tail, int head, int tailTeeth, int headTeeth, const ExactTriple& pitchPoint);
  void parallel(int tail, int tailAxis, int tailTeeth, int head, int headAxis, int headTeeth, bool external);

  Mechanism m_mechanism;
};

/// The unit vector of an axis that has a rational length.
[[nodiscard]] ExactTriple unitDirection(const Axis& axis);

/// A rotation with rational entries, from the quaternion (w, x, y, z).
using ExactRotation = std::array<ExactTriple, 3>;
[[nodiscard]] ExactRotation rotation(int w, int x, int y, int z);

/// The same mechanism elsewhere: points turned and shifted, directions turned. Exact.
[[nodiscard]] Mechanism moved(Mechanism mechanism, const ExactRotation& rotation, const ExactTriple& shift);
/// The same mechanism with axis `axis` pointing the other way and the joints on it turned over: rates keep
/// their meaning.
[[nodiscard]] Mechanism withAxisFlipped(Mechanism mechanism, int axis);
/// The same mechanism with directions of other lengths.
[[nodiscard]] Mechanism withDirectionsScaled(Mechanism mechanism, const std::vector<Rational>& factors);

/// The paper's robot in its drawn pose: Table 1 with module 2 and teeth 18/36, 20/30, 24/18, 16/24, A1 = 60,
/// A2 = 90, A3 = 140; ids equal to the paper's labels.
[[nodiscard]] Mechanism robot();

}  // namespace geargraph::test
