// SPDX-License-Identifier: GPL-3.0-or-later

#include "child_process.h"

#include "Exit_status.h"
#include "Interruption.h"
#include "Stopwatch.h"
#include "temporary_folder.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <system_error>

namespace idt {
namespace {

void write_all(int descriptor, const std::string& text)
{
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = ::write(descriptor, text.data() + done, text.size() - done);
    if (n < 0 && errno != EINTR)
      ::_exit(1);
    if (n > 0)
      done += static_cast<std::size_t>(n);
  }
}

[[noreturn]] void be_the_child(const std::function<void(const Say_function&)>& function, int out,
                               const std::string& folder)
{
  // Not to outlive the parent, nor to share what it writes to.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nothing = ::open("/dev/null", O_WRONLY);
  ::dup2(nothing, STDOUT_FILENO);
  ::dup2(nothing, STDERR_FILENO);
  // What it leaves when it is killed goes with this folder.
  if (!folder.empty())
    ::setenv("TMPDIR", folder.c_str(), 1);
  try {
    function([out](const std::string& line) { write_all(out, line + '\n'); });
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0); // without the destructors and buffers that belong to the parent
}

[[noreturn]] void fail_to_fork()
{
  throw Output_error(std::string("there can be no other process: ") + std::strerror(errno));
}

class Child
{
public:
  explicit Child(const std::function<void(const Say_function&)>& function)
  {
    folder_ = make_temporary_folder();
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
      fail_to_fork();
    process_ = ::fork();
    if (process_ == 0) {
      ::close(ends[0]);
      be_the_child(function, ends[1], folder_);
    }
    const int error_number = errno;
    ::close(ends[1]);
    in_ = ends[0];
    if (process_ < 0) {
      ::close(in_);
      errno = error_number;
      fail_to_fork();
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child()
  {
    ::close(in_);
    std::error_code error;
    if (!folder_.empty())
      std::filesystem::remove_all(folder_, error);
  }

  Child_result listen(double seconds)
  {
    Child_result result;
    std::string rest;
    Stopwatch stopwatch;
    for (;;) {
      struct pollfd in = {in_, POLLIN, 0};
      if (::poll(&in, 1, 50) > 0) {
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
        result.end = is_interrupted() ? Child_result::End::INTERRUPTED
                                      : Child_result::End::TIME_LIMIT;
        ::kill(process_, SIGKILL);
        break;
      }
    }
    if (!wait() && result.end == Child_result::End::DONE)
      result.end = Child_result::End::DIED;
    return result;
  }

private:
  // Returns whether it ended well.
  bool wait()
  {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0)
      if (errno != EINTR)
        return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  std::string folder_;
  pid_t process_ = -1;
  int in_ = -1;
};

class Expendable_child
{
public:
  explicit Expendable_child(const std::function<int()>& function) : folder_(make_temporary_folder())
  {
    // Lest both write what waits there.
    std::cout.flush();
    std::cerr.flush();
    int ends[2];
    process_ = ::pipe2(ends, O_CLOEXEC) == 0 ? ::fork() : -1;
    if (process_ < 0) {
      const int error_number = errno;
      remove_folder();
      errno = error_number;
      fail_to_fork();
    }
    if (process_ == 0) {
      ::close(ends[0]);
      be_the_child(function, ends[1]);
    }
    ::close(ends[1]);
    in_ = ends[0];
  }
  Expendable_child(const Expendable_child&) = delete;
  Expendable_child& operator=(const Expendable_child&) = delete;
  ~Expendable_child()
  {
    ::close(in_);
    remove_folder();
  }

  std::optional<int> wait()
  {
    int result = 0;
    ssize_t n = 0;
    for (bool is_told = false;;) {
      struct pollfd in = {in_, POLLIN, 0};
      if (::poll(&in, 1, 50) > 0) {
        n = ::read(in_, &result, sizeof result);
        if (n >= 0)
          break;
      }
      if (is_interrupted() && !is_told) {
        ::kill(process_, SIGTERM);
        is_told = true;
      }
    }
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR)
      ;
    return n == sizeof result ? std::optional<int>(result) : std::nullopt;
  }

private:
  [[noreturn]] void be_the_child(const std::function<int()>& function, int out)
  {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (!folder_.empty())
      ::setenv("TMPDIR", folder_.c_str(), 1);
    try {
      const int result = function();
      std::cout.flush();
      if (::write(out, &result, sizeof result) != sizeof result)
        ::_exit(1);
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0); // without the destructors that belong to the parent
  }

  void remove_folder() const
  {
    std::error_code error;
    if (!folder_.empty())
      std::filesystem::remove_all(folder_, error);
  }

  std::string folder_; // what it leaves when it is killed goes with this folder
  pid_t process_ = -1;
  int in_ = -1;
};

} // namespace

Child_result run_in_child_process(const std::function<void(const Say_function&)>& function,
                                  double seconds)
{
  return Child(function).listen(seconds);
}

std::optional<int> run_in_expendable_process(const std::function<int()>& function)
{
  Expendable_child child(function);
  return child.wait();
}

} // namespace idt
