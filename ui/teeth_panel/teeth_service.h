#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/design/teeth_search/meant_teeth.h"
#include "core/design/teeth_search/teeth_answer.h"
#include "ui/service/service.h"

namespace geargraph {

/// Choices that are shown, the best ones.
constexpr std::size_t kMaxShown = 100;

/// What is wished about a train, as it is drawn.
struct TeethRequest {
  PlacedMechanism drawn;
  std::string wish;     ///< as readTeethWish() reads it
  bool isWhole = true;  ///< false: a ratio has no number yet; its wheels are listed and nothing is searched
  std::optional<MeantTeethOptions> meant = {};  ///< the ratios are stated ones, of teeth near the drawn ones
  std::shared_ptr<std::atomic<double>> share = std::make_shared<std::atomic<double>>(0);
  std::shared_ptr<std::atomic<std::int64_t>> found = std::make_shared<std::atomic<std::int64_t>>(0);
  std::stop_source halt = {};  ///< ends the search early; the answer is what it found so far
};

/// What was found for a wish, or what is wrong with it.
struct TeethResult {
  MechanismPtr drawn;
  std::string wish;
  Diagnostics problems;                            ///< of the wish, or of the train
  std::shared_ptr<const TeethProblem> problem;     ///< null: there are problems
  std::optional<TeethAnswer> answer;               ///< none: there are problems, or the wish is not whole
  std::optional<MeantTeeth> meant;                 ///< of a request for meant teeth, whose answer it is
  std::vector<std::optional<Rational>> ratiosNow;  ///< by wish, of the drawn teeth
};
using TeethResultPtr = std::shared_ptr<const TeethResult>;

/// Searches teeth on a background thread.
class TeethService final : public Service<TeethRequest, TeethResultPtr> {
 public:
  explicit TeethService(QObject* parent = nullptr);

  /// Searches, unless the last request was for the same wish and a train that differs in places of its
  /// drawing at most.
  void search(const PlacedMechanism& drawn, std::string wish, bool isWhole,
              const std::optional<MeantTeethOptions>& meant = {});
  /// Ends the search early; its answer is what it found so far.
  void halt();
  /// Cancels the search and forgets the last answer.
  void forget();
  /// The fraction done, 0..1, and the choices found until now.
  [[nodiscard]] double share() const { return m_running ? m_running->share->load() : 0; }
  [[nodiscard]] std::int64_t found() const { return m_running ? m_running->found->load() : 0; }

 private:
  std::optional<TeethRequest> m_running;
};

}  // namespace geargraph
