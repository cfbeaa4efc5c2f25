#include "core/mechanism/model/link_mass.h"

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

/// All principal minors of the second moments are at least 0.
bool isInertiaOfABody(const InertiaNumbers& inertia) {
  const Rational half(1, 2);
  const Rational xx = inertia[0].exact();
  const Rational yy = inertia[1].exact();
  const Rational zz = inertia[2].exact();
  const Rational a = half * (yy + zz - xx);
  const Rational b = half * (xx + zz - yy);
  const Rational c = half * (xx + yy - zz);
  const Rational d = -inertia[3].exact();
  const Rational e = -inertia[4].exact();
  const Rational f = -inertia[5].exact();
  for (const Rational& minor : {a, b, c, a * b - d * d, a * c - e * e, b * c - f * f}) {
    if (minor.sign() < 0) return false;
  }
  const Rational determinant = a * (b * c - f * f) - d * (d * c - e * f) + e * (d * f - b * e);
  return determinant.sign() >= 0;
}

}  // namespace

std::optional<MassProblem> massProblem(const LinkMass& mass) {
  if (mass.mass.exact().sign() < 0) return MassProblem{"mass", translated("A mass is at least 0, in kg.")};
  if (mass.inertia && !isInertiaOfABody(*mass.inertia)) {
    return MassProblem{
        "inertia", translated("No body has this inertia: each principal moment is at least 0 and at most the "
                              "sum of the other two. The numbers are xx, yy, zz, xy, xz, yz in kg m², about "
                              "the centre of mass.")};
  }
  return std::nullopt;
}

}  // namespace geargraph
