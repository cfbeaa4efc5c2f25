#include "core/presentation/schematic/arm_grid.h"

#include <algorithm>

namespace geargraph {
namespace {

constexpr double kCrossing = 400;  ///< px of detour that one crossing is worth
constexpr double kTouch = 4;       ///< nearer than this is on the line
constexpr double kNear = 10;       ///< nearer than this looks crowded
constexpr double kCrowded = 20;
constexpr double kOnLine = 40;  ///< a px along a line
constexpr double kBeside = 4;   ///< a px beside one
constexpr double kLaneStep = 11;
constexpr double kLeastLane = 4;  ///< lanes that nobody asked for keep this apart
constexpr double kLeastLaneInLarge = 12;
constexpr std::size_t kLarge = 300;  ///< lines

// --- lanes ---

/// Puts the values from `first` on in order with the ascending ones before them, each once.
void arrange(std::vector<double>& values, std::size_t first) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(middle, values.end());
  std::inplace_merge(values.begin(), middle, values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// The lanes that are wanted, ascending: exact ones stay where they are, others give way to them.
std::vector<double> merged(std::vector<double> exact, const std::vector<double>& preferred, double apart) {
  constexpr double kSame = 1e-6;
  std::size_t count = 0;
  for (const double v : exact) {
    if (count == 0 || v - exact[count - 1] > kSame) exact[count++] = v;
  }
  exact.resize(count);
  std::vector<double> lanes;
  std::size_t near = 0;  // the first exact one that a preferred one might be too near to
  std::size_t next = 0;
  for (const double v : preferred) {
    while (near < count && exact[near] < v - apart) ++near;
    if (near < count && exact[near] <= v + apart) continue;
    while (next < count && exact[next] < v) lanes.push_back(exact[next++]);
    if (lanes.empty() || v - lanes.back() > apart) lanes.push_back(v);
  }
  lanes.insert(lanes.end(), exact.begin() + static_cast<std::ptrdiff_t>(next), exact.end());
  return lanes;
}

// --- weights ---

double squareToSegment(CanvasPoint p, CanvasPoint from, CanvasPoint to) {
  const CanvasPoint along = to - from;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(p - from, along) / square, 0.0, 1.0) : 0;
  const CanvasPoint away = from + share * along - p;
  return dot(away, away);
}

/// The square of the distance between a slanting line and an edge of the grid (from its lesser end to its
/// greater).
double squareApart(const LinkLine& line, CanvasPoint from, CanvasPoint to) {
  const Extent box = Extent::spanning(from, to);
  if (box.meetsSegment(line.from, line.to)) return 0;
  return std::min({squareToSegment(line.from, from, to), squareToSegment(line.to, from, to),
                   squareToSegment(from, line.from, line.to), squareToSegment(to, line.from, line.to)});
}

/// How far two stretches of a line are apart: from `least` to `most`, and between a and b.
double gapBetween(double least, double most, double a, double b) {
  return std::max({std::min(a, b) - most, least - std::max(a, b), 0.0});
}

/// How much of an edge lies beside a line that runs its way: between a and b.
double stretchBeside(double least, double most, double a, double b) {
  const double length = most - least;
  a -= least;
  b -= least;
  return std::max(std::min(std::max(a, b), length) - std::max(std::min(a, b), 0.0), 0.0);
}

/// Bounds of the square of the distance between a line and an edge, those across and along the sheet being
/// added: most often they tell already what the edge costs.
struct GridBounds {
  double least = 0;   ///< of the box about the line
  double ofFrom = 0;  ///< of its ends
  double ofTo = 0;

  GridBounds() = default;
  GridBounds(double low, double high, double from, double to) {
    const auto square = [](double v) { return v * v; };
    least = square(gapBetween(low, high, from, to));
    ofFrom = square(gapBetween(low, high, from, from));
    ofTo = square(gapBetween(low, high, to, to));
  }
  friend GridBounds operator+(GridBounds a, const GridBounds& b) {
    a.least += b.least;
    a.ofFrom += b.ofFrom;
    a.ofTo += b.ofTo;
    return a;
  }
  /// A square that costs the same as the true one.
  [[nodiscard]] std::optional<double> ifClear() const {
    constexpr double kRounding = 1e-6;
    const double most = std::min(ofFrom, ofTo);
    for (const double limit : {kTouch * kTouch, kNear * kNear}) {
      if (most < limit - kRounding) return most;
      if (least < limit + kRounding) return std::nullopt;
    }
    return least;
  }
};

struct EdgeWeight {
  double touch = kCrossing;  ///< on the line
  double near = kCrowded;    ///< beside it
  static EdgeWeight along(double stretch) {
    return {kCrossing + kOnLine * stretch, kCrowded + kBeside * stretch};
  }
  [[nodiscard]] double at(double square) const {
    return square < kTouch * kTouch ? touch : (square < kNear * kNear ? near : 0);
  }
};

/// Adds to the weights of edges near lines, one line after the other.
class EdgeWeigher {
 public:
  EdgeWeigher(const ArmGrid& grid, ArmEdgeWeights& weights)
      : m_grid(grid),
        m_weights(weights),
        m_square(grid.columns()),
        m_touch(grid.columns()),
        m_near(grid.columns()) {}

