// Output folders that one run or study at a time writes to.
#pragma once

#include <string>

namespace hinge::script {

/// Who may write to a folder beside this process: nobody, or tasks of the same study, which write to cases of their
/// own.
enum class Share { alone, with_tasks };

/// Takes the folder, which must be there, until leave_lock or the end of the process and of those that it forks. The
/// kernel keeps the lock (flock), so nothing is left of it after a kill. A process that has the folder takes it again
/// at will. Throws OutsideError, naming the process, where another one has it. On a
/// network file system it is the lock of a file in the folder, .lock, which other machines see. Where no lock can be
/// had, a line to stderr says so, once.
void take_lock(const std::string& folder, Share share = Share::alone);

/// Throws as take_lock does, and takes nothing. A folder that is not there is free.
void refuse_locked(const std::string& folder);

/// This process leaves the folder; one that was forked since it was taken still has it.
void leave_lock(const std::string& folder);

}  // namespace hinge::script
