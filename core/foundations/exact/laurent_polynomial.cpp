#include "core/foundations/exact/laurent_polynomial.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

using Powers = LaurentPolynomial::Powers;
using Term = LaurentPolynomial::Term;

/// -1 where a comes first, 1 where b does, 0 where they are the same product.
int order(Powers a, Powers b) {
  const std::size_t common = std::min(a.size(), b.size());
  std::size_t i = 0;
  while (i < common && a[i] == b[i]) ++i;
  if (i == a.size() && i == b.size()) return 0;
  // The first ratio in which they differ; one that is missing has the power 0.
  const bool inA =
      i < a.size() && (i == b.size() || LaurentPolynomial::ratioOf(a[i]) <= LaurentPolynomial::ratioOf(b[i]));
  const bool inB =
      i < b.size() && (i == a.size() || LaurentPolynomial::ratioOf(b[i]) <= LaurentPolynomial::ratioOf(a[i]));
  const int powerA = inA ? LaurentPolynomial::powerOf(a[i]) : 0;
  const int powerB = inB ? LaurentPolynomial::powerOf(b[i]) : 0;
  return powerA > powerB ? -1 : 1;
}

void writeCoefficient(std::uint32_t* head, std::int64_t coefficient) {
  std::memcpy(head + 1, &coefficient, sizeof coefficient);
}

}  // namespace

InlineUint32Vector::InlineUint32Vector(const InlineUint32Vector& other) {
  std::copy_n(other.data(), other.size(), grow(other.size()));
}

InlineUint32Vector& InlineUint32Vector::operator=(const InlineUint32Vector& other) {
  if (this == &other) return *this;
  m_size = 0;
  std::copy_n(other.data(), other.size(), grow(other.size()));
  return *this;
}

void InlineUint32Vector::reserve(std::size_t capacity) {
  const std::size_t more = std::max(capacity, std::size_t{2} * m_capacity);
  auto* const heap = new std::uint32_t[more];
  std::copy_n(data(), m_size, heap);
  if (isOnHeap()) delete[] m_heap;
  m_heap = heap;
  m_capacity = static_cast<std::uint32_t>(more);
}

LaurentPolynomial LaurentPolynomial::term(std::int64_t factor) {
  LaurentPolynomial result;
  if (factor != 0) result.appendHead(factor, 0);
  return result;
}

LaurentPolynomial LaurentPolynomial::term(std::int64_t factor, int ratio, int power) {
  GEARGRAPH_REQUIRE(std::abs(power) <= kMaxPower && ratio >= 0 && ratio < 1 << 24);
  if (factor == 0 || power == 0) return term(factor);
  LaurentPolynomial result;
  *result.appendHead(factor, 1) = packed(ratio, power);
  return result;
}

bool LaurentPolynomial::isUnit() const {
  if (m_terms != 1) return false;
  std::size_t at = 0;
  const std::int64_t coefficient = termAt(at).coefficient;
  return coefficient == 1 || coefficient == -1;
}

bool LaurentPolynomial::isOne() const {
  std::size_t at = 0;
  return m_terms == 1 && m_words.size() == kHead && termAt(at).coefficient == 1;
}

LaurentPolynomial::Term LaurentPolynomial::termAt(std::size_t& at) const {
  const std::uint32_t* const head = m_words.data() + at;
  Term term{0, {head + kHead, head[0]}};
  std::memcpy(&term.coefficient, head + 1, sizeof term.coefficient);
  at += kHead + head[0];
  return term;
}

/// Returns the place of the powers.
std::uint32_t* LaurentPolynomial::appendHead(std::int64_t coefficient, std::size_t powers) {
  std::uint32_t* const head = m_words.grow(kHead + powers);
  head[0] = static_cast<std::uint32_t>(powers);
  writeCoefficient(head, coefficient);
  ++m_terms;
  return head + kHead;
}

void LaurentPolynomial::append(const Term& term) {
  std::copy(term.powers.begin(), term.powers.end(), appendHead(term.coefficient, term.powers.size()));
}

void LaurentPolynomial::negate() {
  std::size_t at = 0;
  for (int i = 0; i < m_terms; ++i) {
    std::uint32_t* const head = m_words.data() + at;
    writeCoefficient(head, -termAt(at).coefficient);
  }
}

