#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/foundations/base/translation.h"
#include "core/machine/solids/part_solids.h"
#include "core/machine/solids/wheel_form.h"
#include "core/machine/teeth/half_tooth.h"
#include "core/machine/teeth/sampling.h"
#include "core/machine/teeth/worm.h"
#include "core/machine/teeth/worm_cut.h"

// The wheel of a worm: throated, with the teeth that the worm leaves (WormCut) in sections square to its
// axis.

namespace geargraph {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
using Place = std::uint32_t;

/// Vertices of a part of the surface, by section and along the section.
struct Patch {
  std::size_t width = 0;
  std::vector<Place> places;

  [[nodiscard]] Place at(std::size_t section, std::size_t i) const { return places[section * width + i]; }
};

/// One tooth with the root after it, which every tooth repeats turned. Its outline in a section begins at the
/// root on the side of smaller angles and goes over the tip to the next tooth.
class WormWheelTooth {
 public:
  WormWheelTooth(const GearSpec& spec, double tolerance);

  struct Seed {
    Vector3d position;
    Vector3d normal;
  };
  /// What the body is sewn to: the places of one face, with their angles.
  struct Base {
    std::array<Place, 2> places;
    std::array<double, 2> angles;
  };
  std::vector<Seed> seeds;
  std::vector<std::array<Place, 3>> triangles;  ///< places from seeds.size() on are those of the next tooth
  Base bottom, top;

 private:
  /// Points of a section: of the flanks, the lower one from the root and the upper one to it, and the land.
  struct Row {
    std::vector<Seed> low, land, high;
    std::vector<Seed> rim;  ///< the land where it is on the cylinder beside the throat
    std::array<double, 2> rootAngles{};
  };

  /// The flank of the space on the side of growing angles, from root to tip.
  struct Section {
    WormCut::Circle root, tip;
    std::vector<double> radii;
    std::vector<WormCut::FlankPoint> flank;
  };

  void chooseHeights(const GearSpec& spec);
  void chooseRows(const GearSpec& spec, double tolerance);
  [[nodiscard]] Section sectionAt(double height) const;
  [[nodiscard]] Row rowOf(std::size_t section) const;
  Patch addPatch(std::size_t from, std::size_t to, std::vector<Seed> Row::*part);
  void join(const Patch& patch);
  void addQuad(Place a, Place b, Place c, Place d);
  Base addFace(const Row& row, double upward);

