#include "core/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

#include "core/errors.h"

namespace hinge {
namespace {

/// Writes all of it, or returns errno.
int write_all(int fd, const std::string& content) {
    std::size_t done = 0;
    while (done < content.size()) {
        const ssize_t n = ::write(fd, content.data() + done, content.size() - done);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return errno ? errno : EIO;
        done += std::size_t(n);
    }
    return 0;
}

}  // namespace

std::string file_trouble(const std::string& doing, const std::string& path, int error) {
    std::string what = doing + " " + path + ": " + std::strerror(error);
    if (error == ENOSPC || error == EDQUOT) return what + "; free some space, or choose another folder with --out";
    if (error == EACCES || error == EROFS || error == EPERM) return what + "; choose a folder you may write to with --out";
    return what;
}

void make_folder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw OutsideError(file_trouble("cannot make folder", path, error.value()));
}

void write_whole(const std::string& path, const std::string& content) {
    const std::string aside = path + ".part";
    const int fd = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (fd < 0) throw OutsideError(file_trouble("cannot write", path, errno));
    int error = write_all(fd, content);
    if (!error && ::fsync(fd) != 0 && errno != EINVAL) error = errno;
    if (::close(fd) != 0 && !error) error = errno;
    if (!error && std::rename(aside.c_str(), path.c_str()) != 0) error = errno;
    if (error) {
        ::unlink(aside.c_str());
        throw OutsideError(file_trouble("cannot write", path, error));
    }
}

void append(const std::string& path, const std::string& content) {
    const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (fd < 0) throw OutsideError(file_trouble("cannot write", path, errno));
    int error = write_all(fd, content);
    if (::close(fd) != 0 && !error) error = errno;
    if (error) throw OutsideError(file_trouble("cannot write", path, error));
}

}  // namespace hinge
