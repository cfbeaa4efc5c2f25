#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/foundations/base/translation.h"
#include "core/machine/solids/part_solids.h"
#include "core/machine/solids/wheel_form.h"
#include "core/machine/teeth/sampling.h"
#include "core/machine/teeth/worm.h"

// A worm. Its surface is made of sections through its axis, in which a thread needs few points, instead of
// sections square to it, in which one thread goes all the way round.

namespace geargraph {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
using Vertex = std::uint32_t;

/// Meridians are not nearer to each other than this, rad: rounded to floats their vertices could coincide.
constexpr double kNearestMeridians = 1e-4;

/// The axial section of one thread: points from its lower root to its upper root, and the stretches between
/// neighbours, the last of which goes on to the next thread. Lengths in the unit of the spec.
struct Thread {
  struct Stretch {
    Eigen::Vector2d lower, upper;  ///< the normals (radial, along) at its ends
  };
  std::vector<Eigen::Vector2d> points;  ///< (radius, along)
  std::vector<Stretch> stretches;       ///< from each point to the next
  std::vector<char> isBend;             ///< all but those on straight flanks

  Thread(const GearSpec& spec, double tolerance, int flankRows);
};

Thread::Thread(const GearSpec& spec, double tolerance, int flankRows) {
  const double module = axialModule(spec);
  std::vector<ThreadPoint> half = threadProfile(spec, tolerance);
  const ThreadPoint form = half[half.size() - 2], tip = half.back();
  half.pop_back();
  const std::size_t fillets = half.size() - 1;
  for (int i = 1; i <= flankRows; ++i) {
    ThreadPoint p = tip;
    p.rad = form.rad + (tip.rad - form.rad) * i / flankRows;
    p.along = form.along + (tip.along - form.along) * i / flankRows;
    half.push_back(p);
  }
  const auto n = half.size();
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const bool lower = i < n;
    const ThreadPoint& p = half[lower ? i : 2 * n - 1 - i];
    points.emplace_back(p.rad * module, (lower ? -p.along : p.along) * module);
    const std::size_t at = lower ? i : 2 * n - 1 - i;
    isBend.push_back(at <= fillets || at + 1 == n);
  }
  const auto normal = [&](std::size_t i) {
    const ThreadPoint& p = half[i < n ? i : 2 * n - 1 - i];
    return Eigen::Vector2d(p.normalRad, i < n ? -p.normalAlong : p.normalAlong);
  };
  const Eigen::Vector2d outward(1, 0);
  for (std::size_t i = 0; i + 1 < 2 * n; ++i) {
    if (i + 1 == n) {
      stretches.push_back({outward, outward});  // the land
    } else {
      stretches.push_back({normal(i), normal(i + 1)});
    }
  }
  stretches.push_back({outward, outward});  // the root
}

/// The worm between its end planes. Thread points are numbered along the axis through all threads; a turn
/// later, each has the number of the one that was a lead further.
class WormShell {
 public:
  WormShell(const GearSpec& spec, double tolerance);
  Solid take() { return std::move(m_solid); }

 private:
  /// What a strip between two meridians passes: a point, or a place of the stretch above it at an end plane.
  struct Node {
    int stretch = 0;  ///< an end plane: the stretch that it cuts
    int point = 0;
    int end = 0;  ///< -1, 1: at the lower, upper end plane; 0: at the point
  };
  /// Where a meridian ends in an end plane, with the normal (radial, along) there.
  struct End {
    double radius = 0;
    Eigen::Vector2d normal;
  };
  struct Place {
    double radius = 0;
    double height = 0;
    double part = 0;           ///< of the stretch that the end plane cuts
    const End* met = nullptr;  ///< where it lies in an end plane
  };

