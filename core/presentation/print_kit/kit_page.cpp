#include "core/presentation/print_kit/kit_page.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/foundations/base/readable.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kSteepOverhang = 60 * std::numbers::pi / 180;

/// A length in mm with at most two decimals.
std::string lengthText(double mm) {
  return readableNumber(std::round(mm * 100) / 100);
}

/// For numbers in drawings, whatever the language.
std::string coordinate(double value) {
  const auto tenths = static_cast<long long>(std::llround(value * 10));
  const std::string digits = std::to_string(std::abs(tenths) / 10);
  const std::string last = std::abs(tenths) % 10 == 0 ? "" : "." + std::to_string(std::abs(tenths) % 10);
  return (tenths < 0 ? "-" : "") + digits + last;
}

std::string kindText(KitPartKind kind) {
  switch (kind) {
    case KitPartKind::wheel:
      return translated("wheel");
    case KitPartKind::ring:
      return translated("ring gear");
    case KitPartKind::shaft:
      return translated("shaft");
    case KitPartKind::arm:
      return translated("arm or carrier plate");
    case KitPartKind::pedestal:
      return translated("pedestal with a tenon");
    case KitPartKind::base:
      return translated("base plate");
    case KitPartKind::bridge:
      return translated("bridge");
    case KitPartKind::post:
      return translated("post");
    case KitPartKind::spacer:
      return translated("spacer");
    case KitPartKind::clip:
      return translated("clip, pressed on");
  }
  return {};
}

std::string cell(const std::string& text) {
  return "<td>" + escapedXml(text) + "</td>";
}

std::string heading(const std::string& text) {
  return "<h2>" + escapedXml(text) + "</h2>\n";
}

std::string headRow(const std::vector<std::string>& titles) {
  std::string row = "<table>\n<tr>";
  for (const std::string& title : titles) row += "<th>" + escapedXml(title) + "</th>";
  return row + "</tr>\n";
}

std::string measures(const KitPart& part) {
  const Eigen::AlignedBox3d box = boundsOf(*part.solid);
  if (part.diameter > 0 && part.inner > 0)
    return "⌀ " + lengthText(part.diameter) + " / " + lengthText(part.inner) + " × " +
           lengthText(part.length);
  if (part.diameter > 0) return "⌀ " + lengthText(part.diameter) + " × " + lengthText(part.length);
  const Vector3d size = box.sizes();
  return lengthText(size.x()) + " × " + lengthText(size.y()) + " × " + lengthText(size.z());
}

std::string linkName(const Mechanism& mechanism, LinkOrdinal link) {
  const std::string label = std::to_string(mechanism.linkLabel(link));
  const std::string& name = mechanism.links[link].name;
  return name.empty() ? label : label + " " + name;
}

std::string partsSection(const PrintKit& kit, const Mechanism& mechanism) {
  std::map<std::size_t, std::size_t> plateOf;
  for (std::size_t p = 0; p < kit.plates.size(); ++p) {
    for (const PlacedPart& placed : kit.plates[p].parts) plateOf[placed.part] = p + 1;
  }
  std::string text = heading(translated("Parts")) +
                     headRow({translated("Name"), translated("Link"), translated("What it is"),
                              translated("Size, mm"), translated("Engraved"), translated("Plate")});
  for (std::size_t p = 0; p < kit.parts.size(); ++p) {
    const KitPart& part = kit.parts[p];
    text += "<tr>" + cell(part.name) + cell(linkName(mechanism, part.link)) + cell(kindText(part.kind)) +
            cell(measures(part)) + cell(part.number.empty() ? "–" : part.number) +
            cell(std::to_string(plateOf[p])) + "</tr>\n";
  }
  text += "</table>\n";
  std::vector<std::string> steep;
  double flattest = 0;
  for (const KitPart& part : kit.parts) {
    flattest = std::max(flattest, part.overhang);
    if (part.overhang > kSteepOverhang) steep.push_back(part.name);
  }
  const std::string degrees = readableNumber(std::ceil(flattest * 180 / std::numbers::pi));
  text +=
      "<p>" +
      escapedXml(steep.empty() ? translated("All parts lie on a flat face and need no supports: "
                                            "nothing hangs over by more than %1 degrees from the upright.",
                                            {degrees})
                               : translated("Supports are needed below the teeth of: %1.",
                                            {listed(steep, kAllNames)})) +
      "</p>\n";
  return text;
}

