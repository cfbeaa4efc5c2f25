#include "core/theory/pose/modular_pose.h"

#include <flint/fmpz.h>

#include <algorithm>
#include <utility>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr std::uint64_t kAngleSeed = 0x616e676c6573U;
/// A length has its root in every other prime: a dozen unlike ones in one of 4,096.
constexpr std::uint64_t kMaxPrimes = 16'384;

/// The least common multiple of the denominators.
Rational commonDenominator(const std::vector<Rational>& values) {
  Rational multiple(1);
  for (const Rational& value : values) {
    fmpz_lcm(fmpq_numref(multiple.flint()), fmpq_numref(multiple.flint()), fmpq_denref(value.flint()));
  }
  return multiple;
}

}  // namespace

std::optional<ModularGeometry> ModularGeometry::forLines(std::span<const ExactLine> lines,
                                                         std::span<const PathStep> joints) {
  for (std::uint64_t seed = 0; seed < kMaxPrimes; ++seed) {
    ModularGeometry geometry{PrimeField(PrimeField::kFirstSeed + seed)};
    if (geometry.m_field.prime() % 4 == 3 && geometry.takeLines(lines, joints)) return geometry;
  }
  return std::nullopt;
}

bool ModularGeometry::takeLines(std::span<const ExactLine> lines, std::span<const PathStep> joints) {
  for (const PathStep& step : joints) {
    const ExactLine& exact = lines[static_cast<std::size_t>(step.joint)];
    const auto point = vector(exact.point);
    const auto direction = vector(exact.direction);
    if (!point || !direction) return false;
    Residue square = 0;
    for (const Residue component : *direction)
      square = m_field.add(square, m_field.multiply(component, component));
    const auto length = root(square);
    if (!length || *length == 0) return false;
    m_lines.push_back({*point, scaled(*direction, m_field.inverse(*length))});
  }
  return true;
}

std::optional<ModularGeometry::Residue> ModularGeometry::root(Residue square) const {
  Residue result = m_field.one();
  Residue power = square;
  for (std::uint64_t exponent = (m_field.prime() + 1) / 4; exponent != 0; exponent >>= 1U) {
    if ((exponent & 1U) != 0) result = m_field.multiply(result, power);
    power = m_field.multiply(power, power);
  }
  if (m_field.multiply(result, result) != square) return std::nullopt;
  return result;
}

std::optional<ModularGeometry::Vector> ModularGeometry::vector(const ExactVector3& exact) const {
  Vector result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto residue = m_field.fromRational(exact[i]);
    if (!residue) return std::nullopt;
    result[i] = *residue;
  }
  return result;
}

ModularGeometry::Vector ModularGeometry::sum(const Vector& a, const Vector& b) const {
  return {m_field.add(a[0], b[0]), m_field.add(a[1], b[1]), m_field.add(a[2], b[2])};
}

ModularGeometry::Vector ModularGeometry::difference(const Vector& a, const Vector& b) const {
  return {m_field.subtract(a[0], b[0]), m_field.subtract(a[1], b[1]), m_field.subtract(a[2], b[2])};
}

ModularGeometry::Vector ModularGeometry::scaled(const Vector& a, Residue factor) const {
  return {m_field.multiply(a[0], factor), m_field.multiply(a[1], factor), m_field.multiply(a[2], factor)};
}

ModularGeometry::Vector ModularGeometry::cross(const Vector& a, const Vector& b) const {
  const auto minor = [&](std::size_t i, std::size_t j) {
    return m_field.subtract(m_field.multiply(a[i], b[j]), m_field.multiply(a[j], b[i]));
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

ModularGeometry::Vector ModularGeometry::rotated(const Rotation& rotation, const Vector& a) const {
  Vector result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result[i] = m_field.add(result[i], m_field.multiply(rotation[i][j], a[j]));
    }
  }
  return result;
}

ModularGeometry::Vector ModularGeometry::moved(const Displacement& displacement, const Vector& point) const {
  return sum(rotated(displacement.rotation, point), displacement.shift);
}

ModularGeometry::Turn ModularGeometry::randomTurn(ResidueStream& random) const {
  // (1 - t^2, 2t) / (1 + t^2); 1 + t^2 is never 0, because -1 has no root modulo p = 3 (mod 4).
  const Residue t = random.next();
  const Residue square = m_field.multiply(t, t);
  const Residue scale = m_field.inverse(m_field.add(m_field.one(), square));
  return {m_field.multiply(m_field.subtract(m_field.one(), square), scale),
          m_field.multiply(m_field.add(t, t), scale)};
}

ModularGeometry::Turn ModularGeometry::product(const Turn& a, const Turn& b) const {
  return {m_field.subtract(m_field.multiply(a.cosine, b.cosine), m_field.multiply(a.sine, b.sine)),
          m_field.add(m_field.multiply(a.cosine, b.sine), m_field.multiply(a.sine, b.cosine))};
}

