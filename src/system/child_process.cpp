// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/child_process.h"

#include "system/Exit_status.h"
#include "system/Interruption.h"
#include "system/Stopwatch.h"
#include "system/system_calls.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <system_error>

namespace idt {
namespace {

void write_all(int descriptor, const char* data, std::size_t size)
{
  for (std::size_t done = 0; done < size;) {
    const ssize_t n = ::write(descriptor, data + done, size - done);
    if (n < 0 && errno != EINTR)
      ::_exit(1);
    if (n > 0)
      done += static_cast<std::size_t>(n);
  }
}

// A copy of this process that runs a function, to which it passes the descriptor for its output.
class Child
{
public:
  // \param writes_files whether it may have to clean up files before it ends
  Child(const std::function<void(int out)>& function, bool writes_files)
    : writes_files_(writes_files), unfinished_([&] { start(function); }, [this] { end(); })
  {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child()
  {
    ::close(in_);
    remove_folder();
  }

  // Takes the lines that it writes. \param seconds the time limit for the next line
  Child_result listen(double seconds)
  {
    Child_result result;
    std::string rest;
    Stopwatch stopwatch;
    for (;;) {
      if (has_said_something()) {
        char buffer[4096];
        const ssize_t n = ::read(in_, buffer, sizeof buffer);
        if (n == 0)
          break;
        if (n > 0)
          rest.append(buffer, static_cast<std::size_t>(n));
        for (std::size_t end; (end = rest.find('\n')) != std::string::npos;) {
          result.lines.push_back(rest.substr(0, end));
          rest.erase(0, end + 1);
          stopwatch.restart();
        }
      }
      if (is_interrupted() || stopwatch.seconds() > seconds) {
        result.end = is_interrupted() ? Child_result::End::INTERRUPTED : Child_result::End::TIME_LIMIT;
        ::kill(process_, SIGKILL);
        break;
      }
    }
    if (!wait() && result.end == Child_result::End::DONE)
      result.end = Child_result::End::DIED;
    return result;
  }

  // Takes the one number that it writes, unless it ends before. An interruption is passed on.
  std::optional<int> take_number()
  {
    int number = 0;
    ssize_t n = -1;
    for (bool is_told = false; n < 0;) {
      if (has_said_something())
        n = ::read(in_, &number, sizeof number);
      if (is_interrupted() && !is_told) {
        ::kill(process_, SIGTERM);
        is_told = true;
      }
    }
    wait();
    return n == sizeof number ? std::optional<int>(number) : std::nullopt;
  }

private:
  void start(const std::function<void(int out)>& function)
  {
    folder_ = make_temporary_folder();
    // Otherwise both would write the buffered text.
    std::cout.flush();
    std::cerr.flush();
    int ends[2];
    if (::pipe(ends) != 0)
      fail(errno);
    for (int end : ends)
      ::fcntl(end, F_SETFD, FD_CLOEXEC);
    process_ = ::fork();
    if (process_ == 0) {
      ::close(ends[0]);
      be_the_child(function, ends[1]);
    }
    const int error_number = errno;
    ::close(ends[1]);
    in_ = ends[0];
    if (process_ < 0) {
      ::close(in_);
      fail(error_number);
    }
  }

  // Called while this process is being ended.
  void end() const
  {
    // The first signal asks for an orderly end, the second one does not wait. A signal that arrives before the first
    // was handled is lost.
    bool is_awaited = is_awaited_;
    for (int attempt = 0; writes_files_ && !is_awaited && attempt < 20; ++attempt) {
      ::kill(process_, SIGTERM);
      ::usleep(5000);
      is_awaited = ::waitpid(process_, nullptr, WNOHANG) != 0;
    }
    // The system may need a while to reclaim its memory; there is no need to wait for that.
    if (!is_awaited)
      ::kill(process_, SIGKILL);
    remove_folder();
  }

  [[noreturn]] void be_the_child(const std::function<void(int out)>& function, int out) const
  {
#ifdef __linux__
    // It must not outlive the parent.
    ::prctl(PR_SET_PDEATHSIG, writes_files_ ? SIGTERM : SIGKILL);
#endif
    install_signal_handlers_in_copy();
    if (!writes_files_)
      for (int signal_number : {SIGINT, SIGTERM, SIGHUP})
        ::signal(signal_number, SIG_IGN); // the parent handles it
    if (!folder_.empty())
      ::setenv("TMPDIR", folder_.c_str(), 1);
    try {
      function(out);
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0); // without the destructors and buffers that belong to the parent
  }

  [[noreturn]] void fail(int error_number) const
  {
    remove_folder();
    throw Output_error(std::string("there can be no other process: ") + std::strerror(error_number));
  }

  // It closed the pipe or has ended. Waits a little.
  bool has_said_something() const
  {
    struct pollfd in = {in_, POLLIN, 0};
    return ::poll(&in, 1, 50) > 0;
  }

  // Returns whether it ended well.
  bool wait()
  {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0)
      if (errno != EINTR)
        return false;
    is_awaited_ = true; // by now another process may have its number
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  void remove_folder() const
  {
    std::error_code error;
    if (!folder_.empty())
      std::filesystem::remove_all(folder_, error);
  }

  bool writes_files_;
  std::string folder_; // this folder contains everything that it leaves when it is killed
  pid_t process_ = -1;
  std::atomic<bool> is_awaited_{false};
  int in_ = -1;
  Unfinished unfinished_;
};

} // namespace

Child_result run_in_child_process(const std::function<void(const Say_function&)>& function, double seconds)
{
  Child child(
    [&function](int out) {
      // It must not share the parent's output.
      const int nothing = ::open("/dev/null", O_WRONLY);
      ::dup2(nothing, STDOUT_FILENO);
      ::dup2(nothing, STDERR_FILENO);
      function([out](const std::string& line) { write_all(out, (line + '\n').data(), line.size() + 1); });
    },
    false);
  return child.listen(seconds);
}

std::optional<int> run_in_expendable_process(const std::function<int()>& function)
{
  Child child(
    [&function](int out) {
      const int result = function();
      std::cout.flush();
      write_all(out, reinterpret_cast<const char*>(&result), sizeof result);
    },
    true);
  return child.take_number();
}

} // namespace idt