std::string boughtSection(const PrintKit& kit) {
  std::string text = heading(translated("Shafts and screws"));
  text += "<p>" +
          escapedXml(
              translated("Shafts are printed lying on their flat, which keys what is pressed on them. Round "
                         "rods of the same diameter do as well, with a flat filed to the same depth.")) +
          "</p>\n" + headRow({translated("Name"), translated("Diameter, mm"), translated("Length, mm")});
  for (const KitPart& part : kit.parts) {
    if (part.kind != KitPartKind::shaft) continue;
    text += "<tr>" + cell(part.name) +
            cell(part.inner > 0 ? lengthText(part.diameter) + " / " + lengthText(part.inner)
                                : lengthText(part.diameter)) +
            cell(lengthText(part.length)) + "</tr>\n";
  }
  text += "</table>\n";
  if (kit.screws.empty()) return text + "<p>" + escapedXml(translated("No screws are needed.")) + "</p>\n";
  text += "<ul>\n";
  for (const KitScrew& screw : kit.screws) {
    text += "<li>" +
            escapedXml(translated(
                "%1 countersunk screws M%2 × %3, which cut their thread in the part",
                {std::to_string(screw.count), lengthText(screw.diameter), lengthText(screw.length)})) +
            "</li>\n";
  }
  return text + "</ul>\n";
}

/// A tooth or a space in words; where it is not engraved, by its number from the mark of none.
std::string markText(const KitMark& mark, bool isSpace, const std::string& gear) {
  const bool isMarked = isSpace ? mark.isSpaceMarked : mark.isToothMarked;
  const std::string count = std::to_string(mark.count);
  if (isMarked && isSpace) return translated("the space with %1 square(s) on %2", {count, gear});
  if (isMarked) return translated("the tooth with %1 dot(s) on %2", {count, gear});
  const std::string number = std::to_string((isSpace ? mark.space : mark.tooth) + 1);
  if (isSpace) return translated("the space after tooth %1 of %2 (no room for a mark)", {number, gear});
  return translated("tooth %1 of %2 (no room for a mark)", {number, gear});
}

std::string marksSection(const PrintKit& kit, const Mechanism& mechanism, const GearTrain& train) {
  std::string text = heading(translated("Teeth that meet"));
  text += "<p>" +
          escapedXml(
              translated("Put the wheels together with each marked tooth in the marked space. All marks meet "
                         "at once in the pose of assembly.3mf.")) +
          "</p>\n<ul>\n";
  for (const KitMark& mark : kit.marks) {
    text += "<li>" +
            escapedXml(translated("Mesh %1: %2 goes into %3.",
                                  {std::to_string(mechanism.meshLabel(mark.mesh)),
                                   markText(mark, false, train.gears[mark.toothGear].name),
                                   markText(mark, true, train.gears[mark.spaceGear].name)})) +
            "</li>\n";
  }
  return text + "</ul>\n";
}

std::string wayText(const Vector3d& way, const Vector3d& up) {
  if ((way + up).norm() < 1e-6) return translated("from above");
  if ((way - up).norm() < 1e-6) return translated("from below");
  return translated("along (%1, %2, %3)", {lengthText(way.x()), lengthText(way.y()), lengthText(way.z())});
}

