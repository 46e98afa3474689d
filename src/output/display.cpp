// Connection to an X display that can draw, checked before VTK uses it, because VTK aborts without one.
#include "output/display.h"

#include <GL/glx.h>
#include <X11/Xlib.h>
#include <poll.h>
#include <unistd.h>
#include <xcb/xcb.h>

#include <cstdlib>
#include <string>
#include <string_view>

#include "core/errors.h"
#include "output/xvfb.h"

namespace hinge::output {
namespace {

// Guarded by the module's one lock.
Display* connection = nullptr;
pid_t owner = 0;
bool error_seen = false;
bool server_gone = false;

int remember_error(Display*, XErrorEvent*) {
    error_seen = true;
    return 0;
}

int remember_loss(Display*) {
    server_gone = true;
    return 0;
}

/// Xlib's own handler ends the process, and with it the run that only wanted a picture.
void survive_loss(Display*, void*) { server_gone = true; }

/// A display on another machine may hang for minutes, and most forwarded ones cannot do OpenGL 3.2.
bool is_local(std::string_view name) { return name.starts_with(":") || name.starts_with("unix:"); }

/// xcb stays silent where Xlib prints why it was refused.
bool answers(const char* name) {
    xcb_connection_t* probe = ::xcb_connect(name, nullptr);
    const bool good = ::xcb_connection_has_error(probe) == 0;
    ::xcb_disconnect(probe);
    return good;
}

/// The same request as VTK makes.
bool has_opengl(Display* display) {
    if (!::glXQueryExtension(display, nullptr, nullptr)) return false;
    const int wanted[] = {GLX_DRAWABLE_TYPE,
                          GLX_WINDOW_BIT,
                          GLX_RENDER_TYPE,
                          GLX_RGBA_BIT,
                          GLX_RED_SIZE,
                          1,
                          GLX_GREEN_SIZE,
                          1,
                          GLX_BLUE_SIZE,
                          1,
                          GLX_DEPTH_SIZE,
                          1,
                          GLX_ALPHA_SIZE,
                          1,
                          None};
    int n = 0;
    GLXFBConfig* configs = ::glXChooseFBConfig(display, DefaultScreen(display), wanted, &n);
    if (!configs) return false;
    const GLXFBConfig config = n > 0 ? configs[0] : nullptr;
    ::XFree(configs);
    const auto create = reinterpret_cast<PFNGLXCREATECONTEXTATTRIBSARBPROC>(
        ::glXGetProcAddressARB(reinterpret_cast<const GLubyte*>("glXCreateContextAttribsARB")));
    if (!config || !create) return false;
    const int version[] = {GLX_CONTEXT_MAJOR_VERSION_ARB, 3, GLX_CONTEXT_MINOR_VERSION_ARB, 2, None};
    error_seen = false;
    const GLXContext context = create(display, config, nullptr, True, version);
    ::XSync(display, False);
    if (context) ::glXDestroyContext(display, context);
    return context && !error_seen;
}

Display* open_checked(const std::string& name) {
    if (!answers(name.c_str())) return nullptr;
    Display* display = ::XOpenDisplay(name.c_str());
    if (!display) return nullptr;
    ::XSetIOErrorExitHandler(display, survive_loss, nullptr);
    if (has_opengl(display)) return display;
    ::XCloseDisplay(display);
    return nullptr;
}

Display* open_any() {
    const char* given = std::getenv("DISPLAY");
    if (given && is_local(given))
        if (Display* display = open_checked(given)) return display;
    const std::string name = virtual_display();
    if (Display* display = open_checked(name)) return display;
    throw OutsideError("the display of Xvfb cannot do OpenGL 3.2; get it with: apt-get install libgl1-mesa-dri");
}

}  // namespace

CalmX::CalmX()
    : errors_(reinterpret_cast<void*>(::XSetErrorHandler(remember_error))),
      io_errors_(reinterpret_cast<void*>(::XSetIOErrorHandler(remember_loss))) {}

CalmX::~CalmX() {
    ::XSetErrorHandler(reinterpret_cast<XErrorHandler>(errors_));
    ::XSetIOErrorHandler(reinterpret_cast<XIOErrorHandler>(io_errors_));
}

void share_display() {
    const char* given = std::getenv("DISPLAY");
    if (!given || !is_local(given) || !answers(given)) ::setenv("DISPLAY", virtual_display().c_str(), 1);
}

bool display_alive() {
    if (!connection || owner != ::getpid() || server_gone) return false;
    pollfd socket{ConnectionNumber(connection), POLLIN, 0};
    ::poll(&socket, 1, 0);
    return (socket.revents & (POLLHUP | POLLERR | POLLNVAL)) == 0;
}

void* drawing_display(bool& fresh) {
    fresh = !display_alive();
    if (fresh) {
        // A connection that is lost, or our parent's, is left as it is: closing it would talk to the server.
        connection = nullptr;
        server_gone = false;
        connection = open_any();
        owner = ::getpid();
    }
    return connection;
}

}  // namespace hinge::output
