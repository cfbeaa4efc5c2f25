#include "core/presentation/diagrams/chain_layout.h"
#include "core/presentation/drawing/planar.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>

namespace geargraph {
namespace {

constexpr double kPatternRadius = 100;  ///< sheet units
constexpr double kClearance = 26;       ///< of a line past a link: more than the radius of its disc

using Pattern = std::vector<CanvasPoint>;

Pattern circlePattern(int count, double radius, double turn) {
  Pattern pattern;
  for (int i = 0; i < count; ++i) {
    const double angle = turn + 2 * std::numbers::pi * i / count;
    pattern.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
  }
  return pattern;
}

Pattern joined(Pattern outer, const Pattern& inner) {
  outer.insert(outer.end(), inner.begin(), inner.end());
  return outer;
}

Pattern twoRows(int count) {
  const int above = (count + 1) / 2;
  Pattern pattern;
  for (int i = 0; i < count; ++i) {
    const bool isAbove = i < above;
    const int row = isAbove ? above : count - above;
    const int place = isAbove ? i : i - above;
    pattern.push_back({90.0 * (place - (row - 1) / 2.0), isAbove ? -55.0 : 55.0});
  }
  return pattern;
}

/// Two poles, and a row between them: for links that all mesh with the same two.
Pattern polesAndRow(int count) {
  Pattern pattern{{0, -kPatternRadius}, {0, kPatternRadius}};
  for (int i = 0; i < count - 2; ++i) pattern.push_back({(i % 2 == 0 ? 1 : -1) * (65.0 + 80.0 * (i / 2)), 0});
  return pattern;
}

std::vector<Pattern> patternsOf(int count) {
  std::vector<Pattern> patterns{circlePattern(count, kPatternRadius, 0)};
  if (count > kMaxSearchedLinks) return patterns;
  if (count >= 4) {
    patterns.push_back(joined(circlePattern(count - 1, kPatternRadius, 0), {{0, 0}}));
    patterns.push_back(twoRows(count));
  }
  if (count >= 5) {
    patterns.push_back(joined(circlePattern(count - 2, 1.2 * kPatternRadius, 0), {{-40, 0}, {40, 0}}));
    patterns.push_back(polesAndRow(count));
  }
  if (count >= 6)
    patterns.push_back(joined(circlePattern(3, 1.7 * kPatternRadius, 0),
                              circlePattern(count - 3, 0.55 * kPatternRadius, std::numbers::pi)));
  return patterns;
}

/// Twice the signed area of a triangle.
double areaOf(CanvasPoint a, CanvasPoint b, CanvasPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool doCross(CanvasPoint a, CanvasPoint b, CanvasPoint c, CanvasPoint d) {
  return areaOf(a, b, c) * areaOf(a, b, d) < 0 && areaOf(c, d, a) * areaOf(c, d, b) < 0;
}

/// What is known of each line between two places of a pattern, whatever links are put there.
class PatternLines {
 public:
  explicit PatternLines(const Pattern& pattern) : m_count(static_cast<int>(pattern.size())) {
    for (int a = 0; a < m_count; ++a)
      for (int b = a + 1; b < m_count; ++b) addLine(pattern, a, b);
    for (Line& line : m_lines) {
      for (std::size_t other = 0; other < m_lines.size(); ++other) {
        const Line& with = m_lines[other];
        if (doCross(pattern[line.a], pattern[line.b], pattern[with.a], pattern[with.b]))
          line.crossed |= std::uint64_t{1} << other;
      }
    }
  }

  struct Rating {
    int faults = 0;  ///< crossings, and links that a line passes through
    double length = 0;
    [[nodiscard]] bool operator<(const Rating& other) const {
      // Lengths that are equal but for rounding must not decide: the layout is the same on all machines.
      return faults != other.faults ? faults < other.faults : length < other.length - 1e-6;
    }
  };

  /// @param edges pairs of links; link i is at place at[i]
  [[nodiscard]] Rating rated(const std::vector<std::pair<int, int>>& edges,
                             const std::vector<int>& at) const {
    std::uint64_t used = 0;
    Rating rating;
    for (const auto& [tail, head] : edges) {
      const std::size_t line = indexOf(at[tail], at[head]);
      used |= std::uint64_t{1} << line;
      rating.faults += 2 * m_lines[line].blockers;
      rating.length += m_lines[line].length;
    }
    rating.faults += crossingsOf(used);
    return rating;
  }

  [[nodiscard]] int crossings(const std::vector<std::pair<int, int>>& edges,
                              const std::vector<int>& at) const {
    std::uint64_t used = 0;
    for (const auto& [tail, head] : edges) used |= std::uint64_t{1} << indexOf(at[tail], at[head]);
    return crossingsOf(used);
  }

 private:
  struct Line {
    std::size_t a = 0;
    std::size_t b = 0;
    double length = 0;
    int blockers = 0;  ///< places that it passes through
    std::uint64_t crossed = 0;
  };

  void addLine(const Pattern& pattern, int a, int b) {
    Line line{static_cast<std::size_t>(a), static_cast<std::size_t>(b)};
    line.length = std::hypot(pattern[a].x - pattern[b].x, pattern[a].y - pattern[b].y);
    for (int c = 0; c < m_count; ++c)
      if (c != a && c != b && distanceToSegment(pattern[c], pattern[a], pattern[b]) < kClearance)
        ++line.blockers;
    m_lines.push_back(line);
  }
  [[nodiscard]] std::size_t indexOf(int a, int b) const {
    const auto [low, high] = std::minmax(a, b);
    return static_cast<std::size_t>(low * m_count - low * (low + 1) / 2 + high - low - 1);
  }
  [[nodiscard]] int crossingsOf(std::uint64_t used) const {
    int twice = 0;
    for (std::uint64_t rest = used; rest != 0; rest &= rest - 1)
      twice += std::popcount(m_lines[static_cast<std::size_t>(std::countr_zero(rest))].crossed & used);
    return twice / 2;
  }

  int m_count;
  std::vector<Line> m_lines;
};

}  // namespace

std::vector<DrawnTurning> drawnTurnings(const Chain& chain) {
  std::vector<DrawnTurning> turnings;
  for (std::size_t axis = 0; axis < chain.axes.size(); ++axis) {
    const std::vector<int>& links = chain.axes[axis];
    const int carrier = *std::min_element(links.begin(), links.end());
    for (const int link : links)
      if (link != carrier) turnings.push_back({{carrier, link}, static_cast<int>(axis)});
  }
  return turnings;
}

ChainLayout chainLayout(const Chain& chain) {
  if (chain.links > kMaxSearchedLinks) return {circlePattern(chain.links, kPatternRadius, 0), 0};
  std::vector<std::pair<int, int>> edges;
  for (const DrawnTurning& turning : drawnTurnings(chain)) edges.push_back(turning.links);
  for (const ChainMesh& mesh : chain.meshes) edges.emplace_back(mesh.tail, mesh.head);

  ChainLayout best;
  std::optional<PatternLines::Rating> least;
  for (const Pattern& pattern : patternsOf(chain.links)) {
    const PatternLines lines(pattern);
    std::vector<int> at(static_cast<std::size_t>(chain.links));
    std::iota(at.begin(), at.end(), 0);
    do {
      const PatternLines::Rating rating = lines.rated(edges, at);
      if (least && !(rating < *least)) continue;
      least = rating;
      best.crossings = lines.crossings(edges, at);
      best.places.clear();
      for (const int place : at) best.places.push_back(pattern[static_cast<std::size_t>(place)]);
    } while (std::next_permutation(at.begin(), at.end()));
  }
  return best;
}

}  // namespace geargraph
