#include "core/walls.h"

#include <fcntl.h>
#include <link.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace hinge {
namespace {

// ---- Landlock -------------------------------------------------------------------------------------------------------
// Numbers and structures as in linux/landlock.h, of which Debian 12 has the second of today's versions. All
// architectures share them.

constexpr long create_ruleset = 444, add_rule = 445, restrict_self = 446;
constexpr unsigned version_flag = 1, path_beneath = 1;

struct RulesetAttributes {
    std::uint64_t files, network, scoped;
};
struct [[gnu::packed]] PathBeneath {
    std::uint64_t allowed;
    std::int32_t parent;
};

enum Access : std::uint64_t {
    execute = 1u << 0,
    write_file = 1u << 1,
    read_file = 1u << 2,
    read_dir = 1u << 3,
    remove_dir = 1u << 4,
    remove_file = 1u << 5,
    make_dir = 1u << 7,
    make_reg = 1u << 8,
    make_socket = 1u << 9,
    all_of_first = (1u << 13) - 1,  ///< with devices, sockets, pipes and links, which nobody here makes
    move = 1u << 13,                ///< between folders; version 2
    truncate = 1u << 14,            ///< version 3
    device_ioctl = 1u << 15,        ///< version 5
};
constexpr std::uint64_t of_single_files = execute | write_file | read_file | truncate | device_ioctl,
                        reading = read_file | read_dir,
                        writing =
                            reading | write_file | remove_dir | remove_file | make_dir | make_reg | move | truncate;

int landlock_version() {
    const long version = ::syscall(create_ruleset, nullptr, 0, version_flag);
    return version > 0 ? int(version) : 0;
}

void allow(int rules, const std::string& path, std::uint64_t access) {
    const int file = ::open(path.c_str(), O_PATH | O_CLOEXEC);
    if (file < 0) return;
    struct stat what = {};
    if (::fstat(file, &what) == 0) {
        const PathBeneath rule = {S_ISDIR(what.st_mode) ? access : access & of_single_files, file};
        ::syscall(add_rule, rules, path_beneath, &rule, 0);
    }
    ::close(file);
}

// ---- seccomp --------------------------------------------------------------------------------------------------------

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0;  // no wall of this kind
#endif

constexpr std::uint32_t newest = 450;  ///< the last call that this list was made with: Linux 6.1

constexpr int refused[] = {
    // processes; clone and execve are looked at below
    SYS_execveat,
#ifdef SYS_fork
    SYS_fork,
    SYS_vfork,
#endif
    // other processes
    SYS_ptrace,
    SYS_process_vm_readv,
    SYS_process_vm_writev,
    SYS_process_madvise,
    SYS_pidfd_open,
    SYS_pidfd_getfd,
    SYS_pidfd_send_signal,
    SYS_tkill,
    SYS_rt_sigqueueinfo,
    SYS_rt_tgsigqueueinfo,
    SYS_kcmp,
    SYS_setpriority,
    SYS_setns,
    SYS_unshare,
    // the network, and what is like it; sockets that are open already go on
    SYS_socket,
    SYS_socketpair,
    SYS_connect,
    SYS_bind,
    SYS_listen,
    SYS_shmget,
    SYS_shmat,
    SYS_semget,
    SYS_msgget,
    SYS_mq_open,
    // what goes round the filter, or round Landlock
    SYS_io_uring_setup,
    SYS_io_uring_enter,
    SYS_io_uring_register,
    SYS_open_by_handle_at,
    SYS_name_to_handle_at,
    SYS_truncate,
    SYS_fchmod,
    SYS_fchmodat,
    SYS_fchown,
    SYS_fchownat,
    SYS_utimensat,
    SYS_setxattr,
    SYS_lsetxattr,
    SYS_fsetxattr,
    SYS_removexattr,
    SYS_lremovexattr,
    SYS_fremovexattr,
    SYS_inotify_init1,
    SYS_fanotify_init,
#ifdef SYS_chmod
    SYS_chmod,
    SYS_chown,
    SYS_lchown,
    SYS_utime,
    SYS_utimes,
    SYS_futimesat,
    SYS_inotify_init,
#endif
    // the system
    SYS_mount,
    SYS_umount2,
    SYS_move_mount,
    SYS_open_tree,
    SYS_mount_setattr,
    SYS_fsopen,
    SYS_fsmount,
    SYS_fsconfig,
    SYS_fspick,
    SYS_chroot,
    SYS_pivot_root,
    SYS_swapon,
    SYS_swapoff,
    SYS_reboot,
    SYS_kexec_load,
    SYS_kexec_file_load,
    SYS_init_module,
    SYS_finit_module,
    SYS_delete_module,
    SYS_bpf,
    SYS_perf_event_open,
    SYS_userfaultfd,
    SYS_keyctl,
    SYS_add_key,
    SYS_request_key,
    SYS_settimeofday,
    SYS_clock_settime,
    SYS_clock_adjtime,
    SYS_adjtimex,
    SYS_sethostname,
    SYS_setdomainname,
    SYS_acct,
    SYS_quotactl,
    SYS_quotactl_fd,
    SYS_syslog,
    SYS_vhangup,
    SYS_personality,
#ifdef SYS_ioperm
    SYS_ioperm,
    SYS_iopl,
    SYS_modify_ldt,
#endif
    // who one is, and the limits
    SYS_setuid,
    SYS_setgid,
    SYS_setreuid,
    SYS_setregid,
    SYS_setresuid,
    SYS_setresgid,
    SYS_setgroups,
    SYS_setfsuid,
    SYS_setfsgid,
    SYS_capset,
    SYS_setrlimit,
};

constexpr std::uint32_t allowed = SECCOMP_RET_ALLOW, no_right = SECCOMP_RET_ERRNO | EPERM,
                        no_such_call = SECCOMP_RET_ERRNO | ENOSYS;

/// A program for the kernel's filter machine, which jumps forward only and by at most 255.
class Filter {
public:
    void load(std::size_t offset) { add(BPF_LD | BPF_W | BPF_ABS, std::uint32_t(offset)); }
    void load_argument(int i, bool high = false) {
        load(offsetof(seccomp_data, args) + std::size_t(i) * 8 + (high ? 4 : 0));  // little endian
    }
    void end(std::uint32_t result) { add(BPF_RET | BPF_K, result); }
    /// Goes on, or ends where what was loaded is that value (is_not: another one).
    void end_if(std::uint32_t value, std::uint32_t result, bool is_not = false) {
        add(BPF_JMP | BPF_JEQ | BPF_K, value, is_not ? 1 : 0, is_not ? 0 : 1), end(result);
    }
    void end_if_above(std::uint32_t value, std::uint32_t result) {
        add(BPF_JMP | BPF_JGT | BPF_K, value, 0, 1), end(result);
    }
    void end_without(std::uint32_t bits, std::uint32_t result) {
        add(BPF_JMP | BPF_JSET | BPF_K, bits, 1, 0), end(result);
    }
    /// What follows, up to `done`, is of that call alone.
    void begin_call(int call) { begun_ = n_, add(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(call)); }
    void done() { end(allowed), code_[begun_].jf = std::uint8_t(n_ - begun_ - 1); }
    sock_fprog program() { return {static_cast<unsigned short>(n_), code_}; }

private:
    void add(int what, std::uint32_t value, int yes = 0, int no = 0) {
        code_[n_++] = {std::uint16_t(what), std::uint8_t(yes), std::uint8_t(no), value};
    }
    sock_filter code_[400];
    std::size_t n_ = 0, begun_ = 0;
};

Filter make_filter(bool may_exec) {
    Filter f;
    f.load(offsetof(seccomp_data, arch));
    f.end_if(architecture, no_right, true);
    f.load(offsetof(seccomp_data, nr));
    f.end_if_above(newest, no_such_call);
    f.end_if(SYS_clone3, no_such_call);  // its flags are out of sight; the C library then takes clone
    for (const int call : refused) f.end_if(std::uint32_t(call), no_right);
    if (!may_exec) f.end_if(SYS_execve, no_right);
    f.begin_call(SYS_clone);  // threads only
    f.load_argument(0), f.end_without(CLONE_THREAD, no_right);
    f.done();
    for (const int call : {SYS_kill, SYS_tgkill}) {  // signals to itself: abort()
        f.begin_call(call);
        f.load_argument(0), f.end_if(std::uint32_t(::getpid()), no_right, true);
        f.done();
    }
    f.begin_call(SYS_prlimit64);  // limits may be read
    f.load_argument(2), f.end_if(0, no_right, true), f.load_argument(2, true), f.end_if(0, no_right, true);
    f.done();
    f.begin_call(SYS_ioctl);  // no words put into the terminal's mouth
    f.load_argument(1), f.end_if(TIOCSTI, no_right), f.end_if(TIOCLINUX, no_right);
    f.done();
    f.end(allowed);
    return f;
}

bool keep_privileges_low() noexcept { return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0; }

}  // namespace

