#include "core/design/atlas/canonical_graph.h"

#include <algorithm>
#include <numeric>

// Its names are macros and types of the global namespace, so this source is compiled by itself.
#include <nauty.h>

#include "core/foundations/base/contract.h"

static_assert(HAVE_TLS == 1, "nauty has to keep its work space per thread");

namespace geargraph {
namespace {

static_assert(sizeof(::graph) == sizeof(std::uint64_t));

/// The vertices ordered by colour, as nauty takes partitions: the last of each colour ends its cell.
void fillPartition(const std::vector<int>& colours, std::vector<int>& lab, std::vector<int>& ptn) {
  std::iota(lab.begin(), lab.end(), 0);
  const auto colourOf = [&](int vertex) { return colours[static_cast<std::size_t>(vertex)]; };
  std::stable_sort(lab.begin(), lab.end(), [&](int a, int b) { return colourOf(a) < colourOf(b); });
  for (std::size_t i = 0; i + 1 < lab.size(); ++i) ptn[i] = colourOf(lab[i]) == colourOf(lab[i + 1]) ? 1 : 0;
}

}  // namespace

CanonicalGraph canonicalGraph(const ColouredGraph& graph) {
  const std::size_t n = graph.colours.size();
  CanonicalGraph result;
  if (n == 0) return result;
  const std::size_t rowWords = (n + WORDSIZE - 1) / WORDSIZE;
  nauty_check(WORDSIZE, static_cast<int>(rowWords), static_cast<int>(n), NAUTYVERSIONID);
  std::vector<::graph> rows(n * rowWords, 0);
  for (const auto& [a, b] : graph.edges) {
    GEARGRAPH_REQUIRE(a != b);
    ADDELEMENT(&rows[static_cast<std::size_t>(a) * rowWords], b);
    ADDELEMENT(&rows[static_cast<std::size_t>(b) * rowWords], a);
  }
  std::vector<int> lab(n);
  std::vector<int> ptn(n, 0);
  std::vector<int> orbits(n);
  fillPartition(graph.colours, lab, ptn);
  DEFAULTOPTIONS_GRAPH(options);
  options.getcanon = TRUE;
  options.defaultptn = FALSE;
  statsblk stats;
  std::vector<::graph> canonical(n * rowWords);
  densenauty(rows.data(), lab.data(), ptn.data(), orbits.data(), &options, &stats, static_cast<int>(rowWords),
             static_cast<int>(n), canonical.data());
  GEARGRAPH_REQUIRE(stats.errstatus == 0);
  // Sizes and colours belong to the form: the rows alone do not tell how many vertices have which colour.
  result.form.push_back(n);
  for (const int vertex : lab)
    result.form.push_back(static_cast<std::uint64_t>(graph.colours[static_cast<std::size_t>(vertex)]));
  result.form.insert(result.form.end(), canonical.begin(), canonical.end());
  result.order = std::move(lab);
  result.orbits = std::move(orbits);
  return result;
}

}  // namespace geargraph
