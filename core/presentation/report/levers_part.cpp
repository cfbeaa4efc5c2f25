#include "core/foundations/base/translation.h"
#include "core/presentation/diagrams/lever_words.h"
#include "core/presentation/report/report_parts.h"
#include "core/presentation/report/report_words.h"
#include "core/theory/levers/lever_motion.h"

namespace geargraph {
namespace {

/// The lever analogy: places of links on their levers, and speeds that are affine in the place.
class LeversPart : private ReportPart {
 public:
  LeversPart(Report& report, const AnalysisSnapshot& snapshot, LeverPlan plan)
      : ReportPart(report), m_mechanism(*snapshot.mechanism), m_plan(std::move(plan)) {
    if (snapshot.solved && snapshot.solved->exact)
      m_speeds = leverSpeeds(m_plan, snapshot.kinematics->placement(), snapshot.solved->exact->rates);
  }

  void add() {
    heading(1, toTranslate("Levers"));
    paragraph(translated(
        "Each gear set is a lever: its links on the ground's axis are points with exact places, 0 at one end "
        "and 1 at the other. In every motion the speed of a link is an affine function of its place, "
        "$\\omega(x) = \\omega(0) + x\\,(\\omega(1) - \\omega(0))$."));
    put(ReportFigure{ReportDrawing::levers, translated("Levers")});
    for (const Lever& lever : m_plan.levers) addLever(lever);
    if (m_mechanism.states.empty()) return;
    put(ReportFigure{ReportDrawing::nomogram,
                     translated("Nomogram of the states, the speed of the drive being 1")});
  }

 private:
  void addLever(const Lever& lever) {
    ReportTable table;
    table.head = {translated("Links"), translated("Place")};
    if (!m_speeds.empty()) table.head.push_back(translated("Speed in rad/s"));
    for (const LeverPoint& point : lever.points) {
      std::vector<ReportWords> row{plainWords(labelsOf(point.links)), formulaWords(readableLatex(point.at))};
      if (!m_speeds.empty()) {
        const auto at = static_cast<std::size_t>(m_plan.positionOf(point.links.front()));
        row.push_back(formulaWords(readableLatex(m_speeds[at])));
      }
      table.rows.push_back(std::move(row));
    }
    const std::string sets = setsOf(lever);
    if (!sets.empty()) paragraph(translated("Lever of %1, %2 teeth:", {sets, teethOf(m_plan, lever)}));
    put(std::move(table));
    if (!lever.isByMeshes) paragraph(translated("These links are on one lever by these tooth counts only."));
  }
  [[nodiscard]] static ReportWords formulaWords(std::string tex) { return {{std::move(tex), true}}; }

  const Mechanism& m_mechanism;
  LeverPlan m_plan;
  std::vector<Rational> m_speeds;  ///< by position in the plan; empty without a solution
};

}  // namespace

void addLeversPart(Report& report, const AnalysisSnapshot& snapshot, const std::stop_token& stop) {
  if (!snapshot.kinematics || !snapshot.kinematics->model) return;
  auto plan = leverPlanOf(*snapshot.kinematics->model, snapshot.kinematics->placement(), {}, stop);
  if (!plan || plan->levers.empty()) return;
  LeversPart(report, snapshot, *std::move(plan)).add();
}

}  // namespace geargraph
