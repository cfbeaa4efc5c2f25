#include <algorithm>
#include <utility>

#include "core/machine/train/wheel_envelopes.h"

namespace geargraph {
namespace {

constexpr double kStep = 0.85;
constexpr int kMaxFaceSteps = 7;  // to a third

/// The teeth of a face gear are as wide as they are.
bool canShorten(const TrainPair& pair) {
  return hasIntersectingAxes(pair.kind) && !pairKind(pair.kind).hasFace && pair.openFace;
}

/// Bevels are shortened together with all that meshes with them, so that teeth in mesh stay equally wide.
class FaceShortener {
 public:
  FaceShortener(TrainWheels& train, const Placement& placement, const std::stop_token& stop)
      : m_train(train), m_envelopes(train, placement), m_stop(stop), m_pairsOf(train.wheels.size()) {
    for (std::size_t p = 0; p < train.pairs.size(); ++p) {
      for (const GearOrdinal w : {train.pairs[p].tail, train.pairs[p].head}) m_pairsOf[w].push_back(p);
    }
  }

  /// Shortens one of them, or both, until they are out of each other; else leaves them as they were.
  /// Cost: 21 comparisons of two wheels at most, and the bevels that mesh with each other.
  void part(GearOrdinal a, GearOrdinal b) {
    std::vector<std::vector<GearOrdinal>> choices{together(a), together(b), {}};
    for (const std::size_t one : {0, 1}) {
      for (const GearOrdinal w : choices[one]) {
        if (std::find(choices[2].begin(), choices[2].end(), w) == choices[2].end()) choices[2].push_back(w);
      }
    }
    std::vector<double> widths;
    for (const GearOrdinal w : choices[2]) widths.push_back(faceWidth(w));
    double share = 1;
    for (int i = 0; i < kMaxFaceSteps; ++i) {
      share *= kStep;
      for (const std::vector<GearOrdinal>& choice : choices) {
        if (choice.empty()) continue;
        if (m_stop.stop_requested()) return;
        for (const GearOrdinal w : choice) setFaceWidth(w, faceWidth(w) * share);
        if (!m_envelopes.collide(a, b)) return;
        for (std::size_t k = 0; k < widths.size(); ++k) setFaceWidth(choices[2][k], widths[k]);
      }
    }
  }

 private:
  /// The bevel and those that mesh with it and with each other; none where the document gives the face width
  /// of one of them.
  [[nodiscard]] std::vector<GearOrdinal> together(GearOrdinal wheel) const {
    std::vector<GearOrdinal> found{wheel};
    for (std::size_t next = 0; next < found.size(); ++next) {
      for (const std::size_t p : m_pairsOf[found[next]]) {
        const TrainPair& pair = m_train.pairs[p];
        if (!canShorten(pair)) return {};
        const GearOrdinal partner = pair.tail == found[next] ? pair.head : pair.tail;
        if (std::find(found.begin(), found.end(), partner) == found.end()) found.push_back(partner);
      }
    }
    return found;
  }

  [[nodiscard]] double faceWidth(GearOrdinal wheel) const {
    return m_train.wheels[static_cast<std::size_t>(wheel)].spec.faceWidth;
  }
  void setFaceWidth(GearOrdinal wheel, double width) {
    double& known = m_train.wheels[static_cast<std::size_t>(wheel)].spec.faceWidth;
    if (known == width) return;
    known = width;
    m_envelopes.update(wheel);
  }

  TrainWheels& m_train;
  WheelEnvelopes m_envelopes;
  const std::stop_token& m_stop;
  ByGear<std::vector<std::size_t>> m_pairsOf;
};

}  // namespace

void shortenFaces(TrainWheels& train, const Placement& placement, const std::stop_token& stop) {
  const bool open = std::any_of(train.pairs.begin(), train.pairs.end(),
                                [](const TrainPair& pair) { return canShorten(pair); });
  if (!open) return;
  // In the order of meshes, of each the smaller wheel first: tail and head make no difference.
  const auto rank = [&](GearOrdinal w) {
    const TrainWheel& wheel = train.wheels[static_cast<std::size_t>(w)];
    return std::pair(wheel.meshes.front(), wheel.workingRadius);
  };
  std::vector<std::pair<int, int>> pairs = overlappingWheels(train, placement, stop);
  for (auto& [a, b] : pairs) {
    if (rank(b) < rank(a)) std::swap(a, b);
  }
  std::stable_sort(pairs.begin(), pairs.end(), [&](const auto& x, const auto& y) {
    return std::pair(rank(x.first), rank(x.second)) < std::pair(rank(y.first), rank(y.second));
  });
  FaceShortener shortener(train, placement, stop);
  for (const auto& [a, b] : pairs) {
    if (stop.stop_requested()) return;
    shortener.part(a, b);
  }
}

}  // namespace geargraph
