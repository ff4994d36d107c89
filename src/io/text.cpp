#include "io/text.h"

#include <charconv>
#include <limits>
#include <system_error>

namespace blysk::io {
namespace {

std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

// The number is too large or too small for T: its exponent tells which.
template <class T>
T beyond_range(std::string_view word) {
  const std::size_t e = word.find_first_of("eE");
  // Without an exponent, a number out of range either has hundreds of digits or is a tiny fraction.
  const bool small = e == std::string_view::npos ? word.find('.') < 3 : word.substr(e + 1).starts_with('-');
  const T magnitude = small ? T(0) : std::numeric_limits<T>::infinity();
  return word.starts_with('-') ? -magnitude : magnitude;
}

template <class T>
bool parse(std::string_view word, T& value) {
  word = without_plus(word);
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return false;
  if constexpr (std::numeric_limits<T>::has_infinity) {
    if (error == std::errc::result_out_of_range) value = beyond_range<T>(word);
    return true;
  }
  return error == std::errc();
}

}  // namespace

bool parse_number(std::string_view word, float& value) { return parse(word, value); }
bool parse_number(std::string_view word, double& value) { return parse(word, value); }
bool parse_number(std::string_view word, long long& value) { return parse(word, value); }

}  // namespace blysk::io
