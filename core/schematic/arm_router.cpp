#include "core/schematic/arm_router.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace geargraph {
namespace {

constexpr double kCrossing = 400;  ///< px of detour that one crossing is worth
constexpr double kBend = 30;
constexpr double kTouch = 4;  ///< nearer than this is on the line
constexpr double kNear = 10;  ///< nearer than this looks crowded
constexpr double kCrowded = 20;
constexpr double kOnLine = 40;  ///< a px along a line
constexpr double kBeside = 4;   ///< a px beside one
constexpr double kLaneStep = 11;
constexpr double kLeastLane = 4;  ///< lanes that nobody asked for keep this apart
constexpr double kLeastLaneInLarge = 12;
constexpr std::size_t kLarge = 300;  ///< lines

struct Front {
  double cost = 0;
  int state = 0;
};

/// The cheapest first, then the first.
struct Dearer {
  bool operator()(const Front& a, const Front& b) const {
    return a.cost > b.cost || (a.cost == b.cost && a.state > b.state);
  }
};

double squareToSegment(SheetPoint p, SheetPoint from, SheetPoint to) {
  const SheetPoint along = to - from;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(p - from, along) / square, 0.0, 1.0) : 0;
  const SheetPoint away = from + share * along - p;
  return dot(away, away);
}

/// The square of the distance between a line and an edge of the grid (from its lesser end to its greater);
/// every line asks it of every edge near it.
double squareApart(const LinkLine& line, SheetPoint from, SheetPoint to) {
  if (line.from.x == line.to.x || line.from.y == line.to.y) {
    const auto gap = [](double least, double most, double a, double b) {
      return std::max({std::min(a, b) - most, least - std::max(a, b), 0.0});
    };
    const double x = gap(from.x, to.x, line.from.x, line.to.x);
    const double y = gap(from.y, to.y, line.from.y, line.to.y);
    return x * x + y * y;
  }
  const Extent box = Extent::spanning(from, to);
  if (box.meetsSegment(line.from, line.to)) return 0;
  return std::min({squareToSegment(line.from, from, to), squareToSegment(line.to, from, to),
                   squareToSegment(from, line.from, line.to), squareToSegment(to, line.from, line.to)});
}

/// What it costs a foreign arm to run along an edge of the grid near a line: crossing it, or beside it.
/// `along`: the line's direction.
double tollOf(const LinkLine& line, SheetPoint along, SheetPoint from, SheetPoint to) {
  const double square = squareApart(line, from, to);
  if (square >= kNear * kNear) return 0;
  const bool level = from.y == to.y;
  double beside = 0;
  if (std::abs(level ? along.y : along.x) < 0.3) {
    const double a = level ? line.from.x - from.x : line.from.y - from.y;
    const double b = level ? line.to.x - from.x : line.to.y - from.y;
    const double length = level ? to.x - from.x : to.y - from.y;
    beside = std::max(std::min(std::max(a, b), length) - std::max(std::min(a, b), 0.0), 0.0);
  }
  return square < kTouch * kTouch ? kCrossing + kOnLine * beside : kCrowded + kBeside * beside;
}

/// Sorted lanes; `exact` ones stay where they are, others give way to them.
std::vector<double> lanes(std::vector<double> exact, const std::vector<double>& wished, double apart) {
  const auto tidy = [](std::vector<double>& values, double least) {
    std::sort(values.begin(), values.end());
    std::vector<double> kept;
    for (const double v : values) {
      if (kept.empty() || v - kept.back() > least) kept.push_back(v);
    }
    values = std::move(kept);
  };
  tidy(exact, 1e-6);
  std::vector<double> all = exact;
  for (const double v : wished) {
    const auto near = std::lower_bound(exact.begin(), exact.end(), v - apart);
    if (near == exact.end() || *near > v + apart) all.push_back(v);
  }
  std::sort(all.begin(), all.end());
  std::vector<double> kept;
  for (const double v : all) {
    const bool isExact = std::binary_search(exact.begin(), exact.end(), v);
    if (kept.empty() || isExact || v - kept.back() > apart) kept.push_back(v);
  }
  return kept;
}

std::size_t index(const std::vector<double>& values, double v) {
  return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), v) - values.begin());
}

}  // namespace

