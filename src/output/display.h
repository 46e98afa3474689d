// A connection to an X display that can draw: checked before VTK sees it, because VTK aborts where there is none.
#pragma once

namespace hinge::output {

/// While it lives, an X error is remembered instead of ending the process.
class CalmX {
public:
    CalmX();
    ~CalmX();
    CalmX(const CalmX&) = delete;
    CalmX& operator=(const CalmX&) = delete;

private:
    void* errors_;
    void* io_errors_;
};

/// The connection (a Display*) pictures are drawn through: to DISPLAY where that is local and can do OpenGL 3.2,
/// else to a virtual display. Opened once; opened anew after a fork or when the server has gone. `fresh` tells.
void* drawing_display(bool& fresh);

/// Sets DISPLAY to a virtual display, unless it names one that answers: for processes that are started from this one.
/// Opens no connection that lasts, so that they begin with none.
void share_display();

/// Whether the server still answers.
bool display_alive();

}  // namespace hinge::output