  void add(const LinkLine& line) {
    const Extent box = Extent::spanning(line.from, line.to).grown(kNear);
    const auto before = [](std::size_t i) { return i > 0 ? i - 1 : 0; };
    const std::size_t left = firstFrom(m_grid.xs, box.left()), top = firstFrom(m_grid.ys, box.top());
    const std::size_t right = firstFrom(m_grid.xs, box.right()), bottom = firstFrom(m_grid.ys, box.bottom());
    const std::size_t columns = m_grid.columns(), rows = m_grid.rows();
    const Range level{before(left), std::min(right + 1, columns - 1), top, std::min(bottom + 1, rows)};
    const Range upright{left, std::min(right + 1, columns), before(top), std::min(bottom + 1, rows - 1)};
    if (line.from.x == line.to.x || line.from.y == line.to.y) {
      addLevel(line, level);
      addUpright(line, upright);
    } else {
      addSlanting(line, level, true);
      addSlanting(line, upright, false);
    }
  }

 private:
  /// Edges by the node they start from.
  struct Range {
    std::size_t left = 0, right = 0;  ///< columns, the last one not included
    std::size_t top = 0, bottom = 0;  ///< rows
  };

  // A straight line's distance from an edge is made of one number for the row and one for the column.

  void addLevel(const LinkLine& line, const Range& range) {
    const auto& [xs, ys] = m_grid;
    const bool isLevel = line.from.y == line.to.y;
    for (std::size_t c = range.left; c < range.right; ++c) {
      const double gap = gapBetween(xs[c], xs[c + 1], line.from.x, line.to.x);
      m_square[c] = gap * gap;
      const double stretch = isLevel ? stretchBeside(xs[c], xs[c + 1], line.from.x, line.to.x) : 0;
      m_touch[c] = EdgeWeight::along(stretch).touch;
      m_near[c] = EdgeWeight::along(stretch).near;
    }
    for (std::size_t r = range.top; r < range.bottom; ++r) {
      const double gap = gapBetween(ys[r], ys[r], line.from.y, line.to.y);
      double* const weights = m_weights.level.data() + r * m_grid.columns();
      for (std::size_t c = range.left; c < range.right; ++c)
        weights[c] += EdgeWeight{m_touch[c], m_near[c]}.at(m_square[c] + gap * gap);
    }
  }

  void addUpright(const LinkLine& line, const Range& range) {
    const auto& [xs, ys] = m_grid;
    const bool isLevel = line.from.y == line.to.y;
    for (std::size_t c = range.left; c < range.right; ++c) {
      const double gap = gapBetween(xs[c], xs[c], line.from.x, line.to.x);
      m_square[c] = gap * gap;
    }
    for (std::size_t r = range.top; r < range.bottom; ++r) {
      const double gap = gapBetween(ys[r], ys[r + 1], line.from.y, line.to.y);
      const EdgeWeight weight =
          isLevel ? EdgeWeight{} : EdgeWeight::along(stretchBeside(ys[r], ys[r + 1], line.from.y, line.to.y));
      double* const weights = m_weights.upright.data() + r * m_grid.columns();
      for (std::size_t c = range.left; c < range.right; ++c) weights[c] += weight.at(m_square[c] + gap * gap);
    }
  }

  void addSlanting(const LinkLine& line, const Range& range, bool level) {
    const auto& [xs, ys] = m_grid;
    const CanvasPoint along = unit(line.to - line.from);
    const bool runsAlong = std::abs(level ? along.y : along.x) < 0.3;
    const std::size_t right = level ? 1 : 0, down = level ? 0 : 1;
    m_bounds.resize(m_grid.columns());
    for (std::size_t c = range.left; c < range.right; ++c)
      m_bounds[c] = GridBounds(xs[c], xs[c + right], line.from.x, line.to.x);
    for (std::size_t r = range.top; r < range.bottom; ++r) {
      const GridBounds ofRow(ys[r], ys[r + down], line.from.y, line.to.y);
      double* const weights = (level ? m_weights.level : m_weights.upright).data() + r * m_grid.columns();
      for (std::size_t c = range.left; c < range.right; ++c) {
        const CanvasPoint from{xs[c], ys[r]}, to{xs[c + right], ys[r + down]};
        const double stretch = !runsAlong ? 0
                               : level    ? stretchBeside(from.x, to.x, line.from.x, line.to.x)
                                          : stretchBeside(from.y, to.y, line.from.y, line.to.y);
        const std::optional<double> clear = (m_bounds[c] + ofRow).ifClear();
        weights[c] += EdgeWeight::along(stretch).at(clear ? *clear : squareApart(line, from, to));
      }
    }
  }

