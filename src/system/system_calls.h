// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// System calls for which C++ has no function; other processes are in child_process.h. There is a source for POSIX and
// one for Windows.

#ifndef IDT_SYSTEM_CALLS_H
#define IDT_SYSTEM_CALLS_H

#include <cstdint>
#include <string>

namespace idt {

// Makes the standard streams binary, and occupies the descriptors of closed ones, so that no file opened later is taken
// for one of them; writing to them still fails.
void prepare_standard_streams();

// Reads at most `size` bytes from the standard input.
// \return their number; 0 at the end; -1 with errno EAGAIN if nothing came for a moment, so that the caller can ask
//   whether to go on
long read_standard_input(char* bytes, unsigned size);

bool is_error_output_a_terminal();

// Writes to the standard error, whatever other threads do.
void write_error_output(const std::string& text);

int process_number();

// The peak memory of the process so far, for all inputs together.
std::uint64_t peak_memory_bytes();

// Creates a new, empty file. \param is_private whether only its owner may read it
// \return 0, or errno
int create_new_file(const std::string& path, bool is_private);

// Opens a named pipe for writing if a program reads from it; does not wait for one.
// \return a descriptor, or -1 with errno ENXIO if there is no reader
int open_pipe_with_reader(const std::string& path);
void close_descriptor(int descriptor);
// Whether the standard output is a pipe from which no program reads any more.
bool has_lost_reader();

// A new folder for this process alone; empty if it cannot be created.
std::string make_temporary_folder();

// Makes each request for an end, by Ctrl-C or another program, call a function, which may do only what signal handlers
// may do, and then wake wait_for_request(). Requests that the parent of this process ignores stay ignored. Broken pipes
// and file size limits become write errors.
// \param is_once whether the second request of a kind ends the process
void catch_requests(void (*function)(), bool is_once);

// Must be called before, and again in a copy of this process. \return false if it is impossible to wait for requests
bool prepare_to_wait_for_requests();
// Returns the kind of the next request, which is positive, or 0 if there is none in time. \param milliseconds negative:
// waits forever
int wait_for_request(long milliseconds);
// Ends the process as a request of this kind ends one that does not catch it.
[[noreturn]] void end_by_request(int kind);

} // namespace idt

#endif // IDT_SYSTEM_CALLS_H
