#include "core/presentation/scene3d/motion_curves.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxTimes = 2881, kMinTimes = 61;
constexpr std::size_t kMaxTwists = 200'000;
constexpr std::size_t kMaxJoints = 12;  // that are plotted where nothing is chosen
constexpr double kSameDirection = 1e-9;
constexpr std::array kCoordinates = {", x", ", y", ", z"};

/// What turns how fast, sampled.
class Sampler {
 public:
  Sampler(const MechanismScene& stage, const SceneView& view, const CurveChoice& choice)
      : m_stage(stage), m_view(view), m_choice(choice) {
    const std::size_t parts = std::max<std::size_t>(stage.scene.instances.size(), 1);
    const std::size_t count = std::clamp(kMaxTwists / parts, kMinTimes, kMaxTimes);
    for (std::size_t i = 0; i < count; ++i)
      m_times.push_back(choice.span * static_cast<double>(i) / static_cast<double>(count - 1));
  }

  std::vector<CurveSheet> sheets(const std::stop_token& stop) {
    const std::vector<std::size_t> links = chosenLinks();
    std::vector<std::vector<Eigen::Vector3d>> turning(links.size()), sliding(links.size());
    std::vector<std::vector<Eigen::Vector3d>> moving(m_view.traces.size());
    SceneView now = m_view;
    now.traces.clear();
    std::vector<Pose> poses(m_stage.scene.instances.size());
    std::vector<Twist3> twists(poses.size());
    for (const double time : m_times) {
      if (links.empty() && m_view.traces.empty()) break;
      if (stop.stop_requested()) return {};
      now.time = time;
      const std::vector<double> angles = inputAngles(m_stage, now);
      m_stage.place(angles, poses);
      m_stage.twists(angles, inputSpeeds(m_stage, now), twists);
      for (std::size_t k = 0; k < links.size(); ++k) {
        turning[k].push_back(twists[links[k]].angular);
        sliding[k].push_back(twists[links[k]].linear);
      }
      for (std::size_t k = 0; k < moving.size(); ++k)
        moving[k].push_back(velocityOf(m_view.traces[k].point, poses, twists));
    }
    std::vector<CurveSheet> sheets = {{translated("Angular speed"), "rad/s", m_times, {}},
                                      {translated("Speed of what slides"), m_stage.unit + "/s", m_times, {}},
                                      {translated("Traced points"), m_stage.unit + "/s", m_times, {}}};
    addJoints(sheets[0], sheets[1], links.empty());
    for (std::size_t k = 0; k < links.size(); ++k) {
      const Instance& part = m_stage.scene.instances[links[k]];
      const bool slides = isZero(turning[k]) && !isZero(sliding[k]);
      add(
          sheets[slides ? 1 : 0], [&] { return nameOf(part.element); }, part.colour,
          slides ? sliding[k] : turning[k], part.element);
    }
    for (std::size_t k = 0; k < moving.size(); ++k) {
      const ShownTrace& trace = m_view.traces[k];
      add(sheets[2], [&] { return pointName(k, trace.element); },
          m_stage.scene.instances[trace.point.instance].colour, moving[k], {});
    }
    std::erase_if(sheets, [](const CurveSheet& sheet) { return sheet.curves.empty(); });
    return sheets;
  }

 private:
  [[nodiscard]] static bool isZero(const std::vector<Eigen::Vector3d>& vectors) {
    return std::all_of(vectors.begin(), vectors.end(),
                       [](const Eigen::Vector3d& vector) { return vector.isZero(0); });
  }
  [[nodiscard]] std::string nameOf(const ElementId& link) const {
    for (const SceneLabel& label : m_stage.labels) {
      if (label.kind == LabelKind::link && label.element == link) return translated("link %1", {label.text});
    }
    return translated("ground");
  }
  [[nodiscard]] bool isGround(const ElementId& link) const {
    return std::none_of(m_stage.labels.begin(), m_stage.labels.end(), [&](const SceneLabel& label) {
      return label.kind == LabelKind::link && label.element == link;
    });
  }
  [[nodiscard]] std::string pointName(std::size_t trace, const ElementId& link) const {
    return translated("point %1 of %2", {std::to_string(trace + 1), nameOf(link)});
  }

  /// An instance of each link that was chosen, or has a wheel of a chosen mesh.
  [[nodiscard]] std::vector<std::size_t> chosenLinks() const {
    std::vector<std::size_t> found;
    std::set<ElementId> links;
    const auto& instances = m_stage.scene.instances;
    for (std::size_t i = 0; i < instances.size(); ++i) {
      const bool chosen =
          m_choice.elements.contains(instances[i].element) ||
          std::any_of(instances[i].also.begin(), instances[i].also.end(), [&](const ElementId& id) {
            return id.kind == ElementKind::gearMesh && m_choice.elements.contains(id);
          });
      if (chosen && !isGround(instances[i].element) && links.insert(instances[i].element).second)
        found.push_back(i);
    }
    return found;
  }