std::string stepsSection(const PrintKit& kit) {
  std::string text = heading(translated("Order of assembly"));
  text += "<p>" +
          escapedXml(
              translated("Each part comes to its place past all those before it, as assembly.3mf shows it. "
                         "Turn wheels a little where teeth meet.")) +
          "</p>\n<ol>\n";
  for (const KitStep& step : kit.steps) {
    std::vector<std::string> names;
    for (const std::size_t part : step.parts) names.push_back(kit.parts[part].name);
    std::string line = listed(names, kAllNames);
    if (step.direction.norm() > 0) line += ", " + wayText(step.direction, kit.up);
    if (!step.isFree) line += " (" + translated("no straight way was found free; bend or turn it in") + ')';
    text += "<li>" + escapedXml(line) + "</li>\n";
  }
  return text + "</ol>\n";
}

std::string plateSection(const PrintKit& kit, std::size_t index) {
  const KitPlate& plate = kit.plates[index];
  const double width = kit.options.bedX, depth = kit.options.bedY;
  std::string text = heading(translated("Plate %1", {std::to_string(index + 1)}));
  text += "<svg viewBox=\"0 0 " + coordinate(width) + ' ' + coordinate(depth) +
          "\" role=\"img\">\n<rect width=\"" + coordinate(width) + "\" height=\"" + coordinate(depth) +
          "\" class=\"bed\"/>\n";
  std::string names;
  for (const PlacedPart& placed : plate.parts) {
    const KitPart& part = kit.parts[placed.part];
    const Eigen::Rotation2Dd turn(placed.turn);
    text += "<path d=\"";
    for (const std::vector<Vector2d>& line : topLines(*part.solid)) {
      for (std::size_t i = 0; i < line.size(); ++i) {
        const Vector2d p = placed.at + turn * line[i];
        text += (i == 0 ? "M" : "L") + coordinate(p.x()) + ' ' + coordinate(depth - p.y());
      }
    }
    text += "\"/>\n";
    const Eigen::AlignedBox3d box = boundsOf(*part.solid);
    const Vector2d middle = placed.at + turn * Vector2d(box.center().head<2>());
    names += "<text x=\"" + coordinate(middle.x()) + "\" y=\"" + coordinate(depth - middle.y()) + "\">" +
             escapedXml(part.name) + "</text>\n";
  }
  return text + names + "</svg>\n";
}

constexpr std::string_view kStyle =
    R"css(body{font:16px/1.45 sans-serif;max-width:60rem;margin:1rem auto;padding:0 1rem}