ModularGeometry::Turn ModularGeometry::multiple(const Turn& angle, const Rational& times) const {
  GEARGRAPH_REQUIRE(times.isInteger());
  std::uint64_t exponent = fmpz_fdiv_ui(fmpq_numref(times.flint()), m_field.prime() + 1);
  Turn result{m_field.one(), 0};
  for (Turn power = angle; exponent != 0; exponent >>= 1U) {
    if ((exponent & 1U) != 0) result = product(result, power);
    power = product(power, power);
  }
  return result;
}

ModularGeometry::Displacement ModularGeometry::identity() const {
  const Residue one = m_field.one();
  return {{Vector{one, 0, 0}, Vector{0, one, 0}, Vector{0, 0, one}}, {}};
}

ModularGeometry::Displacement ModularGeometry::turned(const Displacement& first, const Line& line,
                                                      const Turn& angle) const {
  // Rodrigues, column by column: R e = cos e + sin u x e + (1 - cos) (u . e) u.
  const Residue rest = m_field.subtract(m_field.one(), angle.cosine);
  const Displacement unit = identity();
  Rotation turn{};
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector& e = unit.rotation[j];
    const Vector column = sum(sum(scaled(e, angle.cosine), scaled(cross(line.direction, e), angle.sine)),
                              scaled(line.direction, m_field.multiply(rest, line.direction[j])));
    for (std::size_t i = 0; i < 3; ++i) turn[i][j] = column[i];
  }
  Displacement result;
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector column = rotated(first.rotation, {turn[0][j], turn[1][j], turn[2][j]});
    for (std::size_t i = 0; i < 3; ++i) result.rotation[i][j] = column[i];
  }
  result.shift = moved(first, difference(line.point, rotated(turn, line.point)));
  return result;
}

std::optional<ModularJacobian> ModularJacobian::of(const ModularGeometry& geometry, const ExactMotion& motion,
                                                   std::span<const PathStep> path, const ExactVector3& point,
                                                   bool isReference) {
  const PrimeField& field = geometry.field();
  ModularJacobian jacobian(geometry);
  jacobian.m_columns.resize(static_cast<std::size_t>(motion.inputs));
  std::vector<ModularGeometry::Turn> angles;
  if (!isReference) angles = jacobian.randomAngles(motion, path);

  // The lines where they are in this pose, then the place of the point on the last link.
  std::vector<ModularGeometry::Line> lines;
  ModularGeometry::Displacement pose = geometry.identity();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const ModularGeometry::Line& line = geometry.line(i);
    lines.push_back({geometry.moved(pose, line.point), geometry.rotated(pose.rotation, line.direction)});
    if (!isReference) pose = geometry.turned(pose, line, angles[i]);
  }
  const auto place = geometry.vector(point);
  if (!place) return std::nullopt;
  const ModularGeometry::Vector moved = geometry.moved(pose, *place);

  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto moment = geometry.cross(lines[i].direction, geometry.difference(moved, lines[i].point));
    for (int input = 0; input < motion.inputs; ++input) {
      const auto gain = field.fromRational(motion.gain(path[i].joint, input) * Rational(path[i].direction));
      if (!gain) return std::nullopt;
      auto& column = jacobian.m_columns[static_cast<std::size_t>(input)];
      for (std::size_t row = 0; row < 3; ++row) {
        column[row] = field.add(column[row], field.multiply(*gain, lines[i].direction[row]));
        column[row + 3] = field.add(column[row + 3], field.multiply(*gain, moment[row]));
      }
    }
  }
  return jacobian;
}

std::vector<ModularGeometry::Turn> ModularJacobian::randomAngles(const ExactMotion& motion,
                                                                 std::span<const PathStep> path) const {
  // Input i turns by D times a random angle, D the common denominator of its gains: all joints then turn by
  // whole multiples of it.
  ResidueStream random(m_geometry.field(), kAngleSeed);
  std::vector<ModularGeometry::Turn> angles(path.size(), {m_geometry.field().one(), 0});
  for (int input = 0; input < motion.inputs; ++input) {
    std::vector<Rational> gains;
    for (const PathStep& step : path) gains.push_back(motion.gain(step.joint, input));
    const Rational common = commonDenominator(gains);
    const ModularGeometry::Turn angle = m_geometry.randomTurn(random);
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Rational times = gains[i] * common * Rational(path[i].direction);
      angles[i] = m_geometry.product(angles[i], m_geometry.multiple(angle, times));
    }
  }
  return angles;
}

int ModularJacobian::rank(int rows) const {
  const PrimeField& field = m_geometry.field();
  auto columns = m_columns;
  int rank = 0;
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
    const auto first = columns.begin() + rank;
    const auto pivot =
        std::find_if(first, columns.end(), [row](const auto& column) { return column[row] != 0; });
    if (pivot == columns.end()) continue;
    std::swap(*first, *pivot);
    const PrimeField::Residue inverse = field.inverse((*first)[row]);
    for (auto column = first + 1; column != columns.end(); ++column) {
      const PrimeField::Residue factor = field.multiply((*column)[row], inverse);
      for (std::size_t i = row; i < 6; ++i) {
        (*column)[i] = field.subtract((*column)[i], field.multiply(factor, (*first)[i]));
      }
    }
    ++rank;
  }
  return rank;
}

}  // namespace geargraph
