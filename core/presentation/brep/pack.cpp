// The bytes between the program and geargraph-step: both are of one build, so numbers are as in memory.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "core/presentation/brep/brep.h"

namespace geargraph {
namespace {

constexpr std::string_view kMagic = "GGB1";

/// Writes what it is shown.
class Packer {
 public:
  explicit Packer(std::string& bytes) : m_bytes(bytes) {}

  template <class Number>
  std::enable_if_t<std::is_arithmetic_v<Number>, void> operator()(const Number& number) {
    m_bytes.append(reinterpret_cast<const char*>(&number), sizeof number);  // NOLINT
  }
  void operator()(const std::string& text) {
    (*this)(static_cast<std::uint32_t>(text.size()));
    m_bytes += text;
  }
  [[nodiscard]] static constexpr bool isReading() { return false; }
  template <class Item>
  std::uint32_t count(const std::vector<Item>& items) {
    const auto number = static_cast<std::uint32_t>(items.size());
    (*this)(number);
    return number;
  }

 private:
  std::string& m_bytes;
};

/// Fills what it is shown, until the bytes end too soon.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : m_bytes(bytes) {}

  template <class Number>
  std::enable_if_t<std::is_arithmetic_v<Number>, void> operator()(Number& number) {
    if (!has(sizeof number)) return;
    std::memcpy(&number, m_bytes.data(), sizeof number);
    m_bytes.remove_prefix(sizeof number);
    if constexpr (std::is_floating_point_v<Number>) m_isSound = m_isSound && std::isfinite(number);
  }
  void operator()(bool& flag) {
    char byte = 0;
    (*this)(byte);
    m_isSound = m_isSound && (byte == 0 || byte == 1);
    flag = byte == 1;
  }
  void operator()(std::string& text) {
    std::uint32_t size = 0;
    (*this)(size);
    if (!has(size)) return;
    text = m_bytes.substr(0, size);
    m_bytes.remove_prefix(size);
  }
  [[nodiscard]] static constexpr bool isReading() { return true; }
  template <class Item>
  std::uint32_t count(std::vector<Item>& items) {
    std::uint32_t number = 0;
    (*this)(number);
    if (!has(number)) return 0;  // every item has a byte at least
    items.resize(number);
    return number;
  }
  [[nodiscard]] bool isSound() const { return m_isSound && m_bytes.empty(); }

 private:
  bool has(std::size_t size) {
    m_isSound = m_isSound && size <= m_bytes.size();
    return m_isSound;
  }

  std::string_view m_bytes;
  bool m_isSound = true;
};

// What follows goes through all values in one order, for writing (const values) and reading alike.

template <class Stream, class Vector>
void passVector(Stream& stream, Vector& vector) {
  for (int i = 0; i < 3; ++i) stream(vector[i]);
}

template <class Stream, class Items, class Each>
void passAll(Stream& stream, Items& items, const Each& each) {
  stream.count(items);
  for (auto& item : items) each(item);
}

template <class Stream, class Numbers>
void passNumbers(Stream& stream, Numbers& numbers) {
  passAll(stream, numbers, [&](auto& number) { stream(number); });
}

template <class Stream, class Points>
void passPoints(Stream& stream, Points& points) {
  passAll(stream, points, [&](auto& point) { passVector(stream, point); });
}

/// Passes the number of a variant's alternative, then the alternative.
template <std::size_t I = 0, class Stream, class Variant, class Each>
void passVariant(Stream& stream, Variant& variant, const Each& each) {
  if constexpr (I == 0) {
    auto number = static_cast<std::uint8_t>(variant.index());
    stream(number);
    if constexpr (Stream::isReading()) {
      switch (number) {
        case 0:
          variant.template emplace<0>();
          break;
        case 1:
          variant.template emplace<1>();
          break;
        default:
          variant.template emplace<2>();
      }
    }
  }
  std::visit(each, variant);
}

template <class Stream>
struct CurvePasser {
  Stream& stream;
  void operator()(const LineCurve& /*line*/) const {}
  template <class Curve>
  void operator()(Curve& curve) const {
    if constexpr (std::is_same_v<std::remove_const_t<Curve>, ArcCurve>) {
      passVector(stream, curve.centre);
      passVector(stream, curve.axis);
    } else if constexpr (std::is_same_v<std::remove_const_t<Curve>, SplineCurve>) {
      passNumbers(stream, curve.knots);
      passPoints(stream, curve.poles);
    }
  }
};

template <class Stream>
struct SurfacePasser {
  Stream& stream;
  template <class Surface>
  void operator()(Surface& surface) const {
    using Kind = std::remove_const_t<Surface>;
    if constexpr (std::is_same_v<Kind, PlaneSurface>) {
      passVector(stream, surface.origin);
      passVector(stream, surface.normal);
    } else if constexpr (std::is_same_v<Kind, RoundSurface>) {
      passVector(stream, surface.origin);
      passVector(stream, surface.axis);
      stream(surface.radius);
      stream(surface.slope);
    } else {
      passNumbers(stream, surface.uKnots);
      passNumbers(stream, surface.vKnots);
      stream(surface.isRuled);
      passPoints(stream, surface.poles);
    }
  }
};

template <class Stream, class Solid>
void passSolid(Stream& stream, Solid& solid) {
  passPoints(stream, solid.points);
  passAll(stream, solid.edges, [&](auto& edge) {
    stream(edge.from);
    stream(edge.to);
    passVariant(stream, edge.curve, CurvePasser<Stream>{stream});
  });
  passAll(stream, solid.faces, [&](auto& face) {
    passVariant(stream, face.surface, SurfacePasser<Stream>{stream});
    stream(face.isReversed);
    passAll(stream, face.loops, [&](auto& loop) {
      passAll(stream, loop, [&](auto& edge) {
        stream(edge.edge);
        stream(edge.isForward);
      });
    });
  });
}

template <class Stream, class Assembly>
void passAssembly(Stream& stream, Assembly& assembly) {
  stream(assembly.name);
  stream(assembly.description);
  stream(assembly.program);
  passAll(stream, assembly.parts, [&](auto& part) {
    stream(part.name);
    for (auto& channel : part.colour) stream(channel);
    passAll(stream, part.solids, [&](auto& solid) { passSolid(stream, solid); });
  });
  passAll(stream, assembly.nodes, [&](auto& node) {
    stream(node.name);
    stream(node.parent);
    stream(node.part);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) stream(node.pose.matrix()(row, column));
    }
  });
}

bool namesWhatIsThere(const CadAssembly& assembly) {
  for (const CadPart& part : assembly.parts) {
    for (const Brep& solid : part.solids) {
      if (flawOf(solid)) return false;
    }
  }
  for (std::size_t i = 0; i < assembly.nodes.size(); ++i) {
    const CadNode& node = assembly.nodes[i];
    if (node.parent >= static_cast<int>(i) || node.parent < -1 || node.part < -1) return false;
    if (node.part >= static_cast<int>(assembly.parts.size())) return false;
  }
  return true;
}

}  // namespace

std::string packedAssembly(const CadAssembly& assembly) {
  std::string bytes(kMagic);
  Packer stream(bytes);
  passAssembly(stream, assembly);
  return bytes;
}

std::optional<CadAssembly> unpackedAssembly(std::string_view bytes) {
  if (bytes.substr(0, kMagic.size()) != kMagic) return std::nullopt;
  Unpacker stream(bytes.substr(kMagic.size()));
  CadAssembly assembly;
  passAssembly(stream, assembly);
  if (!stream.isSound() || !namesWhatIsThere(assembly)) return std::nullopt;
  return assembly;
}

}  // namespace geargraph
