// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// There are no copies of a process: work that CORE could end or keep from ending runs in this one.

#include "system/child_process.h"
#include "system/system_calls.h"

#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
// After the former.
#include <psapi.h>

#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <sys/stat.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <system_error>

namespace idt {

void prepare_standard_streams()
{
  for (int descriptor : {0, 1, 2})
    ::_setmode(descriptor, _O_BINARY);
}

// Waits as long as it takes: the thread that watches for requests ends the process meanwhile.
long read_standard_input(char* bytes, unsigned size) { return ::_read(0, bytes, size); }

bool is_error_output_a_terminal() { return ::_isatty(2) != 0; }

void write_error_output(const std::string& text)
{
  static_cast<void>(::_write(2, text.data(), static_cast<unsigned>(text.size())));
}

int process_number() { return ::_getpid(); }

std::uint64_t peak_memory_bytes()
{
  PROCESS_MEMORY_COUNTERS counters = {};
  ::GetProcessMemoryInfo(::GetCurrentProcess(), &counters, sizeof counters);
  return counters.PeakWorkingSetSize;
}

int create_new_file(const std::string& path, bool)
{
  const int descriptor = ::_open(path.c_str(), _O_CREAT | _O_EXCL | _O_WRONLY | _O_BINARY, _S_IREAD | _S_IWRITE);
  if (descriptor < 0)
    return errno;
  ::_close(descriptor);
  return 0;
}

int open_pipe_with_reader(const std::string&)
{
  errno = ENXIO;
  return -1;
}

void close_descriptor(int descriptor) { ::_close(descriptor); }

bool has_lost_reader() { return false; }

std::string make_temporary_folder()
{
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
  for (int attempt = 0; !error && attempt < 1000; ++attempt) {
    const std::filesystem::path path = parent / ("idt-" + std::to_string(::_getpid()) + "-" + std::to_string(attempt));
    if (std::filesystem::create_directory(path, error))
      return path.string();
  }
  return std::string();
}

// ------------------------------------------------------------------ requests

namespace {

void (*on_request)() = nullptr;
bool has_waiting = false;
std::atomic<int> number_of_requests{0};
HANDLE requests = nullptr;

// Called in a thread of its own.
BOOL WINAPI handle_request(DWORD)
{
  on_request();
  if (!has_waiting)
    return ++number_of_requests == 1 ? TRUE : FALSE;
  ::ReleaseSemaphore(requests, 1, nullptr);
  return TRUE;
}

} // namespace

bool prepare_to_wait_for_requests()
{
  requests = ::CreateSemaphoreA(nullptr, 0, 64, nullptr);
  return requests != nullptr;
}

void catch_requests(void (*function)(), bool is_once)
{
  on_request = function;
  has_waiting = !is_once;
  ::SetConsoleCtrlHandler(handle_request, TRUE);
}

int wait_for_request(long milliseconds)
{
  return ::WaitForSingleObject(requests, milliseconds < 0 ? INFINITE : static_cast<DWORD>(milliseconds)) ==
             WAIT_OBJECT_0
           ? 1
           : 0;
}

void end_by_request(int) { ::TerminateProcess(::GetCurrentProcess(), STATUS_CONTROL_C_EXIT), std::abort(); }

// ----------------------------------------------------------- other processes

Child_result run_in_child_process(const std::function<void(const Say_function&)>& function, double)
{
  Child_result result;
  try {
    function([&result](const std::string& line) { result.lines.push_back(line); });
  } catch (...) {
    result.end = Child_result::End::DIED;
  }
  return result;
}

std::optional<int> run_in_expendable_process(const std::function<int()>& function) { return function(); }

} // namespace idt