  WormCut m_cut;
  int m_teeth;
  double m_tolerance;             ///< a length
  std::vector<double> m_heights;  ///< of the sections, ascending, symmetrical
  std::vector<std::size_t>
      m_edges;                   ///< sections between which the tips are smooth: the ends, and of the throat
  std::vector<double> m_shares;  ///< of the rows of a flank, from its root (0) to its tip (1)
  int m_landChords = 1;
  std::vector<Section> m_sections;
  std::vector<Row> m_rows;
};

WormWheelTooth::WormWheelTooth(const GearSpec& spec, double tolerance)
    : m_cut(spec), m_teeth(spec.teeth), m_tolerance(tolerance * spec.module) {
  chooseHeights(spec);
  chooseRows(spec, tolerance);
  for (const double height : m_heights) m_sections.push_back(sectionAt(height));
  for (std::size_t i = 0; i < m_heights.size(); ++i) m_rows.push_back(rowOf(i));
  const std::size_t last = m_heights.size() - 1;
  const Patch low = addPatch(0, last, &Row::low), high = addPatch(0, last, &Row::high);
  join(low);
  join(high);
  for (std::size_t e = 0; e + 1 < m_edges.size(); ++e) {
    const bool isRim = m_edges.size() > 2 && e != 1;
    const Patch land = addPatch(m_edges[e], m_edges[e + 1], isRim ? &Row::rim : &Row::land);
    join(land);
  }
  bottom = addFace(m_rows.front(), -1);
  top = addFace(m_rows.back(), 1);
  const auto next = static_cast<Place>(seeds.size());
  for (std::size_t i = 0; i < last; ++i) {  // the root is as smooth as the fillets it lies between
    addQuad(high.at(i, high.width - 1), next + low.at(i, 0), next + low.at(i + 1, 0),
            high.at(i + 1, high.width - 1));
  }
}

/// As near to each other as the bend of the flanks along the axis wants, and at the ends of the throat.
void WormWheelTooth::chooseHeights(const GearSpec& spec) {
  const double half = spec.faceWidth / 2;
  const double step = std::sqrt(8 * m_tolerance * kFlankShare / m_cut.bend());
  const auto parts = [&](double from, double to) {
    return std::max(1, static_cast<int>(std::ceil((to - from) / step)));
  };
  std::vector<double> above;  // mid face
  const double end = m_cut.throatEnd();
  const int inThroat = parts(0, end);
  for (int i = 1; i <= inThroat; ++i) above.push_back(end * i / inThroat);
  const auto edge = above.size();
  if (half - end > 0.01 * spec.module) {
    const int beside = parts(end, half);
    for (int i = 1; i <= beside; ++i) above.push_back(end + (half - end) * i / beside);
  } else {
    above.back() = half;
  }
  for (std::size_t i = above.size(); i-- > 0;) m_heights.push_back(-above[i]);
  m_heights.push_back(0);
  m_heights.insert(m_heights.end(), above.begin(), above.end());
  const std::size_t middle = above.size();
  m_edges = {0};
  if (edge < above.size()) {
    m_edges.push_back(middle - edge);
    m_edges.push_back(middle + edge);
  }
  m_edges.push_back(m_heights.size() - 1);
}

/// The rows of the mid section, which is that of an ordinary gear, serve all sections.
void WormWheelTooth::chooseRows(const GearSpec& spec, double tolerance) {
  const HalfTooth tooth = externalTooth(spec, tolerance * kFlankShare);
  m_shares = {0};
  for (const ProfilePoint& p : tooth.points) {
    const double share = (p.rad - tooth.rootRad) / (tooth.tipRad - tooth.rootRad);
    if (share > m_shares.back() + 1e-4 && share < 1 - 1e-4) m_shares.push_back(share);
  }
  m_shares.push_back(1);
  const double space = m_cut.flank(m_cut.tip(0).radius, 0).angle;
  m_landChords = chordsOfArc(2 * (pi / spec.teeth - space), m_cut.tip(0).radius, m_tolerance);
}

WormWheelTooth::Section WormWheelTooth::sectionAt(double height) const {
  Section section{m_cut.root(height), m_cut.tip(height), {}, {}};
  const double root = section.root.radius, tip = section.tip.radius;
  for (const double share : m_shares) {
    section.radii.push_back(share == 1 ? tip : root + share * (tip - root));
    section.flank.push_back(m_cut.flank(section.radii.back(), height));
  }
  return section;
}

/// The lower flank of the tooth is that of the space below it, the upper one that of the section on the other
/// side of mid face, mirrored.
WormWheelTooth::Row WormWheelTooth::rowOf(std::size_t place) const {
  Row row;
  const double half = pi / m_teeth, height = m_heights[place];
  const Section& section = m_sections[place];
  const Section& opposite = m_sections[m_sections.size() - 1 - place];
  const auto seed = [&](double radius, double angle, const Vector3d& normal) {
    const double c = std::cos(angle), s = std::sin(angle);
    const Vector3d turned(normal.x() * c - normal.y() * s, normal.x() * s + normal.y() * c, normal.z());
    return Seed{{radius * c, radius * s, height}, turned.normalized()};
  };
  const Vector3d rootNormal(1, 0, -section.root.perHeight), tipNormal(1, 0, -section.tip.perHeight);
  std::array<double, 2> angles{};
  for (std::size_t i = 0; i < m_shares.size(); ++i) {
    const double radius = section.radii[i];
    const WormCut::FlankPoint& low = section.flank[i];
    const WormCut::FlankPoint& high = opposite.flank[i];
    angles = {low.angle - half, half - high.angle};
    if (i == 0) row.rootAngles = angles;
    row.low.push_back(
        seed(radius, angles[0], i == 0 ? rootNormal : Vector3d(low.perRadius, -1 / radius, low.perHeight)));
    row.high.push_back(
        seed(radius, angles[1], i == 0 ? rootNormal : Vector3d(high.perRadius, 1 / radius, -high.perHeight)));
  }
  for (int i = 0; i <= m_landChords; ++i) {
    const double angle = angles[0] + (angles[1] - angles[0]) * i / m_landChords;
    row.land.push_back(seed(section.tip.radius, angle, tipNormal));
    row.rim.push_back(seed(section.tip.radius, angle, {1, 0, 0}));
  }
  std::reverse(row.high.begin(), row.high.end());
  for (std::vector<Seed>* const land : {&row.land, &row.rim}) {
    land->front().position = row.low.back().position;
    land->back().position = row.high.front().position;
  }
  return row;
}

/// Adds the vertices of one part of the outline from a section to another.
Patch WormWheelTooth::addPatch(std::size_t from, std::size_t to, std::vector<Seed> Row::*part) {
  Patch patch;
  patch.width = (m_rows[from].*part).size();
  for (std::size_t section = from; section <= to; ++section) {
    for (const Seed& s : m_rows[section].*part) {
      patch.places.push_back(static_cast<Place>(seeds.size()));
      seeds.push_back(s);
    }
  }
  return patch;
}

void WormWheelTooth::addQuad(Place a, Place b, Place c, Place d) {
  triangles.push_back({a, b, c});
  triangles.push_back({a, c, d});
}

/// Two triangles between neighbours, by the shorter diagonal.
void WormWheelTooth::join(const Patch& patch) {
  const std::size_t sections = patch.places.size() / patch.width;
  const auto apart = [&](Place p, Place q) { return (seeds[p].position - seeds[q].position).squaredNorm(); };
  for (std::size_t section = 0; section + 1 < sections; ++section) {
    for (std::size_t i = 0; i + 1 < patch.width; ++i) {
      const Place a = patch.at(section, i), b = patch.at(section, i + 1);
      const Place c = patch.at(section + 1, i + 1), d = patch.at(section + 1, i);
      apart(a, c) <= apart(b, d) ? addQuad(a, b, c, d) : addQuad(b, c, d, a);
    }
  }
}

/// The end of the tooth: strips between the points of both flanks at equal radii, which never cross however
/// the flanks lean, and the land.
WormWheelTooth::Base WormWheelTooth::addFace(const Row& row, double upward) {
  const auto add = [&](const Seed& seed) {
    seeds.push_back({seed.position, {0, 0, upward}});
    return static_cast<Place>(seeds.size() - 1);
  };
  const auto addTriangle = [&](Place a, Place b, Place c) {
    upward > 0 ? triangles.push_back({a, b, c}) : triangles.push_back({a, c, b});
  };
  const std::size_t last = row.low.size() - 1;
  std::vector<Place> low, high;
  for (std::size_t i = 0; i <= last; ++i) {
    low.push_back(add(row.low[i]));
    high.push_back(add(row.high[last - i]));
  }
  for (std::size_t i = 0; i < last; ++i) {
    addTriangle(low[i], low[i + 1], high[i + 1]);
    addTriangle(low[i], high[i + 1], high[i]);
  }
  Place before = low[last];
  for (std::size_t i = 1; i + 1 < row.land.size(); ++i) {
    const Place here = add(row.land[i]);
    addTriangle(before, here, high[last]);
    before = here;
  }
  return {{low[0], high[0]}, row.rootAngles};
}

/// Adds all teeth, each turned by its own angle.
void repeatTooth(const WormWheelTooth& tooth, int teeth, Solid& solid) {
  const std::size_t each = tooth.seeds.size(), count = each * static_cast<std::size_t>(teeth);
  solid.positions.reserve(count);
  solid.normals.reserve(count);
  solid.triangles.reserve(tooth.triangles.size() * static_cast<std::size_t>(teeth));
  for (int k = 0; k < teeth; ++k) {
    const double angle = 2 * pi * k / teeth, c = std::cos(angle), s = std::sin(angle);
    const auto turned = [&](const Vector3d& v) {
      return Float3{static_cast<float>(c * v.x() - s * v.y()), static_cast<float>(s * v.x() + c * v.y()),
                    static_cast<float>(v.z())};
    };
    for (const WormWheelTooth::Seed& seed : tooth.seeds) {
      solid.positions.push_back(turned(seed.position));
      solid.normals.push_back(turned(seed.normal));
    }
    const std::size_t start = each * static_cast<std::size_t>(k);
    for (const std::array<Place, 3>& t : tooth.triangles) {
      Triangle& triangle = solid.triangles.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) triangle[i] = static_cast<Place>((start + t[i]) % count);
    }
  }
}

