// Locks of output folders: one run or study at a time writes to a folder.
#pragma once

#include <string>

namespace hinge {

/// Sharing of a folder with other processes: none, or with tasks of the same study, which write to cases of their own.
enum class Share { alone, with_tasks };

/// Locks the folder, which must exist, until leave_lock or the end of the process and of those that it forks. The
/// kernel keeps the lock (flock), so nothing is left of it after a kill. A process that has the lock may take it again.
/// Throws OutsideError, naming the process, where another one has it. On a network file system it is the lock of a file
/// in the folder, .lock, which other machines see. Without any lock, a line to stderr says so, once.
void take_lock(const std::string& folder, Share share = Share::alone);

/// Throws OutsideError where a folder on the way to that path, which this process has locked, is not there any more: it
/// was removed or moved, and another one may have its name.
void refuse_removed(const std::string& path);

/// Throws like take_lock, and locks nothing. A folder that does not exist is free.
void refuse_locked(const std::string& folder);

/// Releases the lock of this process; a process forked since then still has it.
void leave_lock(const std::string& folder);

}  // namespace hinge
