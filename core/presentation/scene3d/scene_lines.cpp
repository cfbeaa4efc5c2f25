#include "core/presentation/scene3d/scene_lines.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace geargraph {
namespace {

constexpr double kMaxArrowLength = 0.34;  // of the scene's radius
constexpr double kCross = 0.022;
constexpr double kInstantAxis = 0.8;
constexpr double kMeshAxis = 0.3;
constexpr double kStandsStill = 1e-9;  // of the fastest

/// Collects the lines of one moment.
class LineMaker {
 public:
  LineMaker(const MechanismScene& stage, const Moment& moment)
      : m_stage(stage), m_moment(moment), m_bounds(boundsOf(stage.scene)), m_size(m_bounds.radius()) {
    if (!stage.twists) return;
    m_twists.resize(stage.scene.instances.size());
    stage.twists(moment.angles, moment.speeds, m_twists);
    if (!moment.watcher) return;
    const Twist3 watcher = m_twists[*moment.watcher];
    for (Twist3& twist : m_twists) {
      twist.angular -= watcher.angular;
      twist.linear -= watcher.linear;
    }
  }

  void addMarks(MarkKind kind);
  void addPitchPoints();
  void addInstantAxes();
  void addVelocities();
  [[nodiscard]] std::vector<MarkLine> take() { return std::move(m_lines); }

 private:
  /// A pitch point as it is seen.
  [[nodiscard]] Eigen::Vector3d seen(const SceneContact& contact) const {
    if (!contact.carrier) return m_moment.ground * contact.point;
    const Pose& reference = m_stage.scene.instances[*contact.carrier].pose;
    return m_moment.poses[*contact.carrier] * reference.inverse() * contact.point;
  }
  [[nodiscard]] bool isCut(const Eigen::Vector3d& point) const {
    return m_moment.cut && m_moment.cut->normal.dot(point) > m_moment.cut->offset;
  }
  void addUncut(MarkLine line);
  void addInstantAxis(const Twist3& twist, const Eigen::Vector3d& middle, double half, const Rgb& colour);
  void addArrow(const Eigen::Vector3d& from, const Eigen::Vector3d& along);

  const MechanismScene& m_stage;
  const Moment& m_moment;
  Bounds m_bounds;
  double m_size;
  std::vector<Twist3> m_twists;  ///< by instance, against the watcher; in the base frame
  std::vector<MarkLine> m_lines;
};

void LineMaker::addMarks(MarkKind kind) {
  for (const SceneMark& mark : m_stage.marks) {
    if (mark.kind != kind) continue;
    MarkLine line{{}, m_moment.ink, 1.3F, mark.dashed};
    for (const Eigen::Vector3d& point : mark.points)
      line.points.push_back(m_moment.poses[mark.instance] * point);
    kind == MarkKind::axis ? m_lines.push_back(std::move(line)) : addUncut(std::move(line));
  }
}

// An axis stays whole: it is where the half that was taken away turned, too.
void LineMaker::addUncut(MarkLine line) {
  MarkLine piece = line;
  piece.points.clear();
  for (const Eigen::Vector3d& point : line.points) {
    if (!isCut(point)) {
      piece.points.push_back(point);
      continue;
    }
    if (piece.points.size() > 1) m_lines.push_back(piece);
    piece.points.clear();
  }
  if (piece.points.size() > 1) m_lines.push_back(std::move(piece));
}

void LineMaker::addPitchPoints() {
  for (const SceneContact& contact : m_stage.contacts) {
    const Eigen::Vector3d at = seen(contact);
    if (isCut(at)) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d arm = kCross * m_size * Eigen::Vector3d::Unit(axis);
      m_lines.push_back({{at - arm, at + arm}, m_moment.motion, 2.4F, false});
    }
  }
}

