#include "terminal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>

#include "blysk/image.h"
#include "text.h"

namespace blysk::command {
namespace {

constexpr auto kPatience = std::chrono::seconds(1);
constexpr auto kFrame = std::chrono::milliseconds(100);

// Writes all of it; 0 or the errno of what went wrong.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

bool on_terminal() { return ::isatty(STDERR_FILENO) == 1; }

bool in_colour() {
  const char* no_color = std::getenv("NO_COLOR");
  const char* term = std::getenv("TERM");
  const bool dumb = term == nullptr || std::string_view(term) == "dumb";
  return on_terminal() && !dumb && (no_color == nullptr || *no_color == '\0');
}

void say_prefixed(std::string_view kind, std::string_view colour, std::string_view line) {
  std::string all = "blysk: ";
  all += in_colour() ? std::string(colour) + std::string(kind) + "\033[0m" : std::string(kind);
  write_all(STDERR_FILENO, all + ": " + printable(line) + "\n");
}

constexpr std::string_view kClearLine = "\r\033[K";
// A line of progress stands on the terminal; it is being written; the process ends and none may be written.
std::atomic<bool> line_shown = false, line_in_work = false, ending = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void show_line(const std::string& line) {
  line_in_work = true;
  if (!ending) write_all(STDERR_FILENO, line);
  line_in_work = false;
}

// Only calls that are safe in a signal handler.
extern "C" void end_by_signal(int signal_number) {
  discard_unfinished_pictures();
  if (line_shown) {
    constexpr int kPatientLooks = 100000000;  // a stopped terminal would take for ever
    ending = true;
    for (int look = 0; line_in_work && look < kPatientLooks; ++look) continue;
    write_all(STDERR_FILENO, kClearLine);
  }
  // Whoever read our output has gone: what remains cannot be written, and nobody wants to hear of it.
  ::_exit(signal_number == SIGPIPE ? static_cast<int>(ErrorCode::output) : 128 + signal_number);
}

}  // namespace

Status print(std::string_view text) {
  const int error = write_all(STDOUT_FILENO, text);
  if (error == 0) return Done{};
  return Error{.code = ErrorCode::output,
               .message = "cannot be written: " + std::generic_category().message(error),
               .source = "standard output"};
}

void say(std::string_view line) { write_all(STDERR_FILENO, printable(line) + "\n"); }
void warn(std::string_view line) { say_prefixed("warning", "\033[1;33m", line); }

int report(const Error& error) {
  say_prefixed("error", "\033[1;31m", error.text());
  return static_cast<int>(error.code);
}

int report_exception() {
  Error error = {.code = ErrorCode::internal,
                 .message = "a bug in blysk, please report it with the command line and the model",
                 .source = ""};
  try {
    throw;
  } catch (const std::bad_alloc&) {
    error.code = ErrorCode::limit;
    error.message = "there is not enough memory; try a smaller --size, a smaller model, or fewer --threads";
  } catch (const std::system_error& refusal) {  // of the system, to start a thread
    error.code = ErrorCode::limit;
    error.message = std::string("the system refuses: ") + refusal.what() + "; try fewer --threads";
  } catch (const std::exception& exception) {
    error.message += std::string(": ") + exception.what();
  } catch (...) {
  }
  return report(error);
}

void prepare_process() {
  // Opened the wrong way round: what is read or written there fails, as on a closed descriptor.
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
    if (::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) != descriptor) ::_exit(70);
  }

  struct sigaction action = {};
  action.sa_handler = end_by_signal;
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    struct sigaction before = {};
    ::sigaction(signal_number, nullptr, &before);
    // nohup and background jobs have these ignored, and mean it.
    const bool ignored = before.sa_handler == SIG_IGN && signal_number != SIGPIPE;
    if (!ignored) ::sigaction(signal_number, &action, nullptr);
  }

  // An exception in a thread ends here.
  std::set_terminate([] {
    discard_unfinished_pictures();
    ::_exit(std::current_exception() ? report_exception() : static_cast<int>(ErrorCode::internal));
  });
}

Progress::Progress(bool wanted) {
  if (wanted && on_terminal()) thread_ = std::thread([this] { run(); });
}

Progress::~Progress() { finish(); }

void Progress::phase(std::string_view what) {
  const std::lock_guard lock(mutex_);
  what_ = printable(what);
}

void Progress::finish() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  wake_.notify_one();
  thread_.join();
  if (line_shown.exchange(false)) write_all(STDERR_FILENO, kClearLine);
}

void Progress::run() {
  constexpr std::string_view kSpinner = "|/-\\";
  sigset_t all;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, nullptr);  // what ends the process may wait for this thread
  std::unique_lock lock(mutex_);
  if (wake_.wait_for(lock, kPatience, [this] { return done_; })) return;
  line_shown = true;
  for (std::size_t turn = 0; !done_; ++turn) {
    const std::string_view arm = kSpinner.substr(turn % kSpinner.size(), 1);
    show_line(std::string(kClearLine) + std::string(arm) + " " + what_ + " ...");
    wake_.wait_for(lock, kFrame, [this] { return done_; });
  }
}

}  // namespace blysk::command
