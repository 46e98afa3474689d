#include "script/bind/drawing.h"

#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "core/archive.h"
#include "core/files.h"
#include "record/folders.h"
#include "core/walls.h"
#include "script/lua/picture_module.h"
#include "script/lua/context.h"

namespace hinge::script {
namespace {

int drawer = -1;  ///< this end of the connection to the process that draws; -1: none
constexpr int own_end = 3;

/// Hands the plot to Lua's part of the library. What that raises goes on as an exception.
void draw_plot(lua_State* L, const DrawingOrder& order) {
    const int top = lua_gettop(L);
    const auto call = [&](int arguments) {
        if (lua_pcall(L, arguments, 1, 0) == LUA_OK) return;
        const std::string text = lua_tostring(L, -1) ? lua_tostring(L, -1) : "the plot could not be drawn";
        lua_settop(L, top);
        const auto& last = context(L)->errors;
        if (last.last == text && last.kind == std::string_view("outside")) {
            if (!last.about.empty()) throw WriteError(last.about, last.why);
            throw OutsideError(text);
        }
        throw InputError(text);
    };
    lua_getglobal(L, "require"), lua_pushstring(L, "hinge.plot.files"), call(1);
    lua_getfield(L, -1, "draw_packed");
    lua_pushlstring(L, order.plot.data(), order.plot.size()), lua_pushstring(L, order.path.c_str()), call(2);
    lua_settop(L, top);
}

void draw_here(lua_State* L, const DrawingOrder& order) {
    const auto c = context(L);
    const char* path = order.path.c_str();
    char error[512] = "";
    prepare_folder(*c, order.path);
    const auto need = [&](bool there) {
        if (!there) throw InputError("the order to draw " + order.path + " is not complete");
    };
    switch (order.what) {
        case DrawingOrder::What::picture:
            need(order.snapshots.size() == 1 && order.views.size() == 1);
            return must_work(picture_function<hinge_render>(*c, "hinge_render")(path, order.snapshots[0],
                                                                                order.views[0], error, sizeof error),
                             error, path);
        case DrawingOrder::What::strip: {
            need(!order.snapshots.empty() && order.views.size() == order.snapshots.size() && order.columns > 0);
            std::vector<const output::Snapshot*> list;
            for (const output::Snapshot& snapshot : order.snapshots) list.push_back(&snapshot);
            return must_work(
                picture_function<hinge_render_strip>(*c, "hinge_render_strip")(
                    path, int(list.size()), list.data(), order.views.data(), order.columns, error, sizeof error),
                error, path);
        }
        case DrawingOrder::What::frame:
            need(order.snapshots.size() == 1);
            return must_work(picture_function<hinge_write_snapshot>(*c, "hinge_write_snapshot")(
                                 path, order.snapshots[0], error, sizeof error),
                             error, path);
        case DrawingOrder::What::collection: {
            std::vector<double> times;
            std::vector<const char*> files;
            for (const auto& [t, f] : order.frames) times.push_back(t), files.push_back(f.c_str());
            return must_work(picture_function<hinge_write_collection>(*c, "hinge_write_collection")(
                                 path, int(times.size()), times.data(), files.data(), error, sizeof error),
                             error, path);
        }
        case DrawingOrder::What::plot: return draw_plot(L, order);
    }
    need(false);
}

// ---- between the two processes: eight bytes of length, then so many bytes -------------------------------------------

bool send_all(int to, const void* from, std::size_t n) {
    for (const char* at = static_cast<const char*>(from); n > 0;) {
        const ssize_t sent = ::send(to, at, n, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        at += sent, n -= std::size_t(sent);
    }
    return true;
}

bool receive_all(int from, void* to, std::size_t n) {
    for (char* at = static_cast<char*>(to); n > 0;) {
        const ssize_t got = ::recv(from, at, n, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got, n -= std::size_t(got);
    }
    return true;
}

bool send_text(int to, const std::string& text) {
    const std::uint64_t n = text.size();
    return send_all(to, &n, sizeof n) && send_all(to, text.data(), text.size());
}

bool receive_text(int from, std::string& text) {
    std::uint64_t n = 0;
    if (!receive_all(from, &n, sizeof n)) return false;
    text.resize(n);  // beyond the sandbox's limit of memory: std::bad_alloc
    return receive_all(from, text.data(), n);
}

constexpr char done = 'd', wrong_input = 'i', failed = 'f', file_unwritten = 'w';

/// What came of an order: one of these letters, and what went wrong; for a file that could not be written its path, a
/// byte 0, and why.
std::string answer(lua_State* L, const std::string& bytes) {
    try {
        draw_here(L, order_from_bytes(bytes));
        return {done};
    } catch (const InputError& e) { return wrong_input + std::string(e.what()); } catch (const std::bad_alloc&) {
        return failed + std::string("not enough memory to draw it");
    } catch (const WriteError& e) { return file_unwritten + e.path + '\0' + e.why; } catch (const std::exception& e) {
        return failed + std::string(e.what());
    }
}

/// The life of the process that draws.
[[noreturn]] void serve(lua_State* L, int connection, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(1);
    ::setpgid(0, 0);  // Ctrl-C belongs to the run, which may still want to draw what it has
    ::dup2(connection, own_end);
    ::close_range(own_end + 1, ~0U, 0);
    // an X server and its compiler of keyboards are started from here, so that programs are not refused
    const Reach reach = {
        {"/"}, {context(L)->output.folder, "/tmp", "/dev", "/proc", "/run", "/var/lib/xkb"}, {"/"}, true};
    restrict_files(make_rules(reach));
    std::string bytes;
    while (receive_text(own_end, bytes) && send_text(own_end, answer(L, bytes))) {}
    ::_exit(0);
}

}  // namespace

bool drawn_elsewhere() { return drawer >= 0; }

void draw(lua_State* L, const DrawingOrder& order) {
    if (!drawn_elsewhere()) return draw_here(L, order);
    std::string reply;
    if (!send_text(drawer, to_bytes(order)) || !receive_text(drawer, reply) || reply.empty())
        throw OutsideError("the process that draws for the sandbox has ended; is there enough memory?");
    if (reply[0] == wrong_input) throw InputError(reply.substr(1));
    if (const std::size_t end = reply.find('\0'); reply[0] == file_unwritten && end != std::string::npos)
        throw WriteError(reply.substr(1, end - 1), reply.substr(end + 1));
    if (reply[0] != done) throw OutsideError(reply.substr(1));
}

void start_drawer(lua_State* L) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw OutsideError(std::string("the process that draws could not be started: ") + std::strerror(errno));
    std::fflush(nullptr);
    const pid_t parent = ::getpid(), child = ::fork();
    if (child == 0) serve(L, ends[1], parent);
    const int error = errno;
    ::close(ends[1]);
    if (child < 0) {
        ::close(ends[0]);
        throw OutsideError(std::string("the process that draws could not be started: ") + std::strerror(error));
    }
    drawer = ends[0];
}

}  // namespace hinge::script