  const ArmGrid& m_grid;
  ArmEdgeWeights& m_weights;
  std::vector<double> m_square;  ///< by column: of the distance along the rows
  std::vector<double> m_touch;   ///< by column: the weights on a line and beside it
  std::vector<double> m_near;
  std::vector<GridBounds> m_bounds;  ///< by column: along the rows
};

}  // namespace

std::size_t firstFrom(const std::vector<double>& values, double v) {
  return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), v) - values.begin());
}

std::optional<std::size_t> ArmGrid::nodeAt(CanvasPoint p) const {
  const std::size_t column = firstFrom(xs, p.x - 1e-3);
  const std::size_t row = firstFrom(ys, p.y - 1e-3);
  if (column >= xs.size() || row >= ys.size()) return std::nullopt;
  if (xs[column] > p.x + 1e-3 || ys[row] > p.y + 1e-3) return std::nullopt;
  return row * xs.size() + column;
}

std::vector<std::size_t> ArmGrid::nodesOn(const LinkLine& line) const {
  std::vector<std::size_t> nodes;
  const Extent box = Extent::spanning(line.from, line.to).grown(1e-3);
  for (std::size_t row = firstFrom(ys, box.top()); row < ys.size() && ys[row] <= box.bottom(); ++row) {
    for (std::size_t column = firstFrom(xs, box.left()); column < xs.size() && xs[column] <= box.right();
         ++column) {
      if (distanceToSegment({xs[column], ys[row]}, line.from, line.to) < 1e-3)
        nodes.push_back(row * xs.size() + column);
    }
  }
  return nodes;
}

void ArmLanes::follow(const std::vector<LinkLine>& lines) {
  const std::size_t exactX = m_x.exact.size(), exactY = m_y.exact.size();
  const std::size_t preferredX = m_x.preferred.size(), preferredY = m_y.preferred.size();
  const auto ask = [](std::vector<double>& preferred, double from, double to) {
    for (const double step : {kLaneStep, 2 * kLaneStep}) {
      preferred.push_back(std::min(from, to) - step);
      preferred.push_back(std::max(from, to) + step);
    }
  };
  for (; m_known < lines.size(); ++m_known) {
    const LinkLine& line = lines[m_known];
    ask(m_x.preferred, line.from.x, line.to.x);
    ask(m_y.preferred, line.from.y, line.to.y);
    if (line.penalty < 0) continue;  // arms may begin on the others
    const bool upright = std::abs(line.from.x - line.to.x) < 1e-6;
    const bool level = std::abs(line.from.y - line.to.y) < 1e-6;
    for (const CanvasPoint p : {line.from, line.to}) {
      (level ? m_x.preferred : m_x.exact).push_back(p.x);
      (upright ? m_y.preferred : m_y.exact).push_back(p.y);
    }
  }
  arrange(m_x.exact, exactX);
  arrange(m_x.preferred, preferredX);
  arrange(m_y.exact, exactY);
  arrange(m_y.preferred, preferredY);
}

ArmGrid ArmLanes::gridWith(const std::vector<CanvasPoint>& ends) const {
  const double apart = m_known > kLarge ? kLeastLaneInLarge : kLeastLane;
  std::vector<double> exactX = m_x.exact, exactY = m_y.exact;
  for (const CanvasPoint p : ends) {
    exactX.push_back(p.x);
    exactY.push_back(p.y);
  }
  arrange(exactX, m_x.exact.size());
  arrange(exactY, m_y.exact.size());
  return {merged(std::move(exactX), m_x.preferred, apart), merged(std::move(exactY), m_y.preferred, apart)};
}

void ArmEdgeWeights::add(const ArmGrid& grid, const std::vector<LinkLine>& lines, int link) {
  level.assign(grid.nodes(), 0);
  upright.assign(grid.nodes(), 0);
  if (grid.nodes() == 0) return;
  EdgeWeigher weigher(grid, *this);
  for (const LinkLine& line : lines) {
    if (line.link != link) weigher.add(line);
  }
}

}  // namespace geargraph