// The points of the screw's line are where the velocity is along the angular velocity.
void LineMaker::addInstantAxis(const Twist3& twist, const Eigen::Vector3d& middle, double half,
                               const Rgb& colour) {
  const double speed = twist.angular.norm();
  if (!(speed > kStandsStill)) return;
  const Eigen::Vector3d direction = twist.angular / speed;
  Eigen::Vector3d point = twist.angular.cross(twist.linear) / (speed * speed);
  point += direction.dot(middle - point) * direction;
  const auto end = [&](double along) -> Eigen::Vector3d {
    return m_moment.ground * Eigen::Vector3d(point + along * direction);
  };
  m_lines.push_back({{end(-half), end(half)}, colour, 1.8F, true});
}

void LineMaker::addInstantAxes() {
  std::set<ElementId> done;
  for (std::size_t i = 0; i < m_twists.size(); ++i) {
    const Instance& instance = m_stage.scene.instances[i];
    if (!done.insert(instance.element).second) continue;
    addInstantAxis(m_twists[i], m_bounds.centre(), kInstantAxis * m_size, instance.colour);
  }
  if (m_twists.empty()) return;
  for (const SceneContact& contact : m_stage.contacts) {
    const Twist3 &tail = m_twists[contact.tail], &head = m_twists[contact.head];
    addInstantAxis({tail.angular - head.angular, tail.linear - head.linear},
                   m_moment.ground.inverse() * seen(contact), kMeshAxis * m_size, m_moment.motion);
  }
}

// A shaft and a head of two strokes, in the plane of the arrow that is most upright.
void LineMaker::addArrow(const Eigen::Vector3d& from, const Eigen::Vector3d& along) {
  const Eigen::Vector3d to = from + along;
  const Eigen::Vector3d side = along.normalized().unitOrthogonal() * 0.09 * along.norm();
  m_lines.push_back({{from, to}, m_moment.motion, 2.2F, false});
  m_lines.push_back({{to - 0.22 * along + side, to, to - 0.22 * along - side}, m_moment.motion, 2.2F, false});
  const Eigen::Vector3d other = along.normalized().cross(side);
  m_lines.push_back(
      {{to - 0.22 * along + other, to, to - 0.22 * along - other}, m_moment.motion, 2.2F, false});
}

void LineMaker::addVelocities() {
  if (m_twists.empty()) return;
  struct Arrow {
    Eigen::Vector3d from;  // as seen
    Eigen::Vector3d velocity;
  };
  std::vector<Arrow> arrows;
  const Pose back = m_moment.ground.inverse();
  const auto add = [&](std::size_t instance, const Eigen::Vector3d& at) {
    arrows.push_back({at, m_moment.ground.linear() * m_twists[instance].at(back * at)});
  };
  std::set<std::size_t> wheels;
  for (const SceneContact& contact : m_stage.contacts) {
    add(contact.tail, seen(contact));
    wheels.insert({contact.tail, contact.head});
  }
  for (const std::size_t wheel : wheels) add(wheel, m_moment.poses[wheel].translation());
  double fastest = 0;
  for (const Arrow& arrow : arrows) fastest = std::max(fastest, arrow.velocity.norm());
  for (const Arrow& arrow : arrows) {
    if (arrow.velocity.norm() <= 1e-6 * fastest || isCut(arrow.from)) continue;
    addArrow(arrow.from, kMaxArrowLength * m_size / fastest * arrow.velocity);
  }
}

}  // namespace

std::vector<MarkLine> stageLines(const MechanismScene& stage, const MarkChoice& choice,
                                 const Moment& moment) {
  if (choice == MarkChoice{}) return {};
  LineMaker maker(stage, moment);
  if (choice.axes) maker.addMarks(MarkKind::axis);
  if (choice.pitchCircles) maker.addMarks(MarkKind::pitchCircle);
  if (choice.instantAxes) maker.addInstantAxes();
  if (choice.pitchPoints) maker.addPitchPoints();
  if (choice.velocities) maker.addVelocities();
  return maker.take();
}

}  // namespace geargraph
