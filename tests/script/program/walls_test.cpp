// The kernel's walls around a process (src/core/walls.h), tried from C++: what is refused behind them, and what
// still works. Ends with 77, a skipped test, where the kernel lacks one of the two.
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>

#include "core/walls.h"

namespace fs = std::filesystem;
using namespace hinge;

namespace {

int failures = 0;

void expect(bool good, const std::string& what) {
    if (!good) ++failures, std::printf("FAILED  %s (%s)\n", what.c_str(), std::strerror(errno));
}

/// A call that must fail in this way.
void refused(long result, const std::string& what, int with = EPERM) {
    expect(result == -1 && errno == with, what + " is refused");
}

int open_file(const fs::path& path, int flags) { return ::open(path.c_str(), flags | O_CLOEXEC, 0666); }

void try_programs() {
    char* const words[] = {const_cast<char*>("true"), nullptr};
    refused(::execv("/bin/true", words), "execve");
    refused(::syscall(SYS_execveat, AT_FDCWD, "/bin/true", words, nullptr, 0), "execveat");
    refused(::fork(), "fork");
    refused(::syscall(SYS_clone3, nullptr, 0), "clone3", ENOSYS);
    refused(::syscall(SYS_clone, CLONE_VM | CLONE_VFORK | SIGCHLD, 0, 0, 0, 0), "clone without CLONE_THREAD");
    expect(std::system("true") != 0, "system() starts nothing");
    refused(::ptrace(PTRACE_ATTACH, ::getppid(), nullptr, nullptr), "ptrace");
    refused(::kill(::getppid(), 0), "kill");
    refused(::syscall(SYS_pidfd_open, ::getppid(), 0), "pidfd_open");
    refused(::syscall(SYS_process_vm_readv, ::getppid(), nullptr, 0, nullptr, 0, 0), "process_vm_readv");
}

void try_network() {
    sockaddr_in other = {};
    other.sin_family = AF_INET, other.sin_port = htons(80), other.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    refused(::connect(0, reinterpret_cast<sockaddr*>(&other), sizeof other), "connect");
    for (const int kind : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK, AF_VSOCK})
        refused(::socket(kind, SOCK_STREAM, 0), "socket of family " + std::to_string(kind));
    int pair[2];
    refused(::socketpair(AF_UNIX, SOCK_STREAM, 0, pair), "socketpair");
    refused(::syscall(SYS_io_uring_setup, 1, nullptr), "io_uring");
}

void try_files(const fs::path& own, const fs::path& other) {
    refused(open_file("/etc/passwd", O_RDONLY), "reading elsewhere", EACCES);
    refused(open_file(other / "there", O_RDONLY), "reading beside the folder", EACCES);
    refused(open_file(other / "there", O_WRONLY | O_TRUNC), "writing beside the folder", EACCES);
    refused(open_file(other / "new", O_WRONLY | O_CREAT), "a new file beside the folder", EACCES);
    refused(open_file(own / "link", O_WRONLY), "writing through a link", EACCES);
    refused(open_file(own / ".." / "other" / "new", O_WRONLY | O_CREAT), "a way with ..", EACCES);
    refused(::mkdir((other / "folder").c_str(), 0777), "a folder elsewhere", EACCES);
    refused(::unlink((other / "there").c_str()), "removing elsewhere", EACCES);
    refused(::truncate((other / "there").c_str(), 0), "truncate");
    refused(::chmod((other / "there").c_str(), 0777), "chmod");
    refused(::chown((other / "there").c_str(), 1, 1), "chown");
    refused(::symlink("/etc/passwd", (own / "new link").c_str()), "a new link", EACCES);
    refused(::rename((own / "file").c_str(), (other / "file").c_str()), "moving out", EACCES);
    refused(::link((other / "there").c_str(), (own / "hard link").c_str()), "linking in", EXDEV);
    refused(open_file("/proc/self/mem", O_RDWR), "its own memory as a file", EACCES);
    refused(open_file("/proc/" + std::to_string(::getppid()) + "/environ", O_RDONLY), "another's environment", EACCES);
    refused(::mount("none", own.c_str(), "tmpfs", 0, nullptr), "mount");
    refused(::chroot(own.c_str()), "chroot");
    const rlimit more = {RLIM_INFINITY, RLIM_INFINITY};
    refused(::setrlimit(RLIMIT_DATA, &more), "setrlimit");
    char letter = 'x';
    refused(::ioctl(0, TIOCSTI, &letter), "words for the terminal");
    refused(::syscall(452, AT_FDCWD, other.c_str(), 0777, 0), "a call younger than the list", ENOSYS);
}

