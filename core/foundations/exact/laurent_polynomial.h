#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

namespace geargraph {

/// A vector of 32-bit words with small-buffer optimisation: most values of an analysis do not allocate.
class InlineUint32Vector {
 public:
  InlineUint32Vector() = default;
  InlineUint32Vector(const InlineUint32Vector& other);
  InlineUint32Vector(InlineUint32Vector&& other) noexcept { take(other); }
  InlineUint32Vector& operator=(const InlineUint32Vector& other);
  InlineUint32Vector& operator=(InlineUint32Vector&& other) noexcept {
    if (this == &other) return *this;
    if (isOnHeap()) delete[] m_heap;
    take(other);
    return *this;
  }
  ~InlineUint32Vector() {
    if (isOnHeap()) delete[] m_heap;
  }

  [[nodiscard]] std::size_t size() const { return m_size; }
  [[nodiscard]] const std::uint32_t* data() const { return isOnHeap() ? m_heap : m_inPlace; }
  [[nodiscard]] std::uint32_t* data() { return isOnHeap() ? m_heap : m_inPlace; }
  void clear() { m_size = 0; }
  /// Appends `more` uninitialised words and returns a pointer to them.
  std::uint32_t* grow(std::size_t more) {
    if (m_size + more > m_capacity) reserve(m_size + more);
    std::uint32_t* const place = data() + m_size;
    m_size += static_cast<std::uint32_t>(more);
    return place;
  }
  /// Removes the last `less` words.
  void shrink(std::size_t less) { m_size -= static_cast<std::uint32_t>(less); }

 private:
  static constexpr std::uint32_t kInPlace = 14;

  [[nodiscard]] bool isOnHeap() const { return m_capacity > kInPlace; }
  void reserve(std::size_t capacity);
  void take(InlineUint32Vector& other) noexcept {
    m_size = std::exchange(other.m_size, 0U);
    m_capacity = std::exchange(other.m_capacity, kInPlace);
    if (isOnHeap()) {
      m_heap = other.m_heap;
    } else {
      std::memcpy(m_inPlace, other.m_inPlace, sizeof m_inPlace);  // all: of fixed length it is two steps
    }
  }

  std::uint32_t m_size = 0;
  std::uint32_t m_capacity = kInPlace;
  union {
    std::uint32_t m_inPlace[kInPlace];
    std::uint32_t* m_heap;
  };
};

/// A Laurent polynomial in the gear ratios with integer coefficients, such as -2 i15/i17 + 1: the result of
/// solving one equation after another, because each is divided by a ratio or by 1 only. No common divisors
/// are computed, and a term takes memory for its own factors only, whatever the number of ratios.
///
/// Coefficients are below 2^62, powers below 128; if a result would exceed these, the functions return false.
class LaurentPolynomial {
 public:
  LaurentPolynomial() = default;  ///< 0
  LaurentPolynomial(const LaurentPolynomial&) = default;
  LaurentPolynomial(LaurentPolynomial&& other) noexcept
      : m_words(std::move(other.m_words)), m_terms(std::exchange(other.m_terms, 0)) {}
  LaurentPolynomial& operator=(const LaurentPolynomial&) = default;
  LaurentPolynomial& operator=(LaurentPolynomial&& other) noexcept {
    m_words = std::move(other.m_words);
    m_terms = std::exchange(other.m_terms, 0);
    return *this;
  }
  ~LaurentPolynomial() = default;
  /// factor * ratio^power. @pre isCoefficient(factor), |power| < 128
  static LaurentPolynomial term(std::int64_t factor);
  static LaurentPolynomial term(std::int64_t factor, int ratio, int power);

  /// A product of powers: packed(ratio, power), ascending.
  using Powers = std::span<const std::uint32_t>;
  struct Term {
    std::int64_t coefficient = 0;
    Powers powers;
  };

  static constexpr int kMaxPower = 127;
  [[nodiscard]] static bool isCoefficient(std::int64_t value) {
    constexpr std::int64_t kMax = (std::int64_t{1} << 62) - 1;
    return value >= -kMax && value <= kMax;
  }
  [[nodiscard]] static std::uint32_t packed(int ratio, int power) {
    return (static_cast<std::uint32_t>(ratio) << 8U) | static_cast<std::uint32_t>(power + 128);
  }
  [[nodiscard]] static int ratioOf(std::uint32_t packed) { return static_cast<int>(packed >> 8U); }
  [[nodiscard]] static int powerOf(std::uint32_t packed) { return static_cast<int>(packed & 255U) - 128; }

  [[nodiscard]] bool isZero() const { return m_terms == 0; }
  [[nodiscard]] int termCount() const { return m_terms; }
  /// The number of its terms and their factors.
  [[nodiscard]] std::size_t size() const {
    return m_words.size() - (kHead - 1) * static_cast<std::size_t>(m_terms);
  }
  /// Is it + or - a product of powers? Then every Laurent polynomial can be divided by it.
  [[nodiscard]] bool isUnit() const;
  [[nodiscard]] bool isOne() const;

  /// Calls use(term) for every term; of two, the one with the higher power of the first ratio in which they
  /// differ comes first.
  template <class Use>
  void forEachTerm(const Use& use) const {
    std::size_t at = 0;
    for (int i = 0; i < m_terms; ++i) use(termAt(at));
  }
  /// Appends a term. @pre it is after the others in the order of terms, and its coefficient is not 0
  void append(const Term& term);

  void negate();
  /// this +- other. False, without a change, on overflow of a coefficient.
  [[nodiscard]] bool add(const LaurentPolynomial& other) { return combine(other, 1); }
  [[nodiscard]] bool subtract(const LaurentPolynomial& other) { return combine(other, -1); }
  [[nodiscard]] bool subtract(LaurentPolynomial&& other) {
    if (!isZero()) return combine(other, -1);
    *this = std::move(other);
    negate();
    return true;
  }
  /// this = a * b. False, with a meaningless value, if neither is a single term or on overflow.
  /// @pre neither is this
  [[nodiscard]] bool setProduct(const LaurentPolynomial& a, const LaurentPolynomial& b);
  /// this = a / b; false likewise. @pre b.isUnit(), neither is this
  [[nodiscard]] bool setQuotient(const LaurentPolynomial& a, const LaurentPolynomial& b);

  friend bool operator==(const LaurentPolynomial& a, const LaurentPolynomial& b);

 private:
  /// The layout of a term: the number of its powers, its coefficient in two words, its powers.
  static constexpr std::size_t kHead = 3;

  [[nodiscard]] Term termAt(std::size_t& at) const;
  std::uint32_t* appendHead(std::int64_t coefficient, std::size_t powers);
  bool appendProduct(const Term& a, const Term& b, int sign);
  bool combine(const LaurentPolynomial& other, int sign);

  InlineUint32Vector m_words;
  int m_terms = 0;
};

}  // namespace geargraph
