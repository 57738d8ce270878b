// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/system_calls.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <system_error>

namespace idt {

void prepare_standard_streams()
{
  for (int descriptor : {0, 1, 2})
    if (::fcntl(descriptor, F_GETFD) == -1)
      // This is the lowest free descriptor. Only the one for messages is writable.
      static_cast<void>(::open("/dev/null", descriptor == 2 ? O_WRONLY : O_RDONLY));
}

long read_standard_input(char* bytes, unsigned size)
{
  struct pollfd input = {STDIN_FILENO, POLLIN, 0};
  if (::poll(&input, 1, 200) <= 0) {
    errno = EAGAIN;
    return -1;
  }
  const long number = ::read(STDIN_FILENO, bytes, size);
  if (number < 0 && errno == EINTR)
    errno = EAGAIN;
  return number;
}

bool is_error_output_a_terminal() { return ::isatty(STDERR_FILENO) == 1; }

void write_error_output(const std::string& text)
{
  static_cast<void>(::write(STDERR_FILENO, text.data(), text.size()) + 1);
}

int process_number() { return static_cast<int>(::getpid()); }

std::uint64_t peak_memory_bytes()
{
  // On Linux, getrusage() includes the program that this one replaced in its process, that is, a copy of the program
  // that started it.
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (std::uint64_t kibibytes = 0; word == "VmHWM:" && status >> kibibytes)
      return kibibytes * 1024;
  struct rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return static_cast<std::uint64_t>(usage.ru_maxrss);
#else
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
#endif
}

int create_new_file(const std::string& path, bool is_private)
{
  const int descriptor = ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, is_private ? 0600 : 0666);
  if (descriptor < 0)
    return errno;
  ::close(descriptor);
  return 0;
}

int open_pipe_with_reader(const std::string& path) { return ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC); }

void close_descriptor(int descriptor) { ::close(descriptor); }

bool has_lost_reader()
{
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

std::string make_temporary_folder()
{
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
  if (error)
    return std::string();
  std::string path = (parent / "idt-XXXXXX").string();
  return ::mkdtemp(&path[0]) ? path : std::string();
}

// ------------------------------------------------------------------ requests

namespace {

std::atomic<int> to_waiting{-1}, to_be_read{-1};
std::atomic<pid_t> waiting_process{-1};
void (*on_request)() = nullptr;

} // namespace

extern "C" {
static void handle_request(int signal_number)
{
  const int error_number = errno;
  on_request();
  // A copy of the process that has no pipe of its own yet must not wake the first one.
  const unsigned char byte = static_cast<unsigned char>(signal_number);
  if (waiting_process == ::getpid())
    static_cast<void>(::write(to_waiting, &byte, 1) + 1);
  errno = error_number;
}
}

bool prepare_to_wait_for_requests()
{
  int ends[2];
  if (::pipe(ends) != 0)
    return false;
  for (int end : ends)
    ::fcntl(end, F_SETFD, FD_CLOEXEC);
  to_be_read = ends[0];
  to_waiting = ends[1];
  waiting_process = ::getpid();
  return true;
}

void catch_requests(void (*function)(), bool is_once)
{
  on_request = function;
  struct sigaction action = {};
  action.sa_handler = handle_request;
  action.sa_flags = static_cast<int>(SA_RESTART);
  if (is_once)
    action.sa_flags |= static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  for (int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    // Signals that the parent ignores (as nohup does) stay ignored.
    struct sigaction old = {};
    sigaction(signal_number, nullptr, &old);
    if (old.sa_handler != SIG_IGN || signal_number == SIGINT)
      sigaction(signal_number, &action, nullptr);
  }
  struct sigaction ignore = {};
  ignore.sa_handler = SIG_IGN;
  sigemptyset(&ignore.sa_mask);
  sigaction(SIGPIPE, &ignore, nullptr);
  sigaction(SIGXFSZ, &ignore, nullptr);
}

int wait_for_request(long milliseconds)
{
  for (;;) {
    struct pollfd in = {to_be_read, POLLIN, 0};
    const int ready = ::poll(&in, 1, static_cast<int>(milliseconds));
    if (ready == 0)
      return 0;
    unsigned char signal_number = 0;
    if (ready > 0 && ::read(to_be_read, &signal_number, 1) == 1)
      return signal_number;
  }
}

void end_by_request(int kind)
{
  struct sigaction action = {};
  action.sa_handler = SIG_DFL;
  sigemptyset(&action.sa_mask);
  sigaction(kind, &action, nullptr);
  ::kill(::getpid(), kind);
  ::_exit(128 + kind);
}

} // namespace idt
