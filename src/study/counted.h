// study/counted.h - a number that counts what is done with it.
//
// The reference forms are templates over their number type: run with this one, they tell how many operations
// a method takes, out of the code that the tests hold to the specification.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace blysk::study {

/// How often each operation was done. A product with a constant power of two is a shift, as it is in the
/// fixed-point programs of the papers.
struct Operations {
  std::uint64_t add = 0;  ///< subtractions too
  std::uint64_t mul = 0, div = 0, sqrt = 0;
  std::uint64_t shift = 0;       ///< by any number of bits
  std::uint64_t shift_bits = 0;  ///< the same, one bit at a time
  std::uint64_t compare = 0;     ///< the papers leave them out

  friend bool operator==(const Operations&, const Operations&) = default;
  Operations& operator+=(const Operations& o) {
    add += o.add, mul += o.mul, div += o.div, sqrt += o.sqrt;
    shift += o.shift, shift_bits += o.shift_bits, compare += o.compare;
    return *this;
  }
  friend Operations operator-(Operations a, const Operations& b) {
    a.add -= b.add, a.mul -= b.mul, a.div -= b.div, a.sqrt -= b.sqrt;
    a.shift -= b.shift, a.shift_bits -= b.shift_bits, a.compare -= b.compare;
    return a;
  }
};

/// What this thread's Counted numbers have done so far.
inline Operations& operations_so_far() {
  static thread_local Operations so_far;
  return so_far;
}

/// Constants are free among themselves; so are a sign, adding the constant 0 and multiplying by 0 or 1.
class Counted {
 public:
  Counted() = default;
  Counted(double constant) : value_(constant) {}  // NOLINT(google-explicit-constructor)
  Counted(int constant) : value_(constant) {}     // NOLINT(google-explicit-constructor)

  /// A number that is known only when the program runs.
  [[nodiscard]] static Counted input(double value) { return {value, false}; }
  [[nodiscard]] double value() const { return value_; }

  friend Counted operator-(Counted a) { return {-a.value_, a.constant_}; }
  friend Counted operator+(Counted a, Counted b) { return sum(a, b, a.value_ + b.value_); }
  friend Counted operator-(Counted a, Counted b) { return sum(a, b, a.value_ - b.value_); }
  friend Counted operator*(Counted a, Counted b) {
    const double product = a.value_ * b.value_;
    if (a.constant_ && b.constant_) return product;
    if (a.is_zero() || b.is_zero()) return 0;
    if (a.constant_ || b.constant_) {
      scale(a.constant_ ? a.value_ : b.value_);
    } else {
      ++operations_so_far().mul;
    }
    return {product, false};
  }
  friend Counted operator/(Counted a, Counted b) {
    const double quotient = a.value_ / b.value_;
    if (a.constant_ && b.constant_) return quotient;
    if (b.constant_ && power_of_two(b.value_)) {
      scale(1 / b.value_);
    } else {
      ++operations_so_far().div;
    }
    return {quotient, false};
  }
  Counted& operator+=(Counted b) { return *this = *this + b; }
  Counted& operator-=(Counted b) { return *this = *this - b; }
  Counted& operator*=(Counted b) { return *this = *this * b; }
  Counted& operator/=(Counted b) { return *this = *this / b; }

  friend bool operator<(Counted a, Counted b) { return compared(a, b), a.value_ < b.value_; }
  friend bool operator>(Counted a, Counted b) { return b < a; }
  friend bool operator<=(Counted a, Counted b) { return compared(a, b), a.value_ <= b.value_; }
  friend bool operator>=(Counted a, Counted b) { return b <= a; }

  /// Which pixel it is a program knows.
  friend Counted next_pixel(Counted x) { return input(x.value_ + 1); }

  /// The upper bits of a fixed-point number, and what is left without an integer that the program found.
  friend int whole_part(Counted a) { return static_cast<int>(a.value_); }
  friend Counted beyond(Counted a, int whole) { return a - input(whole); }

  friend Counted sqrt(Counted a) {
    if (a.constant_) return std::sqrt(a.value_);
    ++operations_so_far().sqrt;
    return {std::sqrt(a.value_), false};
  }

 private:
  Counted(double value, bool constant) : value_(value), constant_(constant) {}
  [[nodiscard]] bool is_zero() const { return constant_ && value_ == 0; }

  static bool power_of_two(double v) {
    int exponent;
    return std::abs(std::frexp(v, &exponent)) == 0.5;
  }
  static Counted sum(Counted a, Counted b, double value) {
    if (a.constant_ && b.constant_) return value;
    if (!a.is_zero() && !b.is_zero()) ++operations_so_far().add;
    return {value, false};
  }
  static void scale(double constant) {
    if (!power_of_two(constant)) {
      ++operations_so_far().mul;
      return;
    }
    int exponent;
    std::frexp(constant, &exponent);  // 1 is 0.5 * 2^1
    if (exponent == 1) return;
    ++operations_so_far().shift;
    operations_so_far().shift_bits += static_cast<std::uint64_t>(std::abs(exponent - 1));
  }
  static void compared(Counted a, Counted b) {
    if (!a.constant_ || !b.constant_) ++operations_so_far().compare;
  }

  double value_ = 0;
  bool constant_ = true;
};

/// A value that a program is given, in its number type.
template <class T>
T input(double value) {
  return static_cast<T>(value);
}
template <>
inline Counted input<Counted>(double value) {
  return Counted::input(value);
}

}  // namespace blysk::study
