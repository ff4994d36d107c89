#include "io/gltf_context.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <utility>

namespace blysk::io::gltf {
namespace {

constexpr std::size_t kMaxQuoted = 80;
constexpr std::size_t kMaxPath = 200;
constexpr std::size_t kMaxProblem = 400;  // bytes of one
constexpr std::size_t kMaxProblems = 32;

// References let a small file describe much more than it holds. Shared vertices, instances and widened
// integers stay far below this multiple of the file's size; a file that asks for more is an attack or broken.
constexpr std::uint64_t kMaxUnpacking = 256;
constexpr std::uint64_t kFreeUnpacking = 16u << 20;

std::string one_line(std::string_view text, std::size_t longest) {
  std::string line(text.substr(0, longest));
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  if (text.size() > longest) line += "...";
  return line;
}

std::string digits(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string_view kind_name(Json::Kind kind) {
  switch (kind) {
    case Json::Kind::none:
      return "absent";
    case Json::Kind::null:
      return "null";
    case Json::Kind::boolean:
      return "a boolean";
    case Json::Kind::number:
      return "a number";
    case Json::Kind::string:
      return "a string";
    case Json::Kind::array:
      return "an array";
    case Json::Kind::object:
      return "an object";
  }
  return "unknown";
}

std::string at_path(Json where, const std::string& what) {
  const std::string path = where ? where.path() : std::string();
  return path.empty() ? what : one_line(path, kMaxPath) + ": " + what;
}

}  // namespace

std::string in_quotes(std::string_view text) { return '"' + one_line(text, kMaxQuoted) + '"'; }

void Context::fail(Json where, const std::string& what, ErrorCode code) {
  // The path costs time in the size of the document, so it is not made for what is not kept.
  if (failed()) return;
  const bool has_remedy = what.find(';') != std::string::npos;
  error_ =
      Error{code, at_path(where, has_remedy ? what : what + "; export the model again"), source_.name, 0};
}

void Context::fail(Error error) {
  if (!failed()) error_ = std::move(error);
}

void Context::problem(Json where, const std::string& what) {
  if (problems_.size() < kMaxProblems) {
    problems_.push_back(one_line(at_path(where, what), kMaxProblem));
  } else {
    ++more_problems_;
  }
}

void Context::problem(const std::string& what) { problem(Json(), what); }

std::vector<std::string> Context::take_problems() {
  if (more_problems_ > 0)
    problems_.push_back(std::to_string(more_problems_) + " further problems of these kinds");
  return std::move(problems_);
}

Json Context::member(Json object, std::string_view name, Json::Kind kind) {
  const Json value = object[name];
  if (!value || value.kind() == kind) return value;
  fail(value, "is " + std::string(kind_name(value.kind())) + "; it must be " + std::string(kind_name(kind)));
  return {};
}

std::uint64_t Context::whole(Json object, std::string_view name, std::uint64_t lowest, std::uint64_t highest,
                             std::uint64_t fallback) {
  const Json value = member(object, name, Json::Kind::number);
  if (!value) return fallback;
  const double number = value.number();
  if (number >= static_cast<double>(lowest) && number <= static_cast<double>(highest)) {
    const auto whole = static_cast<std::uint64_t>(number);
    if (static_cast<double>(whole) == number) return whole;
  }
  fail(value, "is " + digits(number) + "; it must be a whole number from " + std::to_string(lowest) + " to " +
                  std::to_string(highest));
  return fallback;
}

double Context::number(Json object, std::string_view name, double fallback) {
  const Json value = member(object, name, Json::Kind::number);
  return value ? value.number() : fallback;
}

bool Context::flag(Json object, std::string_view name, bool fallback) {
  const Json value = member(object, name, Json::Kind::boolean);
  return value ? value.boolean() : fallback;
}

std::string_view Context::text(Json object, std::string_view name) {
  return member(object, name, Json::Kind::string).text();
}

Json Context::object(Json object, std::string_view name) { return member(object, name, Json::Kind::object); }

std::vector<Json> Context::list(Json object, std::string_view name) {
  return member(object, name, Json::Kind::array).items();
}

bool Context::numbers(Json object, std::string_view name, std::span<double> values) {
  const Json value = member(object, name, Json::Kind::array);
  if (!value) return false;
  const std::vector<Json> items = value.items();
  if (items.size() != values.size()) {
    fail(value,
         "has " + std::to_string(items.size()) + " elements; it must have " + std::to_string(values.size()));
    return false;
  }
  for (const Json& item : items) {
    if (item.kind() != Json::Kind::number) {
      fail(item, "is " + std::string(kind_name(item.kind())) + "; it must be a number");
      return false;
    }
  }
  for (std::size_t i = 0; i < items.size(); ++i) values[i] = items[i].number();
  return true;
}

int Context::index(Json value, std::size_t count, std::string_view noun) {
  if (!value) return kNone;
  const double number = value.number();
  count = std::min<std::size_t>(count, std::numeric_limits<int>::max());
  if (value.kind() == Json::Kind::number && number >= 0 && number < static_cast<double>(count)) {
    const int index = static_cast<int>(number);
    if (static_cast<double>(index) == number) return index;
  }
  if (value.kind() == Json::Kind::number) {
    fail(value,
         std::string(noun) + " " + digits(number) + " does not exist; the file has " + std::to_string(count));
  } else {
    fail(value,
         "is " + std::string(kind_name(value.kind())) + "; it must be the index of a " + std::string(noun));
  }
  return kNone;
}

int Context::index(Json object, std::string_view name, std::size_t count, std::string_view noun) {
  return index(object[name], count, noun);
}

void Context::require(Json object, std::string_view name) {
  if (!object[name]) fail(object, "lacks \"" + std::string(name) + "\"");
}

bool Context::allow(std::uint64_t bytes, Json where) {
  if (failed()) return false;
  unpacked_bytes_ += std::min(bytes, UINT64_MAX - unpacked_bytes_);
  if (const Status status = check_limits(source_, 0, unpacked_bytes_); !status) {
    fail(status.error());
  } else if (unpacked_bytes_ > kFreeUnpacking &&
             (unpacked_bytes_ - kFreeUnpacking) / kMaxUnpacking > file_bytes_) {
    fail(where, "the file unpacks to more than " + std::to_string(kMaxUnpacking) +
                    " times its size; join what it repeats, or write repeated data out");
  }
  return !failed();
}

Json extension(Context& context, Json object, std::string_view name) {
  return context.object(context.object(object, "extensions"), name);
}

}  // namespace blysk::io::gltf
