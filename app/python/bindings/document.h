#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/python/bindings/errors.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::python {

/// A mechanism with its derived geometry. Immutable: edits return new documents.
class Document {
 public:
  explicit Document(PlacedMechanism placed)
      : m_geometry(std::make_shared<const DerivedGeometry>(std::move(placed))) {}

  [[nodiscard]] const DerivedGeometryPtr& geometry() const { return m_geometry; }
  [[nodiscard]] const PlacedMechanism& placed() const { return m_geometry->placed(); }
  [[nodiscard]] const Mechanism& mechanism() const { return m_geometry->mechanism(); }

 private:
  DerivedGeometryPtr m_geometry;
};

/// Numbers are passed as strings ("22/7", "0.1", "3") to keep them exact.
using NumberText = std::string;
using TripleText = std::array<std::string, 3>;

/// Converts a string; raises geargraph.Error (schema) if it is not a number.
[[nodiscard]] Number numberFrom(const NumberText& text);
[[nodiscard]] std::optional<Number> numberFrom(const std::optional<NumberText>& text);
[[nodiscard]] NumberTriple tripleFrom(const TripleText& text);
[[nodiscard]] std::optional<NumberTriple> tripleFrom(const std::optional<TripleText>& text);
[[nodiscard]] Rational rationalFrom(const NumberText& text);

/// The document after an edit; raises geargraph.Error if the edit is rejected.
[[nodiscard]] Document edited(Expected<Mechanism> result);
[[nodiscard]] Document edited(Expected<PlacedMechanism> result);

}  // namespace geargraph::python
