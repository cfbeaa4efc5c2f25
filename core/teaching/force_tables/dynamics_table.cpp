#include "core/teaching/force_tables/dynamics_table.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/locale.h"
#include "core/teaching/force_tables/spoken_cell.h"

namespace geargraph {
namespace {

ForceCell textCell(std::string text) {
  return {std::move(text), std::nullopt, {}};
}
ForceCell measureCell(double value) {
  return {shownNumber(value), value, {}};
}
/// With a head and a meaning that are marked by toTranslate().
ForceColumn numberColumn(const char* head, std::string unit, const char* meaning) {
  return wordedColumn(head, std::move(unit), meaning, true);
}
ForceColumn textColumn(const char* head, const char* meaning) {
  return wordedColumn(head, {}, meaning, false);
}

std::string inputLabel(const Mechanism& mechanism, const MechanismDynamics& dynamics, std::size_t input) {
  return std::to_string(mechanism.jointLabel(dynamics.inputs[input]));
}
ElementId inputId(const Mechanism& mechanism, const MechanismDynamics& dynamics, std::size_t input) {
  return mechanism.turningJoints[dynamics.inputs[input]].id;
}

/// Coordinates below the accuracy of a body's points, which are of single precision, are 0, not -2.02e-05 mm:
/// a wheel has its centre on its axis.
Eigen::Vector3d centerOf(const MassProperties& body) {
  constexpr double kAccuracy = 1e-5;
  const double gyration = body.mass > 0 ? std::sqrt(body.inertia.trace() / body.mass) : 0;
  const double noise = kAccuracy * (body.center.norm() + gyration);
  return body.center.unaryExpr([noise](double at) { return std::abs(at) < noise ? 0.0 : at; });
}

/// A column of numbers in brackets.
template <class Vector>
std::string texColumn(const Vector& values) {
  std::string text = "\\begin{pmatrix}";
  for (Eigen::Index i = 0; i < values.size(); ++i) text += (i == 0 ? " " : " \\\\ ") + texNumber(values[i]);
  return text + " \\end{pmatrix}";
}

}  // namespace

ValueTable massTable(const Mechanism& mechanism, std::span<const LinkInertia> links, double metres) {
  GEARGRAPH_REQUIRE(links.size() == mechanism.links.size());
  constexpr const char* center = toTranslate("The centre of mass in the reference pose, in the base frame.");
  constexpr const char* inertia = toTranslate(
      "The moment of inertia about the centre of mass, about the direction of this axis of the base frame, "
      "in the reference pose.");
  ValueTable table;
  table.columns = {
      textColumn(toTranslate("link"), toTranslate("The link, by its number.")),
      numberColumn(toTranslate("mass"), "kg",
                   toTranslate("The mass: of the link's solids at the density, or as it is stated.")),
      numberColumn("x", mechanism.unit, center),
      numberColumn("y", mechanism.unit, center),
      numberColumn("z", mechanism.unit, center),
      numberColumn("I xx", "kg m²", inertia),
      numberColumn("I yy", "kg m²", inertia),
      numberColumn("I zz", "kg m²", inertia),
      textColumn(
          toTranslate("from"),
          toTranslate("Where the mass comes from: the link's solids, or the document, which states it."))};
  for (std::size_t link = 1; link < links.size(); ++link) {
    const MassProperties& body = links[link].body;
    ForceRow row;
    row.elements = {mechanism.links[link].id};
    row.cells = {textCell(std::to_string(mechanism.linkLabel(static_cast<int>(link)))),
                 measureCell(body.mass)};
    for (const double place : centerOf(body)) row.cells.push_back(measureCell(place / metres));
    for (const double moment : Eigen::Vector3d(body.inertia.diagonal()))
      row.cells.push_back(measureCell(moment));
    row.cells.push_back(spokenCell([&] { return massSourceText(links[link].source); }));
    table.rows.push_back(std::move(row));
  }
  return table;
}

ValueTable reflectedTable(const Mechanism& mechanism, const MechanismDynamics& dynamics,
                          const DynamicState& state) {
  ValueTable table;
  table.columns = {textColumn(toTranslate("link"), toTranslate("The link, by its number."))};
  for (std::size_t i = 0; i < dynamics.inputs.size(); ++i) {
    const std::string label = inputLabel(mechanism, dynamics, i);
    table.columns.push_back(
        spokenColumn([&] { return translated("at %1", {label}); }, "kg m²",
                     translated("The inertia that the link has at the motor of joint %1 while the other "
                                "inputs stand still: for a link that turns about one axis its moment of "
                                "inertia times the square of its ratio.",
                                {label}),
                     true));
  }
  const Eigen::Index links = state.reflected.rows();
  for (Eigen::Index link = 1; link < links; ++link) {
    ForceRow row;
    row.elements = {mechanism.links[link].id};
    row.cells = {textCell(std::to_string(mechanism.linkLabel(static_cast<int>(link))))};
    for (const double inertia : state.reflected.row(link)) row.cells.push_back(measureCell(inertia));
    table.rows.push_back(std::move(row));
  }
  ForceRow sums;
  sums.cells = {spokenCell([] { return translated("sum"); })};
  for (Eigen::Index i = 0; i < state.reflected.cols(); ++i)
    sums.cells.push_back(measureCell(state.reflected.col(i).sum()));
  table.rows.push_back(std::move(sums));
  return table;
}

ValueTable equationTable(const Mechanism& mechanism, const MechanismDynamics& dynamics,
                         const DynamicState& state) {
  ValueTable table;
  table.columns = {textColumn(toTranslate("input"), toTranslate("The joint of the input, by its number."))};
  const std::size_t inputs = dynamics.inputs.size();
  for (std::size_t i = 0; i < inputs; ++i) {
    const std::string label = inputLabel(mechanism, dynamics, i);
    table.columns.push_back(
        {"M " + label, "kg m²",
         translated("The generalised inertia: the torque in the row's joint for each rad/s² of joint %1.",
                    {label}),
         true, false});
  }
  table.columns.push_back(numberColumn("h", "N m",
                                       toTranslate("What motors have to give at constant speeds, for "
                                                   "Coriolis and centrifugal forces and for weight.")));
  table.columns.push_back(numberColumn(
      toTranslate("load"), "N m", toTranslate("What the loads contribute, as a torque in the row's joint.")));
  table.columns.push_back(
      numberColumn(toTranslate("holding"), "N m",
                   toTranslate("The torque of the motor that keeps the speeds constant: h less the load.")));
  for (std::size_t i = 0; i < inputs; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    ForceRow row;
    row.elements = {inputId(mechanism, dynamics, i)};
    row.cells = {textCell(inputLabel(mechanism, dynamics, i))};
    for (const double entry : state.equation.inertia.row(at)) row.cells.push_back(measureCell(entry));
    const double bias = state.equation.bias[at];
    const double load = state.equation.load[at];
    for (const double torque : {bias, load, bias - load}) row.cells.push_back(measureCell(torque));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string equationTex(const Mechanism& mechanism, const MechanismDynamics& dynamics,
                        const DynamicState& state) {
  const std::size_t inputs = dynamics.inputs.size();
  if (inputs == 0 || inputs > static_cast<std::size_t>(kMaxTypesetInputs)) return {};
  std::string accelerations = "\\begin{pmatrix}";
  std::string torques = "\\begin{pmatrix}";
  std::string matrix = "\\begin{pmatrix}";
  for (std::size_t i = 0; i < inputs; ++i) {
    const std::string label = "_{" + inputLabel(mechanism, dynamics, i) + "}";
    const std::string next = i == 0 ? " " : " \\\\ ";
    accelerations += next + "\\ddot{\\theta}" + label;
    torques += next + "\\tau" + label;
    matrix += next;
    for (std::size_t k = 0; k < inputs; ++k) {
      const double entry = state.equation.inertia(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
      matrix += (k == 0 ? "" : " & ") + texNumber(entry);
    }
  }
  const std::string end = " \\end{pmatrix}";
  return matrix + end + " " + accelerations + end + " + " + texColumn(state.equation.bias) + " = " + torques +
         end + " + " + texColumn(state.equation.load);
}

std::string massSourceText(MassSource source) {
  switch (source) {
    case MassSource::none:
      return translated("no solid: massless");
    case MassSource::solids:
      return translated("solids");
    case MassSource::scaled:
      return translated("stated, spread as its solids");
    case MassSource::stated:
      return translated("stated");
  }
  return {};
}

std::string texNumber(double value, int digits) {
  std::array<char, 32> buffer{};
  const auto result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
  std::string text(buffer.data(), result.ptr);
  const std::size_t exponent = text.find('e');
  if (exponent == std::string::npos) return spokenTexNumber(text);
  const int power = std::atoi(text.c_str() + exponent + 1);  // NOLINT: of std::to_chars
  return spokenTexNumber(text.substr(0, exponent)) + " \\cdot 10^{" + std::to_string(power) + "}";
}

}  // namespace geargraph
