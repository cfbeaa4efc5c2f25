#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph::test {

/// Readable in a failed comparison: "schema /links/0/id [links:3]; ...".
inline std::string summary(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    text += text.empty() ? "" : "; ";
    text += std::string(codeName(diagnostic.code)) + " " + diagnostic.pointer;
    for (const ElementId& element : diagnostic.elements) {
      text += " [" + std::string(listName(element.kind)) + ":" + element.id.text() + "]";
    }
  }
  return text;
}

/// What reading the text gives: "" or the summary of its diagnostics.
inline std::string diagnosticsFor(const std::string& text) {
  const auto read = readMechanism(text);
  return read ? std::string() : summary(read.error());
}

inline std::string contentsOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The text with the first occurrence of `from` replaced; aborts where there is none.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  GEARGRAPH_REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// A small document that has every member of the format: a planetary stage with a brake and a clutch.
inline const std::string kEverything = R"({
  "format": "geargraph", "version": 2, "name": "stage", "notes": "free\ntext", "unit": "in",
  "links": [{"id": 0, "name": "ground"}, {"id": "sun"}, {"id": "arm", "pinned": true, "shapes": [
    {"file": "parts/arm.stl", "position": [0, 0, "1/2"], "orientation": [90, 0, 0.0], "scale": 0.25}]},
    {"id": "planet", "mass": 0.80, "centerOfMass": [0, "1/3", 2.50], "inertia": [1e-3, "1/500", 0.0015, 0, -1e-5, 0]}],
  "axes": [{"id": "a", "point": [0, "22/7", 0.10], "direction": [0, 0, 1e-3], "pinned": true}, {"id": "p"}],
  "turningJoints": [
    {"id": 4, "tail": 0, "head": "sun", "axis": "a", "offset": -1.50},
    {"id": 5, "tail": 0, "head": "arm", "axis": "a", "limits": [-170.0, null]},
    {"id": 6, "tail": "arm", "head": "planet", "axis": "p", "kind": "sliding"}],
  "gearMeshes": [
    {"id": 7, "tail": "sun", "head": "planet", "tailTeeth": 20, "headTeeth": 31, "kind": "external",
     "pitchPoint": [1, 2, 3], "faceWidth": "3/8", "tailWheel": "w", "pinned": true, "efficiency": "49/50",
     "helixAngle": 22.250, "hand": "left", "herringbone": true, "module": "7/3", "pressureAngle": 17.5},
    {"id": 8, "tail": "sun", "head": "planet", "tailTeeth": 20, "headTeeth": 31, "kind": "belt", "crossed": true,
     "pitch": 5.0},
    {"id": 9, "tail": "sun", "head": "planet", "kind": "belt", "tailDiameter": 28.50, "headDiameter": "100/3"},
    {"id": 10, "tail": "sun", "head": "planet", "kind": "pins"},
    {"id": 11, "tail": "sun", "head": "planet", "kind": "screw", "lead": 2.50}],
  "wheels": [{"id": "w", "link": "sun", "profileShift": 0.1, "bore": 8, "backlash": 0.04}],
  "gearDefaults": {"pressureAngle": 20, "backlash": 0.05, "faceWidth": 10, "friction": 0.06},
  "inputs": [{"joint": 4, "speed": "1/3"}],
  "couplings": [{"id": "B", "kind": "brake", "link": "arm"}, {"id": "C", "kind": "clutch", "links": ["sun", "arm"]},
    {"id": "F", "kind": "freewheel", "links": ["arm", "sun"]}],
  "states": [{"name": "1", "engaged": ["B", "C"], "drive": "sun", "driven": "arm", "direction": -1}],
  "engaged": ["C"],
  "loads": [{"id": "pull", "joint": 6, "torque": -12.50}, {"link": "planet", "axis": "p", "torque": "5/2"},
    {"link": "arm", "torque": 3}, {"link": "sun", "force": [0, 1.0, "-20/3"], "point": [0, 40, 132]}],
  "balances": [{"joint": 4}, {"link": "arm", "axis": "a"}, {"link": "planet"}],
  "sharing": "stiffness", "driveTorque": "25/2",
  "density": 2700.0, "gravity": [0, "-981/100", 0],
  "view": {"nodes": {"0": [1, 2.5], "sun": [-3, 4]}, "ttNodes": {"0": [-5, 6]},
           "notes": [{"id": "N1", "text": "sun\nand planet", "at": [7, -8.5], "color": "red"}],
    "camera": {"target": [0, 1, 2.5], "azimuth": -26, "elevation": 20, "distance": 400},
    "colors": {"arm": 5, "planet": 2}, "grid": {"zoom": 1.50}}
})";

/// The mechanism of kEverything.
inline Mechanism everything() {
  return *readMechanism(kEverything);
}

}  // namespace geargraph::test