ArmRouter::ArmRouter(const std::vector<LinkLine>& lines, const std::vector<SheetPoint>& ends) {
  std::vector<double> exactX;
  std::vector<double> exactY;
  std::vector<double> wishedX;
  std::vector<double> wishedY;
  const auto ask = [](std::vector<double>& wished, double from, double to) {
    for (const double step : {kLaneStep, 2 * kLaneStep}) {
      wished.push_back(std::min(from, to) - step);
      wished.push_back(std::max(from, to) + step);
    }
  };
  for (const LinkLine& line : lines) {
    ask(wishedX, line.from.x, line.to.x);
    ask(wishedY, line.from.y, line.to.y);
    if (line.hold < 0) continue;  // arms may begin on the others
    const bool upright = std::abs(line.from.x - line.to.x) < 1e-6;
    const bool level = std::abs(line.from.y - line.to.y) < 1e-6;
    for (const SheetPoint p : {line.from, line.to}) {
      (level ? wishedX : exactX).push_back(p.x);
      (upright ? wishedY : exactY).push_back(p.y);
    }
  }
  for (const SheetPoint p : ends) {
    exactX.push_back(p.x);
    exactY.push_back(p.y);
  }
  const double least = lines.size() > kLarge ? kLeastLaneInLarge : kLeastLane;
  m_xs = lanes(exactX, wishedX, least);
  m_ys = lanes(exactY, wishedY, least);
  m_level.resize(m_xs.size() * m_ys.size());
  m_upright.resize(m_xs.size() * m_ys.size());
  for (const LinkLine& line : lines) addLine(line);
}

int ArmRouter::node(std::size_t column, std::size_t row) const {
  return static_cast<int>(row * m_xs.size() + column);
}

SheetPoint ArmRouter::place(int node) const {
  const auto n = static_cast<std::size_t>(node);
  return {m_xs[n % m_xs.size()], m_ys[n / m_xs.size()]};
}

std::optional<int> ArmRouter::nodeAt(SheetPoint p) const {
  const std::size_t column = index(m_xs, p.x - 1e-3);
  const std::size_t row = index(m_ys, p.y - 1e-3);
  if (column >= m_xs.size() || row >= m_ys.size()) return std::nullopt;
  if (m_xs[column] > p.x + 1e-3 || m_ys[row] > p.y + 1e-3) return std::nullopt;
  return node(column, row);
}

void ArmRouter::addLine(const LinkLine& line) {
  m_lines.push_back(line);
  charge(line, true);
  charge(line, false);
}

/// Puts a line's toll on the edges that cross or touch it.
void ArmRouter::charge(const LinkLine& line, bool level) {
  const Extent box = Extent::spanning(line.from, line.to).grown(kNear);
  const std::size_t left = index(m_xs, box.left());
  const std::size_t right = index(m_xs, box.right());
  const std::size_t top = index(m_ys, box.top());
  const std::size_t bottom = index(m_ys, box.bottom());
  const SheetPoint along = unit(line.to - line.from);
  for (std::size_t row = level ? top : (top > 0 ? top - 1 : 0); row < std::min(bottom + 1, m_ys.size());
       ++row) {
    for (std::size_t column = level ? (left > 0 ? left - 1 : 0) : left;
         column < std::min(right + 1, m_xs.size()); ++column) {
      if ((level ? column + 1 : row + 1) >= (level ? m_xs.size() : m_ys.size())) continue;
      const SheetPoint from{m_xs[column], m_ys[row]};
      const SheetPoint to{m_xs[column + (level ? 1 : 0)], m_ys[row + (level ? 0 : 1)]};
      const double toll = tollOf(line, along, from, to);
      if (toll <= 0) continue;
      add((level ? m_level : m_upright)[static_cast<std::size_t>(node(column, row))], line.link, toll);
    }
  }
}

void ArmRouter::add(Tolls& tolls, int link, double cost) {
  const int place = static_cast<int>(m_tolls.size());
  m_tolls.push_back({link, -1, cost});
  (tolls.last < 0 ? tolls.first : m_tolls[static_cast<std::size_t>(tolls.last)].next) = place;
  tolls.last = place;
}

double ArmRouter::tollFor(const Tolls& tolls, int link) const {
  double sum = 0;
  for (int place = tolls.first; place >= 0;) {
    const Toll& toll = m_tolls[static_cast<std::size_t>(place)];
    if (toll.link != link) sum += toll.cost;
    place = toll.next;
  }
  return sum;
}

std::vector<std::pair<int, double>> ArmRouter::startsOf(int link) const {
  std::vector<std::pair<int, double>> starts;
  for (const LinkLine& line : m_lines) {
    if (line.link != link || line.hold < 0) continue;
    const Extent box = Extent::spanning(line.from, line.to).grown(1e-3);
    for (std::size_t row = index(m_ys, box.top()); row < m_ys.size() && m_ys[row] <= box.bottom(); ++row) {
      for (std::size_t column = index(m_xs, box.left()); column < m_xs.size() && m_xs[column] <= box.right();
           ++column) {
        const SheetPoint p{m_xs[column], m_ys[row]};
        if (distanceToSegment(p, line.from, line.to) < 1e-3)
          starts.emplace_back(node(column, row), line.hold);
      }
    }
  }
  return starts;
}