table{border-collapse:collapse}td,th{border:1px solid #bbb;padding:.15rem .5rem;text-align:left}
svg{width:100%;max-width:44rem;border:1px solid #bbb}svg path{fill:none;stroke:#246;stroke-width:.25}
svg .bed{fill:#fafafa}svg text{font-size:3px;text-anchor:middle;fill:#a30})css";

MeshScene sceneOf(const std::string& name, const Mechanism& mechanism,
                  const std::function<Float3(int number)>& colourOfLink) {
  MeshScene scene;
  scene.name = name;
  scene.unit = "mm";
  for (const LinkOrdinal link : mechanism.links.ordinals())
    scene.materials.push_back({linkName(mechanism, link), colourOfLink(mechanism.colorNumber(link))});
  return scene;
}

}  // namespace

std::vector<std::vector<Vector2d>> topLines(const Solid& solid) {
  constexpr double kUp = 0.3;
  constexpr double kShort = 0.15;  // mm: shorter steps of a line are left out
  using Point = std::pair<float, float>;
  std::map<Point, std::vector<Point>> after;
  std::set<std::pair<std::pair<Point, float>, std::pair<Point, float>>> edges;
  const auto key = [](const Float3& p) { return std::pair(Point(p[0], p[1]), p[2]); };
  for (const Triangle& t : solid.triangles) {
    if (solid.normals[t[0]][2] < kUp) continue;
    for (std::size_t k = 0; k < 3; ++k)
      edges.insert({key(solid.positions[t[k]]), key(solid.positions[t[(k + 1) % 3]])});
  }
  for (const auto& [from, to] : edges) {
    if (!edges.contains({to, from}) && from.first != to.first) after[from.first].push_back(to.first);
  }
  std::vector<std::vector<Vector2d>> lines;
  for (auto& [start, next] : after) {
    while (!next.empty()) {
      std::vector<Vector2d> line{{start.first, start.second}};
      for (Point at = start; !after[at].empty();) {
        const Point to = after[at].back();
        after[at].pop_back();
        const Vector2d p(to.first, to.second);
        if ((p - line.back()).norm() > kShort || after[to].empty()) line.push_back(p);
        at = to;
      }
      if (line.size() > 1) lines.push_back(std::move(line));
    }
  }
  return lines;
}

std::string kitPage(const PrintKit& kit, const Mechanism& mechanism, const GearTrain& train) {
  const std::string name = mechanism.name.empty() ? translated("Print kit") : mechanism.name;
  const std::string title = escapedXml(translated("Print kit: %1", {name}));
  std::string page = "<!DOCTYPE html>\n<html lang=\"" + escapedXml(translated(toTranslate("en"))) +
                     "\">\n<head>\n<meta charset=\"utf-8\">\n<meta http-equiv=\"Content-Security-Policy\" "
                     "content=\"default-src 'none'; style-src 'unsafe-inline'\">\n<title>" +
                     title +
                     "</title>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                     "<style>" +
                     std::string(kStyle) + "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n";
  page += "<p>" +
          escapedXml(translated(
              "Play %1 mm on each flank, bores %2 mm wider than their shafts, first layers narrower "
              "by %3 mm, scale %4. Lengths are in mm.",
              {lengthText(kit.options.play), lengthText(kit.options.bore), lengthText(kit.options.chamfer),
               readableNumber(kit.options.scale)})) +
          "</p>\n";
  for (const std::string& note : kit.notes) page += "<p>" + escapedXml(note) + "</p>\n";
  page += partsSection(kit, mechanism) + boughtSection(kit) + stepsSection(kit) +
          marksSection(kit, mechanism, train);
  for (std::size_t plate = 0; plate < kit.plates.size(); ++plate) page += plateSection(kit, plate);
  return page + "</body>\n</html>\n";
}

std::variant<std::vector<std::pair<std::string, std::string>>, MeshFileError> kitFiles(
    const PrintKit& kit, const Mechanism& mechanism, const GearTrain& train,
    const std::function<Float3(int number)>& colourOfLink, const std::stop_token& stop) {
  std::vector<std::pair<std::string, std::string>> files;
  MeshWriteOptions options;
  options.stop = stop;
  const auto write = [&](const MeshScene& scene, const std::string& stem) -> std::optional<MeshFileError> {
    auto encoded = encodedMesh(scene, MeshFormat::threeMf, stem, options);
    if (auto* const error = std::get_if<MeshFileError>(&encoded)) return std::move(*error);
    for (EncodedFile& file : std::get<std::vector<EncodedFile>>(encoded))
      files.emplace_back(std::move(file.name), std::move(file.bytes));
    return std::nullopt;
  };
  for (std::size_t p = 0; p < kit.plates.size(); ++p) {
    const std::string stem = "plate-" + std::to_string(p + 1);
    MeshScene scene = sceneOf(stem, mechanism, colourOfLink);
    for (const PlacedPart& placed : kit.plates[p].parts) {
      const KitPart& part = kit.parts[placed.part];
      Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
      pose.translation() = Vector3d(placed.at.x(), placed.at.y(), 0);
      pose.rotate(Eigen::AngleAxisd(placed.turn, Vector3d::UnitZ()));
      scene.nodes.push_back(
          {part.name, kNoNode, pose, part.solid, static_cast<std::size_t>(int{part.link}), {}});
    }
    if (auto error = write(scene, stem)) return *std::move(error);
  }
  MeshScene scene = sceneOf("assembly", mechanism, colourOfLink);
  for (const KitPart& part : kit.parts)
    scene.nodes.push_back(
        {part.name, kNoNode, part.pose, part.solid, static_cast<std::size_t>(int{part.link}), {}});
  if (auto error = write(scene, "assembly")) return *std::move(error);
  files.emplace_back("assembly.html", kitPage(kit, mechanism, train));
  return files;
}

}  // namespace geargraph
