#include "record/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <thread>
#include <utility>

#include "core/errors.h"

namespace hinge {
namespace {

using FileNumber = std::pair<dev_t, ino_t>;

/// The open files that hold this process's locks; -1 where the file system has none. Processes that it forks have the
/// same files, and so the same locks.
std::map<FileNumber, int>& locks() {
    static std::map<FileNumber, int> all;
    return all;
}

/// The folders of these locks, by their whole path.
std::map<std::string, FileNumber>& folders() {
    static std::map<std::string, FileNumber> all;
    return all;
}

std::string whole_path(const std::string& folder) {
    std::error_code none;
    std::string path = std::filesystem::absolute(folder, none).lexically_normal();
    while (path.size() > 1 && path.back() == '/') path.pop_back();
    return path;
}

std::optional<FileNumber> place_of(const std::string& folder) {
    struct stat info = {};
    if (::stat(folder.c_str(), &info) != 0) return std::nullopt;
    return FileNumber{info.st_dev, info.st_ino};
}

/// The process that has a lock on that file, from the kernel's list; 0 where it is not known.
long holder_of(const FileNumber& place) {
    std::ifstream list("/proc/locks");
    std::string line;
    char wanted[64];
    std::snprintf(wanted, sizeof wanted, ":%lu ", static_cast<unsigned long>(place.second));
    while (std::getline(list, line)) {
        long process = 0;
        if (line.find(" FLOCK ") != std::string::npos && line.find(wanted) != std::string::npos &&
            std::sscanf(line.c_str(), "%*s FLOCK %*s %*s %ld", &process) == 1 && process > 0)
            return process;
    }
    return 0;
}

/// " (process 123: hinge run frame.lua)"
std::string text_of(long process) {
    if (process <= 0) return "";
    std::ifstream file("/proc/" + std::to_string(process) + "/cmdline", std::ios::binary);
    std::string words((std::istreambuf_iterator<char>(file)), {});
    while (!words.empty() && words.back() == '\0') words.pop_back();
    for (char& c : words)
        if (c == '\0' || static_cast<unsigned char>(c) < ' ') c = ' ';
    if (words.size() > 120) words = words.substr(0, 117) + "...";
    return " (process " + std::to_string(process) + (words.empty() ? "" : ": " + words) + ")";
}

void tell_no_lock(const std::string& folder, int error) {
    static bool told = false;
    if (!std::exchange(told, true))
        std::fprintf(stderr,
                     "warning: %s cannot be locked (%s), so a second run that writes there would not be noticed\n",
                     folder.c_str(), std::strerror(error));
}

/// 0, EWOULDBLOCK where somebody else has it, or another errno. One that was just killed may take a moment to go.
int lock(int file, Share share) {
    const int kind = (share == Share::alone ? LOCK_EX : LOCK_SH) | LOCK_NB;
    for (int tries = 0;; ++tries) {
        if (::flock(file, kind) == 0) return 0;
        if (errno == EINTR) continue;
        if (errno != EWOULDBLOCK || tries == 4) return errno;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
}

/// Whether other machines may write there too.
bool on_network(const std::string& folder) {
    struct statfs info = {};
    if (::statfs(folder.c_str(), &info) != 0) return false;
    switch (static_cast<std::uint32_t>(info.f_type)) {
        case 0x6969:      // NFS
        case 0xff534d42:  // CIFS
        case 0xfe534d42:  // SMB 2
        case 0x0bd00bd0:  // Lustre
        case 0x47504653:  // GPFS
        case 0x19830326:  // BeeGFS
        case 0x00c36400:  // Ceph
        case 0x65735546:  // FUSE
            return true;
        default: return false;
    }
}

/// An open file that holds the lock, or -1 with the error.
int open_locked(const std::string& path, int flags, Share share, int& error) {
    const int file = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
    if (file < 0) return error = errno, -1;
    error = lock(file, share);
    if (error == 0) return file;
    ::close(file);
    return -1;
}

}  // namespace

void take_lock(const std::string& folder, Share share) {
    const auto place = place_of(folder);
    if (!place || locks().count(*place) > 0) return;
    // The folder itself, so that nothing is left of the lock. Other machines see only that of a file.
    const std::string file = folder + "/.lock";
    int error = 0, held = -1;
    if (on_network(folder)) held = open_locked(file, O_RDWR | O_CREAT | O_NOFOLLOW, share, error);
    if (held < 0 && error != EWOULDBLOCK) held = open_locked(folder, O_RDONLY | O_DIRECTORY, share, error);
    if (error == EWOULDBLOCK) {
        const auto locked = place_of(file);
        const long first = locked ? holder_of(*locked) : 0;
        throw OutsideError("another run or study writes to " + folder + text_of(first > 0 ? first : holder_of(*place)) +
                           "; wait for its end, or give another folder with --out");
    }
    if (held < 0) tell_no_lock(folder, error);
    locks()[*place] = held;
    folders().insert_or_assign(whole_path(folder), *place);
}

void refuse_removed(const std::string& path) {
    if (folders().empty()) return;
    const std::string whole = whole_path(path);
    for (const auto& [folder, place] : folders()) {
        if (!whole.starts_with(folder) || (whole.size() > folder.size() && whole[folder.size()] != '/')) continue;
        if (place_of(folder) != place)
            throw OutsideError("cannot write " + path + ": the folder " + folder +
                               " was removed or moved while this program wrote to it; what was written is there, if "
                               "it was moved; start the program anew for the rest");
    }
}

void refuse_locked(const std::string& folder) {
    const auto place = place_of(folder);
    if (!place || locks().count(*place) > 0) return;
    take_lock(folder);
    leave_lock(folder);
}

void leave_lock(const std::string& folder) {
    const auto place = place_of(folder);
    const auto at = place ? locks().find(*place) : locks().end();
    if (at == locks().end()) return;
    if (at->second >= 0) ::close(at->second);
    std::erase_if(folders(), [&](const auto& one) { return one.second == *place; });
    locks().erase(at);
}

}  // namespace hinge
