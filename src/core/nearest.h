// core/nearest.h - "did you mean": the choice that a misspelt word is closest to.
#pragma once

#include <span>
#include <string_view>

namespace blysk {

/// The choice fewest edits (insert, delete, replace, swap of neighbours, in words of four letters and more
/// two letters for one; ASCII case ignored) away from `word`; the first of equals. Empty when none is near:
/// more than one edit for every three characters of the word, one edit at least being allowed, unless the
/// word begins the choice. Words over 64 characters: empty.
[[nodiscard]] std::string_view nearest(std::string_view word, std::span<const std::string_view> choices);

}  // namespace blysk
