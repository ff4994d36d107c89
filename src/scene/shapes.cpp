// The table of built-in shapes, and how their text is read.
#include "blysk/shapes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <new>
#include <optional>
#include <string>

#include "core/nearest.h"
#include "scene/shapes_internal.h"

namespace blysk {
namespace {

using shape::Arguments;
using shape::Entry;

const std::vector<Entry>& table() {
  static const std::vector<Entry> rows = {
      shape::teapot(),    shape::sphere(),  shape::icosphere(), shape::torus(),   shape::cube(),
      shape::cylinder(),  shape::plane(),   shape::trefoil(),   shape::terrain(), shape::xfighter(),
      shape::triangles(), shape::spheres(), shape::soup(),      shape::micro(),   shape::meshes(),
      shape::grass(),     shape::fans(),
  };
  return rows;
}

// What the user wrote, fit for one line of a message.
std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string q = "'";
  for (const char c : text.substr(0, kLongest)) q += c >= ' ' && c <= '~' ? c : '?';
  return q + (text.size() > kLongest ? "...'" : "'");
}

std::string number(double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed);
  return {digits, end.ptr};
}

std::string listed(std::span<const std::string_view> names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

Error usage(std::string message) { return {ErrorCode::usage, std::move(message), "shape", 0}; }

std::string suggestion(std::string_view word, std::span<const std::string_view> names) {
  const std::string_view near = nearest(word, names);
  return near.empty() ? "" : "; did you mean '" + std::string(near) + "'?";
}

template <class Rows, class NameOf>
std::vector<std::string_view> names_of(const Rows& rows, const NameOf& name) {
  std::vector<std::string_view> names;
  for (const auto& row : rows) names.push_back(name(row));
  return names;
}

Error unknown_shape(std::string_view name) {
  const auto names = names_of(table(), [](const Entry& e) { return e.info.name; });
  const std::string what = name.empty() ? "no shape is named" : "there is no shape " + quoted(name);
  const std::string near = suggestion(name, names);
  return usage(what + near + (near.empty() ? "; shapes: " : " Shapes: ") + listed(names));
}

Error unknown_key(const ShapeInfo& info, std::string_view key) {
  const auto names = names_of(info.parameters, [](const ShapeParameter& p) { return p.name; });
  const std::string what = std::string(info.name) + " has no parameter " + quoted(key);
  if (names.empty()) return usage(what + "; it has none at all");
  const std::string near = suggestion(key, names);
  return usage(what + near + (near.empty() ? "; parameters: " : " Parameters: ") + listed(names));
}

std::optional<double> parsed(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Reads "key=value" into `arguments`; the error, if there is one.
std::optional<Error> read_pair(std::string_view pair, const ShapeInfo& info, std::vector<bool>& seen,
                               Arguments& arguments) {
  const std::size_t equals = pair.find('=');
  const std::string_view key = pair.substr(0, equals);
  const auto found = std::find_if(info.parameters.begin(), info.parameters.end(),
                                  [&](const ShapeParameter& p) { return p.name == key; });
  if (found == info.parameters.end()) return unknown_key(info, key);
  const auto index = static_cast<std::size_t>(found - info.parameters.begin());
  const std::string name = std::string(info.name) + "'s " + std::string(key);
  if (seen[index]) return usage(name + " is given twice; give it once");
  seen[index] = true;
  const std::string range = " must be a " + std::string(found->whole ? "whole number" : "number") + " from " +
                            number(found->minimum) + " to " + number(found->maximum);
  if (equals == pair.npos)
    return usage(name + range + ", as in " + std::string(key) + "=" + number(found->initial));
  const std::string_view text = pair.substr(equals + 1);
  const std::optional<double> value = parsed(text);
  const bool fits = value && *value >= found->minimum && *value <= found->maximum &&
                    (!found->whole || std::floor(*value) == *value);
  if (!fits) return usage(name + range + ", not " + quoted(text));
  arguments.set(index, *value);
  return std::nullopt;
}

}  // namespace

const std::vector<ShapeInfo>& shapes() {
  static const std::vector<ShapeInfo> infos = [] {
    std::vector<ShapeInfo> all;
    for (const Entry& row : table()) all.push_back(row.info);
    return all;
  }();
  return infos;
}

Result<Scene> make_shape(std::string_view text) {
  constexpr std::string_view kPrefix = "shape:";
  if (text.substr(0, kPrefix.size()) == kPrefix) text.remove_prefix(kPrefix.size());
  const std::size_t question = text.find('?');
  const std::string_view name = text.substr(0, question);
  const auto found =
      std::find_if(table().begin(), table().end(), [&](const Entry& e) { return e.info.name == name; });
  if (found == table().end()) return unknown_shape(name);

  Arguments arguments(found->info);
  std::vector<bool> seen(found->info.parameters.size());
  std::string_view rest = question == text.npos ? std::string_view{} : text.substr(question + 1);
  while (!rest.empty()) {
    const std::size_t ampersand = rest.find('&');
    if (auto error = read_pair(rest.substr(0, ampersand), found->info, seen, arguments))
      return *std::move(error);
    rest = ampersand == rest.npos ? std::string_view{} : rest.substr(ampersand + 1);
  }
  try {
    return found->make(arguments);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit, std::string(name) + " does not fit into memory; make it coarser", "shape",
                 0};
  }
}

namespace shape {

Arguments::Arguments(const ShapeInfo& info) : parameters_(info.parameters) {
  for (const ShapeParameter& p : info.parameters) values_.push_back(p.initial);
}

double Arguments::real(std::string_view name) const {
  const auto found = std::find_if(parameters_.begin(), parameters_.end(),
                                  [&](const ShapeParameter& p) { return p.name == name; });
  return values_[static_cast<std::size_t>(found - parameters_.begin())];
}

}  // namespace shape
}  // namespace blysk
