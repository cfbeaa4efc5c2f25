#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/foundations/exact/prime_field.h"
#include "core/theory/pose/jacobian.h"

namespace geargraph {

/// Lines, rotations and displacements modulo a prime p with p = 3 (mod 4), in which the directions have
/// length 1. A rank over these residues is the rank over the algebraic numbers that they represent, except
/// with a probability near 1/p. (Which of its two roots a length takes does not matter: that is another
/// embedding of the same numbers.)
class ModularGeometry {
 public:
  using Residue = PrimeField::Residue;
  using Vector = std::array<Residue, 3>;
  using Rotation = std::array<Vector, 3>;  ///< rows

  /// cos + i sin of an angle.
  struct Turn {
    Residue cosine = 0;
    Residue sine = 0;
  };
  struct Line {
    Vector point;
    Vector direction;  ///< of length 1
  };
  struct Displacement {
    Rotation rotation;
    Vector shift;
  };

  /// Searches for a prime in which the lengths of these joints' directions have roots; std::nullopt if none
  /// is found.
  [[nodiscard]] static std::optional<ModularGeometry> forLines(std::span<const ExactLine> lines,
                                                               std::span<const PathStep> joints);

  [[nodiscard]] const PrimeField& field() const { return m_field; }
  [[nodiscard]] const Line& line(std::size_t step) const { return m_lines[step]; }
  /// std::nullopt if the prime divides a denominator.
  [[nodiscard]] std::optional<Vector> vector(const ExactVector3& exact) const;

  [[nodiscard]] Vector sum(const Vector& a, const Vector& b) const;
  [[nodiscard]] Vector difference(const Vector& a, const Vector& b) const;
  [[nodiscard]] Vector scaled(const Vector& a, Residue factor) const;
  [[nodiscard]] Vector cross(const Vector& a, const Vector& b) const;
  [[nodiscard]] Vector rotated(const Rotation& rotation, const Vector& a) const;
  [[nodiscard]] Vector moved(const Displacement& displacement, const Vector& point) const;

  /// A random point of the unit circle, other than that of the angle 0.
  [[nodiscard]] Turn randomTurn(ResidueStream& random) const;
  [[nodiscard]] Turn product(const Turn& a, const Turn& b) const;
  /// A rational multiple of the angle: the circle has p + 1 points, so the denominator is inverted modulo its
  /// order. Cost: some 60 doublings.
  [[nodiscard]] Turn multiple(const Turn& angle, const Rational& times) const;

  [[nodiscard]] Displacement identity() const;
  /// The displacement `first`, after a turn about a line of the reference pose: first * Exp(line, angle).
  [[nodiscard]] Displacement turned(const Displacement& first, const Line& line, const Turn& angle) const;

 private:
  explicit ModularGeometry(const PrimeField& field) : m_field(field) {}
  [[nodiscard]] bool takeLines(std::span<const ExactLine> lines, std::span<const PathStep> joints);
  [[nodiscard]] std::optional<Residue> root(Residue square) const;

  PrimeField m_field;
  std::vector<Line> m_lines;  ///< by step of the path
};

/// The Jacobian of a point modulo a prime, in the reference pose or in a random one.
class ModularJacobian {
 public:
  /// std::nullopt if the prime divides a denominator.
  [[nodiscard]] static std::optional<ModularJacobian> of(const ModularGeometry& geometry,
                                                         const ExactMotion& motion,
                                                         std::span<const PathStep> path,
                                                         const ExactVector3& point, bool isReference);

  /// The rank of the first `rows` rows.
  [[nodiscard]] int rank(int rows) const;

 private:
  explicit ModularJacobian(const ModularGeometry& geometry) : m_geometry(geometry) {}
  [[nodiscard]] std::vector<ModularGeometry::Turn> randomAngles(const ExactMotion& motion,
                                                                std::span<const PathStep> path) const;

  const ModularGeometry& m_geometry;
  std::vector<std::array<PrimeField::Residue, 6>> m_columns;  ///< by input
};

}  // namespace geargraph