void try_what_is_left(const fs::path& own) {
    const int file = open_file(own / "file", O_RDWR | O_CREAT);
    expect(file >= 0 && ::write(file, "abc", 3) == 3 && ::ftruncate(file, 1) == 0, "a file in the folder");
    expect(::mkdir((own / "frames").c_str(), 0777) == 0, "a folder in the folder");
    expect(::rename((own / "file").c_str(), (own / "frames/file").c_str()) == 0, "moving within the folder");
    expect(::unlink((own / "frames/file").c_str()) == 0, "removing in the folder");
    int sum = 0;
    std::thread([&] { sum = 1; }).join();
    expect(sum == 1, "threads");
    expect(::mmap(nullptr, 1 << 20, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED,
           "memory");
    rlimit limit = {};
    expect(::getrlimit(RLIMIT_DATA, &limit) == 0, "reading a limit");
    expect(::kill(::getpid(), 0) == 0, "signals to itself");
    int inside = 0;  // a thread that was started later is behind the walls, too
    std::thread([&] { inside = open_file("/etc/passwd", O_RDONLY); }).join();
    expect(inside < 0, "a thread is behind the walls");
}

void try_texts() {
    const auto has = [](const KernelWalls& w, const char* text) {
        const std::string line = missing_walls(w);
        return line.find(text) != std::string::npos && line.find('\n') == std::string::npos;
    };
    expect(missing_walls({1, true}).empty(), "nothing is said where both walls stand");
    expect(has({0, true}, "this kernel lacks Landlock"), "one line where there is no Landlock");
    expect(has({1, false}, "this kernel lacks seccomp"), "one line where there is no seccomp");
    expect(has({0, false}, "and seccomp"), "one line where there is neither");
}

}  // namespace

int main() {
    try_texts();
    const KernelWalls stand = kernel_walls();
    if (!missing_walls(stand).empty()) {
        std::printf("SKIPPED, nothing was tried: %s\n", missing_walls(stand).c_str());
        return failures ? 1 : 77;
    }
    char name[] = "/tmp/hinge-walls-XXXXXX";
    if (!::mkdtemp(name)) return std::perror("mkdtemp"), 1;
    const fs::path folder = name, own = folder / "own", other = folder / "other";
    fs::create_directory(own), fs::create_directory(other);
    std::fclose(std::fopen((other / "there").c_str(), "w"));
    fs::create_symlink(other / "there", own / "link");
    const pid_t child = ::fork();
    if (child == 0) {
        expect(restrict_files(make_rules({{"/usr/lib", "/lib"}, {own.string()}, {}})), "Landlock stands");
        expect(refuse_calls(), "seccomp stands");
        try_what_is_left(own);
        std::fclose(std::fopen((own / "file").c_str(), "w"));
        try_programs(), try_network(), try_files(own, other);
        std::fflush(stdout);
        ::_exit(failures != 0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    expect(WIFEXITED(status) && WEXITSTATUS(status) == 0, "all of the above");
    expect(fs::exists(other / "there") && fs::file_size(other / "there") == 0 && !fs::exists(other / "new"),
           "nothing elsewhere has changed");
    fs::remove_all(folder);
    if (!failures) std::printf("ok, with Landlock %d\n", stand.landlock);
    return failures != 0;
}
