#include <algorithm>

#include "core/gears/wheel_rooms.h"

namespace geargraph {
namespace {

constexpr double kStep = 0.85;
constexpr int kMostSteps = 7;  // to a third

/// Bevels are shortened together with all that meshes with them, so that teeth in mesh stay equally wide.
class FaceShortener {
 public:
  FaceShortener(TrainWheels& train, const Placement& placement, const std::stop_token& stop)
      : m_train(train), m_placement(placement), m_stop(stop) {}

  /// Shortens one of them, or both, until they are out of each other; else leaves them as they were.
  void part(int a, int b) {
    std::vector<std::vector<int>> choices{together(a), together(b), {}};
    for (const std::size_t one : {0, 1}) {
      for (const int w : choices[one]) {
        if (std::find(choices[2].begin(), choices[2].end(), w) == choices[2].end()) choices[2].push_back(w);
      }
    }
    const std::vector<TrainWheel> before = m_train.wheels;
    double share = 1;
    for (int i = 0; i < kMostSteps; ++i) {
      share *= kStep;
      for (const std::vector<int>& choice : choices) {
        if (choice.empty()) continue;
        if (m_stop.stop_requested()) return;
        for (const int w : choice) m_train.wheels[static_cast<std::size_t>(w)].spec.faceWidth *= share;
        if (!WheelRooms(m_train, m_placement).collide(a, b)) return;
        m_train.wheels = before;
      }
    }
  }

 private:
  /// The bevel and those that mesh with it and with each other; none where somebody has said how wide one of
  /// them is.
  [[nodiscard]] std::vector<int> together(int wheel) const {
    std::vector<int> found{wheel};
    for (std::size_t next = 0; next < found.size(); ++next) {
      for (const TrainPair& pair : m_train.pairs) {
        if (pair.tail != found[next] && pair.head != found[next]) continue;
        if (pair.kind != MeshKind::bevel || !pair.openFace) return {};
        const int partner = pair.tail == found[next] ? pair.head : pair.tail;
        if (std::find(found.begin(), found.end(), partner) == found.end()) found.push_back(partner);
      }
    }
    return found;
  }

  TrainWheels& m_train;
  const Placement& m_placement;
  const std::stop_token& m_stop;
};

}  // namespace

void shortenFaces(TrainWheels& train, const Placement& placement, const std::stop_token& stop) {
  const bool open = std::any_of(train.pairs.begin(), train.pairs.end(), [](const TrainPair& pair) {
    return pair.kind == MeshKind::bevel && pair.openFace;
  });
  if (!open) return;
  FaceShortener shortener(train, placement, stop);
  for (const auto& [a, b] : wheelsInOnePlace(train, placement, stop)) {
    if (stop.stop_requested()) return;
    shortener.part(a, b);
  }
}

}  // namespace geargraph
