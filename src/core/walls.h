// Restricts a process by the kernel: it starts no program, and opens nothing outside of given files and folders.
//
// Landlock decides over files and TCP ports, a seccomp filter over system calls. The filter is written here, without
// libseccomp: it is one list of refused calls and five comparisons, needs no package, and Landlock has no library that
// Debian 12 packs. It lists what is refused, not what is allowed: the engine, Lua and glibc call some hundred others,
// which differ between versions of glibc. Calls younger than the list do not exist behind the wall (ENOSYS).
#pragma once

#include <string>
#include <vector>

namespace hinge {

/// Files and folders that a process may still open. Folders count with their contents; missing ones are left out.
struct Reach {
    std::vector<std::string> read;
    std::vector<std::string> write;    ///< folders, in which files may be made and removed too; or single files
    std::vector<std::string> execute;  ///< programs, and the loader that starts them
    bool network = false;              ///< TCP, and sockets in folders that it writes or of other processes
};

/// Files that any program reads, none of the user's: system libraries, time zones, what the C library and the
/// look at free memory open.
std::vector<std::string> system_files();

/// Walls that this kernel has.
struct KernelWalls {
    int landlock = 0;  ///< its version; 0: none
    bool seccomp = false;
};
KernelWalls kernel_walls();

/// The walls that are missing, with what they would be for; "" where both stand.
std::string lacking(const KernelWalls& has);

/// The line for the user where a wall is missing or has a gap; "" where both stand.
std::string missing_walls(const KernelWalls& has);

/// A Landlock rule set as an open file, for restrict_files. -1 where the kernel has no Landlock.
int make_rules(const Reach& reach);

/// Puts this thread, and the threads and processes that it starts from now on, under the rules. It cannot be undone.
/// May be called between fork and exec.
bool restrict_files(int rules) noexcept;

/// Refuses system calls of all threads from now on with EPERM: programs, processes, sockets, other processes' memory
/// and signals, mounts, owners and rights of files, the kernel's settings. It cannot be undone. `may_exec`: the process
/// may become another program, for a child that is about to do so; no second process comes of that. May be called
/// between fork and exec.
bool refuse_calls(bool may_exec = false) noexcept;

/// The loader of this program, which other programs of the system have too; "" for a static one.
std::string program_loader();

}  // namespace hinge