/// The bends of the way that led to a state.
ArmRouter::Course ArmRouter::courseTo(int state, const std::vector<int>& from, int link) const {
  std::vector<SheetPoint> places;
  for (int s = state; s >= 0; s = from[static_cast<std::size_t>(s)]) {
    const SheetPoint p = place(s / 2);
    if (places.empty() || distance(places.back(), p) > 1e-6) places.push_back(p);
  }
  std::reverse(places.begin(), places.end());
  Course course;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool straight =
        i > 0 && i + 1 < places.size() &&
        std::abs(dot(unit(places[i] - places[i - 1]), turned(unit(places[i + 1] - places[i])))) < 1e-6;
    if (!straight) course.points.push_back(places[i]);
  }
  for (std::size_t i = 1; i < course.points.size(); ++i) {
    const Extent way = Extent::spanning(course.points[i - 1], course.points[i]);
    course.length += 2 * (way.halfWidth + way.halfHeight);
    course.crossings +=
        static_cast<int>(std::count_if(m_lines.begin(), m_lines.end(), [&](const LinkLine& line) {
          return line.link >= 0 && line.link != link && way.meetsSegment(line.from, line.to);
        }));
  }
  return course;
}

std::vector<double> ArmRouter::pricesOf(const std::vector<Tolls>& edges, int link) const {
  std::vector<double> prices;
  prices.reserve(edges.size());
  for (const Tolls& tolls : edges) prices.push_back(tollFor(tolls, link));
  return prices;
}

// A state is a node and the way it was reached: 0 level, 1 upright. Behind the states come the targets.
std::optional<ArmRouter::Course> ArmRouter::route(int link, const std::vector<SheetPoint>& targets,
                                                  const std::vector<double>& prices) {
  const std::size_t columns = m_xs.size(), count = columns * m_ys.size(), states = 2 * count;
  std::vector<double> best(states + targets.size(), std::numeric_limits<double>::infinity());
  std::vector<int> from(best.size(), -1);
  const std::vector<double> level = pricesOf(m_level, link), upright = pricesOf(m_upright, link);
  std::priority_queue<Front, std::vector<Front>, Dearer> queue;
  const auto reach = [&](std::size_t state, double cost, int via) {
    if (cost >= best[state]) return;
    best[state] = cost;
    from[state] = via;
    queue.push({cost, static_cast<int>(state)});
  };
  for (const auto& [start, hold] : startsOf(link)) {
    reach(2 * static_cast<std::size_t>(start), hold, -1);
    reach(2 * static_cast<std::size_t>(start) + 1, hold, -1);
  }
  std::vector<int> targetAt(count, -1);
  const auto priceOf = [&](int target) {
    return prices.empty() ? 0 : prices[static_cast<std::size_t>(target)];
  };
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const auto there = nodeAt(targets[t]);
    if (!there) continue;
    int& target = targetAt[static_cast<std::size_t>(*there)];
    if (target < 0 || priceOf(static_cast<int>(t)) < priceOf(target)) target = static_cast<int>(t);
  }
  const auto end = [&](int state, std::size_t target) {
    Course course = courseTo(state, from, link);
    for (std::size_t i = 1; i < course.points.size(); ++i) {
      addLine({course.points[i - 1], course.points[i], link, 0});
    }
    course.target = target;
    return course;
  };
  while (!queue.empty()) {
    const auto [cost, number] = queue.top();
    queue.pop();
    const auto state = static_cast<std::size_t>(number);
    if (cost > best[state]) continue;
    if (state >= states) return end(from[state], state - states);
    const std::size_t at = state / 2, column = at % columns, row = at / columns;
    if (const int target = targetAt[at]; target >= 0) {
      if (priceOf(target) == 0) return end(number, static_cast<std::size_t>(target));
      reach(states + static_cast<std::size_t>(target), cost + priceOf(target), number);
    }
    const auto step = [&, cost = cost, number = number](std::size_t next, std::size_t way, double length,
                                                        double toll) {
      const double bend = way == state % 2 ? 0 : kBend;
      reach(2 * next + way, cost + length + bend + toll, number);
    };
    if (column + 1 < columns) step(at + 1, 0, m_xs[column + 1] - m_xs[column], level[at]);
    if (column > 0) step(at - 1, 0, m_xs[column] - m_xs[column - 1], level[at - 1]);
    if (row + 1 < m_ys.size()) step(at + columns, 1, m_ys[row + 1] - m_ys[row], upright[at]);
    if (row > 0) step(at - columns, 1, m_ys[row] - m_ys[row - 1], upright[at - columns]);
  }
  return std::nullopt;
}

}  // namespace geargraph