Loop baseOfFace(const WormWheelTooth& tooth, bool top, int teeth, double start) {
  const WormWheelTooth::Base& base = top ? tooth.top : tooth.bottom;
  Loop loop;
  for (int k = 0; k < teeth; ++k) {
    for (std::size_t i = 0; i < base.places.size(); ++i) {
      loop.vertices.push_back(static_cast<Place>(tooth.seeds.size()) * static_cast<Place>(k) +
                              base.places[i]);
      loop.angles.push_back(2 * pi * k / teeth + base.angles[i]);
    }
  }
  beginLoopAt(loop, start);
  return loop;
}

Solid wormWheelSolid(const GearSpec& spec, double tolerance) {
  Solid solid;
  const WormWheelTooth tooth(spec, tolerance);
  repeatTooth(tooth, spec.teeth, solid);
  ShellBuilder builder(solid);
  const BodyBelow below{bodyProfile(spec), bodyWindows(spec), tolerance * spec.module};
  const double start = -pi / spec.teeth;
  sewBodyBelow(builder, below, circleCountOf(below), start,
               {baseOfFace(tooth, true, spec.teeth, start), {0, 1}},
               {baseOfFace(tooth, false, spec.teeth, start), {0, -1}});
  return solid;
}

void checkWormWheel(const GearSpec& spec, Diagnostics& found) {
  const std::string teeth = std::to_string(spec.teeth);
  if (spec.mateTeeth < 1 || spec.mateTeeth > kMaxWormStarts || spec.mateTeeth >= spec.teeth) {
    found.push_back(specRejection(translated(
        "A worm wheel of %1 teeth needs a worm of fewer starts, at most %2; a pair of helical gears on "
        "crossed axes may have any numbers of teeth.",
        {teeth, std::to_string(kMaxWormStarts)})));
    return;
  }
  const double thinnest = (std::max(kWormRim, spec.addendum) + 0.5) * spec.module;
  if (!(spec.mateRadius > thinnest)) {
    found.push_back(specRejection(translated(
        "The worm of a wheel of %1 teeth is too thin for its throat: make its pitch diameter larger "
        "than %2.",
        {teeth, oneDecimal(2 * thinnest)})));
    return;
  }
  const double widest = 2 * (spec.mateRadius + spec.addendum * spec.module);
  if (spec.faceWidth > widest) {
    found.push_back(specRejection(translated(
        "A worm wheel of %1 teeth is wider than its worm is thick: make its face width at most %2.",
        {teeth, oneDecimal(widest)})));
    return;
  }
  kDiscForm.check(spec, found);
}

}  // namespace

constexpr WheelForm kWormWheelForm{.body = discBody,
                                   .windows = discWindows,
                                   .outline = discOutline,
                                   .span = discSpan,
                                   .largestBore = largestDiscBore,
                                   .solid = wormWheelSolid,
                                   .toothless = toothlessDisc,
                                   .check = checkWormWheel,
                                   .checkBody = checkBore,
                                   .tooFewTeeth = tooFewForRack};

}  // namespace geargraph
