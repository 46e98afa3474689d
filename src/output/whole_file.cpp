// Whole files, read and written at one go; a file is either the old one or the new one, never half of it.
#include "output/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "core/errors.h"

namespace hinge::output {
namespace {

std::string folder_of(const std::string& path) {
    const auto slash = path.rfind('/');
    if (slash == std::string::npos) return ".";
    return slash == 0 ? "/" : path.substr(0, slash);
}

std::string advice(int code, const std::string& path) {
    const std::string folder = folder_of(path);
    switch (code) {
        case ENOSPC: return "free some space there, or choose an output folder on another disk";
        case EDQUOT: return "your quota is used up: delete something, or choose an output folder elsewhere";
        case ENOENT: return "make the folder " + folder + " first";
        case ENOTDIR: return "a part of the folder name is a file: choose another output folder";
        case EACCES:
        case EPERM: return "no right to write in the folder " + folder + ": choose another output folder";
        case EROFS: return "the folder " + folder + " can only be read: choose another output folder";
        case EISDIR: return "a folder of that name is in the way: move it, or choose another name";
        case ENAMETOOLONG: return "choose a shorter name";
        case EMFILE:
        case ENFILE: return "too many files are open: close some, or raise the limit (ulimit -n)";
        default: return "check the folder " + folder + " and its disk";
    }
}

[[noreturn]] void fail_to_write(int code, const std::string& path) {
    throw OutsideError("cannot write " + path + ": " + std::generic_category().message(code) + "; " +
                       advice(code, path));
}

std::string reading_advice(int code) {
    switch (code) {
        case ENOENT: return "check the name";
        case EACCES: return "no right to read it: ask its owner, or chmod it";
        case EISDIR: return "it is a folder: name a file in it";
        default: return "check its disk";
    }
}

[[noreturn]] void fail_to_read(int code, const std::string& path) {
    throw OutsideError("cannot read " + path + ": " + std::generic_category().message(code) + "; " +
                       reading_advice(code));
}

class Descriptor {
public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int get() const { return fd_; }
    int close() {
        const int result = fd_ < 0 ? 0 : ::close(fd_);
        fd_ = -1;
        return result;
    }

private:
    int fd_;
};

/// 0, or errno. A network folder may report a full disk only on sync or close.
int write_and_sync(int fd_to_own, std::string_view bytes) {
    Descriptor file(fd_to_own);
    while (!bytes.empty()) {
        const ssize_t n = ::write(file.get(), bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    if (::fsync(file.get()) != 0 && errno != EINVAL && errno != ENOTSUP) return errno;
    return file.close() == 0 ? 0 : errno;
}

}  // namespace

void write_whole_file(const std::string& path, std::string_view bytes) {
    // Two runs may share a folder: the process id keeps their unfinished files apart.
    const std::string aside = path + "." + std::to_string(::getpid()) + ".part";
    const int flags = O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW;
    const int fd = ::open(aside.c_str(), flags, 0666);
    if (fd < 0) fail_to_write(errno, path);
    int code = write_and_sync(fd, bytes);
    if (code == 0 && std::rename(aside.c_str(), path.c_str()) != 0) code = errno;
    if (code != 0) {
        ::unlink(aside.c_str());
        fail_to_write(code, path);
    }
}

std::string read_whole_file(const std::string& path) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.get() < 0) fail_to_read(errno, path);
    struct stat about {};
    std::string bytes;
    if (::fstat(file.get(), &about) == 0 && about.st_size > 0) bytes.reserve(static_cast<std::size_t>(about.st_size));
    char chunk[1 << 16];
    for (;;) {
        const ssize_t n = ::read(file.get(), chunk, sizeof chunk);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail_to_read(errno, path);
        if (n == 0) return bytes;
        bytes.append(chunk, static_cast<std::size_t>(n));
    }
}

}  // namespace hinge::output