  [[nodiscard]] int size() const { return static_cast<int>(m_thread.points.size()); }
  [[nodiscard]] static int quotient(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }
  [[nodiscard]] std::size_t local(int number) const {
    return static_cast<std::size_t>(number - quotient(number, size()) * size());
  }
  [[nodiscard]] double heightAt0(int number) const {
    return m_thread.points[local(number)].y() + m_pitch * quotient(number, size());
  }
  /// The number at meridian 0 of what has the number at the last meridian, which is the same one.
  void wrap(int& meridian, int& number) const {
    if (meridian < static_cast<int>(m_angles.size())) return;
    meridian -= static_cast<int>(m_angles.size());
    number += m_hand * m_starts * size();
  }
  /// An angle in [0, 2 pi), or a little less than 0, and the turns that it is away.
  struct Passing {
    double angle = 0;
    double turns = 0;
  };
  [[nodiscard]] Passing exactPassing(int number, int end) const;
  void moveToMeridian(Passing& passing) const;
  [[nodiscard]] double crossing(int number, int end) const;
  void findMeridians(double tolerance);
  [[nodiscard]] End endOf(std::size_t meridian, int end) const;
  [[nodiscard]] Place placeOf(int meridian, const Node& node) const;
  Vertex add(int meridian, const Place& place, const Eigen::Vector2d& normal);
  Vertex vertexOf(int meridian, const Node& node, int stretch, bool lower);
  void addStrip(int meridian);
  void addQuad(int meridian, const Node& below, const Node& above, int stretch);
  void addEnds();

  Thread m_thread;
  int m_starts, m_hand;
  double m_pitch;                   ///< axial
  double m_advance;                 ///< of the thread for 1 rad, positive
  double m_half;                    ///< of the length
  double m_bore;                    ///< radius
  std::vector<Passing> m_passings;  ///< by point of the first turn and end: the angles of their meridians
  std::vector<double> m_angles;     ///< of the meridians, in [0, 2 pi)
  struct Known {
    int number = 0;
    bool lower = false;
    Vertex vertex = 0;
  };
  std::vector<std::vector<Known>> m_known;  ///< by meridian: the vertices of points
  std::vector<std::array<End, 2>> m_ends;   ///< by meridian
  Solid m_solid;
};

int rowsOfFlank(const GearSpec& spec, double tolerance) {
  // Two triangles of the flank between meridians leave the helicoid by advance * step * rise / (2 (r + R)).
  const double module = axialModule(spec);
  const double tip = nominalTipRadius(spec) / module, root = nominalRootRadius(spec) / module;
  const double step = 2 * std::acos(1 - std::min(tolerance / tip, 1.0));
  const double advance = spec.teeth / 2.0, middle = 0.5 * (tip + root);
  const double off = advance * step * (tip - root) / (4 * middle) / std::hypot(1, advance / middle);
  return std::max(1, static_cast<int>(std::ceil(off / (tolerance * kFlankShare))));
}

WormShell::WormShell(const GearSpec& spec, double tolerance)
    : m_thread(spec, tolerance, rowsOfFlank(spec, tolerance)),
      m_starts(spec.teeth),
      m_hand(spec.helixAngle < 0 ? -1 : 1),
      m_pitch(pi * axialModule(spec)),
      m_advance(leadOf(spec) / (2 * pi)),
      m_half(spec.faceWidth / 2),
      m_bore(spec.bore / 2) {
  findMeridians(tolerance * axialModule(spec));
  m_known.resize(m_angles.size());
  for (std::size_t i = 0; i < m_angles.size(); ++i) m_ends.push_back({endOf(i, -1), endOf(i, 1)});
  for (std::size_t i = 0; i < m_angles.size(); ++i) addStrip(static_cast<int>(i));
  addEnds();
}

/// Where a point of the first turn passes an end plane.
WormShell::Passing WormShell::exactPassing(int number, int end) const {
  const double exact = m_hand * (end * m_half - heightAt0(number)) / m_advance;
  const double turns = std::floor((exact + kNearestMeridians) / (2 * pi));
  return {exact - 2 * pi * turns, turns};
}

/// The angle of the meridian that is put where the point passes the end plane; it may lie turns away.
double WormShell::crossing(int number, int end) const {
  const int turn = m_starts * size(), turns = quotient(number, turn);
  const Passing& first = m_passings[2 * static_cast<std::size_t>(number - turns * turn) + (end > 0 ? 1 : 0)];
  return first.angle + 2 * pi * (first.turns - m_hand * turns);
}