std::vector<std::string> system_files() {
    return {"/usr/lib",
            "/usr/local/lib",
            "/lib",
            "/lib64",
            "/etc/ld.so.cache",
            "/etc/localtime",
            "/usr/share/zoneinfo",
            "/proc/meminfo",
            "/proc/self/status",
            "/proc/self/statm",
            "/proc/self/exe",
            "/sys/fs/cgroup/memory.max",
            "/sys/fs/cgroup/memory.current",
            "/sys/devices/system/cpu",
            "/dev/null",
            "/dev/zero",
            "/dev/urandom"};
}

KernelWalls kernel_walls() {
    const std::uint32_t action = SECCOMP_RET_ERRNO;
    return {landlock_version(), architecture != 0 && ::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0};
}

std::string lacking(const KernelWalls& has) {
    std::string text;
    if (has.landlock < 1) text = "Landlock (files outside the output folder)";
    if (!has.seccomp) text += (text.empty() ? "" : " and ") + std::string("seccomp (programs and the network)");
    return text;
}

std::string missing_walls(const KernelWalls& has) {
    const std::string text = lacking(has);
    if (text.empty()) return "";
    return "warning: this kernel lacks " + text +
           ": only Lua keeps the script in the sandbox; "
           "for a script that may be hostile take Linux 5.13 or later";
}

