#include "core/design/teeth_search/best_choices.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geargraph {
namespace {

/// nearError() is a quotient of two sums with a relative error each; where terms cancel they are exact.
constexpr double kErrorOfError = 1e-12;

bool isBetter(const FoundTeeth& one, const FoundTeeth& other) {
  if (one.error != other.error) return one.error < other.error;
  const int largest = *std::max_element(one.teeth.begin(), one.teeth.end());
  const int otherLargest = *std::max_element(other.teeth.begin(), other.teeth.end());
  if (largest != otherLargest) return largest < otherLargest;
  return one.teeth < other.teeth;
}

}  // namespace

FoundTeeth foundTeeth(const TeethProblem& problem, std::span<const int> teeth) {
  FoundTeeth found;
  found.teeth.assign(teeth.begin(), teeth.end());
  for (const SearchedRatio& ratio : problem.ratios) {
    found.ratios.push_back(ratio.numerator.at<Rational>(teeth) / ratio.denominator.at<Rational>(teeth));
    found.errors.push_back(ratio.bounds.errorOf(found.ratios.back()));
    found.error = std::max(found.error, found.errors.back().abs());
  }
  return found;
}

double nearError(const TeethProblem& problem, std::span<const int> teeth) {
  double largest = 0;
  for (const SearchedRatio& ratio : problem.ratios) {
    const auto numerator = ratio.numerator.at<long double>(teeth);
    const auto denominator = ratio.denominator.at<long double>(teeth);
    if (numerator == 0 || denominator == 0) return std::numeric_limits<double>::infinity();
    const double wanted = ratio.bounds.wanted.toDouble();
    largest = std::max(largest, std::abs((static_cast<double>(numerator / denominator) - wanted) / wanted));
  }
  return largest;
}

void BestChoices::offer(std::span<const int> teeth) {
  if (m_most == 0) return;
  if (m_heap.size() == m_most && nearError(m_problem, teeth) > m_worst) return;
  FoundTeeth found = foundTeeth(m_problem, teeth);
  if (m_heap.size() == m_most) {
    if (!isBetter(found, m_heap.front())) return;
    std::pop_heap(m_heap.begin(), m_heap.end(), isBetter);
    m_heap.back() = std::move(found);
  } else {
    m_heap.push_back(std::move(found));
  }
  std::push_heap(m_heap.begin(), m_heap.end(), isBetter);
  m_worst = m_heap.front().error.toDouble() + kErrorOfError;
}

std::vector<FoundTeeth> BestChoices::take() && {
  std::sort_heap(m_heap.begin(), m_heap.end(), isBetter);
  return std::move(m_heap);
}

}  // namespace geargraph
