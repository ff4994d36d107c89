#include "core/nearest.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace blysk {
namespace {

constexpr std::size_t kMaxLength = 64, kLeastForSounds = 4;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool begins(std::string_view word, std::string_view choice) {
  return word.size() <= choice.size() && std::equal(word.begin(), word.end(), choice.begin(),
                                                    [](char a, char b) { return lower(a) == lower(b); });
}

// Damerau-Levenshtein, each character edited at most once (optimal string alignment); two letters for one are
// one edit too, as a sound may be written either way: "fong" for "phong".
std::size_t distance(std::string_view a, std::string_view b) {
  std::array<std::array<std::size_t, kMaxLength + 1>, 3> rows;  // of a's characters i - 2, i - 1 and i
  const bool sounds = a.size() >= kLeastForSounds;
  for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto& now = rows[i % 3];
    const auto& before = rows[(i + 2) % 3];
    const auto& two_before = rows[(i + 1) % 3];
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      now[j] = std::min({before[j] + 1, now[j - 1] + 1, before[j - 1] + (same ? 0 : 1)});
      const bool swapped =
          i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) now[j] = std::min(now[j], two_before[j - 2] + 1);
      if (sounds && j > 1) now[j] = std::min(now[j], before[j - 2] + 1);
      if (sounds && i > 1) now[j] = std::min(now[j], two_before[j - 1] + 1);
    }
  }
  return rows[a.size() % 3][b.size()];
}

}  // namespace

std::string_view nearest(std::string_view word, std::span<const std::string_view> choices) {
  if (word.empty() || word.size() > kMaxLength) return {};
  const std::size_t allowed = std::max<std::size_t>(1, word.size() / 3);
  std::string_view best;
  std::size_t best_distance = kMaxLength + 1;
  for (const std::string_view choice : choices) {
    if (choice.size() > kMaxLength) continue;
    const std::size_t d = distance(word, choice);
    const bool near = d <= allowed && d < std::max(word.size(), choice.size());
    if ((near || (word.size() > 1 && begins(word, choice))) && d < best_distance) {
      best = choice;
      best_distance = d;
    }
  }
  return best;
}

}  // namespace blysk