  /// The chosen joints; where they are none, and `orAll`, all. Each on the sheet of its unit.
  void addJoints(CurveSheet& turning, CurveSheet& sliding, bool orAll) const {
    const auto isChosen = [this](const SceneJoint& joint) {
      return m_choice.elements.contains(joint.element);
    };
    SceneView at = m_view;
    std::vector<std::vector<double>> speeds;
    for (const double time : m_times) {
      at.time = time;
      speeds.push_back(inputSpeeds(m_stage, at));
    }
    const bool all = orAll && std::none_of(m_stage.joints.begin(), m_stage.joints.end(), isChosen);
    for (const SceneJoint& joint : m_stage.joints) {
      const std::size_t shown = turning.curves.size() + sliding.curves.size();
      const bool chosen = all ? shown < kMaxJoints : isChosen(joint);
      if (!chosen) continue;
      CurveSheet& sheet = joint.slides ? sliding : turning;
      sheet.curves.push_back({translated("joint %1", {joint.text}),
                              joint.colour,
                              false,
                              {},
                              joint.element,
                              "joint " + joint.text});
      for (const std::vector<double>& now : speeds) {
        double rate = 0;
        for (std::size_t k = 0; k < joint.gains.size(); ++k) rate += joint.gains[k] * now[k];
        sheet.curves.back().values.push_back(rate);
      }
    }
  }

  /// In the frame of the watcher as it stands at the scene's own poses.
  [[nodiscard]] Eigen::Vector3d velocityOf(const TracedPoint& point, std::span<const Pose> poses,
                                           std::span<const Twist3> twists) const {
    const Eigen::Vector3d at = poses[point.instance] * point.place;
    const Eigen::Vector3d velocity = twists[point.instance].at(at);
    if (!point.watcher) return velocity;
    const Eigen::Matrix3d back =
        m_stage.scene.instances[*point.watcher].pose.linear() * poses[*point.watcher].linear().transpose();
    return back * (velocity - twists[*point.watcher].at(at));
  }

  /// `compose` makes the name of the curve, in the language in use and for files.
  template <class Compose>
  void add(CurveSheet& sheet, const Compose& compose, const Rgb& colour,
           const std::vector<Eigen::Vector3d>& vectors, const std::optional<ElementId>& link) const {
    const std::string name = compose();
    const EnglishScope english;
    const std::string nameInFiles = compose();
    const bool isSigned = link.has_value();
    Eigen::Vector3d main = Eigen::Vector3d::Zero();
    double largest = 0;
    for (const Eigen::Vector3d& vector : vectors) {
      if (vector.norm() > main.norm()) main = vector;
      largest = std::max(largest, vector.norm());
    }
    const bool isOneLine =
        isSigned && std::all_of(vectors.begin(), vectors.end(), [&](const Eigen::Vector3d& v) {
          return v.cross(main).norm() <= kSameDirection * largest * largest;
        });
    // Positive about the axis' direction that points along +x, +y or +z most.
    Eigen::Index widest = 0;
    if (largest > 0) main.cwiseAbs().maxCoeff(&widest);
    MotionCurve whole{name, colour, false, {}, link, nameInFiles};
    for (const Eigen::Vector3d& vector : vectors) {
      const double sense = isOneLine && vector[widest] < 0 ? -1 : 1;
      whole.values.push_back(sense * vector.norm());
    }
    sheet.curves.push_back(std::move(whole));
    if (!m_choice.components || isOneLine) return;
    for (std::size_t axis = 0; axis < kCoordinates.size(); ++axis) {
      MotionCurve part{name + kCoordinates[axis], colour, true, {}, link, nameInFiles + kCoordinates[axis]};
      for (const Eigen::Vector3d& vector : vectors)
        part.values.push_back(vector[static_cast<Eigen::Index>(axis)]);
      sheet.curves.push_back(std::move(part));
    }
  }

  const MechanismScene& m_stage;
  const SceneView& m_view;
  const CurveChoice& m_choice;
  std::vector<double> m_times;
};

/// An empty field where speeds near the end of the doubles have no finite value here.
void appendNumber(std::string& text, double value) {
  if (!std::isfinite(value)) return;
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

}  // namespace

std::vector<CurveSheet> motionCurves(const MechanismScene& stage, const SceneView& view,
                                     const CurveChoice& choice, const std::stop_token& stop) {
  if (!stage.place || !stage.twists || stage.inputSpeeds.empty()) return {};
  return Sampler(stage, view, choice).sheets(stop);
}

std::string curvesCsv(const CurveSheet& sheet) {
  std::string text = "time s";
  for (const MotionCurve& curve : sheet.curves)
    text += ",\"" + (curve.nameInFiles.empty() ? curve.name : curve.nameInFiles) + " " + sheet.unit + "\"";
  text += "\r\n";
  for (std::size_t i = 0; i < sheet.times.size(); ++i) {
    appendNumber(text, sheet.times[i]);
    for (const MotionCurve& curve : sheet.curves) {
      text += ',';
      appendNumber(text, curve.values[i]);
    }
    text += "\r\n";
  }
  return text;
}

}  // namespace geargraph