/// Meridians where a bend of a thread passes an end plane, and as many others as the tolerance wants.
void WormShell::findMeridians(double tolerance) {
  std::vector<double> exact{0};
  for (int number = 0; number < m_starts * size(); ++number) {
    for (const int end : {-1, 1}) {
      m_passings.push_back(exactPassing(number, end));
      if (m_thread.isBend[local(number)]) exact.push_back(m_passings.back().angle);
    }
  }
  std::sort(exact.begin(), exact.end());
  std::vector<double> merged{0};
  for (const double angle : exact) {
    if (angle - merged.back() > kNearestMeridians) merged.push_back(angle);
  }
  double reach = 0;
  for (const Eigen::Vector2d& p : m_thread.points) reach = std::max(reach, p.x());
  const double step = 2 * pi / circleCount(reach, tolerance);
  for (std::size_t i = 0; i < merged.size(); ++i) {
    const double from = merged[i];
    const double to = i + 1 < merged.size() ? merged[i + 1] : 2 * pi;
    const int parts = std::max(1, static_cast<int>(std::ceil((to - from) / step - 1e-9)));
    for (int k = 0; k < parts; ++k) m_angles.push_back(from + (to - from) * k / parts);
  }
  for (Passing& passing : m_passings) moveToMeridian(passing);
}

/// Where the meridian leaves the thread at an end plane.
WormShell::End WormShell::endOf(std::size_t meridian, int end) const {
  const double along = end * m_half - m_hand * m_advance * m_angles[meridian];  // at meridian 0
  int number = static_cast<int>(std::floor(along / m_pitch)) * size();
  while (heightAt0(number) > along) --number;
  while (heightAt0(number + 1) <= along) ++number;
  const double part = (along - heightAt0(number)) / (heightAt0(number + 1) - heightAt0(number));
  const Thread::Stretch& stretch = m_thread.stretches[local(number)];
  return {(1 - part) * m_thread.points[local(number)].x() + part * m_thread.points[local(number + 1)].x(),
          (1 - part) * stretch.lower + part * stretch.upper};
}

/// Lets a point pass at the nearest meridian. It slides along its thread by that, and stays on it.
void WormShell::moveToMeridian(Passing& passing) const {
  const auto after = std::upper_bound(m_angles.begin() + 1, m_angles.end(), passing.angle);
  const double before = *std::prev(after), next = after == m_angles.end() ? 2 * pi : *after;
  if (passing.angle - before <= next - passing.angle) {
    passing.angle = before;
  } else if (after != m_angles.end()) {
    passing.angle = next;
  } else {
    passing.angle = 0;
    ++passing.turns;
  }
}

WormShell::Place WormShell::placeOf(int meridian, const Node& node) const {
  int at = meridian, number = node.end == 0 ? node.point : node.stretch;
  wrap(at, number);
  const auto i = static_cast<std::size_t>(at);
  const double angle = m_angles[i];
  const auto height = [&](int point) { return heightAt0(point) + m_hand * m_advance * angle; };
  const auto inEnd = [&](int end, double part) {
    const End& met = m_ends[i][end > 0 ? 1 : 0];
    return Place{met.radius, end * m_half, std::clamp(part, 0.0, 1.0), &met};
  };
  if (node.end != 0)
    return inEnd(node.end, (node.end * m_half - height(number)) / (height(number + 1) - height(number)));
  for (const int end : {-1, 1}) {
    if (crossing(number, end) == angle) return inEnd(end, 0);
  }
  return {m_thread.points[local(number)].x(), height(number), 0, nullptr};
}

Vertex WormShell::add(int meridian, const Place& place, const Eigen::Vector2d& normal) {
  const double angle = m_angles[static_cast<std::size_t>(meridian) % m_angles.size()];
  const double c = std::cos(angle), s = std::sin(angle);
  const double round = -m_hand * m_advance * normal.y() / place.radius;
  const Vector3d position(place.radius * c, place.radius * s, place.height);
  const Vector3d direction(normal.x() * c - round * s, normal.x() * s + round * c, normal.y());
  return ShellBuilder(m_solid).addVertex(position, direction.normalized());
}

