// terminal.h - everything that the command says: data to standard output, words to standard error.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "blysk/result.h"

namespace blysk::command {

/// Writes data to standard output, all of it or ErrorCode::output.
[[nodiscard]] Status print(std::string_view text);

/// One line to standard error, without a prefix; control characters are shown as '?'.
void say(std::string_view line);
/// "blysk: warning: ..."
void warn(std::string_view line);
/// "blysk: error: ...", the whole of it one line. Gives the exit status.
int report(const Error& error);

/// Exit status and message for whatever is being thrown: out of memory, or a bug.
int report_exception();

/// Makes signals and lost pipes end the command with nothing half-written, and gives closed standard
/// descriptors a place, so that no picture is opened in theirs.
void prepare_process();

/// Says what goes on once it has lasted a second, on a terminal only; takes it back when done.
class Progress {
 public:
  explicit Progress(bool wanted);  ///< false: stays silent
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void phase(std::string_view what);
  /// Ends it and clears its line, so that other words may be said.
  void finish();

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable wake_;
  std::string what_;
  bool done_ = false;
  std::thread thread_;
};

/// Milliseconds since it was made, started or last asked.
class Stopwatch {
 public:
  void start() { last_ = std::chrono::steady_clock::now(); }
  [[nodiscard]] double lap_ms() {
    const auto now = std::chrono::steady_clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return ms;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace blysk::command