int make_rules(const Reach& reach) {
    const int version = landlock_version();
    if (version == 0) return -1;
    RulesetAttributes all = {all_of_first, 0, 0};
    if (version >= 2) all.files |= move;
    if (version >= 3) all.files |= truncate;
    if (version >= 5) all.files |= device_ioctl;
    if (version >= 4 && !reach.network) all.network = 3;  // bind, connect
    if (version >= 6 && !reach.network) all.scoped = 3;   // abstract sockets, signals
    const int rules = int(::syscall(create_ruleset, &all, sizeof all, 0));
    if (rules < 0) return -1;
    for (const std::string& path : reach.read) allow(rules, path, all.files & reading);
    const std::uint64_t sockets = reach.network ? std::uint64_t(make_socket) : 0;
    for (const std::string& path : reach.write) allow(rules, path, all.files & (writing | device_ioctl | sockets));
    for (const std::string& path : reach.execute) allow(rules, path, all.files & (reading | execute));
    return rules;
}

bool restrict_files(int rules) noexcept {
    return rules >= 0 && keep_privileges_low() && ::syscall(restrict_self, rules, 0) == 0;
}

bool refuse_calls(bool may_exec) noexcept {
    if (architecture == 0 || !keep_privileges_low()) return false;
    Filter filter = make_filter(may_exec);
    sock_fprog program = filter.program();
    return ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program) == 0;
}

std::string program_loader() {
    std::string path;
    ::dl_iterate_phdr(
        [](dl_phdr_info* program, std::size_t, void* found) {
            for (int i = 0; i < program->dlpi_phnum; ++i)  // the first is the program itself
                if (const auto& part = program->dlpi_phdr[i]; part.p_type == PT_INTERP)
                    *static_cast<std::string*>(found) =
                        reinterpret_cast<const char*>(program->dlpi_addr + part.p_vaddr);
            return 1;
        },
        &path);
    return path;
}

}  // namespace hinge