/// The vertex of a strip at its lower or upper meridian, as the lower or upper end of a stretch.
Vertex WormShell::vertexOf(int meridian, const Node& node, int stretch, bool lower) {
  const Place place = placeOf(meridian, node);
  const Thread::Stretch& along = m_thread.stretches[local(stretch)];
  const Eigen::Vector2d own = node.end != 0 ? (1 - place.part) * along.lower + place.part * along.upper
                              : lower       ? along.lower
                                            : along.upper;
  const bool slid = place.met != nullptr && place.met->normal.dot(own) > 0.9;  // and not over an edge
  const Eigen::Vector2d normal = slid ? place.met->normal : own;
  if (node.end != 0) return add(meridian, place, normal);
  const std::size_t before = local(node.point - 1), after = local(node.point);
  const bool edge = (m_thread.stretches[before].upper - m_thread.stretches[after].lower).norm() > 1e-9;
  int at = meridian, number = node.point;
  wrap(at, number);
  std::vector<Known>& known = m_known[static_cast<std::size_t>(at)];  // in the order of their numbers
  auto found = std::lower_bound(known.begin(), known.end(), number,
                                [](const Known& k, int wanted) { return k.number < wanted; });
  for (; found != known.end() && found->number == number; ++found) {
    if (found->lower == lower || !edge) return found->vertex;
  }
  return known.insert(found, {number, lower, add(meridian, place, normal)})->vertex;
}

void WormShell::addQuad(int meridian, const Node& below, const Node& above, int stretch) {
  const auto heightOf = [&](int at, const Node& node) { return placeOf(at, node).height; };
  const bool meetHere = heightOf(meridian, below) == heightOf(meridian, above);
  const bool meetNext = heightOf(meridian + 1, below) == heightOf(meridian + 1, above);
  const Vertex a = vertexOf(meridian, below, stretch, true);
  const Vertex b = vertexOf(meridian + 1, below, stretch, true);
  const Vertex c = meetNext ? b : vertexOf(meridian + 1, above, stretch, false);
  const Vertex d = meetHere ? a : vertexOf(meridian, above, stretch, false);
  if (!meetNext) m_solid.triangles.push_back({a, b, c});
  if (!meetHere) m_solid.triangles.push_back({a, c, d});
}

/// The surface between a meridian and the next one: from the lower end plane through all points to the upper.
void WormShell::addStrip(int meridian) {
  const auto i = static_cast<std::size_t>(meridian);
  const double next = i + 1 < m_angles.size() ? m_angles[i + 1] : 2 * pi;
  const double middle = 0.5 * (m_angles[i] + next);
  const auto isAbove = [&](int number, int end) { return m_hand * (middle - crossing(number, end)) > 0; };
  int first = 0;
  while (isAbove(first, -1)) --first;
  while (!isAbove(first, -1)) ++first;  // the first point over the lower end plane
  int last = first;
  while (!isAbove(last, 1)) ++last;  // the first one over the upper end plane
  Node below{first - 1, 0, -1};
  for (int number = first; number <= last; ++number) {
    const Node above = number < last ? Node{0, number, 0} : Node{number - 1, 0, 1};
    addQuad(meridian, below, above, number - 1);
    below = above;
  }
}