bool LaurentPolynomial::combine(const LaurentPolynomial& other, int sign) {
  if (other.isZero()) return true;
  if (isZero()) {
    *this = other;
    if (sign < 0) negate();
    return true;
  }
  LaurentPolynomial sum;
  std::size_t here = 0;
  std::size_t there = 0;
  int leftHere = m_terms;
  int leftThere = other.m_terms;
  while (leftHere > 0 || leftThere > 0) {
    std::size_t nextHere = here;
    std::size_t nextThere = there;
    Term mine = leftHere > 0 ? termAt(nextHere) : Term();
    Term theirs = leftThere > 0 ? other.termAt(nextThere) : Term();
    theirs.coefficient *= sign;
    const int first = leftHere == 0 ? 1 : leftThere == 0 ? -1 : order(mine.powers, theirs.powers);
    if (first <= 0) {
      here = nextHere;
      --leftHere;
    }
    if (first >= 0) {
      there = nextThere;
      --leftThere;
    }
    if (first == 0) mine.coefficient += theirs.coefficient;  // two of 62 bits fit into 64
    const Term& next = first > 0 ? theirs : mine;
    if (!isCoefficient(next.coefficient)) return false;
    if (next.coefficient != 0) sum.append(next);
  }
  *this = std::move(sum);
  return true;
}

/// Appends a * b^sign. False where there is no room.
bool LaurentPolynomial::appendProduct(const Term& a, const Term& b, int sign) {
  std::int64_t coefficient = 0;
  if (__builtin_mul_overflow(a.coefficient, b.coefficient, &coefficient) || !isCoefficient(coefficient)) {
    return false;
  }
  const std::size_t most = a.powers.size() + b.powers.size();
  std::uint32_t* const powers = appendHead(coefficient, most);
  if (b.powers.empty()) {
    std::copy(a.powers.begin(), a.powers.end(), powers);
    return true;
  }
  std::uint32_t* end = powers;
  std::size_t j = 0;
  for (const std::uint32_t power : a.powers) {
    const int ratio = ratioOf(power);
    for (; j < b.powers.size() && ratioOf(b.powers[j]) < ratio; ++j) {
      *end++ = packed(ratioOf(b.powers[j]), sign * powerOf(b.powers[j]));
    }
    int sum = powerOf(power);
    if (j < b.powers.size() && ratioOf(b.powers[j]) == ratio) sum += sign * powerOf(b.powers[j++]);
    if (std::abs(sum) > kMaxPower) return false;
    if (sum != 0) *end++ = packed(ratio, sum);
  }
  for (; j < b.powers.size(); ++j) *end++ = packed(ratioOf(b.powers[j]), sign * powerOf(b.powers[j]));
  const auto used = static_cast<std::size_t>(end - powers);
  *(powers - kHead) = static_cast<std::uint32_t>(used);
  m_words.shrink(most - used);
  return true;
}

bool LaurentPolynomial::setProduct(const LaurentPolynomial& a, const LaurentPolynomial& b) {
  m_words.clear();
  m_terms = 0;
  if (a.isZero() || b.isZero()) return true;
  if (a.m_terms > 1 && b.m_terms > 1) return false;
  const LaurentPolynomial& many = b.m_terms == 1 ? a : b;
  std::size_t at = 0;
  const Term single = (b.m_terms == 1 ? b : a).termAt(at);
  at = 0;
  for (int i = 0; i < many.m_terms; ++i) {  // a common factor leaves the terms in order
    if (!appendProduct(many.termAt(at), single, 1)) return false;
  }
  return true;
}

bool LaurentPolynomial::setQuotient(const LaurentPolynomial& a, const LaurentPolynomial& b) {
  m_words.clear();
  m_terms = 0;
  std::size_t at = 0;
  const Term unit = b.termAt(at);
  at = 0;
  for (int i = 0; i < a.m_terms; ++i) {
    if (!appendProduct(a.termAt(at), unit, -1)) return false;  // its sign is its own inverse
  }
  return true;
}

bool operator==(const LaurentPolynomial& a, const LaurentPolynomial& b) {
  return a.m_words.size() == b.m_words.size() &&
         std::equal(a.m_words.data(), a.m_words.data() + a.m_words.size(), b.m_words.data());
}

}  // namespace geargraph
