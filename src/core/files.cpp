#include "core/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <map>
#include <mutex>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "core/errors.h"

namespace hinge {
namespace {

/// 0, or errno.
int write_all(int fd, std::string_view content) {
    while (!content.empty()) {
        const ssize_t n = ::write(fd, content.data(), content.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return errno ? errno : EIO;
        content.remove_prefix(std::size_t(n));
    }
    return 0;
}

std::string folder_of(const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path();
    return folder.empty() ? "." : folder;
}

const std::string another = "choose another folder with --out";

std::string writing_advice(int error, const std::string& path) {
    const std::string folder = folder_of(path);
    switch (error) {
        case EFBIG: return "raise the limit on a file's size (ulimit -f)";
        case ENOSPC: return "free some space there, or " + another;
        case EDQUOT: return "your quota is used up: delete something, or " + another;
        case ENOENT: return "make the folder " + folder + " first";
        case ENOTDIR: return "a part of the folder's name is a file: " + another;
        case EACCES:
        case EPERM: return "no right to write in the folder " + folder + ": " + another;
        case EROFS: return "the folder " + folder + " can only be read: " + another;
        case EEXIST: return "a file of that name is in the way: move it, or " + another;
        case EISDIR: return "a folder of that name is in the way: move it, or choose another name";
        case ENAMETOOLONG: return "choose a shorter name";
        case EMFILE:
        case ENFILE: return "too many files are open: close some, or raise the limit (ulimit -n)";
        default: return "check the folder " + folder + " and its disk";
    }
}

std::string reading_advice(int error) {
    switch (error) {
        case ENOENT: return "check the name";
        case EACCES: return "no right to read it: ask its owner, or chmod it";
        case EISDIR: return "it is a folder: name a file in it";
        default: return "check its disk";
    }
}

[[noreturn]] void fail_to_write(const std::string& path, int error) {
    throw WriteError(path, std::strerror(error) + ("; " + writing_advice(error, path)));
}
[[noreturn]] void fail_to_read(const std::string& path, int error) {
    throw OutsideError("cannot read " + path + ": " + std::strerror(error) + "; " + reading_advice(error));
}

}  // namespace

void make_folder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (!error) return;
    const bool no_such_place = error.value() == ENOENT;  // those above it are made too
    const std::string advice = no_such_place ? another : writing_advice(error.value(), path);
    throw WriteError(path, std::strerror(error.value()) + ("; " + advice), "cannot make folder");
}

namespace {

/// PATH.PROCESS.part as PATH; "" for another name.
std::string whole_name(const std::string& part) {
    const std::string_view end = ".part";
    if (!std::string_view(part).ends_with(end)) return "";
    std::size_t at = part.size() - end.size();
    const std::size_t last = at;
    while (at > 0 && part[at - 1] >= '0' && part[at - 1] <= '9') --at;
    return at == last || at < 2 || part[at - 1] != '.' ? "" : part.substr(0, at - 1);
}

/// Removes an unfinished file, unless its writer is at work: that one has it locked.
void remove_unfinished(const std::string& part) {
    const int fd = ::open(part.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (fd < 0) return;
    if (::flock(fd, LOCK_EX | LOCK_NB) == 0) ::unlink(part.c_str());
    ::close(fd);
}

/// Removes what writers of this file have left that were killed. A folder is looked through once.
void remove_unfinished_of(const std::string& path) {
    static std::mutex mutex;
    static std::map<std::string, std::multimap<std::string, std::string>> known;  // by folder: whole name, part
    const std::string folder = folder_of(path), name = std::filesystem::path(path).filename();
    const std::lock_guard guard(mutex);
    const auto [place, is_new] = known.try_emplace(folder);
    std::error_code none;
    if (is_new)
        for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
            const std::string part = entry.path().filename();
            if (std::string whole = whole_name(part); !whole.empty()) place->second.emplace(std::move(whole), part);
        }
    const auto [first, last] = place->second.equal_range(name);
    for (auto at = first; at != last; ++at) remove_unfinished(folder + "/" + at->second);
    place->second.erase(first, last);
}

/// A new file that is locked, so that no other writer removes it as unfinished; -1, with errno.
int open_aside(const std::string& aside) {
    for (;;) {
        const int fd = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (fd < 0) return -1;
        struct stat what = {};
        // without locks on this file system nobody removes it
        if (::flock(fd, LOCK_EX) != 0 || ::fstat(fd, &what) != 0 || what.st_nlink > 0) return fd;
        ::close(fd);  // somebody removed it before it was locked
    }
}

}  // namespace

void write_whole(const std::string& path, std::string_view content) {
    remove_unfinished_of(path);
    // two runs may share a folder: the process id keeps their unfinished files apart
    const std::string aside = path + "." + std::to_string(::getpid()) + ".part";
    const int fd = open_aside(aside);
    if (fd < 0) fail_to_write(path, errno);
    int error = write_all(fd, content);  // a network folder may report a full disk only when it is flushed or closed
    if (!error && ::fsync(fd) != 0 && errno != EINVAL && errno != ENOTSUP) error = errno;
    if (::close(fd) != 0 && !error) error = errno;
    if (!error && std::rename(aside.c_str(), path.c_str()) != 0) error = errno;
    if (error) {
        ::unlink(aside.c_str());
        fail_to_write(path, error);
    }
    // the new name too is to be there after a power cut; where a file system has no such thing, it is as good as it
    // gets
    if (const int entry = ::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); entry >= 0)
        ::fsync(entry), ::close(entry);
}

namespace {

void append(const std::string& path, std::string_view content, int create) {
    const int fd = ::open(path.c_str(), O_WRONLY | create | O_APPEND | O_CLOEXEC, 0666);
    if (fd < 0 && errno == ENOENT && !create)
        throw WriteError(path, std::strerror(ENOENT) + std::string("; it was removed while this program wrote to it; "
                                                                   "start the program anew"));
    if (fd < 0) fail_to_write(path, errno);
    const off_t before = ::lseek(fd, 0, SEEK_END);
    int error = write_all(fd, content);
    if (error && before >= 0 && ::ftruncate(fd, before) != 0) error = errno;  // no half of a row
    if (::close(fd) != 0 && !error) error = errno;
    if (error) fail_to_write(path, error);
}

}  // namespace

void append(const std::string& path, std::string_view content) { append(path, content, O_CREAT); }
void append_to(const std::string& path, std::string_view content) { append(path, content, 0); }

std::string read_whole(const std::string& path) {
    // what waits for a writer must not hold us up: a pipe is opened without waiting, and refused
    // nor is a writer to see a reader that goes away at once
    struct stat what = {};
    const auto is_file = [&] { return S_ISREG(what.st_mode) || S_ISDIR(what.st_mode); };
    const bool other = ::stat(path.c_str(), &what) == 0 && !is_file();
    const int fd = other ? -1 : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0 && !other) fail_to_read(path, errno);
    if (other || (::fstat(fd, &what) == 0 && !is_file())) {
        if (fd >= 0) ::close(fd);
        throw OutsideError("cannot read " + path + ": it is a pipe, a socket or a device; name a file");
    }
    std::string content;
    std::vector<char> some(1 << 16);
    ssize_t n;
    while ((n = ::read(fd, some.data(), some.size())) > 0 || (n < 0 && errno == EINTR))
        if (n > 0) content.append(some.data(), std::size_t(n));
    const int error = n < 0 ? errno : 0;
    ::close(fd);
    if (error) fail_to_read(path, error);
    return content;
}

}  // namespace hinge