/// Faces of both ends, star-shaped about the axis, and the bore, all of the same meridians.
void WormShell::addEnds() {
  const auto count = static_cast<Vertex>(m_angles.size());
  ShellBuilder builder(m_solid);
  const auto ring = [&](int end, double radius, const Vector3d& normal, bool inward) {
    const auto start = static_cast<Vertex>(m_solid.positions.size());
    for (std::size_t i = 0; i < m_angles.size(); ++i) {
      const double r = radius > 0 ? radius : m_ends[i][end > 0 ? 1 : 0].radius;
      const double c = std::cos(m_angles[i]), s = std::sin(m_angles[i]);
      builder.addVertex({r * c, r * s, end * m_half}, inward ? Vector3d(-c, -s, 0) : normal);
    }
    return start;
  };
  const auto join = [&](Vertex outer, Vertex inner) {  // counter-clockwise seen from outside: upper face
    for (Vertex i = 0; i < count; ++i) {
      const Vertex next = i + 1 == count ? 0 : i + 1;
      builder.addTriangle(outer + i, outer + next, inner + i);
      builder.addTriangle(outer + next, inner + next, inner + i);
    }
  };
  std::array<Vertex, 2> bores{};
  for (const int end : {-1, 1}) {
    const Vector3d normal(0, 0, end);
    const Vertex outer = ring(end, 0, normal, false);
    if (m_bore > 0) {
      const Vertex inner = ring(end, m_bore, normal, false);
      end > 0 ? join(outer, inner) : join(inner, outer);
      bores[end > 0 ? 1 : 0] = ring(end, m_bore, normal, true);
      continue;
    }
    const Vertex pole = builder.addVertex({0, 0, end * m_half}, normal);
    for (Vertex i = 0; i < count; ++i) {
      const Vertex next = i + 1 == count ? 0 : i + 1;
      end > 0 ? builder.addTriangle(pole, outer + i, outer + next)
              : builder.addTriangle(pole, outer + next, outer + i);
    }
  }
  if (m_bore > 0) join(bores[1], bores[0]);
}

Solid wormSolid(const GearSpec& spec, double tolerance) {
  return WormShell(spec, tolerance).take();
}

std::vector<ProfileVertex> wormBody(const GearSpec& spec) {
  return discProfile(spec.bore, spec.faceWidth);
}

std::optional<WebWindows> noWormWindows(const GearSpec& /*spec*/) {
  return std::nullopt;
}

double largestWormBore(const GearSpec& spec) {
  return 2 * (nominalRootRadius(spec) - 0.5 * axialModule(spec));
}

std::string tooFewStarts(const GearSpec& /*spec*/, int /*fewest*/) {
  return translated("A worm has one start or more.");
}

void checkWorm(const GearSpec& spec, Diagnostics& found) {
  const std::string starts = std::to_string(spec.teeth);
  if (spec.teeth > kMaxWormStarts) {
    found.push_back(specRejection(translated(
        "%1 starts are too many for a worm; use at most %2, or a pair of helical gears on crossed axes.",
        {starts, std::to_string(kMaxWormStarts)})));
    return;
  }
  const double lead = leadAngle(spec);
  if (!(lead > 0.005 && lead < 1.25) || spec.herringbone || spec.profileShift != 0) {
    found.push_back(specRejection(translated(
        "A worm of %1 starts needs a lead angle between 0.3 and 70 degrees, and no profile shift: its "
        "wheel has it.",
        {starts})));
    return;
  }
  const double module = axialModule(spec);
  const double root = nominalRootRadius(spec);
  if (root < 0.5 * module) {
    found.push_back(specRejection(translated(
        "A worm of %1 starts and a pitch diameter of %2 leaves no body below its threads: make it "
        "larger than %3.",
        {starts, oneDecimal(2 * pitchRadius(spec)), oneDecimal(2 * (pitchRadius(spec) - root) + module)})));
    return;
  }
  const double tipWidth =
      pi / 2 - spec.backlashAllowance - 2 * spec.addendum * std::tan(spec.pressureAngle);  // in axial modules
  if (tipWidth < 0.05) {
    found.push_back(specRejection(translated(
        "The threads of a worm of %1 starts would be pointed; use a smaller pressure angle or less height.",
        {starts})));
  }
}

void checkWormBore(const GearSpec& spec, Diagnostics& found) {
  if (spec.bore <= largestWormBore(spec)) return;
  found.push_back(specRejection(
      translated("The bore of %1 leaves no body below the threads of the worm: make it smaller than %2.",
                 {oneDecimal(spec.bore), oneDecimal(largestWormBore(spec))})));
}

}  // namespace

constexpr WheelForm kWormForm{.body = wormBody,
                              .windows = noWormWindows,
                              .outline = discOutline,
                              .span = discSpan,
                              .largestBore = largestWormBore,
                              .solid = wormSolid,
                              .toothless = toothlessDisc,
                              .steepest = pi / 2,
                              .check = checkWorm,
                              .checkBody = checkWormBore,
                              .tooFewTeeth = tooFewStarts};

}  // namespace geargraph
