#include "core/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>
#include <vector>

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
    if (error == EFBIG) return what + "; raise the limit on a file's size (ulimit -f)";
    if (error == ENOSPC || error == EDQUOT) return what + "; free some space, or choose another folder with --out";
    if (doing == "cannot read") return what;
    if (error == EACCES || error == EROFS || error == EPERM)
        return what + "; choose a folder you may write to with --out";
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
    // the new name too is to be there after a power cut; where a file system has no such thing, it is as good as it
    // gets
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (const int entry = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); entry >= 0)
        ::fsync(entry), ::close(entry);
}

void append(const std::string& path, const std::string& content) {
    const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (fd < 0) throw OutsideError(file_trouble("cannot write", path, errno));
    const off_t before = ::lseek(fd, 0, SEEK_END);
    int error = write_all(fd, content);
    if (error && before >= 0 && ::ftruncate(fd, before) != 0) error = errno;  // no half of a row
    if (::close(fd) != 0 && !error) error = errno;
    if (error) throw OutsideError(file_trouble("cannot write", path, error));
}

std::string read_whole(const std::string& path) {
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd < 0) throw OutsideError(file_trouble("cannot read", path, errno));
    std::string content;
    std::vector<char> some(1 << 16);
    ssize_t n;
    while ((n = ::read(fd, some.data(), some.size())) > 0 || (n < 0 && errno == EINTR))
        if (n > 0) content.append(some.data(), std::size_t(n));
    const int error = n < 0 ? errno : 0;
    ::close(fd);
    if (error) throw OutsideError(file_trouble("cannot read", path, error));
    return content;
}

}  // namespace hinge
